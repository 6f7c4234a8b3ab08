/* Repeated calls allocate no more than in Rust. Steps, solves into a solution, gaps, pressures, friction, wear, planes below
 * the surface, and stiffnesses with a workspace allocate nothing. The test counts the allocations that pass through the
 * allocator of glibc. */

#define _GNU_SOURCE

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <stickslip.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *pointer, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

/* Allocations of this thread, which solves grids of this size. Threads of the pool are not counted, because they may start and
 * allocate late. */
static __thread size_t allocations = 0;

/* These functions replace those of the C library, also within the stickslip library. */
void *malloc(size_t size) {
    allocations++;
    return __libc_malloc(size);
}
void *calloc(size_t count, size_t size) {
    allocations++;
    return __libc_calloc(count, size);
}
void *realloc(void *pointer, size_t size) {
    allocations++;
    return __libc_realloc(pointer, size);
}
int posix_memalign(void **out, size_t alignment, size_t size) {
    allocations++;
    *out = __libc_memalign(alignment, size);
    return *out == NULL ? ENOMEM : 0;
}
void *aligned_alloc(size_t alignment, size_t size) {
    allocations++;
    return __libc_memalign(alignment, size);
}

static int failures = 0;

static void ok(stickslip_status status, int line) {
    if (status != STICKSLIP_OK) {
        fprintf(stderr, "line %d: %s\n", line, stickslip_last_error_message());
        failures++;
    }
}
#define OK(call) ok((call), __LINE__)

/* Requires at most this number of allocations in a hundred calls, after two calls that may allocate reusable memory. */
#define EXPECT(most, call)                                                                                             \
    do {                                                                                                               \
        OK(call);                                                                                                      \
        OK(call);                                                                                                      \
        size_t before = allocations;                                                                                   \
        for (int i = 0; i < 100; i++) {                                                                                \
            OK(call);                                                                                                  \
        }                                                                                                              \
        if (allocations - before > (most)) {                                                                           \
            fprintf(stderr, "line %d: %zu allocations, expected %d: %s\n", __LINE__, allocations - before, (most), #call); \
            failures++;                                                                                                \
        }                                                                                                              \
    } while (0)

#define N 32
#define CELLS (N * N)

static const stickslip_grid GRID = {N, N, 0.3e-3 / N, 0.3e-3 / N};
static const stickslip_material STEEL = {213e9, 0.29, 0.0}, RIGID = {INFINITY, 0.0, 0.0};
static const stickslip_normal_load PRESS = {STICKSLIP_FORCE, 100.0};
static const stickslip_tangential_load DRAG = {{STICKSLIP_FORCE, 20.0, 0.0}, {STICKSLIP_HOLD, 0.0, 0.0}, 0.0};
static double ball[CELLS], halves[CELLS], depth[CELLS];

static stickslip_friction per_cell(void) {
    stickslip_friction friction = stickslip_coulomb(0.5);
    friction.coefficient.cells = halves, friction.coefficient.count = CELLS;
    return friction;
}

static void histories(const stickslip_half_space *bodies) {
    stickslip_friction friction = stickslip_coulomb(0.5), cells = per_cell();
    stickslip_history *history = NULL;
    OK(stickslip_history_new(bodies, ball, CELLS, &friction, NULL, &history));
    stickslip_load_step load = {PRESS, {STICKSLIP_FORCE, 20.0, 0.0}, {0}, 0, 0.0, 0, 0.0};
    EXPECT(0, stickslip_history_step(history, &load, NULL));
    EXPECT(0, stickslip_history_set_gap(history, ball, CELLS));
    EXPECT(0, stickslip_history_set_friction(history, &friction));
    EXPECT(0, stickslip_history_set_friction(history, &cells));
    stickslip_per_cell uniform = {1e-14, NULL, 0}, alpha = {0.0, depth, CELLS};
    EXPECT(0, stickslip_wear_energy(history, &uniform, ball, CELLS));
    EXPECT(0, stickslip_wear_archard(history, &alpha, ball, CELLS));
    EXPECT(0, stickslip_wear_threshold_energy(history, &alpha, 0.0, ball, CELLS));
    stickslip_step_result result;
    EXPECT(0, stickslip_history_result(history, &result));
    stickslip_stiffness stiffness;
    stickslip_stiffness_options options = stickslip_stiffness_options_default();
    stickslip_stiffness_workspace *workspace = NULL;
    OK(stickslip_stiffness_workspace_new(&options, &workspace));
    EXPECT(0, stickslip_history_stiffness_with(history, workspace, NULL, &stiffness));
    EXPECT(0, stickslip_stiffness_workspace_set_options(workspace, &options));
    OK(stickslip_stiffness_workspace_free(workspace));
    OK(stickslip_history_free(history));
}

static void solvers(const stickslip_half_space *bodies) {
    stickslip_friction friction = stickslip_coulomb(0.5), cells = per_cell();
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_solution *pressed = NULL;
    OK(stickslip_normal_solver_new(bodies, ball, CELLS, &PRESS, NULL, NULL, &presser));
    OK(stickslip_normal_solution_new(presser, &pressed));
    EXPECT(0, stickslip_normal_solver_solve(presser, pressed, NULL));
    EXPECT(0, stickslip_normal_solver_set_gap(presser, ball, CELLS));
    stickslip_tangential_solver *shearer = NULL;
    stickslip_tangential_solution *sheared = NULL;
    OK(stickslip_tangential_solver_new(bodies, pressed, &friction, &DRAG, NULL, &shearer));
    OK(stickslip_tangential_solution_new(shearer, &sheared));
    EXPECT(0, stickslip_tangential_solver_solve(shearer, sheared, NULL));
    stickslip_rolling_solver *roller = NULL;
    stickslip_rolling_solution *rolled = NULL;
    stickslip_rolling_load creepage = {{STICKSLIP_CREEPAGE, 1e-4}, {0}, {0}};
    OK(stickslip_rolling_solver_new(bodies, pressed, &friction, NULL, NULL, &roller));
    OK(stickslip_rolling_solution_new(roller, &rolled));
    EXPECT(0, stickslip_rolling_solver_set_load(roller, &creepage));
    EXPECT(0, stickslip_rolling_solver_solve(roller, rolled, NULL));
    EXPECT(0, stickslip_rolling_solver_set_normal(roller, pressed));
    EXPECT(0, stickslip_rolling_solver_reset(roller));
    OK(stickslip_rolling_solver_free(roller));
    OK(stickslip_rolling_solution_free(rolled));
    size_t count = 0;
    const double *pressure = stickslip_normal_solution_field(pressed, STICKSLIP_PRESSURE, &count);
    EXPECT(0, stickslip_tangential_solver_set_pressure(shearer, pressure, count));
    EXPECT(0, stickslip_tangential_solver_set_friction(shearer, &cells));
    stickslip_tractions tractions = {pressure, pressure, pressure, count};
    stickslip_planes *planes = NULL;
    double below[] = {0.01e-3};
    OK(stickslip_planes_new(bodies, below, 1, 0, &planes));
    EXPECT(0, stickslip_planes_solve(planes, 0, STICKSLIP_BODY_1, &tractions));
    OK(stickslip_planes_free(planes));
    OK(stickslip_normal_solver_free(presser));
    OK(stickslip_normal_solution_free(pressed));
    OK(stickslip_tangential_solver_free(shearer));
    OK(stickslip_tangential_solution_free(sheared));
}

static void coupled(const stickslip_half_space *bodies) {
    stickslip_friction friction = stickslip_coulomb(0.5), cells = per_cell();
    stickslip_coupled_solver *solver = NULL;
    OK(stickslip_coupled_solver_new(bodies, ball, CELLS, &friction, &PRESS, &DRAG, NULL, NULL, NULL, &solver));
    EXPECT(0, stickslip_coupled_solver_set_gap(solver, ball, CELLS));
    EXPECT(0, stickslip_coupled_solver_set_friction(solver, &cells));
    OK(stickslip_coupled_solver_free(solver));
}

int main(void) {
    stickslip_half_space *steel = NULL, *dissimilar = NULL;
    OK(stickslip_half_space_new(&GRID, &STEEL, &STEEL, NULL, &steel));
    OK(stickslip_half_space_new(&GRID, &STEEL, &RIGID, NULL, &dissimilar));
    OK(stickslip_surface_sphere(&GRID, 3.5e-3, ball, CELLS));
    for (int i = 0; i < CELLS; i++) {
        halves[i] = 0.5;
    }
    size_t before = allocations;
    histories(steel);
    solvers(steel);
    coupled(dissimilar);
    if (allocations == before) {
        fprintf(stderr, "no allocations are counted\n");
        failures++;
    }
    OK(stickslip_half_space_free(steel));
    OK(stickslip_half_space_free(dissimilar));
    printf("%s\n", failures == 0 ? "no more allocations than in Rust" : "too many allocations");
    return failures == 0 ? 0 : 1;
}
