// Load histories: steps with memory of slip, and saved states.

#ifndef STICKSLIP_HISTORY_HPP
#define STICKSLIP_HISTORY_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include "bodies.hpp"
#include "loads.hpp"

namespace stickslip {

class History;

using StiffnessOptions = stickslip_stiffness_options;

/// Buffers, options and report of stiffnesses that are computed repeatedly. Later stiffnesses allocate only for larger contacts.
class StiffnessWorkspace {
  public:
    explicit StiffnessWorkspace(const StiffnessOptions &options = stickslip_stiffness_options_default())
        : own_(detail::made<Own>([&](auto **out) { return stickslip_stiffness_workspace_new(&options, out); })) {}

    /// Sets the options of the next stiffness. The workspace keeps its buffers.
    void set_options(const StiffnessOptions &options) {
        check(stickslip_stiffness_workspace_set_options(get(), &options));
    }
    /// Returns the report of the last stiffness.
    Report report() const {
        return detail::asked<Report>([&](auto *out) { return stickslip_stiffness_workspace_report(get(), out); });
    }
    stickslip_stiffness_workspace *get() const { return own_.get(); }

  private:
    using Own = detail::Owned<stickslip_stiffness_workspace, stickslip_stiffness_workspace_free>;
    Own own_;
};

/// Saved state of a history; a history can return to it.
class State {
  public:
    explicit State(const History &history);
    void keep(const History &history);
    stickslip_state *get() const { return own_.get(); }

  private:
    using Own = detail::Owned<stickslip_state, stickslip_state_free>;
    Own own_;
};

/// Contact that is loaded step by step, with memory of slip.
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

    /// Takes a step and returns its results.
    stickslip_step_result step(const LoadStep &load, const Observe &observe = nullptr) {
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_history_step(get(), &load, observer);
        });
        return result();
    }
    /// Applies a load in as many steps as a tolerance requires, and returns their number. Contacts of dissimilar bodies
    /// must be pressed with this function.
    std::size_t press(const LoadStep &load, double tolerance, const Observe &observe = nullptr) {
        std::size_t taken = 0;
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_history_press(get(), &load, tolerance, observer, &taken);
        });
        return taken;
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
    /// Returns the stiffness of a next step from the current state: stick cells resist fully, including those that came
    /// into contact in the last step, and cells at their friction limit continue to slip.
    Stiffness next_stiffness() const {
        return detail::asked<Stiffness>([&](auto *out) { return stickslip_history_next_stiffness(get(), nullptr, out); });
    }
    /// Returns the stiffness with the options and the buffers of a workspace.
    Stiffness stiffness(StiffnessWorkspace &workspace, const Observe &observe = nullptr) const {
        Stiffness found{};
        detail::Watch(observe).run([&](const stickslip_observer *observer) {
            return stickslip_history_stiffness_with(get(), workspace.get(), observer, &found);
        });
        return found;
    }
    double friction_capacity() const {
        return detail::asked<double>([&](double *out) { return stickslip_history_friction_capacity(get(), out); });
    }
    /// Returns the reports of pressure and traction.
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
    /// Returns a field, STICKSLIP_PRESSURE to STICKSLIP_YIELDED_DEPTH except displacements.
    Field field(std::int32_t which) const {
        return detail::viewed<double>([&](std::size_t *size) { return stickslip_history_field(get(), which, size); });
    }
    Field pressure() const { return field(STICKSLIP_PRESSURE); }
    Field traction_x() const { return field(STICKSLIP_TRACTION_X); }
    Field traction_y() const { return field(STICKSLIP_TRACTION_Y); }
    Zones zones() const {
        return detail::viewed<std::uint8_t>([&](std::size_t *size) { return stickslip_history_zones(get(), size); });
    }

    /// Returns the contact spots after the last step, with the stick ratio of each.
    Spots spots() const {
        return detail::spotted(pressure().size(), [&](auto... to) { return stickslip_history_spots(get(), to...); });
    }

    /// Adds to depth the depth that the energy law removes in the last step.
    void wear_energy(const stickslip_per_cell &coefficient, std::vector<double> &depth) const {
        check(stickslip_wear_energy(get(), &coefficient, depth.data(), depth.size()));
    }
    /// Adds to depth the depth that Archard's law removes in the last step.
    void wear_archard(const stickslip_per_cell &coefficient, std::vector<double> &depth) const {
        check(stickslip_wear_archard(get(), &coefficient, depth.data(), depth.size()));
    }
    /// Adds to depth the depth that the energy law with a threshold of the dissipated energy per area removes in the last
    /// step.
    void wear_threshold_energy(const stickslip_per_cell &coefficient, double threshold, std::vector<double> &depth) const {
        check(stickslip_wear_threshold_energy(get(), &coefficient, threshold, depth.data(), depth.size()));
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

} // namespace stickslip

#endif // STICKSLIP_HISTORY_HPP
