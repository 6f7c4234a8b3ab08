/* Objects in their slots, and the check that failed calls leave them unchanged. */

#include <stdio.h>
#include <string.h>

#include "run.h"

void broken(struct run *run, int line, const char *what) {
    fprintf(stderr, "line %d: %s\n", line, what);
    run->broken++;
}

void seen(struct run *run, stickslip_status status, int line) {
    run->calls++;
    if (status < 0 || status >= CODES || status == STICKSLIP_PANIC ||
        (status != STICKSLIP_OK && strlen(stickslip_last_error_message()) == 0)) {
        broken(run, line, stickslip_last_error_message());
        return;
    }
    run->codes[status]++;
    if (status != STICKSLIP_OK) {
        run->failed = status;
    }
}
#define RELEASE(name)                                                                                                  \
    static stickslip_status release_##name(void *object) { return stickslip_##name##_free(object); }
RELEASE(half_space)
RELEASE(normal_solver)
RELEASE(normal_solution)
RELEASE(tangential_solver)
RELEASE(tangential_solution)
RELEASE(coupled_solver)
RELEASE(coupled_solution)
RELEASE(history)
RELEASE(state)
RELEASE(adaptive_steps)
RELEASE(cycle)
RELEASE(planes)
RELEASE(rolling_solver)
RELEASE(rolling_solution)
static stickslip_status (*const freed_by[KINDS])(void *) = {
    release_half_space,       release_normal_solver,  release_normal_solution,  release_tangential_solver,
    release_tangential_solution, release_coupled_solver, release_coupled_solution, release_history,
    release_state,            release_adaptive_steps, release_cycle, release_planes,
    release_rolling_solver,   release_rolling_solution};

stickslip_status release(enum kind kind, void *object) { return freed_by[kind](object); }

struct slot *pick(struct run *run, enum kind kind) {
    struct world *world = below(run, 3) == 0 ? run->shared : &run->own;
    struct slot *slot = &world->slots[kind][below(run, SLOTS)];
    if (world == &run->own) {
        slot->is_given = true;
    }
    return slot;
}

void put(struct run *run, enum kind kind, void *object, size_t cells) {
    if (object == NULL) {
        return;
    }
    struct slot *slot = &run->own.slots[kind][below(run, SLOTS)];
    release(kind, slot->object);
    *slot = (struct slot){object, cells, hash_of(kind, object), false, false};
}

/* FNV-1a hash by words of an empty input. */
#define NOTHING 0xcbf29ce484222325u

static uint64_t mixed(uint64_t hash, const void *data, size_t bytes) {
    for (size_t i = 0; i < bytes; i += sizeof(uint64_t)) {
        uint64_t word = 0;
        memcpy(&word, (const char *)data + i, bytes - i < sizeof word ? bytes - i : sizeof word);
        hash = (hash ^ word) * 0x100000001b3u;
    }
    return hash;
}

uint64_t hash_of(enum kind kind, const void *object) {
    uint64_t hash = NOTHING;
    if (kind == HISTORY) {
        size_t length = 0;
        uint8_t *bytes = NULL;
        if (stickslip_history_to_bytes(object, NULL, 0, &length) == STICKSLIP_OK) {
            bytes = malloc(length);
            stickslip_history_to_bytes(object, bytes, length, &length);
            hash = mixed(hash, bytes, length);
        }
        free(bytes);
        return hash;
    }
    double capacity;
    if (kind == TANGENTIAL && stickslip_tangential_solver_friction_capacity(object, &capacity) == STICKSLIP_OK) {
        return mixed(hash, &capacity, sizeof capacity);
    }
    for (int32_t which = STICKSLIP_PRESSURE; which <= STICKSLIP_STRESS_YZ; which++) {
        size_t count = 0;
        const double *samples = kind == PRESSED   ? stickslip_normal_solution_field(object, which, &count)
                                : kind == SHEARED ? stickslip_tangential_solution_field(object, which, &count)
                                : kind == BOTH    ? stickslip_coupled_solution_field(object, which, &count)
                                : kind == CYCLE   ? stickslip_cycle_field(object, which, &count)
                                : kind == PLANES  ? stickslip_planes_field(object, which, &count)
                                : kind == ROLLED  ? stickslip_rolling_solution_field(object, which, &count)
                                                  : NULL;
        if (samples != NULL) {
            hash = mixed(hash, samples, count * sizeof *samples);
        }
    }
    return hash;
}

/* The header permits cancelled solves to leave their last iterate in the solution. */
static bool is_kept(const struct run *run, enum kind kind, const struct slot *slot) {
    bool is_solution = kind == PRESSED || kind == SHEARED || kind == BOTH || kind == ROLLED;
    return run->failed != STICKSLIP_OK && !slot->may_change &&
           !(is_solution && run->failed == STICKSLIP_NOT_CONVERGED);
}

void compare(struct run *run) {
    for (int kind = 0; kind < KINDS; kind++) {
        for (int i = 0; i < SLOTS; i++) {
            struct slot *slot = &run->own.slots[kind][i];
            if (slot->is_given && slot->object != NULL) {
                uint64_t hash = hash_of((enum kind)kind, slot->object);
                if (is_kept(run, (enum kind)kind, slot)) {
                    run->compared += slot->hash != NOTHING;
                    if (hash != slot->hash) {
                        broken(run, kind, "a failed call has changed an object of this kind");
                    }
                }
                slot->hash = hash;
            }
            slot->is_given = slot->may_change = false;
        }
    }
    run->failed = STICKSLIP_OK;
}
