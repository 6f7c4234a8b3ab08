/* A child process makes threads of its own, and comes to the bits of its parent; so does any number of threads. */

#define _POSIX_C_SOURCE 200809L

#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stickslip.h>

/* More cells than a thread solves alone. */
#define N 72

static double ball[N * N];

/* The approach of a contact under a force; NaN where that fails. */
static double approach(void) {
    stickslip_grid grid = {N, N, 0.3e-3 / N, 0.3e-3 / N};
    stickslip_material steel = {213e9, 0.29, 0.0};
    stickslip_normal_load load = {STICKSLIP_FORCE, 100.0};
    stickslip_half_space *bodies = NULL;
    stickslip_normal_solver *solver = NULL;
    stickslip_normal_solution *solution = NULL;
    stickslip_normal_result result = {0};
    int bad = stickslip_surface_sphere(&grid, 3.5e-3, ball, N * N) != STICKSLIP_OK ||
              stickslip_half_space_new(&grid, &steel, &steel, NULL, &bodies) != STICKSLIP_OK ||
              stickslip_normal_solver_new(bodies, ball, N * N, &load, NULL, NULL, &solver) != STICKSLIP_OK ||
              stickslip_normal_solution_new(solver, &solution) != STICKSLIP_OK ||
              stickslip_normal_solver_solve(solver, solution, NULL) != STICKSLIP_OK ||
              stickslip_normal_solution_result(solution, &result) != STICKSLIP_OK;
    stickslip_normal_solution_free(solution);
    stickslip_normal_solver_free(solver);
    stickslip_half_space_free(bodies);
    return bad ? -1.0 : result.approach;
}

int main(void) {
    double alone = approach();
    int good = alone > 0.0;
    for (size_t threads = 1; threads <= 3; threads++) {
        good &= stickslip_set_num_threads(threads) == STICKSLIP_OK;
        good &= approach() == alone;
    }
    pid_t child = fork();
    if (child == 0) {
        _exit(stickslip_set_num_threads(2) == STICKSLIP_OK && approach() == alone ? 0 : 1);
    }
    int status = 1;
    good &= child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    good &= approach() == alone;
    printf("approach %.17g: %s\n", alone, good ? "the same everywhere" : "not the same everywhere");
    return good ? 0 : 1;
}
