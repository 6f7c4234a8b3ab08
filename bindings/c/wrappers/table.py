"""Objects of the C++ and Fortran interfaces, and the C function of each method.

The signature of a method follows from the C function. This table lists the methods and the differences between the
languages: other names, another order of the arguments, or a method of one language only."""

from dataclasses import dataclass, field


@dataclass
class Method:
    """Method. `c` is the name of its C function without the prefix of the object, by default the name of the method."""

    name: str
    c: str = ""
    # Name of the method in C++, and of the procedure in Fortran; None if the language does not have it.
    cpp: str | None = ""
    f: str | None = ""
    # Names of the arguments in the order of C++ or Fortran; empty for the order of C, with optional arguments last.
    cpp_order: str = ""
    f_order: str = ""
    # Other names of arguments.
    renamed: dict = field(default_factory=dict)
    # Only result that C++ returns, if the C function has several optional ones.
    part: str = ""
    # Method whose result C++ returns afterwards.
    then: str = ""
    # Whether the procedure in Fortran also creates the object.
    creates: bool = False
    # Whether the C function has no prefix of the object.
    is_apart: bool = False
    # Whether C++ also fills a vector of the caller, which keeps the entries computed before a failure.
    into: bool = False

    def __post_init__(self):
        self.c = self.c or self.name
        self.cpp = self.name if self.cpp == "" else self.cpp
        self.f = self.name if self.f == "" else self.f


@dataclass
class Object:
    """Object with its names in C (without `stickslip_`), C++ and Fortran."""

    c: str
    cpp: str
    f: str
    methods: list
    # Fields that have an accessor in C++; the first one has the cells of the grid.
    fields: str = ""
    has_grid: bool = True

    def __post_init__(self):
        self.methods = [method if isinstance(method, Method) else Method(name) for method in self.methods
                        for name in ([""] if isinstance(method, Method) else method.split())]


@dataclass
class File:
    """C++ header and Fortran module with objects, and with functions that belong to no object."""

    cpp: str
    f: str
    title: str
    includes: str
    uses: str
    objects: list
    functions: list = field(default_factory=list)


def cpp_only(name, **options):
    return Method(name, f=None, **options)


def f_only(name, **options):
    return Method(name, cpp=None, **options)


BODY = {"which": "body"}
# Accessors of several objects.
READ = "field zones result report warnings"

FILES = [
    File("bodies", "objects", "Two bodies on a grid.", "materials", "", [
        Object("half_space", "HalfSpace", "half_space", [
            "new", Method("new_coated", cpp="new"), cpp_only("new_distributed", cpp="new"),
            "first_row set_cell_value cell_value", cpp_only("grid"), "pair", f_only("bulk_strain", is_apart=True)]),
    ]),
    File("normal", "normal", "Normal contact.", "bodies loads", "objects", [
        Object("normal_solution", "NormalSolution", "normal_solution", [
            "field result report warnings stiffness spots edges discretisation_estimate"], "pressure gap"),
        Object("normal_solver", "NormalSolver", "normal_solver", [
            Method("new", cpp_order="bodies gap load settings hardness"), "set_load set_gap set_settings reset solve"]),
    ]),
    File("tangential", "tangential", "Tangential contact under a given pressure.", "normal", "objects normal", [
        Object("tangential_solution", "TangentialSolution", "tangential_solution", [
            READ, "stiffness spots edges discretisation_estimate"], "traction_x traction_y slip_x slip_y"),
        Object("tangential_solver", "TangentialSolver", "tangential_solver", [
            "new", Method("new_under", cpp="new"), "set_load set_friction", Method("set_normal", cpp="set_pressure"),
            "set_pressure set_relative_displacement set_settings reset friction_capacity solve"]),
    ]),
    File("coupled", "coupled", "Coupled pressure and traction of dissimilar bodies.", "bodies loads", "objects", [
        Object("coupled_solution", "CoupledSolution", "coupled_solution", [
            "field zones", cpp_only("normal", c="results", part="normal"),
            cpp_only("tangential", c="results", part="tangential"), f_only("results"),
            "report warnings stiffness edges pressure_edges",
            Method("discretisation_estimates", renamed={"of_pressure": "pressure", "of_traction": "traction"})],
            "pressure"),
        Object("coupled_solver", "CoupledSolver", "coupled_solver", [
            Method("new", cpp_order="bodies gap friction normal tangential settings relative hardness",
                   f_order="bodies gap friction normal tangential hardness settings relative"),
            "set_loads set_gap set_friction set_settings reset solve"]),
    ]),
    File("rolling", "rolling", "Steady rolling.", "normal", "objects normal", [
        Object("rolling_solution", "RollingSolution", "rolling_solution", [READ, "dissipation_per_area"],
               "traction_x traction_y slip_x slip_y"),
        Object("rolling_solver", "RollingSolver", "rolling_solver", [
            "new set_load set_friction", Method("set_normal", cpp="set_pressure"),
            "set_pressure set_normal_solver set_normal_load normal friction_capacity set_settings reset solve stiffness",
            Method("creep_forces", into=True), "creep_warnings"]),
        Object("coupled_rolling_solution", "CoupledRollingSolution", "coupled_rolling_solution", [
            "field zones", cpp_only("normal_result", c="results", part="normal"),
            cpp_only("rolling_result", c="results", part="rolling"), f_only("results"), "report warnings"],
            "pressure gap traction_x traction_y slip_x slip_y"),
        Object("coupled_rolling_solver", "CoupledRollingSolver", "coupled_rolling_solver", [
            "new set_normal_load set_load set_gap set_friction set_settings reset solve stiffness"]),
    ], [cpp_only(name) for name in
        ("carter_cylinder", "bentall_johnson_cylinder", "kalker_coefficients", "vermeulen_johnson_ellipse")]),
    File("history", "histories", "Load histories: steps with memory of slip, saved states, and their stiffness.",
         "bodies loads", "objects", [
        Object("stiffness_workspace", "StiffnessWorkspace", "stiffness_workspace", ["new set_options report"],
               has_grid=False),
        Object("history", "History", "contact_history", [
            "new from_bytes to_bytes clone", Method("step", then="result"),
            "press set_gap set_friction set_settings set_relative_displacement set_state result",
            Method("normal_result", cpp="normal"), "stiffness next_stiffness",
            Method("stiffness_with", cpp="stiffness"),
            "friction_capacity reports warnings field zones spots", cpp_only("grid"),
            *(Method(name, is_apart=True) for name in ("wear_archard", "wear_energy", "wear_threshold_energy"))],
            "pressure traction_x traction_y"),
        Object("state", "State", "contact_state", [cpp_only("new"), Method("keep", creates=True)], has_grid=False),
    ]),
    File("paths", "cycles", "Adaptive load steps, and cycles of histories.", "history batch", "objects histories", [
        Object("adaptive_steps", "AdaptiveSteps", "adaptive_steps", ["new step stepwise error"], has_grid=False),
        Object("cycle", "Cycle", "contact_cycle", [
            cpp_only("new"), Method("begin", creates=True), "add", Method("result", c="result_of"), "field",
            "jump"]),
    ], [Method("history_press_stepwise", cpp="press_stepwise", f="press_stepwise"), cpp_only("max_stable_cycles")]),
    File("stress", "stresses", "Stress and displacement below the surface, and closed-form solutions.", "bodies loads",
         "objects", [
        Object("planes", "Planes", "stress_planes", ["new", Method("solve", renamed=BODY), "field measure warnings"],
               "stress_xx"),
    ], [Method("stress_at_points", cpp="stress_at", renamed=BODY,
               f_order="bodies body points responses tractions observer"),
        cpp_only("hertz_sphere"), cpp_only("cattaneo_mindlin_sphere")]),
]

# Functions without a method: errors, versions, defaults, and the functions that are called by hand-written code.
OTHERS = """last_error last_error_message last_error_copy last_error_report version abi_version set_num_threads block_room
    coulomb history_step_all surface_sphere surface_ellipsoid surface_cylinder surface_self_affine
    surface_self_affine_observed surface_statistics""".split()
