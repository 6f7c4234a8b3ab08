//! The extension module of the Python package `stickslip`: classes and functions over the crate, which the package
//! sorts into modules. What is documented here is documented for Python.

mod array;
mod choice;
mod error;
mod field;
mod friction;
mod grid;
mod half_space;
mod held;
mod load;
mod normal;
mod pickle;
mod pool;
mod progress;
mod report;
mod settings;
mod spots;
mod stiffness;
mod surface;
mod analytical;
mod tangential;
mod work;

use pyo3::prelude::*;

/// What the package ``stickslip`` is made of; import that.
#[pymodule]
mod _stickslip {
    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }

    #[pymodule_export]
    use crate::{
        analytical::{
            CattaneoMindlin, CattaneoMindlinEllipse, CattaneoMindlinLine, Cone, ConePartialSlip, FlatPunch, HertzEllipse, HertzLine, HertzSphere, LubkinTorsion, MindlinDeresiewicz, MindlinFullStick, NoSlipPunch, NoSlipSphere, Persson, PopovLimitingShape, RoughSphere, RoundedPunch, SpencePressing, Westergaard, WestergaardPartialSlip, linear_stick_ratio,
        },
        field::Field,
        friction::{Friction, Hardness},
        grid::{Boundary, ElasticPair, Grid, Material},
        half_space::HalfSpace,
        load::{LoadStep, TangentialLoad},
        normal::{NormalProblem, NormalSolution, NormalSolver},
        pickle::_restore,
        pool::{num_threads, set_num_threads},
        report::{Iteration, Report, Warning},
        settings::Settings,
        spots::{ContactSpots, Spot},
        surface::{
            Filled, Levelled, PowerSpectrum, RoughSurface, SelfAffine, Statistics, bisinusoidal, cone, crop, cylinder,
            ellipsoid, fill_missing, flat_punch, gap_between, gap_from_heights, inverted, level, mirror_x, paraboloid,
            resample, sinusoidal, sphere, sum,
        },
        stiffness::{ContactStiffness, NormalStiffness, TangentialStiffness},
        tangential::{
            JaegerSuperposition, RelativeDisplacement, TangentialProblem, TangentialSolution,
            TangentialSolver,
        },
    };
}
