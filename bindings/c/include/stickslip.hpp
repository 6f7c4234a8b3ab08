// stickslip.h with destructors and exceptions: C++17, nothing to link but the library.
//
// Objects are moved, not copied (a history has clone()), and free themselves. Every failure is a stickslip::Error with its
// code, message and numbers. Fields are views of what the object holds: valid until it is changed or destroyed. NULL in the
// C interface is nullptr or an argument left out here.

#ifndef STICKSLIP_HPP
#define STICKSLIP_HPP

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stickslip.h"

namespace stickslip {

using Grid = stickslip_grid;
using Material = stickslip_material;
using Boundary = stickslip_boundary;
using Settings = stickslip_settings;
using Report = stickslip_report;
using LoadStep = stickslip_load_step;
using Stiffness = stickslip_stiffness;
using Iteration = stickslip_iteration;

/// A view of samples, row by row with x fastest; of an array of the caller, or of what an object holds.
template <class T> class View {
  public:
    View(const T *data, std::size_t size) : data_(data), size_(size) {}
    View(const std::vector<T> &samples) : View(samples.data(), samples.size()) {}

    const T *data() const { return data_; }
    std::size_t size() const { return size_; }
    const T *begin() const { return data_; }
    const T *end() const { return data_ + size_; }
    const T &operator[](std::size_t i) const { return data_[i]; }

  private:
    const T *data_;
    std::size_t size_;
};

using Field = View<double>;
using Zones = View<std::uint8_t>;

/// A call that failed.
class Error : public std::runtime_error {
  public:
    Error() : Error(numbers_of_last()) {}

    /// What the C function returned.
    stickslip_status code() const { return numbers_.code; }
    /// Offending value, limit, index ...
    const stickslip_error &numbers() const { return numbers_; }
    /// The report of a solve that did not converge, else of status STICKSLIP_UNSOLVED.
    const Report &report() const { return report_; }

  private:
    explicit Error(const stickslip_error &numbers)
        : std::runtime_error(stickslip_last_error_message()), numbers_(numbers), report_{} {
        if (numbers_.code == STICKSLIP_NOT_CONVERGED) {
            stickslip_last_error_report(&report_);
        }
    }

    static stickslip_error numbers_of_last() {
        stickslip_error numbers{};
        stickslip_last_error(&numbers);
        return numbers;
    }

    stickslip_error numbers_;
    Report report_;
};

/// Throws unless a call succeeded.
inline void check(stickslip_status status) {
    if (status != STICKSLIP_OK) {
        throw Error();
    }
}

/// Sees every iteration of a solve; false ends it. What it throws leaves the solve.
using Observe = std::function<bool(const Iteration &)>;

namespace detail {

/// Frees an object by its C function.
template <class T, stickslip_status (*Free)(T *)> struct Freer {
    void operator()(T *object) const { Free(object); }
};

template <class T, stickslip_status (*Free)(T *)> using Owned = std::unique_ptr<T, Freer<T, Free>>;

/// Takes over what a C function makes.
template <class Owner, class Make> Owner made(Make make) {
    typename Owner::pointer object = nullptr;
    check(make(&object));
    return Owner(object);
}

/// The answer of a C function.
template <class T, class Ask> T asked(Ask ask) {
    T answer{};
    check(ask(&answer));
    return answer;
}

/// What a C function tells of a field.
template <class T, class Ask> View<T> viewed(Ask ask) {
    std::size_t size = 0;
    const T *data = ask(&size);
    if (data == nullptr) {
        throw Error();
    }
    return View<T>(data, size);
}

template <class Ask> std::vector<stickslip_warning> listed(Ask ask) {
    std::size_t count = 0;
    check(ask(nullptr, 0, &count));
    std::vector<stickslip_warning> warnings(count);
    check(ask(warnings.data(), count, &count));
    return warnings;
}

/// An observer for C, which lets no exception through: it ends the solve, and is thrown again after it.
class Watch {
  public:
    explicit Watch(const Observe &observe) : observe_(observe) {}

    template <class Solve> void run(Solve solve) {
        stickslip_observer observer = {&Watch::call, this};
        stickslip_status status = solve(observe_ ? &observer : nullptr);
        if (thrown_) {
            std::rethrow_exception(thrown_);
        }
        check(status);
    }

  private:
    static std::int32_t call(const Iteration *iteration, void *user) noexcept {
        auto *self = static_cast<Watch *>(user);
        try {
            return self->observe_(*iteration) ? 1 : 0;
        } catch (...) {
            self->thrown_ = std::current_exception();
            return 0;
        }
    }

    const Observe &observe_;
    std::exception_ptr thrown_;
};

} // namespace detail

/// A material of Young's modulus and Poisson's ratio.
inline Material elastic(double youngs_modulus, double poisson_ratio) { return {youngs_modulus, poisson_ratio, 0.0}; }

inline stickslip_friction coulomb(double coefficient) { return stickslip_coulomb(coefficient); }

inline stickslip_normal_load press_by_force(double force) { return {STICKSLIP_FORCE, force}; }
inline stickslip_normal_load press_by_approach(double approach) { return {STICKSLIP_APPROACH, approach}; }
inline stickslip_normal_load held_pressure() { return {STICKSLIP_HOLD, 0.0}; }

inline stickslip_control held() { return {STICKSLIP_HOLD, 0.0, 0.0}; }
inline stickslip_control force(double value) { return {STICKSLIP_FORCE, value, 0.0}; }
inline stickslip_control shift(double value) { return {STICKSLIP_SHIFT, value, 0.0}; }
inline stickslip_control spring(double position, double stiffness) { return {STICKSLIP_SPRING, position, stiffness}; }

/// A tangential load from rest.
inline stickslip_tangential_load tangential(stickslip_control x, stickslip_control y = held(), double twist = 0.0) {
    return {x, y, twist};
}

/// A step of a history that holds what it does not name.
inline LoadStep step(stickslip_normal_load normal, stickslip_control x = held(), stickslip_control y = held()) {
    return {normal, x, y, 0, 0.0, 0, 0.0};
}

/// The gap between a sphere and a plane.
inline std::vector<double> sphere(const Grid &grid, double radius) {
    std::vector<double> gap(grid.nx * grid.ny);
    check(stickslip_surface_sphere(&grid, radius, gap.data(), gap.size()));
    return gap;
}

/// Two bodies on a grid.
class HalfSpace {
  public:
    HalfSpace(const Grid &grid, const Material &body_1, const Material &body_2, const Boundary *boundary = nullptr)
        : own_(detail::made<Own>(
              [&](auto **out) { return stickslip_half_space_new(&grid, &body_1, &body_2, boundary, out); })) {}

    Grid grid() const {
        return detail::asked<Grid>([&](Grid *out) { return stickslip_half_space_grid(get(), out); });
    }
    stickslip_pair pair() const {
        return detail::asked<stickslip_pair>([&](auto *out) { return stickslip_half_space_pair(get(), out); });
    }
    stickslip_half_space *get() const { return own_.get(); }

  private:
    using Own = detail::Owned<stickslip_half_space, stickslip_half_space_free>;
    Own own_;
};

/// A solved normal contact.
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

/// Solves normal contacts again and again.
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

/// A solved tangential contact.
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

/// Solves tangential contacts again and again.
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

/// A solved contact of dissimilar bodies.
class CoupledSolution {
  public:
    /// STICKSLIP_PRESSURE to STICKSLIP_DISPLACEMENT_Z.
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
    stickslip_tangential_result shear() const {
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
    stickslip_coupled_solution *get() const { return own_.get(); }

  private:
    friend class CoupledSolver;
    using Own = detail::Owned<stickslip_coupled_solution, stickslip_coupled_solution_free>;
    explicit CoupledSolution(Own own) : own_(std::move(own)) {}
    Own own_;
};

/// Solves contacts of dissimilar bodies, pressure and shear together.
class CoupledSolver {
  public:
    CoupledSolver(const HalfSpace &bodies, Field gap, const stickslip_friction &friction, stickslip_normal_load normal,
                  const stickslip_tangential_load &load, const Settings *settings = nullptr,
                  const stickslip_relative_displacement *relative = nullptr)
        : own_(detail::made<Own>([&](auto **out) {
              return stickslip_coupled_solver_new(bodies.get(), gap.data(), gap.size(), &friction, &normal, &load,
                                                  relative, settings, out);
          })) {}

    void set_normal(stickslip_normal_load normal) { check(stickslip_coupled_solver_set_normal(get(), &normal)); }
    void set_load(const stickslip_tangential_load &load) { check(stickslip_coupled_solver_set_load(get(), &load)); }
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

class History;

/// A state that a history may return to.
class State {
  public:
    explicit State(const History &history);
    void keep(const History &history);
    stickslip_state *get() const { return own_.get(); }

  private:
    using Own = detail::Owned<stickslip_state, stickslip_state_free>;
    Own own_;
};

/// A contact that is loaded step by step.
class History {
  public:
    History(const HalfSpace &bodies, Field gap, const stickslip_friction &friction,
            const stickslip_history_options &options = stickslip_history_options_default())
        : own_(detail::made<Own>([&](auto **out) {
              return stickslip_history_new(bodies.get(), gap.data(), gap.size(), &friction, &options, out);
          })) {}

    static History from_bytes(const HalfSpace &bodies, const std::vector<std::uint8_t> &bytes) {
        return History(detail::made<Own>([&](auto **out) {
            return stickslip_history_from_bytes(bodies.get(), bytes.data(), bytes.size(), out);
        }));
    }
    std::vector<std::uint8_t> to_bytes() const {
        std::size_t length = 0;
        check(stickslip_history_to_bytes(get(), nullptr, 0, &length));
        std::vector<std::uint8_t> bytes(length);
        check(stickslip_history_to_bytes(get(), bytes.data(), length, &length));
        return bytes;
    }
    History clone() const {
        return History(detail::made<Own>([&](auto **out) { return stickslip_history_clone(get(), out); }));
    }

    /// Takes a step, and returns what it came to.
    stickslip_step_result step(const LoadStep &load, const Observe &observe = nullptr) {
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_history_step(get(), &load, observer);
        });
        return result();
    }
    void set_gap(Field gap) { check(stickslip_history_set_gap(get(), gap.data(), gap.size())); }
    void set_friction(const stickslip_friction &friction) { check(stickslip_history_set_friction(get(), &friction)); }
    void set_settings(const Settings &settings) { check(stickslip_history_set_settings(get(), &settings)); }
    void set_relative_displacement(const stickslip_relative_displacement &pattern) {
        check(stickslip_history_set_relative_displacement(get(), &pattern));
    }
    void set_state(const State &state) { check(stickslip_history_set_state(get(), state.get())); }

    stickslip_step_result result() const {
        return detail::asked<stickslip_step_result>([&](auto *out) { return stickslip_history_result(get(), out); });
    }
    stickslip_normal_result normal() const {
        return detail::asked<stickslip_normal_result>(
            [&](auto *out) { return stickslip_history_normal_result(get(), out); });
    }
    Stiffness stiffness() const {
        return detail::asked<Stiffness>([&](auto *out) { return stickslip_history_stiffness(get(), out); });
    }
    double friction_capacity() const {
        return detail::asked<double>([&](double *out) { return stickslip_history_friction_capacity(get(), out); });
    }
    /// Those of pressure and traction.
    std::pair<Report, Report> reports() const {
        std::pair<Report, Report> both{};
        check(stickslip_history_reports(get(), &both.first, &both.second));
        return both;
    }
    std::vector<stickslip_warning> warnings() const {
        return detail::listed([&](stickslip_warning *to, std::size_t capacity, std::size_t *count) {
            return stickslip_history_warnings(get(), to, capacity, count);
        });
    }
    /// STICKSLIP_PRESSURE to STICKSLIP_YIELDED_DEPTH.
    Field field(std::int32_t which) const {
        return detail::viewed<double>([&](std::size_t *size) { return stickslip_history_field(get(), which, size); });
    }
    Field pressure() const { return field(STICKSLIP_PRESSURE); }
    Field traction_x() const { return field(STICKSLIP_TRACTION_X); }
    Field traction_y() const { return field(STICKSLIP_TRACTION_Y); }
    Zones zones() const {
        return detail::viewed<std::uint8_t>([&](std::size_t *size) { return stickslip_history_zones(get(), size); });
    }

    /// Adds to depth what the energy law removes in the last step.
    void wear_energy(const stickslip_per_cell &coefficient, std::vector<double> &depth) const {
        check(stickslip_wear_energy(get(), &coefficient, depth.data(), depth.size()));
    }
    /// Adds to depth what Archard's law removes in the last step.
    void wear_archard(const stickslip_per_cell &coefficient, std::vector<double> &depth) const {
        check(stickslip_wear_archard(get(), &coefficient, depth.data(), depth.size()));
    }
    stickslip_history *get() const { return own_.get(); }

  private:
    using Own = detail::Owned<stickslip_history, stickslip_history_free>;
    explicit History(Own own) : own_(std::move(own)) {}
    Own own_;
};

inline State::State(const History &history)
    : own_(detail::made<Own>([&](auto **out) { return stickslip_state_new(history.get(), out); })) {}
inline void State::keep(const History &history) { check(stickslip_state_keep(get(), history.get())); }

/// Takes a step of each of many histories, and returns the code of each; those that failed are as they were.
inline std::vector<stickslip_status> step_all(const std::vector<History *> &histories,
                                              const std::vector<LoadStep> &loads) {
    if (histories.size() != loads.size()) {
        throw std::invalid_argument("as many loads as histories are needed");
    }
    std::vector<stickslip_history *> handles;
    for (const History *history : histories) {
        handles.push_back(history == nullptr ? nullptr : history->get());
    }
    std::vector<stickslip_status> codes(handles.size());
    stickslip_status status = stickslip_history_step_all(handles.data(), loads.data(), handles.size(), codes.data());
    if (status != STICKSLIP_SOME_FAILED) {
        check(status);
    }
    return codes;
}

/// Takes loads in steps short enough for a tolerance.
class AdaptiveSteps {
  public:
    AdaptiveSteps(const History &history, double tolerance)
        : own_(detail::made<Own>(
              [&](auto **out) { return stickslip_adaptive_steps_new(history.get(), tolerance, out); })) {}

    /// Takes a load, and returns in how many steps.
    std::size_t step(History &history, const LoadStep &load) {
        return detail::asked<std::size_t>(
            [&](auto *out) { return stickslip_adaptive_steps_step(own_.get(), history.get(), &load, out); });
    }
    stickslip_step_error error(History &history, const LoadStep &load) {
        return detail::asked<stickslip_step_error>(
            [&](auto *out) { return stickslip_adaptive_steps_error(own_.get(), history.get(), &load, out); });
    }

  private:
    using Own = detail::Owned<stickslip_adaptive_steps, stickslip_adaptive_steps_free>;
    Own own_;
};

/// What the steps of a history add up to.
class Cycle {
  public:
    explicit Cycle(const History &history)
        : own_(detail::made<Own>([&](auto **out) { return stickslip_cycle_new(history.get(), out); })) {}

    void begin(const History &history) { check(stickslip_cycle_begin(own_.get(), history.get())); }
    void add(const History &history) { check(stickslip_cycle_add(own_.get(), history.get())); }
    stickslip_cycle_result result() const {
        return detail::asked<stickslip_cycle_result>(
            [&](auto *out) { return stickslip_cycle_result_of(own_.get(), out); });
    }
    Field field(std::int32_t which) const {
        return detail::viewed<double>(
            [&](std::size_t *size) { return stickslip_cycle_field(own_.get(), which, size); });
    }

  private:
    using Own = detail::Owned<stickslip_cycle, stickslip_cycle_free>;
    Own own_;
};

} // namespace stickslip

#endif // STICKSLIP_HPP
