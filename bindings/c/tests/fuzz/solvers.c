/* Solves, and calls that change a solver. */

#include "run.h"

void solve(struct run *run) {
    size_t limit = below(run, 30);
    stickslip_observer observer = {watch, &limit};
    const stickslip_observer *watching = below(run, 4) == 0 ? maybe(run, &observer) : NULL;
    switch (below(run, 3)) {
    case 0:
        SEEN(stickslip_normal_solver_solve(GET(stickslip_normal_solver, pick(run, NORMAL)),
                                           GET(stickslip_normal_solution, pick(run, PRESSED)), watching));
        break;
    case 1:
        SEEN(stickslip_tangential_solver_solve(GET(stickslip_tangential_solver, pick(run, TANGENTIAL)),
                                               GET(stickslip_tangential_solution, pick(run, SHEARED)), watching));
        break;
    default:
        SEEN(stickslip_coupled_solver_solve(GET(stickslip_coupled_solver, pick(run, COUPLED)),
                                            GET(stickslip_coupled_solution, pick(run, BOTH)), watching));
    }
}

void change_solver(struct run *run) {
    struct slot *normal = pick(run, NORMAL), *tangential = pick(run, TANGENTIAL), *coupled = pick(run, COUPLED);
    size_t count = coupled->cells == 0 ? 4 : coupled->cells;
    double *numbers = array(run, &count, 0.2);
    stickslip_friction law = friction(run, numbers, count);
    stickslip_settings set = settings(run);
    stickslip_normal_load press = normal_load(run);
    stickslip_tangential_load drag = tangential_load(run);
    stickslip_relative_displacement pattern = {numbers, numbers, count};
    stickslip_normal_solver *presser = GET(stickslip_normal_solver, normal);
    stickslip_tangential_solver *shearer = GET(stickslip_tangential_solver, tangential);
    stickslip_coupled_solver *solver = GET(stickslip_coupled_solver, coupled);
    switch (below(run, 17)) {
    case 0:
        SEEN(stickslip_normal_solver_set_load(presser, maybe(run, &press)));
        break;
    case 1:
        SEEN(stickslip_normal_solver_set_gap(presser, maybe(run, numbers), count));
        break;
    case 2:
        SEEN(stickslip_normal_solver_set_settings(presser, maybe(run, &set)));
        break;
    case 3:
        SEEN(stickslip_normal_solver_reset(presser));
        break;
    case 4:
        SEEN(stickslip_tangential_solver_set_load(shearer, maybe(run, &drag)));
        break;
    case 5:
        SEEN(stickslip_tangential_solver_set_friction(shearer, maybe(run, &law)));
        break;
    case 6:
        SEEN(stickslip_tangential_solver_set_normal(shearer, GET(stickslip_normal_solution, pick(run, PRESSED))));
        break;
    case 7:
        SEEN(stickslip_tangential_solver_set_pressure(shearer, maybe(run, numbers), count));
        break;
    case 8:
        SEEN(stickslip_tangential_solver_set_relative_displacement(shearer, maybe(run, &pattern)));
        break;
    case 9:
        SEEN(stickslip_tangential_solver_set_settings(shearer, maybe(run, &set)));
        break;
    case 10:
        SEEN(stickslip_tangential_solver_reset(shearer));
        break;
    case 11:
        SEEN(stickslip_coupled_solver_set_loads(solver, maybe(run, &press), maybe(run, &drag)));
        break;
    case 13:
        SEEN(stickslip_coupled_solver_set_gap(solver, maybe(run, numbers), count));
        break;
    case 14:
        SEEN(stickslip_coupled_solver_set_friction(solver, maybe(run, &law)));
        break;
    case 15:
        SEEN(stickslip_coupled_solver_set_settings(solver, maybe(run, &set)));
        break;
    default:
        SEEN(stickslip_coupled_solver_reset(solver));
    }
    free(numbers);
}
