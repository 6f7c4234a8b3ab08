/* Random arguments: mostly useful values, sometimes invalid ones. */

#include <math.h>

#include "run.h"

uint64_t next(struct run *run) {
    run->state += 0x9e3779b97f4a7c15u;
    uint64_t z = run->state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

size_t below(struct run *run, size_t count) { return (size_t)(next(run) % count); }
bool rarely(struct run *run) { return below(run, 40) == 0; }
double unit(struct run *run) { return (double)(next(run) >> 11) * 0x1p-53; }

double number(struct run *run, double scale) {
    static const double odd[] = {0.0, -1.0, NAN, INFINITY, -INFINITY, 1e300, -1e300, 1e-300, 5e-324, -0.0};
    return rarely(run) ? odd[below(run, sizeof odd / sizeof *odd)] : scale * (0.2 + unit(run));
}

int32_t option(struct run *run, int32_t count) {
    return rarely(run) ? (int32_t)next(run) : (int32_t)below(run, (size_t)count);
}

const void *maybe(struct run *run, const void *pointer) {
    if (!rarely(run)) {
        return pointer;
    }
    return below(run, 2) == 0 || pointer == NULL ? NULL : (const char *)pointer + 1;
}
void *maybe_out(struct run *run, void *pointer) { return (void *)(uintptr_t)maybe(run, pointer); }

double *array(struct run *run, size_t *count, double scale) {
    size_t right = *count;
    if (rarely(run)) {
        const size_t odd[] = {0, 1, right + 1, right - 1, 2 * right, SIZE_MAX, SIZE_MAX / 8};
        *count = odd[below(run, 7)];
    }
    size_t length = *count < LARGE ? *count : 1;
    double *numbers = malloc((length == 0 ? 1 : length) * sizeof *numbers);
    for (size_t i = 0; i < length; i++) {
        numbers[i] = scale * unit(run);
    }
    if (length > 0 && rarely(run)) {
        numbers[below(run, length)] = number(run, scale);
    }
    return numbers;
}

stickslip_settings settings(struct run *run) {
    stickslip_settings settings = stickslip_settings_default();
    settings.method = option(run, 2);
    settings.tolerance = rarely(run) ? number(run, 0.1) : pow(10.0, -3.0 - 9.0 * unit(run));
    settings.max_iterations = rarely(run) ? below(run, 4) : 500;
    settings.time_limit = rarely(run) ? number(run, 1e-4) : INFINITY;
    return settings;
}

stickslip_friction friction(struct run *run, double *cells, size_t count) {
    stickslip_friction friction = stickslip_coulomb(number(run, 0.5));
    if (below(run, 4) == 0) {
        friction.coefficient.cells = maybe(run, cells);
        friction.coefficient.count = friction.coefficient.cells == NULL && !rarely(run) ? 0 : count;
    }
    if (below(run, 8) == 0) {
        friction.max_shear_stress = number(run, 0.2);
    }
    return friction;
}

stickslip_normal_load normal_load(struct run *run) {
    stickslip_normal_load load = {option(run, 3), 0.0};
    if (load.kind != STICKSLIP_HOLD || rarely(run)) {
        load.value = number(run, 0.1);
    }
    return load;
}

stickslip_control control(struct run *run) {
    stickslip_control control = {below(run, 3) == 0 ? option(run, 5) : STICKSLIP_HOLD, 0.0, 0.0};
    if (control.kind != STICKSLIP_HOLD || rarely(run)) {
        control.value = number(run, 0.02);
    }
    if (control.kind == STICKSLIP_SPRING || rarely(run)) {
        control.stiffness = number(run, 2.0);
    }
    return control;
}

stickslip_tangential_load tangential_load(struct run *run) {
    stickslip_tangential_load load = {control(run), control(run), below(run, 8) == 0 ? number(run, 1e-3) : 0.0};
    return load;
}

stickslip_load_step load_step(struct run *run) {
    stickslip_load_step load = {normal_load(run), control(run), control(run), below(run, 8) == 0, 0.0, below(run, 8) == 0, 0.0};
    if (load.has_twist != 0 || rarely(run)) {
        load.twist = number(run, 1e-3);
    }
    if (load.has_relative_displacement != 0 || rarely(run)) {
        load.relative_displacement = number(run, 0.01);
    }
    if (below(run, 3) == 0) {
        stickslip_roll roll = {rarely(run) ? UINT32_MAX >> below(run, 32) : below(run, 3), option(run, 4),
                               {number(run, 0.01), number(run, 0.01)}, below(run, 8) == 0 ? number(run, 0.01) : 0.0};
        load.roll = roll;
    }
    return load;
}

int32_t watch(const stickslip_iteration *iteration, void *user) {
    return iteration->iteration < *(size_t *)user;
}

