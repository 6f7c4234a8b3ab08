/* Stiffnesses with and without a workspace agree, for each option and for several histories. */

#include <math.h>
#include <string.h>

#include "check.h"

#define N 24
#define CELLS (N * N)

static const stickslip_grid GRID = {N, N, 0.3e-3 / N, 0.3e-3 / N};
static const stickslip_material STEEL = {213e9, 0.29, 0.0}, RIGID = {INFINITY, 0.0, 0.0};
static double ball[CELLS];

static int32_t stop(const stickslip_iteration *iteration, void *user) {
    (void)iteration;
    (void)user;
    return 0;
}

static stickslip_history *sheared(const stickslip_half_space *bodies) {
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_history *history = NULL;
    OK(stickslip_history_new(bodies, ball, CELLS, &friction, NULL, &history));
    stickslip_load_step load = {{STICKSLIP_FORCE, 100.0}, {STICKSLIP_FORCE, 20.0, 0.0}, {0}, 0, 0.0, 0, 0.0};
    OK(stickslip_history_step(history, &load, NULL));
    return history;
}

static void options_apply(const stickslip_history *history) {
    stickslip_stiffness_options options = stickslip_stiffness_options_default();
    stickslip_stiffness_workspace *workspace = NULL;
    stickslip_stiffness found, expected;
    stickslip_report report, coarse;
    OK(stickslip_stiffness_workspace_new(NULL, &workspace));
    OK(stickslip_stiffness_workspace_report(workspace, &report));
    CHECK(report.status == STICKSLIP_UNSOLVED);
    for (int i = 0; i < 2; i++) {
        OK(stickslip_history_stiffness_with(history, workspace, NULL, &found));
        OK(stickslip_history_stiffness(history, &expected));
        CHECK(memcmp(&found, &expected, sizeof found) == 0);
    }
    OK(stickslip_stiffness_workspace_report(workspace, &report));
    CHECK(report.status == STICKSLIP_CONVERGED && report.residual <= options.tolerance && report.iterations > 0);

    options.next_step = 1;
    OK(stickslip_stiffness_workspace_set_options(workspace, &options));
    OK(stickslip_history_stiffness_with(history, workspace, NULL, &found));
    OK(stickslip_history_next_stiffness(history, NULL, &expected));
    CHECK(memcmp(&found, &expected, sizeof found) == 0);

    options.next_step = options.reversal = 0;
    options.tolerance = 1e-3;
    OK(stickslip_stiffness_workspace_set_options(workspace, &options));
    OK(stickslip_history_stiffness_with(history, workspace, NULL, &found));
    OK(stickslip_history_stiffness(history, &expected));
    CHECK(isnan(found.tangential.reversal[0][0]) && !isnan(expected.tangential.reversal[0][0]));
    CLOSE(found.tangential.loading[0][0], expected.tangential.loading[0][0], 1e-4);
    OK(stickslip_stiffness_workspace_report(workspace, &coarse));
    CHECK(coarse.iterations < report.iterations && coarse.residual <= 1e-3);

    /* A failure leaves the options and the result unchanged. */
    options.tolerance = 1.0;
    CHECK(stickslip_stiffness_workspace_set_options(workspace, &options) == STICKSLIP_TOLERANCE);
    CHECK(stickslip_stiffness_workspace_set_options(workspace, NULL) == STICKSLIP_BAD_POINTER);
    stickslip_stiffness_workspace *other = NULL;
    CHECK(stickslip_stiffness_workspace_new(&options, &other) == STICKSLIP_TOLERANCE && other == NULL);
    options.tolerance = 1e-11, options.reserved[0] = 1;
    CHECK(stickslip_stiffness_workspace_set_options(workspace, &options) == STICKSLIP_UNKNOWN_OPTION);
    stickslip_observer observer = {stop, NULL};
    stickslip_stiffness kept = found;
    CHECK(stickslip_history_stiffness_with(history, workspace, &observer, &found) == STICKSLIP_NOT_CONVERGED);
    CHECK(stickslip_history_stiffness_with(history, NULL, NULL, &found) == STICKSLIP_BAD_POINTER);
    CHECK(memcmp(&found, &kept, sizeof found) == 0);
    OK(stickslip_history_stiffness_with(history, workspace, NULL, &found));
    CHECK(isnan(found.tangential.reversal[0][0]) && found.normal.value == kept.normal.value);
    OK(stickslip_stiffness_workspace_free(workspace));
    OK(stickslip_stiffness_workspace_free(NULL));
}

static void histories_share_a_workspace(const stickslip_history *first, const stickslip_history *second) {
    stickslip_stiffness_workspace *workspace = NULL;
    OK(stickslip_stiffness_workspace_new(NULL, &workspace));
    for (int i = 0; i < 4; i++) {
        const stickslip_history *history = i % 2 == 0 ? first : second;
        stickslip_stiffness found, expected;
        OK(stickslip_history_stiffness_with(history, workspace, NULL, &found));
        OK(stickslip_history_stiffness(history, &expected));
        CHECK(memcmp(&found, &expected, sizeof found) == 0);
    }
    OK(stickslip_stiffness_workspace_free(workspace));
}

int main(void) {
    stickslip_half_space *steel = NULL, *dissimilar = NULL;
    OK(stickslip_half_space_new(&GRID, &STEEL, &STEEL, NULL, &steel));
    OK(stickslip_half_space_new(&GRID, &STEEL, &RIGID, NULL, &dissimilar));
    OK(stickslip_surface_sphere(&GRID, 3.5e-3, ball, CELLS));
    stickslip_history *history = sheared(steel), *coupled = sheared(dissimilar);
    options_apply(history);
    histories_share_a_workspace(history, coupled);
    OK(stickslip_history_free(history));
    OK(stickslip_history_free(coupled));
    OK(stickslip_half_space_free(steel));
    OK(stickslip_half_space_free(dissimilar));
    return report("stiffness workspace");
}
