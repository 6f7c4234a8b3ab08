// Batches of histories, adaptive load steps, and cycles.

#ifndef STICKSLIP_PATHS_HPP
#define STICKSLIP_PATHS_HPP

#include <stdexcept>
#include <vector>

#include "history.hpp"

namespace stickslip {

/// Takes a step of each of many histories and returns the code of each; histories whose step failed are unchanged.
inline std::vector<stickslip_status> step_all(const std::vector<History *> &histories,
                                              const std::vector<LoadStep> &loads) {
    if (histories.size() != loads.size()) {
        throw std::invalid_argument("the number of loads must equal the number of histories");
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

/// Adaptive load stepper, which applies loads in steps that are short enough for a tolerance.
class AdaptiveSteps {
  public:
    AdaptiveSteps(const History &history, double tolerance)
        : own_(detail::made<Own>(
              [&](auto **out) { return stickslip_adaptive_steps_new(history.get(), tolerance, out); })) {}

    /// Applies a load and returns the number of steps.
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

/// Sums over the steps of a history.
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
    /// Returns the number of cycles like this one that a jump may skip, not rounded; depth is the depth that the cycle
    /// removed.
    double jump(const HalfSpace &bodies, Field depth,
                const stickslip_jump_limits &limits = stickslip_jump_limits_default()) const {
        return detail::asked<double>([&](double *out) {
            return stickslip_cycle_jump(bodies.get(), own_.get(), depth.data(), depth.size(), &limits, out);
        });
    }

  private:
    using Own = detail::Owned<stickslip_cycle, stickslip_cycle_free>;
    Own own_;
};

/// Returns the number of cycles whose wear may be removed in one step without growing oscillations of the pressure.
inline double max_stable_cycles(const HalfSpace &bodies, const stickslip_per_cell &coefficient, Field slip_distance) {
    return detail::asked<double>([&](double *out) {
        return stickslip_max_stable_cycles(bodies.get(), &coefficient, slip_distance.data(), slip_distance.size(), out);
    });
}

} // namespace stickslip

#endif // STICKSLIP_PATHS_HPP
