// Batches of histories.

#ifndef STICKSLIP_BATCH_HPP
#define STICKSLIP_BATCH_HPP

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <vector>

#include "history.hpp"

namespace stickslip {

/// Takes a step of each of many histories and returns the code of each; histories whose step failed are unchanged. Failed steps
/// do not throw, so the caller must read the codes. A null pointer and a history that occurs twice throw, and no step is taken.
[[nodiscard]] inline std::vector<stickslip_status> step_all(const std::vector<History *> &histories,
                                              const std::vector<LoadStep> &loads) {
    if (histories.size() != loads.size()) {
        throw std::invalid_argument("the number of loads must equal the number of histories");
    }
    std::vector<stickslip_history *> handles;
    for (const History *history : histories) {
        if (history == nullptr) {
            throw std::invalid_argument("a history is a null pointer");
        }
        handles.push_back(history->get());
    }
    std::vector<stickslip_history *> sorted = handles;
    std::sort(sorted.begin(), sorted.end(), std::less<stickslip_history *>());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
        throw std::invalid_argument("a history occurs twice: pass each history once");
    }
    std::vector<stickslip_status> codes(handles.size());
    stickslip_status status = stickslip_history_step_all(handles.data(), loads.data(), handles.size(), codes.data());
    if (status != STICKSLIP_SOME_FAILED) {
        check(status);
    }
    return codes;
}

} // namespace stickslip

#endif // STICKSLIP_BATCH_HPP
