"""Compared codes: installed packages, and the settings and tolerances of each code."""

# Versions of all packages on which the numbers in the report depend.
PACKAGES = {
    "aspher": ["aspher==0.1.3.post1", "rfgen==0.2.3"],
    "tamaas": ["tamaas==2.9.0"],
    "ContactMechanics": [
        "ContactMechanics==1.8.3",
        "SurfaceTopography==1.27.1",
        "muGrid==1.6.1",
        "NuMPI==0.18.1",
    ],
}
COMMON = ["numpy==2.4.6", "scipy==1.17.1"]
# ASPHER is compiled locally and for the local processor, as its authors build it for themselves. The other codes are
# installed from the wheels of their authors.
OPTIONS = {"aspher": ["--no-cache-dir", "--config-settings=cmake.define.ASPHER_NATIVE=ON"]}

# Spinning threads are the default of this OpenMP runtime. They are fastest on a quiet machine and many times slower on
# a shared machine. ASPHER is therefore timed in both modes; the search for settings uses the mode that is less
# sensitive to noise.
CALM = "aspher, waits passive"
VARIANTS = {
    "aspher": ["aspher", CALM],
    "tamaas": ["tamaas"],
    "ContactMechanics": ["ContactMechanics"],
}
ENVIRONMENT = {CALM: {"OMP_WAIT_POLICY": "passive"}}
# The wheels of these codes are built without threads.
SINGLE_THREADED = ("tamaas", "ContactMechanics")

ASPHER_TOLERANCES = [1e-4, 1e-5, 2e-6, 1e-6, 1e-7, 1e-8, 1e-9]
DECADES = [10.0**-k for k in range(2, 11)]
HALF_DECADES = [x for k in range(2, 10) for x in (10.0**-k, 3.16 * 10.0 ** -(k + 1))] + [1e-10]

# (name, options) of each setting; the first settings are expected to be the fastest. A setting is dropped when it takes
# 1.3 times as long as the best setting for the same error. If it takes twice as long, it is also dropped for larger
# grids.
SETTINGS = {
    ("aspher", "press"): [
        ("nested fft, fft preconditioner", {"backend": "fft", "precond_engine": "fft"}),
        (
            "nested fft, fft preconditioner, float",
            {"backend": "fft", "precond_engine": "fft", "precision": "float"},
        ),
        (
            "nested fft, fft preconditioner, float then double",
            {"backend": "fft", "precond_engine": "fft", "precision": "float_then_double"},
        ),
        (
            "nested fft from 32, fft preconditioner",
            {"backend": "fft", "precond_engine": "fft", "coarsest": 32},
        ),
        ("nested fft", {"backend": "fft"}),
        ("nested fft, float then double", {"backend": "fft", "precision": "float_then_double"}),
        ("nested h2, active set", {"backend": "h2", "active_set": True}),
        ("nested h2", {"backend": "h2"}),
    ],
    ("aspher", "shear"): [("FrictionSolver", {"tol_normal": 1e-8})],
    ("tamaas", "press"): [("PolonskyKeerRey, dcfft", {})],
    ("ContactMechanics", "press"): [("free, Polonsky-Keer", {})],
}
TOLERANCES = {
    ("aspher", "press"): ASPHER_TOLERANCES,
    # At a tolerance of 1e-4 ASPHER has never reached an energy error of 1e-4.
    ("aspher", "shear"): [1e-5, 3e-7, 1e-7],
    ("tamaas", "press"): DECADES[2:],
    ("ContactMechanics", "press"): DECADES,
}

# Target values of the relative error in the energy norm.
TARGETS = [1e-4, 1e-6]
# Size and tolerance for the smallest error of each code on a small grid. Different influence coefficients would show as
# an error that does not vanish.
FLOOR_SIZE, FLOOR_TOLERANCE = 128, 1e-12
SHEAR_SIZES = [256, 512]
# Largest grids of the slow codes, which would take a day on larger grids.
LARGEST = {
    ("aspher", "shear", 1e-6): 256,
    ("tamaas", "press", 1e-6): 512,
    ("ContactMechanics", "press", 1e-6): 512,
}
# Problems that the slow peers solve on the largest grid.
SLOW_SCENES, ALL_SCENES_TO = ("sphere", "rough-10%"), 512
# Largest grid that is timed with fewer threads.
SECOND_PASS_TO = 512


def is_tried(code, problem, scene, target):
    if (code, problem) not in SETTINGS:
        return False
    if code in SINGLE_THREADED and scene["cells"] > ALL_SCENES_TO and scene["scene"] not in SLOW_SCENES:
        return False
    return scene["cells"] <= LARGEST.get((code, problem, target), scene["cells"])


# (problem, code, scene) of each range of ratios; an empty scene stands for all scenes.
RANGES = [
    ("press", "aspher", "sphere"),
    ("press", "aspher", "rough"),
    ("press", "tamaas", ""),
    ("press", "ContactMechanics", ""),
    ("shear", "aspher", ""),
]
