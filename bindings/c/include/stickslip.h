/* Normal and stick-slip contact of elastic half-spaces: the crate stickslip for C. Made by cbindgen from the source: do not
 * edit. The same interface with destructors and exceptions is in stickslip.hpp, and for Fortran in stickslip.f90.
 *
 * Status. A function returns STICKSLIP_OK (0) or the kind of failure; those that return a pointer return NULL on failure. What
 * failed is told by stickslip_last_error_message() and stickslip_last_error(), for each thread on its own. Arguments are
 * checked before any work, and a call that fails leaves its objects as they were, unless its page says otherwise. Nothing
 * unwinds out of a function, and nothing is printed.
 *
 * Pointers. A pointer is NULL, or points to what its type says for as long as the call lasts. Where NULL is allowed the
 * function says so; elsewhere it is STICKSLIP_BAD_POINTER. Arrays have as many entries as the number beside them says, and
 * what the library keeps of them is copied. Places for answers need not be initialised.
 *
 * Objects. An object is made by ..._new, and freed once by ..._free, in any order: nothing refers to another object. Fields
 * are read by pointer, without a copy: such a pointer is valid until the next call that changes or frees its object.
 *
 * Threads. Any thread may use any object. Several may read one at once (parameters that are const); a call that changes an
 * object needs it alone, else one of the two returns STICKSLIP_BUSY and does nothing. To free an object or read through a
 * pointer to a field while another thread uses or changes it is an error that nobody notices.
 *
 * Structs. Those that end with reserved grow in its place: begin them from zeros or from their ..._default(). A member that the
 * library does not know is refused, STICKSLIP_UNKNOWN_OPTION, unless it is zero.
 *
 * Floating-point arithmetic. Within a call it rounds to nearest and traps nothing, whatever the program has set; after it all
 * is set as before.
 *
 * Memory. A call that cannot have memory whose size follows the cells returns STICKSLIP_MEMORY and leaves its objects as they
 * were. The process ends only where it cannot have a few kilobytes whatever the grid (an object, a report, a message), a row of
 * the grid (tables of the transforms, rows that repeat along y, the extent of a contact), or a thread; and in rough surfaces and
 * their statistics, which ask for their memory before they begin.
 *
 * Units are any consistent set. Pressure and approach are positive when bodies are pressed; the shift is the motion of body
 * 2 relative to body 1, traction and tangential force are those that body 2 exerts on body 1.
 */


#ifndef STICKSLIP_H
#define STICKSLIP_H

#include <stddef.h>
#include <stdint.h>

// No cell slipped.
#define STICKSLIP_FULL_STICK 0

// Some cells slipped, but some stuck at the end of each step.
#define STICKSLIP_PARTIAL_SLIP 1

// The whole contact was at its friction limit at the end of a step.
#define STICKSLIP_GROSS_SLIP 2

// Pressure, zero outside the contact.
#define STICKSLIP_PRESSURE 0

// Gap under load (lengths).
#define STICKSLIP_GAP 1

// Shear traction along x that body 2 exerts on body 1 (pressures).
#define STICKSLIP_TRACTION_X 2

// Shear traction along y.
#define STICKSLIP_TRACTION_Y 3

// Slip along x (lengths), the motion of the surface of body 1 over that of body 2; of a history the sum of all steps.
#define STICKSLIP_SLIP_X 4

// Slip along y.
#define STICKSLIP_SLIP_Y 5

// Displacement by pressure and tractions together along x (lengths): of coupled solutions that of body 1 relative to body 2,
// of planes below the surface that of the body.
#define STICKSLIP_DISPLACEMENT_X 6

// The same along y.
#define STICKSLIP_DISPLACEMENT_Y 7

// The same along z; of coupled solutions the sum of both bodies.
#define STICKSLIP_DISPLACEMENT_Z 8

// Length of the path slipped, in all steps of a history or in those of a cycle (lengths).
#define STICKSLIP_SLIP_DISTANCE 9

// Energy that each cell has dissipated, in all steps of a history or in those of a cycle.
#define STICKSLIP_DISSIPATED_ENERGY 10

// Gap of a history before loading, as last set (lengths).
#define STICKSLIP_INITIAL_GAP 11

// Slip along x of the last step of a history (lengths).
#define STICKSLIP_STEP_SLIP_X 12

// Slip along y of the last step.
#define STICKSLIP_STEP_SLIP_Y 13

// Length of the slip of the last step.
#define STICKSLIP_STEP_SLIP_DISTANCE 14

// Energy that each cell dissipated in the last step, by its traction at the end.
#define STICKSLIP_STEP_DISSIPATED_ENERGY 15

// Energy that each cell dissipated in the last step, by the mean of its tractions: the measure that closes the balance.
#define STICKSLIP_STEP_MID_DISSIPATED_ENERGY 16

// What has yielded for good, added to the gap (lengths); histories with a permanent set only.
#define STICKSLIP_YIELDED_DEPTH 17

// Mean pressure while slipping, weighted by the slip; cycles only.
#define STICKSLIP_SLIP_PRESSURE 18

// Amplitude of the slip along x; cycles only (lengths).
#define STICKSLIP_SLIP_AMPLITUDE_X 19

// Amplitude of the slip along y; cycles only.
#define STICKSLIP_SLIP_AMPLITUDE_Y 20

// Stress xx on a plane below the surface (pressures, positive in tension).
#define STICKSLIP_STRESS_XX 21

// Stress yy on a plane.
#define STICKSLIP_STRESS_YY 22

// Stress zz on a plane.
#define STICKSLIP_STRESS_ZZ 23

// Stress xy on a plane.
#define STICKSLIP_STRESS_XY 24

// Stress xz on a plane.
#define STICKSLIP_STRESS_XZ 25

// Stress yz on a plane.
#define STICKSLIP_STRESS_YZ 26

// Von Mises' equivalent stress (pressures), for stickslip_planes_measure.
#define STICKSLIP_VON_MISES 27

// Largest shear stress (pressures), for stickslip_planes_measure: half the difference of the largest and the smallest principal stress.
#define STICKSLIP_MAX_SHEAR 28

// Mean of the normal stresses (pressures, positive in tension), for stickslip_planes_measure.
#define STICKSLIP_HYDROSTATIC 29

// Zone of a cell out of contact.
#define STICKSLIP_SEPARATED 0

// Zone of a cell in contact, below the friction limit.
#define STICKSLIP_STICK 1

// Zone of a cell in contact, at the friction limit.
#define STICKSLIP_SLIP 2

// Along x.
#define STICKSLIP_X 0

// Along y.
#define STICKSLIP_Y 1

// A cell that touches within a step follows its motion as far as it would if all that grows stuck (default).
#define STICKSLIP_SINCE_TOUCH 0

// It follows all of the motion of the step.
#define STICKSLIP_WHOLE_STEP 1

// The grid is a patch on infinite bodies.
#define STICKSLIP_NON_PERIODIC 0

// The grid repeats along x and y.
#define STICKSLIP_PERIODIC 1

// The grid repeats along y alone.
#define STICKSLIP_PERIODIC_ALONG_Y 2

// The traction of a cell is uniform over it.
#define STICKSLIP_UNIFORM 0

// The traction of a cell is that at its centre, and smooth between the centres.
#define STICKSLIP_CENTRE 1

// Active sets, the default.
#define STICKSLIP_ACTIVE_SET 0

// The loop of Polonsky and Keer, for pressure or for one traction.
#define STICKSLIP_POLONSKY_KEER 1

// Hold: the pressure, the shift as it is.
#define STICKSLIP_HOLD 0

// A force.
#define STICKSLIP_FORCE 1

// The approach of the bodies (a length), from the datum of the gap.
#define STICKSLIP_APPROACH 2

// The shift, the rigid motion of body 2 relative to body 1 (a length), since the unloaded state.
#define STICKSLIP_SHIFT 3

// A spring that drags body 2: the force is stiffness * (value - shift).
#define STICKSLIP_SPRING 4

// The traction along the load alone (default).
#define STICKSLIP_SCALAR 0

// Both tractions, under loads of any direction.
#define STICKSLIP_VECTOR 1

// Pressure and traction are found together: coupled solvers and histories only.
#define STICKSLIP_FULL 0

// Shear does not change the pressure, but pressure moves the surfaces tangentially.
#define STICKSLIP_ONE_WAY 1

// Neither moves the other.
#define STICKSLIP_NEGLECTED 2

// Nothing has been solved yet.
#define STICKSLIP_UNSOLVED 0

// A fresh product shows residual and certified error at or below the tolerance.
#define STICKSLIP_CONVERGED 1

// The iteration limit was reached first.
#define STICKSLIP_AT_ITERATION_LIMIT 2

// The time limit was reached first.
#define STICKSLIP_AT_TIME_LIMIT 3

// The residual no longer falls: the tolerance is below round-off.
#define STICKSLIP_STALLED 4

// The observer asked to stop.
#define STICKSLIP_CANCELLED 5

// The smallest eigenvalue of an operator, on which a certified error rests, is not known. The bound of the error is then the
// root of the duality gap of the problem, and falls only with the root of the residual.
#define STICKSLIP_EIGENVALUE_UNKNOWN 0

// It is known by an estimate on the safe side: of stiff coatings on long grids.
#define STICKSLIP_EIGENVALUE_ESTIMATED 1

// It has a bound from below, which was computed.
#define STICKSLIP_EIGENVALUE_PROVEN 2

// There is no contact.
#define STICKSLIP_WARNING_NO_CONTACT 1

// Contact cells (cells) lie on the edge of the grid.
#define STICKSLIP_WARNING_CONTACT_AT_EDGE 2

// Contact spots (cells) of all (of) are smaller than five cells, and have a tenth of the contact cells or more.
#define STICKSLIP_WARNING_UNRESOLVED_SPOTS 3

// The grid is a line of cells that does not repeat.
#define STICKSLIP_WARNING_SINGLE_ROW_OF_CELLS 4

// A contact spot runs across the whole grid.
#define STICKSLIP_WARNING_CONTACT_SPANS_GRID 5

// Cells (cells) are pressed beyond the hardness that a material states.
#define STICKSLIP_WARNING_BEYOND_HARDNESS 6

// The pressure was held although the gap had changed.
#define STICKSLIP_WARNING_STALE_PRESSURE 7

// The contact has too few cells (cells).
#define STICKSLIP_WARNING_UNDERRESOLVED_CONTACT 8

// Too few cells (cells) stick.
#define STICKSLIP_WARNING_UNDERRESOLVED_STICK_ZONE 9

// The zone that slips is narrower than two cells, or than one cell in a step that rolls.
#define STICKSLIP_WARNING_UNDERRESOLVED_SLIP_ZONE 10

// A coupled problem was pressed in one step.
#define STICKSLIP_WARNING_SINGLE_LOAD_STEP 11

// The cells leave an error of more than 5 % in the pressure or the traction, by an estimate; 1 % needs so many (cells) on the
// radius of a contact spot.
#define STICKSLIP_WARNING_DISCRETISATION_ERROR 12

// The approach exceeds the longest side of the grid.
#define STICKSLIP_WARNING_APPROACH_BEYOND_GRID 13

// The contact radius exceeds 0.3 of the radius of curvature.
#define STICKSLIP_WARNING_LARGE_CONTACT_RADIUS 14

// The rms slope of the surface within the contact exceeds 0.5.
#define STICKSLIP_WARNING_STEEP_SURFACE 15

// A step of a history held the shift, and the tangential force fell by more than half.
#define STICKSLIP_WARNING_HELD_SHIFT_LOST_FORCE 16

// Tractions of dissimilar bodies that roll change the pressure, and the change is neglected.
#define STICKSLIP_WARNING_NEGLECTED_LIFT 17

// Any other: the message says which.
#define STICKSLIP_WARNING_OTHER 127

// Bytes of the message of a warning.
#define STICKSLIP_WARNING_LENGTH 384

// A creepage, what body 2 moves over body 1 for each length rolled (dimensionless).
#define STICKSLIP_CREEPAGE 0

// A spin, the rotation of body 2 relative to body 1 about the origin of the grid for each length rolled (one over a
// length, positive from x to y).
#define STICKSLIP_SPIN 0

// The moment on body 1 about the origin of the grid (a force times a length, positive from x to y).
#define STICKSLIP_MOMENT 5

// Particles enter the contact at the largest x (default).
#define STICKSLIP_PLUS_X 0

// At the smallest x.
#define STICKSLIP_MINUS_X 1

// At the largest y.
#define STICKSLIP_PLUS_Y 2

// At the smallest y.
#define STICKSLIP_MINUS_Y 3

// Each wave has the amplitude of the spectrum, and only its phase is random (default).
#define STICKSLIP_EXACT 0

// The amplitudes are random too, as of filtered white noise.
#define STICKSLIP_GAUSSIAN 1

// Done.
#define STICKSLIP_OK 0

// The tolerance was not reached, or the observer or a limit ended the solve. The solution holds the last feasible iterate
// and its report; a history is as it was, and stickslip_last_error_report has the report.
#define STICKSLIP_NOT_CONVERGED 1

// The tangential force or moment (value) exceeds what friction can carry (limit): no equilibrium exists.
#define STICKSLIP_BEYOND_FRICTION_CAPACITY 2

// The normal force (value) exceeds what the hardness lets the cells carry (limit).
#define STICKSLIP_BEYOND_HARDNESS 3

// The bodies do not touch: there is nothing to load tangentially.
#define STICKSLIP_EMPTY_CONTACT 4

// The approach (value) is not below the mean gap (limit) of a periodic contact.
#define STICKSLIP_APPROACH_BEYOND_MEAN_GAP 5

// The materials couple pressure and traction (value: Dundurs' beta), and what was asked for does not model that.
#define STICKSLIP_COUPLED_MATERIALS 6

// The model does not include this load (value).
#define STICKSLIP_UNSUPPORTED_BY_MODEL 7

// The load has components along both axes, which the scalar model does not allow (value: along x, limit: along y).
#define STICKSLIP_OBLIQUE_LOAD 8

// A load was cut into the shortest steps allowed, and the error of one (value) is still beyond its tolerance (limit).
#define STICKSLIP_STEP_TOO_LONG 9

// Cells (index: how many) are at their hardness, where only elastic contacts have what was asked for.
#define STICKSLIP_YIELDED 10

// A history that a cycle already counts, or of another step.
#define STICKSLIP_STEP_ALREADY_COUNTED 11

// The cycle does not close: the residual of its loop (value) is more than what stands for those that follow (limit).
#define STICKSLIP_CYCLE_NOT_CLOSED 12

// A handle or another pointer that is needed is NULL, or misaligned.
#define STICKSLIP_BAD_POINTER 32

// The handle is in use by another thread; nothing was done.
#define STICKSLIP_BUSY 33

// The number (value) is no constant of the kind that is needed there, or a struct has a member that this library does not
// know: reserved is not zero.
#define STICKSLIP_UNKNOWN_OPTION 34

// The buffer has room for fewer entries (found) than there are (expected).
#define STICKSLIP_BUFFER_TOO_SMALL 35

// Some contacts of a batch failed: the codes of each say why, the last error is that of the first (index).
#define STICKSLIP_SOME_FAILED 36

// The threads cannot be made.
#define STICKSLIP_NO_THREADS 37

// A defect of the library. The objects of the call can be freed, and should not be used otherwise.
#define STICKSLIP_PANIC 38

// A grid needs at least one cell along each axis.
#define STICKSLIP_GRID_SIZE 64

// Memory cannot be allocated, and none was.
#define STICKSLIP_MEMORY 65

// A quantity (value) that must be positive and finite is not.
#define STICKSLIP_NOT_POSITIVE 66

// A quantity (value) that must be zero or positive, and finite, is not.
#define STICKSLIP_NEGATIVE_OR_NOT_FINITE 67

// A quantity (value) that must be finite is not.
#define STICKSLIP_NOT_FINITE 68

// A sample (value, at index) of a field violates a rule for that field.
#define STICKSLIP_SAMPLE 69

// Poisson's ratio (value) lies outside (-1, 1/2].
#define STICKSLIP_POISSON_RATIO 70

// Both bodies are rigid: nothing deforms.
#define STICKSLIP_BOTH_RIGID 71

// The cells are too long: double precision does not resolve the compliance of their short waves.
#define STICKSLIP_CELLS_TOO_LONG 72

// An array has the wrong number of entries (found for expected).
#define STICKSLIP_LENGTH 73

// Two objects live on different grids.
#define STICKSLIP_GRID_MISMATCH 74

// Two objects belong to bodies with different boundaries.
#define STICKSLIP_BOUNDARY_MISMATCH 75

// Two objects belong to bodies of different materials.
#define STICKSLIP_MATERIAL_MISMATCH 76

// The tolerance (value) lies outside (0, 1).
#define STICKSLIP_TOLERANCE 77

// The iteration limit is zero.
#define STICKSLIP_ITERATION_LIMIT 78

// A solver that is to hold its pressure has none yet: give it a force or an approach.
#define STICKSLIP_NO_PRESSURE_TO_HOLD 79

// The method does not solve this kind of problem.
#define STICKSLIP_METHOD 80

// A quantity (value) is below its lower limit (limit).
#define STICKSLIP_BELOW_MINIMUM 81

// The bytes are no saved history, of another version, or damaged.
#define STICKSLIP_FORMAT 82

// The body is rigid: nothing determines its stress.
#define STICKSLIP_RIGID_BODY 83

// A sum over images that does not converge on a grid that repeats along both axes.
#define STICKSLIP_DIVERGENT_PERIODIC_SUM 84

// The Hurst exponent (value) lies outside [0, 1].
#define STICKSLIP_HURST 85

// No wave of the surface has a wavelength between the longest (value) and the shortest (limit).
#define STICKSLIP_NO_WAVE_IN_BAND 86

// No heights of this skewness (value) and kurtosis (limit) were found.
#define STICKSLIP_HEIGHT_MOMENTS_NOT_REACHED 87

// Two objects belong to bodies whose cells have values of another meaning.
#define STICKSLIP_CELL_VALUE_MISMATCH 88

// Ranks cannot go on together: one of them (index) is lost, makes other calls or has refused its part, or they came with
// different inputs, which the message names.
#define STICKSLIP_RANK_FAILURE 89

// A rolled step needs more cells (expected) next to the contact than the grid has there (found): ahead of it or behind it.
#define STICKSLIP_GRID_TOO_SHORT 90

// A quantity (value) is beyond a limit (limit) outside which its squares leave the range of numbers: choose other units.
#define STICKSLIP_EXTREME_NUMBER 91

// Any other refusal: the message says which.
#define STICKSLIP_INVALID_ARGUMENT 127

// Body 1, into which z points.
#define STICKSLIP_BODY_1 1

// Body 2, above it.
#define STICKSLIP_BODY_2 2

// Major version of the library.
#define STICKSLIP_VERSION_MAJOR 0

// Minor version of the library.
#define STICKSLIP_VERSION_MINOR 1

// Patch version of the library.
#define STICKSLIP_VERSION_PATCH 0

// Version of the binary interface: of functions, layouts of structs and meanings of constants.
//
// It goes up whenever a program compiled with an older header could go wrong, and is part of the SONAME. A patch never
// changes it, a minor version may before 1.0; functions, constants and members in the place of reserved ones may be added
// without. A host that loads the library at run time compares it with stickslip_abi_version() first.
#define STICKSLIP_ABI_VERSION 2

// Takes loads in steps short enough for a tolerance of the tractions: a step is compared with the same in two halves. For
// histories on one grid.
typedef struct stickslip_adaptive_steps stickslip_adaptive_steps;

// A block on its way to this rank.
typedef struct stickslip_block stickslip_block;

// Pressure, traction, slip and creepage of coupled steady rolling. Its fields are read without a copy, and are valid until
// the next solve into it, or until it is freed.
typedef struct stickslip_coupled_rolling_solution stickslip_coupled_rolling_solution;

// Solves coupled steady rolling for one load after the other, each from the last answer.
typedef struct stickslip_coupled_rolling_solver stickslip_coupled_rolling_solver;

// Pressure, tractions and displacements of a coupled contact. Its fields are read without a copy, and are valid until the
// next solve into it, or until it is freed.
typedef struct stickslip_coupled_solution stickslip_coupled_solution;

// Solves coupled contacts again and again, each from rest in one step, beginning with the last answer.
typedef struct stickslip_coupled_solver stickslip_coupled_solver;

// What the steps of a history add up to since the cycle began.
typedef struct stickslip_cycle stickslip_cycle;

// Two elastic half-spaces on a grid, with the operators that all contacts on them share. Solvers and histories keep what
// they need of it: it may be freed before them. Many threads may use one at once.
typedef struct stickslip_half_space stickslip_half_space;

// A contact that is loaded step by step, with memory of slip. A step that fails leaves it bit for bit as it was. Its
// fields are read without a copy, and are valid until the next call that changes it.
typedef struct stickslip_history stickslip_history;

// Pressure, gap and approach of a normal contact. Its fields are read without a copy, and are valid until the next solve
// into it, or until it is freed.
typedef struct stickslip_normal_solution stickslip_normal_solution;

// Solves normal contacts of two bodies again and again, each solve beginning with the last answer.
typedef struct stickslip_normal_solver stickslip_normal_solver;

// Planes at chosen depths below each body, and the one that was solved last. Its fields are read without a copy, and are
// valid until the next solve, or until it is freed.
typedef struct stickslip_planes stickslip_planes;

// Traction, slip and creepage of steady rolling. Its fields are read without a copy, and are valid until the next solve
// into it, or until it is freed.
typedef struct stickslip_rolling_solution stickslip_rolling_solution;

// Solves steady rolling for one creepage, force or spin after the other, each from the last answer.
typedef struct stickslip_rolling_solver stickslip_rolling_solver;

// A state of a history, to which it may return: gap, friction and settings are part of it.
typedef struct stickslip_state stickslip_state;

// Traction, slip and shift of a tangential contact. Its fields are read without a copy, and are valid until the next solve
// into it, or until it is freed.
typedef struct stickslip_tangential_solution stickslip_tangential_solution;

// Solves tangential contacts again and again, each from rest, beginning with the last answer.
typedef struct stickslip_tangential_solver stickslip_tangential_solver;

// What a function returns: STICKSLIP_OK or the kind of failure.
typedef int32_t stickslip_status;

// A normal load.
typedef struct {
    // STICKSLIP_HOLD, STICKSLIP_FORCE or STICKSLIP_APPROACH.
    int32_t kind;
    // The force (zero or positive) or the approach (a length, positive when the bodies come together).
    double value;
} stickslip_normal_load;

// What is prescribed along one axis.
typedef struct {
    // STICKSLIP_HOLD, STICKSLIP_FORCE, STICKSLIP_SHIFT or STICKSLIP_SPRING.
    int32_t kind;
    // The force that body 2 exerts on body 1, the shift, or the position of the far end of the spring.
    double value;
    // Stiffness of the spring (a force over a length).
    double stiffness;
} stickslip_control;

// How the bodies roll in a step of a history: the memory of the particles moves through the contact, and body 2 creeps over
// body 1 on the way. All zero: they do not roll. A step that rolls names no shift, no spring and no twist; along an axis on
// which it names a force the creepage follows, and is zero here.
typedef struct {
    // Cells by which the particles of both surfaces move through the contact, one or more.
    uint32_t cells;
    // Where particles enter the contact: STICKSLIP_PLUS_X, STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y or STICKSLIP_MINUS_Y.
    int32_t leading_edge;
    // The creepages along x and y, what body 2 moves over body 1 for each length rolled (dimensionless).
    double creepage[2];
    // The spin, the rotation of body 2 relative to body 1 about the origin of the grid for each length rolled (one over a
    // length, positive from x to y); the vector model only.
    double spin;
} stickslip_roll;

// A step of a history: what it prescribes at its end. All zero holds everything.
typedef struct {
    // Normal load.
    stickslip_normal_load normal;
    // Tangential load along x.
    stickslip_control x;
    // Tangential load along y.
    stickslip_control y;
    // Not zero: to this twist; else the twist is held.
    int32_t has_twist;
    // Rotation of body 2 relative to body 1 since the start (radians, from x to y).
    double twist;
    // Not zero: to this amount of the relative displacement; else it is held.
    int32_t has_relative_displacement;
    // Amount of the relative displacement, as a multiple of the pattern of the history.
    double relative_displacement;
    // How the bodies roll; all zero: they do not.
    stickslip_roll roll;
    // Room for members to come: zero.
    uint64_t reserved[4];
} stickslip_load_step;

// The error that one step makes with a load: its difference from the same in two halves.
typedef struct {
    // That of the traction, relative; what the tolerance is for.
    double traction;
    // That of the tangential force.
    double force[2];
    // That of the shift (lengths).
    double shift[2];
    // That of the energy dissipated.
    double dissipated_energy;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_step_error;

// The contact of a sphere and a plane without friction, by Hertz.
typedef struct {
    // Radius of the contact (a length): a = (3 W R/(4 E*))^(1/3), with the force W and the radius R of the sphere.
    double contact_radius;
    // Pressure at the centre: p0 = 3 W/(2 pi a^2). At the distance r from it the pressure is p0 (1 - r^2/a^2)^(1/2).
    double max_pressure;
    // Approach of the bodies (a length): a^2/R.
    double approach;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_hertz;

// The contact of a sphere and a plane that is pressed and then loaded tangentially, by Cattaneo and Mindlin.
typedef struct {
    // The normal contact.
    stickslip_hertz hertz;
    // Radius of the circle that sticks (a length): c = a (1 - |Q|/(mu W))^(1/3), with the tangential force Q; 0 without
    // friction.
    double stick_radius;
    // Shift (a length), with the sign of the force: 3 mu W/(16 a G*) (1 - c^2/a^2), with G* of
    // stickslip_pair.
    double shift;
    // Energy dissipated as the force grows from zero (a force times a length), zero or positive.
    double dissipated_energy;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_cattaneo_mindlin;

// A cylinder that rolls steadily on a plane with longitudinal creepage, in plane strain, by Carter.
typedef struct {
    // Half-width of the contact (a length): a = (4 P R/(pi E*))^(1/2), with the force P per length and the radius R.
    double half_width;
    // Pressure at the centre: p0 = 2 P/(pi a).
    double max_pressure;
    // The creepage from which on the whole contact slips (dimensionless): 2 mu p0/E*.
    double sliding_creepage;
    // Half-width of the strip that sticks, at the leading edge x = a (a length): c = a (1 - |creepage|/sliding_creepage).
    double stick_half_width;
    // Tangential force on body 1 (a force per length), with the sign of the creepage: mu P (1 - c^2/a^2).
    double force;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_carter;

// Cylinders of different materials that roll freely, in plane strain and with little friction, by Bentall and Johnson: the
// limit of a friction much less than the size of Dundurs' beta. The leading edge is at the largest x; with that at the
// smallest the creepage has the other sign.
typedef struct {
    // Half-width of the contact (a length): a = (4 P R/(pi E*))^(1/2), with the force P per length and the radius R.
    double half_width;
    // Pressure at the centre: p0 = 2 P/(pi a).
    double max_pressure;
    // The creepage without a tangential force (dimensionless): 0.9148 beta a/R.
    double creepage;
    // Half-width of the middle strip, at whose ends the slip reverses (a length): 0.4040 a.
    double reversal;
    // Energy that slip dissipates for each length rolled (a force per length): 0.1239 mu |beta| P a/R.
    double dissipation;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_bentall_johnson;

// Kalker's coefficients: forces and moment of an elliptic contact that rolls along x with creepages so small that it sticks,
// but at its trailing edge. With semi-axes a along x and b along y, c = (a b)^(1/2) and the shear modulus G of two equal
// bodies the creepages xi along x and eta along y and the spin phi cause F_x = G c^2 c11 xi,
// F_y = G c^2 (c22 eta + c c23 phi) and the moment G c^3 (-c23 eta + c c33 phi) on body 1.
typedef struct {
    // Force along x by the creepage along x.
    double c11;
    // Force along y by the creepage along y.
    double c22;
    // Force along y by the spin; minus the moment by the creepage along y.
    double c23;
    // Moment by the spin.
    double c33;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_kalker;

// An elliptic contact that rolls along x with creepages, without spin, by Vermeulen and Johnson with Kalker's slope: a few
// percent less than what is solved.
typedef struct {
    // Semi-axes of the contact along x and y (lengths).
    double semi_axes[2];
    // Pressure at the centre.
    double max_pressure;
    // The coefficients of the contact without slip.
    stickslip_kalker coefficients;
    // The force that the creepages would cause without slip, over the friction limit (dimensionless): x, from 3 on all
    // slips.
    double relative_creepage;
    // Tangential force on body 1 along x and y: mu W (1 - (1 - x/3)^3) along that without slip, with the normal force W.
    double force[2];
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_vermeulen_johnson;

// A quantity of all cells: one value, or one for each.
typedef struct {
    // The value of all cells, if cells is NULL.
    double value;
    // A value for each cell, copied by the call; or NULL.
    const double *cells;
    // Number of cells, if cells is not NULL.
    size_t count;
} stickslip_per_cell;

// Coulomb friction.
typedef struct {
    // Coefficient of friction, zero or positive.
    stickslip_per_cell coefficient;
    // Largest shear traction (a pressure); 0 or infinite: no limit but that of the coefficient.
    double max_shear_stress;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_friction;

// A tangential load from rest.
typedef struct {
    // Along x.
    stickslip_control x;
    // Along y.
    stickslip_control y;
    // Rotation of body 2 relative to body 1 about the origin of the grid (radians, from x to y); the vector model only.
    double twist;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_tangential_load;

// A tangential displacement of body 1 relative to body 2 in each cell that the contact does not cause, such as that of
// bulk strain; copied by the call.
typedef struct {
    // That along x (lengths), for each cell.
    const double *x;
    // That along y (lengths), for each cell.
    const double *y;
    // Number of cells.
    size_t count;
} stickslip_relative_displacement;

// Method, tolerance and limits of a solve; stickslip_settings_default() has the defaults.
typedef struct {
    // STICKSLIP_ACTIVE_SET (default) or STICKSLIP_POLONSKY_KEER.
    int32_t method;
    // The error accepted, in (0, 1) (default 1e-8): certified in the energy norm, and as a residual relative to the largest
    // displacement.
    double tolerance;
    // Conjugate-gradient steps allowed (default 10000).
    size_t max_iterations;
    // Wall time allowed for a solve (seconds); infinite (default): any. A step of a history has two solves, pressure and
    // traction.
    double time_limit;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_settings;

// One step of an iteration.
typedef struct {
    // Conjugate-gradient steps so far.
    size_t iteration;
    // Products in double precision so far.
    size_t double_precision_products;
    // Products in single precision so far.
    size_t single_precision_products;
    // Largest complementarity residual, relative to the largest displacement, as last measured.
    double residual;
    // Contact cells of a normal problem, sticking cells of a tangential one.
    size_t free;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_iteration;

// Called before every product with the operator, also on the coarser grids of a start: returns 0 to end the solve, any other
// number to continue. It is called by one thread at a time, on more than 4096 cells possibly another than that which called the
// solve. It must not unwind or jump out, nor call functions with handles that the solve uses (STICKSLIP_BUSY).
typedef int32_t (*stickslip_observe)(const stickslip_iteration *iteration, void *user);

// A function that watches a solve, with data of yours.
typedef struct {
    // The function; NULL watches nothing.
    stickslip_observe observe;
    // Passed to the function as it is.
    void *user;
} stickslip_observer;

// Numbers of a normal contact.
typedef struct {
    // Approach of the bodies from the datum of the gap (a length).
    double approach;
    // Normal force.
    double force;
    // Area of the cells in contact.
    double contact_area;
    // The same, corrected for the steps of its perimeter.
    double contact_area_corrected;
    // Force over contact area; zero without contact.
    double mean_pressure;
    // Moments of the pressure about x and y at the origin of the grid (forces times lengths).
    double moments[2];
    // Centre of pressure (lengths); NaN without contact.
    double centre_of_pressure[2];
    // Cells in contact.
    size_t contact_cells;
    // Cells at their hardness.
    size_t yielded_cells;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_normal_result;

// Numbers of a tangential contact.
typedef struct {
    // Shift of body 2 relative to body 1 (lengths).
    double shift[2];
    // Tangential force that body 2 exerts on body 1.
    double force[2];
    // Rotation of body 2 relative to body 1 (radians).
    double twist;
    // Moment about z that the tractions exert on body 1 (a force times a length).
    double moment;
    // Stick cells over contact cells.
    double stick_ratio;
    // Area that sticks.
    double stick_area;
    // Area that slips.
    double slip_area;
    // Energy dissipated by slip.
    double dissipated_energy;
    // Not zero if the whole contact is at its friction limit.
    int32_t is_gross_slip;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_tangential_result;

// How a solve ended, what it cost and how large its error can be.
typedef struct {
    // STICKSLIP_CONVERGED or why not, or STICKSLIP_UNSOLVED.
    int32_t status;
    // How the smallest eigenvalue is known that duality_gap, and what else is certified beside it, rests on:
    // STICKSLIP_EIGENVALUE_PROVEN, STICKSLIP_EIGENVALUE_ESTIMATED or STICKSLIP_EIGENVALUE_UNKNOWN.
    int32_t eigenvalue_bound;
    // Conjugate-gradient steps.
    size_t iterations;
    // Products with the operator in double precision.
    size_t double_precision_products;
    // Products in single precision.
    size_t single_precision_products;
    // Largest complementarity residual, relative to the largest displacement.
    double residual;
    // Certified bound on the squared relative error in the energy norm.
    double duality_gap;
    // Certified bound on the relative error in the energy norm, the root of the above.
    double energy_error_bound;
    // Relative error of the prescribed total force.
    double load_error;
    // Wall time of the solve (seconds).
    double seconds;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_report;

// How a coupled solve ended. The whole error is bounded where friction is weak; else its halves are certified.
typedef struct {
    // The work; its duality gap is infinite.
    stickslip_report work;
    // Bound of the error of the pressure in the energy norm, at tractions as they are.
    double pressure_error_bound;
    // Bound of the error of the tractions, at the pressure as it is.
    double traction_error_bound;
    // Bounds of the errors of pressure and traction as a whole; NaN where there are none.
    double error_bounds[2];
    // What the errors of pressure and traction as a whole are likely to be; NaN where that is not known.
    double error_estimate[2];
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_coupled_report;

// Report of coupled rolling: ending, cost, passes and certified errors.
typedef struct {
    // The work of all passes; its duality gap is infinite for coupled bodies.
    stickslip_report work;
    // Number of passes: solves of the pressure, each followed by a solve of the tractions.
    size_t passes;
    // Residual of the coupling: lift within the contact that the last pass has added, over the largest normal displacement.
    double coupling_residual;
    // Change of the pressure in the last pass, over the pressure (root mean squares).
    double pressure_change;
    // Bound of the relative error of the pressure in the energy norm, for the tractions of the solution.
    double pressure_error_bound;
    // Bound of the relative error of the tractions, for the pressure of the solution.
    double traction_error_bound;
    // Estimate of the relative error of the pressure as a whole; NaN if there is none.
    double error_estimate;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_coupled_rolling_report;

// A diagnostic on a converged solution that may mislead.
typedef struct {
    // One of STICKSLIP_WARNING_NO_CONTACT and the others.
    int32_t kind;
    // Cells or spots that it is about; else zero.
    size_t cells;
    // Spots in all; else zero.
    size_t of;
    // What it means and what to do, in English; ends with a zero byte.
    char message[STICKSLIP_WARNING_LENGTH];
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_warning;

// Normal force by approach.
typedef struct {
    // A force over a length; zero without contact.
    double value;
    // Bound of its relative error; infinite where pressure and traction are found together.
    double bound;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_normal_stiffness;

// Forces along x and y and the moment, by shifts along x and y and the twist: rows are loads, columns motions. In C
// loading[row, column]. NaN for loads and motions that the model does not have: in the scalar model what is across its axis
// and the twist, on grids that repeat the twist.
typedef struct {
    // Derivative with respect to the motion at the end of the step, if the motion continues in its direction. Cells that came
    // into contact in the step follow the motion only in part. After a step that presses a ball the derivative is about
    // two thirds of Mindlin's stiffness, although all cells stick. stickslip_history_next_stiffness has the derivative of the
    // next step, in which they resist fully.
    double loading[3][3];
    // If the motion reverses: all cells of the contact stick.
    double reversal[3][3];
    // Bound of the errors: none is larger than this times the root of the product of the two entries on the diagonal;
    // infinite where pressure and traction are found together.
    double bound;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_tangential_stiffness;

// The stiffness of a contact.
typedef struct {
    // Normal force by approach.
    stickslip_normal_stiffness normal;
    // Tangential forces and moment by shift and twist.
    stickslip_tangential_stiffness tangential;
    // Tangential forces and moment by the approach while slip continues; NaN for those that the model does not have.
    double by_approach[3];
    // Normal force by shifts along x and y and the twist: zero but where pressure and traction are found together. NaN for
    // motions that the model does not have.
    double normal_by_motion[3];
    // Room for members to come: zero.
    uint64_t reserved[5];
} stickslip_stiffness;

// Work, elastic energy and dissipation of a step or a cycle.
typedef struct {
    // Work of the tangential load.
    double work;
    // Elastic energy of shear before.
    double elastic_before;
    // Elastic energy of shear after.
    double elastic_after;
    // Energy dissipated, by the tractions at the ends of steps.
    double dissipated_energy;
    // Energy dissipated, by the mean tractions of steps, which closes the balance.
    double dissipated_energy_midpoint;
    // Energy that cells let go as they leave the contact.
    double released;
    // Work on the motion that the tolerance leaves in stick cells.
    double residual;
    // What is missing in the balance: round-off.
    double imbalance;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_energy;

// Numbers of a cycle.
typedef struct {
    // Steps since it began.
    size_t steps;
    // STICKSLIP_FULL_STICK, STICKSLIP_PARTIAL_SLIP or STICKSLIP_GROSS_SLIP.
    int32_t regime;
    // Energy dissipated over the area of the rectangle around the loop of force and shift.
    double energy_ratio;
    // How far the traction at the end is from that at the beginning, relative to the largest: zero if the loop repeats.
    double cyclic_residual;
    // Amplitude of the tangential force.
    double force_amplitude[2];
    // Amplitude of the shift (lengths).
    double shift_amplitude[2];
    // Least and largest stick ratio at the end of a step.
    double stick_ratios[2];
    // Energies of all its steps.
    stickslip_energy energy;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_cycle_result;

// The edges of a contact and of its stick zone, found inside the cells. Numbers of the stick zone and of the traction are NaN
// for a contact that is pressed only.
typedef struct {
    // Area of the contact, with the parts of the cells at its edge (a length squared).
    double contact_area;
    // The part of the cells at the edge of the contact whose fit was refused: these count as a mean part, and have their own
    // pressure.
    double unfitted_fraction;
    // Largest pressure at the centre of a cell (a pressure).
    double peak_pressure;
    // Area of the stick zone (a length squared).
    double stick_area;
    // Area of the slip zone (a length squared).
    double slip_area;
    // Stick area over contact area; zero without contact.
    double stick_ratio;
    // The part of the cells at the edge of the stick zone whose fit was refused.
    double stick_unfitted_fraction;
    // Largest magnitude of the traction at the centre of a cell (a pressure).
    double peak_traction;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_edges;

// The numbers of the last failure on this thread; zero where they have no meaning.
typedef struct {
    // What the function returned, STICKSLIP_OK before any failure.
    stickslip_status code;
    // The offending value.
    double value;
    // The limit that it violates.
    double limit;
    // The index of the offending sample, or the place in a batch.
    size_t index;
    // Entries needed.
    size_t expected;
    // Entries given.
    size_t found;
    // Room for members to come: zero.
    uint64_t reserved[4];
} stickslip_error;

// A grid of nx by ny rectangular cells of sides dx and dy (lengths), centred on the origin. An array of samples has
// nx * ny entries, row by row with x fastest: that of cell (ix, iy) is at iy * nx + ix.
typedef struct {
    // Cells along x.
    size_t nx;
    // Cells along y.
    size_t ny;
    // Side of a cell along x (a length).
    double dx;
    // Side of a cell along y (a length).
    double dy;
} stickslip_grid;

// The material of a body.
typedef struct {
    // Young's modulus (a pressure); infinite for a rigid body.
    double youngs_modulus;
    // Poisson's ratio, in (-1, 1/2]; of no meaning for a rigid body.
    double poisson_ratio;
    // Indentation hardness (a pressure), for warnings only; 0 or infinite: not known.
    double hardness;
} stickslip_material;

// What lies beyond the edge of the grid.
typedef struct {
    // STICKSLIP_NON_PERIODIC, STICKSLIP_PERIODIC or STICKSLIP_PERIODIC_ALONG_Y.
    int32_t kind;
    // With STICKSLIP_PERIODIC_ALONG_Y: distance along x at which a line load moves nothing (a length).
    double datum;
} stickslip_boundary;

// An elastic layer bonded to what lies below it.
typedef struct {
    // Young's modulus (a pressure).
    double youngs_modulus;
    // Poisson's ratio, in (-1, 1/2].
    double poisson_ratio;
    // Thickness (a length).
    double thickness;
} stickslip_layer;

// Sends a block of words to the rank `to` and receives one from the rank `from`, neither of which is this one: it asks
// stickslip_block_room for the memory, and fills it. Blocks between two ranks keep their order, and are of any length, also
// none. Returns 0, or any other number if a rank is lost: nothing more is then asked. It is called by one thread at a time, on
// more than 4096 cells possibly another than that which made the call. It must not unwind or jump out, nor call other
// functions of this library.
typedef int32_t (*stickslip_swap)(const uint64_t *block,
                                  size_t words,
                                  size_t to,
                                  size_t from,
                                  stickslip_block *received,
                                  void *user);

// One of several processes that solve together; stickslip_mpi.h makes it of an MPI communicator. Function and data are
// needed until all that was made of the bodies is freed.
typedef struct {
    // The number of this one, from zero.
    size_t rank;
    // How many there are.
    size_t size;
    // Swaps blocks with others; not called where there are none.
    stickslip_swap swap;
    // Passed to the function as it is.
    void *user;
} stickslip_ranks;

// Constants of a pair of materials.
typedef struct {
    // E* (a pressure): 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
    double contact_modulus;
    // G* of Mindlin (a pressure): 1/G* = (2 - nu_1)/G_1 + (2 - nu_2)/G_2; a circle of radius a that sticks has 8 G* a.
    double tangential_modulus;
    // Dundurs' second parameter; zero where pressure and traction are not coupled.
    double dundurs_beta;
    // Not zero if pressure and traction are coupled.
    int32_t is_coupled;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_pair;

// Options of a history; stickslip_history_options_default() has the defaults.
typedef struct {
    // Axis of load and traction in the scalar model: STICKSLIP_X (default) or STICKSLIP_Y.
    int32_t axis;
    // STICKSLIP_SCALAR (default) or STICKSLIP_VECTOR.
    int32_t model;
    // STICKSLIP_FULL (default), STICKSLIP_ONE_WAY or STICKSLIP_NEGLECTED; of meaning for dissimilar bodies only.
    int32_t coupling;
    // STICKSLIP_SINCE_TOUCH (default) or STICKSLIP_WHOLE_STEP.
    int32_t entry_rule;
    // Largest pressure that the cells carry, or NULL (default).
    const stickslip_per_cell *hardness;
    // Not zero if what yields stays (default 0).
    int32_t permanent_set;
    // Pattern of a displacement that the contact does not cause, or NULL (default); steps reach an amount of it.
    const stickslip_relative_displacement *relative_displacement;
    // Method, tolerance and limits.
    stickslip_settings settings;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_history_options;

// Numbers of a history after its last step.
typedef struct {
    // Normal force.
    double normal_force;
    // Approach of the bodies (a length).
    double approach;
    // Tangential force that body 2 exerts on body 1.
    double force[2];
    // Shift of body 2 relative to body 1 since the start (lengths).
    double shift[2];
    // Moment about z that the tractions exert on body 1.
    double moment;
    // Rotation of body 2 relative to body 1 since the start (radians).
    double twist;
    // Stick cells over contact cells after the last step; zero without contact.
    double stick_ratio;
    // Not zero if the whole contact is at its friction limit after the last step.
    int32_t is_gross_slip;
    // Steps taken since the start.
    uint64_t steps;
    // Energies of the last step.
    stickslip_energy energy;
    // The creepages along x and y of the last step, given or caused by the force (dimensionless); zero if it did not roll.
    double creepage[2];
    // Room for members to come: zero.
    uint64_t reserved[6];
} stickslip_step_result;

// What limits a jump besides the pressure; stickslip_jump_limits_default() has the defaults.
typedef struct {
    // Most depth that is worn off at once (a length); infinite (default): any. A hundredth of the approach keeps the shape
    // of a ball.
    double largest_depth;
    // Cycles left to simulate; infinite (default): any number.
    double cycles_left;
    // Largest cyclic_residual of a cycle that stands for those that follow (default 0.25).
    double max_residual;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_jump_limits;

// What acts on the surface: the fields of a solution or a history, or any others. It is up to the caller that they belong
// to the same bodies.
typedef struct {
    // Pressure of each cell, positive in compression.
    const double *pressure;
    // Traction along x on body 1 (pressures); NULL, like that along y, without shear.
    const double *x;
    // Traction along y on body 1.
    const double *y;
    // Number of cells.
    size_t count;
} stickslip_tractions;

// Options of a rolling solver; stickslip_rolling_options_default() has the defaults.
typedef struct {
    // STICKSLIP_PLUS_X (default), STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y or STICKSLIP_MINUS_Y.
    int32_t leading_edge;
    // How cells that enter the contact follow the motion: STICKSLIP_SINCE_TOUCH (default) or STICKSLIP_WHOLE_STEP.
    int32_t entry_rule;
    // Cells that a particle passes in a step (default 1). Longer steps cost less and are less accurate.
    size_t step;
    // Number of corrections of the direction of slip (default 0). Two raise the order of the forces under spin from 1 to
    // between 1.5 and 2.
    size_t slip_corrections;
    // Method, tolerance and limits.
    stickslip_settings settings;
    // Room for members to come: zero.
    uint64_t reserved[7];
} stickslip_rolling_options;

// What is prescribed of rolling bodies along an axis, or of their rotation.
typedef struct {
    // Along an axis STICKSLIP_CREEPAGE or STICKSLIP_FORCE, of the rotation STICKSLIP_SPIN or STICKSLIP_MOMENT.
    int32_t kind;
    // The creepage or the force that body 2 exerts on body 1, less than friction holds; the spin or the moment.
    double value;
} stickslip_rolling_control;

// What is prescribed of rolling bodies. All zero: no creepage and no spin.
typedef struct {
    // Along x.
    stickslip_rolling_control x;
    // Along y.
    stickslip_rolling_control y;
    // The spin or the moment.
    stickslip_rolling_control spin;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_rolling_load;

// How forces and moment follow creepages and spin.
typedef struct {
    // Slopes of the forces along x and y and of the moment (rows) by the creepages along x and y and the spin (columns).
    // In C slopes[row, column]. Forces; with the spin forces times lengths, in the row of the moment once more times a
    // length.
    double slopes[3][3];
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_rolling_stiffness;

// Creepages and spin: a point of a creep curve or a creep surface.
typedef struct {
    // The creepages along x and y (dimensionless).
    double creepage[2];
    // The spin (one over a length).
    double spin;
} stickslip_creep_point;

// The loads that creepages and spin cause.
typedef struct {
    // Tangential force on body 1 along x and y.
    double force[2];
    // Moment on body 1 about the origin of the grid (a force times a length).
    double moment;
    // Stick cells over contact cells.
    double stick_ratio;
} stickslip_creep_force;

// Numbers of a rolling contact.
typedef struct {
    // The creepages along x and y, prescribed or caused by the forces (dimensionless).
    double creepage[2];
    // The spin, prescribed or caused by the moment (one over a length).
    double spin;
    // Tangential force that body 2 exerts on body 1.
    double force[2];
    // Moment about z at the origin of the grid that the tractions exert on body 1 (a force times a length).
    double moment;
    // Work that creepages and spin do for each length rolled (a force). Between bodies of the same material all of it is
    // dissipated; between others the pressure does work as well, which is not in it.
    double work;
    // Stick cells over contact cells.
    double stick_ratio;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_rolling_result;

// A random surface with a self-affine power spectrum; stickslip_self_affine_default() has the defaults. Wavelengths are
// lengths. A spectrum constant from the longest wavelength to the roll-off falls with the wave number q as q^(-2 - 2 H) from
// there to the cut-off.
typedef struct {
    // Root-mean-square height (a length); 0 if the slope is given.
    double rms_height;
    // Root-mean-square slope; 0 if the height is given.
    double rms_slope;
    // Hurst exponent H, in [0, 1] (default 0.8).
    double hurst;
    // Longest wavelength, where the spectrum begins; 0 (default): the longer side of the grid.
    double longest_wavelength;
    // Roll-off wavelength, where the spectrum begins to fall; 0 (default): the longest wavelength.
    double roll_off_wavelength;
    // Cut-off wavelength, where the spectrum ends, at least two cells; 0 (default): eight cells, of their longer side.
    double cut_off_wavelength;
    // STICKSLIP_EXACT (default) or STICKSLIP_GAUSSIAN.
    int32_t amplitudes;
    // Not zero: the middle of a larger surface, which does not repeat; else (default) the surface repeats along x and y.
    int32_t cropped;
    // Skewness of the heights; NaN (default): as it follows from the phases, or 0 if a kurtosis is given.
    double skewness;
    // Kurtosis of the heights; NaN (default): as it follows from the phases, or 3 if a skewness is given.
    double kurtosis;
    // Another seed is another surface (default 0).
    uint64_t seed;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_self_affine;

// Statistics of heights about their mean, as in ISO 25178-2.
typedef struct {
    // Mean height (a length), from which all other heights count.
    double mean_height;
    // Arithmetic mean height Sa (a length).
    double arithmetic_mean_height;
    // Root-mean-square height Sq (a length).
    double rms_height;
    // Skewness Ssk; NaN for a flat surface.
    double skewness;
    // Kurtosis Sku, 3 for a Gaussian surface; NaN for a flat one.
    double kurtosis;
    // Height of the highest peak Sp (a length).
    double highest_peak;
    // Depth of the deepest valley Sv (a length, positive).
    double deepest_valley;
    // Root-mean-square slope Sdq by finite differences, without those across the edge.
    double finite_difference_rms_slope;
    // Root-mean-square slope of the waves of the surface, continued periodically.
    double spectral_rms_slope;
    // Excess of the area over its projection, relative to the projection, Sdr.
    double developed_area_ratio;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_statistics;

// A contact spot: contact cells connected through their sides, across the edges of a grid that repeats too.
typedef struct {
    // Its cells.
    size_t cells;
    // Area, by counting cells (a length squared).
    double area;
    // Normal force that it carries.
    double load;
    // Load over area (a pressure).
    double mean_pressure;
    // Largest pressure of its cells (a pressure).
    double max_pressure;
    // Centre of the area (lengths), inside the grid; of no meaning for a spot that spans the whole period.
    double centroid[2];
    // Length of its edge along the sides of its cells (a length): longer than that of a round spot by a factor of 4/pi.
    double perimeter;
    // Stick cells over all its cells; NaN for a contact that is pressed only.
    double stick_ratio;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_spot;

// A point in a body.
typedef struct {
    // Position along x, that of the grid (a length).
    double x;
    // Position along y (a length).
    double y;
    // Depth below the surface of the body (a length), zero or positive in both bodies.
    double depth;
} stickslip_point;

// Displacement and stress at a point, along x, y and z, with z into body 1.
typedef struct {
    // Displacement of the body along x, y and z (lengths), zero at infinity.
    double displacement[3];
    // Stresses xx, yy and zz (pressures, positive in tension).
    double normal_stress[3];
    // Stresses xy, xz and yz (pressures).
    double shear_stress[3];
    // Principal stresses (pressures, positive in tension), the largest first.
    double principal_stress[3];
    // Von Mises' equivalent stress (a pressure).
    double von_mises;
} stickslip_response;

// Options of a tangential solver; stickslip_tangential_options_default() has the defaults.
typedef struct {
    // STICKSLIP_SCALAR (default) or STICKSLIP_VECTOR.
    int32_t model;
    // STICKSLIP_ONE_WAY (default) or STICKSLIP_NEGLECTED; of meaning for dissimilar bodies only.
    int32_t coupling;
    // A displacement of body 1 relative to body 2 that the contact does not cause, or NULL (default).
    const stickslip_relative_displacement *relative_displacement;
    // Method, tolerance and limits.
    stickslip_settings settings;
    // Room for members to come: zero.
    uint64_t reserved[8];
} stickslip_tangential_options;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Makes the buffers for histories on the grid of this one, with a tolerance in (0, 1) for a whole load.
stickslip_status stickslip_adaptive_steps_new(const stickslip_history *history,
                                              double tolerance,
                                              stickslip_adaptive_steps **steps);

// Frees the buffers; nothing for NULL.
stickslip_status stickslip_adaptive_steps_free(stickslip_adaptive_steps *steps);

// Takes a load in as many steps as it needs, and writes how many to taken (may be NULL). After a failure, which may be
// STICKSLIP_STEP_TOO_LONG, the state of the history is as it was; its last step is that of the last attempt.
stickslip_status stickslip_adaptive_steps_step(stickslip_adaptive_steps *steps,
                                               stickslip_history *history,
                                               const stickslip_load_step *load,
                                               size_t *taken);

// The error that stickslip_history_step would make with a load. The state of the history is as it was; its last step is
// the second half of this one.
stickslip_status stickslip_adaptive_steps_error(stickslip_adaptive_steps *steps,
                                                stickslip_history *history,
                                                const stickslip_load_step *load,
                                                stickslip_step_error *error);

// Hertz' contact of a sphere of this radius (a length) under this normal force on the materials of the bodies.
// STICKSLIP_NOT_POSITIVE if radius, force or a result is not positive and finite.
stickslip_status stickslip_hertz_sphere(const stickslip_half_space *half_space,
                                        double radius,
                                        double force,
                                        stickslip_hertz *hertz);

// Cattaneo and Mindlin's contact of a sphere under a normal force, with a coefficient of friction, under a tangential force
// of either sign; STICKSLIP_BEYOND_FRICTION_CAPACITY if friction does not carry it. The coupling of pressure and traction of
// dissimilar bodies is neglected.
stickslip_status stickslip_cattaneo_mindlin_sphere(const stickslip_half_space *half_space,
                                                   double radius,
                                                   double force,
                                                   double friction,
                                                   double tangential_force,
                                                   stickslip_cattaneo_mindlin *found);

// Carter's contact of a cylinder of this radius under this force per length, with a coefficient of friction, at a creepage
// of either sign. STICKSLIP_COUPLED_MATERIALS for bodies whose Dundurs' beta is not zero.
stickslip_status stickslip_carter_cylinder(const stickslip_half_space *half_space,
                                           double radius,
                                           double force,
                                           double friction,
                                           double creepage,
                                           stickslip_carter *found);

// Bentall and Johnson's contact of a cylinder of this radius that rolls freely under this force per length, with a
// coefficient of friction. Between bodies whose Dundurs' beta is zero nothing slips.
stickslip_status stickslip_bentall_johnson_cylinder(const stickslip_half_space *half_space,
                                                    double radius,
                                                    double force,
                                                    double friction,
                                                    stickslip_bentall_johnson *found);

// Kalker's coefficients of an ellipse of this ratio a/b of its semi-axes, along the rolling direction and across it, from
// 1/16 to 16, and of this Poisson's ratio, from 0 to 1/2. STICKSLIP_BELOW_MINIMUM for a ratio beyond the table or a negative
// Poisson's ratio, STICKSLIP_POISSON_RATIO for one above 1/2.
stickslip_status stickslip_kalker_coefficients(double ratio,
                                               double poisson_ratio,
                                               stickslip_kalker *found);

// Vermeulen and Johnson's contact of a body with the radii of curvature radius_x and radius_y (lengths) under this normal
// force, with a coefficient of friction, at creepages of either sign. STICKSLIP_COUPLED_MATERIALS for bodies whose Dundurs'
// beta is not zero, STICKSLIP_BELOW_MINIMUM for a contact longer than 16 times its width or the other way about.
stickslip_status stickslip_vermeulen_johnson_ellipse(const stickslip_half_space *half_space,
                                                     double radius_x,
                                                     double radius_y,
                                                     double force,
                                                     double friction,
                                                     double creepage_x,
                                                     double creepage_y,
                                                     stickslip_vermeulen_johnson *found);

// Takes a step of each of count histories, the i-th load for the i-th history, on the threads of stickslip_set_num_threads.
// Contacts of at most 4096 cells are solved on one thread each. Each comes to the bits that it has alone.
//
// codes (may be NULL) gets what stickslip_history_step would return for each. STICKSLIP_SOME_FAILED if any failed: these
// are as they were, and the last error is that of the first of them; the others have taken their step. A history that
// occurs twice is STICKSLIP_BUSY the second time.
stickslip_status stickslip_history_step_all(stickslip_history *const *histories,
                                            const stickslip_load_step *loads,
                                            size_t count,
                                            stickslip_status *codes);

// Makes a solver of a gap before loading (lengths, count entries, copied). hardness (no limit), relative (none) and settings
// (the defaults) may be NULL.
stickslip_status stickslip_coupled_solver_new(const stickslip_half_space *half_space,
                                              const double *gap,
                                              size_t count,
                                              const stickslip_friction *friction,
                                              const stickslip_normal_load *normal,
                                              const stickslip_tangential_load *tangential,
                                              const stickslip_per_cell *hardness,
                                              const stickslip_relative_displacement *relative,
                                              const stickslip_settings *settings,
                                              stickslip_coupled_solver **solver);

// Frees a solver; nothing for NULL.
stickslip_status stickslip_coupled_solver_free(stickslip_coupled_solver *solver);

// Changes the normal and the tangential load of the next solve.
stickslip_status stickslip_coupled_solver_set_load(stickslip_coupled_solver *solver,
                                                   const stickslip_normal_load *normal,
                                                   const stickslip_tangential_load *tangential);

// Changes the gap before loading of the next solve (lengths, count entries, copied).
stickslip_status stickslip_coupled_solver_set_gap(stickslip_coupled_solver *solver, const double *gap, size_t count);

// Changes the friction of the next solve.
stickslip_status stickslip_coupled_solver_set_friction(stickslip_coupled_solver *solver,
                                                       const stickslip_friction *friction);

// Changes method, tolerance and limits of the next solve.
stickslip_status stickslip_coupled_solver_set_settings(stickslip_coupled_solver *solver,
                                                       const stickslip_settings *settings);

// Forgets the last answer: the next solve starts as the first did.
stickslip_status stickslip_coupled_solver_reset(stickslip_coupled_solver *solver);

// Solves into a solution of stickslip_coupled_solution_new for the same bodies. observer may be NULL. With
// STICKSLIP_NOT_CONVERGED the solution holds the last iterate and its report; after any other failure it is as it was.
stickslip_status stickslip_coupled_solver_solve(stickslip_coupled_solver *solver,
                                                stickslip_coupled_solution *solution,
                                                const stickslip_observer *observer);

// Makes an empty solution of the right size for a solver.
stickslip_status stickslip_coupled_solution_new(const stickslip_coupled_solver *solver,
                                                stickslip_coupled_solution **solution);

// Frees a solution; nothing for NULL.
stickslip_status stickslip_coupled_solution_free(stickslip_coupled_solution *solution);

// A field, STICKSLIP_PRESSURE to STICKSLIP_DISPLACEMENT_Z, and how many cells it has (count may be NULL); NULL on failure.
const double *stickslip_coupled_solution_field(const stickslip_coupled_solution *solution,
                                               int32_t which,
                                               size_t *count);

// The zone of every cell; NULL on failure.
const uint8_t *stickslip_coupled_solution_zones(const stickslip_coupled_solution *solution, size_t *count);

// The numbers of both halves; either may be NULL.
stickslip_status stickslip_coupled_solution_results(const stickslip_coupled_solution *solution,
                                                    stickslip_normal_result *normal,
                                                    stickslip_tangential_result *tangential);

// How it was solved.
stickslip_status stickslip_coupled_solution_report(const stickslip_coupled_solution *solution,
                                                   stickslip_coupled_report *report);

// Diagnostics that may mislead: as stickslip_normal_solution_warnings.
stickslip_status stickslip_coupled_solution_warnings(const stickslip_coupled_solution *solution,
                                                     stickslip_warning *buffer,
                                                     size_t capacity,
                                                     size_t *count);

// The stiffness of a coupled contact on the bodies and with the friction it was solved for.
stickslip_status stickslip_coupled_solution_stiffness(const stickslip_coupled_solution *solution,
                                                      const stickslip_half_space *half_space,
                                                      const stickslip_friction *friction,
                                                      stickslip_stiffness *stiffness);

// The same with an observer (may be NULL), which is called before every product with the operator and may end it:
// STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
stickslip_status stickslip_coupled_solution_stiffness_observed(const stickslip_coupled_solution *solution,
                                                               const stickslip_half_space *half_space,
                                                               const stickslip_friction *friction,
                                                               const stickslip_observer *observer,
                                                               stickslip_stiffness *stiffness);

// Makes a solver of a gap before loading (lengths, count entries, copied) under a normal load. load (no creepage, no spin)
// and options (the defaults) may be NULL.
stickslip_status stickslip_coupled_rolling_solver_new(const stickslip_half_space *half_space,
                                                      const double *gap,
                                                      size_t count,
                                                      const stickslip_friction *friction,
                                                      const stickslip_normal_load *normal,
                                                      const stickslip_rolling_load *load,
                                                      const stickslip_rolling_options *options,
                                                      stickslip_coupled_rolling_solver **solver);

// Frees a solver; nothing for NULL.
stickslip_status stickslip_coupled_rolling_solver_free(stickslip_coupled_rolling_solver *solver);

// Changes the normal load of the next solve.
stickslip_status stickslip_coupled_rolling_solver_set_normal_load(stickslip_coupled_rolling_solver *solver,
                                                                  const stickslip_normal_load *normal);

// Changes creepages, forces, spin or moment of the next solve.
stickslip_status stickslip_coupled_rolling_solver_set_load(stickslip_coupled_rolling_solver *solver,
                                                           const stickslip_rolling_load *load);

// Changes the gap before loading of the next solve (lengths, count entries, copied).
stickslip_status stickslip_coupled_rolling_solver_set_gap(stickslip_coupled_rolling_solver *solver,
                                                          const double *gap,
                                                          size_t count);

// Changes the friction of the next solve.
stickslip_status stickslip_coupled_rolling_solver_set_friction(stickslip_coupled_rolling_solver *solver,
                                                               const stickslip_friction *friction);

// Changes method, tolerance and limits of the next solve.
stickslip_status stickslip_coupled_rolling_solver_set_settings(stickslip_coupled_rolling_solver *solver,
                                                               const stickslip_settings *settings);

// Forgets the last answer: the next solve starts as the first did.
stickslip_status stickslip_coupled_rolling_solver_reset(stickslip_coupled_rolling_solver *solver);

// Solves into a solution of stickslip_coupled_rolling_solution_new for the same bodies. observer may be NULL. With
// STICKSLIP_NOT_CONVERGED the solution holds the last iterate and its report.
stickslip_status stickslip_coupled_rolling_solver_solve(stickslip_coupled_rolling_solver *solver,
                                                        stickslip_coupled_rolling_solution *solution,
                                                        const stickslip_observer *observer);

// The slopes of the loads about the last answer, with the pressure that follows the tractions. observer may be NULL.
// STICKSLIP_NOT_CONVERGED before the first solve.
stickslip_status stickslip_coupled_rolling_solver_stiffness(stickslip_coupled_rolling_solver *solver,
                                                            const stickslip_observer *observer,
                                                            stickslip_rolling_stiffness *stiffness);

// Makes an empty solution of the right size for a solver.
stickslip_status stickslip_coupled_rolling_solution_new(const stickslip_coupled_rolling_solver *solver,
                                                        stickslip_coupled_rolling_solution **solution);

// Frees a solution; nothing for NULL.
stickslip_status stickslip_coupled_rolling_solution_free(stickslip_coupled_rolling_solution *solution);

// STICKSLIP_PRESSURE, STICKSLIP_GAP, STICKSLIP_TRACTION_X, STICKSLIP_SLIP_X or those along y, and how many cells it has (count
// may be NULL); NULL on failure. The slip is the slip for each length rolled (dimensionless).
const double *stickslip_coupled_rolling_solution_field(const stickslip_coupled_rolling_solution *solution,
                                                       int32_t which,
                                                       size_t *count);

// The zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; NULL on failure.
const uint8_t *stickslip_coupled_rolling_solution_zones(const stickslip_coupled_rolling_solution *solution,
                                                        size_t *count);

// The numbers of both halves; either may be NULL.
stickslip_status stickslip_coupled_rolling_solution_results(const stickslip_coupled_rolling_solution *solution,
                                                            stickslip_normal_result *normal,
                                                            stickslip_rolling_result *rolling);

// Report of the solve.
stickslip_status stickslip_coupled_rolling_solution_report(const stickslip_coupled_rolling_solution *solution,
                                                           stickslip_coupled_rolling_report *report);

// Diagnostics that may mislead: as stickslip_normal_solution_warnings.
stickslip_status stickslip_coupled_rolling_solution_warnings(const stickslip_coupled_rolling_solution *solution,
                                                             stickslip_warning *buffer,
                                                             size_t capacity,
                                                             size_t *count);

// Begins a cycle at the present state of a history.
stickslip_status stickslip_cycle_new(const stickslip_history *history, stickslip_cycle **cycle);

// Frees a cycle; nothing for NULL.
stickslip_status stickslip_cycle_free(stickslip_cycle *cycle);

// Begins the cycle anew, at the present state of a history.
stickslip_status stickslip_cycle_begin(stickslip_cycle *cycle, const stickslip_history *history);

// Adds the last step of the history, which must be new (else STICKSLIP_STEP_ALREADY_COUNTED).
stickslip_status stickslip_cycle_add(stickslip_cycle *cycle, const stickslip_history *history);

// The numbers of the cycle.
stickslip_status stickslip_cycle_result_of(const stickslip_cycle *cycle, stickslip_cycle_result *result);

// A field of the cycle: STICKSLIP_SLIP_DISTANCE, STICKSLIP_DISSIPATED_ENERGY, STICKSLIP_SLIP_PRESSURE,
// STICKSLIP_SLIP_AMPLITUDE_X or _Y; NULL on failure. It is valid until the next call that changes the cycle.
const double *stickslip_cycle_field(const stickslip_cycle *cycle, int32_t which, size_t *count);

// The edge of the contact inside the cells, and the pressure there.
//
// centres and means, which have cells entries, get the pressure at the centres of the cells and its means over the cells; each
// may be NULL. Most accurate with STICKSLIP_CENTRE.
stickslip_status stickslip_normal_solution_edges(const stickslip_normal_solution *solution,
                                                 stickslip_edges *edges,
                                                 double *centres,
                                                 double *means,
                                                 size_t cells);

// The edges of the contact and of the stick zone inside the cells, under the pressure and the friction of the problem. They are
// those of a contact loaded once.
//
// centres and means, which have cells entries, get the magnitude of the traction at the centres of the cells and its means over
// the cells; each may be NULL.
stickslip_status stickslip_tangential_solution_edges(const stickslip_tangential_solution *solution,
                                                     const stickslip_normal_solution *normal,
                                                     const stickslip_friction *friction,
                                                     stickslip_edges *edges,
                                                     double *centres,
                                                     double *means,
                                                     size_t cells);

// The edges of a contact whose pressure and traction were found together: as stickslip_tangential_solution_edges. The pressure
// comes from stickslip_coupled_solution_pressure_edges.
stickslip_status stickslip_coupled_solution_edges(const stickslip_coupled_solution *solution,
                                                  const stickslip_friction *friction,
                                                  stickslip_edges *edges,
                                                  double *centres,
                                                  double *means,
                                                  size_t cells);

// The edge of the contact alone, with its pressure: as stickslip_normal_solution_edges.
stickslip_status stickslip_coupled_solution_pressure_edges(const stickslip_coupled_solution *solution,
                                                           stickslip_edges *edges,
                                                           double *centres,
                                                           double *means,
                                                           size_t cells);

// An estimate of the relative error that the cells leave in the pressure: the sum over cells of the error of its means. NaN
// without contact.
stickslip_status stickslip_normal_solution_discretisation_estimate(const stickslip_normal_solution *solution,
                                                                   double *estimate);

// The same of the traction; NaN without any.
stickslip_status stickslip_tangential_solution_discretisation_estimate(const stickslip_tangential_solution *solution,
                                                                       double *estimate);

// The same of pressure and traction that were found together; NaN of what there is not.
stickslip_status stickslip_coupled_solution_discretisation_estimates(const stickslip_coupled_solution *solution,
                                                                     double *of_pressure,
                                                                     double *of_traction);

// The message of the last failure on this thread, in English, UTF-8; empty before any. The pointer is the same for every
// failure of a thread, and valid until the thread ends.
const char *stickslip_last_error_message(void);

// The numbers of the last failure on this thread.
stickslip_status stickslip_last_error(stickslip_error *error);

// The report of the last failure on this thread, if that was STICKSLIP_NOT_CONVERGED; else STICKSLIP_INVALID_ARGUMENT.
stickslip_status stickslip_last_error_report(stickslip_report *report);

// Makes the bodies: nothing is computed yet. A NULL boundary is STICKSLIP_NON_PERIODIC.
stickslip_status stickslip_half_space_new(const stickslip_grid *grid,
                                          const stickslip_material *body_1,
                                          const stickslip_material *body_2,
                                          const stickslip_boundary *boundary,
                                          stickslip_half_space **half_space);

// The same of bodies under layers, each the outermost first, at most eight; no layers leave a body as it is.
stickslip_status stickslip_half_space_new_coated(const stickslip_grid *grid,
                                                 const stickslip_material *body_1,
                                                 const stickslip_layer *layers_1,
                                                 size_t layers_1_count,
                                                 const stickslip_material *body_2,
                                                 const stickslip_layer *layers_2,
                                                 size_t layers_2_count,
                                                 const stickslip_boundary *boundary,
                                                 stickslip_half_space **half_space);

// The same of bodies whose rows are dealt out to ranks, which solve together to the bits of one: every rank makes them of the
// whole grid, and then the same calls in the same order. The grid of the bodies is that of the rows of this rank, from
// stickslip_half_space_first_row on, as are all arrays and labels; sums, reports and spots are those of the whole contact.
//
// Of the functions that return or take a grid alone none knows that it is a part: gaps are made by the program. Where ranks are
// threads of one process, stickslip_set_num_threads(1) must keep each in its own: else they wait for the same threads for ever.
stickslip_status stickslip_half_space_new_distributed(const stickslip_grid *grid,
                                                      const stickslip_material *body_1,
                                                      const stickslip_layer *layers_1,
                                                      size_t layers_1_count,
                                                      const stickslip_material *body_2,
                                                      const stickslip_layer *layers_2,
                                                      size_t layers_2_count,
                                                      const stickslip_boundary *boundary,
                                                      const stickslip_ranks *ranks,
                                                      stickslip_half_space **half_space);

// The first row of the whole grid that this rank has; zero where no ranks share it.
stickslip_status stickslip_half_space_first_row(const stickslip_half_space *half_space, size_t *row);

// Chooses the meaning of the pressure and the traction of a cell, STICKSLIP_UNIFORM (at first) or STICKSLIP_CENTRE, for what is
// made of the bodies from now on. On a grid with STICKSLIP_PERIODIC values are those at the centres in any case.
stickslip_status stickslip_half_space_set_cell_value(stickslip_half_space *half_space,
                                                     int32_t value);

// The meaning of the pressure and the traction of a cell: STICKSLIP_UNIFORM or STICKSLIP_CENTRE.
stickslip_status stickslip_half_space_cell_value(const stickslip_half_space *half_space, int32_t *value);

// Frees the bodies; nothing for NULL.
stickslip_status stickslip_half_space_free(stickslip_half_space *half_space);

// The grid.
stickslip_status stickslip_half_space_grid(const stickslip_half_space *half_space, stickslip_grid *grid);

// The constants of the pair.
stickslip_status stickslip_half_space_pair(const stickslip_half_space *half_space, stickslip_pair *pair);

// The options that histories have by default.
stickslip_history_options stickslip_history_options_default(void);

// Makes a history of a gap before loading (lengths, count entries, copied); nothing touches before the first step. options
// may be NULL (the defaults).
stickslip_status stickslip_history_new(const stickslip_half_space *half_space,
                                       const double *gap,
                                       size_t count,
                                       const stickslip_friction *friction,
                                       const stickslip_history_options *options,
                                       stickslip_history **history);

// Makes a copy of a history, independent of it: steps of one do not change the other.
stickslip_status stickslip_history_clone(const stickslip_history *history, stickslip_history **copy);

// Frees a history; nothing for NULL.
stickslip_status stickslip_history_free(stickslip_history *history);

// Takes a step. observer may be NULL. After a failure the history is as it was; after STICKSLIP_NOT_CONVERGED
// stickslip_last_error_report has the report.
stickslip_status stickslip_history_step(stickslip_history *history,
                                        const stickslip_load_step *load,
                                        const stickslip_observer *observer);

// Takes a load in as many steps of equal growth of the contact as a tolerance in (0, 1) needs, and writes their number to
// taken (may be NULL). A contact of dissimilar bodies must be pressed so. It takes the load in 1, 2, 4, 8, ... steps from the
// present state, until the tractions change by no more than the tolerance times the friction limits: 0.01 is a good choice.
// observer may be NULL; it receives the iterations of all steps. After a failure, which may be STICKSLIP_STEP_TOO_LONG, the
// state of the history is unchanged; its last step is the last one that succeeded.
stickslip_status stickslip_history_press(stickslip_history *history,
                                         const stickslip_load_step *load,
                                         double tolerance,
                                         const stickslip_observer *observer,
                                         size_t *taken);

// Changes the gap before loading (lengths, count entries, copied), as wear does. The pressure stays until a step that
// gives a normal load again.
stickslip_status stickslip_history_set_gap(stickslip_history *history, const double *gap, size_t count);

// Changes the friction from the next step on.
stickslip_status stickslip_history_set_friction(stickslip_history *history, const stickslip_friction *friction);

// Changes method, tolerance and limits from the next step on.
stickslip_status stickslip_history_set_settings(stickslip_history *history, const stickslip_settings *settings);

// Changes the pattern of the relative displacement from the next step on.
stickslip_status stickslip_history_set_relative_displacement(stickslip_history *history,
                                                             const stickslip_relative_displacement *pattern);

// The stiffness of the contact after the last step: normal, tangential on loading and at reversal.
stickslip_status stickslip_history_stiffness(const stickslip_history *history, stickslip_stiffness *stiffness);

// The same with an observer (may be NULL), which is called before every product with an operator and may end it:
// STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
stickslip_status stickslip_history_stiffness_observed(const stickslip_history *history,
                                                      const stickslip_observer *observer,
                                                      stickslip_stiffness *stiffness);

// The stiffness of a next step that starts from the present state. In loading and by_approach cells that stick resist fully,
// also those that came into contact in the last step, and cells at their limit continue to slip. A host that shears the contact
// further under the same normal load needs this. observer may be NULL.
stickslip_status stickslip_history_next_stiffness(const stickslip_history *history,
                                                  const stickslip_observer *observer,
                                                  stickslip_stiffness *stiffness);

// The numbers of the state. Stick ratio, gross slip, energies and creepages are those of the last step taken, zero before
// any and after the history was made from bytes.
stickslip_status stickslip_history_result(const stickslip_history *history,
                                          stickslip_step_result *result);

// The numbers of the normal contact.
stickslip_status stickslip_history_normal_result(const stickslip_history *history, stickslip_normal_result *result);

// The grid of all fields.
stickslip_status stickslip_history_grid(const stickslip_history *history, stickslip_grid *grid);

// The largest tangential force that friction holds at the present pressure.
stickslip_status stickslip_history_friction_capacity(const stickslip_history *history, double *capacity);

// How pressure and traction of the last step were solved; STICKSLIP_UNSOLVED if the pressure was held, or before anything
// has touched.
stickslip_status stickslip_history_reports(const stickslip_history *history,
                                           stickslip_report *normal,
                                           stickslip_report *tangential);

// Diagnostics on the last step: as stickslip_normal_solution_warnings.
stickslip_status stickslip_history_warnings(const stickslip_history *history,
                                            stickslip_warning *buffer,
                                            size_t capacity,
                                            size_t *count);

// A field by its number, STICKSLIP_PRESSURE to STICKSLIP_YIELDED_DEPTH but displacements, and how many cells it has (count
// may be NULL); NULL on failure.
const double *stickslip_history_field(const stickslip_history *history,
                                      int32_t which,
                                      size_t *count);

// The zone of every cell after the last step; NULL on failure.
const uint8_t *stickslip_history_zones(const stickslip_history *history, size_t *count);

// The settings that solvers and histories have by default.
stickslip_settings stickslip_settings_default(void);

// Friction with one coefficient for all cells.
stickslip_friction stickslip_coulomb(double coefficient);

// The limits that jumps have by default.
stickslip_jump_limits stickslip_jump_limits_default(void);

// Writes how many cycles like this one may be jumped over to cycles, not rounded: as many as their wear may be taken off at
// once without the pressure swinging, and no more than the limits (may be NULL: the defaults) allow; infinite if nothing
// limits them.
//
// depth (lengths, count entries) is what the cycle removed, of both bodies together. STICKSLIP_CYCLE_NOT_CLOSED for a cycle
// that does not close, as the first from rest; STICKSLIP_NEGATIVE_OR_NOT_FINITE for a limit, STICKSLIP_SAMPLE for a depth.
stickslip_status stickslip_cycle_jump(const stickslip_half_space *half_space,
                                      const stickslip_cycle *cycle,
                                      const double *depth,
                                      size_t count,
                                      const stickslip_jump_limits *limits,
                                      double *cycles);

// Writes to cycles how many cycles of wear may be taken off at once without the pressure swinging up: explicit wear by
// Archard's law is stable below. coefficient (one over a pressure) is the sum of both bodies, slip_distance (lengths, count
// entries) that of one cycle; for the energy law the coefficient is that of the law times that of friction. Infinite if
// nothing slips.
stickslip_status stickslip_max_stable_cycles(const stickslip_half_space *half_space,
                                             const stickslip_per_cell *coefficient,
                                             const double *slip_distance,
                                             size_t count,
                                             double *cycles);

// Makes a solver of a gap before loading (lengths, count entries, copied) under a load.
//
// settings may be NULL (the defaults), as may hardness, the largest pressure that the cells carry (no limit).
stickslip_status stickslip_normal_solver_new(const stickslip_half_space *half_space,
                                             const double *gap,
                                             size_t count,
                                             const stickslip_normal_load *load,
                                             const stickslip_per_cell *hardness,
                                             const stickslip_settings *settings,
                                             stickslip_normal_solver **solver);

// Frees a solver; nothing for NULL.
stickslip_status stickslip_normal_solver_free(stickslip_normal_solver *solver);

// Changes the load of the next solve.
stickslip_status stickslip_normal_solver_set_load(stickslip_normal_solver *solver, const stickslip_normal_load *load);

// Changes the gap before loading of the next solve (lengths, count entries, copied).
stickslip_status stickslip_normal_solver_set_gap(stickslip_normal_solver *solver, const double *gap, size_t count);

// Changes method, tolerance and limits of the next solve.
stickslip_status stickslip_normal_solver_set_settings(stickslip_normal_solver *solver,
                                                      const stickslip_settings *settings);

// Forgets the last answer: the next solve starts as the first did.
stickslip_status stickslip_normal_solver_reset(stickslip_normal_solver *solver);

// Solves into a solution of stickslip_normal_solution_new for the same bodies. observer may be NULL.
//
// With STICKSLIP_NOT_CONVERGED the solution holds the last feasible iterate and its report; after any other failure it is
// as it was.
stickslip_status stickslip_normal_solver_solve(stickslip_normal_solver *solver,
                                               stickslip_normal_solution *solution,
                                               const stickslip_observer *observer);

// Makes an empty solution of the right size for a solver.
stickslip_status stickslip_normal_solution_new(const stickslip_normal_solver *solver,
                                               stickslip_normal_solution **solution);

// Frees a solution; nothing for NULL.
stickslip_status stickslip_normal_solution_free(stickslip_normal_solution *solution);

// STICKSLIP_PRESSURE or STICKSLIP_GAP, and how many cells it has (count may be NULL); NULL on failure.
const double *stickslip_normal_solution_field(const stickslip_normal_solution *solution, int32_t which, size_t *count);

// The numbers of the contact.
stickslip_status stickslip_normal_solution_result(const stickslip_normal_solution *solution,
                                                  stickslip_normal_result *result);

// How it was solved.
stickslip_status stickslip_normal_solution_report(const stickslip_normal_solution *solution, stickslip_report *report);

// Diagnostics that may mislead: writes them to a buffer of capacity entries, and how many there are to count. With
// capacity 0 only the number.
stickslip_status stickslip_normal_solution_warnings(const stickslip_normal_solution *solution,
                                                    stickslip_warning *buffer,
                                                    size_t capacity,
                                                    size_t *count);

// The stiffness of a normal contact on the bodies it was solved for.
stickslip_status stickslip_normal_solution_stiffness(const stickslip_normal_solution *solution,
                                                     const stickslip_half_space *half_space,
                                                     stickslip_normal_stiffness *stiffness);

// The same with an observer (may be NULL), which is called before every product with the operator and may end it:
// STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
stickslip_status stickslip_normal_solution_stiffness_observed(const stickslip_normal_solution *solution,
                                                              const stickslip_half_space *half_space,
                                                              const stickslip_observer *observer,
                                                              stickslip_normal_stiffness *stiffness);

// Makes planes at count depths (lengths, zero or positive, copied) below the surface of either body; with displacements
// if that is not zero. The kernels of a depth, 112 bytes for each cell (152 with displacements), are made when it is first
// solved, and kept.
stickslip_status stickslip_planes_new(const stickslip_half_space *half_space,
                                      const double *depths,
                                      size_t count,
                                      int32_t with_displacements,
                                      stickslip_planes **planes);

// Frees planes; nothing for NULL.
stickslip_status stickslip_planes_free(stickslip_planes *planes);

// Solves the plane at the depth of number index, counted from zero, in body STICKSLIP_BODY_1 or STICKSLIP_BODY_2, by fast
// transforms. STICKSLIP_LENGTH for an index that is not less than the number of depths, STICKSLIP_RIGID_BODY for a rigid
// body. After a failure the plane solved last is as it was.
stickslip_status stickslip_planes_solve(stickslip_planes *planes,
                                        size_t index,
                                        int32_t which,
                                        const stickslip_tractions *tractions);

// The same with an observer (may be NULL), which is called before the kernels are sampled and before each transform of a
// kernel and of three components, and may end it: STICKSLIP_NOT_CONVERGED. Watched, it takes memory for another plane.
stickslip_status stickslip_planes_solve_observed(stickslip_planes *planes,
                                                 size_t index,
                                                 int32_t which,
                                                 const stickslip_tractions *tractions,
                                                 const stickslip_observer *observer);

// A field of the plane solved last, STICKSLIP_STRESS_XX to STICKSLIP_STRESS_YZ or, of planes made with displacements,
// STICKSLIP_DISPLACEMENT_X to STICKSLIP_DISPLACEMENT_Z, and how many cells it has (count may be NULL); NULL on failure.
const double *stickslip_planes_field(const stickslip_planes *planes, int32_t which, size_t *count);

// Writes STICKSLIP_VON_MISES, STICKSLIP_MAX_SHEAR or STICKSLIP_HYDROSTATIC of each cell of the plane solved last to
// values, which has count entries.
stickslip_status stickslip_planes_measure(const stickslip_planes *planes, int32_t which, double *values, size_t count);

// Room for so many words of a block that is received, to be filled before the swap returns; NULL if there is no memory.
// Called by a stickslip_swap alone, on the block that it was given.
uint64_t *stickslip_block_room(stickslip_block *block, size_t words);

// The options that rolling solvers have by default.
stickslip_rolling_options stickslip_rolling_options_default(void);

// Makes a solver under the pressure of a solved normal contact on the same bodies, with room of a step of cells ahead of
// the contact, else STICKSLIP_GRID_TOO_SHORT. load (no creepage, no spin) and options (the defaults) may be NULL.
stickslip_status stickslip_rolling_solver_new(const stickslip_half_space *half_space,
                                              const stickslip_normal_solution *normal,
                                              const stickslip_friction *friction,
                                              const stickslip_rolling_load *load,
                                              const stickslip_rolling_options *options,
                                              stickslip_rolling_solver **solver);

// Frees a solver; nothing for NULL.
stickslip_status stickslip_rolling_solver_free(stickslip_rolling_solver *solver);

// Changes what is prescribed of the next solve. STICKSLIP_BEYOND_FRICTION_CAPACITY for a force or a moment that friction
// does not hold, or holds only by sliding.
stickslip_status stickslip_rolling_solver_set_load(stickslip_rolling_solver *solver,
                                                   const stickslip_rolling_load *load);

// Changes the friction of the next solve. STICKSLIP_BEYOND_FRICTION_CAPACITY if it does not hold the present load, or holds
// it only by sliding. The stiffness is about the last answer, if there is one, until that solve.
stickslip_status stickslip_rolling_solver_set_friction(stickslip_rolling_solver *solver,
                                                       const stickslip_friction *friction);

// Sets the pressure of the next solve to that of a solved normal contact on the same bodies. A contact within the largest
// window so far allocates nothing. STICKSLIP_BEYOND_FRICTION_CAPACITY if friction no longer holds the prescribed force.
stickslip_status stickslip_rolling_solver_set_normal(stickslip_rolling_solver *solver,
                                                     const stickslip_normal_solution *normal);

// Sets the pressure of the next solve to one from elsewhere (count entries, copied). It has no gap:
// STICKSLIP_UNSUPPORTED_BY_MODEL unless the solver has STICKSLIP_WHOLE_STEP.
stickslip_status stickslip_rolling_solver_set_pressure(stickslip_rolling_solver *solver,
                                                       const double *pressure,
                                                       size_t count);

// Sets the solver that finds the pressure of a new normal load; copied, with its gap, hardness and settings.
stickslip_status stickslip_rolling_solver_set_normal_solver(stickslip_rolling_solver *solver,
                                                            const stickslip_normal_solver *normal);

// Sets the normal load of the next solve, and solves for its pressure. STICKSLIP_UNSUPPORTED_BY_MODEL without a normal solver of
// stickslip_rolling_solver_set_normal_solver. After a failure the solver is unchanged.
stickslip_status stickslip_rolling_solver_set_normal_load(stickslip_rolling_solver *solver,
                                                          const stickslip_normal_load *load);

// The largest tangential force that friction holds.
stickslip_status stickslip_rolling_solver_friction_capacity(const stickslip_rolling_solver *solver, double *capacity);

// Forgets the last answer: the next solve starts as the first did, and the stiffness is that of a contact that sticks.
stickslip_status stickslip_rolling_solver_reset(stickslip_rolling_solver *solver);

// Changes method, tolerance and limits of the next solve.
stickslip_status stickslip_rolling_solver_set_settings(stickslip_rolling_solver *solver,
                                                       const stickslip_settings *settings);

// Solves into a solution of stickslip_rolling_solution_new for the same bodies. observer may be NULL.
//
// With STICKSLIP_NOT_CONVERGED the solution holds the last feasible iterate and its report; after any other failure it is
// as it was, except that STICKSLIP_MEMORY in the search for the spin of a moment leaves the answer at another spin.
stickslip_status stickslip_rolling_solver_solve(stickslip_rolling_solver *solver,
                                                stickslip_rolling_solution *solution,
                                                const stickslip_observer *observer);

// The slopes of the loads about the last answer. Cells that stick follow, cells that slip stay at their limits; before the
// first solve all cells stick: these are Kalker's coefficients, times G a b and lengths.
stickslip_status stickslip_rolling_solver_stiffness(stickslip_rolling_solver *solver,
                                                    stickslip_rolling_stiffness *stiffness);

// The same with an observer (may be NULL), which is called before every product with an operator and may end it:
// STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
stickslip_status stickslip_rolling_solver_stiffness_observed(stickslip_rolling_solver *solver,
                                                             const stickslip_observer *observer,
                                                             stickslip_rolling_stiffness *stiffness);

// The loads at count points, written to forces, each solved from the answer of the one before: neighbours in the order
// should be neighbours in the plane. The last point stays prescribed. All are checked before the first is solved. With
// STICKSLIP_NOT_CONVERGED the point that failed stays prescribed, and forces are as they were.
stickslip_status stickslip_rolling_solver_creep_forces(stickslip_rolling_solver *solver,
                                                       const stickslip_creep_point *points,
                                                       size_t count,
                                                       stickslip_creep_force *forces);

// The same with an observer (may be NULL), which is called before every product with an operator and may end it:
// STICKSLIP_NOT_CONVERGED, the point under way stays prescribed, and forces are as they were.
stickslip_status stickslip_rolling_solver_creep_forces_observed(stickslip_rolling_solver *solver,
                                                                const stickslip_creep_point *points,
                                                                size_t count,
                                                                const stickslip_observer *observer,
                                                                stickslip_creep_force *forces);

// Makes an empty solution of the right size for a solver.
stickslip_status stickslip_rolling_solution_new(const stickslip_rolling_solver *solver,
                                                stickslip_rolling_solution **solution);

// Frees a solution; nothing for NULL.
stickslip_status stickslip_rolling_solution_free(stickslip_rolling_solution *solution);

// STICKSLIP_TRACTION_X, STICKSLIP_SLIP_X or those along y, and how many cells it has (count may be NULL); NULL on failure.
// The slip is that for each length rolled (dimensionless), over the step that brought the particles to their cells.
const double *stickslip_rolling_solution_field(const stickslip_rolling_solution *solution,
                                               int32_t which,
                                               size_t *count);

// The zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; NULL on failure.
const uint8_t *stickslip_rolling_solution_zones(const stickslip_rolling_solution *solution, size_t *count);

// Energy that slip dissipates in each cell for each length rolled (a pressure), written to values, which has count
// entries: what wear follows. Between bodies of the same material its integral is less than the work by a part that falls
// with the size of the cells.
stickslip_status stickslip_rolling_solution_dissipation(const stickslip_rolling_solution *solution,
                                                        double *values,
                                                        size_t count);

// The numbers of the contact.
stickslip_status stickslip_rolling_solution_result(const stickslip_rolling_solution *solution,
                                                   stickslip_rolling_result *result);

// How it was solved.
stickslip_status stickslip_rolling_solution_report(const stickslip_rolling_solution *solution,
                                                   stickslip_report *report);

// Diagnostics that may mislead: as stickslip_normal_solution_warnings.
stickslip_status stickslip_rolling_solution_warnings(const stickslip_rolling_solution *solution,
                                                     stickslip_warning *buffer,
                                                     size_t capacity,
                                                     size_t *count);

// The options of a self-affine surface by default; height or slope is to be given.
stickslip_self_affine stickslip_self_affine_default(void);

// Writes the heights of a random surface (lengths, positive out of the body, of zero mean) to heights, which has count
// entries. The gap of this surface to a plane is any constant less the height.
//
// STICKSLIP_INVALID_ARGUMENT if height and slope are both given, STICKSLIP_NOT_POSITIVE for height, slope or a wavelength,
// STICKSLIP_HURST for the exponent, STICKSLIP_NOT_FINITE for skewness or kurtosis; STICKSLIP_BELOW_MINIMUM for a cut-off of less
// than two cells, a wavelength less than the next shorter one or a kurtosis less than the squared skewness plus one;
// STICKSLIP_NO_WAVE_IN_BAND if no wave fits the wavelengths, STICKSLIP_HEIGHT_MOMENTS_NOT_REACHED if no heights of such skewness and
// kurtosis are found; STICKSLIP_SAMPLE for the first height that overflows. heights is then as it was.
stickslip_status stickslip_surface_self_affine(const stickslip_grid *grid,
                                               const stickslip_self_affine *surface,
                                               double *heights,
                                               size_t count);

// The same with an observer (may be NULL), which is called before each transform of the surface, also of the iterations for
// skewness and kurtosis, and may end it: STICKSLIP_NOT_CONVERGED.
stickslip_status stickslip_surface_self_affine_observed(const stickslip_grid *grid,
                                                        const stickslip_self_affine *surface,
                                                        const stickslip_observer *observer,
                                                        double *heights,
                                                        size_t count);

// The statistics of count heights (lengths) on a grid. STICKSLIP_SAMPLE for the first height that is NaN or infinite,
// STICKSLIP_NOT_FINITE if their range or the square of their slopes overflows.
stickslip_status stickslip_surface_statistics(const stickslip_grid *grid,
                                              const double *heights,
                                              size_t count,
                                              stickslip_statistics *statistics);

// The contact spots, in the order of their first cells, and how many there are. With a NULL buffer and capacity 0 only
// that; STICKSLIP_BUFFER_TOO_SMALL for a buffer that is too small, to which nothing is written.
//
// labels, which has cells entries, gets the number of the spot of every cell, counted from one, and zero outside the
// contact; it may be NULL.
stickslip_status stickslip_normal_solution_spots(const stickslip_normal_solution *solution,
                                                 stickslip_spot *buffer,
                                                 size_t capacity,
                                                 size_t *count,
                                                 uint32_t *labels,
                                                 size_t cells);

// The contact spots under the pressure of a normal contact, with the part of each that sticks: as
// stickslip_normal_solution_spots.
stickslip_status stickslip_tangential_solution_spots(const stickslip_tangential_solution *solution,
                                                     const stickslip_normal_solution *normal,
                                                     stickslip_spot *buffer,
                                                     size_t capacity,
                                                     size_t *count,
                                                     uint32_t *labels,
                                                     size_t cells);

// The contact spots after the last step, with the part of each that sticks: as stickslip_normal_solution_spots.
stickslip_status stickslip_history_spots(const stickslip_history *history,
                                         stickslip_spot *buffer,
                                         size_t capacity,
                                         size_t *count,
                                         uint32_t *labels,
                                         size_t cells);

// Keeps a copy of the state of a history.
stickslip_status stickslip_state_new(const stickslip_history *history, stickslip_state **state);

// Frees a state; nothing for NULL.
stickslip_status stickslip_state_free(stickslip_state *state);

// Keeps the present state of a history in the place of an older one, whose memory it uses.
stickslip_status stickslip_state_keep(stickslip_state *state, const stickslip_history *history);

// Returns a history to a state, one of its own or of another on equal bodies.
stickslip_status stickslip_history_set_state(stickslip_history *history, const stickslip_state *state);

// The state of a history as bytes, some 60 to 130 for each cell. A history made from them by stickslip_history_from_bytes
// takes further steps with the same results, bit for bit.
//
// length gets how many there are. With a NULL buffer and capacity 0 only that; a buffer that is too small is
// STICKSLIP_BUFFER_TOO_SMALL, and nothing is written to it. Each call takes about as long as a warm step.
stickslip_status stickslip_history_to_bytes(const stickslip_history *history,
                                            uint8_t *buffer,
                                            size_t capacity,
                                            size_t *length);

// Makes a history from bytes of stickslip_history_to_bytes, on the bodies it had. Damaged bytes are STICKSLIP_FORMAT.
stickslip_status stickslip_history_from_bytes(const stickslip_half_space *half_space,
                                              const uint8_t *bytes,
                                              size_t length,
                                              stickslip_history **history);

// Displacement and stress of body STICKSLIP_BODY_1 or STICKSLIP_BODY_2 at count points, written to responses, by sums over
// all loaded cells: exact for a uniform traction on each. STICKSLIP_RIGID_BODY for a rigid body, STICKSLIP_DIVERGENT_PERIODIC_SUM on a grid
// that repeats along both axes. For whole planes stickslip_planes_solve is faster.
stickslip_status stickslip_stress_at_points(const stickslip_half_space *half_space,
                                            int32_t which,
                                            const stickslip_tractions *tractions,
                                            const stickslip_point *points,
                                            size_t count,
                                            stickslip_response *responses);

// The same with an observer (may be NULL), which is called before each portion of the points and may end it:
// STICKSLIP_NOT_CONVERGED, and responses is as it was.
stickslip_status stickslip_stress_at_points_observed(const stickslip_half_space *half_space,
                                                     int32_t which,
                                                     const stickslip_tractions *tractions,
                                                     const stickslip_point *points,
                                                     size_t count,
                                                     const stickslip_observer *observer,
                                                     stickslip_response *responses);

// The gap between a sphere and a plane that touch at the origin (lengths), written to gap, which has count entries.
stickslip_status stickslip_surface_sphere(const stickslip_grid *grid, double radius, double *gap, size_t count);

// The gap between an ellipsoid, of the radii of curvature radius_x and radius_y at the origin, and a plane.
stickslip_status stickslip_surface_ellipsoid(const stickslip_grid *grid,
                                             double radius_x,
                                             double radius_y,
                                             double *gap,
                                             size_t count);

// The gap between a cylinder along y and a plane.
stickslip_status stickslip_surface_cylinder(const stickslip_grid *grid, double radius, double *gap, size_t count);

// The options that tangential solvers have by default.
stickslip_tangential_options stickslip_tangential_options_default(void);

// Makes a solver under the pressure of a solved normal contact on the same bodies. options may be NULL (the defaults).
stickslip_status stickslip_tangential_solver_new(const stickslip_half_space *half_space,
                                                 const stickslip_normal_solution *normal,
                                                 const stickslip_friction *friction,
                                                 const stickslip_tangential_load *load,
                                                 const stickslip_tangential_options *options,
                                                 stickslip_tangential_solver **solver);

// Makes a solver under a pressure from elsewhere (count entries, zero or positive, copied). options may be NULL (the
// defaults).
stickslip_status stickslip_tangential_solver_new_under(const stickslip_half_space *half_space,
                                                       const double *pressure,
                                                       size_t count,
                                                       const stickslip_friction *friction,
                                                       const stickslip_tangential_load *load,
                                                       const stickslip_tangential_options *options,
                                                       stickslip_tangential_solver **solver);

// Frees a solver; nothing for NULL.
stickslip_status stickslip_tangential_solver_free(stickslip_tangential_solver *solver);

// Changes the load of the next solve.
stickslip_status stickslip_tangential_solver_set_load(stickslip_tangential_solver *solver,
                                                      const stickslip_tangential_load *load);

// Changes the friction of the next solve.
stickslip_status stickslip_tangential_solver_set_friction(stickslip_tangential_solver *solver,
                                                          const stickslip_friction *friction);

// Changes the pressure of the next solve to that of a solved normal contact.
stickslip_status stickslip_tangential_solver_set_normal(stickslip_tangential_solver *solver,
                                                        const stickslip_normal_solution *normal);

// Changes the pressure of the next solve to one from elsewhere (count entries, copied).
stickslip_status stickslip_tangential_solver_set_pressure(stickslip_tangential_solver *solver,
                                                          const double *pressure,
                                                          size_t count);

// Changes the relative displacement of the next solve.
stickslip_status stickslip_tangential_solver_set_relative_displacement(stickslip_tangential_solver *solver,
                                                                       const stickslip_relative_displacement *relative);

// Changes method, tolerance and limits of the next solve.
stickslip_status stickslip_tangential_solver_set_settings(stickslip_tangential_solver *solver,
                                                          const stickslip_settings *settings);

// Forgets the last answer: the next solve starts as the first did.
stickslip_status stickslip_tangential_solver_reset(stickslip_tangential_solver *solver);

// The largest tangential force that friction holds.
stickslip_status stickslip_tangential_solver_friction_capacity(const stickslip_tangential_solver *solver,
                                                               double *capacity);

// Solves into a solution of stickslip_tangential_solution_new for the same bodies. observer may be NULL.
//
// With STICKSLIP_NOT_CONVERGED the solution holds the last feasible iterate and its report; after any other failure it is
// as it was.
stickslip_status stickslip_tangential_solver_solve(stickslip_tangential_solver *solver,
                                                   stickslip_tangential_solution *solution,
                                                   const stickslip_observer *observer);

// Makes an empty solution of the right size for a solver.
stickslip_status stickslip_tangential_solution_new(const stickslip_tangential_solver *solver,
                                                   stickslip_tangential_solution **solution);

// Frees a solution; nothing for NULL.
stickslip_status stickslip_tangential_solution_free(stickslip_tangential_solution *solution);

// STICKSLIP_TRACTION_X, STICKSLIP_SLIP_X or those along y, and how many cells it has (count may be NULL); NULL on failure.
const double *stickslip_tangential_solution_field(const stickslip_tangential_solution *solution,
                                                  int32_t which,
                                                  size_t *count);

// The zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; NULL on failure.
const uint8_t *stickslip_tangential_solution_zones(const stickslip_tangential_solution *solution, size_t *count);

// The numbers of the contact.
stickslip_status stickslip_tangential_solution_result(const stickslip_tangential_solution *solution,
                                                      stickslip_tangential_result *result);

// How it was solved.
stickslip_status stickslip_tangential_solution_report(const stickslip_tangential_solution *solution,
                                                      stickslip_report *report);

// Diagnostics that may mislead: as stickslip_normal_solution_warnings.
stickslip_status stickslip_tangential_solution_warnings(const stickslip_tangential_solution *solution,
                                                        stickslip_warning *buffer,
                                                        size_t capacity,
                                                        size_t *count);

// The stiffness of a tangential contact on the bodies it was solved for.
stickslip_status stickslip_tangential_solution_stiffness(const stickslip_tangential_solution *solution,
                                                         const stickslip_half_space *half_space,
                                                         stickslip_tangential_stiffness *stiffness);

// The same with an observer (may be NULL), which is called before every product with the operator and may end it:
// STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
stickslip_status stickslip_tangential_solution_stiffness_observed(const stickslip_tangential_solution *solution,
                                                                  const stickslip_half_space *half_space,
                                                                  const stickslip_observer *observer,
                                                                  stickslip_tangential_stiffness *stiffness);

// Sets how many threads solve contacts of more than 4096 cells and batches, from the next call on; 0 for the default, one
// for each processor (or RAYON_NUM_THREADS). With 1 all is done by the thread that calls, and no other is ever started.
// Calls under way keep the threads they have. Results have the same bits on any number of threads.
//
// Threads do not survive a fork: a child process makes as many of its own at its first such call.
stickslip_status stickslip_set_num_threads(size_t count);

// The version of the library that is running, as "major.minor.patch"; it lives as long as the program.
const char *stickslip_version(void);

// STICKSLIP_ABI_VERSION of the library that is running.
uint32_t stickslip_abi_version(void);

// Adds to depth (lengths, count entries) what Archard's law removes in the last step: coefficient (one over a pressure)
// times pressure times slip. After a failure depth is as it was.
stickslip_status stickslip_wear_archard(const stickslip_history *history,
                                        const stickslip_per_cell *coefficient,
                                        double *depth,
                                        size_t count);

// Adds to depth what the energy law removes in the last step: coefficient (one over a pressure) times the energy dissipated
// per area.
stickslip_status stickslip_wear_energy(const stickslip_history *history,
                                       const stickslip_per_cell *coefficient,
                                       double *depth,
                                       size_t count);

// The same beyond a threshold, an energy per area that wears nothing, of the energy dissipated since the start.
stickslip_status stickslip_wear_threshold_energy(const stickslip_history *history,
                                                 const stickslip_per_cell *coefficient,
                                                 double threshold,
                                                 double *depth,
                                                 size_t count);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* STICKSLIP_H */
