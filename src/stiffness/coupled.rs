//! The stiffness of a contact whose pressure and shear are found together.

use std::sync::Arc;

use crate::boundary::Boundary;
use crate::buffer::{self, try_each};
use crate::cgm::cone::{ConeProblem, ConeWorkspace, Stand, responses};
use crate::cgm::{Settings, Total};
use crate::error::{Error, Result, finite};
use crate::field::Field;
use crate::half_space::{Compliance, HalfSpace, Region};
use crate::influence::Direction;
use crate::operator::Operator;
use crate::parallel;
use crate::stiffness::contact::without_contact;
use crate::stiffness::motions::kinds;
use crate::stiffness::{ContactStiffness, NormalStiffness, TangentialStiffness};
use crate::tangential::{Axis, Friction, centre};
use crate::watch::Observer;
use crate::window::Window;

/// Components of a vector: along z, x and y.
const N: usize = 3;

/// A bound that is not known.
const UNKNOWN: f64 = f64::INFINITY;

/// What is known of a contact under pressure and shear.
pub(crate) struct Coupled<'a> {
    pub(crate) pressure: &'a Field,
    pub(crate) traction: [&'a Field; 2],
    /// Slip of the step.
    pub(crate) slip: [&'a Field; 2],
    /// Compliance of their own of the cells that entered the contact in the step; of no cells where none did.
    pub(crate) entered: &'a [f64],
    pub(crate) friction: &'a Friction,
    pub(crate) settings: &'a Settings,
}

/// Normal force, tangential forces and moment by a motion.
type Loads = [f64; 4];

impl Coupled<'_> {
    /// By the approach, the shifts along x and y and the twist, while slip continues, and by the last three while all
    /// sticks.
    pub(crate) fn stiffness(
        &self,
        bodies: &HalfSpace,
        observer: Observer<'_>,
    ) -> Result<ContactStiffness> {
        bodies.check_alone("a stiffness")?;
        let grid = bodies.grid();
        let pressure = self.pressure.as_slice();
        let Some(window) = Window::around(grid, |i| pressure[i] > 0.0) else {
            return Ok(ContactStiffness::without_contact(bodies.boundary()));
        };
        let window = bodies.confined(window);
        let closed = window.indices().all(|i| pressure[i] > 0.0);
        if closed && bodies.boundary() == Boundary::Periodic {
            finite(
                "stiffness of a contact that is closed everywhere",
                f64::INFINITY,
            )?;
        }
        parallel::enter_with(grid.cells(), || {
            let loading = self.loads(bodies, window, true, &mut *observer)?;
            let reversal = self.loads(bodies, window, false, observer)?;
            Ok(whole(bodies.boundary(), &loading, &reversal))
        })
    }

    /// The loads by a unit of each motion that the grid allows, the approach first.
    fn loads(
        &self,
        bodies: &HalfSpace,
        window: Window,
        slips: bool,
        observer: Observer<'_>,
    ) -> Result<[Loads; 4]> {
        let (size, region) = (window.size, Region::new(bodies, window));
        let [x, y, z] = [Direction::X, Direction::Y, Direction::Z];
        let Compliance { operator, inverse } = bodies.compliance([z, x, y], size)?;
        let normal = bodies.compliance([z], size)?.operator;
        let plane = bodies.compliance([x, y], size)?.operator;
        let friction = &self.friction.within(&region);
        let problem = ConeProblem {
            operator: Arc::clone(&operator),
            preconditioner: Arc::clone(&inverse),
            layout: region.layout(),
            linear: [&[]; N],
            closing: None,
            friction,
            totals: [Total::Free; N],
            lower_bounds: [normal.lower_bound(), plane.lower_bound()],
            coupling: 0.0,
        };
        let gathered = |field: &[f64]| {
            let mut part = buffer::zeros(window.cells())?;
            region.gather(field, &mut part);
            Ok::<Vec<f64>, Error>(part)
        };
        let pressure = gathered(self.pressure.as_slice())?;
        let [qx, qy, sx, sy] = try_each(|c| {
            let [q, s] = [self.traction, self.slip];
            gathered([q[0], q[1], s[0], s[1]][c].as_slice())
        })?;
        let has_entered = slips && !self.entered.is_empty();
        let entered = has_entered.then(|| gathered(self.entered)).transpose()?;
        let stand = Stand {
            x: [&pressure, &qx, &qy],
            slip: [&sx, &sy],
            own: entered.as_deref().unwrap_or(&[]),
            slips,
        };
        let (grid, motions) = (bodies.grid(), motions(bodies, window)?);
        let mut workspace = ConeWorkspace::new(&operator, &inverse)?;
        let settings = self.settings;
        let found = responses(
            &problem,
            settings,
            stand,
            &motions,
            &mut workspace,
            observer,
        )?;
        let mut loads = [[0.0; 4]; 4];
        for (loads, found) in loads.iter_mut().zip(&found) {
            for (k, i) in window.indices().enumerate() {
                let [x, y] = centre(grid, i);
                let [p, qx, qy] = [0, 1, 2].map(|c| grid.cell_area() * found[c][k]);
                let parts = [p, qx, qy, x * qy - y * qx];
                *loads = [0, 1, 2, 3].map(|load| loads[load] + parts[load]);
            }
        }
        Ok(loads)
    }
}

/// Approach, shifts along x and y and, where the grid can turn, twist about its origin, as motions of the cells.
fn motions(bodies: &HalfSpace, window: Window) -> Result<Vec<[Vec<f64>; N]>> {
    let all: [fn([f64; 2]) -> [f64; N]; 4] = [
        |_| [1.0, 0.0, 0.0],
        |_| [0.0, 1.0, 0.0],
        |_| [0.0, 0.0, 1.0],
        |[x, y]| [0.0, -y, x],
    ];
    let kinds = if bodies.boundary().may_turn() { 4 } else { 3 };
    let of_cells = |moved: &fn([f64; 2]) -> [f64; N]| {
        let mut cells: [Vec<f64>; N] = buffer::vector(window.cells())?;
        for (k, i) in window.indices().enumerate() {
            for (part, value) in cells.iter_mut().zip(moved(centre(bodies.grid(), i))) {
                part[k] = value;
            }
        }
        Ok(cells)
    };
    all[..kinds].iter().map(of_cells).collect()
}

impl ContactStiffness {
    /// Zero of what the model in the plane has.
    fn without_contact(boundary: Boundary) -> Self {
        let (tangential, none) = without_contact(None, boundary);
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

/// The stiffness by the loads of each motion.
fn whole(boundary: Boundary, loading: &[Loads; 4], reversal: &[Loads; 4]) -> ContactStiffness {
    let has = kinds(Axis::BOTH, boundary);
    let of = |kind: usize, value: f64| has.contains(&kind).then_some(value);
    let matrix = |loads: &[Loads; 4]| {
        [0, 1, 2].map(|load| {
            [0, 1, 2].map(|motion| {
                of(load, loads[1 + motion][1 + load]).and_then(|value| of(motion, value))
            })
        })
    };
    ContactStiffness {
        normal: NormalStiffness {
            value: loading[0][0],
            bound: UNKNOWN,
        },
        tangential: TangentialStiffness {
            loading: matrix(loading),
            reversal: matrix(reversal),
            bound: UNKNOWN,
        },
        by_approach: [0, 1, 2].map(|load| of(load, loading[0][1 + load])),
        normal_by_motion: [0, 1, 2].map(|motion| of(motion, loading[1 + motion][0])),
    }
}
