/* Rough surfaces have the requested height or slope and are reproducible from their seed. */

#include <math.h>
#include <string.h>

#include "check.h"

#define N 64
#define CELLS (N * N)

static const stickslip_grid GRID = {N, N, 1.0 / N, 1.0 / N};
static double heights[CELLS], again[CELLS], gap[CELLS];

static void surfaces_are_as_asked_for(void) {
    stickslip_self_affine recipe = stickslip_self_affine_default();
    stickslip_statistics statistics;
    recipe.rms_height = 0.01;
    OK(stickslip_surface_self_affine(&GRID, &recipe, heights, CELLS));
    OK(stickslip_surface_statistics(&GRID, heights, CELLS, &statistics));
    CLOSE(statistics.rms_height, 0.01, 1e-12);
    CHECK(fabs(statistics.mean_height) < 1e-15);
    CHECK(statistics.highest_peak > 0.01 && statistics.deepest_valley > 0.01);
    OK(stickslip_surface_self_affine(&GRID, &recipe, again, CELLS));
    CHECK(memcmp(heights, again, sizeof heights) == 0);
    recipe.seed = 1;
    OK(stickslip_surface_self_affine(&GRID, &recipe, again, CELLS));
    CHECK(memcmp(heights, again, sizeof heights) != 0);

    recipe.rms_height = 0.0, recipe.rms_slope = 0.2;
    recipe.hurst = 0.7, recipe.roll_off_wavelength = 0.5, recipe.cut_off_wavelength = 0.2, recipe.kurtosis = 4.0;
    OK(stickslip_surface_self_affine(&GRID, &recipe, heights, CELLS));
    OK(stickslip_surface_statistics(&GRID, heights, CELLS, &statistics));
    CLOSE(statistics.spectral_rms_slope, 0.2, 1e-9);
    CLOSE(statistics.kurtosis, 4.0, 1e-6);
    CHECK(fabs(statistics.skewness) < 1e-6);
    CHECK(statistics.finite_difference_rms_slope < 0.2);
    CLOSE(statistics.developed_area_ratio, 0.02, 0.2);
}

static void bad_recipes_are_refused(void) {
    stickslip_self_affine recipe = stickslip_self_affine_default();
    stickslip_statistics statistics;
    memcpy(again, heights, sizeof again);
    CHECK(stickslip_surface_self_affine(&GRID, &recipe, heights, CELLS) == STICKSLIP_NOT_POSITIVE);
    recipe.rms_height = 0.01, recipe.rms_slope = 0.2;
    CHECK(stickslip_surface_self_affine(&GRID, &recipe, heights, CELLS) == STICKSLIP_INVALID_ARGUMENT);
    recipe.rms_slope = 0.0, recipe.hurst = 1.5;
    CHECK(stickslip_surface_self_affine(&GRID, &recipe, heights, CELLS) == STICKSLIP_HURST);
    recipe.hurst = 0.8, recipe.longest_wavelength = 0.9, recipe.cut_off_wavelength = 0.8;
    CHECK(stickslip_surface_self_affine(&GRID, &recipe, heights, CELLS) == STICKSLIP_NO_WAVE_IN_BAND);
    recipe.longest_wavelength = 0.0, recipe.cut_off_wavelength = 0.0, recipe.amplitudes = 2;
    CHECK(stickslip_surface_self_affine(&GRID, &recipe, heights, CELLS) == STICKSLIP_UNKNOWN_OPTION);
    recipe.amplitudes = STICKSLIP_GAUSSIAN;
    CHECK(stickslip_surface_self_affine(&GRID, &recipe, heights, CELLS - 1) == STICKSLIP_LENGTH);
    CHECK(memcmp(heights, again, sizeof heights) == 0);
    heights[5] = INFINITY;
    CHECK(stickslip_surface_statistics(&GRID, heights, CELLS, &statistics) == STICKSLIP_SAMPLE);
    heights[5] = NAN;
    CHECK(stickslip_surface_statistics(&GRID, heights, CELLS, &statistics) == STICKSLIP_OK);
    heights[5] = again[5];
}

/* Against a plane the real contact area is a small fraction of the square, and grows proportionally to the load. */
static void rough_contacts_grow_in_proportion(void) {
    stickslip_material elastic = {1.0, 0.0, 0.0}, rigid = {INFINITY, 0.0, 0.0};
    stickslip_boundary periodic = {STICKSLIP_PERIODIC, 0.0};
    stickslip_half_space *bodies = NULL;
    stickslip_normal_solver *solver = NULL;
    stickslip_normal_solution *solution = NULL;
    stickslip_normal_result one, two;
    for (int i = 0; i < CELLS; i++) {
        gap[i] = -heights[i];
    }
    stickslip_normal_load load = {STICKSLIP_FORCE, 0.003};
    OK(stickslip_half_space_new(&GRID, &elastic, &rigid, &periodic, &bodies));
    OK(stickslip_normal_solver_new(bodies, gap, CELLS, &load, NULL, NULL, &solver));
    OK(stickslip_normal_solution_new(solver, &solution));
    OK(stickslip_normal_solver_solve(solver, solution, NULL));
    OK(stickslip_normal_solution_result(solution, &one));
    load.value = 0.006;
    OK(stickslip_normal_solver_set_load(solver, &load));
    OK(stickslip_normal_solver_solve(solver, solution, NULL));
    OK(stickslip_normal_solution_result(solution, &two));
    CHECK(one.contact_area > 0.01 && one.contact_area < 0.1);
    CLOSE(two.contact_area, 2.0 * one.contact_area, 0.15);
    OK(stickslip_normal_solution_free(solution));
    OK(stickslip_normal_solver_free(solver));
    OK(stickslip_half_space_free(bodies));
}

int main(void) {
    surfaces_are_as_asked_for();
    bad_recipes_are_refused();
    rough_contacts_grow_in_proportion();
    return report("rough surfaces");
}
