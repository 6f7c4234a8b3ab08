/* A steel ball on steel, pressed and sheared, compared with the solutions of Hertz and of Cattaneo and Mindlin. SI units.
 *   press_and_shear [cells along a side, default 128] */

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

/* Prints a number and its closed-form value, and returns whether they agree. */
static int agrees(const char *name, double found, double exact, double tolerance) {
    double error = found / exact - 1.0;
    printf("%-16s %.6e  closed form %.6e  difference %+.1e\n", name, found, exact, error);
    return fabs(error) <= tolerance;
}

int main(int argc, char **argv) {
    size_t n = argc > 1 ? strtoul(argv[1], NULL, 10) : 128;
    const double radius = 3.5e-3, load = 100.0, drag = 20.0, mu = 0.5, side = 0.40e-3;
    if (stickslip_abi_version() != STICKSLIP_ABI_VERSION) {
        fprintf(stderr, "the library is of another version\n");
        return 1;
    }

    stickslip_grid grid = {n, n, side / (double)n, side / (double)n};
    stickslip_material steel = {213e9, 0.29, 0.0};
    stickslip_half_space *bodies;
    need(stickslip_half_space_new(&grid, &steel, &steel, NULL, &bodies));
    double *ball = malloc(n * n * sizeof *ball);
    need(stickslip_surface_sphere(&grid, radius, ball, n * n));

    stickslip_normal_load press = {STICKSLIP_FORCE, load};
    stickslip_normal_solver *presser;
    stickslip_normal_solution *pressed;
    need(stickslip_normal_solver_new(bodies, ball, n * n, &press, NULL, NULL, &presser));
    need(stickslip_normal_solution_new(presser, &pressed));
    need(stickslip_normal_solver_solve(presser, pressed, NULL));

    stickslip_friction friction = stickslip_coulomb(mu);
    stickslip_tangential_load pull = {{STICKSLIP_FORCE, drag, 0.0}, {STICKSLIP_HOLD, 0.0, 0.0}, 0.0};
    stickslip_tangential_solver *shearer;
    stickslip_tangential_solution *sheared;
    need(stickslip_tangential_solver_new(bodies, pressed, &friction, &pull, NULL, &shearer));
    need(stickslip_tangential_solution_new(shearer, &sheared));
    need(stickslip_tangential_solver_solve(shearer, sheared, NULL));

    /* The pointers refer to the fields of the solutions; nothing is copied. */
    size_t count;
    const double *pressure = stickslip_normal_solution_field(pressed, STICKSLIP_PRESSURE, &count);
    double largest = 0.0;
    for (size_t i = 0; pressure != NULL && i < count; i++) {
        largest = fmax(largest, pressure[i]);
    }
    stickslip_normal_result normal;
    stickslip_tangential_result shear;
    stickslip_report report;
    need(stickslip_normal_solution_result(pressed, &normal));
    need(stickslip_tangential_solution_result(sheared, &shear));
    need(stickslip_tangential_solution_report(sheared, &report));

    stickslip_pair pair;
    need(stickslip_half_space_pair(bodies, &pair));
    double a = cbrt(0.75 * load * radius / pair.contact_modulus);
    double peak = 1.5 * load / (acos(-1.0) * a * a);
    double stick = cbrt(1.0 - drag / (mu * load));
    double shift = 3.0 * mu * load / (16.0 * pair.tangential_modulus * a) * (1.0 - stick * stick);
    /* The grid resolves pressure and shift to a fraction of a cell, and the stick zone to whole cells. */
    double cells = a / grid.dx;
    int good = agrees("approach", normal.approach, a * a / radius, 0.3 / (cells * cells));
    good &= agrees("largest pressure", largest, peak, 3.0 / (cells * cells));
    good &= agrees("shift", shear.shift[0], shift, 1.0 / (cells * cells));
    good &= agrees("stick ratio", shear.stick_ratio, stick * stick, 0.6 / cells);
    good &= report.energy_error_bound <= 1e-8;

    /* A force above the friction capacity is rejected; the error contains the limit. */
    stickslip_error error;
    pull.x.value = 60.0;
    good &= stickslip_tangential_solver_set_load(shearer, &pull) == STICKSLIP_BEYOND_FRICTION_CAPACITY;
    need(stickslip_last_error(&error));
    printf("refused: %s\n", stickslip_last_error_message());
    good &= error.value == 60.0 && fabs(error.limit - mu * load) < 1e-6;

    stickslip_tangential_solution_free(sheared);
    stickslip_tangential_solver_free(shearer);
    stickslip_normal_solution_free(pressed);
    stickslip_normal_solver_free(presser);
    stickslip_half_space_free(bodies);
    free(ball);
    return good ? 0 : 1;
}
