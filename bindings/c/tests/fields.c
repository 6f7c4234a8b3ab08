/* Messages for fields that an object does not have, and the relative displacement due to a bulk strain. */

#include <math.h>
#include <string.h>

#include "check.h"

#define N 16
#define CELLS (N * N)
/* A steel ball on steel, in N and mm. */
#define RADIUS 5.0
#define FORCE 100.0

static const stickslip_grid GRID = {N, N, 0.4 / N, 0.4 / N};
static const stickslip_material STEEL = {210e3, 0.3, 0.0};
static double ball[CELLS], values[CELLS], along_x[CELLS], along_y[CELLS];
static stickslip_half_space *bodies;

/* Requires a failure with a value, and a message with a part. */
static void message_names(double value, const char *part, int line) {
    stickslip_error error;
    OK(stickslip_last_error(&error));
    if (error.code != STICKSLIP_UNKNOWN_OPTION || error.value != value || !strstr(stickslip_last_error_message(), part)) {
        fprintf(stderr, "line %d: code %d, value %g: %s\n", line, (int)error.code, error.value,
                stickslip_last_error_message());
        failures++;
    }
}

/* Requires that a field does not exist, and that the message names the remedy. */
#define NONE(read, object, which, part)                                                                                \
    do {                                                                                                               \
        CHECK(read(object, which, NULL) == NULL);                                                                      \
        message_names(which, part, __LINE__);                                                                          \
    } while (0)

static void solutions_name_their_fields(void) {
    stickslip_normal_load load = {STICKSLIP_FORCE, FORCE};
    stickslip_tangential_load drag = {{STICKSLIP_FORCE, 10.0, 0.0}, {0}, 0.0};
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_solution *pressed = NULL;
    stickslip_tangential_solver *shearer = NULL;
    stickslip_tangential_solution *sheared = NULL;
    stickslip_coupled_solver *coupler = NULL;
    stickslip_coupled_solution *coupled = NULL;
    stickslip_rolling_solver *roller = NULL;
    stickslip_rolling_solution *rolled = NULL;
    stickslip_coupled_rolling_solver *slider = NULL;
    stickslip_coupled_rolling_solution *slid = NULL;
    OK(stickslip_normal_solver_new(bodies, ball, CELLS, &load, NULL, NULL, &presser));
    OK(stickslip_normal_solution_new(presser, &pressed));
    OK(stickslip_normal_solver_solve(presser, pressed, NULL));
    NONE(stickslip_normal_solution_field, pressed, STICKSLIP_TRACTION_X, "field of a normal solution: use STICKSLIP_PRESSURE");
    OK(stickslip_tangential_solver_new(bodies, pressed, &friction, &drag, NULL, &shearer));
    OK(stickslip_tangential_solution_new(shearer, &sheared));
    NONE(stickslip_tangential_solution_field, sheared, STICKSLIP_PRESSURE,
         "field of a tangential solution: use STICKSLIP_TRACTION_X");
    OK(stickslip_coupled_solver_new(bodies, ball, CELLS, &friction, &load, &drag, NULL, NULL, NULL, &coupler));
    OK(stickslip_coupled_solution_new(coupler, &coupled));
    CHECK(stickslip_coupled_solution_field(coupled, STICKSLIP_SLIP_Y, NULL) != NULL);
    NONE(stickslip_coupled_solution_field, coupled, STICKSLIP_SLIP_DISTANCE,
         "field of a coupled solution: use STICKSLIP_PRESSURE to STICKSLIP_DISPLACEMENT_Z");
    OK(stickslip_rolling_solver_new(bodies, pressed, &friction, NULL, NULL, &roller));
    OK(stickslip_rolling_solution_new(roller, &rolled));
    NONE(stickslip_rolling_solution_field, rolled, STICKSLIP_GAP, "field of a rolling solution: use STICKSLIP_TRACTION_X");
    OK(stickslip_coupled_rolling_solver_new(bodies, ball, CELLS, &friction, &load, NULL, NULL, &slider));
    OK(stickslip_coupled_rolling_solution_new(slider, &slid));
    CHECK(stickslip_coupled_rolling_solution_field(slid, STICKSLIP_SLIP_Y, NULL) != NULL);
    NONE(stickslip_coupled_rolling_solution_field, slid, STICKSLIP_DISPLACEMENT_X,
         "field of a coupled rolling solution: use STICKSLIP_PRESSURE to STICKSLIP_SLIP_Y");
    OK(stickslip_coupled_rolling_solution_free(slid));
    OK(stickslip_coupled_rolling_solver_free(slider));
    OK(stickslip_rolling_solution_free(rolled));
    OK(stickslip_rolling_solver_free(roller));
    OK(stickslip_coupled_solution_free(coupled));
    OK(stickslip_coupled_solver_free(coupler));
    OK(stickslip_tangential_solution_free(sheared));
    OK(stickslip_tangential_solver_free(shearer));
    OK(stickslip_normal_solution_free(pressed));
    OK(stickslip_normal_solver_free(presser));
}

static void histories_name_their_fields_and_options(void) {
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_history_options options = stickslip_history_options_default();
    stickslip_per_cell hardness = {1e6, NULL, 0};
    stickslip_history *history = NULL;
    stickslip_cycle *cycle = NULL;
    OK(stickslip_history_new(bodies, ball, CELLS, &friction, NULL, &history));
    NONE(stickslip_history_field, history, STICKSLIP_STRESS_XX, "field of a history: use STICKSLIP_PRESSURE to");
    NONE(stickslip_history_field, history, STICKSLIP_YIELDED_DEPTH, "with the options hardness and permanent_set");
    OK(stickslip_cycle_new(history, &cycle));
    NONE(stickslip_cycle_field, cycle, STICKSLIP_PRESSURE, "field of a cycle: use STICKSLIP_SLIP_DISTANCE");
    OK(stickslip_cycle_free(cycle));
    OK(stickslip_history_free(history));
    options.hardness = &hardness, options.permanent_set = 1;
    OK(stickslip_history_new(bodies, ball, CELLS, &friction, &options, &history));
    CHECK(stickslip_history_field(history, STICKSLIP_YIELDED_DEPTH, NULL) != NULL);
    OK(stickslip_history_free(history));
}

static void planes_name_their_fields_and_depths(void) {
    stickslip_tractions tractions = {ball, NULL, NULL, CELLS};
    stickslip_planes *planes = NULL;
    stickslip_error error;
    double depths[] = {0.1, 0.2};
    OK(stickslip_planes_new(bodies, depths, 2, 0, &planes));
    OK(stickslip_planes_solve(planes, 0, STICKSLIP_BODY_1, &tractions));
    NONE(stickslip_planes_field, planes, STICKSLIP_DISPLACEMENT_Z, "create the planes with with_displacements");
    NONE(stickslip_planes_field, planes, STICKSLIP_PRESSURE, "field of planes: use STICKSLIP_STRESS_XX to");
    NONE(stickslip_planes_field, planes, STICKSLIP_VON_MISES, "use the function measure of planes");
    CHECK(stickslip_planes_measure(planes, STICKSLIP_STRESS_XX, values, CELLS) == STICKSLIP_UNKNOWN_OPTION);
    message_names(STICKSLIP_STRESS_XX, "measure of planes: use STICKSLIP_VON_MISES", __LINE__);
    CHECK(stickslip_planes_solve(planes, 2, STICKSLIP_BODY_1, &tractions) == STICKSLIP_LENGTH);
    CHECK(strstr(stickslip_last_error_message(), "no depth has the index 2, counted from zero: use 0 to 1") != NULL);
    OK(stickslip_last_error(&error));
    CHECK(error.index == 2 && error.expected == 3 && error.found == 2);
    OK(stickslip_planes_free(planes));
    OK(stickslip_planes_new(bodies, NULL, 0, 0, &planes));
    CHECK(stickslip_planes_solve(planes, 0, STICKSLIP_BODY_1, &tractions) == STICKSLIP_LENGTH);
    CHECK(strstr(stickslip_last_error_message(), "create them with at least one depth") != NULL);
    OK(stickslip_planes_free(planes));
}

static void missing_heights_have_a_remedy(void) {
    stickslip_statistics statistics;
    for (int i = 0; i < CELLS; i++) {
        values[i] = NAN;
    }
    CHECK(stickslip_surface_statistics(&GRID, values, CELLS, &statistics) == STICKSLIP_INVALID_ARGUMENT);
    CHECK(strstr(stickslip_last_error_message(), "all points are missing (NaN): check the source of the data") != NULL);
}

static void a_bulk_strain_is_linear_in_the_position(void) {
    double xx = 1e-3, xy = 2e-4, yy = -5e-4;
    OK(stickslip_bulk_strain(bodies, xx, xy, yy, along_x, along_y, CELLS));
    for (int i = 0; i < CELLS; i++) {
        double x = GRID.dx * (i % N - 0.5 * (N - 1)), y = GRID.dy * (i / N - 0.5 * (N - 1));
        CHECK(fabs(along_x[i] - (xx * x + xy * y)) < 1e-18 && fabs(along_y[i] - (xy * x + yy * y)) < 1e-18);
    }
    /* The strain stretches body 1 against friction, which causes slip at the edge without a force. */
    stickslip_relative_displacement stretch = {along_x, along_y, CELLS};
    stickslip_friction friction = stickslip_coulomb(0.1);
    stickslip_history_options options = stickslip_history_options_default();
    stickslip_history *history = NULL;
    stickslip_step_result result;
    stickslip_load_step load = {{STICKSLIP_FORCE, FORCE}, {0}, {0}, 0, 0.0, 0, 0.0};
    options.model = STICKSLIP_VECTOR, options.relative_displacement = &stretch;
    OK(stickslip_history_new(bodies, ball, CELLS, &friction, &options, &history));
    OK(stickslip_history_step(history, &load, NULL));
    load.has_relative_displacement = 1, load.relative_displacement = 1.0;
    OK(stickslip_history_step(history, &load, NULL));
    OK(stickslip_history_result(history, &result));
    CHECK(fabs(result.force[0]) < 1e-6 * FORCE && result.energy.dissipated_energy > 0.0);
    OK(stickslip_history_free(history));
}

static void invalid_bulk_strains_leave_the_arrays_unchanged(void) {
    static const char *const names[] = {"bulk strain xx", "bulk strain xy", "bulk strain yy"};
    stickslip_boundary periodic = {STICKSLIP_PERIODIC, 0.0}, along = {STICKSLIP_PERIODIC_ALONG_Y, 100.0};
    stickslip_half_space *closed = NULL, *strip = NULL;
    stickslip_error error;
    OK(stickslip_half_space_new(&GRID, &STEEL, &STEEL, &periodic, &closed));
    OK(stickslip_half_space_new(&GRID, &STEEL, &STEEL, &along, &strip));
    for (int i = 0; i < 3; i++) {
        double part[3] = {0.0, 0.0, 0.0};
        part[i] = INFINITY;
        CHECK(stickslip_bulk_strain(bodies, part[0], part[1], part[2], values, values, CELLS) == STICKSLIP_NOT_FINITE);
        CHECK(strstr(stickslip_last_error_message(), names[i]) != NULL);
        part[i] = 1e-3;
        along_x[0] = along_y[0] = 7.0;
        CHECK(stickslip_bulk_strain(closed, part[0], part[1], part[2], along_x, along_y, CELLS) ==
              STICKSLIP_INVALID_ARGUMENT);
        OK(stickslip_last_error(&error));
        CHECK(error.value == 1e-3 && strstr(stickslip_last_error_message(), names[i]) != NULL);
        CHECK(along_x[0] == 7.0 && along_y[0] == 7.0);
        CHECK(stickslip_bulk_strain(strip, part[0], part[1], part[2], along_x, along_y, CELLS) ==
              (i == 0 ? STICKSLIP_OK : STICKSLIP_INVALID_ARGUMENT));
    }
    CHECK(stickslip_bulk_strain(bodies, 0.0, 0.0, 0.0, along_x, along_y, CELLS - 1) == STICKSLIP_LENGTH);
    CHECK(stickslip_bulk_strain(bodies, 0.0, 0.0, 0.0, along_x, NULL, CELLS) == STICKSLIP_BAD_POINTER);
    CHECK(stickslip_bulk_strain(NULL, 0.0, 0.0, 0.0, along_x, along_y, CELLS) == STICKSLIP_BAD_POINTER);
    OK(stickslip_half_space_free(strip));
    OK(stickslip_half_space_free(closed));
}

int main(void) {
    OK(stickslip_half_space_new(&GRID, &STEEL, &STEEL, NULL, &bodies));
    OK(stickslip_surface_sphere(&GRID, RADIUS, ball, CELLS));
    solutions_name_their_fields();
    histories_name_their_fields_and_options();
    planes_name_their_fields_and_depths();
    missing_heights_have_a_remedy();
    a_bulk_strain_is_linear_in_the_position();
    invalid_bulk_strains_leave_the_arrays_unchanged();
    OK(stickslip_half_space_free(bodies));
    return report("fields and bulk strain");
}
