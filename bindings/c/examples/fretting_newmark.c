/* A mass on a contact with friction under an alternating force. Time integration uses Newmark's rule of average
 * acceleration. Each time step uses Newton's iteration with the tangent stiffness of the contact. The energy balance closes
 * to the tolerance of Newton's iteration. SI units.
 *   fretting_newmark [cells along a side, default 48] [time steps, default 160] */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <stickslip.h>

static void need(stickslip_status status) {
    if (status != STICKSLIP_OK) {
        fprintf(stderr, "error %d: %s\n", (int)status, stickslip_last_error_message());
        exit(1);
    }
}

int main(int argc, char **argv) {
    size_t n = argc > 1 ? strtoul(argv[1], NULL, 10) : 48;
    int steps = argc > 2 ? atoi(argv[2]) : 160;
    const double mass = 1.0, load = 100.0, amplitude = 20.0;
    const int steps_per_cycle = 40;

    stickslip_grid grid = {n, n, 0.30e-3 / (double)n, 0.30e-3 / (double)n};
    stickslip_material steel = {213e9, 0.29, 0.0};
    stickslip_half_space *bodies;
    need(stickslip_half_space_new(&grid, &steel, &steel, NULL, &bodies));
    double *ball = malloc(n * n * sizeof *ball);
    need(stickslip_surface_sphere(&grid, 3.5e-3, ball, n * n));
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_history_options options = stickslip_history_options_default();
    options.settings.tolerance = 1e-10;
    stickslip_history *history;
    need(stickslip_history_new(bodies, ball, n * n, &friction, &options, &history));

    /* Members of a load that are zero hold their quantities. */
    stickslip_load_step press = {{STICKSLIP_FORCE, load}, {0}, {0}, 0, 0.0, 0, 0.0};
    need(stickslip_history_step(history, &press, NULL));
    stickslip_state *before;
    stickslip_cycle *cycle;
    need(stickslip_state_new(history, &before));
    need(stickslip_cycle_new(history, &cycle));

    /* The mass is driven at half of the natural frequency of the sticking contact. */
    stickslip_stiffness slope;
    need(stickslip_history_stiffness(history, &slope));
    double pulsation = 0.5 * sqrt(slope.tangential.reversal[0][0] / mass);
    double dt = 2.0 * acos(-1.0) / pulsation / steps_per_cycle;
    double x = 0.0, v = 0.0, a = 0.0, pull = 0.0;
    double given = 0.0, dissipated = 0.0, most_iterations = 0.0;
    stickslip_step_result now;
    need(stickslip_history_result(history, &now));

    for (int step = 1; step <= steps; step++) {
        if ((step - 1) % steps_per_cycle == 0) {
            need(stickslip_cycle_begin(cycle, history));
        }
        double ramp = fmin(1.0, (double)step / steps_per_cycle);
        double new_pull = ramp * amplitude * sin(pulsation * dt * step);
        need(stickslip_state_keep(before, history));
        double new_x = x + dt * v + 0.25 * dt * dt * a, new_a = 0.0;
        int iteration = 0;
        for (;;) {
            /* Each iteration starts from the state before the time step. */
            need(stickslip_history_set_state(history, before));
            stickslip_load_step move = {{STICKSLIP_HOLD, 0.0}, {STICKSLIP_SHIFT, new_x, 0.0}, {0}, 0, 0.0, 0, 0.0};
            need(stickslip_history_step(history, &move, NULL));
            need(stickslip_history_result(history, &now));
            new_a = 4.0 / (dt * dt) * (new_x - x) - 4.0 / dt * v - a;
            double missing = new_pull - now.force[0] - mass * new_a;
            if (fabs(missing) <= 1e-9 * amplitude) {
                break;
            }
            if (++iteration > 30) {
                fprintf(stderr, "Newton does not converge in step %d\n", step);
                return 1;
            }
            need(stickslip_history_stiffness(history, &slope));
            new_x += missing / (4.0 / (dt * dt) * mass + slope.tangential.loading[0][0]);
        }
        most_iterations = fmax(most_iterations, iteration);
        given += 0.5 * (pull + new_pull) * (new_x - x);
        dissipated += now.energy.dissipated_energy_midpoint;
        v += 0.5 * dt * (a + new_a);
        x = new_x, a = new_a, pull = new_pull;
        need(stickslip_cycle_add(cycle, history));
    }

    double moving = 0.5 * mass * v * v, stored = now.energy.elastic_after;
    double imbalance = (moving + stored + dissipated) / given - 1.0;
    stickslip_cycle_result loop;
    need(stickslip_cycle_result_of(cycle, &loop));
    printf("%d time steps, at most %.0f iterations of Newton\n", steps, most_iterations);
    printf("given %.6e J = moving %.3e + stored %.3e + dissipated %.3e, imbalance %+.1e\n", given, moving, stored,
           dissipated, imbalance);
    printf("last cycle: force +-%.2f N, shift +-%.4f um, %s\n", loop.force_amplitude[0], 1e6 * loop.shift_amplitude[0],
           loop.regime == STICKSLIP_PARTIAL_SLIP ? "partial slip" : "no partial slip");

    stickslip_cycle_free(cycle);
    stickslip_state_free(before);
    stickslip_history_free(history);
    stickslip_half_space_free(bodies);
    free(ball);
    return fabs(imbalance) < 1e-6 && dissipated > 0.0 && loop.regime == STICKSLIP_PARTIAL_SLIP ? 0 : 1;
}
