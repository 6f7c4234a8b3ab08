/* Guarantees of the header: codes instead of crashes, unchanged state after a failure, fields without a copy, bitwise
 * identical snapshots, batches, exclusive access. */

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

#define N 16
#define CELLS (N * N)

static const stickslip_grid GRID = {N, N, 0.3e-3 / N, 0.3e-3 / N};
static const stickslip_material STEEL = {213e9, 0.29, 0.0};
static double ball[CELLS];

static void *misaligned(void *pointer) { return (char *)pointer + 1; }

static stickslip_half_space *make_bodies(void) {
    stickslip_half_space *bodies = NULL;
    OK(stickslip_half_space_new(&GRID, &STEEL, &STEEL, NULL, &bodies));
    return bodies;
}

static stickslip_history *make_history(const stickslip_half_space *bodies) {
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_history *history = NULL;
    OK(stickslip_history_new(bodies, ball, CELLS, &friction, NULL, &history));
    return history;
}

static stickslip_load_step press(double force) {
    stickslip_load_step load = {{STICKSLIP_FORCE, force}, {0}, {0}, 0, 0.0, 0, 0.0};
    return load;
}

static stickslip_load_step drag(double force) {
    stickslip_load_step load = {{0}, {STICKSLIP_FORCE, force, 0.0}, {0}, 0, 0.0, 0, 0.0};
    return load;
}

/* A hard layer reduces the contact area and the approach. */
static void layers_are_felt(void) {
    stickslip_layer oxide = {380e9, 0.22, 5e-6};
    stickslip_half_space *bodies[2] = {make_bodies(), NULL};
    OK(stickslip_half_space_new_coated(&GRID, &STEEL, &oxide, 1, &STEEL, NULL, 0, NULL, &bodies[1]));
    stickslip_normal_load load = {STICKSLIP_FORCE, 10.0};
    stickslip_normal_result found[2];
    for (int i = 0; i < 2; i++) {
        stickslip_normal_solver *solver = NULL;
        stickslip_normal_solution *solution = NULL;
        OK(stickslip_normal_solver_new(bodies[i], ball, CELLS, &load, NULL, NULL, &solver));
        OK(stickslip_normal_solution_new(solver, &solution));
        OK(stickslip_normal_solver_solve(solver, solution, NULL));
        OK(stickslip_normal_solution_result(solution, &found[i]));
        OK(stickslip_normal_solution_free(solution));
        OK(stickslip_normal_solver_free(solver));
        OK(stickslip_half_space_free(bodies[i]));
    }
    CHECK(found[1].approach < found[0].approach && found[1].approach > 0.5 * found[0].approach);
}

/* A report states whether its certificate relies on an estimate. */
static void a_report_tells_how_the_least_eigenvalue_is_known(void) {
    enum { NX = 24, NY = 20 };
    stickslip_grid grid = {NX, NY, 2.0, 2.0};
    stickslip_material soft = {2.6, 0.3, 0.0}, rigid = {INFINITY, 0.0, 0.0};
    stickslip_layer stiff = {2600.0, 0.3, 1.0};
    static double gap[NX * NY];
    OK(stickslip_surface_sphere(&grid, 50.0, gap, NX * NY));
    for (size_t layers = 0; layers < 2; layers++) {
        stickslip_half_space *bodies = NULL;
        stickslip_normal_solver *solver = NULL;
        stickslip_normal_solution *solution = NULL;
        stickslip_normal_load load = {STICKSLIP_APPROACH, 0.05};
        stickslip_report report;
        OK(stickslip_half_space_new_coated(&grid, &soft, &stiff, layers, &rigid, NULL, 0, NULL, &bodies));
        OK(stickslip_normal_solver_new(bodies, gap, NX * NY, &load, NULL, NULL, &solver));
        OK(stickslip_normal_solution_new(solver, &solution));
        OK(stickslip_normal_solution_report(solution, &report));
        CHECK(report.status == STICKSLIP_UNSOLVED && report.eigenvalue_bound == STICKSLIP_EIGENVALUE_UNKNOWN);
        OK(stickslip_normal_solver_solve(solver, solution, NULL));
        OK(stickslip_normal_solution_report(solution, &report));
        CHECK(report.status == STICKSLIP_CONVERGED);
        CHECK(report.eigenvalue_bound == (layers == 0 ? STICKSLIP_EIGENVALUE_PROVEN : STICKSLIP_EIGENVALUE_ESTIMATED));
        OK(stickslip_normal_solution_free(solution));
        OK(stickslip_normal_solver_free(solver));
        OK(stickslip_half_space_free(bodies));
    }
}

static void bad_input_is_refused(void) {
    stickslip_half_space *bodies = make_bodies(), *none = NULL;
    stickslip_grid grid = GRID;
    stickslip_error error;
    grid.nx = 0;
    CHECK(stickslip_half_space_new(&grid, &STEEL, &STEEL, NULL, &none) == STICKSLIP_GRID_SIZE && none == NULL);
    grid.nx = SIZE_MAX, grid.ny = SIZE_MAX;
    CHECK(stickslip_half_space_new(&grid, &STEEL, &STEEL, NULL, &none) == STICKSLIP_MEMORY && none == NULL);
    grid = GRID, grid.dx = NAN;
    CHECK(stickslip_half_space_new(&grid, &STEEL, &STEEL, NULL, &none) == STICKSLIP_NOT_POSITIVE);
    CHECK(stickslip_half_space_new(NULL, &STEEL, &STEEL, NULL, &none) == STICKSLIP_BAD_POINTER);
    CHECK(stickslip_half_space_new(&GRID, &STEEL, &STEEL, NULL, NULL) == STICKSLIP_BAD_POINTER);
    stickslip_material odd = {213e9, 0.7, 0.0}, rigid = {INFINITY, 0.0, 0.0}, soft = {1e-300, 0.3, 0.0};
    CHECK(stickslip_half_space_new(&GRID, &soft, &soft, NULL, &none) == STICKSLIP_EXTREME_NUMBER);
    CHECK(stickslip_half_space_new(&GRID, &odd, &STEEL, NULL, &none) == STICKSLIP_POISSON_RATIO);
    OK(stickslip_last_error(&error));
    CHECK(error.value == 0.7);
    CHECK(strstr(stickslip_last_error_message(), "0.7") != NULL);
    // A message pointer that was read before a failure refers to the message of that failure.
    const char *message = stickslip_last_error_message();
    odd.poisson_ratio = 0.8;
    CHECK(stickslip_half_space_new(&GRID, &odd, &STEEL, NULL, &none) == STICKSLIP_POISSON_RATIO);
    CHECK(strstr(message, "0.8") != NULL && message == stickslip_last_error_message());
    CHECK(stickslip_half_space_new(&GRID, &rigid, &rigid, NULL, &none) == STICKSLIP_BOTH_RIGID);
    stickslip_layer oxide = {380e9, 0.22, 5e-6}, many[9], thin = {380e9, 0.22, 0.0};
    for (int i = 0; i < 9; i++) {
        many[i] = oxide;
    }
    CHECK(stickslip_half_space_new_coated(&GRID, &STEEL, many, 9, &STEEL, NULL, 0, NULL, &none) == STICKSLIP_INVALID_ARGUMENT);
    CHECK(stickslip_half_space_new_coated(&GRID, &STEEL, &thin, 1, &STEEL, NULL, 0, NULL, &none) == STICKSLIP_NOT_POSITIVE);
    CHECK(stickslip_half_space_new_coated(&GRID, &STEEL, NULL, 1, &STEEL, NULL, 0, NULL, &none) == STICKSLIP_BAD_POINTER);
    CHECK(none == NULL);
    stickslip_boundary boundary = {7, 0.0};
    CHECK(stickslip_half_space_new(&GRID, &STEEL, &STEEL, &boundary, &none) == STICKSLIP_UNKNOWN_OPTION);
    int32_t value = -1;
    CHECK(stickslip_half_space_set_cell_value(bodies, 7) == STICKSLIP_UNKNOWN_OPTION);
    OK(stickslip_half_space_set_cell_value(bodies, STICKSLIP_CENTRE));
    OK(stickslip_half_space_cell_value(bodies, &value));
    CHECK(value == STICKSLIP_CENTRE);
    OK(stickslip_half_space_set_cell_value(bodies, STICKSLIP_UNIFORM));

    stickslip_normal_load load = {STICKSLIP_FORCE, 10.0}, nan_load = {STICKSLIP_FORCE, NAN};
    stickslip_normal_solver *solver = NULL;
    CHECK(stickslip_normal_solver_new(bodies, ball, CELLS - 1, &load, NULL, NULL, &solver) == STICKSLIP_LENGTH);
    OK(stickslip_last_error(&error));
    CHECK(error.expected == CELLS && error.found == CELLS - 1);
    /* The output of a failed call can be freed. */
    solver = misaligned(&solver);
    CHECK(stickslip_normal_solver_new(bodies, NULL, CELLS, &load, NULL, NULL, &solver) == STICKSLIP_BAD_POINTER);
    CHECK(solver == NULL);
    CHECK(stickslip_set_num_threads(1025) == STICKSLIP_NO_THREADS);
    CHECK(stickslip_normal_solver_new(bodies, ball, CELLS, &nan_load, NULL, NULL, &solver) == STICKSLIP_NEGATIVE_OR_NOT_FINITE);
    stickslip_normal_load shift_load = {STICKSLIP_SHIFT, 1e-6}, hold = {STICKSLIP_HOLD, 0.0};
    CHECK(stickslip_normal_solver_new(bodies, ball, CELLS, &shift_load, NULL, NULL, &solver) == STICKSLIP_UNKNOWN_OPTION);
    CHECK(strcmp(stickslip_last_error_message(), "the value 3 is not a valid kind of normal load: use STICKSLIP_HOLD, "
                                                 "STICKSLIP_FORCE or STICKSLIP_APPROACH") == 0);
    CHECK(stickslip_normal_solver_new(bodies, ball, CELLS, &hold, NULL, NULL, &solver) == STICKSLIP_NO_PRESSURE_TO_HOLD);
    CHECK(strstr(stickslip_last_error_message(), "only a history has one: prescribe a normal force") != NULL);
    double holed[CELLS];
    memcpy(holed, ball, sizeof holed);
    holed[37] = NAN;
    CHECK(stickslip_normal_solver_new(bodies, holed, CELLS, &load, NULL, NULL, &solver) == STICKSLIP_SAMPLE);
    OK(stickslip_last_error(&error));
    CHECK(error.index == 37 && isnan(error.value));
    CHECK(solver == NULL);
    CHECK(stickslip_normal_solver_new((const stickslip_half_space *)((const char *)bodies + 1), ball, CELLS, &load, NULL,
                                      NULL, &solver) == STICKSLIP_BAD_POINTER);
    OK(stickslip_half_space_free(bodies));
    OK(stickslip_half_space_free(NULL));
}

/* Cancels the solve after calls that an observer must not make. */
static int32_t cancel(const stickslip_iteration *iteration, void *user) {
    stickslip_history *history = user;
    stickslip_step_result result;
    CHECK(isfinite(iteration->residual) || iteration->iteration == 0);
    /* Two attempts: a rejected call must not release the handle for the next call. */
    for (int i = 0; i < 2; i++) {
        CHECK(stickslip_history_result(history, &result) == STICKSLIP_BUSY);
        CHECK(strstr(stickslip_last_error_message(), "or by the call that made this call: wait until that call") != NULL);
        CHECK(stickslip_history_free(history) == STICKSLIP_BUSY);
    }
    return 0;
}

static void failed_steps_leave_no_trace(void) {
    stickslip_half_space *bodies = make_bodies();
    stickslip_history *history = make_history(bodies);
    stickslip_load_step load = press(100.0);
    OK(stickslip_history_step(history, &load, NULL));
    size_t length = 0, again = 0;
    OK(stickslip_history_to_bytes(history, NULL, 0, &length));
    uint8_t *before = malloc(length), *after = malloc(length);
    OK(stickslip_history_to_bytes(history, before, length, &length));
    CHECK(stickslip_history_to_bytes(history, after, length - 1, &again) == STICKSLIP_BUFFER_TOO_SMALL && again == length);

    stickslip_error error;
    load = drag(60.0);
    CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_BEYOND_FRICTION_CAPACITY);
    OK(stickslip_last_error(&error));
    CHECK(error.value == 60.0 && fabs(error.limit - 50.0) < 1e-9);
    stickslip_report report;
    CHECK(stickslip_last_error_report(&report) == STICKSLIP_INVALID_ARGUMENT);
    load = drag(NAN);
    CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_NOT_FINITE);
    load = drag(1.0), load.y.kind = STICKSLIP_FORCE, load.y.value = 1.0;
    CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_UNSUPPORTED_BY_MODEL);
    load = press(120.0);
    stickslip_observer observer = {cancel, history};
    CHECK(stickslip_history_step(history, &load, &observer) == STICKSLIP_NOT_CONVERGED);
    OK(stickslip_last_error_report(&report));
    CHECK(report.status == STICKSLIP_CANCELLED);
    CHECK(stickslip_history_set_gap(history, ball, 3) == STICKSLIP_LENGTH);
    OK(stickslip_history_to_bytes(history, after, length, &again));
    CHECK(again == length && memcmp(before, after, length) == 0);

    /* If an output pointer is NULL or misaligned, nothing is written and the history is unchanged. */
    stickslip_adaptive_steps *steps = NULL;
    OK(stickslip_adaptive_steps_new(history, 0.01, &steps));
    size_t taken[2] = {77, 77};
    load = drag(10.0);
    CHECK(stickslip_adaptive_steps_step(steps, history, &load, misaligned(taken)) == STICKSLIP_BAD_POINTER);
    OK(stickslip_adaptive_steps_free(steps));
    stickslip_report reports[2];
    reports[0].status = 77;
    CHECK(stickslip_history_reports(history, &reports[0], misaligned(reports)) == STICKSLIP_BAD_POINTER);
    CHECK(stickslip_history_reports(history, &reports[0], NULL) == STICKSLIP_BAD_POINTER);
    stickslip_warning warning;
    size_t warned = 77;
    CHECK(stickslip_history_warnings(history, misaligned(&warning), 1, &warned) == STICKSLIP_BAD_POINTER);
    CHECK(taken[0] == 77 && reports[0].status == 77 && warned == 77);
    OK(stickslip_history_to_bytes(history, after, length, &again));
    CHECK(again == length && memcmp(before, after, length) == 0);

    /* A history from bytes takes the next step with bitwise identical results. */
    stickslip_history *restored = NULL;
    OK(stickslip_history_from_bytes(bodies, before, length, &restored));
    load = drag(20.0);
    OK(stickslip_history_step(history, &load, NULL));
    OK(stickslip_history_step(restored, &load, NULL));
    stickslip_step_result one, other;
    OK(stickslip_history_result(history, &one));
    OK(stickslip_history_result(restored, &other));
    CHECK(one.shift[0] == other.shift[0] && one.shift[0] > 0.0 && one.steps == 2 && other.steps == 2);
    before[length / 2] ^= 1;
    stickslip_history *damaged = NULL;
    CHECK(stickslip_history_from_bytes(bodies, before, length, &damaged) == STICKSLIP_FORMAT && damaged == NULL);
    free(before), free(after);
    OK(stickslip_history_free(restored));
    OK(stickslip_half_space_free(bodies)); /* before the history that came from it */
    load = drag(-20.0);
    OK(stickslip_history_step(history, &load, NULL));
    OK(stickslip_history_free(history));
}

static void fields_are_not_copied(void) {
    stickslip_half_space *bodies = make_bodies();
    stickslip_history *history = make_history(bodies);
    stickslip_load_step load = press(100.0);
    OK(stickslip_history_step(history, &load, NULL));
    size_t count = 0;
    const double *pressure = stickslip_history_field(history, STICKSLIP_PRESSURE, &count);
    CHECK(pressure != NULL && count == CELLS);
    CHECK(pressure == stickslip_history_field(history, STICKSLIP_PRESSURE, NULL));
    double sum = 0.0;
    for (size_t i = 0; pressure != NULL && i < count; i++) {
        sum += pressure[i] * GRID.dx * GRID.dy;
    }
    CHECK(fabs(sum - 100.0) < 1e-6);
    const uint8_t *zones = stickslip_history_zones(history, &count);
    CHECK(zones != NULL && count == CELLS && zones[0] == STICKSLIP_SEPARATED);
    CHECK(zones != NULL && zones[CELLS / 2 + N / 2] != STICKSLIP_SEPARATED);
    CHECK(stickslip_history_field(history, STICKSLIP_DISPLACEMENT_X, &count) == NULL);
    CHECK(stickslip_history_field(history, -1, NULL) == NULL);
    CHECK(stickslip_history_field(NULL, STICKSLIP_PRESSURE, NULL) == NULL);

    stickslip_state *state = NULL;
    OK(stickslip_state_new(history, &state));
    load = drag(30.0);
    OK(stickslip_history_step(history, &load, NULL));
    stickslip_stiffness slope;
    OK(stickslip_history_stiffness(history, &slope));
    CHECK(slope.normal.value > 0.0 && slope.tangential.reversal[0][0] > slope.tangential.loading[0][0]);
    stickslip_stiffness next;
    OK(stickslip_history_next_stiffness(history, NULL, &next));
    CHECK(next.normal.value == slope.normal.value && next.tangential.loading[0][0] > 0.0);
    stickslip_per_cell alpha = {1e-14, NULL, 0};
    double depth[CELLS] = {0};
    OK(stickslip_wear_energy(history, &alpha, depth, CELLS));
    double volume = 0.0;
    for (size_t i = 0; i < CELLS; i++) {
        volume += depth[i] * GRID.dx * GRID.dy;
    }
    stickslip_step_result result;
    OK(stickslip_history_result(history, &result));
    CHECK(fabs(volume / (1e-14 * result.energy.dissipated_energy) - 1.0) < 1e-12);
    OK(stickslip_history_set_state(history, state));
    OK(stickslip_history_result(history, &result));
    CHECK(result.force[0] == 0.0 && result.steps == 1);
    OK(stickslip_state_free(state));
    OK(stickslip_history_free(history));
    OK(stickslip_half_space_free(bodies));
}

/* A rejected step counts neither in a cycle nor as wear, and its numbers are no longer returned. */
static void rejected_steps_do_not_count(void) {
    stickslip_half_space *bodies = make_bodies();
    stickslip_history *history = make_history(bodies), *direct = NULL, *restored = NULL;
    stickslip_step_result result;
    stickslip_report reports[2];
    stickslip_per_cell alpha = {1e-14, NULL, 0};
    static double depth[CELLS], expected[CELLS];
    size_t count = 0;
    OK(stickslip_history_result(history, &result));
    CHECK(result.has_last_step == 0 && isnan(result.stick_ratio) && isnan(result.energy.work) && isnan(result.creepage[1]));
    stickslip_load_step load = press(100.0);
    OK(stickslip_history_step(history, &load, NULL));
    OK(stickslip_history_clone(history, &direct));
    stickslip_state *before = NULL;
    stickslip_cycle *cycle = NULL, *of_direct = NULL;
    OK(stickslip_state_new(history, &before));
    OK(stickslip_cycle_new(history, &cycle));
    OK(stickslip_cycle_new(direct, &of_direct));
    const double forces[] = {20.0, 40.0, -40.0, 0.0};
    for (int i = 0; i < 4; i++) {
        OK(stickslip_state_keep(before, history));
        load = drag(-0.9 * forces[i]);
        OK(stickslip_history_step(history, &load, NULL));
        OK(stickslip_history_set_state(history, before));
        CHECK(stickslip_cycle_add(cycle, history) == STICKSLIP_NO_LAST_STEP);
        CHECK(stickslip_wear_energy(history, &alpha, depth, CELLS) == STICKSLIP_NO_LAST_STEP);
        CHECK(stickslip_wear_archard(history, &alpha, depth, CELLS) == STICKSLIP_NO_LAST_STEP);
        CHECK(stickslip_wear_threshold_energy(history, &alpha, 0.0, depth, CELLS) == STICKSLIP_NO_LAST_STEP);
        CHECK(strstr(stickslip_last_error_message(), "make a step first") != NULL);
        CHECK(stickslip_history_reports(history, &reports[0], &reports[1]) == STICKSLIP_NO_LAST_STEP);
        CHECK(stickslip_history_warnings(history, NULL, 0, &count) == STICKSLIP_NO_LAST_STEP);
        CHECK(stickslip_history_field(history, STICKSLIP_STEP_SLIP_DISTANCE, NULL) == NULL);
        CHECK(stickslip_history_field(history, STICKSLIP_SLIP_DISTANCE, NULL) != NULL);
        OK(stickslip_history_result(history, &result));
        CHECK(result.has_last_step == 0 && isnan(result.stick_ratio) && isnan(result.energy.dissipated_energy));
        CHECK(fabs(result.normal_force / 100.0 - 1.0) < 1e-6 && result.steps == (uint64_t)(i + 1));
        load = drag(forces[i]);
        OK(stickslip_history_step(history, &load, NULL));
        OK(stickslip_cycle_add(cycle, history));
        OK(stickslip_wear_energy(history, &alpha, depth, CELLS));
        OK(stickslip_history_step(direct, &load, NULL));
        OK(stickslip_cycle_add(of_direct, direct));
        OK(stickslip_wear_energy(direct, &alpha, expected, CELLS));
    }
    stickslip_cycle_result one, other;
    OK(stickslip_cycle_result_of(cycle, &one));
    OK(stickslip_cycle_result_of(of_direct, &other));
    CHECK(one.steps == 4 && other.steps == 4 && one.energy.dissipated_energy > 0.0);
    CHECK(memcmp(&one.energy, &other.energy, sizeof one.energy) == 0 && one.cyclic_residual == other.cyclic_residual);
    CHECK(memcmp(depth, expected, sizeof depth) == 0);
    OK(stickslip_history_result(history, &result));
    CHECK(result.has_last_step == 1 && result.stick_ratio > 0.0);

    size_t length = 0;
    OK(stickslip_history_to_bytes(history, NULL, 0, &length));
    uint8_t *bytes = malloc(length);
    OK(stickslip_history_to_bytes(history, bytes, length, &length));
    OK(stickslip_history_from_bytes(bodies, bytes, length, &restored));
    CHECK(stickslip_cycle_add(cycle, restored) == STICKSLIP_NO_LAST_STEP);
    free(bytes);

    /* A stiffness belongs to the friction of the last step. */
    stickslip_stiffness slope;
    stickslip_friction less = stickslip_coulomb(0.4);
    OK(stickslip_history_set_friction(history, &less));
    CHECK(stickslip_history_stiffness(history, &slope) == STICKSLIP_OUTDATED_SOLUTION);
    CHECK(stickslip_history_next_stiffness(history, NULL, &slope) == STICKSLIP_OUTDATED_SOLUTION);
    CHECK(strstr(stickslip_last_error_message(), "take a step first") != NULL);
    load = drag(10.0);
    OK(stickslip_history_step(history, &load, NULL));
    OK(stickslip_history_next_stiffness(history, NULL, &slope));

    /* The gap under load is not a gap before loading. */
    const double *loaded = stickslip_history_field(history, STICKSLIP_GAP, NULL);
    CHECK(stickslip_history_set_gap(history, loaded, CELLS) == STICKSLIP_GAP_UNDER_LOAD);
    CHECK(strstr(stickslip_last_error_message(), "give the gap before loading") != NULL);
    OK(stickslip_cycle_free(cycle));
    OK(stickslip_cycle_free(of_direct));
    OK(stickslip_state_free(before));
    OK(stickslip_history_free(history));
    OK(stickslip_history_free(direct));
    OK(stickslip_history_free(restored));
    OK(stickslip_half_space_free(bodies));
}

static void batches_are_the_steps_alone(void) {
    stickslip_half_space *bodies = make_bodies();
    stickslip_history *histories[5], *alone = make_history(bodies);
    stickslip_load_step loads[5];
    stickslip_status codes[5];
    for (int i = 0; i < 3; i++) {
        histories[i] = make_history(bodies);
        loads[i] = press(10.0 * (i + 1));
    }
    OK(stickslip_history_step_all(histories, loads, 3, codes));
    OK(stickslip_history_step(alone, &loads[1], NULL));
    stickslip_step_result one, other;
    OK(stickslip_history_result(alone, &one));
    OK(stickslip_history_result(histories[1], &other));
    CHECK(one.approach == other.approach && one.approach > 0.0);

    /* One history is loaded beyond friction, and one occurs three times. */
    loads[0] = drag(1.0), loads[1] = drag(30.0), loads[2] = drag(1.0), loads[3] = drag(2.0), loads[4] = drag(2.0);
    histories[3] = histories[4] = histories[0];
    CHECK(stickslip_history_step_all(histories, loads, 5, codes) == STICKSLIP_SOME_FAILED);
    CHECK(codes[0] == STICKSLIP_OK && codes[1] == STICKSLIP_BEYOND_FRICTION_CAPACITY && codes[2] == STICKSLIP_OK &&
          codes[3] == STICKSLIP_BUSY && codes[4] == STICKSLIP_BUSY);
    stickslip_error error;
    OK(stickslip_last_error(&error));
    CHECK(error.index == 1);
    loads[1] = drag(1.0);
    CHECK(stickslip_history_step_all(histories, loads, 5, NULL) == STICKSLIP_SOME_FAILED);
    CHECK(strstr(stickslip_last_error_message(), "history 3 is the same object as history 0: pass each history once") != NULL);
    histories[3] = NULL;
    CHECK(stickslip_history_step_all(histories, loads, 4, NULL) == STICKSLIP_SOME_FAILED);
    OK(stickslip_history_step_all(NULL, NULL, 0, NULL));
    for (int i = 0; i < 3; i++) {
        OK(stickslip_history_free(histories[i]));
    }
    OK(stickslip_history_free(alone));
    OK(stickslip_half_space_free(bodies));
}

static void dissimilar_bodies_are_coupled(void) {
    stickslip_material rubber = {1e6, 0.0, 0.0}, rigid = {INFINITY, 0.0, 0.0};
    stickslip_half_space *bodies = NULL;
    OK(stickslip_half_space_new(&GRID, &rubber, &rigid, NULL, &bodies));
    stickslip_pair pair;
    OK(stickslip_half_space_pair(bodies, &pair));
    CHECK(pair.is_coupled && fabs(pair.dundurs_beta - 0.5) < 1e-12);
    stickslip_friction friction = stickslip_coulomb(0.3);
    stickslip_normal_load load = {STICKSLIP_APPROACH, 2e-6};
    stickslip_tangential_load still = {{STICKSLIP_SHIFT, 0.0, 0.0}, {STICKSLIP_SHIFT, 0.0, 0.0}, 0.0};
    stickslip_coupled_solver *solver = NULL;
    stickslip_coupled_solution *solution = NULL;
    OK(stickslip_coupled_solver_new(bodies, ball, CELLS, &friction, &load, &still, NULL, NULL, NULL, &solver));
    OK(stickslip_coupled_solution_new(solver, &solution));
    OK(stickslip_coupled_solver_solve(solver, solution, NULL));
    stickslip_normal_result normal;
    normal.force = 77.0;
    CHECK(stickslip_coupled_solution_results(solution, &normal, misaligned(&normal)) == STICKSLIP_BAD_POINTER);
    CHECK(normal.force == 77.0);
    OK(stickslip_coupled_solution_results(solution, &normal, NULL));
    CHECK(normal.force > 0.0 && normal.approach == 2e-6);
    CHECK(stickslip_coupled_solution_field(solution, STICKSLIP_DISPLACEMENT_Z, NULL) != NULL);
    stickslip_coupled_report report;
    OK(stickslip_coupled_solution_report(solution, &report));
    CHECK(report.work.status == STICKSLIP_CONVERGED && report.pressure_error_bound < 1e-6);
    size_t count = 9;
    stickslip_warning warnings[8];
    OK(stickslip_coupled_solution_warnings(solution, warnings, 8, &count));
    for (size_t i = 0; i < count && i < 8; i++) {
        CHECK(strlen(warnings[i].message) > 10);
    }
    /* The stiffness is the derivative of the force. */
    stickslip_settings exact = stickslip_settings_default();
    stickslip_normal_result pressed[2];
    stickslip_stiffness slope;
    exact.tolerance = 1e-10;
    OK(stickslip_coupled_solver_set_settings(solver, &exact));
    for (int i = 0; i < 3; i++) {
        const double step = 1e-10;
        load.value = 2e-6 + (i - 1) * step;
        OK(stickslip_coupled_solver_set_loads(solver, &load, &still));
        OK(stickslip_coupled_solver_solve(solver, solution, NULL));
        if (i == 1) {
            OK(stickslip_coupled_solution_stiffness(solution, bodies, &friction, &slope));
        } else {
            OK(stickslip_coupled_solution_results(solution, &pressed[i / 2], NULL));
        }
    }
    const double by_approach = (pressed[1].force - pressed[0].force) / (pressed[1].approach - pressed[0].approach);
    CLOSE(slope.normal.value, by_approach, 1e-4);
    stickslip_friction wrong = stickslip_coulomb(-1.0);
    CHECK(stickslip_coupled_solution_stiffness(solution, bodies, &wrong, &slope) != STICKSLIP_OK);
    CHECK(stickslip_coupled_solution_stiffness(solution, bodies, NULL, &slope) == STICKSLIP_BAD_POINTER);
    /* Every tolerance below 1 is valid. */
    stickslip_settings settings = stickslip_settings_default();
    for (settings.tolerance = 0.9; settings.tolerance > 1e-3; settings.tolerance *= 0.3) {
        OK(stickslip_coupled_solver_set_settings(solver, &settings));
        OK(stickslip_coupled_solver_reset(solver));
        OK(stickslip_coupled_solver_solve(solver, solution, NULL));
    }
    OK(stickslip_coupled_solution_free(solution));
    OK(stickslip_coupled_solver_free(solver));
    OK(stickslip_half_space_free(bodies));
}

/* Number of received steps, their dissipated energy, and the number after which the observer ends the call. */
typedef struct {
    size_t seen, allowed;
    double energy;
} step_log;

static int32_t log_step(const stickslip_step_result *step, void *user) {
    step_log *log = user;
    log->seen++;
    log->energy += step->energy.dissipated_energy;
    return step->has_last_step && log->seen < log->allowed;
}

/* The observer and the cycle receive every accepted step. An observer that returns 0 ends the call, which undoes its steps. */
static void steps_reach_observer_and_cycle(stickslip_history *history, stickslip_adaptive_steps *steps,
                                           stickslip_load_step load) {
    stickslip_cycle *cycle = NULL;
    stickslip_cycle_result sums;
    stickslip_step_result before, after;
    size_t taken = 0;
    for (int pressing = 0; pressing < 2; pressing++) {
        step_log log = {0, 1, 0.0};
        stickslip_step_observer observer = {log_step, &log};
        OK(stickslip_history_result(history, &before));
        stickslip_status ended =
            pressing ? stickslip_history_press_stepwise(history, &load, 0.01, NULL, &observer, &taken)
                     : stickslip_adaptive_steps_stepwise(steps, history, &load, NULL, &observer, &taken);
        CHECK(ended == STICKSLIP_NOT_CONVERGED && log.seen == 1 && taken == 0);
        CHECK(strstr(stickslip_last_error_message(), "the observer ended the call") != NULL);
        OK(stickslip_history_result(history, &after));
        CHECK(after.steps == before.steps && after.force[1] == before.force[1]);

        log = (step_log){0, SIZE_MAX, 0.0};
        OK(stickslip_cycle_new(history, &cycle));
        if (pressing) {
            OK(stickslip_history_press_stepwise(history, &load, 0.01, cycle, &observer, &taken));
        } else {
            OK(stickslip_adaptive_steps_stepwise(steps, history, &load, cycle, &observer, &taken));
        }
        OK(stickslip_cycle_result_of(cycle, &sums));
        CHECK(taken >= 2 && log.seen == taken && sums.steps == taken);
        CHECK(log.energy > 0.0 && fabs(log.energy / sums.energy.dissipated_energy - 1.0) < 1e-9);
        OK(stickslip_cycle_free(cycle));
        load.y.value = -load.y.value, taken = 0;
    }
}

static void loads_are_cut_into_steps(void) {
    stickslip_half_space *bodies = make_bodies();
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_history_options options = stickslip_history_options_default();
    options.model = STICKSLIP_VECTOR;
    stickslip_history *history = NULL, *copy = NULL;
    OK(stickslip_history_new(bodies, ball, CELLS, &friction, &options, &history));
    stickslip_load_step load = press(50.0);
    OK(stickslip_history_step(history, &load, NULL));
    load = drag(20.0);
    OK(stickslip_history_step(history, &load, NULL));
    OK(stickslip_history_clone(history, &copy));
    stickslip_adaptive_steps *steps = NULL;
    CHECK(stickslip_adaptive_steps_new(history, 2.0, &steps) == STICKSLIP_TOLERANCE && steps == NULL);
    OK(stickslip_adaptive_steps_new(history, 0.01, &steps));
    load = press(100.0), load.x.kind = STICKSLIP_FORCE, load.y.kind = STICKSLIP_FORCE, load.y.value = 20.0;
    stickslip_step_error error;
    size_t taken = 0;
    OK(stickslip_adaptive_steps_error(steps, history, &load, &error));
    OK(stickslip_adaptive_steps_step(steps, history, &load, &taken));
    CHECK(error.traction > 0.0 && taken >= 2);
    stickslip_step_result result;
    OK(stickslip_history_result(history, &result));
    CHECK(fabs(result.force[1] - 20.0) < 1e-6 && fabs(result.normal_force - 100.0) < 1e-6);
    OK(stickslip_history_result(copy, &result));
    CHECK(fabs(result.normal_force - 50.0) < 1e-6);
    stickslip_load_step back = load;
    back.y.value = -20.0;
    steps_reach_observer_and_cycle(history, steps, back);
    OK(stickslip_adaptive_steps_free(steps));
    load = press(100.0);
    CHECK(stickslip_history_press(copy, &load, 2.0, NULL, NULL) == STICKSLIP_TOLERANCE);
    OK(stickslip_history_press(copy, &load, 0.01, NULL, &taken));
    OK(stickslip_history_result(copy, &result));
    CHECK(taken == 2 && fabs(result.normal_force - 100.0) < 1e-6);
    OK(stickslip_history_free(copy));
    OK(stickslip_history_free(history));
    OK(stickslip_half_space_free(bodies));
}

static void step_is_rejected(stickslip_history *history, stickslip_load_step load, double value, const char *remedy) {
    stickslip_error error;
    CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_INVALID_ARGUMENT);
    CHECK(strstr(stickslip_last_error_message(), remedy) != NULL);
    OK(stickslip_last_error(&error));
    CHECK(error.value == value || (isnan(value) && isnan(error.value)));
}

/* A number that has no effect because of another member is rejected. */
static void numbers_without_effect_are_rejected(void) {
    stickslip_half_space *bodies = make_bodies();
    stickslip_history *history = make_history(bodies), *made = NULL;
    stickslip_load_step load = press(100.0);
    load.twist = 1e-3;
    step_is_rejected(history, load, 1e-3, "set has_twist to 1");
    load.twist = NAN;
    step_is_rejected(history, load, NAN, "set has_twist to 1");
    load = press(100.0), load.relative_displacement = 2.0;
    step_is_rejected(history, load, 2.0, "has_relative_displacement is zero");
    load = press(100.0), load.normal.kind = STICKSLIP_HOLD;
    step_is_rejected(history, load, 100.0, "STICKSLIP_FORCE or STICKSLIP_APPROACH");
    load = drag(10.0), load.x.kind = STICKSLIP_HOLD;
    step_is_rejected(history, load, 10.0, "STICKSLIP_SHIFT or STICKSLIP_SPRING");
    load = drag(10.0), load.y.stiffness = 5.0;
    step_is_rejected(history, load, 5.0, "set kind to STICKSLIP_SPRING");
    load = drag(10.0), load.x.stiffness = 5.0;
    step_is_rejected(history, load, 5.0, "set kind to STICKSLIP_SPRING");
    load = press(100.0);
    OK(stickslip_history_step(history, &load, NULL));

    stickslip_boundary boundary = {STICKSLIP_PERIODIC, 1.0};
    stickslip_half_space *periodic = NULL;
    CHECK(stickslip_half_space_new(&GRID, &STEEL, &STEEL, &boundary, &periodic) == STICKSLIP_INVALID_ARGUMENT);
    stickslip_friction friction = stickslip_coulomb(0.5);
    friction.coefficient.count = CELLS; /* without an array, as after a failed allocation */
    CHECK(stickslip_history_set_friction(history, &friction) == STICKSLIP_BAD_POINTER);
    CHECK(strstr(stickslip_last_error_message(), "the member cells of the coefficient of friction is NULL, but count is") !=
          NULL);
    friction.coefficient.count = 0;
    OK(stickslip_history_set_friction(history, &friction));
    stickslip_history_options options = stickslip_history_options_default();
    options.permanent_set = 1;
    CHECK(stickslip_history_new(bodies, ball, CELLS, &friction, &options, &made) == STICKSLIP_INVALID_ARGUMENT);
    CHECK(strstr(stickslip_last_error_message(), "hardness is NULL") != NULL);
    OK(stickslip_history_free(history));
    OK(stickslip_half_space_free(bodies));
}

int main(void) {
    CHECK(stickslip_abi_version() == STICKSLIP_ABI_VERSION);
    char version[32];
    snprintf(version, sizeof version, "%d.%d.%d", STICKSLIP_VERSION_MAJOR, STICKSLIP_VERSION_MINOR,
             STICKSLIP_VERSION_PATCH);
    CHECK(strcmp(stickslip_version(), version) == 0);
    CHECK(strcmp(stickslip_last_error_message(), "") == 0);
    OK(stickslip_set_num_threads(2));
    OK(stickslip_surface_sphere(&GRID, 3.5e-3, ball, CELLS));
    layers_are_felt();
    a_report_tells_how_the_least_eigenvalue_is_known();
    bad_input_is_refused();
    numbers_without_effect_are_rejected();
    failed_steps_leave_no_trace();
    fields_are_not_copied();
    rejected_steps_do_not_count();
    batches_are_the_steps_alone();
    dissimilar_bodies_are_coupled();
    loads_are_cut_into_steps();
    OK(stickslip_set_num_threads(0));
    return report("guarantees of the header");
}
