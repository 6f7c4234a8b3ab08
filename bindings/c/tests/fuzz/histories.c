/* Calls on histories and on objects created from them. */

#include <math.h>

#include "run.h"

uint8_t *bytes_of(struct run *run, const stickslip_history *history, size_t *length) {
    *length = 0;
    stickslip_status status = stickslip_history_to_bytes(history, NULL, 0, length);
    SEEN(status);
    if (status != STICKSLIP_OK) {
        return NULL;
    }
    uint8_t *bytes = malloc(*length);
    status = stickslip_history_to_bytes(history, bytes, *length, length);
    SEEN(status);
    if (status != STICKSLIP_OK) {
        free(bytes);
        return NULL;
    }
    return bytes;
}

void step(struct run *run) {
    size_t limit = below(run, 30);
    stickslip_load_step load = load_step(run);
    stickslip_observer observer = {rarely(run) ? NULL : watch, &limit};
    SEEN(stickslip_history_step(GET(stickslip_history, pick(run, HISTORY)), maybe(run, &load),
                                below(run, 4) == 0 ? &observer : NULL));
}

void change_history(struct run *run) {
    struct slot *slot = pick(run, HISTORY);
    stickslip_history *history = GET(stickslip_history, slot);
    size_t count = slot->cells == 0 ? 4 : slot->cells;
    double *numbers = array(run, &count, 0.2);
    stickslip_friction law = friction(run, numbers, count);
    stickslip_settings set = settings(run);
    stickslip_load_step load = load_step(run);
    switch (below(run, 13)) {
    case 0:
        SEEN(stickslip_history_set_gap(history, maybe(run, numbers), count));
        break;
    case 1:
        SEEN(stickslip_history_set_friction(history, maybe(run, &law)));
        break;
    case 2:
        SEEN(stickslip_history_set_settings(history, maybe(run, &set)));
        break;
    case 3: {
        stickslip_relative_displacement pattern = {numbers, numbers, count};
        SEEN(stickslip_history_set_relative_displacement(history, maybe(run, &pattern)));
        break;
    }
    case 4:
        SEEN(stickslip_history_set_state(history, GET(stickslip_state, pick(run, STATE))));
        break;
    case 5:
        SEEN(stickslip_state_keep(GET(stickslip_state, pick(run, STATE)), history));
        break;
    case 6: {
        size_t taken = 0;
        SEEN(stickslip_adaptive_steps_step(GET(stickslip_adaptive_steps, pick(run, ADAPTIVE)), history,
                                           maybe(run, &load), maybe_out(run, &taken)));
        break;
    }
    case 7: {
        stickslip_step_error error;
        SEEN(stickslip_adaptive_steps_error(GET(stickslip_adaptive_steps, pick(run, ADAPTIVE)), history,
                                            maybe(run, &load), maybe_out(run, &error)));
        break;
    }
    case 8: {
        struct slot *slots[3];
        stickslip_history *all[3];
        stickslip_load_step loads[3];
        stickslip_status codes[3];
        for (int i = 0; i < 3; i++) {
            slots[i] = pick(run, HISTORY);
            all[i] = GET(stickslip_history, slots[i]);
            loads[i] = load_step(run);
        }
        stickslip_status *asked = maybe_out(run, codes);
        stickslip_status status = stickslip_history_step_all(maybe_out(run, all), maybe(run, loads), 3, asked);
        SEEN(status);
        /* If a batch fails in part, the other histories have taken their step. */
        for (int i = 0; i < 3 && status == STICKSLIP_SOME_FAILED; i++) {
            slots[i]->may_change |= asked != codes || codes[i] == STICKSLIP_OK;
        }
        break;
    }
    case 9: {
        size_t length;
        uint8_t *bytes = bytes_of(run, history, &length);
        stickslip_history *made = NULL;
        struct slot *bodies = pick(run, BODIES);
        if (bytes != NULL && length > 0 && below(run, 2) == 0) {
            bytes[below(run, length)] ^= (uint8_t)(1 << below(run, 8));
        }
        if (rarely(run)) {
            length = below(run, length + 1);
        }
        SEEN(stickslip_history_from_bytes(GET(stickslip_half_space, bodies), rarely(run) ? NULL : bytes,
                                          bytes == NULL ? 0 : length, maybe_out(run, &made)));
        put(run, HISTORY, made, bodies->cells);
        free(bytes);
        break;
    }
    case 10: {
        struct slot *cycle = pick(run, CYCLE);
        SEEN(below(run, 4) == 0 ? stickslip_cycle_begin(GET(stickslip_cycle, cycle), history)
                                : stickslip_cycle_add(GET(stickslip_cycle, cycle), history));
        break;
    }
    case 11: {
        stickslip_jump_limits limits = stickslip_jump_limits_default();
        stickslip_per_cell alpha = {number(run, 0.1), below(run, 4) == 0 ? numbers : NULL, 0};
        alpha.count = alpha.cells == NULL && !rarely(run) ? 0 : count;
        const stickslip_half_space *bodies = GET(stickslip_half_space, pick(run, BODIES));
        double cycles;
        limits.largest_depth = below(run, 2) == 0 ? INFINITY : number(run, 0.1);
        limits.max_residual = number(run, 1.0);
        limits.reserved[0] = rarely(run);
        SEEN(stickslip_cycle_jump(bodies, GET(stickslip_cycle, pick(run, CYCLE)), maybe(run, numbers), count,
                                  maybe(run, &limits), maybe_out(run, &cycles)));
        SEEN(stickslip_max_stable_cycles(bodies, maybe(run, &alpha), maybe(run, numbers), count,
                                         maybe_out(run, &cycles)));
        break;
    }
    default: {
        stickslip_per_cell alpha = {number(run, 0.1), below(run, 4) == 0 ? numbers : NULL, 0};
        alpha.count = alpha.cells == NULL && !rarely(run) ? 0 : count;
        double *depth = calloc(count < LARGE ? count + 1 : 1, sizeof *depth);
        size_t which = below(run, 3);
        SEEN(which == 0   ? stickslip_wear_archard(history, maybe(run, &alpha), maybe_out(run, depth), count)
             : which == 1 ? stickslip_wear_energy(history, maybe(run, &alpha), maybe_out(run, depth), count)
                          : stickslip_wear_threshold_energy(history, maybe(run, &alpha), number(run, 0.1),
                                                            maybe_out(run, depth), count));
        free(depth);
    }
    }
    free(numbers);
}
