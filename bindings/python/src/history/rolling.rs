//! Rolling during a step.

use pyo3::prelude::*;
use stickslip::Axis;
use stickslip::history::{LeadingEdge, Rolling as Rolled};

use crate::argument::by_value;
use crate::choice::Choice;
use crate::conversion;
use crate::digits::{short, tuple};
use crate::load::one_along;
use crate::pickle::{parts, picklable};
use crate::real::{Count, Real};

/// Rolling of the bodies in a step of a history: the number of cells, the edge where particles enter the contact, and the
/// creepage of body 2 over body 1. Without creepage and spin, the bodies roll freely.
///
/// Parameters
/// ----------
/// cells : int
///     Number of cells by which the particles of both surfaces move through the contact, one or more; a step with zero cells raises
///     :class:`~stickslip.errors.NotPositive`. The grid must
///     extend by this number of cells ahead of and behind the contact; otherwise the step raises
///     :class:`~stickslip.errors.GridTooShort`. The entry rule needs the slope of the gap two cells further ahead. If
///     the grid ends before, this slope is one-sided.
/// creepage : pair of float, optional
///     The creepages along x and y, the motion of body 2 over body 1 per unit length rolled (dimensionless, default
///     zero). A positive creepage causes a positive force. Kalker and CONTACT define creepage and spin as motions
///     of body 1 over body 2, with the opposite sign. Along an axis with a prescribed force, the creepage follows
///     from the force and must not be given here.
/// creepage_x, creepage_y : float, optional
///     Creepage along one axis.
/// spin : float, default 0
///     Rotation of body 2 relative to body 1 about the origin of the grid per unit length rolled (one over a length,
///     positive from x to y). It requires the vector model.
/// leading_edge : LeadingEdge or str, default "plus_x"
///     The edge where particles enter the contact.
///
/// Examples
/// --------
/// >>> import stickslip as ss
/// >>> body = ss.Material.from_shear_modulus(1.0, 0.25)
/// >>> bodies = ss.HalfSpace(ss.Grid.square(24, 3.0), (body, body))
/// >>> history = ss.History(bodies, ss.surface.sphere(bodies.grid, 1.0), 0.3, model="vector")
/// >>> step = history.step(normal_force=1.0)
/// >>> rolling = ss.history.Rolling(1, creepage_x=0.05)
/// >>> forces = [history.step(roll=rolling).tangential_force[0] for _ in range(5)]
/// >>> forces == sorted(forces), history.last_step.creepage  # the force grows towards that of steady rolling
/// (True, (0.05, 0.0))
#[pyclass(frozen, eq, module = "stickslip.history")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Rolling(pub(crate) Rolled);

by_value!(Rolling);

#[pymethods]
impl Rolling {
    #[new]
    #[pyo3(signature = (cells, *, creepage=None, creepage_x=None, creepage_y=None, spin=None, leading_edge=None))]
    fn new(
        cells: Count,
        creepage: Option<conversion::Creepages>,
        creepage_x: Option<Real>,
        creepage_y: Option<Real>,
        spin: Option<Real>,
        leading_edge: Option<Choice<LeadingEdge>>,
    ) -> PyResult<Self> {
        let along = |axis: Axis, alone: Option<Real>| {
            let both = creepage.as_ref().map(|both| both.0[axis.index()]);
            let given = [both, alone.map(f64::from)];
            let kinds = ["creepage and creepage_x", "creepage and creepage_y"][axis.index()];
            one_along(axis.index(), given, kinds).map(Option::unwrap_or_default)
        };
        let creepage = [along(Axis::X, creepage_x)?, along(Axis::Y, creepage_y)?];
        let mut rolling = Rolled::new(cells.0).creepage(creepage);
        if let Some(Real(spin)) = spin {
            rolling = rolling.spin(spin);
        }
        if let Some(edge) = leading_edge {
            rolling = rolling.leading_edge(edge.0);
        }
        Ok(Self(rolling))
    }

    fn __repr__(&self) -> PyResult<String> {
        as_keywords(&self.0)
    }
}

/// Returns the constructor call as text.
pub(crate) fn as_keywords(rolling: &Rolled) -> PyResult<String> {
    #[derive(serde::Deserialize)]
    struct Parts {
        leading_edge: LeadingEdge,
        cells: usize,
        creepage: [f64; 2],
        spin: f64,
    }
    let Parts {
        leading_edge,
        cells,
        creepage,
        spin,
    } = parts(rolling)?;
    Ok(format!(
        "Rolling({cells}, creepage={}, spin={}, leading_edge='{}')",
        tuple(&creepage),
        short(spin),
        Choice(leading_edge).name()
    ))
}

picklable!(Rolling: Rolled);
