//! The extension module of the Python package `stickslip`: classes and functions over the crate, which the package
//! exports in several modules. The docs of its items are the Python docstrings.

mod adaptive;
mod analytical;
mod argument;
mod array;
mod boundary;
mod cgm;
mod choice;
mod content;
mod conversion;
mod coupled;
mod digits;
mod edges;
mod error;
mod field;
mod friction;
mod function;
mod grid;
mod half_space;
mod history;
mod images;
mod influence;
mod io;
mod kernel;
mod layers;
mod load;
mod material;
mod normal;
mod numpy_functions;
mod operator;
mod pickle;
mod pool;
mod progress;
mod ranks;
mod readers;
mod real;
mod report;
mod rolling;
mod samples;
mod sensitivity;
mod sequence;
mod settings;
mod solution_pool;
mod solver;
mod spots;
mod stiffness;
mod subsurface;
mod surface;
mod tangential;
mod unit;
mod work;
mod xarray;
mod xyz_header;

use pyo3::prelude::*;

/// Extension module of the package ``stickslip``; import that package instead.
#[pymodule]
mod _stickslip {
    use pyo3::prelude::*;

    /// Version of the package.
    #[pymodule_export]
    #[expect(
        non_upper_case_globals,
        reason = "the name that Python gives to versions"
    )]
    const __version__: &str = env!("CARGO_PKG_VERSION");

    #[pymodule_init]
    #[expect(
        clippy::unnecessary_wraps,
        reason = "the signature of what initialises a module"
    )]
    fn initialise(_module: &Bound<'_, PyModule>) -> PyResult<()> {
        crate::pool::initialise();
        Ok(())
    }

    #[pymodule_export]
    use crate::{
        adaptive::{AdaptiveProblem, AdaptiveSolution, GridRecord, Region},
        analytical::{
            BentallJohnson, Carter, CattaneoMindlin, CattaneoMindlinEllipse, CattaneoMindlinLine,
            Cone, ConePartialSlip, FlatPunch, HertzEllipse, HertzLine, HertzSphere,
            KalkerCoefficients, LubkinTorsion, MindlinDeresiewicz, MindlinFullStick, NoSlipPunch,
            NoSlipSphere, Persson, PopovLimitingShape, RoughSphere, RoundedPunch, SpencePressing,
            VermeulenJohnson, Westergaard, WestergaardPartialSlip, linear_stick_ratio,
        },
        boundary::Boundary,
        cgm::{Minimum, minimise},
        coupled::{CoupledProblem, CoupledReport, CoupledSolution, CoupledSolver, ErrorEstimate},
        edges::{Edges, TangentialEdges},
        field::Field,
        friction::Friction,
        grid::Grid,
        half_space::HalfSpace,
        history::{
            AdaptiveSteps, Cycle, CycleJump, EnergyBalance, History, LoadPath, LoopPoint,
            LoopPoints, Rolling, State, StepErrorEstimate, StepResult, archard, energy,
            max_stable_cycles, threshold_energy,
        },
        images::{PvdWriter, vti_to_bytes, vti_write},
        influence::{Rectangle, Table, Tensor},
        io::{
            asc_parse, asc_read, csv_parse, csv_read, csv_to_bytes, csv_write, npy_grid, npy_parse,
            npy_read, npy_to_bytes, npy_write, read, sdf_parse, sdf_read, sdf_to_bytes, sdf_write,
            sur_parse, sur_read, x3p_parse, x3p_read, xyz_parse, xyz_read,
        },
        kernel::Kernel,
        layers::{Layer, WaveResponse},
        load::{LoadStep, TangentialLoad},
        material::{ElasticPair, Material},
        normal::{Hardness, NormalProblem, NormalSolution, NormalSolver},
        operator::{
            Convolution, DenseMinimum, DenseOperator, LinearOperator, TensorOperator, identity,
        },
        pickle::{_from_bytes, _restore},
        pool::{num_threads, set_num_threads},
        report::{Iteration, Report, Warning},
        rolling::{
            CoupledRollingProblem, CoupledRollingReport, CoupledRollingSolution,
            CoupledRollingSolver, CreepForce, CreepForces, RollingProblem, RollingSolution,
            RollingSolver,
        },
        sensitivity::{Functional, Sensitivity},
        settings::Settings,
        spots::{ContactSpots, Spot},
        stiffness::{ContactStiffness, NormalStiffness, TangentialStiffness},
        subsurface::{Plane, Planes, PointResult, PointResults, Principal, Stress, at_points},
        surface::{
            Autocorrelation, Filled, Filtered, Levelled, MaterialRatio, PowerSpectrum,
            RoughSurface, SelfAffine, Statistics, WithoutOutliers, bisinusoidal, cone, crop,
            cylinder, ellipsoid, fill_missing, flat_punch, gap_between, gap_from_heights,
            gaussian_filter, inverted, level, mirror_x, paraboloid, remove_outliers, resample,
            sinusoidal, sphere, sum,
        },
        tangential::{
            JaegerSuperposition, RelativeDisplacement, TangentialProblem, TangentialSolution,
            TangentialSolver,
        },
    };
}
