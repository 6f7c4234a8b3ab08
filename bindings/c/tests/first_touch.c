/* A mass is pressed on a ball and dragged simultaneously from first touch, with Newmark's rule. Newton's iteration for
 * approach and shift together takes at most five iterations a step, because the stiffness is the derivative of steps in
 * which contacts grow.
 *   first_touch [steps of the slowest growth, default 20] */

#include <math.h>
#include <stdlib.h>

#include "check.h"

#define N 32
#define CELLS (N * N)
#define MOST 5

/* Motion of the mass in one of its two directions: place, speed, acceleration and load. */
typedef struct {
    double place, speed, acceleration, load;
} motion;

/* Runs the time integration. The mass, in units of a time step, is given as a multiple of the stiffness of the contact that
 * sticks under the full load. The load grows in the given number of steps, and the drag then reverses twice. */
static void loop(double mass, int growth) {
    const double press = 100.0, drag = 20.0, pi = acos(-1.0);
    stickslip_grid grid = {N, N, 0.30e-3 / N, 0.30e-3 / N};
    stickslip_material steel = {213e9, 0.29, 0.0};
    stickslip_half_space *bodies = NULL;
    stickslip_history *history = NULL;
    stickslip_state *before = NULL;
    double ball[CELLS];
    OK(stickslip_half_space_new(&grid, &steel, &steel, NULL, &bodies));
    OK(stickslip_surface_sphere(&grid, 3.5e-3, ball, CELLS));
    stickslip_friction friction = stickslip_coulomb(0.5);
    OK(stickslip_history_new(bodies, ball, CELLS, &friction, NULL, &history));
    OK(stickslip_state_new(history, &before));
    OK(stickslip_state_keep(before, history));
    stickslip_load_step load = {{STICKSLIP_FORCE, press}, {0}, {0}, 0, 0.0, 0, 0.0};
    OK(stickslip_history_step(history, &load, NULL));
    stickslip_stiffness slope;
    OK(stickslip_history_stiffness(history, &slope));
    double inertia = mass * slope.tangential.reversal[0][0];
    OK(stickslip_history_set_state(history, before));

    motion x = {0}, z = {0};
    int slipping = 0, closed = 0;
    for (int step = 1; step <= 3 * growth; step++) {
        double part = fmin(1.0, (double)step / growth);
        z.load = part * press;
        x.load = drag * (step <= growth ? part : cos(2.0 * pi * (step - growth) / growth));
        OK(stickslip_state_keep(before, history));
        motion from[2] = {x, z};
        double by_rule[2], missing[2];
        /* Newton's iteration starts at the place of the mass, or initially at first touch. */
        z.place = fmax(z.place, 1e-9);
        stickslip_step_result now;
        for (int iteration = 0;; iteration++) {
            OK(stickslip_history_set_state(history, before));
            load.normal.kind = STICKSLIP_APPROACH, load.normal.value = z.place;
            load.x.kind = STICKSLIP_SHIFT, load.x.value = x.place;
            OK(stickslip_history_step(history, &load, NULL));
            OK(stickslip_history_result(history, &now));
            /* All derivatives are in units of a time step. */
            by_rule[0] = 4.0 * (x.place - from[0].place - from[0].speed) - from[0].acceleration;
            by_rule[1] = 4.0 * (z.place - from[1].place - from[1].speed) - from[1].acceleration;
            missing[0] = x.load - now.force[0] - 0.25 * inertia * by_rule[0];
            missing[1] = z.load - now.normal_force - 0.25 * inertia * by_rule[1];
            if ((fabs(missing[0]) <= 1e-6 * drag && fabs(missing[1]) <= 1e-6 * press) || failures > 0) {
                break;
            }
            CHECK(iteration < MOST);
            OK(stickslip_history_stiffness(history, &slope));
            double deeper = missing[1] / (inertia + slope.normal.value);
            z.place += deeper;
            x.place += (missing[0] - slope.by_approach[0] * deeper) / (inertia + slope.tangential.loading[0][0]);
        }
        x.speed += 0.5 * (x.acceleration + by_rule[0]), x.acceleration = by_rule[0];
        z.speed += 0.5 * (z.acceleration + by_rule[1]), z.acceleration = by_rule[1];
        closed += now.normal_force > 0.0, slipping += now.stick_ratio > 0.0 && now.stick_ratio < 0.9;
    }
    CHECK(closed > 2 * growth && slipping > growth / 2);
    OK(stickslip_state_free(before));
    OK(stickslip_history_free(history));
    OK(stickslip_half_space_free(bodies));
}

int main(int argc, char **argv) {
    int slowest = argc > 1 ? atoi(argv[1]) : 20;
    for (int growth = 5; growth <= slowest; growth += 15) {
        loop(10.0, growth);
        loop(1.0, growth);
    }
    return report("five Newton iterations from first touch");
}
