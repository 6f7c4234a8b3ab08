//! Operators of bodies with their preconditioners, created once and shared.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::bodies::component::{Component, Direction};
use crate::cgm::{SparseFactors, SparseInverse};
use crate::error::{Error, Result};
use crate::fft::{CirculantInverse, Convolution, UniformWave};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::half_space::{ElasticOperator, ElasticPreconditioner, HalfSpace};
use crate::influence::{InfluenceKernel, Samples, least_of_lattice};
use crate::memory::fallible;
use crate::memory::pool::Pool;
use crate::operator::Operator;
use crate::parallel;
use crate::parallel::ranks::partition::RowPartition;
use crate::report::EigenvalueBound;

/// Operator with its preconditioner.
#[derive(Debug, Clone)]
pub(crate) struct Compliance<const N: usize> {
    pub(crate) operator: ElasticOperator<N>,
    pub(crate) inverse: ElasticPreconditioner<N>,
}

/// Preconditioner for displacements up to a uniform displacement.
struct UpToMean<const N: usize>(ElasticPreconditioner<N>);

/// Conservative estimate of the smallest eigenvalue on all rectangles of the cells.
struct LatticeEigenvalueBound(f64);

impl HalfSpace {
    /// Returns the operator and the preconditioner for distinct directions on a rectangle of `[nx, ny]` cells of the
    /// grid. Both are valid for any position of the rectangle. Along a periodic axis the rectangle contains all cells.
    pub(crate) fn compliance<const N: usize>(
        &self,
        directions: [Direction; N],
        size: [usize; 2],
    ) -> Result<Compliance<N>> {
        let components = tensor(directions);
        let operator = self.operator_of(components, size)?;
        self.joint(Ok(()))?;
        // Without a bound no error could be certified. A single periodic cell has no wave that needs a bound.
        let grid = self.grid();
        let (least, _) = operator.bound_without_mean();
        let is_unbounded = N < 3 && least <= 0.0 && grid.whole().cells() > 1;
        if let Some(eigenvalue) = operator.least_eigenvalue().filter(|_| is_unbounded) {
            let sides = [grid.dx(), grid.dy()];
            return Err(if !self.pair().is_homogeneous() && eigenvalue <= 0.0 {
                Error::NotDefinite { eigenvalue, sides }
            } else {
                Error::CellsTooLong { sides }
            });
        }
        let inverse = self.made(components, size, |size, share, kernels| {
            CirculantInverse::new(size, share, kernels, least)
        })?;
        Ok(Compliance {
            operator,
            inverse: ElasticPreconditioner(inverse),
        })
    }

    /// Returns the preconditioner of a [compliance](Self::compliance) for displacements up to a uniform displacement.
    /// If the grid is periodic along y, this preconditioner does not depend on the datum. For user-defined operators it
    /// is the preconditioner of the compliance.
    pub(crate) fn inverse_up_to_mean<const N: usize>(
        &self,
        Compliance { operator, inverse }: Compliance<N>,
        directions: [Direction; N],
        size: [usize; 2],
    ) -> Result<ElasticPreconditioner<N>> {
        if self.kernel().user_operators().is_some() {
            return Ok(inverse);
        }
        let (least, _) = operator.bound_without_mean();
        let made = self.made(tensor(directions), size, |size, _, kernels| {
            let inverse = CirculantInverse::up_to_mean(size, kernels, least)?;
            Ok(UpToMean(ElasticPreconditioner(Arc::new(inverse))))
        })?;
        Ok(made.0.clone())
    }

    /// Returns the sparse inverse for scattered contacts on a rectangle of `[nx, ny]` cells. Returns `None` for periodic
    /// grids and user-defined operators. The factors are created once for all rectangles of the grid.
    pub(crate) fn sparse_inverse<const N: usize>(
        &self,
        directions: [Direction; N],
        size: [usize; 2],
    ) -> Result<Option<SparseInverse<N>>> {
        let has_table = self.boundary() == Boundary::NonPeriodic;
        if !has_table || self.kernel().user_operators().is_some() {
            return Ok(None);
        }
        let (grid, added) = (self.grid().whole(), self.shared.kernels.added());
        let diagonal = directions.map(|direction| Component::of(direction, direction));
        let made = &self.shared.made;
        let factors = made.get_or_make(&diagonal, self.size(), true, || {
            let samples = Samples::new(grid, SparseFactors::<N>::DISTANCES)?
                .of(self.cell_value())
                .coated(added.cloned());
            let tables: [_; N] =
                fallible::try_each(|n| samples.table(grid, self.pair(), diagonal[n]))?;
            Ok(SparseFactors::<N>::new(|n, column, row| {
                tables[n].at(column, row)
            }))
        });
        Ok(Some(SparseInverse {
            factors: self.joint(factors)?,
            columns: size[0],
        }))
    }

    /// Checks that problems with tractions along these directions can be solved. User-defined operators must have all
    /// directions, and must state a bound if `needs_bound` is set.
    pub(crate) fn check_directions<const N: usize>(
        &self,
        directions: [Direction; N],
        needs_bound: bool,
    ) -> Result<()> {
        self.check_components(tensor(directions), needs_bound)
    }

    /// Checks components like [`Self::check_directions`].
    pub(crate) fn check_components<const N: usize>(
        &self,
        components: [[Component; N]; N],
        needs_bound: bool,
    ) -> Result<()> {
        let Some(operators) = self.kernel().user_operators() else {
            return Ok(());
        };
        let operator = ElasticOperator::from(operators.part(components, self.size())?);
        if needs_bound {
            operator.check_bounded()?;
        }
        Ok(())
    }

    /// Returns the pool of buffers of a type for these cells and components. The pool exists as long as it has an
    /// owner. A pool that does not depend on components is stored under an empty list of components.
    pub(crate) fn pool<T: Send + 'static>(
        &self,
        components: &[Component],
        size: [usize; 2],
    ) -> Result<Arc<Pool<T>>> {
        let empty = || Ok(Pool::new(Vec::new()));
        let made = &self.shared.made;
        made.get_or_make(components, self.cut(size), false, empty)
    }

    /// Returns the pool of buffers of products. Convolutions share buffers for all directions. User-defined operators
    /// have separate buffers.
    pub(crate) fn pool_of_products<T: Send + 'static, const N: usize>(
        &self,
        directions: [Direction; N],
        size: [usize; 2],
    ) -> Result<Arc<Pool<T>>> {
        match self.kernel().user_operators() {
            Some(_) => self.pool(tensor(directions).as_flattened(), size),
            None => self.pool(&[], size),
        }
    }

    /// Returns the size of the rectangle on which the operator of a window works. Along axes that are not cut, it is
    /// the size of the grid.
    fn cut(&self, size: [usize; 2]) -> [usize; 2] {
        let (whole, spanned) = (self.size(), self.spanned());
        std::array::from_fn(|axis| {
            if spanned[axis] {
                whole[axis]
            } else {
                size[axis]
            }
        })
    }

    /// Returns the operator without its preconditioner, for any components.
    pub(crate) fn operator_of<const N: usize>(
        &self,
        components: [[Component; N]; N],
        size: [usize; 2],
    ) -> Result<ElasticOperator<N>> {
        if let Some(operators) = self.kernel().user_operators() {
            return Ok(operators.part(components, self.size())?.into());
        }
        let made = self.made(components, size, |size, share, kernels| {
            let mut convolution = Convolution::of_kernels(size, share, kernels)?;
            let is_compliance = (0..N).all(|i| components[i][i].is_odd() == [false; 2]);
            if N == 3 || !is_compliance || convolution.lower_bound() > 0.0 {
                return Ok(convolution);
            }
            // The periodic continuation of a stiff layer on a soft body may have eigenvalues that the grid does not
            // have.
            let (boundary, has_response) = (self.boundary(), self.kernel().has_response());
            if boundary == Boundary::NonPeriodic && has_response {
                let least = self.least_of_lattice(components)?;
                convolution = convolution.bounded(least.0, EigenvalueBound::Estimated);
            }
            // The matrix of a window is a principal submatrix of the matrix of the grid.
            if convolution.lower_bound() <= 0.0 && size != self.size() {
                let whole = self.operator_of(components, self.size())?;
                return Ok(match whole.as_convolution() {
                    Some(whole) => convolution.bounded_as(whole),
                    None => convolution,
                });
            }
            match boundary {
                Boundary::PeriodicAlongY { datum } if has_response => {
                    self.bounded_along_y(convolution, components, datum)
                }
                _ => Ok(convolution),
            }
        });
        made.map(ElasticOperator::from)
    }

    /// Returns the operator of the whole grid, which is periodic along y. The operator has separate bounds for
    /// tractions with zero mean and for uniform tractions.
    fn bounded_along_y<const N: usize>(
        &self,
        mut convolution: Convolution<N>,
        components: [[Component; N]; N],
        datum: f64,
    ) -> Result<Convolution<N>> {
        if convolution.lower_bound_without_mean() <= 0.0 {
            let least = self.least_of_lattice(components)?;
            convolution = convolution.bounded(least.0, EigenvalueBound::Estimated);
        }
        let least = convolution.lower_bound_without_mean();
        if least <= 0.0 {
            return Ok(convolution);
        }
        // Tractions that are uniform along y correspond to a line of cells. They couple neither with other tractions
        // nor between directions.
        let grid = self.grid().whole();
        let line = Grid::new(grid.nx(), 1, grid.dx(), grid.ny() as f64 * grid.dy())?;
        let line = Self::with_boundary(line, self.kernel(), self.boundary())?;
        let line = line.with_cell_value(self.cell_value())?;
        let long_waves = self.kernel().long_times_k();
        let waves = fallible::try_each(|n| {
            let component = components[n][n];
            let kernels = line.shared.kernels.of([[component]])?;
            let operator = Convolution::of_kernels(line.size(), None, kernels)?;
            let strength = component.of_response(long_waves, [1.0, 0.0]);
            // A line load moves the surface by its strength times the logarithm of the distance, divided by pi.
            let slope = strength * grid.nx() as f64 * grid.dx() / PI;
            UniformWave::new(&operator, least, [datum, slope])
        })?;
        Ok(convolution.with_uniform_waves(waves))
    }

    /// Returns the estimate on the infinite lattice, which all windows of the grid share.
    fn least_of_lattice<const N: usize>(
        &self,
        components: [[Component; N]; N],
    ) -> Result<Arc<LatticeEigenvalueBound>> {
        let made = &self.shared.made;
        made.get_or_make(components.as_flattened(), self.size(), true, || {
            let (grid, kernel) = (self.grid().whole(), self.kernel());
            let repeats = self.boundary().repeats()[1];
            let least = least_of_lattice((grid, repeats), kernel, self.cell_value(), components);
            Ok(LatticeEigenvalueBound(least))
        })
    }

    /// Returns the shared result of `make` for the kernels of these components on a rectangle of cells.
    fn made<T: Send + Sync + 'static, const N: usize>(
        &self,
        components: [[Component; N]; N],
        size: [usize; 2],
        make: impl FnOnce(
            [usize; 2],
            Option<Arc<RowPartition>>,
            [[&InfluenceKernel; N]; N],
        ) -> Result<T>
        + Send,
    ) -> Result<Arc<T>> {
        let size = self.cut(size);
        let is_kept = size == self.size();
        let made = &self.shared.made;
        made.get_or_make(components.as_flattened(), size, is_kept, || {
            parallel::enter_with(size.into_iter().product(), || {
                self.with_kernels(components, size, |kernels| {
                    make(size, self.share(size), kernels)
                })
            })
        })
    }
}

/// Returns the components of all pairs of directions: displacement, then traction.
pub(super) fn tensor<const N: usize>(directions: [Direction; N]) -> [[Component; N]; N] {
    const { assert!(N > 0, "an operator has a direction") }
    directions.map(|displacement| directions.map(|traction| Component::of(displacement, traction)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bodies::material::{ElasticPair, Material};

    /// Equal windows share one operator as long as it has an owner. The operator of the whole grid is kept.
    #[test]
    fn equal_windows_share_what_they_need() {
        let pair = ElasticPair::new(Material::new(1.0, 0.2).unwrap(), Material::rigid()).unwrap();
        let bodies = HalfSpace::new(Grid::new(12, 9, 1.0, 1.0).unwrap(), pair).unwrap();
        let [x, y, z] = [Direction::X, Direction::Y, Direction::Z];

        let first = bodies.compliance([x, y], [7, 5]).unwrap();
        let second = bodies.clone().compliance([x, y], [7, 5]).unwrap();
        assert!(first.operator.is(&second.operator));
        assert!(Arc::ptr_eq(&first.inverse.0, &second.inverse.0));
        for other in [[y, x], [x, z]] {
            let other = bodies.compliance(other, [7, 5]).unwrap();
            assert!(!first.operator.is(&other.operator));
        }
        let is_lent = Arc::downgrade(&first.inverse.0);
        drop((first, second));
        assert!(is_lent.upgrade().is_none());

        let whole = Arc::downgrade(&bodies.compliance([x, y, z], [12, 9]).unwrap().inverse.0);
        let again = bodies.tensor_preconditioner([x, y, z]).unwrap();
        assert!(std::ptr::eq(whole.as_ptr(), Arc::as_ptr(&again.0)));

        // A periodic grid is never cut.
        let grid = bodies.grid();
        let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
        let part = bodies.compliance([z], [7, 5]).unwrap();
        let whole = bodies.compliance([z], [12, 9]).unwrap();
        assert!(part.operator.is(&whole.operator));
    }

    /// Kernels of a large grid are not kept. The kernels of a window equal the kernels of a grid of the same size.
    #[test]
    fn windows_of_large_grids_have_the_operators_of_small_grids() {
        let body = Material::new(1.0, 0.4).unwrap();
        let pair = ElasticPair::new(body, Material::rigid()).unwrap();
        let on = |nx, ny| HalfSpace::new(Grid::new(nx, ny, 0.5, 0.7).unwrap(), pair).unwrap();
        let (large, small) = (on(1025, 1024), on(9, 7));
        assert!(!large.keeps_kernels() && small.keeps_kernels());
        let traction: Vec<f64> = (0..63).map(f64::from).collect();
        let displacement = |bodies: &HalfSpace| {
            let Compliance { operator, .. } = bodies.compliance([Direction::Z], [9, 7]).unwrap();
            let mut u = vec![0.0; 63];
            operator.apply([&traction], [&mut u], &mut operator.scratch().unwrap());
            u
        };
        assert_eq!(displacement(&large), displacement(&small));
    }
}
