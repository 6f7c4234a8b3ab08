"""Who takes part: what is installed, and which settings and tolerances of each code are tried."""

# Every version that a number in the report depends on.
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
# ASPHER is built here, and for this processor, as its authors build it for themselves; the other codes
# come as their authors' wheels.
OPTIONS = {"aspher": ["--no-cache-dir", "--config-settings=cmake.define.ASPHER_NATIVE=ON"]}

# Spinning threads are the default of OpenMP here: fastest on a quiet machine, many times slower on a shared one.
# ASPHER is therefore timed both ways; settings are looked for in the way that noise does not upset.
CALM = "aspher, waits passive"
VARIANTS = {
    "aspher": ["aspher", CALM],
    "tamaas": ["tamaas"],
    "ContactMechanics": ["ContactMechanics"],
}
ENVIRONMENT = {CALM: {"OMP_WAIT_POLICY": "passive"}}
# The wheels of these were built without threads.
SINGLE_THREADED = ("tamaas", "ContactMechanics")

ASPHER_TOLERANCES = [1e-4, 1e-5, 2e-6, 1e-6, 1e-7, 1e-8, 1e-9]
DECADES = [10.0**-k for k in range(2, 11)]
HALF_DECADES = [x for k in range(2, 10) for x in (10.0**-k, 3.16 * 10.0 ** -(k + 1))] + [1e-10]

# (name, options) of each setting; the first ones are expected to be the fastest. A setting is dropped once it
# takes 1.3 times as long as the best one took to reach the same error, on larger grids too if it takes twice as long.
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
    # At 1e-4 it has never come below an energy error of 1e-4.
    ("aspher", "shear"): [1e-5, 3e-7, 1e-7],
    ("tamaas", "press"): DECADES[2:],
    ("ContactMechanics", "press"): DECADES,
}

# Relative errors in the energy norm to be reached.
TARGETS = [1e-4, 1e-6]
# How close all codes come on a small grid: other influence coefficients would show as an error that stays.
FLOOR_SIZE, FLOOR_TOLERANCE = 128, 1e-12
SHEAR_SIZES = [256, 512]
# Beyond these sizes the slow ones would take the day.
LARGEST = {
    ("aspher", "shear", 1e-6): 256,
    ("tamaas", "press", 1e-6): 512,
    ("ContactMechanics", "press", 1e-6): 512,
}
# Of the scenes on the largest grid the slow peers see these.
SLOW_SCENES, ALL_SCENES_TO = ("sphere", "rough-10%"), 512
# With fewer threads nothing is timed on larger grids than this.
SECOND_PASS_TO = 512


def is_tried(code, problem, scene, target):
    if (code, problem) not in SETTINGS:
        return False
    if code in SINGLE_THREADED and scene["cells"] > ALL_SCENES_TO and scene["scene"] not in SLOW_SCENES:
        return False
    return scene["cells"] <= LARGEST.get((code, problem, target), scene["cells"])


# (problem, code, scene) of each aim, with the ratio aimed at.
AIMS = [
    ("press", "aspher", "sphere", 3),
    ("press", "aspher", "rough", 4),
    ("press", "tamaas", "", 30),
    ("press", "ContactMechanics", "", 30),
    ("shear", "aspher", "", 100),
]
