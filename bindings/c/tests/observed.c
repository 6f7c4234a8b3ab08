/* Long calls other than solves call their observer, end if it requests this, and leave their output unchanged. */

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

#define N 24
#define CELLS (N * N)
#define POINTS 1000

static const stickslip_grid GRID = {N, N, 0.3e-3 / N, 0.3e-3 / N};
static const stickslip_material STEEL = {213e9, 0.29, 0.0}, RIGID = {INFINITY, 0.0, 0.0};
static double ball[CELLS];

/* Number of calls of an observer, and number of calls that let the work continue. */
typedef struct {
    size_t asked, allowed;
} patience;

static int32_t observe(const stickslip_iteration *iteration, void *user) {
    patience *left = user;
    if (iteration->double_precision_products + iteration->single_precision_products != left->asked) {
        failures++;
    }
    return left->asked++ < left->allowed;
}

/* Objects used by all calls, and outputs of the calls. */
typedef struct {
    stickslip_half_space *bodies;
    stickslip_normal_solution *pressed;
    stickslip_tangential_solution *sheared;
    stickslip_half_space *dissimilar;
    stickslip_coupled_solution *both;
    stickslip_friction friction;
    stickslip_history *history;
    stickslip_rolling_solver *roller;
    stickslip_planes *planes;
    stickslip_tractions tractions;
    stickslip_point points[POINTS];
} objects;

typedef struct {
    stickslip_normal_stiffness normal;
    stickslip_tangential_stiffness tangential;
    stickslip_stiffness all;
    stickslip_rolling_stiffness rolling;
    stickslip_response responses[POINTS];
    double values[CELLS];
} answers;

typedef stickslip_status (*long_call)(const objects *of, const stickslip_observer *observer, answers *to);

static stickslip_status normal(const objects *of, const stickslip_observer *observer, answers *to) {
    return stickslip_normal_solution_stiffness_observed(of->pressed, of->bodies, observer, &to->normal);
}

static stickslip_status tangential(const objects *of, const stickslip_observer *observer, answers *to) {
    return stickslip_tangential_solution_stiffness_observed(of->sheared, of->bodies, observer, &to->tangential);
}

static stickslip_status coupled(const objects *of, const stickslip_observer *observer, answers *to) {
    return stickslip_coupled_solution_stiffness_observed(of->both, of->dissimilar, &of->friction, observer, &to->all);
}

static stickslip_status history(const objects *of, const stickslip_observer *observer, answers *to) {
    return stickslip_history_stiffness_observed(of->history, observer, &to->all);
}

static stickslip_status rolling(const objects *of, const stickslip_observer *observer, answers *to) {
    return stickslip_rolling_solver_stiffness_observed(of->roller, observer, &to->rolling);
}

static stickslip_status points(const objects *of, const stickslip_observer *observer, answers *to) {
    return stickslip_stress_at_points_observed(of->bodies, STICKSLIP_BODY_1, &of->tractions, of->points, POINTS, observer,
                                               to->responses);
}

static stickslip_status rough(const objects *of, const stickslip_observer *observer, answers *to) {
    (void)of;
    stickslip_self_affine surface = stickslip_self_affine_default();
    surface.rms_height = 1e-6;
    surface.skewness = 0.3;
    return stickslip_surface_self_affine_observed(&GRID, &surface, observer, to->values, CELLS);
}

/* Reads the last solved plane, also after a call that was ended. */
static stickslip_status plane(const objects *of, const stickslip_observer *observer, answers *to) {
    stickslip_status status = stickslip_planes_solve_observed(of->planes, 1, STICKSLIP_BODY_1, &of->tractions, observer);
    OK(stickslip_planes_measure(of->planes, STICKSLIP_VON_MISES, to->values, CELLS));
    return status;
}

static void stops(long_call call, const objects *of) {
    static answers before, whole, found;
    patience whole_of = {0, (size_t)-1};
    stickslip_observer observer = {observe, &whole_of};
    memset(&before, 0, sizeof before);
    if (call == plane) {
        OK(stickslip_planes_measure(of->planes, STICKSLIP_VON_MISES, before.values, CELLS));
    }
    memset(&whole, 0, sizeof whole);
    OK(call(of, NULL, &whole));
    CHECK(memcmp(&whole, &before, sizeof before) != 0 || call == plane);
    memset(&found, 0, sizeof found);
    OK(call(of, &observer, &found));
    CHECK(memcmp(&found, &whole, sizeof found) == 0);
    CHECK(whole_of.asked > 2);
    const size_t allowed[] = {0, whole_of.asked / 2, whole_of.asked - 1};
    for (size_t i = 0; i < 3; i++) {
        patience some = {0, allowed[i]};
        stickslip_report report;
        observer.user = &some;
        memset(&found, 0, sizeof found);
        CHECK(call(of, &observer, &found) == STICKSLIP_NOT_CONVERGED);
        OK(stickslip_last_error_report(&report));
        CHECK(report.status == STICKSLIP_CANCELLED);
        CHECK(some.asked == allowed[i] + 1);
        CHECK(memcmp(&found, call == plane ? &whole : &before, sizeof found) == 0);
    }
}

int main(void) {
    static objects of;
    const double depths[] = {0.0, 2e-5};
    stickslip_normal_load load = {STICKSLIP_FORCE, 100.0};
    stickslip_tangential_load drag = {{STICKSLIP_FORCE, 20.0, 0.0}, {0}, 0.0};
    stickslip_load_step step = {{STICKSLIP_FORCE, 100.0}, {STICKSLIP_FORCE, 20.0, 0.0}, {0}, 0, 0.0, 0, 0.0};
    stickslip_normal_solver *press = NULL;
    stickslip_tangential_solver *shear = NULL;
    stickslip_coupled_solver *press_and_shear = NULL;
    of.friction = stickslip_coulomb(0.5);
    OK(stickslip_surface_sphere(&GRID, 3.5e-3, ball, CELLS));
    OK(stickslip_half_space_new(&GRID, &STEEL, &STEEL, NULL, &of.bodies));
    OK(stickslip_normal_solver_new(of.bodies, ball, CELLS, &load, NULL, NULL, &press));
    OK(stickslip_normal_solution_new(press, &of.pressed));
    OK(stickslip_normal_solver_solve(press, of.pressed, NULL));
    OK(stickslip_tangential_solver_new(of.bodies, of.pressed, &of.friction, &drag, NULL, &shear));
    OK(stickslip_tangential_solution_new(shear, &of.sheared));
    OK(stickslip_tangential_solver_solve(shear, of.sheared, NULL));
    OK(stickslip_half_space_new(&GRID, &STEEL, &RIGID, NULL, &of.dissimilar));
    OK(stickslip_coupled_solver_new(of.dissimilar, ball, CELLS, &of.friction, &load, &drag, NULL, NULL, NULL,
                                    &press_and_shear));
    OK(stickslip_coupled_solution_new(press_and_shear, &of.both));
    OK(stickslip_coupled_solver_solve(press_and_shear, of.both, NULL));
    OK(stickslip_history_new(of.bodies, ball, CELLS, &of.friction, NULL, &of.history));
    OK(stickslip_history_step(of.history, &step, NULL));
    OK(stickslip_rolling_solver_new(of.bodies, of.pressed, &of.friction, NULL, NULL, &of.roller));
    of.tractions.pressure = stickslip_normal_solution_field(of.pressed, STICKSLIP_PRESSURE, &of.tractions.count);
    for (int i = 0; i < POINTS; i++) {
        of.points[i].depth = 1e-7 * i;
    }
    OK(stickslip_planes_new(of.bodies, depths, 2, 0, &of.planes));
    OK(stickslip_planes_solve(of.planes, 1, STICKSLIP_BODY_1, &of.tractions));

    stops(normal, &of);
    stops(tangential, &of);
    stops(coupled, &of);
    stops(history, &of);
    stops(rolling, &of);
    stops(points, &of);
    stops(rough, &of);
    stops(plane, &of);

    OK(stickslip_planes_free(of.planes));
    OK(stickslip_rolling_solver_free(of.roller));
    OK(stickslip_history_free(of.history));
    OK(stickslip_coupled_solution_free(of.both));
    OK(stickslip_coupled_solver_free(press_and_shear));
    OK(stickslip_half_space_free(of.dissimilar));
    OK(stickslip_tangential_solution_free(of.sheared));
    OK(stickslip_tangential_solver_free(shear));
    OK(stickslip_normal_solution_free(of.pressed));
    OK(stickslip_normal_solver_free(press));
    OK(stickslip_half_space_free(of.bodies));
    return report("observed calls");
}
