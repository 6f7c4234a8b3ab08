/* Calls that create objects. */

#include <math.h>

#include "run.h"

void make_bodies(struct run *run) {
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
    stickslip_boundary boundary = {below(run, 2) == 0 ? STICKSLIP_NON_PERIODIC : option(run, 3), 0.0};
    if (boundary.kind == STICKSLIP_PERIODIC_ALONG_Y || rarely(run)) {
        boundary.datum = number(run, 50.0);
    }
    stickslip_half_space *bodies = NULL;
    SEEN(stickslip_half_space_new(maybe(run, &grid), maybe(run, &one), maybe(run, &two), maybe(run, &boundary),
                                  maybe_out(run, &bodies)));
    put(run, BODIES, bodies, grid.nx * grid.ny);
}

/* Creates or reads an object that requires a half-space. */
void make(struct run *run) {
    struct slot *bodies = pick(run, BODIES), *pressed = pick(run, PRESSED), *history = pick(run, HISTORY);
    size_t cells = bodies->cells == 0 ? 4 : bodies->cells, count = cells, mu_count = cells;
    double *gap = array(run, &count, 0.2), *mu = array(run, &mu_count, 0.5);
    stickslip_friction law = friction(run, mu, mu_count);
    stickslip_normal_load press = normal_load(run);
    stickslip_tangential_load drag = tangential_load(run);
    stickslip_settings set = settings(run);
    stickslip_per_cell hardness = {number(run, 0.05), below(run, 2) == 0 ? mu : NULL, 0};
    hardness.count = hardness.cells == NULL && !rarely(run) ? 0 : mu_count;
    stickslip_relative_displacement relative = {maybe(run, mu), maybe(run, mu), mu_count};
    const stickslip_half_space *on = GET(stickslip_half_space, bodies);
    void *made = NULL;
    switch (below(run, 11)) {
    case 0:
        SEEN(stickslip_normal_solver_new(on, maybe(run, gap), count, maybe(run, &press),
                                         below(run, 4) == 0 ? &hardness : NULL, below(run, 2) == 0 ? &set : NULL,
                                         maybe_out(run, &made)));
        put(run, NORMAL, made, cells);
        break;
    case 1: {
        struct slot *solver = pick(run, NORMAL);
        SEEN(stickslip_normal_solution_new(GET(stickslip_normal_solver, solver), maybe_out(run, &made)));
        put(run, PRESSED, made, solver->cells);
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
        put(run, TANGENTIAL, made, cells);
        break;
    }
    case 3: {
        struct slot *solver = pick(run, TANGENTIAL);
        SEEN(stickslip_tangential_solution_new(GET(stickslip_tangential_solver, solver), maybe_out(run, &made)));
        put(run, SHEARED, made, solver->cells);
        break;
    }
    case 4:
        SEEN(stickslip_coupled_solver_new(on, maybe(run, gap), count, maybe(run, &law), maybe(run, &press),
                                          maybe(run, &drag), below(run, 4) == 0 ? &hardness : NULL,
                                          below(run, 6) == 0 ? &relative : NULL, below(run, 2) == 0 ? &set : NULL, maybe_out(run, &made)));
        put(run, COUPLED, made, cells);
        break;
    case 5: {
        struct slot *solver = pick(run, COUPLED);
        SEEN(stickslip_coupled_solution_new(GET(stickslip_coupled_solver, solver), maybe_out(run, &made)));
        put(run, BOTH, made, solver->cells);
        break;
    }
    case 6: {
        stickslip_history_options options = stickslip_history_options_default();
        options.axis = option(run, 2), options.model = option(run, 2), options.coupling = option(run, 3);
        options.entry_rule = option(run, 2), options.permanent_set = option(run, 2), options.settings = set;
        options.hardness = below(run, 6) == 0 ? &hardness : NULL;
        options.relative_displacement = below(run, 6) == 0 ? &relative : NULL;
        SEEN(stickslip_history_new(on, maybe(run, gap), count, maybe(run, &law),
                                   below(run, 2) == 0 ? &options : NULL, maybe_out(run, &made)));
        put(run, HISTORY, made, cells);
        break;
    }
    case 7:
        SEEN(stickslip_history_clone(GET(stickslip_history, history), maybe_out(run, &made)));
        put(run, HISTORY, made, history->cells);
        break;
    case 8:
        SEEN(stickslip_state_new(GET(stickslip_history, history), maybe_out(run, &made)));
        put(run, STATE, made, history->cells);
        break;
    case 9:
        SEEN(stickslip_adaptive_steps_new(GET(stickslip_history, history), number(run, 0.01), maybe_out(run, &made)));
        put(run, ADAPTIVE, made, history->cells);
        break;
    default:
        SEEN(stickslip_cycle_new(GET(stickslip_history, history), maybe_out(run, &made)));
        put(run, CYCLE, made, history->cells);
    }
    free(gap), free(mu);
}

void rest(struct run *run) {
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
            SEEN(release(kind, slot->object));
            slot->object = NULL;
        }
        break;
    default:
        make_bodies(run);
    }
    free(gap);
}
