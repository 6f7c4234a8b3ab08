// Normal contact.

#ifndef STICKSLIP_NORMAL_HPP
#define STICKSLIP_NORMAL_HPP

#include <utility>
#include <vector>

#include "bodies.hpp"
#include "loads.hpp"

namespace stickslip {

/// Solution of a normal contact.
class NormalSolution {
  public:
    Field pressure() const { return field(STICKSLIP_PRESSURE); }
    Field gap() const { return field(STICKSLIP_GAP); }
    stickslip_normal_result result() const {
        return detail::asked<stickslip_normal_result>(
            [&](auto *out) { return stickslip_normal_solution_result(get(), out); });
    }
    Report report() const {
        return detail::asked<Report>([&](auto *out) { return stickslip_normal_solution_report(get(), out); });
    }
    std::vector<stickslip_warning> warnings() const {
        return detail::listed([&](stickslip_warning *to, std::size_t capacity, std::size_t *count) {
            return stickslip_normal_solution_warnings(get(), to, capacity, count);
        });
    }
    stickslip_normal_stiffness stiffness(const HalfSpace &bodies) const {
        return detail::asked<stickslip_normal_stiffness>(
            [&](auto *out) { return stickslip_normal_solution_stiffness(get(), bodies.get(), out); });
    }
    Spots spots() const {
        return detail::spotted(pressure().size(), [&](auto... to) { return stickslip_normal_solution_spots(get(), to...); });
    }
    /// Returns the edge of the contact with the pressure.
    Edges edges() const {
        return detail::edged(pressure().size(), [&](auto... to) { return stickslip_normal_solution_edges(get(), to...); });
    }
    /// Returns the estimate of the discretisation error, or NaN without contact.
    double discretisation_estimate() const {
        return detail::asked<double>(
            [&](auto *out) { return stickslip_normal_solution_discretisation_estimate(get(), out); });
    }
    stickslip_normal_solution *get() const { return own_.get(); }

  private:
    friend class NormalSolver;
    using Own = detail::Owned<stickslip_normal_solution, stickslip_normal_solution_free>;
    explicit NormalSolution(Own own) : own_(std::move(own)) {}

    Field field(std::int32_t which) const {
        return detail::viewed<double>(
            [&](std::size_t *size) { return stickslip_normal_solution_field(get(), which, size); });
    }

    Own own_;
};

/// Solver for repeated normal contacts.
class NormalSolver {
  public:
    NormalSolver(const HalfSpace &bodies, Field gap, stickslip_normal_load load, const Settings *settings = nullptr,
                 const stickslip_per_cell *hardness = nullptr)
        : own_(detail::made<Own>([&](auto **out) {
              return stickslip_normal_solver_new(bodies.get(), gap.data(), gap.size(), &load, hardness, settings, out);
          })) {}

    void set_load(stickslip_normal_load load) { check(stickslip_normal_solver_set_load(get(), &load)); }
    void set_gap(Field gap) { check(stickslip_normal_solver_set_gap(get(), gap.data(), gap.size())); }
    void set_settings(const Settings &settings) { check(stickslip_normal_solver_set_settings(get(), &settings)); }
    void reset() { check(stickslip_normal_solver_reset(get())); }

    NormalSolution solve(const Observe &observe = nullptr) {
        NormalSolution solution = new_solution();
        solve_into(solution, observe);
        return solution;
    }
    NormalSolution new_solution() const {
        return NormalSolution(detail::made<NormalSolution::Own>(
            [&](auto **out) { return stickslip_normal_solution_new(get(), out); }));
    }
    void solve_into(NormalSolution &solution, const Observe &observe = nullptr) {
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_normal_solver_solve(get(), solution.get(), observer);
        });
    }
    stickslip_normal_solver *get() const { return own_.get(); }

  private:
    using Own = detail::Owned<stickslip_normal_solver, stickslip_normal_solver_free>;
    Own own_;
};

} // namespace stickslip

#endif // STICKSLIP_NORMAL_HPP
