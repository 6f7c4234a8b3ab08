// Views, errors and observers.

#ifndef STICKSLIP_CORE_HPP
#define STICKSLIP_CORE_HPP

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../stickslip.h"

namespace stickslip {

using Grid = stickslip_grid;
using Layer = stickslip_layer;
using Material = stickslip_material;
using Boundary = stickslip_boundary;
using Settings = stickslip_settings;
using Report = stickslip_report;
using Stiffness = stickslip_stiffness;
using StiffnessOptions = stickslip_stiffness_options;
using Iteration = stickslip_iteration;

/// View of the samples of an array of the caller or of a field of an object, row by row with x fastest. The view does not own
/// the samples, so it cannot be created from a temporary vector: store the vector first. Members of a temporary object, such
/// as `solver.solve().pressure()`, return a vector with a copy of the samples instead of a view.
///
/// A view of a field is valid until the object is changed or destroyed. A later solve or step, also one that fails, writes to
/// the same memory or to a second array that the object exchanges with it. A view from before can then contain the samples of
/// any of these solves, and it does not detect the change. Call the member again after each solve or step, and store samples
/// that must remain with copy().
template <class T> class View {
  public:
    View(const T *data, std::size_t size) : data_(data), size_(size) {}
    View(const std::vector<T> &samples) : View(samples.data(), samples.size()) {}
    View(const std::vector<T> &&) = delete;

    /// Returns a copy of the samples, which remains valid when the object changes.
    std::vector<T> copy() const { return {begin(), end()}; }
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

/// Samples that a function reads during its call only. A field and a vector convert to it without a copy. A temporary vector
/// is moved into it, so that a stored argument remains valid.
class FieldArgument {
  public:
    FieldArgument(const double *data, std::size_t size) : data_(data), size_(size) {}
    FieldArgument(const Field &field) : FieldArgument(field.data(), field.size()) {}
    FieldArgument(const std::vector<double> &samples) : FieldArgument(samples.data(), samples.size()) {}
    FieldArgument(std::vector<double> &&samples)
        : owned_(std::move(samples)), data_(owned_.data()), size_(owned_.size()) {}
    FieldArgument(const std::vector<double> &&samples) : FieldArgument(std::vector<double>(samples)) {}
    FieldArgument(const FieldArgument &) = delete;
    FieldArgument &operator=(const FieldArgument &) = delete;

    const double *data() const { return data_; }
    std::size_t size() const { return size_; }

  private:
    std::vector<double> owned_;
    const double *data_;
    std::size_t size_;
};

/// Failure of a call.
class Error : public std::runtime_error {
  public:
    Error() : Error(numbers_of_last()) {}

    /// Returns the code of the C function.
    stickslip_status code() const { return numbers_.code; }
    /// Returns the numbers of the failure: invalid value, limit, index and others.
    const stickslip_error &numbers() const { return numbers_; }
    /// Returns the report of a solve that did not converge; for other failures its status is STICKSLIP_UNSOLVED.
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

/// Throws an Error unless the call succeeded.
inline void check(stickslip_status status) {
    if (status != STICKSLIP_OK) {
        throw Error();
    }
}

/// Observer that receives every iteration of a solve and returns false to end it. An exception of the observer ends the
/// solve and propagates to the caller.
using Observe = std::function<bool(const Iteration &)>;

/// Observer that receives the results of every accepted step of a load and returns false to end the call, which then undoes
/// all steps. An exception of the observer does the same and propagates to the caller.
using ObserveStep = std::function<bool(const stickslip_step_result &)>;

/// Contact spots and, for every cell, the number of its spot: counted from one, zero outside the contact.
struct Spots {
    std::vector<stickslip_spot> spots;
    std::vector<std::uint32_t> labels;
};

/// Edges of a contact located inside the cells. They include the value at the centre and the mean over each cell,
/// either of the pressure or of the magnitude of the traction.
struct Edges {
    stickslip_edges edges;
    std::vector<double> centres;
    std::vector<double> means;
};

namespace detail {

/// Deleter that frees an object with its C function.
template <class T, stickslip_status (*Free)(T *)> struct Freer {
    void operator()(T *object) const { Free(object); }
};

template <class T, stickslip_status (*Free)(T *)> using Owned = std::unique_ptr<T, Freer<T, Free>>;

/// Takes ownership of an object that a C function creates.
template <class Owner, class Make> Owner made(Make make) {
    typename Owner::pointer object = nullptr;
    check(make(&object));
    return Owner(object);
}

/// Returns a view of the field that a C function returns.
template <class T, class Ask> View<T> viewed(Ask ask) {
    std::size_t size = 0;
    const T *data = ask(&size);
    if (data == nullptr) {
        throw Error();
    }
    return View<T>(data, size);
}

/// Returns all entries from a C function that writes them to a buffer.
template <class T, class Ask> std::vector<T> listed(Ask ask) {
    std::size_t count = 0;
    check(ask(nullptr, 0, &count));
    std::vector<T> entries(count);
    check(ask(entries.data(), count, &count));
    return entries;
}

/// Returns the spots from a C function, with labels for the given number of cells.
template <class Ask> Spots spotted(std::size_t cells, Ask ask) {
    std::size_t count = 0;
    check(ask(nullptr, 0, &count, nullptr, 0));
    Spots found{std::vector<stickslip_spot>(count), std::vector<std::uint32_t>(cells)};
    check(ask(found.spots.data(), count, &count, found.labels.data(), cells));
    return found;
}

/// Returns the edges from a C function, with values for the given number of cells.
template <class Ask> Edges edged(std::size_t cells, Ask ask) {
    Edges found{{}, std::vector<double>(cells), std::vector<double>(cells)};
    check(ask(&found.edges, found.centres.data(), found.means.data(), cells));
    return found;
}

/// Removes the entries that a C function has not written because it failed, and returns its status.
template <class T> stickslip_status kept(stickslip_status status, std::vector<T> &entries) {
    stickslip_error numbers{};
    if (status != STICKSLIP_OK && stickslip_last_error(&numbers) == STICKSLIP_OK && numbers.found < entries.size()) {
        entries.resize(numbers.found);
    }
    return status;
}

/// Observer for C. An exception must not pass through C: it ends the solve and is rethrown afterwards.
template <class Seen> class Watch {
  public:
    explicit Watch(const std::function<bool(const Seen &)> &observe) : observe_(observe) {}

    template <class Solve> void run(Solve solve) {
        using OfSteps = std::is_same<Seen, stickslip_step_result>;
        std::conditional_t<OfSteps::value, stickslip_step_observer, stickslip_observer> observer = {&Watch::call, this};
        stickslip_status status = solve(observe_ ? &observer : nullptr);
        if (thrown_) {
            std::rethrow_exception(thrown_);
        }
        check(status);
    }

  private:
    static std::int32_t call(const Seen *seen, void *user) noexcept {
        auto *self = static_cast<Watch *>(user);
        try {
            return self->observe_(*seen) ? 1 : 0;
        } catch (...) {
            self->thrown_ = std::current_exception();
            return 0;
        }
    }

    const std::function<bool(const Seen &)> &observe_;
    std::exception_ptr thrown_;
};

} // namespace detail

} // namespace stickslip

#endif // STICKSLIP_CORE_HPP
