/* All calls for steady rolling. */

#include "run.h"

#define POINTS 3

static stickslip_rolling_control control(struct run *run, int32_t load) {
    stickslip_rolling_control control = {below(run, 3) == 0 ? option(run, load + 1) : 0, number(run, 0.01)};
    return control;
}

void roll(struct run *run) {
    struct slot *bodies = pick(run, BODIES), *rolling = pick(run, ROLLING), *rolled = pick(run, ROLLED);
    size_t cells = bodies->cells == 0 ? 4 : bodies->cells, count = cells, limit = below(run, 30);
    double *numbers = array(run, &count, 0.5);
    stickslip_friction law = friction(run, numbers, count);
    stickslip_settings set = settings(run);
    stickslip_rolling_load load = {control(run, STICKSLIP_FORCE), control(run, STICKSLIP_FORCE),
                                   control(run, STICKSLIP_MOMENT)};
    stickslip_observer observer = {watch, &limit};
    stickslip_rolling_solver *solver = GET(stickslip_rolling_solver, rolling);
    stickslip_rolling_solution *solution = GET(stickslip_rolling_solution, rolled);
    void *made = NULL;
    switch (below(run, 15)) {
    case 0:
    case 1: {
        stickslip_rolling_options options = stickslip_rolling_options_default();
        options.leading_edge = option(run, 4), options.entry_rule = option(run, 2), options.settings = set;
        options.step = rarely(run) ? SIZE_MAX >> below(run, 64) : 1 + below(run, 2);
        SEEN(stickslip_rolling_solver_new(GET(stickslip_half_space, bodies),
                                          GET(stickslip_normal_solution, pick(run, PRESSED)), maybe(run, &law),
                                          maybe(run, &load), below(run, 2) == 0 ? &options : NULL,
                                          maybe_out(run, &made)));
        put(run, ROLLING, made, cells);
        break;
    }
    case 2:
        SEEN(stickslip_rolling_solution_new(solver, maybe_out(run, &made)));
        put(run, ROLLED, made, rolling->cells);
        break;
    case 3:
        SEEN(stickslip_rolling_solver_set_load(solver, maybe(run, &load)));
        break;
    case 4:
        SEEN(stickslip_rolling_solver_set_settings(solver, maybe(run, &set)));
        break;
    case 5: {
        stickslip_rolling_stiffness stiffness;
        SEEN(stickslip_rolling_solver_stiffness_observed(solver, below(run, 2) == 0 ? &observer : NULL,
                                                         maybe_out(run, &stiffness)));
        break;
    }
    case 6: {
        stickslip_creep_point points[POINTS];
        stickslip_creep_force forces[POINTS];
        for (int i = 0; i < POINTS; i++) {
            points[i] = (stickslip_creep_point){{number(run, 0.01), number(run, 0.01)}, number(run, 0.01)};
        }
        SEEN(stickslip_rolling_solver_creep_forces_observed(solver, maybe(run, points), below(run, POINTS + 1),
                                                            below(run, 2) == 0 ? &observer : NULL,
                                                            maybe_out(run, forces)));
        break;
    }
    case 7: {
        stickslip_rolling_result result;
        stickslip_report report;
        SEEN(stickslip_rolling_solution_result(solution, maybe_out(run, &result)));
        SEEN(stickslip_rolling_solution_report(solution, maybe_out(run, &report)));
        SEEN(stickslip_rolling_solution_dissipation_per_area(solution, maybe_out(run, numbers), count));
        break;
    }
    case 8:
        SEEN(stickslip_rolling_solver_set_friction(solver, maybe(run, &law)));
        break;
    case 9:
        SEEN(stickslip_rolling_solver_reset(solver));
        break;
    case 10:
        SEEN(stickslip_rolling_solver_set_normal(solver, GET(stickslip_normal_solution, pick(run, PRESSED))));
        SEEN(stickslip_rolling_solver_set_pressure(solver, maybe(run, numbers), count));
        break;
    case 11: {
        stickslip_normal_load pressing = {option(run, 3), number(run, 1.0)};
        SEEN(stickslip_rolling_solver_set_normal_solver(solver, GET(stickslip_normal_solver, pick(run, NORMAL))));
        SEEN(stickslip_rolling_solver_set_normal_load(solver, maybe(run, &pressing)));
        SEEN(stickslip_rolling_solver_normal(solver, GET(stickslip_normal_solution, pick(run, PRESSED))));
        break;
    }
    case 12: {
        stickslip_warning warnings[POINTS];
        double capacity;
        size_t found;
        SEEN(stickslip_rolling_solver_friction_capacity(solver, maybe_out(run, &capacity)));
        SEEN(stickslip_rolling_solution_warnings(solution, warnings, below(run, POINTS + 1), maybe_out(run, &found)));
        SEEN(stickslip_rolling_solver_creep_warnings(solver, warnings, below(run, POINTS + 1), maybe_out(run, &found)));
        break;
    }
    default:
        SEEN(stickslip_rolling_solver_solve(solver, solution, below(run, 4) == 0 ? maybe(run, &observer) : NULL));
    }
    free(numbers);
}
