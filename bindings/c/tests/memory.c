/* A call that cannot allocate memory for its cells returns STICKSLIP_MEMORY and leaves its objects unchanged. The test
 * repeats every call below, and in each repetition the n-th large allocation and all later ones fail. An allocation is
 * large if its size depends on the number of cells; objects of a few kilobytes are not. An abort fails the test.
 *   memory        n spread over the allocations of each call
 *   memory all    every n, until no allocation is left to fail: minutes
 *
 * A second argument selects a single scene to run. */

#define _GNU_SOURCE

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <stickslip.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *pointer, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

/* Allocations of all threads fail from number `first` while `armed`, if they have at least `least` bytes or the size of the
 * tiles in which fields are transformed. */
#define TILE 2048
#define LEAST 8192
/* Size of a block of the queue of the thread pool, which holds 63 jobs. Without memory for it the pool ends the process. */
#define QUEUE_BLOCK 1520
static int armed = 0;
static size_t first = 0, least = 0, seen = 0;

static int fails(size_t size) {
    return __atomic_load_n(&armed, __ATOMIC_SEQ_CST) && (size >= least || size == TILE) && size != QUEUE_BLOCK
        && __atomic_fetch_add(&seen, 1, __ATOMIC_SEQ_CST) >= first;
}

/* These functions replace those of the C library, also within the stickslip library. */
void *malloc(size_t size) {
    return fails(size) ? NULL : __libc_malloc(size);
}
void *calloc(size_t count, size_t size) {
    return fails(count * size) ? NULL : __libc_calloc(count, size);
}
void *realloc(void *pointer, size_t size) {
    return fails(size) ? NULL : __libc_realloc(pointer, size);
}
int posix_memalign(void **out, size_t alignment, size_t size) {
    *out = fails(size) ? NULL : __libc_memalign(alignment, size);
    return *out == NULL ? ENOMEM : 0;
}
void *aligned_alloc(size_t alignment, size_t size) {
    return fails(size) ? NULL : __libc_memalign(alignment, size);
}

static int failures = 0;

static void expect(int holds, const char *what, int line) {
    if (!holds) {
        fprintf(stderr, "line %d: %s (last error: %s)\n", line, what, stickslip_last_error_message());
        failures++;
    }
}
#define EXPECT(condition) expect((condition), #condition, __LINE__)
#define OK(call) EXPECT((call) == STICKSLIP_OK)

/* Grid, gaps and bodies. */
#define MOST (65 * 64)
static size_t cells;
static stickslip_grid grid;
static double ball[MOST], halves[MOST], depth[MOST];
static stickslip_half_space *steel, *dissimilar;

static const stickslip_material STEEL = {213e9, 0.29, 0.0}, RIGID = {INFINITY, 0.0, 0.0};
static const stickslip_normal_load PRESS = {STICKSLIP_FORCE, 100.0};
static const stickslip_tangential_load DRAG = {{STICKSLIP_FORCE, 20.0, 0.0}, {STICKSLIP_HOLD, 0.0, 0.0}, 0.0};

static stickslip_load_step load(double normal, double shear) {
    stickslip_load_step load = {{STICKSLIP_FORCE, normal}, {STICKSLIP_FORCE, shear, 0.0}, {0}, 0, 0.0, 0, 0.0};
    return load;
}

static const char *name;

/* Number of attempts with failing memory, and number of attempts that returned STICKSLIP_MEMORY. */
static size_t attempts = 0, refused = 0;

/* Approximate largest number of attempts on each call. With `memory all` there is one attempt for every allocation. */
#define SAMPLES 24
static int is_complete = 0;
/* Only scene to run, or NULL for all scenes. */
static const char *chosen = NULL;

static void on_abort(int signal) {
    (void)signal;
    __atomic_store_n(&armed, 0, __ATOMIC_SEQ_CST);
    fprintf(stderr, "%s, %zu cells: the process ended when allocation %zu failed\n", name, cells, first);
    _exit(1);
}

static void arm(void) {
    seen = 0;
    __atomic_store_n(&armed, 1, __ATOMIC_SEQ_CST);
}
static stickslip_status disarmed(stickslip_status status) {
    __atomic_store_n(&armed, 0, __ATOMIC_SEQ_CST);
    return status;
}
#define ARMED(call) (arm(), disarmed(call))

/* Creates objects, makes a call while memory fails, and checks the objects afterwards. */
typedef stickslip_status scene(void);

static void run(const char *scene_name, scene *scene) {
    if (chosen != NULL && strcmp(chosen, scene_name) != 0) {
        return;
    }
    name = scene_name;
    /* The first run has no failure and counts the allocations. */
    first = SIZE_MAX;
    EXPECT(scene() == STICKSLIP_OK);
    size_t before = refused, tried = 0, all = seen, stride = is_complete || all < SAMPLES ? 1 : all / SAMPLES;
    for (first = 0;; first += stride) {
        stickslip_status status = scene();
        /* The loop ends, for any result of the call, when no allocation is left to fail. */
        if (seen <= first) {
            EXPECT(status == STICKSLIP_OK);
            break;
        }
        tried++;
        refused += status == STICKSLIP_MEMORY;
        if (status != STICKSLIP_MEMORY && status != STICKSLIP_OK) {
            fprintf(stderr, "%s, %zu cells, allocation %zu: status %d\n", name, cells, first, status);
            failures++;
        }
    }
    attempts += tried;
    printf("%s, %zu cells: %zu of %zu allocations failed, %zu calls refused\n", name, cells, tried, all, refused - before);
    fflush(stdout);
}

/* Returns the bytes of a history. The caller frees them. */
static uint8_t *bytes_of(const stickslip_history *history, size_t *length) {
    OK(stickslip_history_to_bytes(history, NULL, 0, length));
    uint8_t *bytes = __libc_malloc(*length);
    OK(stickslip_history_to_bytes(history, bytes, *length, length));
    return bytes;
}
static int is_same(const stickslip_history *history, const uint8_t *bytes, size_t length) {
    size_t found = 0;
    uint8_t *own = bytes_of(history, &found);
    int same = found == length && memcmp(own, bytes, length) == 0;
    free(own);
    return same;
}

static stickslip_history *made(const stickslip_half_space *bodies, int steps, double normal, double shear) {
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_history *history = NULL;
    OK(stickslip_history_new(bodies, ball, cells, &friction, NULL, &history));
    stickslip_load_step step = load(normal, shear);
    for (int i = 0; i < steps; i++) {
        OK(stickslip_history_step(history, &step, NULL));
    }
    return history;
}

/* A failed step leaves its history unchanged; the step taken afterwards is bitwise identical to a step without a failure.
 * (A step that succeeds while memory fails may have omitted the products in single precision: its result is correct but not
 * bitwise identical.) */
static stickslip_status step_from(stickslip_history *history, stickslip_load_step step, const stickslip_half_space *bodies) {
    size_t length = 0;
    uint8_t *before = bytes_of(history, &length);
    stickslip_history *twin = NULL;
    OK(stickslip_history_from_bytes(bodies, before, length, &twin));
    stickslip_status status = ARMED(stickslip_history_step(history, &step, NULL));
    if (status != STICKSLIP_OK) {
        EXPECT(is_same(history, before, length));
        OK(stickslip_history_step(history, &step, NULL));
        OK(stickslip_history_step(twin, &step, NULL));
        free(before);
        before = bytes_of(twin, &length);
        EXPECT(is_same(history, before, length));
    }
    free(before);
    OK(stickslip_history_free(twin));
    OK(stickslip_history_free(history));
    return status;
}

static stickslip_status new_bodies(void) {
    stickslip_half_space *bodies = NULL;
    stickslip_status status = ARMED(stickslip_half_space_new(&grid, &STEEL, &STEEL, NULL, &bodies));
    EXPECT((status == STICKSLIP_OK) == (bodies != NULL));
    OK(stickslip_half_space_free(bodies));
    return status;
}

static stickslip_status press_on(const stickslip_half_space *bodies) {
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_solution *pressed = NULL;
    arm();
    stickslip_status status = stickslip_normal_solver_new(bodies, ball, cells, &PRESS, NULL, NULL, &presser);
    if (status == STICKSLIP_OK) {
        status = stickslip_normal_solution_new(presser, &pressed);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_normal_solver_solve(presser, pressed, NULL);
    }
    disarmed(status);
    if (pressed != NULL) {
        OK(stickslip_normal_solver_solve(presser, pressed, NULL));
    }
    OK(stickslip_normal_solver_free(presser));
    OK(stickslip_normal_solution_free(pressed));
    return status;
}

/* Normal contacts of bodies with and without existing operators. */
static stickslip_status first_press(void) {
    stickslip_half_space *bodies = NULL;
    OK(stickslip_half_space_new(&grid, &STEEL, &STEEL, NULL, &bodies));
    stickslip_status status = press_on(bodies);
    OK(stickslip_half_space_free(bodies));
    return status;
}
static stickslip_status press(void) {
    return press_on(steel);
}

static stickslip_status shear(void) {
    stickslip_friction friction = stickslip_coulomb(0.5), per_cell = friction;
    per_cell.coefficient.cells = halves, per_cell.coefficient.count = cells;
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_solution *pressed = NULL;
    OK(stickslip_normal_solver_new(steel, ball, cells, &PRESS, NULL, NULL, &presser));
    OK(stickslip_normal_solution_new(presser, &pressed));
    OK(stickslip_normal_solver_solve(presser, pressed, NULL));
    stickslip_tangential_solver *shearer = NULL;
    stickslip_tangential_solution *sheared = NULL;
    arm();
    stickslip_status status = stickslip_tangential_solver_new(steel, pressed, &friction, &DRAG, NULL, &shearer);
    if (status == STICKSLIP_OK) {
        status = stickslip_tangential_solver_set_friction(shearer, &per_cell);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_tangential_solution_new(shearer, &sheared);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_tangential_solver_solve(shearer, sheared, NULL);
    }
    disarmed(status);
    OK(stickslip_tangential_solver_free(shearer));
    OK(stickslip_tangential_solution_free(sheared));
    OK(stickslip_normal_solver_free(presser));
    OK(stickslip_normal_solution_free(pressed));
    return status;
}

static stickslip_status roll(void) {
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_rolling_load creepage = {{STICKSLIP_CREEPAGE, 1e-3}, {0}, {0}};
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_solution *pressed = NULL;
    stickslip_rolling_solver *solver = NULL;
    stickslip_rolling_solution *solution = NULL;
    stickslip_rolling_stiffness stiffness;
    static double lost[MOST];
    OK(stickslip_normal_solver_new(steel, ball, cells, &PRESS, NULL, NULL, &presser));
    OK(stickslip_normal_solution_new(presser, &pressed));
    OK(stickslip_normal_solver_solve(presser, pressed, NULL));
    arm();
    stickslip_status status = stickslip_rolling_solver_new(steel, pressed, &friction, &creepage, NULL, &solver);
    if (status == STICKSLIP_OK) {
        status = stickslip_rolling_solution_new(solver, &solution);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_rolling_solver_solve(solver, solution, NULL);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_rolling_solver_stiffness(solver, &stiffness);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_rolling_solution_dissipation_per_area(solution, lost, cells);
    }
    disarmed(status);
    OK(stickslip_rolling_solver_free(solver));
    OK(stickslip_rolling_solution_free(solution));
    OK(stickslip_normal_solver_free(presser));
    OK(stickslip_normal_solution_free(pressed));
    return status;
}

/* Edges of a pressed and sheared contact, and the estimates of its errors. */
static stickslip_status edges(void) {
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_solution *pressed = NULL;
    stickslip_tangential_solver *shearer = NULL;
    stickslip_tangential_solution *sheared = NULL;
    OK(stickslip_normal_solver_new(steel, ball, cells, &PRESS, NULL, NULL, &presser));
    OK(stickslip_normal_solution_new(presser, &pressed));
    OK(stickslip_normal_solver_solve(presser, pressed, NULL));
    OK(stickslip_tangential_solver_new(steel, pressed, &friction, &DRAG, NULL, &shearer));
    OK(stickslip_tangential_solution_new(shearer, &sheared));
    OK(stickslip_tangential_solver_solve(shearer, sheared, NULL));
    stickslip_edges contact = {0}, both = {0};
    double of_pressure = 0.0, of_traction = 0.0;
    arm();
    stickslip_status status = stickslip_normal_solution_edges(pressed, &contact, depth, NULL, cells);
    if (status == STICKSLIP_OK) {
        status = stickslip_tangential_solution_edges(sheared, pressed, &friction, &both, depth, NULL, cells);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_normal_solution_discretisation_estimate(pressed, &of_pressure);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_tangential_solution_discretisation_estimate(sheared, &of_traction);
    }
    disarmed(status);
    /* A call writes all numbers or none. */
    EXPECT(status != STICKSLIP_OK || (both.contact_area == contact.contact_area && of_pressure > 0.0 && of_traction > 0.0));
    EXPECT(status != STICKSLIP_MEMORY || both.contact_area == 0.0);
    OK(stickslip_tangential_solver_free(shearer));
    OK(stickslip_tangential_solution_free(sheared));
    OK(stickslip_normal_solver_free(presser));
    OK(stickslip_normal_solution_free(pressed));
    return status;
}

static stickslip_status press_and_shear_coupled(void) {
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_coupled_solver *solver = NULL;
    stickslip_coupled_solution *solution = NULL;
    arm();
    stickslip_status status =
        stickslip_coupled_solver_new(dissimilar, ball, cells, &friction, &PRESS, &DRAG, NULL, NULL, NULL, &solver);
    if (status == STICKSLIP_OK) {
        status = stickslip_coupled_solution_new(solver, &solution);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_coupled_solver_solve(solver, solution, NULL);
    }
    disarmed(status);
    OK(stickslip_coupled_solver_free(solver));
    OK(stickslip_coupled_solution_free(solution));
    return status;
}

static stickslip_status new_history(void) {
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_history *history = NULL;
    stickslip_status status = ARMED(stickslip_history_new(steel, ball, cells, &friction, NULL, &history));
    OK(stickslip_history_free(history));
    return status;
}
static stickslip_status first_step(void) {
    return step_from(made(steel, 0, 0.0, 0.0), load(100.0, 10.0), steel);
}
static stickslip_status growing_step(void) {
    return step_from(made(steel, 2, 10.0, 1.0), load(200.0, 20.0), steel);
}
static stickslip_status shrinking_step(void) {
    return step_from(made(steel, 2, 200.0, 20.0), load(10.0, 1.0), steel);
}
static stickslip_status first_coupled_step(void) {
    return step_from(made(dissimilar, 0, 0.0, 0.0), load(100.0, 10.0), dissimilar);
}
static stickslip_status growing_coupled_step(void) {
    return step_from(made(dissimilar, 1, 10.0, 1.0), load(200.0, 20.0), dissimilar);
}

/* A copy is complete, or it does not exist. */
static stickslip_status clone_of(stickslip_history *history) {
    size_t length = 0;
    uint8_t *bytes = bytes_of(history, &length);
    stickslip_history *copy = NULL;
    stickslip_status status = ARMED(stickslip_history_clone(history, &copy));
    EXPECT((status == STICKSLIP_OK) == (copy != NULL));
    if (copy != NULL) {
        EXPECT(is_same(copy, bytes, length));
    }
    EXPECT(is_same(history, bytes, length));
    free(bytes);
    OK(stickslip_history_free(copy));
    OK(stickslip_history_free(history));
    return status;
}
static stickslip_status clone(void) {
    return clone_of(made(steel, 2, 100.0, 10.0));
}
static stickslip_status clone_coupled(void) {
    return clone_of(made(dissimilar, 1, 100.0, 10.0));
}

static stickslip_status keep_states(void) {
    stickslip_history *history = made(steel, 1, 10.0, 1.0), *other = made(steel, 2, 200.0, 20.0);
    size_t length = 0;
    uint8_t *before = bytes_of(other, &length);
    stickslip_state *state = NULL;
    arm();
    stickslip_status status = stickslip_state_new(history, &state);
    if (status == STICKSLIP_OK) {
        status = stickslip_history_set_state(other, state);
    }
    disarmed(status);
    if (status != STICKSLIP_OK) {
        EXPECT(is_same(other, before, length));
    } else {
        stickslip_load_step step = load(150.0, 10.0);
        OK(stickslip_history_step(history, &step, NULL));
        status = ARMED(stickslip_state_keep(state, history));
    }
    free(before);
    OK(stickslip_state_free(state));
    OK(stickslip_history_free(history));
    OK(stickslip_history_free(other));
    return status;
}

static stickslip_status save_and_load(void) {
    stickslip_history *history = made(steel, 2, 100.0, 10.0), *loaded = NULL;
    size_t length = 0, found = 0;
    uint8_t *bytes = bytes_of(history, &length);
    arm();
    stickslip_status status = stickslip_history_to_bytes(history, NULL, 0, &found);
    if (status == STICKSLIP_OK) {
        status = stickslip_history_from_bytes(steel, bytes, length, &loaded);
    }
    disarmed(status);
    free(bytes);
    OK(stickslip_history_free(history));
    OK(stickslip_history_free(loaded));
    return status;
}

static stickslip_status stiffness(void) {
    stickslip_history *history = made(steel, 1, 100.0, 10.0);
    stickslip_stiffness found;
    stickslip_status status = ARMED(stickslip_history_stiffness(history, &found));
    OK(stickslip_history_free(history));
    return status;
}

static stickslip_status coupled_stiffness(void) {
    stickslip_history *history = made(dissimilar, 1, 100.0, 10.0);
    stickslip_stiffness found;
    stickslip_status status = ARMED(stickslip_history_stiffness(history, &found));
    OK(stickslip_history_free(history));
    return status;
}
/* The operators of these bodies do not exist yet. */
static stickslip_status coupled_solution_stiffness(void) {
    stickslip_friction friction = stickslip_coulomb(0.5), per_cell = friction;
    per_cell.coefficient.cells = halves, per_cell.coefficient.count = cells;
    stickslip_coupled_solver *solver = NULL;
    stickslip_coupled_solution *solution = NULL;
    OK(stickslip_coupled_solver_new(dissimilar, ball, cells, &friction, &PRESS, &DRAG, NULL, NULL, NULL, &solver));
    OK(stickslip_coupled_solution_new(solver, &solution));
    OK(stickslip_coupled_solver_solve(solver, solution, NULL));
    stickslip_half_space *bodies = NULL;
    stickslip_stiffness found;
    OK(stickslip_half_space_new(&grid, &STEEL, &RIGID, NULL, &bodies));
    stickslip_status status = ARMED(stickslip_coupled_solution_stiffness(solution, bodies, &per_cell, &found));
    OK(stickslip_half_space_free(bodies));
    OK(stickslip_coupled_solver_free(solver));
    OK(stickslip_coupled_solution_free(solution));
    return status;
}

static stickslip_status wear(void) {
    stickslip_history *history = made(steel, 1, 100.0, 10.0);
    stickslip_per_cell uniform = {1e-14, NULL, 0};
    stickslip_load_step step = load(100.0, -10.0);
    stickslip_friction per_cell = stickslip_coulomb(0.5);
    per_cell.coefficient.cells = halves, per_cell.coefficient.count = cells;
    memset(depth, 0, sizeof depth);
    arm();
    stickslip_status status = stickslip_wear_energy(history, &uniform, depth, cells);
    if (status == STICKSLIP_OK) {
        status = stickslip_history_set_gap(history, ball, cells);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_history_set_friction(history, &per_cell);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_history_step(history, &step, NULL);
    }
    disarmed(status);
    OK(stickslip_history_free(history));
    return status;
}

static stickslip_status adaptive_steps(void) {
    stickslip_history *history = made(steel, 1, 50.0, 0.0);
    size_t length = 0, taken = 0;
    uint8_t *before = bytes_of(history, &length);
    stickslip_adaptive_steps *steps = NULL;
    stickslip_load_step step = load(150.0, 20.0);
    arm();
    stickslip_status status = stickslip_adaptive_steps_new(history, 0.05, &steps);
    if (status == STICKSLIP_OK) {
        status = stickslip_adaptive_steps_step(steps, history, &step, &taken);
    }
    disarmed(status);
    if (status != STICKSLIP_OK) {
        EXPECT(is_same(history, before, length));
    }
    free(before);
    OK(stickslip_adaptive_steps_free(steps));
    OK(stickslip_history_free(history));
    return status;
}

static stickslip_status cycle(void) {
    stickslip_history *history = made(steel, 1, 50.0, 0.0);
    stickslip_cycle *cycle = NULL;
    stickslip_status status = ARMED(stickslip_cycle_new(history, &cycle));
    OK(stickslip_cycle_free(cycle));
    OK(stickslip_history_free(history));
    return status;
}

static stickslip_status stresses(void) {
    double below[] = {1e-5, 2e-5};
    stickslip_tractions tractions = {halves, halves, halves, cells};
    stickslip_planes *planes = NULL;
    double *measures = __libc_malloc(cells * sizeof(double));
    stickslip_point point = {0.0, 0.0, 1e-5};
    stickslip_response response;
    arm();
    stickslip_status status = stickslip_planes_new(steel, below, 2, 1, &planes);
    if (status == STICKSLIP_OK) {
        status = stickslip_planes_solve(planes, 1, STICKSLIP_BODY_1, &tractions);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_planes_measure(planes, STICKSLIP_VON_MISES, measures, cells);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_stress_at_points(steel, STICKSLIP_BODY_1, &tractions, &point, 1, &response);
    }
    disarmed(status);
    free(measures);
    OK(stickslip_planes_free(planes));
    return status;
}

static stickslip_status shape(void) {
    return ARMED(stickslip_surface_sphere(&grid, 3.5e-3, ball, cells));
}

/* Lists of warnings and spots, whose length depends on the contact. */
static stickslip_status lists(void) {
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_solution *pressed = NULL;
    OK(stickslip_normal_solver_new(steel, ball, cells, &PRESS, NULL, NULL, &presser));
    OK(stickslip_normal_solution_new(presser, &pressed));
    OK(stickslip_normal_solver_solve(presser, pressed, NULL));
    stickslip_tangential_solver *shearer = NULL;
    stickslip_tangential_solution *sheared = NULL;
    OK(stickslip_tangential_solver_new(steel, pressed, &friction, &DRAG, NULL, &shearer));
    OK(stickslip_tangential_solution_new(shearer, &sheared));
    OK(stickslip_tangential_solver_solve(shearer, sheared, NULL));
    stickslip_history *history = made(steel, 1, 100.0, 10.0);
    size_t count = 0;
    least = 1024;
    arm();
    stickslip_status status = stickslip_normal_solution_warnings(pressed, NULL, 0, &count);
    if (status == STICKSLIP_OK) {
        status = stickslip_tangential_solution_warnings(sheared, NULL, 0, &count);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_history_warnings(history, NULL, 0, &count);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_normal_solution_spots(pressed, NULL, 0, &count, NULL, 0);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_tangential_solution_spots(sheared, pressed, NULL, 0, &count, NULL, 0);
    }
    if (status == STICKSLIP_OK) {
        status = stickslip_history_spots(history, NULL, 0, &count, NULL, 0);
    }
    disarmed(status);
    least = LEAST;
    OK(stickslip_history_free(history));
    OK(stickslip_tangential_solver_free(shearer));
    OK(stickslip_tangential_solution_free(sheared));
    OK(stickslip_normal_solver_free(presser));
    OK(stickslip_normal_solution_free(pressed));
    return status;
}

/* Runs all scenes on a grid with the given number of cells. */
static void scenes(size_t nx, size_t ny) {
    cells = nx * ny, least = LEAST;
    stickslip_grid made_of = {nx, ny, 0.3e-3 / (double)nx, 0.3e-3 / (double)nx};
    grid = made_of;
    OK(stickslip_half_space_new(&grid, &STEEL, &STEEL, NULL, &steel));
    OK(stickslip_half_space_new(&grid, &STEEL, &RIGID, NULL, &dissimilar));
    OK(stickslip_surface_sphere(&grid, 3.5e-3, ball, cells));
    run("bodies", new_bodies);
    run("first normal contact", first_press);
    run("normal contact", press);
    run("tangential contact", shear);
    run("rolling contact", roll);
    run("edges", edges);
    run("coupled contact", press_and_shear_coupled);
    run("history", new_history);
    run("first step", first_step);
    run("growing step", growing_step);
    run("shrinking step", shrinking_step);
    run("first coupled step", first_coupled_step);
    run("growing coupled step", growing_coupled_step);
    run("clone", clone);
    run("clone of a coupled history", clone_coupled);
    run("states", keep_states);
    run("bytes", save_and_load);
    run("stiffness", stiffness);
    run("coupled stiffness", coupled_stiffness);
    run("stiffness of a coupled solution", coupled_solution_stiffness);
    run("wear", wear);
    run("adaptive steps", adaptive_steps);
    run("cycle", cycle);
    run("stresses", stresses);
    run("shape", shape);
    run("warnings and spots", lists);
    OK(stickslip_half_space_free(steel));
    OK(stickslip_half_space_free(dissimilar));
}

int main(int count, char **arguments) {
    is_complete = count > 1 && strcmp(arguments[1], "all") == 0;
    chosen = count > 2 ? arguments[2] : NULL;
    signal(SIGABRT, on_abort);
    for (size_t i = 0; i < MOST; i++) {
        halves[i] = 0.5;
    }
    /* The small grid is solved on the calling thread, and the large grid on the threads of the pool. */
    scenes(48, 48);
    scenes(65, 64);
    printf("%zu allocations failed, %zu calls returned an error, the process never ended\n", attempts, refused);
    EXPECT(chosen != NULL || refused > 300);
    return failures == 0 ? 0 : 1;
}
