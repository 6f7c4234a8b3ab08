/* Random calls of every function: NULL and misaligned pointers, wrong lengths, NaN and infinities, constants that do not exist,
 * objects of other grids, several threads at the same objects. Every call must return a code; none may crash, leak, or
 * be STICKSLIP_PANIC; what fails has a message, and a step that fails leaves its history as it was.
 * fuzz [calls, default 20000] [threads, default 3] [seed, default 1] */

#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <stickslip.h>

/* A refused allocation is a code of its own. */
const char *__asan_default_options(void);
const char *__asan_default_options(void) { return "allocator_may_return_null=1"; }

enum kind { BODIES, NORMAL, PRESSED, TANGENTIAL, SHEARED, COUPLED, BOTH, HISTORY, STATE, ADAPTIVE, CYCLE, KINDS };
#define SLOTS 3
#define CODES 128
/* More than the cells of any grid here. */
#define LARGE 16384

struct slot {
    void *object;
    size_t cells;
};

struct world {
    struct slot slots[KINDS][SLOTS];
};

struct run {
    struct world own, *shared;
    uint64_t state;
    size_t calls, broken;
    size_t codes[CODES];
};

static uint64_t next(struct run *run) {
    run->state += 0x9e3779b97f4a7c15u;
    uint64_t z = run->state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static size_t below(struct run *run, size_t count) { return (size_t)(next(run) % count); }
static bool rarely(struct run *run) { return below(run, 40) == 0; }
static double unit(struct run *run) { return (double)(next(run) >> 11) * 0x1p-53; }

/* Mostly near scale, sometimes what no number should be. */
static double number(struct run *run, double scale) {
    static const double odd[] = {0.0, -1.0, NAN, INFINITY, -INFINITY, 1e300, -1e300, 1e-300, 5e-324, -0.0};
    return rarely(run) ? odd[below(run, sizeof odd / sizeof *odd)] : scale * (0.2 + unit(run));
}

static int32_t option(struct run *run, int32_t count) {
    return rarely(run) ? (int32_t)next(run) : (int32_t)below(run, (size_t)count);
}

/* A pointer as it is; sometimes NULL or misaligned. */
static const void *maybe(struct run *run, const void *pointer) {
    if (!rarely(run)) {
        return pointer;
    }
    return below(run, 2) == 0 || pointer == NULL ? NULL : (const char *)pointer + 1;
}
static void *maybe_out(struct run *run, void *pointer) { return (void *)(uintptr_t)maybe(run, pointer); }

static void seen(struct run *run, stickslip_status status, int line) {
    run->calls++;
    if (status < 0 || status >= CODES || status == STICKSLIP_PANIC ||
        (status != STICKSLIP_OK && strlen(stickslip_last_error_message()) == 0)) {
        fprintf(stderr, "line %d: code %d, %s\n", line, (int)status, stickslip_last_error_message());
        run->broken++;
        return;
    }
    run->codes[status]++;
}
#define SEEN(call) seen(run, (call), __LINE__)

/* An array of so many numbers, or of another length, which count then has. */
static double *array(struct run *run, size_t *count, double scale) {
    size_t right = *count;
    if (rarely(run)) {
        const size_t odd[] = {0, 1, right + 1, right - 1, 2 * right, SIZE_MAX, SIZE_MAX / 8};
        *count = odd[below(run, 7)];
    }
    size_t length = *count < LARGE ? *count : 1;
    double *numbers = malloc((length == 0 ? 1 : length) * sizeof *numbers);
    for (size_t i = 0; i < length; i++) {
        numbers[i] = scale * unit(run);
    }
    if (length > 0 && rarely(run)) {
        numbers[below(run, length)] = number(run, scale);
    }
    return numbers;
}

static struct slot *pick(struct run *run, enum kind kind) {
    struct world *world = below(run, 3) == 0 ? run->shared : &run->own;
    return &world->slots[kind][below(run, SLOTS)];
}
#define GET(type, slot) ((type *)maybe_out(run, (slot)->object))

static stickslip_settings settings(struct run *run) {
    stickslip_settings settings = stickslip_settings_default();
    settings.method = option(run, 2);
    settings.tolerance = rarely(run) ? number(run, 0.1) : pow(10.0, -3.0 - 9.0 * unit(run));
    settings.max_iterations = rarely(run) ? below(run, 4) : 500;
    settings.time_limit = rarely(run) ? number(run, 1e-4) : INFINITY;
    return settings;
}

static stickslip_friction friction(struct run *run, double *cells, size_t count) {
    stickslip_friction friction = stickslip_coulomb(number(run, 0.5));
    if (below(run, 4) == 0) {
        friction.coefficient.cells = maybe(run, cells);
        friction.coefficient.count = count;
    }
    if (below(run, 8) == 0) {
        friction.max_shear_stress = number(run, 0.2);
    }
    return friction;
}

static stickslip_normal_load normal_load(struct run *run) {
    stickslip_normal_load load = {option(run, 3), number(run, 0.1)};
    return load;
}

static stickslip_control control(struct run *run) {
    stickslip_control control = {below(run, 3) == 0 ? option(run, 5) : STICKSLIP_HOLD, number(run, 0.02), number(run, 2.0)};
    return control;
}

static stickslip_tangential_load tangential_load(struct run *run) {
    stickslip_tangential_load load = {control(run), control(run), below(run, 8) == 0 ? number(run, 1e-3) : 0.0};
    return load;
}

static stickslip_load_step load_step(struct run *run) {
    stickslip_load_step load = {normal_load(run),           control(run),      control(run),          below(run, 8) == 0,
                                number(run, 1e-3), below(run, 8) == 0, number(run, 0.01)};
    return load;
}

/* Goes on, sometimes ends the solve. */
static int32_t watch(const stickslip_iteration *iteration, void *user) {
    return iteration->iteration < *(size_t *)user;
}

static void put(struct run *run, enum kind kind, void *object, size_t cells, stickslip_status (*release)(void *)) {
    if (object == NULL) {
        return;
    }
    struct slot *slot = &run->own.slots[kind][below(run, SLOTS)];
    release(slot->object);
    slot->object = object, slot->cells = cells;
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
static stickslip_status (*const release[KINDS])(void *) = {
    release_half_space,       release_normal_solver,  release_normal_solution,  release_tangential_solver,
    release_tangential_solution, release_coupled_solver, release_coupled_solution, release_history,
    release_state,            release_adaptive_steps, release_cycle};

static void make_bodies(struct run *run) {
    stickslip_grid grid = {1 + below(run, 10), 1 + below(run, 10), number(run, 1.0), number(run, 1.0)};
    if (rarely(run)) {
        grid.nx = below(run, 2) == 0 ? 0 : SIZE_MAX >> below(run, 16);
    } else if (below(run, 2) == 0) {
        grid = (stickslip_grid){8, 8, 0.5, 0.5};
    } else if (below(run, 60) == 0) {
        grid.nx = grid.ny = 66; /* so many that other threads solve it */
    }
    stickslip_material one = {number(run, 1.0), 0.5 * unit(run), below(run, 4) == 0 ? number(run, 0.1) : 0.0};
    stickslip_material two = {below(run, 3) == 0 ? INFINITY : one.youngs_modulus, one.poisson_ratio, 0.0};
    if (below(run, 2) == 0) {
        one.poisson_ratio = two.poisson_ratio = 0.5;
    }
    stickslip_boundary boundary = {below(run, 2) == 0 ? STICKSLIP_NON_PERIODIC : option(run, 3), number(run, 50.0)};
    stickslip_half_space *bodies = NULL;
    SEEN(stickslip_half_space_new(maybe(run, &grid), maybe(run, &one), maybe(run, &two), maybe(run, &boundary),
                                  maybe_out(run, &bodies)));
    put(run, BODIES, bodies, grid.nx * grid.ny, release[BODIES]);
}

/* Makes or reads one object that a half-space is needed for. */
static void make(struct run *run) {
    struct slot *bodies = pick(run, BODIES), *pressed = pick(run, PRESSED), *history = pick(run, HISTORY);
    size_t cells = bodies->cells == 0 ? 4 : bodies->cells, count = cells, mu_count = cells;
    double *gap = array(run, &count, 0.2), *mu = array(run, &mu_count, 0.5);
    stickslip_friction law = friction(run, mu, mu_count);
    stickslip_normal_load press = normal_load(run);
    stickslip_tangential_load drag = tangential_load(run);
    stickslip_settings set = settings(run);
    stickslip_per_cell hardness = {number(run, 0.05), below(run, 2) == 0 ? mu : NULL, mu_count};
    stickslip_relative_displacement relative = {maybe(run, mu), maybe(run, mu), mu_count};
    const stickslip_half_space *on = GET(stickslip_half_space, bodies);
    void *made = NULL;
    switch (below(run, 11)) {
    case 0:
        SEEN(stickslip_normal_solver_new(on, maybe(run, gap), count, maybe(run, &press),
                                         below(run, 4) == 0 ? &hardness : NULL, below(run, 2) == 0 ? &set : NULL,
                                         maybe_out(run, &made)));
        put(run, NORMAL, made, cells, release[NORMAL]);
        break;
    case 1: {
        struct slot *solver = pick(run, NORMAL);
        SEEN(stickslip_normal_solution_new(GET(stickslip_normal_solver, solver), maybe_out(run, &made)));
        put(run, PRESSED, made, solver->cells, release[PRESSED]);
        break;
    }
    case 2: {
        stickslip_tangential_options options = stickslip_tangential_options_default();
        options.model = option(run, 2), options.coupling = option(run, 3), options.settings = set;
        options.relative_displacement = below(run, 6) == 0 ? &relative : NULL;
        const stickslip_tangential_options *given = below(run, 2) == 0 ? &options : NULL;
        if (below(run, 2) == 0) {
            SEEN(stickslip_tangential_solver_new(on, GET(stickslip_normal_solution, pressed), maybe(run, &law),
                                                 maybe(run, &drag), given, maybe_out(run, &made)));
        } else {
            SEEN(stickslip_tangential_solver_new_under(on, maybe(run, gap), count, maybe(run, &law), maybe(run, &drag),
                                                       given, maybe_out(run, &made)));
        }
        put(run, TANGENTIAL, made, cells, release[TANGENTIAL]);
        break;
    }
    case 3: {
        struct slot *solver = pick(run, TANGENTIAL);
        SEEN(stickslip_tangential_solution_new(GET(stickslip_tangential_solver, solver), maybe_out(run, &made)));
        put(run, SHEARED, made, solver->cells, release[SHEARED]);
        break;
    }
    case 4:
        SEEN(stickslip_coupled_solver_new(on, maybe(run, gap), count, maybe(run, &law), maybe(run, &press),
                                          maybe(run, &drag), below(run, 6) == 0 ? &relative : NULL,
                                          below(run, 2) == 0 ? &set : NULL, maybe_out(run, &made)));
        put(run, COUPLED, made, cells, release[COUPLED]);
        break;
    case 5: {
        struct slot *solver = pick(run, COUPLED);
        SEEN(stickslip_coupled_solution_new(GET(stickslip_coupled_solver, solver), maybe_out(run, &made)));
        put(run, BOTH, made, solver->cells, release[BOTH]);
        break;
    }
    case 6: {
        stickslip_history_options options = stickslip_history_options_default();
        options.axis = option(run, 2), options.model = option(run, 2), options.coupling = option(run, 3);
        options.touch_rule = option(run, 2), options.permanent_set = option(run, 2), options.settings = set;
        options.hardness = below(run, 6) == 0 ? &hardness : NULL;
        options.relative_displacement = below(run, 6) == 0 ? &relative : NULL;
        SEEN(stickslip_history_new(on, maybe(run, gap), count, maybe(run, &law),
                                   below(run, 2) == 0 ? &options : NULL, maybe_out(run, &made)));
        put(run, HISTORY, made, cells, release[HISTORY]);
        break;
    }
    case 7:
        SEEN(stickslip_history_clone(GET(stickslip_history, history), maybe_out(run, &made)));
        put(run, HISTORY, made, history->cells, release[HISTORY]);
        break;
    case 8:
        SEEN(stickslip_state_new(GET(stickslip_history, history), maybe_out(run, &made)));
        put(run, STATE, made, history->cells, release[STATE]);
        break;
    case 9:
        SEEN(stickslip_adaptive_steps_new(GET(stickslip_history, history), number(run, 0.01), maybe_out(run, &made)));
        put(run, ADAPTIVE, made, history->cells, release[ADAPTIVE]);
        break;
    default:
        SEEN(stickslip_cycle_new(GET(stickslip_history, history), maybe_out(run, &made)));
        put(run, CYCLE, made, history->cells, release[CYCLE]);
    }
    free(gap), free(mu);
}

/* A history as bytes; NULL if it has none to give. */
static uint8_t *bytes_of(struct run *run, const stickslip_history *history, size_t *length) {
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

/* A step that fails leaves the history as it was; only of one's own histories. */
static void step(struct run *run) {
    struct slot *slot = pick(run, HISTORY);
    bool is_own = slot >= &run->own.slots[0][0] && slot < &run->own.slots[KINDS - 1][SLOTS];
    bool is_watched = is_own && slot->object != NULL && below(run, 8) == 0;
    stickslip_history *history = is_watched ? slot->object : GET(stickslip_history, slot);
    size_t length = 0, limit = below(run, 30), again = 0;
    uint8_t *before = is_watched ? bytes_of(run, history, &length) : NULL;
    stickslip_load_step load = load_step(run);
    stickslip_observer observer = {rarely(run) ? NULL : watch, &limit};
    stickslip_status status =
        stickslip_history_step(history, maybe(run, &load), below(run, 4) == 0 ? &observer : NULL);
    SEEN(status);
    if (before != NULL && status != STICKSLIP_OK) {
        uint8_t *after = bytes_of(run, history, &again);
        if (after == NULL || again != length || memcmp(before, after, length) != 0) {
            fprintf(stderr, "a failed step has changed its history\n");
            run->broken++;
        }
        free(after);
    }
    free(before);
}

static void change_history(struct run *run) {
    struct slot *slot = pick(run, HISTORY);
    stickslip_history *history = GET(stickslip_history, slot);
    size_t count = slot->cells == 0 ? 4 : slot->cells;
    double *numbers = array(run, &count, 0.2);
    stickslip_friction law = friction(run, numbers, count);
    stickslip_settings set = settings(run);
    stickslip_load_step load = load_step(run);
    switch (below(run, 12)) {
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
        stickslip_history *all[3];
        stickslip_load_step loads[3];
        stickslip_status codes[3];
        for (int i = 0; i < 3; i++) {
            all[i] = GET(stickslip_history, pick(run, HISTORY));
            loads[i] = load_step(run);
        }
        SEEN(stickslip_history_step_all(maybe_out(run, all), maybe(run, loads), 3, maybe_out(run, codes)));
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
        put(run, HISTORY, made, bodies->cells, release[HISTORY]);
        free(bytes);
        break;
    }
    case 10: {
        struct slot *cycle = pick(run, CYCLE);
        SEEN(below(run, 4) == 0 ? stickslip_cycle_begin(GET(stickslip_cycle, cycle), history)
                                : stickslip_cycle_add(GET(stickslip_cycle, cycle), history));
        break;
    }
    default: {
        stickslip_per_cell alpha = {number(run, 0.1), below(run, 4) == 0 ? numbers : NULL, count};
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

/* A field or zones: read to the end if nobody else can change them. */
static void field(struct run *run) {
    int32_t which = option(run, 21);
    size_t count = 0;
    enum kind kinds[] = {PRESSED, SHEARED, BOTH, HISTORY, CYCLE};
    enum kind kind = kinds[below(run, 5)];
    struct slot *slot = pick(run, kind);
    bool is_shared = slot >= &run->shared->slots[0][0] && slot <= &run->shared->slots[KINDS - 1][SLOTS - 1];
    const void *object = maybe(run, slot->object);
    const double *samples = NULL;
    const uint8_t *zones = NULL;
    switch (kind) {
    case PRESSED:
        samples = stickslip_normal_solution_field(object, which, maybe_out(run, &count));
        break;
    case SHEARED:
        samples = stickslip_tangential_solution_field(object, which, maybe_out(run, &count));
        zones = stickslip_tangential_solution_zones(object, NULL);
        break;
    case BOTH:
        samples = stickslip_coupled_solution_field(object, which, maybe_out(run, &count));
        zones = stickslip_coupled_solution_zones(object, NULL);
        break;
    case HISTORY:
        samples = stickslip_history_field(object, which, maybe_out(run, &count));
        zones = stickslip_history_zones(object, NULL);
        break;
    default:
        samples = stickslip_cycle_field(object, which, maybe_out(run, &count));
    }
    run->calls++;
    if (is_shared) {
        return;
    }
    volatile double sum = 0.0;
    for (size_t i = 0; samples != NULL && i < count; i++) {
        sum += samples[i];
    }
    for (size_t i = 0; zones != NULL && samples != NULL && i < count; i++) {
        if (zones[i] > STICKSLIP_SLIP) {
            run->broken++;
        }
    }
}

static void read_numbers(struct run *run) {
    stickslip_history *history = GET(stickslip_history, pick(run, HISTORY));
    const stickslip_normal_solution *pressed = GET(stickslip_normal_solution, pick(run, PRESSED));
    const stickslip_tangential_solution *sheared = GET(stickslip_tangential_solution, pick(run, SHEARED));
    const stickslip_coupled_solution *both = GET(stickslip_coupled_solution, pick(run, BOTH));
    const stickslip_half_space *bodies = GET(stickslip_half_space, pick(run, BODIES));
    stickslip_normal_result normal;
    stickslip_tangential_result tangential;
    stickslip_step_result result;
    stickslip_report report, other;
    stickslip_coupled_report coupled;
    stickslip_warning warnings[2];
    stickslip_stiffness stiffness;
    stickslip_normal_stiffness slope;
    stickslip_tangential_stiffness slopes;
    stickslip_cycle_result cycle;
    stickslip_grid grid;
    stickslip_pair pair;
    stickslip_error error;
    double value;
    size_t count, capacity = below(run, 3);
    switch (below(run, 22)) {
    case 0:
        SEEN(stickslip_normal_solution_result(pressed, maybe_out(run, &normal)));
        break;
    case 1:
        SEEN(stickslip_tangential_solution_result(sheared, maybe_out(run, &tangential)));
        break;
    case 2:
        SEEN(stickslip_coupled_solution_results(both, maybe_out(run, &normal), maybe_out(run, &tangential)));
        break;
    case 3:
        SEEN(stickslip_history_result(history, maybe_out(run, &result)));
        break;
    case 4:
        SEEN(stickslip_history_normal_result(history, maybe_out(run, &normal)));
        break;
    case 5:
        SEEN(stickslip_history_reports(history, maybe_out(run, &report), maybe_out(run, &other)));
        break;
    case 6:
        SEEN(stickslip_normal_solution_report(pressed, maybe_out(run, &report)));
        break;
    case 7:
        SEEN(stickslip_tangential_solution_report(sheared, maybe_out(run, &report)));
        break;
    case 8:
        SEEN(stickslip_coupled_solution_report(both, maybe_out(run, &coupled)));
        break;
    case 9:
        SEEN(stickslip_normal_solution_warnings(pressed, maybe_out(run, warnings), capacity, maybe_out(run, &count)));
        break;
    case 10:
        SEEN(stickslip_tangential_solution_warnings(sheared, maybe_out(run, warnings), capacity, maybe_out(run, &count)));
        break;
    case 11:
        SEEN(stickslip_coupled_solution_warnings(both, maybe_out(run, warnings), capacity, maybe_out(run, &count)));
        break;
    case 12:
        SEEN(stickslip_history_warnings(history, maybe_out(run, warnings), capacity, maybe_out(run, &count)));
        break;
    case 13:
        SEEN(stickslip_history_stiffness(history, maybe_out(run, &stiffness)));
        break;
    case 14:
        SEEN(stickslip_normal_solution_stiffness(pressed, bodies, maybe_out(run, &slope)));
        break;
    case 15:
        SEEN(stickslip_tangential_solution_stiffness(sheared, bodies, maybe_out(run, &slopes)));
        break;
    case 16:
        SEEN(stickslip_history_grid(history, maybe_out(run, &grid)));
        break;
    case 17:
        SEEN(stickslip_half_space_grid(bodies, maybe_out(run, &grid)));
        SEEN(stickslip_half_space_pair(bodies, maybe_out(run, &pair)));
        break;
    case 18:
        SEEN(stickslip_history_friction_capacity(history, maybe_out(run, &value)));
        break;
    case 19:
        SEEN(stickslip_cycle_result_of(GET(stickslip_cycle, pick(run, CYCLE)), maybe_out(run, &cycle)));
        break;
    case 20:
        SEEN(stickslip_last_error(maybe_out(run, &error)));
        SEEN(stickslip_last_error_report(maybe_out(run, &report)));
        break;
    default:
        SEEN(stickslip_tangential_solver_friction_capacity(GET(stickslip_tangential_solver, pick(run, TANGENTIAL)),
                                                           maybe_out(run, &value)));
    }
}

static void solve(struct run *run) {
    size_t limit = below(run, 30);
    stickslip_observer observer = {watch, &limit};
    const stickslip_observer *watching = below(run, 4) == 0 ? maybe(run, &observer) : NULL;
    switch (below(run, 3)) {
    case 0:
        SEEN(stickslip_normal_solver_solve(GET(stickslip_normal_solver, pick(run, NORMAL)),
                                           GET(stickslip_normal_solution, pick(run, PRESSED)), watching));
        break;
    case 1:
        SEEN(stickslip_tangential_solver_solve(GET(stickslip_tangential_solver, pick(run, TANGENTIAL)),
                                               GET(stickslip_tangential_solution, pick(run, SHEARED)), watching));
        break;
    default:
        SEEN(stickslip_coupled_solver_solve(GET(stickslip_coupled_solver, pick(run, COUPLED)),
                                            GET(stickslip_coupled_solution, pick(run, BOTH)), watching));
    }
}

static void change_solver(struct run *run) {
    struct slot *normal = pick(run, NORMAL), *tangential = pick(run, TANGENTIAL), *coupled = pick(run, COUPLED);
    size_t count = coupled->cells == 0 ? 4 : coupled->cells;
    double *numbers = array(run, &count, 0.2);
    stickslip_friction law = friction(run, numbers, count);
    stickslip_settings set = settings(run);
    stickslip_normal_load press = normal_load(run);
    stickslip_tangential_load drag = tangential_load(run);
    stickslip_relative_displacement pattern = {numbers, numbers, count};
    stickslip_normal_solver *presser = GET(stickslip_normal_solver, normal);
    stickslip_tangential_solver *shearer = GET(stickslip_tangential_solver, tangential);
    stickslip_coupled_solver *solver = GET(stickslip_coupled_solver, coupled);
    switch (below(run, 17)) {
    case 0:
        SEEN(stickslip_normal_solver_set_load(presser, maybe(run, &press)));
        break;
    case 1:
        SEEN(stickslip_normal_solver_set_gap(presser, maybe(run, numbers), count));
        break;
    case 2:
        SEEN(stickslip_normal_solver_set_settings(presser, maybe(run, &set)));
        break;
    case 3:
        SEEN(stickslip_normal_solver_reset(presser));
        break;
    case 4:
        SEEN(stickslip_tangential_solver_set_load(shearer, maybe(run, &drag)));
        break;
    case 5:
        SEEN(stickslip_tangential_solver_set_friction(shearer, maybe(run, &law)));
        break;
    case 6:
        SEEN(stickslip_tangential_solver_set_normal(shearer, GET(stickslip_normal_solution, pick(run, PRESSED))));
        break;
    case 7:
        SEEN(stickslip_tangential_solver_set_pressure(shearer, maybe(run, numbers), count));
        break;
    case 8:
        SEEN(stickslip_tangential_solver_set_relative_displacement(shearer, maybe(run, &pattern)));
        break;
    case 9:
        SEEN(stickslip_tangential_solver_set_settings(shearer, maybe(run, &set)));
        break;
    case 10:
        SEEN(stickslip_tangential_solver_reset(shearer));
        break;
    case 11:
        SEEN(stickslip_coupled_solver_set_normal(solver, maybe(run, &press)));
        break;
    case 12:
        SEEN(stickslip_coupled_solver_set_load(solver, maybe(run, &drag)));
        break;
    case 13:
        SEEN(stickslip_coupled_solver_set_gap(solver, maybe(run, numbers), count));
        break;
    case 14:
        SEEN(stickslip_coupled_solver_set_friction(solver, maybe(run, &law)));
        break;
    case 15:
        SEEN(stickslip_coupled_solver_set_settings(solver, maybe(run, &set)));
        break;
    default:
        SEEN(stickslip_coupled_solver_reset(solver));
    }
    free(numbers);
}

static void rest(struct run *run) {
    stickslip_grid grid = {1 + below(run, 6), 1 + below(run, 6), number(run, 1.0), number(run, 1.0)};
    size_t count = grid.nx * grid.ny;
    enum kind kind = (enum kind)below(run, KINDS);
    struct slot *slot = &run->own.slots[kind][below(run, SLOTS)];
    double *gap = array(run, &count, 1.0);
    switch (below(run, 8)) {
    case 0:
        SEEN(stickslip_surface_sphere(maybe(run, &grid), number(run, 10.0), maybe_out(run, gap), count));
        break;
    case 1:
        SEEN(stickslip_surface_cylinder(maybe(run, &grid), number(run, 10.0), maybe_out(run, gap), count));
        break;
    case 2:
        SEEN(stickslip_surface_ellipsoid(maybe(run, &grid), number(run, 9.0), number(run, 3.0), maybe_out(run, gap), count));
        break;
    case 3:
        if (below(run, 50) == 0) {
            SEEN(stickslip_set_num_threads(rarely(run) ? SIZE_MAX : below(run, 4)));
        }
        break;
    case 4:
        if (below(run, 4) == 0) {
            SEEN(release[kind](slot->object));
            slot->object = NULL;
        }
        break;
    default:
        make_bodies(run);
    }
    free(gap);
}

static void one_call(struct run *run) {
    switch (below(run, 16)) {
    case 0:
        rest(run);
        break;
    case 1:
    case 2:
    case 3:
        make(run);
        break;
    case 4:
    case 5:
        change_solver(run);
        break;
    case 6:
    case 7:
        solve(run);
        break;
    case 8:
    case 9:
        step(run);
        break;
    case 10:
    case 11:
        change_history(run);
        break;
    case 12:
        field(run);
        break;
    default:
        read_numbers(run);
    }
}

static atomic_size_t left;

static void *thread(void *data) {
    struct run *run = data;
    size_t before = 0;
    for (;;) {
        size_t done = run->calls - before, now = atomic_load(&left);
        before = run->calls;
        while (!atomic_compare_exchange_weak(&left, &now, now > done ? now - done : 0)) {
        }
        if (now <= done) {
            return NULL;
        }
        one_call(run);
    }
}

static void release_all(struct world *world) {
    for (int kind = 0; kind < KINDS; kind++) {
        for (int i = 0; i < SLOTS; i++) {
            if (release[kind](world->slots[kind][i].object) != STICKSLIP_OK) {
                abort();
            }
        }
    }
}

int main(int argc, char **argv) {
    size_t calls = argc > 1 ? strtoul(argv[1], NULL, 10) : 20000;
    size_t threads = argc > 2 ? strtoul(argv[2], NULL, 10) : 3;
    uint64_t seed = argc > 3 ? strtoul(argv[3], NULL, 10) : 1;
    struct run *runs = calloc(threads + 1, sizeof *runs), *first = &runs[threads];
    struct world empty;
    memset(&empty, 0, sizeof empty);
    /* What threads share is made by one, and freed at the end. */
    first->shared = &empty;
    first->state = seed;
    while (first->calls < 1500) {
        one_call(first);
    }
    pthread_t *handles = calloc(threads, sizeof *handles);
    atomic_store(&left, calls > first->calls ? calls - first->calls : 1);
    for (size_t i = 0; i < threads; i++) {
        runs[i].shared = &first->own;
        runs[i].state = seed + 1000003 * (i + 1);
        if (pthread_create(&handles[i], NULL, thread, &runs[i]) != 0) {
            return 1;
        }
    }
    size_t done = 0, broken = 0, codes[CODES] = {0};
    for (size_t i = 0; i <= threads; i++) {
        if (i < threads) {
            pthread_join(handles[i], NULL);
        }
        done += runs[i].calls, broken += runs[i].broken;
        for (int code = 0; code < CODES; code++) {
            codes[code] += runs[i].codes[code];
        }
    }
    for (size_t i = 0; i <= threads; i++) {
        release_all(&runs[i].own);
    }
    stickslip_set_num_threads(0);
    free(handles), free(runs);
    printf("%zu calls on %zu threads, %zu broken promises; codes:", done, threads, broken);
    for (int code = 0; code < CODES; code++) {
        if (codes[code] > 0) {
            printf(" %d:%zu", code, codes[code]);
        }
    }
    printf("\n");
    return broken == 0 ? 0 : 1;
}
