/* Stresses below a contact, and closed-form solutions for comparison. */

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

#define N 64
#define CELLS (N * N)
/* A steel ball on steel, in N and mm. */
#define RADIUS 5.0
#define FORCE 100.0

static const stickslip_grid GRID = {N, N, 0.4 / N, 0.4 / N};
static const stickslip_material STEEL = {210e3, 0.3, 0.0}, RIGID = {INFINITY, 0.0, 0.0};
static double ball[CELLS], half[CELLS], values[CELLS];

static double largest(const double *of) {
    double most = of[0];
    for (int i = 1; i < CELLS; i++) {
        most = fmax(most, of[i]);
    }
    return most;
}

static stickslip_normal_solution *press(const stickslip_half_space *bodies) {
    stickslip_normal_load load = {STICKSLIP_FORCE, FORCE};
    stickslip_normal_solver *solver = NULL;
    stickslip_normal_solution *solution = NULL;
    OK(stickslip_normal_solver_new(bodies, ball, CELLS, &load, NULL, NULL, &solver));
    OK(stickslip_normal_solution_new(solver, &solution));
    OK(stickslip_normal_solver_solve(solver, solution, NULL));
    OK(stickslip_normal_solver_free(solver));
    return solution;
}

static void closed_forms_are_met(const stickslip_half_space *bodies, const stickslip_normal_solution *pressed) {
    stickslip_hertz hertz;
    stickslip_normal_result normal;
    OK(stickslip_hertz_sphere(bodies, RADIUS, FORCE, &hertz));
    OK(stickslip_normal_solution_result(pressed, &normal));
    CLOSE(normal.approach, hertz.approach, 2e-3);
    CLOSE(normal.contact_area_corrected, acos(-1.0) * hertz.contact_radius * hertz.contact_radius, 2e-2);
    CLOSE(largest(stickslip_normal_solution_field(pressed, STICKSLIP_PRESSURE, NULL)), hertz.max_pressure, 2e-2);
    CHECK(stickslip_hertz_sphere(bodies, -1.0, FORCE, &hertz) == STICKSLIP_NOT_POSITIVE);

    stickslip_cattaneo_mindlin form;
    OK(stickslip_cattaneo_mindlin_sphere(bodies, RADIUS, FORCE, 0.5, 30.0, &form));
    CLOSE(form.hertz.approach, hertz.approach, 0.0);
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_tangential_load drag = {{STICKSLIP_FORCE, 30.0, 0.0}, {0}, 0.0};
    stickslip_tangential_solver *solver = NULL;
    stickslip_tangential_solution *sheared = NULL;
    stickslip_tangential_result result;
    OK(stickslip_tangential_solver_new(bodies, pressed, &friction, &drag, NULL, &solver));
    OK(stickslip_tangential_solution_new(solver, &sheared));
    OK(stickslip_tangential_solver_solve(solver, sheared, NULL));
    OK(stickslip_tangential_solution_result(sheared, &result));
    CLOSE(result.shift[0], form.shift, 1e-2);
    CLOSE(result.stick_ratio, pow(form.stick_radius / hertz.contact_radius, 2.0), 5e-2);
    CLOSE(result.dissipated_energy, form.dissipated_energy, 5e-2);
    CHECK(stickslip_cattaneo_mindlin_sphere(bodies, RADIUS, FORCE, 0.5, 51.0, &form) ==
          STICKSLIP_BEYOND_FRICTION_CAPACITY);
    OK(stickslip_tangential_solution_free(sheared));
    OK(stickslip_tangential_solver_free(solver));
}

/* Johnson (1985), section 4.2: the largest shear stress is 0.310 p0, at the depth 0.481 a for a Poisson's ratio of 0.3. */
static void stresses_are_those_of_hertz(const stickslip_half_space *bodies, const stickslip_normal_solution *pressed) {
    stickslip_hertz hertz;
    OK(stickslip_hertz_sphere(bodies, RADIUS, FORCE, &hertz));
    double depth = 0.481 * hertz.contact_radius;
    size_t count = 0;
    const double *pressure = stickslip_normal_solution_field(pressed, STICKSLIP_PRESSURE, &count);
    stickslip_tractions tractions = {pressure, NULL, NULL, count};
    stickslip_point points[] = {{0.0, 0.0, depth}, {0.5 * GRID.dx, 0.5 * GRID.dy, depth}, {0.0, 0.0, 40.0 * depth}};
    stickslip_response at[3], other[3];
    OK(stickslip_stress_at_points(bodies, STICKSLIP_BODY_1, &tractions, points, 3, at));
    CLOSE(0.5 * (at[0].principal_stress[0] - at[0].principal_stress[2]), 0.310 * hertz.max_pressure, 5e-3);
    /* On the axis the von Mises stress is twice the largest shear stress. */
    CLOSE(at[0].von_mises, at[0].principal_stress[0] - at[0].principal_stress[2], 1e-9);
    /* Far below the contact, Boussinesq's point force applies: szz = -3 P/(2 pi z^2). */
    CLOSE(at[2].normal_stress[2], -1.5 * FORCE / (acos(-1.0) * pow(points[2].depth, 2.0)), 1e-2);
    OK(stickslip_stress_at_points(bodies, STICKSLIP_BODY_2, &tractions, points, 3, other));
    CLOSE(other[0].displacement[2], -at[0].displacement[2], 1e-12);

    stickslip_planes *planes = NULL;
    double depths[] = {0.5 * depth, depth};
    OK(stickslip_planes_new(bodies, depths, 2, 1, &planes));
    CHECK(stickslip_planes_field(planes, STICKSLIP_STRESS_ZZ, NULL) == NULL);
    CHECK(stickslip_planes_warnings(planes, NULL, 0, &count) == STICKSLIP_INVALID_ARGUMENT);
    CHECK(stickslip_planes_measure(planes, STICKSLIP_VON_MISES, values, CELLS) == STICKSLIP_INVALID_ARGUMENT);
    OK(stickslip_planes_solve(planes, 1, STICKSLIP_BODY_1, &tractions));
    const double *szz = stickslip_planes_field(planes, STICKSLIP_STRESS_ZZ, &count);
    const double *down = stickslip_planes_field(planes, STICKSLIP_DISPLACEMENT_Z, NULL);
    size_t middle = CELLS / 2 + N / 2;
    CHECK(szz != NULL && down != NULL && count == CELLS);
    CLOSE(szz[middle], at[1].normal_stress[2], 1e-9);
    CLOSE(down[middle], at[1].displacement[2], 1e-9);
    OK(stickslip_planes_measure(planes, STICKSLIP_VON_MISES, values, CELLS));
    CLOSE(values[middle], at[1].von_mises, 1e-9);
    OK(stickslip_planes_measure(planes, STICKSLIP_MAX_SHEAR, values, CELLS));
    CLOSE(largest(values), 0.310 * hertz.max_pressure, 5e-3);
    /* A failure leaves the solved plane unchanged. */
    memcpy(values, szz, sizeof values);
    CHECK(stickslip_planes_solve(planes, 2, STICKSLIP_BODY_1, &tractions) == STICKSLIP_LENGTH);
    CHECK(stickslip_planes_solve(planes, SIZE_MAX, STICKSLIP_BODY_1, &tractions) == STICKSLIP_LENGTH);
    CHECK(stickslip_planes_solve(planes, 0, 3, &tractions) == STICKSLIP_UNKNOWN_OPTION);
    tractions.x = pressure;
    CHECK(stickslip_planes_solve(planes, 0, STICKSLIP_BODY_1, &tractions) == STICKSLIP_BAD_POINTER);
    CHECK(memcmp(values, stickslip_planes_field(planes, STICKSLIP_STRESS_ZZ, NULL), sizeof values) == 0);
    /* The shear traction along x equals the pressure, and the traction along y is half of it. */
    for (int i = 0; i < CELLS; i++) {
        half[i] = 0.5 * pressure[i];
    }
    tractions.y = half;
    OK(stickslip_stress_at_points(bodies, STICKSLIP_BODY_1, &tractions, &points[1], 1, at));
    OK(stickslip_planes_solve(planes, 1, STICKSLIP_BODY_1, &tractions));
    for (int i = 0; i < 3; i++) {
        CLOSE(stickslip_planes_field(planes, STICKSLIP_STRESS_XX + i, NULL)[middle], at[0].normal_stress[i], 1e-9);
        CLOSE(stickslip_planes_field(planes, STICKSLIP_STRESS_XY + i, NULL)[middle], at[0].shear_stress[i], 1e-9);
    }
    /* On the surface sxz = -qx and syz = -qy. */
    points[1].depth = 0.0;
    OK(stickslip_stress_at_points(bodies, STICKSLIP_BODY_1, &tractions, &points[1], 1, at));
    CLOSE(at[0].shear_stress[1], -pressure[middle], 1e-9);
    CLOSE(at[0].shear_stress[2], -half[middle], 1e-9);
    points[1].depth = -1.0;
    stickslip_error error;
    CHECK(stickslip_stress_at_points(bodies, STICKSLIP_BODY_1, &tractions, points, 3, at) == STICKSLIP_SAMPLE);
    OK(stickslip_last_error(&error));
    CHECK(error.index == 1 && error.value == -1.0);
    OK(stickslip_planes_free(planes));
    /* Below the edge of the sheared contact, the stress on the surface is inaccurate. */
    double surface = 0.0;
    stickslip_warning warning;
    OK(stickslip_planes_new(bodies, &surface, 1, 0, &planes));
    OK(stickslip_planes_solve(planes, 0, STICKSLIP_BODY_1, &tractions));
    OK(stickslip_planes_warnings(planes, &warning, 1, &count));
    CHECK(count == 1 && warning.kind == STICKSLIP_WARNING_STRESS_AT_EDGE);
    OK(stickslip_planes_free(planes));
    /* Without depths, no index is valid. */
    OK(stickslip_planes_new(bodies, NULL, 0, 0, &planes));
    CHECK(stickslip_planes_solve(planes, SIZE_MAX, STICKSLIP_BODY_1, &tractions) == STICKSLIP_LENGTH);
    OK(stickslip_planes_free(planes));
}

int main(void) {
    stickslip_half_space *bodies = NULL, *on_rigid = NULL;
    OK(stickslip_half_space_new(&GRID, &STEEL, &STEEL, NULL, &bodies));
    OK(stickslip_half_space_new(&GRID, &STEEL, &RIGID, NULL, &on_rigid));
    OK(stickslip_surface_sphere(&GRID, RADIUS, ball, CELLS));
    stickslip_normal_solution *pressed = press(bodies);
    closed_forms_are_met(bodies, pressed);
    stresses_are_those_of_hertz(bodies, pressed);
    stickslip_tractions tractions = {ball, NULL, NULL, CELLS};
    stickslip_point point = {0.0, 0.0, 0.1};
    stickslip_response at;
    CHECK(stickslip_stress_at_points(on_rigid, STICKSLIP_BODY_2, &tractions, &point, 1, &at) == STICKSLIP_RIGID_BODY);
    OK(stickslip_normal_solution_free(pressed));
    OK(stickslip_half_space_free(on_rigid));
    OK(stickslip_half_space_free(bodies));
    return report("stresses and closed forms");
}
