/* Shared library with libstickslip.a inside. */

#include <stickslip.h>

/* Returns the contact modulus of two bodies of the same material, or 0 for an invalid material. */
double plugin_modulus(double youngs_modulus, double poisson_ratio);

double plugin_modulus(double youngs_modulus, double poisson_ratio) {
    stickslip_grid grid = {4, 4, 1.0, 1.0};
    stickslip_material material = {youngs_modulus, poisson_ratio, 0.0};
    stickslip_half_space *bodies = NULL;
    stickslip_pair pair = {0};
    if (stickslip_half_space_new(&grid, &material, &material, NULL, &bodies) == STICKSLIP_OK) {
        stickslip_half_space_pair(bodies, &pair);
    }
    stickslip_half_space_free(bodies);
    return pair.contact_modulus;
}
