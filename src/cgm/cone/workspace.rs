//! What a solve of cones writes to.

use crate::buffer;
use crate::cgm::cone::N;
use crate::cgm::cone::krylov::RESTART;
use crate::cgm::cone::law::Law;
use crate::cgm::moving::MovingCells;
use crate::error::Result;
use crate::operator::Operator;
use crate::report::Report;

/// Everything a solve writes to besides its tractions; made once, reused by every solve of one size.
#[derive(Debug, Clone)]
pub(crate) struct ConeWorkspace<C: Operator<N>, P: Operator<N>> {
    pub(super) operator: C::Workspace,
    pub(super) preconditioner: P::Workspace,
    pub(super) product: [Vec<f64>; N],
    pub(super) direction: [Vec<f64>; N],
    pub(super) image: [Vec<f64>; N],
    /// The friction limit of every cell.
    pub(super) limits: Vec<f64>,
    pub(super) laws: Vec<Law>,
    /// $`\kappa g/p`$ of every cell; empty where none enters.
    pub(super) own: Vec<f64>,
    /// Traction over pressure of these cells, where the lag was last found.
    pub(super) ratio: Vec<[f64; 2]>,
    /// The cells in contact; the vectors below hold these alone.
    pub(super) contact: MovingCells,
    pub(super) residual: Vec<[f64; N]>,
    pub(super) correction: Vec<[f64; N]>,
    /// How a change of each multiplier spreads over the unknowns.
    pub(super) spread: Vec<[[f64; N]; N]>,
    pub(super) basis: [Vec<[f64; N]>; RESTART + 1],
    pub(super) multiplier: [f64; N],
    pub(super) report: Report,
}

impl<C: Operator<N>, P: Operator<N>> ConeWorkspace<C, P> {
    /// Buffers for an operator and its preconditioner.
    pub(crate) fn new(operator: &C, preconditioner: &P) -> Result<Self> {
        let cells = operator.cells();
        Ok(Self {
            operator: operator.try_workspace()?,
            preconditioner: preconditioner.try_workspace()?,
            product: buffer::vector(cells)?,
            direction: buffer::vector(cells)?,
            image: buffer::vector(cells)?,
            limits: buffer::zeros(cells)?,
            laws: buffer::filled(Law::OPEN, cells)?,
            own: Vec::new(),
            ratio: Vec::new(),
            contact: MovingCells::new(operator.layout())?,
            residual: Vec::new(),
            correction: Vec::new(),
            spread: Vec::new(),
            basis: std::array::from_fn(|_| Vec::new()),
            multiplier: [0.0; N],
            report: Report::with_room(),
        })
    }

    /// Makes room for the cells in contact; vectors of the basis follow as they are needed.
    pub(super) fn make_room(&mut self) -> Result<()> {
        let cells = self.contact.len();
        buffer::resize(&mut self.residual, cells, [0.0; N])?;
        buffer::resize(&mut self.correction, cells, [0.0; N])?;
        buffer::resize(&mut self.spread, cells, [[0.0; N]; N])
    }

    /// Writes `C x` to `out`; the answer stays.
    pub(crate) fn apply(&mut self, operator: &C, x: [&[f64]; N], out: [&mut [f64]; N]) {
        operator.apply(x, out, &mut self.operator);
    }

    /// The product `C x` of the tractions last returned.
    pub(crate) fn product(&self) -> [&[f64]; N] {
        self.product.each_ref().map(Vec::as_slice)
    }

    pub(crate) fn multiplier(&self) -> [f64; N] {
        self.multiplier
    }

    pub(crate) fn set_multiplier(&mut self, multiplier: [f64; N]) {
        self.multiplier = multiplier;
    }

    pub(crate) fn report(&self) -> &Report {
        &self.report
    }
}

/// Gap and slip of the cells.
pub(super) fn gradient<'a>(
    product: &'a [Vec<f64>; N],
    linear: [&'a [f64]; N],
    multiplier: [f64; N],
) -> impl Fn(usize) -> [f64; N] + Sync + 'a {
    move |i| std::array::from_fn(|c| product[c][i] + linear[c][i] - multiplier[c])
}
