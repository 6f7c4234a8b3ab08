//! Stiffness of a contact with coupled pressure and shear.

use crate::bodies::component::Direction;
use crate::cgm::cone::{ConeProblem, ConeWorkspace, FrozenState};
use crate::cgm::{CellCompliance, FixedSetSystem, Total, UNLIMITED, reduce};
use crate::coupled::CoupledSolution;
use crate::error::{Result, finite};
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::grid::per_cell::PerCell;
use crate::grid::window::Window;
use crate::half_space::{Compliance, HalfSpace, Region};
use crate::memory::fallible;
use crate::normal::Hardness;
use crate::numerics::cell_vector::{at, slices};
use crate::observer::{Observer, unwatched};
use crate::operator::{LowerBound, Operator};
use crate::parallel;
use crate::report::Iteration;
use crate::stiffness::contact_stiffness::{window_of, without_contact};
use crate::stiffness::motions::kinds;
use crate::stiffness::workspace::LinearSolveContext;
use crate::stiffness::workspace::{SystemBuffers, get_or_create};
use crate::stiffness::{
    ContactStiffness, NormalStiffness, StiffnessWorkspace, TangentialStiffness,
};
use crate::tangential::{Axis, Friction, centre};
use std::ops::ControlFlow;

/// Number of components of a vector (z, x and y).
const N: usize = 3;

/// Value of an unknown bound.
const UNKNOWN: f64 = f64::INFINITY;

/// Contact under pressure and shear, as input of a stiffness.
pub(crate) struct Coupled<'a> {
    pub(crate) pressure: &'a Field,
    pub(crate) traction: [&'a Field; 2],
    /// Slip of the step, or `None` for the stiffness of the next step.
    pub(crate) slip: Option<[&'a [f64]; 2]>,
    /// Entry compliance of the cells that came into contact in the step. Empty if no cell came into contact.
    pub(crate) entered: &'a [f64],
    pub(crate) friction: &'a Friction,
    pub(crate) hardness: Option<&'a Hardness>,
    /// Window in which the contact was solved, if known.
    pub(crate) window: Option<Window>,
}

/// Derivatives of the normal force, the tangential forces and the moment with respect to a motion.
type LoadVector = [f64; 4];

/// Buffers for coupled contacts on a window.
#[derive(Debug)]
pub(super) struct CoupledBuffers {
    compliance: Compliance<N>,
    /// Tangential displacement of a cell under a unit tangential traction on it.
    self_compliance: f64,
    workspace: ConeWorkspace,
    /// Pressure, tractions, slips, entry compliance and hardness of the cells.
    cells: [Vec<f64>; 7],
    right: Vec<[f64; N]>,
    unknowns: Vec<[f64; N]>,
}

impl CoupledBuffers {
    /// Returns the buffers for a window. Reuses the existing buffers if they belong to this window.
    fn get_or_create<'a>(
        slot: &'a mut Option<Self>,
        bodies: &HalfSpace,
        compliance: Compliance<N>,
    ) -> Result<&'a mut Self> {
        let Compliance { operator, inverse } = compliance.clone();
        operator.check_bounded()?;
        let is_own = |own: &Self| {
            own.compliance.operator.is(&operator) && own.compliance.inverse.is(&inverse)
        };
        get_or_create(slot, is_own, || {
            let (x, y) = (Direction::X, Direction::Y);
            let plane = bodies.compliance([x, y], bodies.grid().whole().size())?;
            Ok(Self {
                self_compliance: plane.operator.self_compliance(),
                workspace: ConeWorkspace::new(&operator, &inverse)?,
                cells: fallible::vector(operator.cells())?,
                right: Vec::new(),
                unknowns: Vec::new(),
                compliance,
            })
        })
    }
}

impl Coupled<'_> {
    /// Returns the derivatives of the loads with respect to the approach, the shifts along x and y and the twist while slip
    /// continues. It also returns the derivatives with respect to the shifts and the twist while all cells stick.
    pub(crate) fn stiffness(
        &self,
        bodies: &HalfSpace,
        workspace: &mut StiffnessWorkspace,
        observer: Observer<'_>,
    ) -> Result<ContactStiffness> {
        workspace.check_alike(bodies)?;
        let (mut course, SystemBuffers { joint, .. }) = workspace.begin(observer);
        let pressure = self.pressure.as_slice();
        let Some(window) = bodies.around(|i| pressure[i] > 0.0) else {
            return Ok(ContactStiffness::without_contact(
                bodies.boundary(),
                &mut course,
            ));
        };
        let window = window_of(bodies, self.window, window);
        let is_open = || reduce::any(&bodies.grid_layout(), |i| pressure[i] <= 0.0);
        if bodies.boundary() == Boundary::Periodic && !is_open() {
            finite(
                "stiffness of a contact that is closed everywhere",
                f64::INFINITY,
            )?;
        }
        bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            let [x, y, z] = [Direction::X, Direction::Y, Direction::Z];
            let compliance = bodies.compliance([z, x, y], window.size)?;
            let joint = CoupledBuffers::get_or_create(joint, bodies, compliance)?;
            let loading = self.loads(bodies, window, true, joint, &mut course)?;
            let reversal = if course.has_reversal {
                Some(self.loads(bodies, window, false, joint, &mut course)?)
            } else {
                None
            };
            Ok(whole(bodies.boundary(), &loading, reversal.as_ref()))
        }))
    }

    /// Computes the loads per unit of each motion that the grid allows. The approach is the first motion.
    fn loads(
        &self,
        bodies: &HalfSpace,
        window: Window,
        slips: bool,
        joint: &mut CoupledBuffers,
        course: &mut LinearSolveContext<'_>,
    ) -> Result<[LoadVector; 4]> {
        let (grid, region) = (bodies.grid(), Region::new(bodies, window));
        let layout = region.layout().clone().alike(bodies.team());
        let place = |cell: usize| centre(grid.whole(), region.own().index(cell));
        let CoupledBuffers {
            compliance: Compliance { operator, inverse },
            self_compliance,
            workspace,
            cells,
            right,
            unknowns,
        } = joint;
        let [qx, qy] = self.traction.map(Field::as_slice);
        let limits = self.hardness.map_or(UNLIMITED, Hardness::limits);
        let entered = |i: usize| self.entered.get(i).copied().unwrap_or(0.0);
        let [p, x, y, slip_x, slip_y, own, hardness] = &mut *cells;
        for (cells, field) in [(p, self.pressure.as_slice()), (x, qx), (y, qy)] {
            region.gather(field, cells);
        }
        for (axis, cells) in [slip_x, slip_y].into_iter().enumerate() {
            match self.slip {
                Some(slip) => region.gather(slip[axis], cells),
                None => cells.fill(0.0),
            }
        }
        region.collect(|i| if slips { entered(i) } else { 0.0 }, own);
        if let PerCell::Cells(field) = limits {
            region.gather(field, hardness);
        }
        let [p, qx, qy, sx, sy, own, hardness] = slices(cells);
        let problem = ConeProblem {
            operator: &*operator,
            preconditioner: &*inverse,
            layout: &layout,
            linear: [&[]; N],
            closing: None,
            hardness: limits.map(|_| hardness),
            friction: &self.friction.within(&region),
            totals: [Total::Free; N],
            lower_bounds: [LowerBound::NONE; 2],
            self_compliance: *self_compliance,
            coupling: 0.0,
        };
        let stand = FrozenState {
            x: [p, qx, qy],
            slip: [sx, sy],
            own,
            slips,
        };
        let held = FixedSetSystem {
            operator: &*operator,
            preconditioner: &*inverse,
            layout: &layout,
            own: CellCompliance::default(),
        };
        let linear = workspace.hold(&problem, stand)?;
        let mut loads = [[0.0; 4]; 4];
        let count = if bodies.boundary().may_turn() { 4 } else { 3 };
        for (motion, loads) in loads.iter_mut().enumerate().take(count) {
            linear.restrict(|cell| moved(motion, place(cell)), right)?;
            course.respond(&held, right, unknowns, linear)?;
            course.check_solved()?;
            let found = linear.tractions();
            *loads = reduce::sum(&layout, |cell| {
                let [x, y] = place(cell);
                let [p, qx, qy] = at(&found, cell).map(|q| grid.cell_area() * q);
                [p, qx, qy, x * qy - y * qx]
            });
        }
        Ok(loads)
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
    ///     let (normal, load) = (NormalControl::Approach(approach), TangentialLoad::shift([shift, 0.0]));
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
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch), [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch) or
    ///   [`Error::MaterialMismatch`](crate::Error::MaterialMismatch) if the solution belongs to other bodies or another friction.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if a periodic contact is closed everywhere.
    /// - [`Error::NotConverged`](crate::Error::NotConverged) if a linear solve fails or is cancelled.
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
        bodies.collective_result(checked.and_then(|()| friction.check(bodies.grid())))?;
        let contact = Coupled {
            pressure: normal.pressure(),
            traction: tangential.traction(),
            slip: Some(tangential.slip().map(Field::as_slice)),
            entered: &[],
            friction,
            hardness: None,
            window: None,
        };
        contact.stiffness(bodies, &mut StiffnessWorkspace::new(), &mut observer)
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

impl ContactStiffness {
    /// Returns zero entries for the vector model.
    fn without_contact(boundary: Boundary, course: &mut LinearSolveContext<'_>) -> Self {
        let (tangential, none) = without_contact(None, boundary, course);
        Self {
            normal: NormalStiffness {
                value: 0.0,
                bound: 0.0,
            },
            tangential,
            by_approach: none,
            normal_by_motion: none,
        }
    }
}

/// Returns the stiffness from the loads per unit of each motion.
fn whole(
    boundary: Boundary,
    loading: &[LoadVector; 4],
    reversal: Option<&[LoadVector; 4]>,
) -> ContactStiffness {
    let has = kinds(Axis::BOTH, boundary);
    let matrix = |loads: &[LoadVector; 4]| {
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
