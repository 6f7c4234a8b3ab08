// Surfaces, stresses, closed-form solutions, spots, jumps and exceptions of the C++ interface.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include <stickslip.hpp>

namespace ss = stickslip;

// A view does not own its samples, so it refers to no temporary vector. Arguments may be temporary.
using Vector = std::vector<double>;
static_assert(!std::is_constructible<ss::Field, Vector>::value, "view of a temporary vector");
static_assert(!std::is_constructible<ss::Field, const Vector>::value, "view of a constant temporary vector");
static_assert(!std::is_convertible<Vector, ss::Field>::value, "conversion of a temporary vector");
static_assert(!std::is_assignable<ss::Field &, Vector>::value, "assignment of a temporary vector");
static_assert(std::is_constructible<ss::Field, Vector &>::value, "view of a vector");
static_assert(std::is_convertible<const Vector &, ss::Field>::value, "conversion of a vector");
static_assert(std::is_constructible<ss::FieldArgument, Vector>::value, "temporary vector as an argument");
static_assert(std::is_constructible<ss::FieldArgument, ss::Field>::value, "view as an argument");
static_assert(std::is_constructible<ss::FieldArgument, const Vector>::value, "constant temporary vector as an argument");
static_assert(!std::is_copy_constructible<ss::FieldArgument>::value, "copy of an argument");
static_assert(std::is_constructible<ss::NormalSolver, ss::HalfSpace &, Vector, stickslip_normal_load>::value,
              "solver of a temporary gap");

// Members of a temporary object return a copy, which does not convert to a view. Members of a stored object return a view.
template <class Object> using Pressure = decltype(std::declval<Object>().pressure());
template <class Object> using Any = decltype(std::declval<Object>().field(STICKSLIP_PRESSURE));
template <class Object> using AllZones = decltype(std::declval<Object>().zones());
static_assert(std::is_same<Pressure<ss::NormalSolution>, Vector>::value, "pressure of a temporary solution");
static_assert(std::is_same<Pressure<const ss::NormalSolution>, Vector>::value, "pressure of a constant temporary solution");
static_assert(!std::is_convertible<Pressure<ss::NormalSolution>, ss::Field>::value, "view of a temporary solution");
static_assert(std::is_same<Pressure<ss::NormalSolution &>, ss::Field>::value, "view of a solution");
static_assert(std::is_same<Any<ss::NormalSolution>, Vector>::value, "field of a temporary normal solution");
static_assert(std::is_same<Any<ss::TangentialSolution>, Vector>::value, "field of a temporary tangential solution");
static_assert(std::is_same<Any<ss::CoupledSolution>, Vector>::value, "field of a temporary coupled solution");
static_assert(std::is_same<Any<ss::RollingSolution>, Vector>::value, "field of a temporary rolling solution");
static_assert(std::is_same<Any<ss::History>, Vector>::value, "field of a temporary history");
static_assert(std::is_same<Any<ss::Cycle>, Vector>::value, "field of a temporary cycle");
static_assert(std::is_same<Any<ss::Planes>, Vector>::value, "field of temporary planes");
static_assert(std::is_same<AllZones<ss::History>, std::vector<std::uint8_t>>::value, "zones of a temporary history");
static_assert(std::is_same<AllZones<ss::History &>, ss::Zones>::value, "zones of a history");
// A statement with tractions(solver.solve().pressure()) does not compile.
template <class Object, class = void> struct HasTractions : std::false_type {};
template <class Object>
struct HasTractions<Object, decltype(void(ss::tractions(std::declval<Object>().pressure())))> : std::true_type {};
static_assert(!HasTractions<ss::NormalSolution>::value, "tractions of a temporary solution");
static_assert(HasTractions<const ss::NormalSolution &>::value, "tractions of a solution");

static int failures = 0;

static void check(bool condition, const char *what) {
    if (!condition) {
        std::fprintf(stderr, "%s\n", what);
        failures++;
    }
}

template <class Call> static void fails(stickslip_status code, Call call) {
    try {
        call();
        check(false, "no exception");
    } catch (const ss::Error &error) {
        check(error.code() == code, error.what());
    }
}

// The caller of a batch reads the codes. Errors of use throw, and no contact takes a step.
static void step_batches(const ss::Grid &grid, const ss::HalfSpace &bodies) {
    ss::History one(bodies, ss::sphere(grid, 5.0), ss::coulomb(0.3)), other(bodies, ss::sphere(grid, 5.0), ss::coulomb(0.3));
    const ss::LoadStep good = ss::step(ss::press_by_force(100.0)), bad = ss::step(ss::press_by_force(-100.0));
    const std::vector<stickslip_status> codes = ss::step_all({&one, &other}, {good, bad});
    check(codes[0] == STICKSLIP_OK && codes[1] != STICKSLIP_OK, "codes of a batch");
    const Vector before = one.pressure().copy();
    for (ss::History *second : {&one, static_cast<ss::History *>(nullptr)}) {
        std::string refused;
        try {
            const auto unread = ss::step_all({&one, second}, {ss::step(ss::press_by_force(200.0)), good});
            check(unread.empty(), "no exception");
        } catch (const std::invalid_argument &reason) {
            refused = reason.what();
        }
        const char *due = second == nullptr ? "a history is a null pointer" : "a history occurs twice: pass each history once";
        check(refused == due && one.pressure().copy() == before, "a batch with a history that is missing or repeated");
    }
}

int main() {
    const std::size_t n = 48;
    const ss::Grid grid{n, n, 0.4 / n, 0.4 / n};
    const ss::Material steel = ss::elastic(210e3, 0.3);
    const ss::HalfSpace bodies(grid, steel, steel);
    const ss::NormalSolution pressed = ss::NormalSolver(bodies, ss::sphere(grid, 5.0), ss::press_by_force(100.0)).solve();
    const stickslip_hertz hertz = ss::hertz_sphere(bodies, 5.0, 100.0);
    check(std::fabs(pressed.result().approach / hertz.approach - 1.0) < 5e-3, "approach");
    check(ss::cattaneo_mindlin_sphere(bodies, 5.0, 100.0, 0.5, 50.0).stick_radius < 1e-4, "gross slip");
    fails(STICKSLIP_BEYOND_FRICTION_CAPACITY, [&] { ss::cattaneo_mindlin_sphere(bodies, 5.0, 100.0, 0.5, 60.0); });

    // Position and stiffness of a spring are exchanged.
    ss::TangentialSolver(bodies, pressed, ss::coulomb(0.5), ss::tangential(ss::spring(2e-4, 1e5))).solve();
    fails(STICKSLIP_UNSUPPORTED_BY_MODEL, [&] {
        ss::TangentialSolver(bodies, pressed, ss::coulomb(0.5), ss::tangential(ss::spring(5e5, 4e-5)));
    });

    // A temporary solution and a stored one have the same samples, which a copy keeps.
    ss::NormalSolver presser(bodies, ss::sphere(grid, 5.0), ss::press_by_force(100.0));
    ss::NormalSolution now = presser.solve();
    const Vector kept_samples = now.pressure().copy();
    const auto of_temporary = ss::NormalSolver(bodies, ss::sphere(grid, 5.0), ss::press_by_force(100.0)).solve().pressure();
    check(of_temporary == kept_samples && of_temporary.size() == n * n, "pressure of a temporary solution");
    presser.set_load(ss::press_by_force(50.0));
    presser.solve_into(now);
    const std::size_t centre = n * n / 2 + n / 2;
    check(kept_samples[centre] == of_temporary[centre] && now.pressure()[centre] < kept_samples[centre], "copy of a field");

    // A stored argument owns the samples of a temporary vector, and refers to the samples of a stored one.
    Vector moved(4, 1.0);
    const double *const samples = moved.data();
    const ss::FieldArgument of_moved(std::move(moved));
    check(moved.empty() && of_moved.data() == samples && of_moved.size() == 4, "argument of a temporary vector");
    const ss::FieldArgument of_constant(static_cast<const Vector &&>(kept_samples));
    check(of_constant.data() != kept_samples.data() && of_constant.size() == n * n, "argument of a constant temporary vector");
    const ss::FieldArgument of_stored(kept_samples);
    check(of_stored.data() == kept_samples.data(), "argument of a stored vector");

    // The message for a moved-from object names its kind.
    ss::NormalSolver emptied(bodies, ss::sphere(grid, 5.0), ss::press_by_force(100.0));
    const ss::NormalSolver owner(std::move(emptied));
    fails(STICKSLIP_BAD_POINTER, [&] { emptied.set_load(ss::press_by_force(50.0)); });
    const std::string text = stickslip_last_error_message();
    check(text == "normal solver is NULL or misaligned: create the object and check the status of its creation, and do not use an object that was moved or freed", text.c_str());

    // A layer with the modulus of its body changes nothing, and a harder layer reduces the approach.
    const auto under = [&](double modulus) {
        const ss::Coated body{steel, {{modulus, 0.3, 0.02}}};
        const ss::HalfSpace coated(grid, body, body);
        return ss::NormalSolver(coated, ss::sphere(grid, 5.0), ss::press_by_force(100.0)).solve().result().approach;
    };
    check(std::fabs(under(210e3) / pressed.result().approach - 1.0) < 1e-7, "layer with the modulus of its body");
    check(under(420e3) < 0.99 * pressed.result().approach, "a hard layer reduces the approach");
    fails(STICKSLIP_NOT_POSITIVE, [&] { under(-1.0); });

    // Near the origin, an ellipsoid with one large radius has the gap of a cylinder, and one with equal radii that of a sphere.
    const Vector round = ss::ellipsoid(grid, 5.0, 5.0), wide = ss::ellipsoid(grid, 5.0, 1e12), ball = ss::sphere(grid, 5.0);
    const Vector along_y = ss::cylinder(grid, 5.0);
    const std::size_t near = centre + 3;
    check(std::fabs(round[near] / ball[near] - 1.0) < 1e-3, "gap of an ellipsoid");
    check(std::fabs(wide[near] / along_y[near] - 1.0) < 1e-3, "gap of a cylinder");
    fails(STICKSLIP_NOT_POSITIVE, [&] { ss::cylinder(grid, 0.0); });

    // The largest shear stress is 0.310 p0, at the depth 0.481 a.
    const double depth = 0.481 * hertz.contact_radius;
    const ss::Tractions load = ss::tractions(pressed.pressure());
    ss::Planes planes(bodies, {depth});
    fails(STICKSLIP_INVALID_ARGUMENT, [&] { planes.field(STICKSLIP_STRESS_ZZ); });
    planes.solve(0, STICKSLIP_BODY_1, load);
    const std::vector<double> shear = planes.measure(STICKSLIP_MAX_SHEAR);
    const double largest = *std::max_element(shear.begin(), shear.end());
    check(std::fabs(largest / hertz.max_pressure - 0.310) < 2e-3, "largest shear stress");
    const ss::Response at = ss::stress_at(bodies, STICKSLIP_BODY_1, load, {{0.5 * grid.dx, 0.5 * grid.dy, depth}}).front();
    check(std::fabs(planes.field(STICKSLIP_STRESS_ZZ)[n * n / 2 + n / 2] / at.normal_stress[2] - 1.0) < 1e-9, "szz");
    fails(STICKSLIP_UNKNOWN_OPTION, [&] { planes.solve(0, 0, load); });
    // On the surface sxz = -qx and syz = -qy.
    const std::size_t middle = n * n / 2 + n / 2;
    std::vector<double> half(pressed.pressure().begin(), pressed.pressure().end());
    for (double &traction : half) {
        traction *= 0.5;
    }
    const ss::Tractions sheared = ss::tractions(pressed.pressure(), pressed.pressure(), half);
    const ss::Response on = ss::stress_at(bodies, STICKSLIP_BODY_1, sheared, {{0.5 * grid.dx, 0.5 * grid.dy, 0.0}}).front();
    check(std::fabs(on.shear_stress[1] / pressed.pressure()[middle] + 1.0) < 1e-9, "sxz");
    check(std::fabs(on.shear_stress[2] / half[middle] + 1.0) < 1e-9, "syz");

    // Stiffnesses and planes accept an observer, which may end them.
    const ss::Observe stop = [](const ss::Iteration &) { return false; };
    fails(STICKSLIP_NOT_CONVERGED, [&] { pressed.stiffness(bodies, stop); });
    fails(STICKSLIP_NOT_CONVERGED, [&] { planes.solve(0, STICKSLIP_BODY_1, load, stop); });
    check(bodies.first_row() == 0 && bodies.grid().nx == n, "grid of the bodies");

    const ss::Spots one = pressed.spots();
    check(one.spots.size() == 1 && one.labels[middle] == 1 && one.labels[0] == 0, "one spot");
    check(one.spots[0].cells == pressed.result().contact_cells, "cells of the spot");

    const double area = std::acos(-1.0) * hertz.contact_radius * hertz.contact_radius;
    const ss::Edges found_edges = pressed.edges();
    check(std::fabs(found_edges.edges.contact_area / area - 1.0) < 0.02, "area within the edge");
    check(found_edges.centres[middle] == pressed.pressure()[middle], "pressure away from the edge");
    check(pressed.discretisation_estimate() > 0.0 && pressed.discretisation_estimate() < 0.05, "estimate");

    ss::History history(bodies, ss::sphere(grid, 5.0), ss::coulomb(0.3));
    history.step(ss::step(ss::press_by_force(100.0)));
    const double amplitude = 0.2 * history.result().approach;
    ss::Cycle cycle(history);
    std::vector<double> worn(n * n);
    for (const double shift : {amplitude, -amplitude, 0.0}) {
        history.step(ss::step(ss::held_pressure(), ss::shift(shift)));
        cycle.add(history);
        history.wear_archard({1e-6, nullptr, 0}, worn);
    }
    check(history.spots().spots[0].stick_ratio == history.result().stick_ratio, "stick ratio of the spot");
    // An observer and a cycle receive every step of a load. An exception of the observer undoes the steps.
    ss::History parted = history.clone();
    ss::AdaptiveSteps steps(parted, 0.05);
    const ss::LoadStep further = ss::step(ss::held_pressure(), ss::shift(2.0 * amplitude));
    const ss::LoadStep deeper = ss::step(ss::press_by_force(200.0));
    for (const bool is_pressed : {false, true}) {
        ss::Cycle sums(parted);
        const stickslip_step_result start = parted.result();
        std::size_t seen = 0;
        const auto take = [&](ss::Cycle *to, const ss::ObserveStep &observe) {
            return is_pressed ? ss::press_stepwise(parted, deeper, 0.05, to, observe)
                              : steps.stepwise(parted, further, to, observe);
        };
        fails(STICKSLIP_NOT_CONVERGED, [&] { take(nullptr, [](const stickslip_step_result &) { return false; }); });
        bool is_thrown = false;
        try {
            take(nullptr, [](const stickslip_step_result &) -> bool { throw std::runtime_error("stop"); });
        } catch (const std::runtime_error &) {
            is_thrown = true;
        }
        check(is_thrown && parted.result().steps == start.steps && parted.result().force[0] == start.force[0], "undone steps");
        const std::size_t taken = take(&sums, [&](const stickslip_step_result &step) {
            seen++;
            return step.has_last_step != 0;
        });
        check(taken >= 2 && seen == taken && sums.result().steps == taken, "observed steps");
    }
    // A restored state has no last step.
    ss::State kept(history);
    history.set_state(kept);
    fails(STICKSLIP_NO_LAST_STEP, [&] { cycle.add(history); });
    fails(STICKSLIP_NO_LAST_STEP, [&] { history.wear_archard({1e-6, nullptr, 0}, worn); });
    check(history.result().has_last_step == 0 && std::isnan(history.result().stick_ratio), "no last step");
    stickslip_jump_limits limits = stickslip_jump_limits_default();
    limits.cycles_left = 7.0;
    limits.max_residual = 2.0;
    check(cycle.jump(bodies, worn, limits) == 7.0, "all remaining cycles");
    check(ss::max_stable_cycles(bodies, {1e-6, nullptr, 0}, cycle.field(STICKSLIP_SLIP_DISTANCE)) > 7.0, "stable");
    limits.max_residual = 0.0;
    fails(STICKSLIP_CYCLE_NOT_CLOSED, [&] { cycle.jump(bodies, worn, limits); });

    // A contact of dissimilar bodies has the stiffness of a history after the same first step.
    const ss::HalfSpace dissimilar(grid, steel, {INFINITY, 0.0, 0.0});
    const ss::HalfSpace braced(grid, {210e3, 0.3, 0.0}, {210e3, 0.3, 0.0});
    check(braced.pair().contact_modulus > 0.0, "materials from initialiser lists");
    const stickslip_friction law = ss::coulomb(0.3);
    const stickslip_normal_load press = ss::press_by_force(100.0);
    const stickslip_control drag = ss::force(10.0);
    ss::CoupledSolver solver(dissimilar, ss::sphere(grid, 5.0), law, press, ss::tangential(drag));
    const ss::CoupledSolution both = solver.solve();
    check(both.edges(law).edges.contact_area == both.pressure_edges().edges.contact_area, "edges of a coupled contact");
    check(both.discretisation_estimates().second > 0.0, "error estimate of the traction");
    const ss::Stiffness found = both.stiffness(dissimilar, law);
    stickslip_history_options whole = stickslip_history_options_default();
    whole.model = STICKSLIP_VECTOR;
    whole.entry_rule = STICKSLIP_WHOLE_STEP;
    ss::History same(dissimilar, ss::sphere(grid, 5.0), law, whole);
    same.step(ss::step(press, drag));
    const ss::Stiffness expected = same.stiffness();
    check(std::fabs(found.normal.value / expected.normal.value - 1.0) < 1e-6, "normal stiffness");
    check(std::fabs(found.tangential.loading[0][0] / expected.tangential.loading[0][0] - 1.0) < 1e-6, "stiffness along x");
    check(std::fabs(found.normal_by_motion[0] / expected.normal_by_motion[0] - 1.0) < 1e-4, "change of normal force");

    // A workspace gives the same stiffness, also after a change of its options.
    ss::StiffnessWorkspace workspace;
    check(same.stiffness(workspace).normal.value == expected.normal.value, "stiffness with a workspace");
    check(workspace.report().status == STICKSLIP_CONVERGED, "report of the stiffness");
    ss::StiffnessOptions options = stickslip_stiffness_options_default();
    options.reversal = 0;
    options.next_step = 1;
    workspace.set_options(options);
    const ss::Stiffness ahead = same.stiffness(workspace);
    check(ahead.tangential.loading[0][0] == same.next_stiffness().tangential.loading[0][0], "stiffness of the next step");
    check(std::isnan(ahead.tangential.reversal[0][0]), "no stiffness at reversal");
    options.tolerance = 0.0;
    fails(STICKSLIP_TOLERANCE, [&] { workspace.set_options(options); });
    fails(STICKSLIP_NOT_CONVERGED, [&] { same.stiffness(workspace, [](const ss::Iteration &) { return false; }); });

    // Rolling: Carter's force, and a creep curve of a ball from zero force to sliding.
    const stickslip_carter carter = ss::carter_cylinder(bodies, 10.0, 100.0, 0.3, 1e-4);
    const double sticks = 1.0 - 1e-4 / carter.sliding_creepage;
    check(std::fabs(carter.force / (30.0 * (1.0 - sticks * sticks)) - 1.0) < 1e-12, "Carter");
    ss::RollingSolver roller(bodies, pressed, law);
    const double linear = roller.stiffness().slopes[0][0];
    // The coefficient lies between the values of Kalker's table for Poisson's ratios of 1/4 and 1/2.
    const double unit = 210e3 / 2.6 * hertz.contact_radius * hertz.contact_radius;
    check(std::fabs(linear / unit / 4.31 - 1.0) < 0.03, "C11");
    const std::vector<ss::CreepForce> curve = roller.creep_forces({{{0.0, 0.0}, 0.0}, {{0.1, 0.0}, 0.0}});
    check(curve[0].force[0] == 0.0 && std::fabs(curve[1].force[0] / 30.0 - 1.0) < 1e-3, "creep curve");
    roller.set_load(ss::rolling(ss::rolling_force(10.0), ss::creepage(1e-4), ss::spin(1e-3)));
    const ss::RollingSolution rolled = roller.solve();
    check(std::fabs(rolled.result().force[0] / 10.0 - 1.0) < 1e-8 && rolled.result().creepage[0] > 10.0 / linear, "force");
    check(rolled.result().creepage[1] == 1e-4 && rolled.result().spin == 1e-3, "lateral creepage and spin");
    const std::vector<double> lost = rolled.dissipation_per_area();
    check(*std::min_element(lost.begin(), lost.end()) == 0.0 && *std::max_element(lost.begin(), lost.end()) > 0.0, "lost");
    fails(STICKSLIP_BEYOND_FRICTION_CAPACITY, [&] { roller.set_load(ss::rolling(ss::rolling_force(31.0))); });
    fails(STICKSLIP_BEYOND_FRICTION_CAPACITY,
          [&] { roller.set_load(ss::rolling(ss::creepage(0.0), ss::creepage(0.0), ss::moment(1e3))); });
    roller.set_friction(ss::coulomb(0.6));
    check(roller.solve().result().creepage[0] < rolled.result().creepage[0], "less creepage with more friction");
    roller.reset();
    check(std::fabs(roller.stiffness().slopes[0][0] / linear - 1.0) < 1e-9, "full stick after reset");
    const ss::Observe never = [](const ss::Iteration &) { return false; };
    fails(STICKSLIP_NOT_CONVERGED, [&] { roller.stiffness(never); });
    fails(STICKSLIP_NOT_CONVERGED, [&] { roller.creep_forces({{{0.1, 0.0}, 0.0}}, never); });
    // The points solved before an observer ends the call are kept, also if it throws. No point is kept if one is invalid.
    const std::vector<ss::CreepPoint> two_points = {{{0.05, 0.0}, 0.0}, {{0.1, 0.0}, 0.0}};
    std::vector<ss::CreepForce> kept_forces, all_forces;
    std::size_t products = 0;
    roller.reset();
    roller.creep_forces_into({two_points[0]}, all_forces, [&](const ss::Iteration &) { return ++products > 0; });
    const std::size_t of_first = products;
    const ss::Observe end_in_second = [&](const ss::Iteration &) { return ++products <= of_first + 1; };
    const ss::Observe throw_in_second = [&](const ss::Iteration &) {
        return ++products <= of_first + 1 ? true : throw std::runtime_error("stop");
    };
    for (const ss::Observe &observe : {end_in_second, throw_in_second}) {
        products = 0;
        roller.reset();
        bool is_ended = false;
        try {
            roller.creep_forces_into(two_points, kept_forces, observe);
        } catch (const std::runtime_error &) {
            is_ended = true;
        }
        check(is_ended && kept_forces.size() == 1 && kept_forces[0].force[0] == all_forces[0].force[0], "kept points");
    }
    fails(STICKSLIP_NOT_FINITE, [&] { roller.creep_forces_into({two_points[0], {{NAN, 0.0}, 0.0}}, kept_forces); });
    check(kept_forces.empty(), "no point of an invalid curve");
    roller.creep_forces_into(two_points, kept_forces);
    check(kept_forces.size() == 2 && kept_forces[1].force[0] > kept_forces[0].force[0], "a creep curve in a vector");
    // Creepages in per cent cause one warning for the whole curve.
    roller.creep_forces({{{0.2, 0.0}, 0.0}, {{0.3, 0.0}, 0.0}});
    check(roller.creep_warnings().size() == 1 && roller.creep_warnings()[0].kind == STICKSLIP_WARNING_LARGE_CREEPAGE,
          "warnings of a creep curve");
    // The normal contact of a new load, computed by a copy of the normal solver.
    ss::NormalSolver reused(bodies, ss::sphere(grid, 5.0), press);
    ss::NormalSolution lighter = reused.solve();
    fails(STICKSLIP_OUTDATED_SOLUTION, [&] { roller.normal(lighter); });
    roller.set_normal_solver(reused);
    roller.set_normal_load(ss::press_by_force(90.0));
    roller.normal(lighter);
    check(std::fabs(lighter.result().force / 90.0 - 1.0) < 1e-8, "normal contact of a rolling solver");
    const stickslip_kalker kalker = ss::kalker_coefficients(1.0, steel.poisson_ratio);
    check(std::fabs(kalker.c11 * unit / linear - 1.0) < 0.02, "C11 of the table");
    const stickslip_vermeulen_johnson slight = ss::vermeulen_johnson_ellipse(bodies, 5.0, 5.0, 100.0, 0.3, 1e-7, 0.0);
    check(std::fabs(slight.force[0] / (1e-7 * kalker.c11 * unit) - 1.0) < 1e-3, "Vermeulen and Johnson");
    check(ss::bentall_johnson_cylinder(bodies, 10.0, 100.0, 0.01).creepage == 0.0, "Bentall and Johnson");

    // Steady rolling of dissimilar bodies: the stiffness predicts the force at a slightly larger creepage.
    ss::CoupledRollingSolver slider(dissimilar, ss::sphere(grid, 5.0), law, press, ss::rolling(ss::creepage(1e-3)));
    const ss::CoupledRollingSolution before = slider.solve();
    check(before.report().work.status == STICKSLIP_CONVERGED, "coupled rolling");
    check(std::fabs(before.normal_result().force / 100.0 - 1.0) < 1e-6, "normal force of coupled rolling");
    check(before.pressure().size() == n * n && before.zones().size() == n * n, "fields of coupled rolling");
    for (const stickslip_warning &warning : before.warnings()) {
        check(warning.kind != STICKSLIP_WARNING_NO_CONTACT, warning.message);
    }
    const double slope = slider.stiffness().slopes[0][0];
    slider.set_load(ss::rolling(ss::creepage(1.001e-3)));
    const double change = slider.solve().rolling_result().force[0] - before.rolling_result().force[0];
    check(std::fabs(change / (1e-6 * slope) - 1.0) < 0.02, "stiffness of coupled rolling");

    // Stepwise rolling.
    stickslip_history_options in_the_plane = stickslip_history_options_default();
    in_the_plane.model = STICKSLIP_VECTOR;
    ss::History rolls(bodies, ss::sphere(grid, 5.0), law, in_the_plane);
    rolls.step(ss::step(ss::press_by_force(100.0)));
    const ss::LoadStep roll = ss::rolled(ss::step(ss::held_pressure()), 1, 1e-4);
    const double once = rolls.step(roll).force[0];
    const stickslip_step_result twice = rolls.step(roll);
    check(once > 0.0 && twice.force[0] > once && twice.creepage[0] == 1e-4, "history with rolling");
    const stickslip_step_result sideways = rolls.step(ss::rolled(
        ss::step(ss::held_pressure(), ss::force(0.5 * once)), 2, 0.0, 1e-4, 1e-3, STICKSLIP_MINUS_X));
    check(std::fabs(sideways.force[0] / (0.5 * once) - 1.0) < 1e-8 && sideways.creepage[1] == 1e-4, "force and creepage");
    check(std::fabs(sideways.twist / (2.0 * grid.dx * 1e-3) - 1.0) < 1e-12, "spin over two cells");
    check(std::fabs((sideways.shift[1] - twice.shift[1]) / (2.0 * grid.dx * 1e-4) - 1.0) < 1e-12, "travel of two cells");
    fails(STICKSLIP_UNSUPPORTED_BY_MODEL, [&] { rolls.step(ss::rolled(ss::step(ss::held_pressure(), ss::shift(1e-3)), 1)); });
    std::string refused;
    try {
        ss::rolled(ss::step(ss::held_pressure(), ss::force(0.5 * once)), 0);
    } catch (const std::invalid_argument &reason) {
        refused = reason.what();
    }
    check(refused == "rolled: cells is 0: a rolling step covers at least one cell", "rolling by no cells");

    step_batches(grid, bodies);

    // A bulk strain makes cells slip without a force.
    const ss::RelativeDisplacement bulk = ss::bulk_strain(bodies, 1e-3, 0.0, 0.0);
    check(std::fabs((bulk.x[1] - bulk.x[0]) / (1e-3 * grid.dx) - 1.0) < 1e-9 && bulk.y[0] == 0.0, "bulk strain");
    ss::TangentialSolver stretched(bodies, pressed, law, ss::tangential(ss::force(0.0)));
    stretched.set_relative_displacement(bulk.pattern());
    check(stretched.solve().result().stick_ratio < 1.0, "slip due to a bulk strain");
    fails(STICKSLIP_NOT_FINITE, [&] { ss::bulk_strain(bodies, NAN, 0.0, 0.0); });

    ss::SelfAffine recipe = stickslip_self_affine_default();
    recipe.rms_height = 1e-3;
    check(std::fabs(ss::statistics(grid, ss::self_affine(grid, recipe)).rms_height / 1e-3 - 1.0) < 1e-12, "rms height");
    fails(STICKSLIP_NOT_CONVERGED, [&] { ss::self_affine(grid, recipe, never); });
    recipe.hurst = 2.0;
    fails(STICKSLIP_HURST, [&] { ss::self_affine(grid, recipe); });
    return failures == 0 ? 0 : 1;
}
