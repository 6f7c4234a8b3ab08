// Coupled pressure and traction of dissimilar bodies.

#ifndef STICKSLIP_COUPLED_HPP
#define STICKSLIP_COUPLED_HPP

#include <utility>
#include <vector>

#include "bodies.hpp"
#include "loads.hpp"

namespace stickslip {

/// Solution of a coupled contact of dissimilar bodies.
class CoupledSolution {
  public:
    /// Returns a field, STICKSLIP_PRESSURE to STICKSLIP_DISPLACEMENT_Z.
    Field field(std::int32_t which) const {
        return detail::viewed<double>(
            [&](std::size_t *size) { return stickslip_coupled_solution_field(get(), which, size); });
    }
    Zones zones() const {
        return detail::viewed<std::uint8_t>(
            [&](std::size_t *size) { return stickslip_coupled_solution_zones(get(), size); });
    }
    stickslip_normal_result normal() const {
        return detail::asked<stickslip_normal_result>(
            [&](auto *out) { return stickslip_coupled_solution_results(get(), out, nullptr); });
    }
    stickslip_tangential_result tangential() const {
        return detail::asked<stickslip_tangential_result>(
            [&](auto *out) { return stickslip_coupled_solution_results(get(), nullptr, out); });
    }
    stickslip_coupled_report report() const {
        return detail::asked<stickslip_coupled_report>(
            [&](auto *out) { return stickslip_coupled_solution_report(get(), out); });
    }
    std::vector<stickslip_warning> warnings() const {
        return detail::listed([&](stickslip_warning *to, std::size_t capacity, std::size_t *count) {
            return stickslip_coupled_solution_warnings(get(), to, capacity, count);
        });
    }
    /// Returns the stiffness; bodies and friction must be those of the solve.
    Stiffness stiffness(const HalfSpace &bodies, const stickslip_friction &friction) const {
        return detail::asked<Stiffness>([&](auto *out) {
            return stickslip_coupled_solution_stiffness(get(), bodies.get(), &friction, out);
        });
    }
    /// Returns the edges with the magnitude of the traction; the friction must be that of the solve.
    Edges edges(const stickslip_friction &friction) const {
        return detail::edged(zones().size(), [&](auto... to) {
            return stickslip_coupled_solution_edges(get(), &friction, to...);
        });
    }
    /// Returns the edge of the contact with the pressure.
    Edges pressure_edges() const {
        return detail::edged(zones().size(), [&](auto... to) {
            return stickslip_coupled_solution_pressure_edges(get(), to...);
        });
    }
    /// Returns the estimates of the discretisation errors of pressure and traction, or NaN without contact or without
    /// traction.
    std::pair<double, double> discretisation_estimates() const {
        std::pair<double, double> found;
        check(stickslip_coupled_solution_discretisation_estimates(get(), &found.first, &found.second));
        return found;
    }
    stickslip_coupled_solution *get() const { return own_.get(); }

  private:
    friend class CoupledSolver;
    using Own = detail::Owned<stickslip_coupled_solution, stickslip_coupled_solution_free>;
    explicit CoupledSolution(Own own) : own_(std::move(own)) {}
    Own own_;
};

/// Solver for contacts of dissimilar bodies with coupled pressure and traction.
class CoupledSolver {
  public:
    CoupledSolver(const HalfSpace &bodies, Field gap, const stickslip_friction &friction, stickslip_normal_load normal,
                  const stickslip_tangential_load &tangential, const Settings *settings = nullptr,
                  const stickslip_relative_displacement *relative = nullptr,
                  const stickslip_per_cell *hardness = nullptr)
        : own_(detail::made<Own>([&](auto **out) {
              return stickslip_coupled_solver_new(bodies.get(), gap.data(), gap.size(), &friction, &normal,
                                                  &tangential, hardness, relative, settings, out);
          })) {}

    void set_load(stickslip_normal_load normal, const stickslip_tangential_load &tangential) {
        check(stickslip_coupled_solver_set_load(get(), &normal, &tangential));
    }
    void set_gap(Field gap) { check(stickslip_coupled_solver_set_gap(get(), gap.data(), gap.size())); }
    void set_friction(const stickslip_friction &friction) {
        check(stickslip_coupled_solver_set_friction(get(), &friction));
    }
    void set_settings(const Settings &settings) { check(stickslip_coupled_solver_set_settings(get(), &settings)); }
    void reset() { check(stickslip_coupled_solver_reset(get())); }

    CoupledSolution solve(const Observe &observe = nullptr) {
        CoupledSolution solution(detail::made<CoupledSolution::Own>(
            [&](auto **out) { return stickslip_coupled_solution_new(get(), out); }));
        solve_into(solution, observe);
        return solution;
    }
    void solve_into(CoupledSolution &solution, const Observe &observe = nullptr) {
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_coupled_solver_solve(get(), solution.get(), observer);
        });
    }
    stickslip_coupled_solver *get() const { return own_.get(); }

  private:
    using Own = detail::Owned<stickslip_coupled_solver, stickslip_coupled_solver_free>;
    Own own_;
};

} // namespace stickslip

#endif // STICKSLIP_COUPLED_HPP
