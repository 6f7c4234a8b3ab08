/* Times of warm steps in C, for comparison with the times of overhead.rs for the same contact and loads.
 *   overhead [cells along a side, default 64] [steps, default 2000] */

#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <stickslip.h>

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static int ascending(const void *one, const void *other) {
    double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

int main(int argc, char **argv) {
    size_t n = argc > 1 ? strtoul(argv[1], NULL, 10) : 64, steps = argc > 2 ? strtoul(argv[2], NULL, 10) : 2000;
    stickslip_grid grid = {n, n, 0.30e-3 / (double)n, 0.30e-3 / (double)n};
    stickslip_material steel = {213e9, 0.29, 0.0};
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_half_space *bodies = NULL;
    stickslip_history *history = NULL;
    double *ball = malloc(n * n * sizeof *ball), *times = malloc(steps * sizeof *times);
    int bad = stickslip_half_space_new(&grid, &steel, &steel, NULL, &bodies) != STICKSLIP_OK;
    bad |= stickslip_surface_sphere(&grid, 3.5e-3, ball, n * n) != STICKSLIP_OK;
    bad |= stickslip_history_new(bodies, ball, n * n, &friction, NULL, &history) != STICKSLIP_OK;
    stickslip_load_step load = {{STICKSLIP_FORCE, 100.0}, {0}, {0}, 0, 0.0, 0, 0.0};
    bad |= stickslip_history_step(history, &load, NULL) != STICKSLIP_OK;
    load.x.kind = STICKSLIP_FORCE;
    load.y.kind = STICKSLIP_FORCE;
    for (size_t step = 0; step < steps; step++) {
        load.x.value = 10.0 * sin(0.1 * (double)step);
        double start = now();
        bad |= stickslip_history_step(history, &load, NULL) != STICKSLIP_OK;
        times[step] = now() - start;
    }
    stickslip_step_result result;
    bad |= stickslip_history_result(history, &result) != STICKSLIP_OK;
    qsort(times, steps, sizeof *times, ascending);
    printf("C    %zu^2: median %.2f us, tenth %.2f us, shift %e\n", n, 1e6 * times[steps / 2], 1e6 * times[steps / 10],
           result.shift[0]);
    stickslip_history_free(history);
    stickslip_half_space_free(bodies);
    free(ball), free(times);
    return bad;
}
