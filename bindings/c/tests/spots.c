/* Contact spots, and jumps over cycles of wear. */

#include <math.h>
#include <stdlib.h>

#include "check.h"

#define NX 48
#define NY 24
#define CELLS (NX * NY)
#define SPOTS 4

static const stickslip_material RUBBER = {1.0, 0.5, 0.0}, RIGID = {INFINITY, 0.0, 0.0};

/* Computes the gap of two balls side by side. The second ball is lower by 0.05. */
static void two_balls(const stickslip_grid *grid, double *gap) {
    for (size_t iy = 0; iy < NY; iy++) {
        for (size_t ix = 0; ix < NX; ix++) {
            double x = ((double)ix - 0.5 * (NX - 1)) * grid->dx, y = ((double)iy - 0.5 * (NY - 1)) * grid->dy;
            double first = (pow(x + 4.0, 2) + y * y) / 20.0, second = (pow(x - 4.0, 2) + y * y) / 20.0 + 0.05;
            gap[iy * NX + ix] = fmin(first, second);
        }
    }
}

static void spots_are_told(void) {
    stickslip_grid grid = {NX, NY, 1.0 / 3.0, 1.0 / 3.0};
    double gap[CELLS];
    two_balls(&grid, gap);
    stickslip_half_space *bodies = NULL;
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_solution *pressed = NULL;
    stickslip_normal_load load = {STICKSLIP_FORCE, 0.5};
    OK(stickslip_half_space_new(&grid, &RUBBER, &RIGID, NULL, &bodies));
    OK(stickslip_normal_solver_new(bodies, gap, CELLS, &load, NULL, NULL, &presser));
    OK(stickslip_normal_solution_new(presser, &pressed));
    OK(stickslip_normal_solver_solve(presser, pressed, NULL));

    stickslip_spot spots[SPOTS];
    uint32_t labels[CELLS];
    size_t count = 0;
    OK(stickslip_normal_solution_spots(pressed, NULL, 0, &count, NULL, 0));
    CHECK(count == 2);
    OK(stickslip_normal_solution_spots(pressed, spots, SPOTS, &count, labels, CELLS));
    CHECK(spots[0].load > spots[1].load);
    CLOSE(spots[0].load + spots[1].load, 0.5, 1e-9);
    CLOSE(spots[0].centroid[0], -4.0, 0.03);
    CLOSE(spots[1].centroid[0], 4.0, 0.03);
    CHECK(isnan(spots[0].stick_ratio));
    /* Area, load and largest pressure are computed from the labels. */
    const double *pressure = stickslip_normal_solution_field(pressed, STICKSLIP_PRESSURE, NULL);
    for (uint32_t spot = 1; spot <= 2; spot++) {
        double sum = 0.0, largest = 0.0;
        size_t cells = 0;
        for (size_t i = 0; i < CELLS; i++) {
            CHECK((labels[i] == 0) == (pressure[i] == 0.0));
            if (labels[i] == spot) {
                cells++, sum += pressure[i], largest = fmax(largest, pressure[i]);
            }
        }
        CHECK(cells == spots[spot - 1].cells && largest == spots[spot - 1].max_pressure);
        CLOSE(sum * grid.dx * grid.dy, spots[spot - 1].load, 1e-12);
        CLOSE((double)cells * grid.dx * grid.dy, spots[spot - 1].area, 1e-12);
    }
    spots[0].cells = 77;
    CHECK(stickslip_normal_solution_spots(pressed, spots, 1, &count, NULL, 0) == STICKSLIP_BUFFER_TOO_SMALL && count == 2);
    CHECK(stickslip_normal_solution_spots(pressed, spots, SPOTS, &count, labels, CELLS - 1) == STICKSLIP_LENGTH);
    CHECK(spots[0].cells == 77);

    /* The drag makes the ball with the smaller load slide. This ball loses its stick zone first. */
    stickslip_friction friction = stickslip_coulomb(0.3);
    stickslip_tangential_load drag = {{STICKSLIP_FORCE, 0.1, 0.0}, {0}, 0.0};
    stickslip_tangential_solver *shearer = NULL;
    stickslip_tangential_solution *sheared = NULL;
    OK(stickslip_tangential_solver_new(bodies, pressed, &friction, &drag, NULL, &shearer));
    OK(stickslip_tangential_solution_new(shearer, &sheared));
    OK(stickslip_tangential_solver_solve(shearer, sheared, NULL));
    OK(stickslip_tangential_solution_spots(sheared, pressed, spots, SPOTS, &count, labels, CELLS));
    CHECK(spots[0].stick_ratio > spots[1].stick_ratio && spots[1].stick_ratio >= 0.0 && spots[0].stick_ratio < 1.0);
    stickslip_tangential_result result;
    OK(stickslip_tangential_solution_result(sheared, &result));
    double stick = spots[0].stick_ratio * (double)spots[0].cells + spots[1].stick_ratio * (double)spots[1].cells;
    CLOSE(stick / (double)(spots[0].cells + spots[1].cells), result.stick_ratio, 1e-12);
    OK(stickslip_tangential_solution_free(sheared));
    OK(stickslip_tangential_solver_free(shearer));
    OK(stickslip_normal_solution_free(pressed));
    OK(stickslip_normal_solver_free(presser));
    OK(stickslip_half_space_free(bodies));
}

#define N 32

/* Runs a cycle to a shift of 0.1 and to its opposite, adds its wear to depth, and returns the number of steps. */
static void fret(stickslip_history *history, stickslip_cycle *cycle, double *depth) {
    static const double path[] = {0.05, 0.1, 0.0, -0.1, 0.0};
    stickslip_per_cell alpha = {1e-2, NULL, 0};
    OK(stickslip_cycle_begin(cycle, history));
    for (size_t i = 0; i < sizeof path / sizeof *path; i++) {
        stickslip_load_step load = {0};
        load.normal.kind = STICKSLIP_FORCE, load.normal.value = 0.5;
        load.x.kind = STICKSLIP_SHIFT, load.x.value = path[i];
        OK(stickslip_history_step(history, &load, NULL));
        OK(stickslip_cycle_add(cycle, history));
        OK(stickslip_wear_energy(history, &alpha, depth, N * N));
    }
}

static void cycles_are_jumped_over(void) {
    stickslip_grid grid = {N, N, 0.25, 0.25};
    static double gap[N * N], depth[N * N];
    stickslip_half_space *bodies = NULL;
    stickslip_history *history = NULL;
    stickslip_cycle *cycle = NULL;
    stickslip_friction friction = stickslip_coulomb(0.3);
    OK(stickslip_surface_sphere(&grid, 10.0, gap, N * N));
    OK(stickslip_half_space_new(&grid, &RUBBER, &RIGID, NULL, &bodies));
    OK(stickslip_history_new(bodies, gap, N * N, &friction, NULL, &history));
    OK(stickslip_cycle_new(history, &cycle));
    fret(history, cycle, depth);
    /* The first cycle, from rest, does not represent the following cycles. */
    double jump = -1.0, stable = 0.0;
    stickslip_error error;
    stickslip_jump_limits limits = stickslip_jump_limits_default();
    CHECK(stickslip_cycle_jump(bodies, cycle, depth, N * N, NULL, &jump) == STICKSLIP_CYCLE_NOT_CLOSED && jump == -1.0);
    OK(stickslip_last_error(&error));
    CHECK(error.value > 0.25 && error.limit == 0.25);
    limits.max_residual = 2.0;
    OK(stickslip_cycle_jump(bodies, cycle, depth, N * N, &limits, &jump));
    CHECK(jump > 0.0);
    limits.max_residual = 0.25, limits.cycles_left = -1.0;
    CHECK(stickslip_cycle_jump(bodies, cycle, depth, N * N - 1, NULL, &jump) == STICKSLIP_LENGTH);

    double done = 0.0, worn = 0.0, first = 0.0;
    int jumps = 0;
    while (done < 1000.0 && jumps < 1000) {
        for (size_t i = 0; i < N * N; i++) {
            depth[i] = 0.0;
        }
        fret(history, cycle, depth);
        stickslip_normal_result normal;
        OK(stickslip_history_normal_result(history, &normal));
        limits.largest_depth = 0.05 * normal.approach, limits.cycles_left = 1000.0 - done;
        OK(stickslip_cycle_jump(bodies, cycle, depth, N * N, &limits, &jump));
        double deepest = 0.0;
        for (size_t i = 0; i < N * N; i++) {
            deepest = fmax(deepest, depth[i]);
            gap[i] += jump * depth[i];
        }
        CHECK(jump * deepest <= limits.largest_depth * (1.0 + 1e-12));
        first = jumps == 0 ? deepest : first;
        worn += jump * deepest, done += jump, jumps++;
        OK(stickslip_history_set_gap(history, gap, N * N));
    }
    CHECK(done == 1000.0 && jumps > 1 && worn < 1000.0 * first);
    /* Archard's law: the jump is at least half of the stable number of cycles. */
    const double *slip = stickslip_cycle_field(cycle, STICKSLIP_SLIP_DISTANCE, NULL);
    const double *pressure = stickslip_cycle_field(cycle, STICKSLIP_SLIP_PRESSURE, NULL);
    for (size_t i = 0; i < N * N; i++) {
        depth[i] = 1e-2 * slip[i] * pressure[i];
    }
    stickslip_per_cell k = {1e-2, NULL, 0};
    OK(stickslip_cycle_jump(bodies, cycle, depth, N * N, NULL, &jump));
    OK(stickslip_max_stable_cycles(bodies, &k, slip, N * N, &stable));
    CHECK(stable <= 2.0 * jump * (1.0 + 1e-12) && stable > jump);
    OK(stickslip_cycle_free(cycle));
    OK(stickslip_history_free(history));
    OK(stickslip_half_space_free(bodies));
}

int main(void) {
    spots_are_told();
    cycles_are_jumped_over();
    return report("spots and jumps");
}
