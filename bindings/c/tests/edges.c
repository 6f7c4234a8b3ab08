/* Edges inside the cells and error estimates for a ball with known contact and stick zones. */

#include <math.h>
#include <stdlib.h>

#include "check.h"

#define N 64
#define CELLS ((size_t)N * N)

static const double PI = 3.14159265358979323846;
static double gap[CELLS], centres[CELLS], means[CELLS];

static double sum(const double *values) {
    double total = 0.0;
    for (size_t i = 0; i < CELLS; i++) {
        total += values[i];
    }
    return total;
}

int main(void) {
    /* The contact radius is one under a force of 4/3. */
    const stickslip_grid grid = {N, N, 3.0 / N, 3.0 / N};
    const stickslip_material body = {2.0, 0.0, 0.0};
    const double area = grid.dx * grid.dy, force = 0.4 * 0.5 * 4.0 / 3.0;
    stickslip_half_space *bodies = NULL;
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_solution *pressed = NULL;
    stickslip_normal_load load = {STICKSLIP_FORCE, 4.0 / 3.0};
    stickslip_edges edges;
    double estimate = 0.0;
    OK(stickslip_surface_sphere(&grid, 1.0, gap, CELLS));
    OK(stickslip_half_space_new(&grid, &body, &body, NULL, &bodies));
    OK(stickslip_half_space_set_cell_value(bodies, STICKSLIP_CENTRE));
    OK(stickslip_normal_solver_new(bodies, gap, CELLS, &load, NULL, NULL, &presser));
    OK(stickslip_normal_solution_new(presser, &pressed));
    OK(stickslip_normal_solution_discretisation_estimate(pressed, &estimate));
    CHECK(isnan(estimate));
    OK(stickslip_normal_solver_solve(presser, pressed, NULL));
    OK(stickslip_normal_solution_edges(pressed, &edges, centres, means, CELLS));
    CLOSE(edges.contact_area, PI, 1e-3);
    CHECK(edges.unfitted_fraction == 0.0 && isnan(edges.stick_area) && isnan(edges.peak_traction));
    CLOSE(edges.peak_pressure, 2.0 / PI, 1e-3);
    CLOSE(sum(means) * area, 4.0 / 3.0, 1e-3);
    CHECK(sum(centres) > 0.0);
    OK(stickslip_normal_solution_edges(pressed, &edges, NULL, NULL, 0));
    OK(stickslip_normal_solution_discretisation_estimate(pressed, &estimate));
    CHECK(estimate > 1e-4 && estimate < 1e-2);
    CHECK(stickslip_normal_solution_edges(pressed, &edges, centres, NULL, CELLS - 1) == STICKSLIP_LENGTH);
    CHECK(stickslip_normal_solution_edges(pressed, NULL, centres, NULL, CELLS) == STICKSLIP_BAD_POINTER);
    CHECK(stickslip_normal_solution_edges(NULL, &edges, centres, NULL, CELLS) == STICKSLIP_BAD_POINTER);

    /* Cattaneo and Mindlin: the stick ratio is 0.6^(2/3). */
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_tangential_load drag = {{STICKSLIP_FORCE, force, 0.0}, {0}, 0.0};
    stickslip_tangential_solver *shearer = NULL;
    stickslip_tangential_solution *sheared = NULL;
    OK(stickslip_tangential_solver_new(bodies, pressed, &friction, &drag, NULL, &shearer));
    OK(stickslip_tangential_solution_new(shearer, &sheared));
    OK(stickslip_tangential_solver_solve(shearer, sheared, NULL));
    OK(stickslip_tangential_solution_edges(sheared, pressed, &friction, &edges, centres, means, CELLS));
    CLOSE(edges.stick_ratio, pow(0.6, 2.0 / 3.0), 2e-3);
    CLOSE(edges.stick_area + edges.slip_area, PI, 1e-3);
    CLOSE(sum(means) * area, force, 2e-3);
    CHECK(edges.stick_unfitted_fraction == 0.0 && edges.peak_traction < 1.0 / PI);
    CHECK(stickslip_tangential_solution_edges(sheared, pressed, NULL, &edges, NULL, NULL, 0) == STICKSLIP_BAD_POINTER);
    OK(stickslip_tangential_solution_discretisation_estimate(sheared, &estimate));
    CHECK(estimate > 1e-3 && estimate < 5e-2);

    /* Coupled solution: bodies of the same material give the same result. */
    stickslip_coupled_solver *solver = NULL;
    stickslip_coupled_solution *both = NULL;
    stickslip_edges together;
    double traction = 0.0;
    OK(stickslip_coupled_solver_new(bodies, gap, CELLS, &friction, &load, &drag, NULL, NULL, NULL, &solver));
    OK(stickslip_coupled_solution_new(solver, &both));
    OK(stickslip_coupled_solver_solve(solver, both, NULL));
    OK(stickslip_coupled_solution_edges(both, &friction, &together, NULL, NULL, 0));
    CLOSE(together.contact_area, edges.contact_area, 1e-4);
    CLOSE(together.stick_area, edges.stick_area, 1e-3);
    OK(stickslip_coupled_solution_pressure_edges(both, &together, centres, NULL, CELLS));
    CLOSE(together.peak_pressure, 2.0 / PI, 1e-3);
    OK(stickslip_coupled_solution_discretisation_estimates(both, &estimate, &traction));
    CHECK(estimate > 1e-4 && traction > estimate);
    CHECK(stickslip_coupled_solution_discretisation_estimates(both, &estimate, NULL) == STICKSLIP_BAD_POINTER);

    OK(stickslip_coupled_solution_free(both));
    OK(stickslip_coupled_solver_free(solver));
    OK(stickslip_tangential_solution_free(sheared));
    OK(stickslip_tangential_solver_free(shearer));
    OK(stickslip_normal_solution_free(pressed));
    OK(stickslip_normal_solver_free(presser));
    OK(stickslip_half_space_free(bodies));
    return report("edges and estimates");
}
