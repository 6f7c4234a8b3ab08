/* The floating-point settings of a program neither affect the library nor are changed by it. Traps do not end a solve, and
 * results are bitwise identical for every rounding mode. */

#define _GNU_SOURCE
#include <fenv.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

#define N 72 /* more cells than one thread takes */
#define CELLS (N * N)

static double ball[CELLS];

/* Presses and drags a ball, and copies the traction. */
static void run(double *traction) {
    stickslip_grid grid = {N, N, 0.3e-3 / N, 0.3e-3 / N};
    stickslip_material steel = {213e9, 0.29, 0.0};
    stickslip_friction friction = stickslip_coulomb(0.5);
    stickslip_history_options options = stickslip_history_options_default();
    options.model = STICKSLIP_VECTOR;
    stickslip_half_space *bodies = NULL;
    stickslip_history *history = NULL;
    OK(stickslip_surface_sphere(&grid, 3.5e-3, ball, CELLS));
    OK(stickslip_half_space_new(&grid, &steel, &steel, NULL, &bodies));
    OK(stickslip_history_new(bodies, ball, CELLS, &friction, &options, &history));
    for (int i = 0; i < 3; i++) {
        stickslip_load_step load = {0};
        load.normal.kind = STICKSLIP_FORCE, load.normal.value = 100.0;
        load.x.kind = STICKSLIP_FORCE, load.x.value = 10.0 * i;
        load.y.kind = STICKSLIP_FORCE, load.y.value = 5.0 * i;
        OK(stickslip_history_step(history, &load, NULL));
    }
    memcpy(traction, stickslip_history_field(history, STICKSLIP_TRACTION_X, NULL), CELLS * sizeof *traction);
    OK(stickslip_history_free(history));
    OK(stickslip_half_space_free(bodies));
}

int main(void) {
    static double usual[CELLS], other[CELLS];
    const int traps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
    run(usual);
    fesetround(FE_UPWARD);
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(traps);
    feraiseexcept(FE_INEXACT);
    /* The threads of the pool start at this call. */
    OK(stickslip_set_num_threads(2));
    run(other);
    CHECK(memcmp(usual, other, sizeof usual) == 0);
    CHECK(fegetround() == FE_UPWARD);
    CHECK(fegetexcept() == traps);
    CHECK(fetestexcept(FE_ALL_EXCEPT) == FE_INEXACT);
    fesetenv(FE_DFL_ENV);
    return report("floating-point settings");
}
