/* A forked process can use all parts of the interface that its parent has used, with bitwise identical results. Results do
 * not depend on the number of threads, and with one thread no other thread is ever started. */

#define _POSIX_C_SOURCE 200809L

#include <dirent.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "check.h"

/* Time limit of a process in seconds. It ends a process that waits for threads that do not exist. */
#define PATIENCE 300
/* Largest number of cells along a side. */
#define MOST 72
#define DEPTHS 2

/* Results of all calls. */
typedef struct {
    double numbers[12];
} answers;

static double ball[MOST * MOST], heights[MOST * MOST], values[MOST * MOST];

/* Returns the number of threads of this process, or 0 if the system does not report it. */
static int threads(void) {
    DIR *tasks = opendir("/proc/self/task");
    int count = 0;
    for (struct dirent *entry; tasks != NULL && (entry = readdir(tasks)) != NULL;) {
        count += entry->d_name[0] != '.';
    }
    if (tasks != NULL) {
        closedir(tasks);
    }
    return count;
}

static void surfaces(const stickslip_grid *grid, size_t cells, answers *to) {
    stickslip_self_affine rough = stickslip_self_affine_default();
    stickslip_statistics statistics;
    rough.rms_height = 1e-6;
    rough.skewness = 0.3;
    rough.cropped = 1;
    OK(stickslip_surface_sphere(grid, 3.5e-3, ball, cells));
    OK(stickslip_surface_self_affine(grid, &rough, heights, cells));
    OK(stickslip_surface_statistics(grid, heights, cells, &statistics));
    to->numbers[0] = statistics.rms_height;
    to->numbers[1] = statistics.spectral_rms_slope;
}

static void below(const stickslip_half_space *bodies, const stickslip_normal_solution *pressed, size_t cells, answers *to) {
    const double depths[DEPTHS] = {0.0, 2e-5};
    const stickslip_point points[] = {{0.0, 0.0, 1e-5}, {1e-5, 2e-5, 3e-5}};
    stickslip_tractions tractions = {stickslip_normal_solution_field(pressed, STICKSLIP_PRESSURE, NULL), NULL, NULL, cells};
    stickslip_response responses[2];
    stickslip_planes *planes = NULL;
    OK(stickslip_stress_at_points(bodies, STICKSLIP_BODY_1, &tractions, points, 2, responses));
    OK(stickslip_planes_new(bodies, depths, DEPTHS, 1, &planes));
    OK(stickslip_planes_solve(planes, 1, STICKSLIP_BODY_1, &tractions));
    OK(stickslip_planes_measure(planes, STICKSLIP_VON_MISES, values, cells));
    OK(stickslip_planes_free(planes));
    to->numbers[2] = responses[1].von_mises;
    to->numbers[3] = values[cells / 2];
}

static void problems(const stickslip_half_space *bodies, size_t cells, answers *to) {
    stickslip_normal_load load = {STICKSLIP_FORCE, 100.0};
    stickslip_normal_solver *press = NULL;
    stickslip_normal_solution *pressed = NULL;
    stickslip_normal_result result;
    stickslip_normal_stiffness stiffness;
    OK(stickslip_normal_solver_new(bodies, ball, cells, &load, NULL, NULL, &press));
    OK(stickslip_normal_solution_new(press, &pressed));
    OK(stickslip_normal_solver_solve(press, pressed, NULL));
    OK(stickslip_normal_solution_result(pressed, &result));
    OK(stickslip_normal_solution_stiffness(pressed, bodies, &stiffness));
    to->numbers[4] = result.approach;
    to->numbers[5] = stiffness.value;
    below(bodies, pressed, cells, to);

    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_tangential_load drag = {{STICKSLIP_FORCE, 20.0, 0.0}, {0}, 0.0};
    stickslip_tangential_solver *shear = NULL;
    stickslip_tangential_solution *sheared = NULL;
    stickslip_tangential_result found;
    stickslip_tangential_stiffness matrix;
    double capacity = 0.0;
    OK(stickslip_tangential_solver_new(bodies, pressed, &friction, &drag, NULL, &shear));
    OK(stickslip_tangential_solver_friction_capacity(shear, &capacity));
    OK(stickslip_tangential_solution_new(shear, &sheared));
    OK(stickslip_tangential_solver_solve(shear, sheared, NULL));
    OK(stickslip_tangential_solution_result(sheared, &found));
    OK(stickslip_tangential_solution_stiffness(sheared, bodies, &matrix));
    to->numbers[6] = found.shift[0];
    to->numbers[7] = matrix.loading[0][0];
    to->numbers[8] = capacity;
    OK(stickslip_tangential_solution_free(sheared));
    OK(stickslip_tangential_solver_free(shear));
    OK(stickslip_normal_solution_free(pressed));
    OK(stickslip_normal_solver_free(press));
}

static void histories(const stickslip_half_space *bodies, size_t cells, answers *to) {
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_history *history = NULL, *copy = NULL;
    stickslip_load_step load = {{STICKSLIP_FORCE, 100.0}, {0}, {0}, 0, 0.0, 0, 0.0};
    stickslip_cycle *cycle = NULL;
    stickslip_state *state = NULL;
    stickslip_stiffness stiffness;
    stickslip_step_result result;
    double capacity = 0.0;
    OK(stickslip_history_new(bodies, ball, cells, &friction, NULL, &history));
    OK(stickslip_history_step(history, &load, NULL));
    OK(stickslip_cycle_new(history, &cycle));
    OK(stickslip_state_new(history, &state));
    OK(stickslip_history_clone(history, &copy));
    load.x = (stickslip_control){STICKSLIP_FORCE, 20.0, 0.0};
    stickslip_history *both[] = {history, copy};
    stickslip_load_step loads[] = {load, load};
    OK(stickslip_history_step_all(both, loads, 2, NULL));
    OK(stickslip_cycle_add(cycle, history));
    OK(stickslip_history_friction_capacity(history, &capacity));
    OK(stickslip_history_stiffness(history, &stiffness));
    memset(values, 0, sizeof values);
    stickslip_per_cell coefficient = {1e-13, NULL, 0};
    OK(stickslip_wear_archard(history, &coefficient, values, cells));
    OK(stickslip_history_set_gap(history, ball, cells));
    OK(stickslip_history_result(history, &result));
    OK(stickslip_history_set_state(history, state));
    to->numbers[9] = capacity;
    to->numbers[10] = stiffness.tangential.reversal[0][0];
    to->numbers[11] = result.shift[0];
    OK(stickslip_state_free(state));
    OK(stickslip_cycle_free(cycle));
    OK(stickslip_history_free(copy));
    OK(stickslip_history_free(history));
}

/* Makes all calls on a grid with the given number of cells along a side. */
static answers everything(size_t side) {
    stickslip_grid grid = {side, side, 0.3e-3 / (double)side, 0.3e-3 / (double)side};
    stickslip_material steel = {213e9, 0.29, 0.0};
    stickslip_half_space *bodies = NULL;
    answers found = {{0.0}};
    surfaces(&grid, side * side, &found);
    OK(stickslip_half_space_new(&grid, &steel, &steel, NULL, &bodies));
    problems(bodies, side * side, &found);
    histories(bodies, side * side, &found);
    OK(stickslip_half_space_free(bodies));
    return found;
}

/* Returns whether a separate process completes this work correctly within its time limit. */
static int in_a_process(void (*work)(size_t, const answers *), size_t side, const answers *expected) {
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        alarm(PATIENCE);
        failures = 0;
        work(side, expected);
        fflush(NULL);
        _exit(failures == 0 ? 0 : 1);
    }
    int status = 1;
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static void again(size_t side, const answers *expected) {
    answers found = everything(side);
    CHECK(memcmp(&found, expected, sizeof found) == 0);
}

/* Uses the default threads, then forks a process in which they do not exist. */
static void used_and_forked(size_t side, const answers *none) {
    (void)none;
    answers alone = everything(side);
    CHECK(alone.numbers[4] > 0.0 && alone.numbers[11] != 0.0);
    CHECK(in_a_process(again, side, &alone));
    again(side, &alone);
    for (size_t count = 1; count <= 3; count++) {
        OK(stickslip_set_num_threads(count));
        again(side, &alone);
        CHECK(in_a_process(again, side, &alone));
    }
}

static void of_one_thread(size_t side, const answers *none) {
    (void)none;
    int before = threads();
    OK(stickslip_set_num_threads(1));
    everything(side);
    CHECK(threads() == before);
}

int main(void) {
    const size_t sides[] = {12, 32, 48, 72};
    /* The main process makes no calls, so that each child starts fresh. */
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        CHECK(in_a_process(used_and_forked, sides[i], NULL));
        CHECK(in_a_process(of_one_thread, sides[i], NULL));
    }
    return report("forked processes");
}
