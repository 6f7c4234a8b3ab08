/* Steady and stepwise rolling compared with Carter and Kalker, with prescribed creepages, forces and moments. */

#include <math.h>
#include <string.h>

#include "check.h"

#define N 24
#define CELLS (N * N)
#define FRICTION 0.3

/* A ball of radius one on a plane of the same material, with shear modulus one, under a force of one. */
static const stickslip_material BODY = {2.5, 0.25, 0.0};
static double gap[CELLS], dissipation[CELLS];

static stickslip_normal_solution *press(const stickslip_half_space *bodies, const double *of, size_t cells, double force) {
    stickslip_normal_load load = {STICKSLIP_FORCE, force};
    stickslip_normal_solver *solver = NULL;
    stickslip_normal_solution *solution = NULL;
    OK(stickslip_normal_solver_new(bodies, of, cells, &load, NULL, NULL, &solver));
    OK(stickslip_normal_solution_new(solver, &solution));
    OK(stickslip_normal_solver_solve(solver, solution, NULL));
    OK(stickslip_normal_solver_free(solver));
    return solution;
}

static stickslip_rolling_load by_creepage(double x, double y, double spin) {
    stickslip_rolling_load load = {{STICKSLIP_CREEPAGE, x}, {STICKSLIP_CREEPAGE, y}, {STICKSLIP_SPIN, spin}};
    return load;
}

static stickslip_rolling_result solve(stickslip_rolling_solver *solver, stickslip_rolling_solution *solution) {
    stickslip_rolling_result result;
    OK(stickslip_rolling_solver_solve(solver, solution, NULL));
    OK(stickslip_rolling_solution_result(solution, &result));
    return result;
}

static void a_cylinder_is_carter(void) {
    enum { CUT = 128 };
    const double radius = 10.0, force = 100.0;
    stickslip_material steel = {210e3, 0.3, 0.0};
    stickslip_half_space *bodies = NULL;
    stickslip_carter carter;
    double side = 1.0, line[CUT];
    stickslip_grid grid = {CUT, 1, side / CUT, 1.0};
    stickslip_boundary along_y = {STICKSLIP_PERIODIC_ALONG_Y, side};
    OK(stickslip_half_space_new(&grid, &steel, &steel, &along_y, &bodies));
    OK(stickslip_carter_cylinder(bodies, radius, force, FRICTION, 0.0, &carter));
    CHECK(carter.force == 0.0 && carter.stick_half_width == carter.half_width);
    OK(stickslip_half_space_free(bodies));

    grid.dx = 2.5 * carter.half_width / CUT;
    OK(stickslip_half_space_new(&grid, &steel, &steel, &along_y, &bodies));
    double creepage = 0.4 * carter.sliding_creepage;
    OK(stickslip_carter_cylinder(bodies, radius, force, FRICTION, creepage, &carter));
    CLOSE(carter.force, 0.64 * FRICTION * force, 1e-12);
    OK(stickslip_surface_cylinder(&grid, radius, line, CUT));
    stickslip_normal_solution *pressed = press(bodies, line, CUT, force);
    stickslip_friction friction = stickslip_coulomb(FRICTION);
    stickslip_rolling_load load = by_creepage(creepage, 0.0, 0.0);
    stickslip_rolling_solver *solver = NULL;
    stickslip_rolling_solution *solution = NULL;
    OK(stickslip_rolling_solver_new(bodies, pressed, &friction, &load, NULL, &solver));
    OK(stickslip_rolling_solution_new(solver, &solution));
    stickslip_rolling_result result = solve(solver, solution);
    CHECK(fabs(result.force[0] - carter.force) < 1e-4 * FRICTION * force);
    CHECK(fabs(result.stick_ratio - carter.stick_half_width / carter.half_width) < 0.02);
    OK(stickslip_rolling_solution_free(solution));
    OK(stickslip_rolling_solver_free(solver));
    OK(stickslip_normal_solution_free(pressed));
    OK(stickslip_half_space_free(bodies));
}

static void small_creepages_have_the_coefficients_of_kalker(stickslip_rolling_solver *solver,
                                                            stickslip_rolling_solution *solution, double radius) {
    stickslip_rolling_stiffness stiffness;
    OK(stickslip_rolling_solver_stiffness(solver, &stiffness));
    CLOSE(stiffness.slopes[0][0], 4.12 * radius * radius, 0.02);
    CLOSE(stiffness.slopes[1][1], 3.67 * radius * radius, 0.02);
    CLOSE(stiffness.slopes[1][2], 1.47 * pow(radius, 3), 0.02);
    stickslip_rolling_load load = by_creepage(0.0, 0.0, 1e-6);
    OK(stickslip_rolling_solver_set_load(solver, &load));
    stickslip_rolling_result result = solve(solver, solution);
    CLOSE(result.force[1], 1e-6 * stiffness.slopes[1][2], 1e-3);
    CLOSE(result.moment, 1e-6 * stiffness.slopes[2][2], 1e-3);
}

static void loads_have_the_motions_that_cause_them(stickslip_rolling_solver *solver, stickslip_rolling_solution *solution) {
    stickslip_rolling_load load = by_creepage(0.1, 0.0, 0.1);
    OK(stickslip_rolling_solver_set_load(solver, &load));
    stickslip_rolling_result by_motion = solve(solver, solution);
    load.x.kind = load.y.kind = STICKSLIP_FORCE, load.spin.kind = STICKSLIP_MOMENT;
    load.x.value = by_motion.force[0], load.y.value = by_motion.force[1], load.spin.value = by_motion.moment;
    OK(stickslip_rolling_solver_set_load(solver, &load));
    stickslip_rolling_result by_load = solve(solver, solution);
    CLOSE(by_load.force[0], by_motion.force[0], 1e-8);
    CLOSE(by_load.creepage[0], 0.1, 1e-4);
    CLOSE(by_load.spin, 0.1, 1e-4);

    /* Most of the work is dissipated, and only in slip cells. */
    size_t count = 0;
    OK(stickslip_rolling_solution_dissipation_per_area(solution, dissipation, CELLS));
    const uint8_t *zones = stickslip_rolling_solution_zones(solution, &count);
    const double *traction = stickslip_rolling_solution_field(solution, STICKSLIP_TRACTION_X, NULL);
    const double *slip = stickslip_rolling_solution_field(solution, STICKSLIP_SLIP_X, NULL);
    CHECK(count == CELLS && zones != NULL && traction != NULL && slip != NULL);
    double sum = 0.0, force = 0.0, area = 9.0 / CELLS;
    for (int i = 0; i < CELLS; i++) {
        sum += dissipation[i] * area, force += traction[i] * area;
        CHECK(zones[i] == STICKSLIP_SLIP ? dissipation[i] >= 0.0 : dissipation[i] == 0.0 && slip[i] == 0.0);
    }
    CHECK(sum > 0.8 * by_load.work && sum < by_load.work);
    CLOSE(force, by_load.force[0], 1e-12);
    CHECK(stickslip_rolling_solution_dissipation_per_area(solution, dissipation, 1) == STICKSLIP_LENGTH);
    CHECK(stickslip_rolling_solution_field(solution, STICKSLIP_PRESSURE, NULL) == NULL);
    stickslip_report report;
    OK(stickslip_rolling_solution_report(solution, &report));
    CHECK(report.status == STICKSLIP_CONVERGED);
}

static void a_creep_curve_goes_from_nothing_to_sliding(stickslip_rolling_solver *solver) {
    stickslip_creep_point points[11] = {0};
    stickslip_creep_force forces[11];
    for (int i = 0; i < 11; i++) {
        points[i].creepage[0] = 0.03 * i;
    }
    OK(stickslip_rolling_solver_creep_forces(solver, points, 11, forces));
    CHECK(forces[0].force[0] == 0.0 && forces[0].stick_ratio == 1.0);
    /* In gross slip the force is not exactly along x. */
    CHECK(forces[10].stick_ratio == 0.0 && forces[10].force[0] > 0.999 * FRICTION && forces[10].force[0] < FRICTION);
    for (int i = 1; i < 10; i++) {
        CHECK(forces[i + 1].force[0] - forces[i].force[0] <= forces[i].force[0] - forces[i - 1].force[0] + 1e-9);
    }
    OK(stickslip_rolling_solver_creep_forces(solver, NULL, 0, NULL));
    CHECK(stickslip_rolling_solver_creep_forces(solver, points, 11, NULL) == STICKSLIP_BAD_POINTER);
}

static void creepages_in_per_cent_cause_a_warning(stickslip_rolling_solver *solver) {
    stickslip_creep_point small[2] = {{{0.0, 0.0}, 0.0}, {{0.01, 0.0}, 0.0}};
    stickslip_creep_point large[3] = {{{0.0, 0.0}, 0.0}, {{0.2, 0.0}, 0.0}, {{0.3, 0.0}, 0.0}};
    stickslip_creep_force forces[3];
    stickslip_warning warning = {0};
    size_t count = 7;
    OK(stickslip_rolling_solver_creep_forces(solver, large, 3, forces));
    OK(stickslip_rolling_solver_creep_warnings(solver, NULL, 0, &count));
    CHECK(count == 1);
    OK(stickslip_rolling_solver_creep_warnings(solver, &warning, 1, &count));
    CHECK(count == 1 && warning.kind == STICKSLIP_WARNING_LARGE_CREEPAGE && strstr(warning.message, "by 20 %") != NULL);
    /* The warnings belong to the last call. */
    OK(stickslip_rolling_solver_creep_forces(solver, small, 2, forces));
    OK(stickslip_rolling_solver_creep_warnings(solver, NULL, 0, &count));
    CHECK(count == 0);
    CHECK(stickslip_rolling_solver_creep_warnings(solver, NULL, 0, NULL) == STICKSLIP_BAD_POINTER);
}

static void what_is_refused_leaves_the_solver(stickslip_rolling_solver *solver, stickslip_rolling_solution *solution) {
    stickslip_rolling_load load = by_creepage(0.05, 0.0, 0.0);
    OK(stickslip_rolling_solver_set_load(solver, &load));
    stickslip_rolling_result before = solve(solver, solution);
    load.x.kind = STICKSLIP_FORCE, load.x.value = 0.31;
    CHECK(stickslip_rolling_solver_set_load(solver, &load) == STICKSLIP_BEYOND_FRICTION_CAPACITY);
    stickslip_error numbers;
    OK(stickslip_last_error(&numbers));
    CHECK(numbers.value == 0.31);
    CLOSE(numbers.limit, FRICTION, 1e-9);
    load = by_creepage(0.0, NAN, 0.0);
    CHECK(stickslip_rolling_solver_set_load(solver, &load) == STICKSLIP_NOT_FINITE);
    load = by_creepage(0.0, 0.0, 1.0);
    load.spin.kind = STICKSLIP_MOMENT;
    CHECK(stickslip_rolling_solver_set_load(solver, &load) == STICKSLIP_BEYOND_FRICTION_CAPACITY);
    OK(stickslip_last_error(&numbers));
    CHECK(numbers.value == 1.0 && 0.0 < numbers.limit && numbers.limit < 1.0);
    load.spin.kind = STICKSLIP_FORCE;
    CHECK(stickslip_rolling_solver_set_load(solver, &load) == STICKSLIP_UNKNOWN_OPTION);
    load.spin.kind = STICKSLIP_CREEPAGE;
    CHECK(stickslip_rolling_solver_set_load(solver, &load) == STICKSLIP_UNKNOWN_OPTION);
    load.spin.kind = 0;
    CHECK(stickslip_rolling_solver_set_load(solver, &load) == STICKSLIP_UNKNOWN_OPTION);
    load = by_creepage(0.1, 0.0, 0.0);
    load.x.kind = STICKSLIP_SPIN;
    CHECK(stickslip_rolling_solver_set_load(solver, &load) == STICKSLIP_UNKNOWN_OPTION);
    load = by_creepage(0.0, 0.0, 0.0);
    load.reserved[7] = 1;
    CHECK(stickslip_rolling_solver_set_load(solver, &load) == STICKSLIP_UNKNOWN_OPTION);
    stickslip_creep_point points[2] = {{{0.2, 0.0}, 0.0}, {{0.0, 0.0}, INFINITY}};
    stickslip_creep_force forces[2];
    CHECK(stickslip_rolling_solver_creep_forces(solver, points, 2, forces) == STICKSLIP_NOT_FINITE);
    stickslip_settings settings = stickslip_settings_default();
    settings.method = STICKSLIP_POLONSKY_KEER;
    CHECK(stickslip_rolling_solver_set_settings(solver, &settings) == STICKSLIP_METHOD);
    CHECK(stickslip_rolling_solver_set_load(solver, NULL) == STICKSLIP_BAD_POINTER);
    stickslip_rolling_result after = solve(solver, solution);
    CLOSE(after.creepage[0], 0.05, 0.0);
    CLOSE(after.force[0], before.force[0], 1e-7);
}

static void options_are_chosen(const stickslip_half_space *bodies, const stickslip_normal_solution *pressed) {
    stickslip_friction friction = stickslip_coulomb(FRICTION);
    stickslip_rolling_load load = by_creepage(0.1, 0.0, 0.0), across = by_creepage(0.0, 0.1, 0.0);
    stickslip_rolling_options options = stickslip_rolling_options_default(), whole = options;
    stickslip_rolling_solver *solver = NULL, *turned = NULL, *none = NULL;
    stickslip_rolling_solution *solution = NULL;
    OK(stickslip_rolling_solver_new(bodies, pressed, &friction, &load, &options, &solver));
    OK(stickslip_rolling_solution_new(solver, &solution));
    double force = solve(solver, solution).force[0];
    options.leading_edge = STICKSLIP_PLUS_Y;
    OK(stickslip_rolling_solver_new(bodies, pressed, &friction, &across, &options, &turned));
    CLOSE(solve(turned, solution).force[1], force, 1e-7);
    OK(stickslip_rolling_solver_free(turned));
    whole.entry_rule = STICKSLIP_WHOLE_STEP;
    OK(stickslip_rolling_solver_new(bodies, pressed, &friction, &load, &whole, &turned));
    CHECK(solve(turned, solution).force[0] > 1.001 * force);
    options.leading_edge = 4;
    CHECK(stickslip_rolling_solver_new(bodies, pressed, &friction, &load, &options, &none) == STICKSLIP_UNKNOWN_OPTION);
    whole.step = 0;
    CHECK(stickslip_rolling_solver_new(bodies, pressed, &friction, &load, &whole, &none) == STICKSLIP_NOT_POSITIVE);
    whole.step = N;
    CHECK(stickslip_rolling_solver_new(bodies, pressed, &friction, &load, &whole, &none) == STICKSLIP_GRID_TOO_SHORT);
    whole.step = 1, whole.reserved[0] = 1;
    CHECK(stickslip_rolling_solver_new(bodies, pressed, &friction, &load, &whole, &none) == STICKSLIP_UNKNOWN_OPTION);
    CHECK(none == NULL);
    OK(stickslip_rolling_solution_free(solution));
    OK(stickslip_rolling_solver_free(solver));
    OK(stickslip_rolling_solver_free(turned));
}

static void friction_changes_and_the_last_answer_is_forgotten(stickslip_rolling_solver *solver,
                                                              stickslip_rolling_solution *solution) {
    stickslip_rolling_load load = by_creepage(0.0, 0.0, 0.0);
    stickslip_friction more = stickslip_coulomb(2.0 * FRICTION), less = stickslip_coulomb(1e-3), own = stickslip_coulomb(FRICTION);
    stickslip_rolling_stiffness sticking, slipping;
    load.x.kind = STICKSLIP_FORCE, load.x.value = 0.2;
    OK(stickslip_rolling_solver_set_load(solver, &load));
    stickslip_rolling_result before = solve(solver, solution);
    OK(stickslip_rolling_solver_stiffness(solver, &slipping));
    OK(stickslip_rolling_solver_set_friction(solver, &more));
    CHECK(stickslip_rolling_solver_stiffness(solver, &sticking) == STICKSLIP_OUTDATED_SOLUTION);
    CHECK(strstr(stickslip_last_error_message(), "the friction changed since the last solution") != NULL);
    stickslip_rolling_result after = solve(solver, solution);
    CLOSE(after.force[0], 0.2, 1e-8);
    CHECK(after.creepage[0] < before.creepage[0] && after.stick_ratio > before.stick_ratio);
    CHECK(stickslip_rolling_solver_set_friction(solver, &less) == STICKSLIP_BEYOND_FRICTION_CAPACITY);
    CHECK(stickslip_rolling_solver_set_friction(solver, NULL) == STICKSLIP_BAD_POINTER);
    CLOSE(solve(solver, solution).creepage[0], after.creepage[0], 1e-6);
    OK(stickslip_rolling_solver_set_friction(solver, &own));
    OK(stickslip_rolling_solver_reset(solver));
    OK(stickslip_rolling_solver_stiffness(solver, &sticking));
    CHECK(sticking.slopes[0][0] > 1.2 * slipping.slopes[0][0]);
    CHECK(stickslip_rolling_solver_reset(NULL) == STICKSLIP_BAD_POINTER);
}

static int32_t count_down(const stickslip_iteration *iteration, void *user) {
    (void)iteration;
    return (*(int *)user)-- > 0;
}

static void long_calls_ask_their_observer(stickslip_rolling_solver *solver) {
    stickslip_creep_point points[2] = {{{0.05, 0.0}, 0.0}, {{0.1, 0.0}, 0.0}};
    stickslip_creep_force forces[2] = {{{7.0, 7.0}, 7.0, 7.0}};
    int left = 1000, few = 3;
    stickslip_observer observer = {count_down, &few}, patient = {count_down, &left};
    CHECK(stickslip_rolling_solver_creep_forces_observed(solver, points, 2, &observer, forces) == STICKSLIP_NOT_CONVERGED);
    stickslip_report report;
    OK(stickslip_last_error_report(&report));
    CHECK(report.status == STICKSLIP_CANCELLED && few == -1 && forces[0].moment == 7.0);
    OK(stickslip_rolling_solver_creep_forces_observed(solver, points, 2, &patient, forces));
    CHECK(left < 1000 && forces[1].force[0] > forces[0].force[0]);

    /* The points solved before the end are written. */
    stickslip_creep_force whole = forces[0];
    stickslip_error numbers;
    forces[0].moment = forces[1].moment = 7.0;
    OK(stickslip_rolling_solver_reset(solver));
    left = 1000;
    OK(stickslip_rolling_solver_creep_forces_observed(solver, points, 1, &patient, forces));
    int of_first = 1000 - left;
    forces[0].moment = 7.0;
    OK(stickslip_rolling_solver_reset(solver));
    left = of_first + 2;
    CHECK(stickslip_rolling_solver_creep_forces_observed(solver, points, 2, &patient, forces) == STICKSLIP_NOT_CONVERGED);
    OK(stickslip_last_error(&numbers));
    CHECK(numbers.found == 1 && forces[1].moment == 7.0);
    CLOSE(forces[0].force[0], whole.force[0], 1e-6);
    stickslip_rolling_stiffness stiffness;
    CHECK(stickslip_rolling_solver_stiffness(solver, &stiffness) == STICKSLIP_NOT_CONVERGED);
}

static void closed_forms_are_met(const stickslip_half_space *bodies, stickslip_rolling_solver *solver) {
    stickslip_kalker kalker;
    stickslip_vermeulen_johnson curve;
    stickslip_bentall_johnson none;
    OK(stickslip_kalker_coefficients(1.0, 0.25, &kalker));
    CLOSE(kalker.c11, 4.12, 5e-3);
    CLOSE(kalker.c22, 3.67, 5e-3);
    CLOSE(kalker.c23, 1.47, 5e-3);
    CHECK(stickslip_kalker_coefficients(32.0, 0.25, &kalker) == STICKSLIP_BELOW_MINIMUM);
    CHECK(stickslip_kalker_coefficients(0.0, 0.25, &kalker) == STICKSLIP_NOT_POSITIVE);
    CHECK(stickslip_kalker_coefficients(-1.0, 0.25, &kalker) == STICKSLIP_NOT_POSITIVE);
    CHECK(stickslip_kalker_coefficients(1.0, 0.6, &kalker) == STICKSLIP_POISSON_RATIO);
    CHECK(stickslip_kalker_coefficients(1.0, 0.25, NULL) == STICKSLIP_BAD_POINTER);
    OK(stickslip_vermeulen_johnson_ellipse(bodies, 1.0, 1.0, 1.0, FRICTION, 0.06, 0.03, &curve));
    CHECK(curve.coefficients.c11 == kalker.c11 && curve.semi_axes[0] == curve.semi_axes[1]);
    double unit = pow(curve.semi_axes[0], 2) / FRICTION;
    CLOSE(curve.relative_creepage, hypot(kalker.c11 * 0.06, kalker.c22 * 0.03) * unit, 1e-12);
    stickslip_creep_point point = {{0.06, 0.03}, 0.0};
    stickslip_creep_force solved;
    OK(stickslip_rolling_solver_creep_forces(solver, &point, 1, &solved));
    CLOSE(curve.force[0], solved.force[0], 0.04);
    CLOSE(curve.force[1], solved.force[1], 0.04);
    OK(stickslip_bentall_johnson_cylinder(bodies, 1.0, 1.0, 0.01, &none));
    CHECK(none.creepage == 0.0 && none.dissipation == 0.0);

    /* Freely rolling rollers of aluminium and steel. */
    stickslip_material aluminium = {70e3, 0.33, 0.0}, steel = {210e3, 0.3, 0.0};
    stickslip_grid grid = {4, 4, 1.0, 1.0};
    stickslip_half_space *rollers = NULL;
    stickslip_pair pair;
    stickslip_bentall_johnson rolls;
    OK(stickslip_half_space_new(&grid, &aluminium, &steel, NULL, &rollers));
    OK(stickslip_half_space_pair(rollers, &pair));
    OK(stickslip_bentall_johnson_cylinder(rollers, 10.0, 100.0, 0.01, &rolls));
    CLOSE(rolls.creepage, 0.9148 * pair.dundurs_beta * rolls.half_width / 10.0, 1e-4);
    CLOSE(rolls.dissipation, 0.1239 * 0.01 * fabs(pair.dundurs_beta) * 100.0 * rolls.half_width / 10.0, 1e-3);
    CLOSE(rolls.reversal, 0.4040 * rolls.half_width, 1e-4);
    CHECK(stickslip_vermeulen_johnson_ellipse(rollers, 1.0, 1.0, 1.0, FRICTION, 0.0, 0.0, &curve) ==
          STICKSLIP_COUPLED_MATERIALS);
    OK(stickslip_half_space_free(rollers));
}

static stickslip_history *pressed_history(const stickslip_half_space *bodies) {
    stickslip_friction friction = stickslip_coulomb(FRICTION);
    stickslip_history_options options = stickslip_history_options_default();
    stickslip_load_step press = {{STICKSLIP_FORCE, 1.0}};
    stickslip_history *history = NULL;
    options.model = STICKSLIP_VECTOR;
    OK(stickslip_history_new(bodies, gap, CELLS, &friction, &options, &history));
    OK(stickslip_history_step(history, &press, NULL));
    return history;
}

static void histories_that_roll_on_end_in_the_steady_state(const stickslip_half_space *bodies,
                                                           stickslip_rolling_solver *solver,
                                                           stickslip_rolling_solution *solution) {
    stickslip_history *history = pressed_history(bodies);
    stickslip_load_step load = {0};
    stickslip_step_result step = {0};
    load.roll = (stickslip_roll){1, STICKSLIP_PLUS_X, {0.05, 0.02}, 0.01};
    for (int i = 0; i < 120; i++) {
        double last = step.force[0];
        OK(stickslip_history_step(history, &load, NULL));
        OK(stickslip_history_result(history, &step));
        CHECK(step.force[0] > last - 1e-6 && step.creepage[0] == 0.05 && step.creepage[1] == 0.02);
    }
    stickslip_rolling_load steady = by_creepage(0.05, 0.02, 0.01);
    OK(stickslip_rolling_solver_set_load(solver, &steady));
    stickslip_rolling_result result = solve(solver, solution);
    CLOSE(step.force[0], result.force[0], 1e-6);
    CLOSE(step.force[1], result.force[1], 1e-6);
    CLOSE(step.moment, result.moment, 1e-6);

    /* The creepage due to a prescribed force, and a step without rolling. */
    load.roll.creepage[0] = load.roll.spin = 0.0;
    load.x.kind = STICKSLIP_FORCE, load.x.value = 0.1;
    OK(stickslip_history_step(history, &load, NULL));
    OK(stickslip_history_result(history, &step));
    CLOSE(step.force[0], 0.1, 1e-8);
    CHECK(step.creepage[0] < 0.05 && step.creepage[1] == 0.02);
    load.roll = (stickslip_roll){0};
    OK(stickslip_history_step(history, &load, NULL));
    OK(stickslip_history_result(history, &step));
    CHECK(step.creepage[0] == 0.0 && step.creepage[1] == 0.0);
    OK(stickslip_history_free(history));
}

/* A ball rolls in the same way in all directions. */
static void histories_roll_to_each_side(const stickslip_half_space *bodies) {
    const int32_t edges[] = {STICKSLIP_PLUS_X, STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y, STICKSLIP_MINUS_Y};
    const double length = 2.0 * 3.0 / N, spin = 0.01;
    stickslip_step_result first = {0};
    for (int i = 0; i < 4; i++) {
        stickslip_history *history = pressed_history(bodies);
        stickslip_load_step load = {0};
        stickslip_step_result step;
        int axis = i / 2;
        load.roll = (stickslip_roll){2, edges[i], {0.0, 0.0}, spin};
        load.roll.creepage[axis] = 0.05;
        OK(stickslip_history_step(history, &load, NULL));
        OK(stickslip_history_result(history, &step));
        CLOSE(step.shift[axis], length * 0.05, 1e-12);
        CLOSE(step.twist, length * spin, 1e-12);
        CHECK(step.creepage[axis] == 0.05 && step.creepage[1 - axis] == 0.0);
        if (i == 0) {
            first = step;
            CHECK(step.force[0] > 0.0 && step.force[0] < FRICTION && step.moment > 0.0);
        }
        CLOSE(step.force[axis], first.force[0], 1e-6);
        CLOSE(step.moment, first.moment, 1e-6);

        /* The normal load, the force along one axis, and the creepage along the other axis in one step. */
        load.normal.kind = STICKSLIP_FORCE, load.normal.value = 1.1;
        load.roll = (stickslip_roll){1, edges[i], {0.0, 0.0}, 0.0};
        load.roll.creepage[1 - axis] = 0.02;
        stickslip_control *control = axis == 0 ? &load.x : &load.y;
        control->kind = STICKSLIP_FORCE, control->value = 0.5 * first.force[0];
        OK(stickslip_history_step(history, &load, NULL));
        OK(stickslip_history_result(history, &step));
        CLOSE(step.normal_force, 1.1, 1e-7);
        CLOSE(step.force[axis], 0.5 * first.force[0], 1e-8);
        CLOSE(step.twist, length * spin, 1e-12);
        CHECK(step.creepage[axis] < 0.05 && step.creepage[1 - axis] == 0.02);

        /* A force and a creepage along the same axis. */
        load.roll.creepage[axis] = 0.01;
        CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_UNSUPPORTED_BY_MODEL);
        OK(stickslip_history_free(history));
    }
}

static void steps_that_cannot_roll_leave_the_history(const stickslip_half_space *bodies) {
    stickslip_history *history = pressed_history(bodies);
    stickslip_load_step load = {0};
    load.roll.cells = N;
    CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_GRID_TOO_SHORT);
    load.roll.cells = UINT32_MAX;
    CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_GRID_TOO_SHORT);
    load.roll.cells = 0, load.roll.creepage[0] = 0.1;
    CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_NOT_POSITIVE);
    load.roll.cells = 1, load.roll.leading_edge = 4;
    CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_UNKNOWN_OPTION);
    load.roll.leading_edge = 0, load.roll.creepage[0] = NAN;
    CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_NOT_FINITE);
    load.roll.creepage[0] = 0.1, load.x.kind = STICKSLIP_SHIFT, load.x.value = 0.1;
    CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_UNSUPPORTED_BY_MODEL);
    stickslip_step_result result;
    OK(stickslip_history_result(history, &result));
    CHECK(result.steps == 1 && result.force[0] == 0.0);
    OK(stickslip_history_free(history));
}

static void a_solver_takes_new_loads(const stickslip_half_space *bodies, const stickslip_normal_solution *pressed) {
    stickslip_normal_load load = {STICKSLIP_FORCE, 1.0};
    stickslip_friction friction = stickslip_coulomb(FRICTION);
    stickslip_rolling_load creepage = by_creepage(0.02, 0.0, 0.0);
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_solution *light = press(bodies, gap, CELLS, 0.8);
    stickslip_rolling_solver *solver = NULL, *other = NULL;
    stickslip_rolling_solution *solution = NULL;
    double capacity = 0.0, coarse_gap[CELLS / 4];
    size_t warnings = 1;
    stickslip_grid coarse = {N / 2, N / 2, 6.0 / N, 6.0 / N};
    stickslip_half_space *coarse_bodies = NULL;
    stickslip_normal_result of_copy, of_light;
    OK(stickslip_surface_sphere(&coarse, 1.0, coarse_gap, CELLS / 4));
    OK(stickslip_half_space_new(&coarse, &BODY, &BODY, NULL, &coarse_bodies));
    stickslip_normal_solution *copy = press(bodies, gap, CELLS, 0.5), *elsewhere = press(coarse_bodies, coarse_gap, CELLS / 4, 1.0);
    OK(stickslip_normal_solver_new(bodies, gap, CELLS, &load, NULL, NULL, &presser));
    OK(stickslip_rolling_solver_new(bodies, pressed, &friction, &creepage, NULL, &solver));
    OK(stickslip_rolling_solver_new(bodies, light, &friction, &creepage, NULL, &other));
    OK(stickslip_rolling_solution_new(solver, &solution));
    load.value = 0.8;
    CHECK(stickslip_rolling_solver_set_normal_load(solver, &load) == STICKSLIP_UNSUPPORTED_BY_MODEL);
    OK(stickslip_rolling_solver_set_normal_solver(solver, presser));
    CHECK(stickslip_rolling_solver_normal(solver, copy) == STICKSLIP_OUTDATED_SOLUTION);
    CHECK(strstr(stickslip_last_error_message(), "set a normal solver and a normal load first") != NULL);
    OK(stickslip_rolling_solver_set_normal_load(solver, &load));
    OK(stickslip_rolling_solver_normal(solver, copy));
    OK(stickslip_normal_solution_result(copy, &of_copy));
    CLOSE(of_copy.force, 0.8, 1e-6);
    OK(stickslip_normal_solution_result(light, &of_light));
    CLOSE(of_copy.approach, of_light.approach, 1e-6);
    CHECK(stickslip_rolling_solver_normal(solver, elsewhere) == STICKSLIP_GRID_MISMATCH);
    CHECK(stickslip_rolling_solver_normal(solver, NULL) == STICKSLIP_BAD_POINTER);
    OK(stickslip_rolling_solver_friction_capacity(solver, &capacity));
    CLOSE(capacity, 0.8 * FRICTION, 1e-6);
    double expected = solve(other, solution).force[0];
    CLOSE(solve(solver, solution).force[0], expected, 1e-6);
    /* A ball of a few contact radii causes warnings about the pressure that the solver has computed. */
    OK(stickslip_rolling_solution_warnings(solution, NULL, 0, &warnings));
    CHECK(warnings > 0);
    OK(stickslip_rolling_solver_set_normal(other, pressed));
    load.value = 1.0;
    OK(stickslip_rolling_solver_set_normal_load(solver, &load));
    expected = solve(other, solution).force[0];
    CLOSE(solve(solver, solution).force[0], expected, 1e-6);
    CHECK(stickslip_rolling_solver_set_pressure(solver, gap, CELLS) == STICKSLIP_UNSUPPORTED_BY_MODEL);
    OK(stickslip_rolling_solver_set_normal(solver, pressed));
    CHECK(stickslip_rolling_solver_normal(solver, copy) == STICKSLIP_OUTDATED_SOLUTION);
    OK(stickslip_normal_solution_result(copy, &of_copy));
    CLOSE(of_copy.force, 0.8, 1e-6);
    OK(stickslip_normal_solution_free(copy));
    OK(stickslip_normal_solution_free(elsewhere));
    OK(stickslip_half_space_free(coarse_bodies));
    OK(stickslip_rolling_solution_free(solution));
    OK(stickslip_rolling_solver_free(other));
    OK(stickslip_rolling_solver_free(solver));
    OK(stickslip_normal_solver_free(presser));
    OK(stickslip_normal_solution_free(light));
}

int main(void) {
    a_cylinder_is_carter();
    stickslip_grid grid = {N, N, 3.0 / N, 3.0 / N};
    stickslip_half_space *bodies = NULL;
    stickslip_hertz hertz;
    OK(stickslip_surface_sphere(&grid, 1.0, gap, CELLS));
    OK(stickslip_half_space_new(&grid, &BODY, &BODY, NULL, &bodies));
    OK(stickslip_hertz_sphere(bodies, 1.0, 1.0, &hertz));
    stickslip_normal_solution *pressed = press(bodies, gap, CELLS, 1.0);
    stickslip_friction friction = stickslip_coulomb(FRICTION);
    stickslip_rolling_solver *solver = NULL;
    stickslip_rolling_solution *solution = NULL;
    OK(stickslip_rolling_solver_new(bodies, pressed, &friction, NULL, NULL, &solver));
    OK(stickslip_rolling_solution_new(solver, &solution));
    small_creepages_have_the_coefficients_of_kalker(solver, solution, hertz.contact_radius);
    loads_have_the_motions_that_cause_them(solver, solution);
    a_creep_curve_goes_from_nothing_to_sliding(solver);
    creepages_in_per_cent_cause_a_warning(solver);
    what_is_refused_leaves_the_solver(solver, solution);
    friction_changes_and_the_last_answer_is_forgotten(solver, solution);
    long_calls_ask_their_observer(solver);
    options_are_chosen(bodies, pressed);
    a_solver_takes_new_loads(bodies, pressed);
    closed_forms_are_met(bodies, solver);
    histories_that_roll_on_end_in_the_steady_state(bodies, solver, solution);
    histories_roll_to_each_side(bodies);
    steps_that_cannot_roll_leave_the_history(bodies);
    OK(stickslip_rolling_solution_free(solution));
    OK(stickslip_rolling_solver_free(solver));
    OK(stickslip_normal_solution_free(pressed));
    OK(stickslip_half_space_free(bodies));
    return report("rolling");
}
