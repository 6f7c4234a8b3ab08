// Steady rolling.

#ifndef STICKSLIP_ROLLING_HPP
#define STICKSLIP_ROLLING_HPP

#include <utility>
#include <vector>

#include "normal.hpp"

namespace stickslip {

using RollingControl = stickslip_rolling_control;
using CreepPoint = stickslip_creep_point;
using CreepForce = stickslip_creep_force;

inline RollingControl creepage(double value) { return {STICKSLIP_CREEPAGE, value}; }
inline RollingControl rolling_force(double value) { return {STICKSLIP_FORCE, value}; }
inline RollingControl spin(double value) { return {STICKSLIP_SPIN, value}; }
inline RollingControl moment(double value) { return {STICKSLIP_MOMENT, value}; }

/// Returns a load of rolling bodies: a creepage or a force along x and y, and a spin or a moment.
inline stickslip_rolling_load rolling(RollingControl x, RollingControl y = creepage(0.0),
                                      RollingControl about = spin(0.0)) {
    return {x, y, about, {}};
}

/// Solution of a rolling contact.
class RollingSolution {
  public:
    Field traction_x() const { return field(STICKSLIP_TRACTION_X); }
    Field traction_y() const { return field(STICKSLIP_TRACTION_Y); }
    /// Returns the slip along x for each length rolled.
    Field slip_x() const { return field(STICKSLIP_SLIP_X); }
    Field slip_y() const { return field(STICKSLIP_SLIP_Y); }
    Zones zones() const {
        return detail::viewed<std::uint8_t>(
            [&](std::size_t *size) { return stickslip_rolling_solution_zones(get(), size); });
    }
    /// Returns the energy dissipated in each cell for each length rolled.
    std::vector<double> dissipation() const {
        std::vector<double> values(traction_x().size());
        check(stickslip_rolling_solution_dissipation(get(), values.data(), values.size()));
        return values;
    }
    stickslip_rolling_result result() const {
        return detail::asked<stickslip_rolling_result>(
            [&](auto *out) { return stickslip_rolling_solution_result(get(), out); });
    }
    Report report() const {
        return detail::asked<Report>([&](auto *out) { return stickslip_rolling_solution_report(get(), out); });
    }
    std::vector<stickslip_warning> warnings() const {
        return detail::listed([&](stickslip_warning *to, std::size_t capacity, std::size_t *count) {
            return stickslip_rolling_solution_warnings(get(), to, capacity, count);
        });
    }
    stickslip_rolling_solution *get() const { return own_.get(); }

  private:
    friend class RollingSolver;
    using Own = detail::Owned<stickslip_rolling_solution, stickslip_rolling_solution_free>;
    explicit RollingSolution(Own own) : own_(std::move(own)) {}

    Field field(std::int32_t which) const {
        return detail::viewed<double>(
            [&](std::size_t *size) { return stickslip_rolling_solution_field(get(), which, size); });
    }

    Own own_;
};

/// Solver for steady rolling with a sequence of creepages, forces or spins.
class RollingSolver {
  public:
    RollingSolver(const HalfSpace &bodies, const NormalSolution &normal, const stickslip_friction &friction,
                  const stickslip_rolling_load &load = {}, const stickslip_rolling_options *options = nullptr)
        : own_(detail::made<Own>([&](auto **out) {
              return stickslip_rolling_solver_new(bodies.get(), normal.get(), &friction, &load, options, out);
          })) {}

    void set_load(const stickslip_rolling_load &load) { check(stickslip_rolling_solver_set_load(get(), &load)); }
    void set_friction(const stickslip_friction &friction) { check(stickslip_rolling_solver_set_friction(get(), &friction)); }
    void set_pressure(const NormalSolution &normal) { check(stickslip_rolling_solver_set_normal(get(), normal.get())); }
    /// Sets the pressure of the next solve; requires STICKSLIP_WHOLE_STEP.
    void set_pressure(Field pressure) {
        check(stickslip_rolling_solver_set_pressure(get(), pressure.data(), pressure.size()));
    }
    /// Copies the solver that computes the pressure of a new normal load.
    void set_normal_solver(const NormalSolver &normal) {
        check(stickslip_rolling_solver_set_normal_solver(get(), normal.get()));
    }
    /// Solves for the pressure of a normal load; requires a normal solver.
    void set_normal_load(const stickslip_normal_load &load) {
        check(stickslip_rolling_solver_set_normal_load(get(), &load));
    }
    double friction_capacity() const {
        return detail::asked<double>(
            [&](double *out) { return stickslip_rolling_solver_friction_capacity(get(), out); });
    }
    void set_settings(const Settings &settings) { check(stickslip_rolling_solver_set_settings(get(), &settings)); }
    void reset() { check(stickslip_rolling_solver_reset(get())); }

    RollingSolution solve(const Observe &observe = nullptr) {
        RollingSolution solution = new_solution();
        solve_into(solution, observe);
        return solution;
    }
    RollingSolution new_solution() const {
        return RollingSolution(detail::made<RollingSolution::Own>(
            [&](auto **out) { return stickslip_rolling_solution_new(get(), out); }));
    }
    void solve_into(RollingSolution &solution, const Observe &observe = nullptr) {
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_rolling_solver_solve(get(), solution.get(), observer);
        });
    }
    /// Returns the derivatives of the loads at the last solution.
    stickslip_rolling_stiffness stiffness(const Observe &observe = nullptr) {
        stickslip_rolling_stiffness found{};
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_rolling_solver_stiffness_observed(get(), observer, &found);
        });
        return found;
    }
    /// Returns the loads at the points of a creep curve or a creep surface; afterwards the last point is the prescribed
    /// load.
    std::vector<CreepForce> creep_forces(const std::vector<CreepPoint> &points, const Observe &observe = nullptr) {
        std::vector<CreepForce> forces(points.size());
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_rolling_solver_creep_forces_observed(get(), points.data(), points.size(), observer,
                                                                  forces.data());
        });
        return forces;
    }
    stickslip_rolling_solver *get() const { return own_.get(); }

  private:
    using Own = detail::Owned<stickslip_rolling_solver, stickslip_rolling_solver_free>;
    Own own_;
};

/// Solution of a rolling contact of dissimilar bodies with full coupling of pressure and traction.
class CoupledRollingSolution {
  public:
    Field pressure() const { return field(STICKSLIP_PRESSURE); }
    /// Returns the gap under load, including the lift due to the tractions.
    Field gap() const { return field(STICKSLIP_GAP); }
    Field traction_x() const { return field(STICKSLIP_TRACTION_X); }
    Field traction_y() const { return field(STICKSLIP_TRACTION_Y); }
    /// Returns the slip along x for each length rolled.
    Field slip_x() const { return field(STICKSLIP_SLIP_X); }
    Field slip_y() const { return field(STICKSLIP_SLIP_Y); }
    Zones zones() const {
        return detail::viewed<std::uint8_t>(
            [&](std::size_t *size) { return stickslip_coupled_rolling_solution_zones(get(), size); });
    }
    stickslip_normal_result normal_result() const {
        return detail::asked<stickslip_normal_result>(
            [&](auto *out) { return stickslip_coupled_rolling_solution_results(get(), out, nullptr); });
    }
    stickslip_rolling_result rolling_result() const {
        return detail::asked<stickslip_rolling_result>(
            [&](auto *out) { return stickslip_coupled_rolling_solution_results(get(), nullptr, out); });
    }
    stickslip_coupled_rolling_report report() const {
        return detail::asked<stickslip_coupled_rolling_report>(
            [&](auto *out) { return stickslip_coupled_rolling_solution_report(get(), out); });
    }
    stickslip_coupled_rolling_solution *get() const { return own_.get(); }

  private:
    friend class CoupledRollingSolver;
    using Own = detail::Owned<stickslip_coupled_rolling_solution, stickslip_coupled_rolling_solution_free>;
    explicit CoupledRollingSolution(Own own) : own_(std::move(own)) {}

    Field field(std::int32_t which) const {
        return detail::viewed<double>(
            [&](std::size_t *size) { return stickslip_coupled_rolling_solution_field(get(), which, size); });
    }

    Own own_;
};

/// Solver for coupled steady rolling under a sequence of loads. Each solve starts from the last solution.
class CoupledRollingSolver {
  public:
    CoupledRollingSolver(const HalfSpace &bodies, Field gap, const stickslip_friction &friction,
                         const stickslip_normal_load &normal, const stickslip_rolling_load &load = {},
                         const stickslip_rolling_options *options = nullptr)
        : own_(detail::made<Own>([&](auto **out) {
              return stickslip_coupled_rolling_solver_new(bodies.get(), gap.data(), gap.size(), &friction, &normal, &load,
                                                          options, out);
          })) {}

    void set_normal_load(const stickslip_normal_load &normal) {
        check(stickslip_coupled_rolling_solver_set_normal_load(get(), &normal));
    }
    void set_load(const stickslip_rolling_load &load) { check(stickslip_coupled_rolling_solver_set_load(get(), &load)); }
    void set_gap(Field gap) { check(stickslip_coupled_rolling_solver_set_gap(get(), gap.data(), gap.size())); }
    void set_friction(const stickslip_friction &friction) {
        check(stickslip_coupled_rolling_solver_set_friction(get(), &friction));
    }
    void set_settings(const Settings &settings) { check(stickslip_coupled_rolling_solver_set_settings(get(), &settings)); }
    void reset() { check(stickslip_coupled_rolling_solver_reset(get())); }

    CoupledRollingSolution solve(const Observe &observe = nullptr) {
        CoupledRollingSolution solution = new_solution();
        solve_into(solution, observe);
        return solution;
    }
    CoupledRollingSolution new_solution() const {
        return CoupledRollingSolution(detail::made<CoupledRollingSolution::Own>(
            [&](auto **out) { return stickslip_coupled_rolling_solution_new(get(), out); }));
    }
    void solve_into(CoupledRollingSolution &solution, const Observe &observe = nullptr) {
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_coupled_rolling_solver_solve(get(), solution.get(), observer);
        });
    }
    /// Returns the derivatives of the loads at the last solution, including the change of the pressure with the tractions.
    stickslip_rolling_stiffness stiffness(const Observe &observe = nullptr) {
        stickslip_rolling_stiffness found{};
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_coupled_rolling_solver_stiffness(get(), observer, &found);
        });
        return found;
    }
    stickslip_coupled_rolling_solver *get() const { return own_.get(); }

  private:
    using Own = detail::Owned<stickslip_coupled_rolling_solver, stickslip_coupled_rolling_solver_free>;
    Own own_;
};

/// Returns the Carter contact of a cylinder under a force per length, with a creepage.
inline stickslip_carter carter_cylinder(const HalfSpace &bodies, double radius, double force, double friction,
                                        double creepage) {
    return detail::asked<stickslip_carter>([&](auto *out) {
        return stickslip_carter_cylinder(bodies.get(), radius, force, friction, creepage, out);
    });
}

/// Returns the Bentall-Johnson contact of a freely rolling cylinder of a different material under a force per length.
inline stickslip_bentall_johnson bentall_johnson_cylinder(const HalfSpace &bodies, double radius, double force,
                                                          double friction) {
    return detail::asked<stickslip_bentall_johnson>([&](auto *out) {
        return stickslip_bentall_johnson_cylinder(bodies.get(), radius, force, friction, out);
    });
}

/// Returns Kalker's coefficients of a contact with a given ratio of the semi-axes along and across the rolling direction.
inline stickslip_kalker kalker_coefficients(double ratio, double poisson_ratio) {
    return detail::asked<stickslip_kalker>(
        [&](auto *out) { return stickslip_kalker_coefficients(ratio, poisson_ratio, out); });
}

/// Returns the Vermeulen-Johnson contact of a body with two radii of curvature under a normal force, with creepages.
inline stickslip_vermeulen_johnson vermeulen_johnson_ellipse(const HalfSpace &bodies, double radius_x, double radius_y,
                                                             double force, double friction, double creepage_x,
                                                             double creepage_y) {
    return detail::asked<stickslip_vermeulen_johnson>([&](auto *out) {
        return stickslip_vermeulen_johnson_ellipse(bodies.get(), radius_x, radius_y, force, friction, creepage_x,
                                                   creepage_y, out);
    });
}

} // namespace stickslip

#endif // STICKSLIP_ROLLING_HPP
