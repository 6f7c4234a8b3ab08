//! Two elastic half-spaces meshed by one grid: the operators every problem on it shares.

use std::sync::{Arc, OnceLock};

use crate::error::Result;
use crate::fft::{CirculantInverse, Convolution};
use crate::grid::Grid;
use crate::influence::{Component, Samples, Table};
use crate::material::ElasticPair;
use crate::operator::Operator;
use crate::parallel::get_or_make;
use crate::window::halved;

/// A pair of half-spaces on a grid, with the operators of the components in use.
///
/// A component is sampled and transformed when a problem first asks for it, once; clones share it. The
/// samples behind `XX`, `YY` and `ZZ` take 16 bytes per cell together, and serve the coarser grids of
/// nested starts too; each operator takes 12 and its preconditioner one, the coarser ones a third more.
/// `Send + Sync`: many solvers may run over one `HalfSpace` on many threads.
///
/// ```
/// use stickslip::{ElasticPair, Grid, HalfSpace, Material};
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(Grid::square(64, 0.4e-3)?, ElasticPair::new(steel, steel)?)?;
/// assert_eq!(bodies.grid().cells(), 4096);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct HalfSpace {
    shared: Arc<Shared>,
}

#[derive(Debug)]
struct Shared {
    grid: Grid,
    pair: ElasticPair,
    /// What the coefficients of this grid and of all coarser ones are made of.
    samples: Arc<Samples>,
    kernels: [OnceLock<Kernel>; Component::ALL.len()],
    /// The same bodies on cells twice as large.
    coarser: OnceLock<HalfSpace>,
}

/// One component: its samples, and what was made of them for the whole grid.
#[derive(Debug)]
struct Kernel {
    table: Table,
    operator: OnceLock<Arc<Convolution>>,
    inverse: OnceLock<Arc<CirculantInverse>>,
}

/// An operator and the preconditioner that goes with it.
#[derive(Debug, Clone)]
pub(crate) struct Compliance {
    pub(crate) operator: Arc<Convolution>,
    pub(crate) inverse: Arc<CirculantInverse>,
}

const _: () = {
    const fn assert_send_sync<T: Send + Sync>() {}
    assert_send_sync::<HalfSpace>();
};

impl HalfSpace {
    /// The pair meshed by `grid`; nothing is computed yet.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) if the sides of a cell are too far apart
    /// to compare.
    pub fn new(grid: Grid, pair: ElasticPair) -> Result<Self> {
        let samples = Convolution::samples(grid)?;
        Ok(Self::with_samples(grid, pair, Arc::new(samples)))
    }

    fn with_samples(grid: Grid, pair: ElasticPair, samples: Arc<Samples>) -> Self {
        Self {
            shared: Arc::new(Shared {
                grid,
                pair,
                samples,
                kernels: Default::default(),
                coarser: OnceLock::new(),
            }),
        }
    }

    /// The grid.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.shared.grid
    }

    /// The two bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.shared.pair
    }

    /// The operator of one component on the whole grid, made at the first call.
    ///
    /// # Errors
    /// As [`Table::sample`].
    pub fn operator(&self, component: Component) -> Result<Arc<Convolution>> {
        let kernel = self.kernel(component)?;
        let make = || Ok(Arc::new(Convolution::of_table(self.size(), &kernel.table)));
        get_or_make(&kernel.operator, make).cloned()
    }

    /// The circulant preconditioner of one component on the whole grid; `None` for the components
    /// that are not a compliance of their own (all but `XX`, `YY` and `ZZ`).
    ///
    /// # Errors
    /// As [`Table::sample`].
    pub fn preconditioner(&self, component: Component) -> Result<Option<Arc<CirculantInverse>>> {
        Ok(match component {
            Component::XX | Component::YY | Component::ZZ => {
                Some(self.compliance(component)?.inverse)
            }
            _ => None,
        })
    }

    /// Operator and preconditioner of a diagonal component on the whole grid.
    pub(crate) fn compliance(&self, component: Component) -> Result<Compliance> {
        let operator = self.operator(component)?;
        let kernel = self.kernel(component)?;
        let floor = operator.lower_bound();
        let make = || {
            Ok(Arc::new(CirculantInverse::of_table(
                self.size(),
                &kernel.table,
                floor,
            )))
        };
        let inverse = get_or_make(&kernel.inverse, make).cloned()?;
        Ok(Compliance { operator, inverse })
    }

    /// The same on a rectangle of `[nx, ny]` cells cut out of the grid, wherever it lies.
    pub(crate) fn compliance_of_window(
        &self,
        component: Component,
        size: [usize; 2],
    ) -> Result<Compliance> {
        if size == self.size() {
            return self.compliance(component);
        }
        let table = &self.kernel(component)?.table;
        let operator = Convolution::of_table(size, table);
        let inverse = CirculantInverse::of_table(size, table, operator.lower_bound());
        Ok(Compliance {
            operator: Arc::new(operator),
            inverse: Arc::new(inverse),
        })
    }

    /// The same bodies on cells of twice the sides, the grid as large or a fine cell larger.
    pub(crate) fn coarser(&self) -> Result<&Self> {
        let Shared {
            grid,
            pair,
            samples,
            coarser,
            ..
        } = &*self.shared;
        get_or_make(coarser, || {
            let [nx, ny] = halved(self.size());
            let grid = Grid::new(nx, ny, 2.0 * grid.dx(), 2.0 * grid.dy())?;
            Ok(Self::with_samples(grid, *pair, Arc::clone(samples)))
        })
    }

    fn size(&self) -> [usize; 2] {
        [self.shared.grid.nx(), self.shared.grid.ny()]
    }

    fn kernel(&self, component: Component) -> Result<&Kernel> {
        let Shared {
            grid,
            pair,
            samples,
            kernels,
            ..
        } = &*self.shared;
        get_or_make(&kernels[component as usize], || {
            Ok(Kernel {
                table: samples.table(*grid, pair, component)?,
                operator: OnceLock::new(),
                inverse: OnceLock::new(),
            })
        })
    }
}
