// Tangential contact under a given pressure.

#ifndef STICKSLIP_TANGENTIAL_HPP
#define STICKSLIP_TANGENTIAL_HPP

#include <utility>
#include <vector>

#include "normal.hpp"

namespace stickslip {

/// Solution of a tangential contact.
class TangentialSolution {
  public:
    Field traction_x() const { return field(STICKSLIP_TRACTION_X); }
    Field traction_y() const { return field(STICKSLIP_TRACTION_Y); }
    Field slip_x() const { return field(STICKSLIP_SLIP_X); }
    Field slip_y() const { return field(STICKSLIP_SLIP_Y); }
    Zones zones() const {
        return detail::viewed<std::uint8_t>(
            [&](std::size_t *size) { return stickslip_tangential_solution_zones(get(), size); });
    }
    stickslip_tangential_result result() const {
        return detail::asked<stickslip_tangential_result>(
            [&](auto *out) { return stickslip_tangential_solution_result(get(), out); });
    }
    Report report() const {
        return detail::asked<Report>([&](auto *out) { return stickslip_tangential_solution_report(get(), out); });
    }
    std::vector<stickslip_warning> warnings() const {
        return detail::listed([&](stickslip_warning *to, std::size_t capacity, std::size_t *count) {
            return stickslip_tangential_solution_warnings(get(), to, capacity, count);
        });
    }
    stickslip_tangential_stiffness stiffness(const HalfSpace &bodies) const {
        return detail::asked<stickslip_tangential_stiffness>(
            [&](auto *out) { return stickslip_tangential_solution_stiffness(get(), bodies.get(), out); });
    }
    /// Returns the contact spots under the pressure of a normal contact, with the stick ratio of each.
    Spots spots(const NormalSolution &normal) const {
        return detail::spotted(traction_x().size(), [&](auto... to) {
            return stickslip_tangential_solution_spots(get(), normal.get(), to...);
        });
    }
    /// Returns the edges with the magnitude of the traction; pressure and friction must be those of the problem.
    Edges edges(const NormalSolution &normal, const stickslip_friction &friction) const {
        return detail::edged(traction_x().size(), [&](auto... to) {
            return stickslip_tangential_solution_edges(get(), normal.get(), &friction, to...);
        });
    }
    /// Returns the estimate of the discretisation error, or NaN without traction.
    double discretisation_estimate() const {
        return detail::asked<double>(
            [&](auto *out) { return stickslip_tangential_solution_discretisation_estimate(get(), out); });
    }
    stickslip_tangential_solution *get() const { return own_.get(); }

  private:
    friend class TangentialSolver;
    using Own = detail::Owned<stickslip_tangential_solution, stickslip_tangential_solution_free>;
    explicit TangentialSolution(Own own) : own_(std::move(own)) {}

    Field field(std::int32_t which) const {
        return detail::viewed<double>(
            [&](std::size_t *size) { return stickslip_tangential_solution_field(get(), which, size); });
    }

    Own own_;
};

/// Solver for repeated tangential contacts.
class TangentialSolver {
  public:
    TangentialSolver(const HalfSpace &bodies, const NormalSolution &normal, const stickslip_friction &friction,
                     const stickslip_tangential_load &load, const stickslip_tangential_options *options = nullptr)
        : own_(detail::made<Own>([&](auto **out) {
              return stickslip_tangential_solver_new(bodies.get(), normal.get(), &friction, &load, options, out);
          })) {}
    TangentialSolver(const HalfSpace &bodies, Field pressure, const stickslip_friction &friction,
                     const stickslip_tangential_load &load, const stickslip_tangential_options *options = nullptr)
        : own_(detail::made<Own>([&](auto **out) {
              return stickslip_tangential_solver_new_under(bodies.get(), pressure.data(), pressure.size(), &friction,
                                                           &load, options, out);
          })) {}

    void set_load(const stickslip_tangential_load &load) { check(stickslip_tangential_solver_set_load(get(), &load)); }
    void set_friction(const stickslip_friction &friction) {
        check(stickslip_tangential_solver_set_friction(get(), &friction));
    }
    void set_pressure(const NormalSolution &normal) {
        check(stickslip_tangential_solver_set_normal(get(), normal.get()));
    }
    void set_pressure(Field pressure) {
        check(stickslip_tangential_solver_set_pressure(get(), pressure.data(), pressure.size()));
    }
    void set_relative_displacement(const stickslip_relative_displacement &relative) {
        check(stickslip_tangential_solver_set_relative_displacement(get(), &relative));
    }
    void set_settings(const Settings &settings) { check(stickslip_tangential_solver_set_settings(get(), &settings)); }
    void reset() { check(stickslip_tangential_solver_reset(get())); }
    double friction_capacity() const {
        return detail::asked<double>(
            [&](double *out) { return stickslip_tangential_solver_friction_capacity(get(), out); });
    }

    TangentialSolution solve(const Observe &observe = nullptr) {
        TangentialSolution solution = new_solution();
        solve_into(solution, observe);
        return solution;
    }
    TangentialSolution new_solution() const {
        return TangentialSolution(detail::made<TangentialSolution::Own>(
            [&](auto **out) { return stickslip_tangential_solution_new(get(), out); }));
    }
    void solve_into(TangentialSolution &solution, const Observe &observe = nullptr) {
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_tangential_solver_solve(get(), solution.get(), observer);
        });
    }
    stickslip_tangential_solver *get() const { return own_.get(); }

  private:
    using Own = detail::Owned<stickslip_tangential_solver, stickslip_tangential_solver_free>;
    Own own_;
};

} // namespace stickslip

#endif // STICKSLIP_TANGENTIAL_HPP
