/* Calls that read. */

#include "run.h"

/* Reads a field or zones, to the end if no other thread can change them. */
void field(struct run *run) {
    int32_t which = option(run, 27);
    size_t count = 0;
    enum kind kinds[] = {PRESSED, SHEARED, BOTH, HISTORY, CYCLE, PLANES, ROLLED};
    enum kind kind = kinds[below(run, 7)];
    struct slot *slot = pick(run, kind);
    bool is_shared = slot >= &run->shared->slots[0][0] && slot <= &run->shared->slots[KINDS - 1][SLOTS - 1];
    const void *object = maybe(run, slot->object);
    const double *samples = NULL;
    const uint8_t *zones = NULL;
    switch (kind) {
    case PRESSED:
        samples = stickslip_normal_solution_field(object, which, maybe_out(run, &count));
        break;
    case SHEARED:
        samples = stickslip_tangential_solution_field(object, which, maybe_out(run, &count));
        zones = stickslip_tangential_solution_zones(object, NULL);
        break;
    case BOTH:
        samples = stickslip_coupled_solution_field(object, which, maybe_out(run, &count));
        zones = stickslip_coupled_solution_zones(object, NULL);
        break;
    case HISTORY:
        samples = stickslip_history_field(object, which, maybe_out(run, &count));
        zones = stickslip_history_zones(object, NULL);
        break;
    case ROLLED:
        samples = stickslip_rolling_solution_field(object, which, maybe_out(run, &count));
        zones = stickslip_rolling_solution_zones(object, NULL);
        break;
    case CYCLE:
        samples = stickslip_cycle_field(object, which, maybe_out(run, &count));
        break;
    default:
        samples = stickslip_planes_field(object, which, maybe_out(run, &count));
    }
    run->calls++;
    if (samples == NULL) {
        run->failed = STICKSLIP_INVALID_ARGUMENT;
    }
    if (is_shared) {
        return;
    }
    volatile double sum = 0.0;
    for (size_t i = 0; samples != NULL && i < count; i++) {
        sum += samples[i];
    }
    for (size_t i = 0; zones != NULL && samples != NULL && i < count; i++) {
        if (zones[i] > STICKSLIP_SLIP) {
            broken(run, __LINE__, "a value that is not a zone");
        }
    }
}

void read_numbers(struct run *run) {
    stickslip_history *history = GET(stickslip_history, pick(run, HISTORY));
    const stickslip_normal_solution *pressed = GET(stickslip_normal_solution, pick(run, PRESSED));
    const stickslip_tangential_solution *sheared = GET(stickslip_tangential_solution, pick(run, SHEARED));
    const stickslip_coupled_solution *both = GET(stickslip_coupled_solution, pick(run, BOTH));
    const stickslip_half_space *bodies = GET(stickslip_half_space, pick(run, BODIES));
    stickslip_normal_result normal;
    stickslip_tangential_result tangential;
    stickslip_step_result result;
    stickslip_report report, other;
    stickslip_coupled_report coupled;
    stickslip_warning warnings[2];
    stickslip_spot spots[2];
    uint32_t labels[100];
    stickslip_edges edges;
    double centres[100], means[100];
    stickslip_stiffness stiffness;
    stickslip_normal_stiffness slope;
    stickslip_tangential_stiffness slopes;
    stickslip_cycle_result cycle;
    stickslip_grid grid;
    stickslip_pair pair;
    stickslip_error error;
    double value;
    size_t count, capacity = below(run, 3);
    switch (below(run, 29)) {
    case 0:
        SEEN(stickslip_normal_solution_result(pressed, maybe_out(run, &normal)));
        break;
    case 1:
        SEEN(stickslip_tangential_solution_result(sheared, maybe_out(run, &tangential)));
        break;
    case 2:
        SEEN(stickslip_coupled_solution_results(both, maybe_out(run, &normal), maybe_out(run, &tangential)));
        break;
    case 3:
        SEEN(stickslip_history_result(history, maybe_out(run, &result)));
        break;
    case 4:
        SEEN(stickslip_history_normal_result(history, maybe_out(run, &normal)));
        break;
    case 5:
        SEEN(stickslip_history_reports(history, maybe_out(run, &report), maybe_out(run, &other)));
        break;
    case 6:
        SEEN(stickslip_normal_solution_report(pressed, maybe_out(run, &report)));
        break;
    case 7:
        SEEN(stickslip_tangential_solution_report(sheared, maybe_out(run, &report)));
        break;
    case 8:
        SEEN(stickslip_coupled_solution_report(both, maybe_out(run, &coupled)));
        break;
    case 9:
        SEEN(stickslip_normal_solution_warnings(pressed, maybe_out(run, warnings), capacity, maybe_out(run, &count)));
        break;
    case 10:
        SEEN(stickslip_tangential_solution_warnings(sheared, maybe_out(run, warnings), capacity, maybe_out(run, &count)));
        break;
    case 11:
        SEEN(stickslip_coupled_solution_warnings(both, maybe_out(run, warnings), capacity, maybe_out(run, &count)));
        break;
    case 12:
        SEEN(stickslip_history_warnings(history, maybe_out(run, warnings), capacity, maybe_out(run, &count)));
        break;
    case 13:
        SEEN(stickslip_history_stiffness(history, maybe_out(run, &stiffness)));
        break;
    case 14:
        SEEN(stickslip_normal_solution_stiffness(pressed, bodies, maybe_out(run, &slope)));
        break;
    case 15:
        SEEN(stickslip_tangential_solution_stiffness(sheared, bodies, maybe_out(run, &slopes)));
        break;
    case 16:
        SEEN(stickslip_history_grid(history, maybe_out(run, &grid)));
        break;
    case 17:
        SEEN(stickslip_half_space_grid(bodies, maybe_out(run, &grid)));
        SEEN(stickslip_half_space_pair(bodies, maybe_out(run, &pair)));
        break;
    case 18:
        SEEN(stickslip_history_friction_capacity(history, maybe_out(run, &value)));
        break;
    case 19:
        SEEN(stickslip_cycle_result_of(GET(stickslip_cycle, pick(run, CYCLE)), maybe_out(run, &cycle)));
        break;
    case 20:
        SEEN(stickslip_last_error(maybe_out(run, &error)));
        SEEN(stickslip_last_error_report(maybe_out(run, &report)));
        break;
    case 21:
        SEEN(stickslip_normal_solution_spots(pressed, maybe_out(run, spots), capacity, maybe_out(run, &count),
                                             maybe_out(run, labels), below(run, 101)));
        break;
    case 22:
        SEEN(stickslip_tangential_solution_spots(sheared, pressed, maybe_out(run, spots), capacity,
                                                 maybe_out(run, &count), maybe_out(run, labels), below(run, 101)));
        break;
    case 23:
        SEEN(stickslip_history_spots(history, maybe_out(run, spots), capacity, maybe_out(run, &count),
                                     maybe_out(run, labels), below(run, 101)));
        break;
    case 24: {
        stickslip_friction law = stickslip_coulomb(below(run, 4) == 0 ? number(run, 0.5) : 0.3);
        SEEN(stickslip_coupled_solution_stiffness(both, bodies, maybe(run, &law), maybe_out(run, &stiffness)));
        break;
    }
    case 25: {
        stickslip_friction law = stickslip_coulomb(below(run, 4) == 0 ? number(run, 0.5) : 0.3);
        size_t cells = below(run, 101);
        SEEN(stickslip_normal_solution_edges(pressed, maybe_out(run, &edges), maybe_out(run, centres),
                                             maybe_out(run, means), cells));
        SEEN(stickslip_tangential_solution_edges(sheared, pressed, maybe(run, &law), maybe_out(run, &edges),
                                                 maybe_out(run, centres), maybe_out(run, means), cells));
        SEEN(stickslip_coupled_solution_edges(both, maybe(run, &law), maybe_out(run, &edges), maybe_out(run, centres),
                                              maybe_out(run, means), cells));
        SEEN(stickslip_coupled_solution_pressure_edges(both, maybe_out(run, &edges), maybe_out(run, centres),
                                                       maybe_out(run, means), cells));
        break;
    }
    case 26:
        SEEN(stickslip_normal_solution_discretisation_estimate(pressed, maybe_out(run, &value)));
        SEEN(stickslip_tangential_solution_discretisation_estimate(sheared, maybe_out(run, &value)));
        SEEN(stickslip_coupled_solution_discretisation_estimates(both, maybe_out(run, &value),
                                                                 maybe_out(run, centres)));
        break;
    case 27: {
        stickslip_stiffness_options options = stickslip_stiffness_options_default();
        options.tolerance = below(run, 4) == 0 ? number(run, 1e-6) : 1e-6;
        options.next_step = (int32_t)below(run, 2), options.reversal = (int32_t)below(run, 2);
        stickslip_stiffness_workspace *workspace = NULL;
        SEEN(stickslip_stiffness_workspace_new(maybe(run, &options), &workspace));
        SEEN(stickslip_history_stiffness_with(history, workspace, NULL, maybe_out(run, &stiffness)));
        SEEN(stickslip_stiffness_workspace_report(workspace, maybe_out(run, &report)));
        SEEN(stickslip_stiffness_workspace_free(workspace));
        break;
    }
    default:
        SEEN(stickslip_tangential_solver_friction_capacity(GET(stickslip_tangential_solver, pick(run, TANGENTIAL)),
                                                           maybe_out(run, &value)));
    }
}
