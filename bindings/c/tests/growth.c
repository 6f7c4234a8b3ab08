/* Structs grow without a change of their sizes. A new member replaces reserved bytes, and a library that does not support
 * the member rejects a nonzero value instead of ignoring it. A change of a number here requires a new
 * STICKSLIP_ABI_VERSION. */

#include <stdlib.h>
#include <string.h>

#include "check.h"

#define SIZE(name, bytes) CHECK(sizeof(name) == (bytes))

static void sizes_stay(void) {
    SIZE(stickslip_normal_load, 16);
    SIZE(stickslip_control, 24);
    SIZE(stickslip_load_step, 160);
    SIZE(stickslip_roll, 32);
    SIZE(stickslip_step_error, 112);
    SIZE(stickslip_hertz, 88);
    SIZE(stickslip_cattaneo_mindlin, 176);
    SIZE(stickslip_per_cell, 24);
    SIZE(stickslip_friction, 96);
    SIZE(stickslip_tangential_load, 120);
    SIZE(stickslip_relative_displacement, 24);
    SIZE(stickslip_settings, 96);
    SIZE(stickslip_iteration, 104);
    SIZE(stickslip_observer, 16);
    SIZE(stickslip_normal_result, 152);
    SIZE(stickslip_tangential_result, 152);
    SIZE(stickslip_report, 136);
    SIZE(stickslip_coupled_report, 248);
    SIZE(stickslip_warning, 472);
    SIZE(stickslip_energy, 128);
    SIZE(stickslip_cycle_result, 272);
    SIZE(stickslip_error, 80);
    SIZE(stickslip_grid, 32);
    SIZE(stickslip_material, 24);
    SIZE(stickslip_boundary, 16);
    SIZE(stickslip_pair, 96);
    SIZE(stickslip_history_options, 200);
    SIZE(stickslip_normal_stiffness, 80);
    SIZE(stickslip_tangential_stiffness, 216);
    SIZE(stickslip_stiffness, 384);
    SIZE(stickslip_stiffness_options, 80);
    SIZE(stickslip_step_result, 280);
    SIZE(stickslip_tractions, 32);
    SIZE(stickslip_self_affine, 144);
    SIZE(stickslip_statistics, 144);
    SIZE(stickslip_point, 24);
    SIZE(stickslip_response, 104);
    SIZE(stickslip_tangential_options, 176);
    SIZE(stickslip_rolling_control, 16);
    SIZE(stickslip_rolling_load, 112);
    SIZE(stickslip_rolling_options, 176);
    SIZE(stickslip_rolling_stiffness, 136);
    SIZE(stickslip_rolling_result, 128);
    SIZE(stickslip_creep_point, 24);
    SIZE(stickslip_creep_force, 32);
    SIZE(stickslip_carter, 104);
    SIZE(stickslip_bentall_johnson, 104);
    SIZE(stickslip_kalker, 96);
    SIZE(stickslip_vermeulen_johnson, 208);
    SIZE(stickslip_jump_limits, 88);
    SIZE(stickslip_spot, 136);
}

#define N 8
#define CELLS (N * N)

/* Requires that a call zeroes the reserved bytes of a struct that was filled with garbage. */
#define READS(type, call)                                                                                              \
    do {                                                                                                               \
        static const unsigned char zeros[sizeof ((type *)0)->reserved];                                                \
        type found;                                                                                                    \
        memset(&found, 0xa5, sizeof found);                                                                            \
        OK(call);                                                                                                      \
        CHECK(memcmp(found.reserved, zeros, sizeof zeros) == 0);                                                       \
    } while (0)

static void unknown_members_are_refused(void) {
    stickslip_grid grid = {N, N, 0.3e-3 / N, 0.3e-3 / N};
    stickslip_material steel = {213e9, 0.29, 0.0};
    stickslip_half_space *bodies = NULL;
    stickslip_normal_solver *solver = NULL;
    stickslip_history *history = NULL, *none = NULL;
    double ball[CELLS];
    OK(stickslip_surface_sphere(&grid, 3.5e-3, ball, CELLS));
    OK(stickslip_half_space_new(&grid, &steel, &steel, NULL, &bodies));
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_history_options options = stickslip_history_options_default();
    OK(stickslip_history_new(bodies, ball, CELLS, &friction, &options, &history));

    options.reserved[7] = 1;
    CHECK(stickslip_history_new(bodies, ball, CELLS, &friction, &options, &none) == STICKSLIP_UNKNOWN_OPTION);
    CHECK(strstr(stickslip_last_error_message(), "reserved of the options") != NULL);
    options.reserved[7] = 0, options.settings.reserved[0] = 1;
    CHECK(stickslip_history_new(bodies, ball, CELLS, &friction, &options, &none) == STICKSLIP_UNKNOWN_OPTION);
    CHECK(stickslip_history_set_settings(history, &options.settings) == STICKSLIP_UNKNOWN_OPTION);
    friction.reserved[3] = 1;
    CHECK(stickslip_history_set_friction(history, &friction) == STICKSLIP_UNKNOWN_OPTION);
    stickslip_load_step load = {0};
    load.normal.kind = STICKSLIP_FORCE, load.normal.value = 100.0, load.reserved[0] = 1;
    CHECK(stickslip_history_step(history, &load, NULL) == STICKSLIP_UNKNOWN_OPTION);
    load.reserved[0] = 0;
    OK(stickslip_history_step(history, &load, NULL));

    stickslip_normal_load press = {STICKSLIP_FORCE, 100.0};
    stickslip_normal_solution *pressed = NULL;
    OK(stickslip_normal_solver_new(bodies, ball, CELLS, &press, NULL, NULL, &solver));
    OK(stickslip_normal_solution_new(solver, &pressed));
    OK(stickslip_normal_solver_solve(solver, pressed, NULL));
    stickslip_tangential_solver *shearer = NULL;
    stickslip_tangential_load drag = {{STICKSLIP_FORCE, 20.0, 0.0}, {0}, 0.0};
    stickslip_tangential_options choices = stickslip_tangential_options_default();
    friction = stickslip_coulomb(0.5);
    choices.reserved[1] = 1;
    CHECK(stickslip_tangential_solver_new(bodies, pressed, &friction, &drag, &choices, &shearer) ==
          STICKSLIP_UNKNOWN_OPTION);
    drag.reserved[1] = 1;
    CHECK(stickslip_tangential_solver_new(bodies, pressed, &friction, &drag, NULL, &shearer) == STICKSLIP_UNKNOWN_OPTION);
    stickslip_self_affine surface = stickslip_self_affine_default();
    surface.rms_height = 1e-6, surface.reserved[2] = 1;
    CHECK(stickslip_surface_self_affine(&grid, &surface, ball, CELLS) == STICKSLIP_UNKNOWN_OPTION);
    CHECK(none == NULL && shearer == NULL);

    READS(stickslip_pair, stickslip_half_space_pair(bodies, &found));
    READS(stickslip_hertz, stickslip_hertz_sphere(bodies, 3.5e-3, 100.0, &found));
    READS(stickslip_bentall_johnson, stickslip_bentall_johnson_cylinder(bodies, 1.0, 1.0, 0.1, &found));
    READS(stickslip_kalker, stickslip_kalker_coefficients(1.0, 0.25, &found));
    READS(stickslip_vermeulen_johnson,
          stickslip_vermeulen_johnson_ellipse(bodies, 1.0, 1.0, 1.0, 0.1, 1e-3, 0.0, &found));
    READS(stickslip_normal_result, stickslip_normal_solution_result(pressed, &found));
    READS(stickslip_report, stickslip_normal_solution_report(pressed, &found));
    READS(stickslip_normal_stiffness, stickslip_normal_solution_stiffness(pressed, bodies, &found));
    READS(stickslip_step_result, stickslip_history_result(history, &found));
    READS(stickslip_stiffness, stickslip_history_stiffness(history, &found));
    READS(stickslip_error, stickslip_last_error(&found));
    OK(stickslip_normal_solution_free(pressed));
    OK(stickslip_normal_solver_free(solver));
    OK(stickslip_history_free(history));
    OK(stickslip_half_space_free(bodies));
}

int main(void) {
    sizes_stay();
    unknown_members_are_refused();
    return report("sizes of structs");
}
