//! Stiffness of a contact with coupled pressure and shear.

use crate::bodies::component::Direction;
use crate::cgm::cone::FrozenState;
use crate::cgm::{CellCompliance, Row, UNLIMITED, reduce};
use crate::coupled::CoupledSolution;
use crate::error::{Result, check_converged};
use crate::grid::boundary::Boundary;
use crate::grid::per_cell::PerCell;
use crate::half_space::{HalfSpace, Region};
use crate::normal::Hardness;
use crate::numerics::cell_vector::slices;
use crate::observer::{Observer, unwatched};
use crate::operator::Operator;
use crate::parallel;
use crate::report::Iteration;
use crate::stiffness::contact::{ContactCells, Pressing, SolvedContact, check_open, collect};
use crate::stiffness::motions::kinds;
use crate::stiffness::system::System;
use crate::stiffness::workspace::SystemBuffers;
use crate::stiffness::{
    ContactStiffness, NormalStiffness, StiffnessWorkspace, TangentialStiffness,
};
use crate::tangential::{Axis, Friction, centre};
use std::ops::ControlFlow;

/// Number of components of a vector (z, x and y).
const N: usize = 3;

/// Value of an unknown bound.
const UNKNOWN: f64 = f64::INFINITY;

/// Derivatives of the normal force, the tangential forces and the moment with respect to the approach, the shifts along x and y
/// and the twist. The first index is the motion.
type LoadMatrix = [[f64; 4]; 4];

/// Returns the system of pressure and tractions on a region.
pub(crate) fn joint_system<'s, R: Row<N>>(
    bodies: &HalfSpace,
    region: &Region,
    slot: &'s mut Option<System<R, N>>,
) -> Result<&'s mut System<R, N>> {
    let [x, y, z] = [Direction::X, Direction::Y, Direction::Z];
    let compliance = bodies.compliance([z, x, y], region.window().size)?;
    System::get_or_create(slot, bodies, compliance, |_| {
        let plane = bodies.compliance([x, y], bodies.grid().whole().size())?;
        Ok(plane.operator.self_compliance())
    })
}

impl SolvedContact<'_> {
    /// Copies the values that determine the states of a coupled contact to the cells of the region.
    pub(crate) fn take_coupled(
        &self,
        region: &Region,
        pressure: &[f64],
        cells: &mut ContactCells,
    ) -> Result<()> {
        cells.take(region, self)?;
        collect(region, |i| pressure[i], &mut cells.pressure)?;
        if let PerCell::Cells(limits) = self.limits() {
            collect(region, |i| limits[i], &mut cells.hardness)?;
        }
        Ok(())
    }

    fn limits(&self) -> PerCell<&[f64]> {
        self.hardness.map_or(UNLIMITED, Hardness::limits)
    }

    /// Returns the states of the cells, in which cells at their limits continue to slip or stick.
    pub(crate) fn frozen<'c>(&self, cells: &'c ContactCells, slips: bool) -> FrozenState<'c> {
        let [qx, qy] = slices(&cells.traction);
        FrozenState {
            x: [&cells.pressure, qx, qy],
            slip: slices(&cells.slip),
            own: if slips { &cells.entered } else { &[] },
            hardness: self.limits().map(|_| &*cells.hardness),
            slips,
        }
    }

    /// Returns the derivatives of the loads with respect to the approach, the shifts along x and y and the twist while slip
    /// continues. It also returns the derivatives with respect to the shifts and the twist while all cells stick.
    pub(crate) fn coupled_stiffness(
        &self,
        (normal, friction): Pressing<'_>,
        workspace: &mut StiffnessWorkspace,
        observer: Observer<'_>,
    ) -> Result<ContactStiffness> {
        let (bodies, pressure) = (self.bodies, normal.pressure().as_slice());
        workspace.check_alike(bodies)?;
        let (mut context, buffers) = workspace.begin(observer);
        let SystemBuffers {
            has_reversal,
            joint,
            cells,
            ..
        } = buffers;
        let (grid, boundary) = (bodies.grid(), bodies.boundary());
        bodies.joint(parallel::enter_with(grid.cells(), || {
            let Some(region) = self.region(self.windows[0], |i| pressure[i] > 0.0) else {
                let (tangential, none) = self.without_contact(None, *has_reversal, &mut context);
                return Ok(ContactStiffness {
                    normal: NormalStiffness::NONE,
                    tangential,
                    by_approach: none,
                    normal_by_motion: none,
                });
            };
            let layout = bodies.grid_layout();
            check_open(bodies, || reduce::any(&layout, |i| pressure[i] <= 0.0))?;
            let system = joint_system(bodies, &region, joint)?;
            self.take_coupled(&region, pressure, cells)?;
            let within = &friction.within(&region);
            let place = |cell: usize| centre(grid.whole(), region.own().index(cell));
            let mut loads = |slips: bool| {
                let state = self.frozen(cells, slips);
                let response = &mut system.response;
                let rows = state.rows(&response.layout, &within, system.self_compliance);
                response.linear.hold(rows)?;
                response.responses(
                    system.compliance.with_cells(CellCompliance::default()),
                    if boundary.may_turn() { 4 } else { 3 },
                    |motion, cell| moved(motion, place(cell)),
                    |cell, q| {
                        let ([x, y], [p, qx, qy]) = (place(cell), q.map(|q| grid.cell_area() * q));
                        [p, qx, qy, x * qy - y * qx]
                    },
                    &mut context,
                )
            };
            let loading = loads(true)?;
            let reversal = has_reversal.then(|| loads(false)).transpose()?;
            Ok(whole(boundary, &loading, reversal.as_ref()))
        }))
    }
}

impl CoupledSolution {
    /// Computes the stiffness of the contact with the friction of the problem. It consists of the derivatives of the normal
    /// force, the tangential forces and the moment with respect to the approach and the tangential motions. The loading stiffness
    /// applies while the load continues.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(32, 3.0)?;
    /// let rubber = ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?;
    /// let bodies = HalfSpace::new(grid, rubber)?;
    /// let (ball, friction) = (surface::sphere(grid, 10.0)?, Friction::coulomb(0.4)?);
    /// let at = |approach: f64, shift: f64| {
    ///     let (normal, load) = (NormalLoad::Approach(approach), TangentialLoad::shift([shift, 0.0]));
    ///     let problem = CoupledProblem::builder(&bodies, &ball, friction.clone(), normal, load);
    ///     problem.tolerance(1e-10).build()?.solve()
    /// };
    /// let stiffness = at(0.1, 0.01)?.stiffness(&bodies, &friction)?;
    /// // Shearing changes the normal force.
    /// let force = |shift: f64| at(0.1, shift).map(|contact| contact.normal().force());
    /// let slope = (force(0.010_001)? - force(0.009_999)?) / 2e-6;
    /// let expected = stiffness.normal_by_motion[0].unwrap_or(0.0);
    /// assert!((slope - expected).abs() < 1e-4 * stiffness.normal.value);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch),
    ///   [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch) or
    ///   [`Error::MaterialMismatch`](crate::Error::MaterialMismatch) if the solution was computed for other bodies, or
    ///   if the friction has a different grid.
    /// - [`Error::OutdatedSolution`](crate::Error::OutdatedSolution) if the solution was computed for a different friction.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if a periodic contact is closed everywhere.
    /// - [`Error::NotConverged`](crate::Error::NotConverged) for a solution that has not been solved, or if a linear
    ///   solve fails or is cancelled.
    /// - [`Error::Ranks`](crate::Error::Ranks) if ranks fail or pass different input.
    /// - The errors of [`NormalSolution::stiffness`](crate::NormalSolution::stiffness) for a contact that has yielded.
    /// - The errors of [`HalfSpace::operator`].
    pub fn stiffness(&self, bodies: &HalfSpace, friction: &Friction) -> Result<ContactStiffness> {
        self.stiffness_observed(bodies, friction, unwatched)
    }

    /// Computes the [`stiffness`](Self::stiffness) with an observer. The observer is called before every product with the
    /// operator and may cancel.
    ///
    /// # Errors
    /// The errors of [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &self,
        bodies: &HalfSpace,
        friction: &Friction,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<ContactStiffness> {
        let (normal, tangential) = (self.normal(), self.tangential());
        let checked = normal.check_bodies(bodies);
        let checked = checked.and_then(|()| normal.check_elastic("the stiffness"));
        let checked = checked.and_then(|()| check_converged(&self.report().work));
        bodies.collective_result(checked.and_then(|()| friction.check(bodies.grid())))?;
        tangential.check_limits(bodies, normal, friction)?;
        let contact = SolvedContact::sheared(bodies, tangential);
        let workspace = &mut StiffnessWorkspace::new();
        contact.coupled_stiffness((normal, friction), workspace, &mut observer)
    }
}

/// Returns the displacement of a point for a unit of approach, shift along x, shift along y or twist about the origin.
fn moved(motion: usize, [x, y]: [f64; 2]) -> [f64; N] {
    match motion {
        0 => [1.0, 0.0, 0.0],
        1 => [0.0, 1.0, 0.0],
        2 => [0.0, 0.0, 1.0],
        _ => [0.0, -y, x],
    }
}

/// Returns the stiffness from the loads per unit of each motion.
fn whole(
    boundary: Boundary,
    loading: &LoadMatrix,
    reversal: Option<&LoadMatrix>,
) -> ContactStiffness {
    let has = kinds(Axis::BOTH, boundary);
    let matrix = |loads: &LoadMatrix| {
        let entry = |load: usize, motion: usize| loads[1 + motion][1 + load];
        [0, 1, 2].map(|load| {
            [0, 1, 2].map(|motion| (has[load] && has[motion]).then(|| entry(load, motion)))
        })
    };
    ContactStiffness {
        normal: NormalStiffness {
            value: loading[0][0],
            bound: UNKNOWN,
        },
        tangential: TangentialStiffness {
            loading: matrix(loading),
            reversal: reversal.map_or([[None; 3]; 3], matrix),
            bound: UNKNOWN,
        },
        by_approach: [0, 1, 2].map(|load| has[load].then(|| loading[0][1 + load])),
        normal_by_motion: [0, 1, 2].map(|motion| has[motion].then(|| loading[1 + motion][0])),
    }
}
