/* Calls for stresses below the surface, rough surfaces and closed-form solutions. */

#include <math.h>

#include "run.h"

#define POINTS 3

/* Returns one of count constants, starting at first, or rarely an invalid constant. */
static int32_t constant(struct run *run, int32_t first, int32_t count) {
    int32_t chosen = option(run, count);
    return chosen > INT32_MAX - first ? chosen : first + chosen;
}

void below_the_surface(struct run *run) {
    struct slot *bodies = pick(run, BODIES), *planes = pick(run, PLANES);
    const stickslip_half_space *on = GET(stickslip_half_space, bodies);
    size_t at = below(run, 3) == 0 ? bodies->cells : planes->cells, count = at == 0 ? 4 : at, depth_count = 2;
    double *pressure = array(run, &count, 0.2), *depths = array(run, &depth_count, 1.0);
    bool has_shear = below(run, 2) == 0;
    stickslip_tractions tractions = {maybe(run, pressure), has_shear ? maybe(run, pressure) : NULL,
                                     has_shear ? maybe(run, pressure) : NULL, count};
    int32_t body = constant(run, STICKSLIP_BODY_1, 2);
    switch (below(run, 4)) {
    case 0: {
        stickslip_planes *made = NULL;
        SEEN(stickslip_planes_new(on, maybe(run, depths), depth_count, option(run, 2), maybe_out(run, &made)));
        put(run, PLANES, made, bodies->cells);
        break;
    }
    case 1: {
        stickslip_point points[POINTS];
        stickslip_response responses[POINTS];
        for (int i = 0; i < POINTS; i++) {
            points[i] = (stickslip_point){number(run, 1.0), number(run, 1.0), number(run, 1.0)};
        }
        SEEN(stickslip_stress_at_points(on, body, maybe(run, &tractions), maybe(run, points), below(run, POINTS + 1),
                                        maybe_out(run, responses)));
        break;
    }
    case 2: {
        size_t index = rarely(run) ? SIZE_MAX : below(run, 3);
        SEEN(stickslip_planes_solve(GET(stickslip_planes, planes), index, body, maybe(run, &tractions)));
        break;
    }
    default:
        SEEN(stickslip_planes_measure(GET(stickslip_planes, planes), constant(run, STICKSLIP_VON_MISES, 3),
                                      maybe_out(run, pressure), count));
    }
    free(pressure), free(depths);
}

/* Returns zero or NaN, which select the default, or a random value. */
static double left_out(struct run *run, double nothing, double scale) {
    return below(run, 2) == 0 ? nothing : number(run, scale);
}

void forms(struct run *run) {
    const stickslip_half_space *bodies = GET(stickslip_half_space, pick(run, BODIES));
    stickslip_grid grid = {1 + below(run, 12), 1 + below(run, 12), number(run, 1.0), number(run, 1.0)};
    size_t count = grid.nx * grid.ny;
    double *heights = array(run, &count, 0.1);
    stickslip_hertz hertz;
    stickslip_cattaneo_mindlin found;
    stickslip_carter carter;
    stickslip_bentall_johnson free_rolling;
    stickslip_kalker kalker;
    stickslip_vermeulen_johnson curve;
    stickslip_statistics statistics;
    switch (below(run, 9)) {
    case 0:
        SEEN(stickslip_hertz_sphere(bodies, number(run, 5.0), number(run, 1.0), maybe_out(run, &hertz)));
        break;
    case 1:
        SEEN(stickslip_cattaneo_mindlin_sphere(bodies, number(run, 5.0), number(run, 1.0), number(run, 0.5),
                                               number(run, 0.3), maybe_out(run, &found)));
        break;
    case 2:
        SEEN(stickslip_carter_cylinder(bodies, number(run, 5.0), number(run, 1.0), number(run, 0.5), number(run, 1e-2),
                                       maybe_out(run, &carter)));
        break;
    case 3:
        SEEN(stickslip_bentall_johnson_cylinder(bodies, number(run, 5.0), number(run, 1.0), number(run, 0.1),
                                                maybe_out(run, &free_rolling)));
        break;
    case 4:
        SEEN(stickslip_kalker_coefficients(number(run, 4.0), number(run, 0.5), maybe_out(run, &kalker)));
        break;
    case 5:
        SEEN(stickslip_vermeulen_johnson_ellipse(bodies, number(run, 5.0), number(run, 5.0), number(run, 1.0),
                                                 number(run, 0.5), number(run, 1e-2), number(run, 1e-2),
                                                 maybe_out(run, &curve)));
        break;
    case 6:
        SEEN(stickslip_surface_statistics(maybe(run, &grid), maybe(run, heights), count, maybe_out(run, &statistics)));
        break;
    case 7: {
        const struct slot *of = pick(run, BODIES);
        size_t both = 2 * of->cells;
        double *along = array(run, &both, 0.1);
        double *along_x = maybe_out(run, along), *along_y = maybe_out(run, along + both / 2);
        SEEN(stickslip_bulk_strain(GET(stickslip_half_space, of), number(run, 1e-3), number(run, 1e-3), number(run, 1e-3),
                                   along_x, along_y, both / 2));
        free(along);
        break;
    }
    default: {
        stickslip_self_affine recipe = stickslip_self_affine_default();
        bool has_height = below(run, 2) == 0;
        recipe.rms_height = has_height ? number(run, 0.1) : 0.0;
        recipe.rms_slope = has_height && !rarely(run) ? 0.0 : number(run, 0.2);
        recipe.hurst = unit(run), recipe.seed = next(run), recipe.amplitudes = option(run, 2);
        recipe.longest_wavelength = left_out(run, 0.0, 12.0), recipe.roll_off_wavelength = left_out(run, 0.0, 6.0);
        recipe.cut_off_wavelength = left_out(run, 0.0, 4.0), recipe.cropped = option(run, 2);
        if (below(run, 8) == 0) {
            recipe.skewness = left_out(run, NAN, 0.5), recipe.kurtosis = left_out(run, NAN, 4.0);
        }
        SEEN(stickslip_surface_self_affine(maybe(run, &grid), maybe(run, &recipe), maybe_out(run, heights), count));
    }
    }
    free(heights);
}
