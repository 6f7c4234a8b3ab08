//! The stiffness of a contact that is solved.

use crate::buffer;
use crate::cgm::small::Small;
use crate::error::{Result, positive};
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::influence::Direction;
use crate::normal::NormalSolution;
use crate::stiffness::motions::Motions;
use crate::stiffness::system::{Freedom, Stiffness, System, Vector, times};
use crate::tangential::{Axis, Friction, TangentialSolution, Zone};
use crate::window::Window;

/// The normal stiffness of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct NormalStiffness {
    /// $`dW/d\delta_z`$ (a force over a length), zero without contact. Hertz: $`2 E^* a`$.
    pub value: f64,
    /// Bound of its relative error.
    pub bound: f64,
}

/// The tangential stiffness of a contact: forces along x and y and the moment, by shifts along x and y and the twist.
///
/// Rows are loads, columns motions: forces over lengths in the upper left two by two, moments over radians in the last
/// place, forces (over radians) between.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct TangentialStiffness {
    /// If the motion continues in its direction. Of a ball, by
    /// [Cattaneo and Mindlin](crate::analytical::CattaneoMindlin): $`8 G^* a\,(1 - F/\mu W)^{1/3}`$.
    pub loading: [[f64; 3]; 3],
    /// If the motion reverses: all cells of the contact stick. Of a circle, by
    /// [Mindlin](crate::analytical::MindlinFullStick): $`8 G^* a`$.
    pub reversal: [[f64; 3]; 3],
    /// Bound of the errors: none is larger than this times the root of the product of the two entries on the diagonal,
    /// of the matrix for a twist about the centre of the contact.
    pub bound: f64,
}

/// The stiffness of a contact in all directions.
#[doc(alias = "tangent")]
#[doc(alias = "slope")]
#[doc(alias = "jacobian")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct ContactStiffness {
    /// Normal force by approach.
    pub normal: NormalStiffness,
    /// Tangential forces and moment by shift and twist.
    pub tangential: TangentialStiffness,
    /// Tangential forces (over a length) and moment (a force) by the approach while slip continues, through the friction
    /// limit of the cells that slip: if the shift grows in the same step, or the approach decreases. Pressed further at a
    /// held shift these cells stick, and the slope is zero. Without a bound of its own; the change of pressure behind it
    /// has a relative error, in the energy norm, of the root of the bound of `normal`.
    pub by_approach: [f64; 3],
}

impl TangentialStiffness {
    /// The stiffness behind springs: forces and moment by the motion of the far ends of springs along x and y (a force
    /// over a length each), and by the twist, $`(K^{-1} + k^{-1})^{-1}`$.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for a spring.
    pub fn through_springs(&self, springs: [f64; 2]) -> Result<Self> {
        for stiffness in springs {
            positive("stiffness of the spring", stiffness)?;
        }
        let [x, y] = springs.map(f64::recip);
        // (1 + K / k) dF = K dX.
        let in_series = |matrix: [[f64; 3]; 3]| {
            let mut system = times(&matrix, &[[x, 0.0, 0.0], [0.0, y, 0.0], [0.0; 3]]);
            for (a, row) in system.iter_mut().enumerate() {
                row[a] += 1.0;
            }
            let column = |a: usize| Small(system).solve(matrix.map(|row| row[a]), [true; 3]);
            let columns = [column(0), column(1), column(2)];
            [0, 1, 2].map(|a| columns.map(|column| column[a]))
        };
        Ok(Self {
            loading: in_series(self.loading),
            reversal: in_series(self.reversal),
            bound: self.bound,
        })
    }
}

impl NormalSolution {
    /// The normal stiffness $`dW/d\delta_z`$, by one solve on the cells of the contact.
    ///
    /// The set of cells is held, so that the stiffness jumps where a cell comes into contact; it is that of a contact
    /// whose edge runs along sides of cells. On a periodic grid the approach is that of the mean planes.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch),
    /// [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch) or
    /// [`Error::MaterialMismatch`](crate::Error::MaterialMismatch) for bodies that the solution is
    /// not of; [`Error::NotFinite`](crate::Error::NotFinite) where a periodic contact is closed everywhere and
    /// resists without limit; [`Error::NotConverged`](crate::Error::NotConverged); as [`HalfSpace::operator`];
    /// [`Error::Ranks`](crate::Error::Ranks).
    pub fn stiffness(&self, bodies: &HalfSpace) -> Result<NormalStiffness> {
        bodies.check_alone("a stiffness")?;
        Ok(pressed(bodies, self)?.map_or(
            NormalStiffness {
                value: 0.0,
                bound: 0.0,
            },
            |press| press.stiffness,
        ))
    }
}

impl TangentialSolution {
    /// The tangential stiffness, by a solve for each motion of the model and each of the two sets of cells.
    ///
    /// Loading is the derivative of this solution by its load. In the vector model that includes how the slip of the
    /// step resists turning; on grids that do not repeat the vector model has the twist.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch) or
    /// [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch) for bodies that the solution is not of;
    /// [`Error::NotFinite`](crate::Error::NotFinite) where a periodic contact is closed everywhere;
    /// [`Error::NotConverged`](crate::Error::NotConverged); as [`HalfSpace::operator`];
    /// [`Error::Ranks`](crate::Error::Ranks).
    pub fn stiffness(&self, bodies: &HalfSpace) -> Result<TangentialStiffness> {
        bodies.check_alone("a stiffness")?;
        bodies.check_host("tangential contact", self.grid(), self.boundary())?;
        let sheared = Sheared {
            zones: self.zones(),
            traction: self.traction(),
            slip: self.slip(),
        };
        sheared
            .stiffness(bodies, self.axis(), None)
            .map(|found| found.0)
    }
}

impl ContactStiffness {
    /// Of a contact under a load from rest: pressed, and sheared with this friction.
    ///
    /// # Errors
    /// As [`NormalSolution::stiffness`] and [`TangentialSolution::stiffness`];
    /// [`Error::GridMismatch`](crate::Error::GridMismatch) for the friction.
    pub fn new(
        bodies: &HalfSpace,
        normal: &NormalSolution,
        friction: &Friction,
        shear: &TangentialSolution,
    ) -> Result<Self> {
        bodies.check_host("tangential contact", shear.grid(), shear.boundary())?;
        let sheared = Sheared {
            zones: shear.zones(),
            traction: shear.traction(),
            slip: shear.slip(),
        };
        Self::of(bodies, normal, friction, &sheared, shear.axis())
    }

    pub(crate) fn of(
        bodies: &HalfSpace,
        normal: &NormalSolution,
        friction: &Friction,
        sheared: &Sheared<'_>,
        axis: Option<Axis>,
    ) -> Result<Self> {
        friction.check(bodies.grid())?;
        let press = pressed(bodies, normal)?;
        let mut limits = buffer::zeros(bodies.grid().cells())?;
        if let Some(press) = &press {
            let pressure = normal.pressure().as_slice();
            for (i, growth) in press.window.indices().zip(&press.growth) {
                limits[i] = friction.slope(i, pressure[i]) * growth;
            }
        }
        let (tangential, by_approach) = sheared.stiffness(bodies, axis, Some(&limits))?;
        Ok(Self {
            normal: press.map_or(
                NormalStiffness {
                    value: 0.0,
                    bound: 0.0,
                },
                |press| press.stiffness,
            ),
            tangential,
            by_approach,
        })
    }
}

/// How the pressure answers the approach.
struct Press {
    window: Window,
    stiffness: NormalStiffness,
    /// Growth of the pressure of the cells of the window, for each growth of the approach.
    growth: Vec<f64>,
}

/// `None` without contact.
fn pressed(bodies: &HalfSpace, normal: &NormalSolution) -> Result<Option<Press>> {
    normal.check_bodies(bodies)?;
    normal.check_elastic("the stiffness")?;
    let pressure = normal.pressure().as_slice();
    let Some(window) = Window::around(bodies.grid(), |i| pressure[i] > 0.0) else {
        return Ok(None);
    };
    let window = bodies.confined(window);
    let freedom = |i: usize| {
        if pressure[i] > 0.0 {
            Freedom::Free
        } else {
            Freedom::Fixed
        }
    };
    let compliance = bodies.compliance([Direction::Z], window.size)?;
    let freedoms = buffer::collected(window.cells(), window.indices().map(freedom))?;
    let system = System::new(bodies.boundary(), &compliance, freedoms)?;
    let Stiffness {
        matrix,
        bound,
        tractions,
        ..
    } = system.stiffness(&[[buffer::filled(1.0, window.cells())?]])?;
    let cell_area = bodies.grid().cell_area();
    let per_area = matrix[0][0];
    let value = per_area * cell_area;
    let unit = tractions.into_iter().flatten().flatten();
    Ok(Some(Press {
        window,
        stiffness: NormalStiffness { value, bound },
        growth: buffer::collected(window.cells(), unit.map(|traction| traction * per_area))?,
    }))
}

/// What is known of a sheared contact.
pub(crate) struct Sheared<'a> {
    pub(crate) zones: &'a [Zone],
    pub(crate) traction: [&'a Field; 2],
    /// Slip of the step.
    pub(crate) slip: [&'a Field; 2],
}

impl Sheared<'_> {
    /// The stiffness; and the loads by the approach, if the growth of the limits with it is given.
    fn stiffness(
        &self,
        bodies: &HalfSpace,
        axis: Option<Axis>,
        limits: Option<&[f64]>,
    ) -> Result<(TangentialStiffness, [f64; 3])> {
        let grid = bodies.grid();
        let Some(window) = Window::around(grid, |i| self.zones[i] != Zone::Separated) else {
            return Ok((
                TangentialStiffness {
                    loading: [[0.0; 3]; 3],
                    reversal: [[0.0; 3]; 3],
                    bound: 0.0,
                },
                [0.0; 3],
            ));
        };
        let window = bodies.confined(window);
        match axis {
            Some(axis) => self.along(bodies, window, [axis], limits),
            None => self.along(bodies, window, [Axis::X, Axis::Y], limits),
        }
    }

    fn along<const N: usize>(
        &self,
        bodies: &HalfSpace,
        window: Window,
        axes: [Axis; N],
        limits: Option<&[f64]>,
    ) -> Result<(TangentialStiffness, [f64; 3])> {
        let grid = bodies.grid();
        let compliance = bodies.compliance(axes.map(Axis::direction), window.size)?;
        let sticking = |i: usize| match self.zones[i] {
            Zone::Separated => Freedom::Fixed,
            // What carries nothing at its limit never sticks.
            Zone::Slip if self.traction.iter().all(|q| q.as_slice()[i] == 0.0) => Freedom::Fixed,
            Zone::Stick | Zone::Slip => Freedom::Free,
        };
        let slipping = |i: usize| match self.zones[i] {
            Zone::Slip => self.turning(axes, i),
            _ => sticking(i),
        };
        let touches = |i: usize| self.zones[i] != Zone::Separated;
        let motions = Motions::new(grid, window, axes, bodies.boundary(), touches)?;
        let area = grid.cell_area();
        let boundary = bodies.boundary();
        let freedoms = buffer::collected(window.cells(), window.indices().map(sticking))?;
        let reversal = System::new(boundary, &compliance, freedoms)?;
        let reversal = reversal.stiffness(&motions.cells)?;
        let freedoms = buffer::collected(window.cells(), window.indices().map(slipping))?;
        let loading = System::new(boundary, &compliance, freedoms)?;
        let found = loading.stiffness(&motions.cells)?;
        let mut by_approach = [0.0; 3];
        if let Some(limits) = limits {
            let forced = self.forced(axes, window, limits)?;
            let displacement = loading.displacement(&forced)?;
            let own = motions
                .cells
                .iter()
                .map(|motion| loading.product(motion, &forced));
            let mut loads = loading.reaction(&found, &displacement);
            for (load, own) in loads.iter_mut().zip(own) {
                *load += own;
            }
            by_approach = motions.loads(loads).map(|load| load * area);
        }
        let whole = |stiffness: &Stiffness<N>| {
            motions
                .matrix(&stiffness.matrix)
                .map(|row| row.map(|entry| entry * area))
        };
        let stiffness = TangentialStiffness {
            loading: whole(&found),
            reversal: whole(&reversal),
            bound: found.bound.max(reversal.bound),
        };
        Ok((stiffness, by_approach))
    }

    fn at<const N: usize>(vector: [&Field; 2], axes: [Axis; N], index: usize) -> [f64; N] {
        axes.map(|axis| vector[axis.index()].as_slice()[index])
    }

    /// What a cell that slips may do: nothing along one axis, turn in the plane.
    fn turning<const N: usize>(&self, axes: [Axis; N], index: usize) -> Freedom<N> {
        let [q, slip] = [self.traction, self.slip].map(|vector| Self::at(vector, axes, index));
        let length = |v: [f64; N]| v.iter().fold(0.0_f64, |sum, v| sum.hypot(*v));
        let limit = length(q);
        if N == 1 || limit <= 0.0 {
            return Freedom::Fixed;
        }
        let mut tangent = [0.0; N];
        (tangent[0], tangent[N - 1]) = (-q[N - 1] / limit, q[0] / limit);
        Freedom::Along {
            tangent,
            stiffness: length(slip) / limit,
        }
    }

    /// The tractions of cells that slip, when their limits grow so.
    fn forced<const N: usize>(
        &self,
        axes: [Axis; N],
        window: Window,
        limits: &[f64],
    ) -> Result<Vector<N>> {
        let mut forced: Vector<N> = buffer::vector(window.cells())?;
        for (k, i) in window.indices().enumerate() {
            let q = Self::at(self.traction, axes, i);
            let limit = q.iter().fold(0.0_f64, |sum, q| sum.hypot(*q));
            if self.zones[i] == Zone::Slip && limit > 0.0 {
                for (part, q) in forced.iter_mut().zip(q) {
                    part[k] = limits[i] * q / limit;
                }
            }
        }
        Ok(forced)
    }
}
