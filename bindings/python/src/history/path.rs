//! Cyclic load paths.

use numpy::PyArray2;
use pyo3::prelude::*;

use crate::argument::by_value;
use crate::array::Array;
use crate::conversion;
use crate::digits::{counted, tuple};
use crate::error::OrRaise;
use crate::pickle::picklable;
use crate::real::{Count, Real};
use crate::sequence::{entry, pair};

/// A cycle of a tangential load in the plane, given by the values (x, y) at the ends of its steps. The caller uses these
/// values as forces or as shifts. A path is a sequence of pairs.
///
/// Parameters
/// ----------
/// steps : sequence of pairs of float, or array_like of shape (n, 2)
///     The values (x, y) at the ends of the steps (forces or lengths). The columns of a table of pandas are recognised by the
///     names x and y.
///
/// Raises
/// ------
/// EmptyPath, Sample
///
/// Examples
/// --------
/// >>> from stickslip.history import LoadPath
/// >>> path = LoadPath.sine((20.0, 0.0), 40)
/// >>> len(path), path[9], path.end
/// (40, (20.0, 0.0), (0.0, 0.0))
#[pyclass(frozen, eq, module = "stickslip.history", sequence)]
#[derive(Clone, PartialEq)]
pub(crate) struct LoadPath(pub(crate) stickslip::history::LoadPath);

type Path = stickslip::history::LoadPath;

by_value!(LoadPath);

#[pymethods]
impl LoadPath {
    #[new]
    fn new(py: Python<'_>, steps: conversion::PathSteps) -> PyResult<Self> {
        Path::table(steps.0).or_raise(py).map(Self)
    }

    /// Returns a sinusoidal path along a line: the amplitude (x, y) times sin(2 pi t). The path goes from zero to the
    /// amplitude, to its negative, and back to zero. The number of steps must be a multiple of four. A path along x has
    /// the amplitude (a, 0). The amplitude is half of the stroke (zero to peak).
    #[staticmethod]
    fn sine(py: Python<'_>, amplitude: conversion::Amplitude, steps: Count) -> PyResult<Self> {
        Path::sine(amplitude.0, steps.0).or_raise(py).map(Self)
    }

    /// Returns a path back and forth along a line at a constant rate. The number of steps must be a multiple of four. The
    /// amplitude is half of the stroke (zero to peak).
    #[staticmethod]
    fn triangle(py: Python<'_>, amplitude: conversion::Amplitude, steps: Count) -> PyResult<Self> {
        Path::triangle(amplitude.0, steps.0).or_raise(py).map(Self)
    }

    /// Returns a path around an ellipse with the amplitudes (A_x, A_y): A_x sin(2 pi t) along x and A_y sin(2 pi t +
    /// phase) along y, with the phase in radians. The number of steps must be a multiple of four. Each amplitude is half of
    /// the stroke along its axis (zero to peak).
    #[staticmethod]
    fn ellipse(
        py: Python<'_>,
        amplitudes: conversion::EllipseAmplitudes,
        phase: Real,
        steps: Count,
    ) -> PyResult<Self> {
        Path::ellipse(amplitudes.0, phase.0, steps.0)
            .or_raise(py)
            .map(Self)
    }

    /// Values of one cycle, of shape (steps, 2).
    #[getter]
    fn steps<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let rows: Vec<Vec<f64>> = self.0.steps().iter().map(|step| step.to_vec()).collect();
        Ok(Array::of(PyArray2::from_vec2(py, &rows)?))
    }

    /// Value at the end of a cycle, where the next cycle starts.
    #[getter]
    fn end(&self) -> (f64, f64) {
        pair(self.0.end())
    }

    /// Returns the values of the given number of consecutive cycles.
    fn cycles(&self, count: Count) -> Vec<(f64, f64)> {
        self.0.cycles(count.0).map(pair).collect()
    }

    fn __len__(&self) -> usize {
        self.0.steps().len()
    }

    fn __getitem__(&self, index: isize) -> PyResult<(f64, f64)> {
        entry(self.0.steps(), index, "step").copied().map(pair)
    }

    fn __repr__(&self) -> String {
        let steps = counted(self.0.steps().len(), "step");
        format!("LoadPath({steps}, end={})", tuple(&self.0.end()))
    }
}

picklable!(LoadPath: stickslip::history::LoadPath);
