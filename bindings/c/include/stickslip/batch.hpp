// Batches of histories.

#ifndef STICKSLIP_BATCH_HPP
#define STICKSLIP_BATCH_HPP

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

} // namespace stickslip

#endif // STICKSLIP_BATCH_HPP
