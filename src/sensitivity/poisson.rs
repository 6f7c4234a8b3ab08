//! Derivatives with respect to Poisson's ratios of homogeneous bodies.
//!
//! The compliance is linear in three sums over the bodies: $`c_n = \sum (1 - \nu)/G`$, $`c_l = \sum \nu/G`$ and the difference
//! $`c_c`$ of $`(1 - 2 \nu)/G`$. Three pairs of bodies with known sums give the displacement per unit of each sum.

use crate::bodies::component::{Component, Direction};
use crate::bodies::material::{ElasticPair, Material};
use crate::cgm::reduce;
use crate::contact::ResponseContext;
use crate::error::Result;
use crate::half_space::{HalfSpace, Region};
use crate::memory::fallible;
use crate::numerics::cell_vector::{at, dot, slices, slices_mut};
use crate::operator::Operator;

/// Displacements of the cells of a region per unit of each sum: of $`c_n`$, $`c_l`$ and $`c_c`$.
pub(super) struct UnitDisplacements<const N: usize>([[Vec<f64>; N]; 3]);

/// Tractions of a contact along these directions, and the pressure that moves the surfaces tangentially.
pub(super) struct Loading<'a, const N: usize> {
    pub(super) directions: [Direction; N],
    pub(super) tractions: [&'a [f64]; N],
    /// Pressure that is not among the tractions, if it moves the surfaces.
    pub(super) pressure: Option<&'a [f64]>,
}

impl<const N: usize> UnitDisplacements<N> {
    /// Computes the displacements, or returns `None` for bodies that are not homogeneous, or that are distributed over
    /// ranks.
    pub(super) fn new(
        bodies: &HalfSpace,
        region: &Region,
        loading: &Loading<'_, N>,
        context: &mut ResponseContext<'_>,
    ) -> Result<Option<Self>> {
        if !bodies.pair().is_homogeneous() || bodies.team().is_some() {
            return Ok(None);
        }
        // The units of length and pressure of the bodies prevent overflow.
        let shear_modulus = bodies.pair().contact_modulus();
        let body = |ratio| Material::from_shear_modulus(shear_modulus, ratio);
        let equal = ElasticPair::new(body(0.0)?, body(0.0)?)?;
        let compressible = ElasticPair::new(body(0.0)?, Material::rigid())?;
        let incompressible = ElasticPair::new(body(0.5)?, Material::rigid())?;
        let host = |pair: ElasticPair| {
            let host = HalfSpace::with_boundary(bodies.grid(), pair, bodies.boundary())?;
            host.with_cell_value(bodies.cell_value())
        };
        let size = region.window().size;
        let mut product = |pair| -> Result<[Vec<f64>; N]> {
            context.notify_observer(region.layout())?;
            let of = |u: Direction| loading.directions.map(|q| Component::of(u, q));
            let operator = host(pair)?.operator_of(loading.directions.map(of), size)?;
            let mut out = fallible::vector(region.cells())?;
            operator.apply(
                loading.tractions,
                slices_mut(&mut out),
                &mut operator.scratch()?,
            );
            Ok(out)
        };
        // The sums of the three pairs, times the modulus, are (2, 0, 0), (1/2, 1/2, 0) and (1, 0, 1).
        let combined = |a: f64, x: [Vec<f64>; N], b: f64, y: &[Vec<f64>; N]| {
            let mut x = x;
            for (x, y) in x.iter_mut().zip(y) {
                for (x, y) in x.iter_mut().zip(y) {
                    *x = shear_modulus * a * *x + b * y;
                }
            }
            x
        };
        let zero = fallible::try_each(|_| fallible::zeros(region.cells()))?;
        let normal = combined(0.5, product(equal)?, 0.0, &zero);
        let lateral = combined(2.0, product(incompressible)?, -1.0, &normal);
        let coupling = match loading.pressure {
            None if N < 3 => zero,
            None => combined(1.0, product(compressible)?, -1.0, &normal),
            Some(pressure) => {
                let host = host(compressible)?;
                let mut drawn = zero;
                for (direction, out) in loading.directions.into_iter().zip(&mut drawn) {
                    context.notify_observer(region.layout())?;
                    let component = Component::of(direction, Direction::Z);
                    let operator = host.operator_of([[component]], size)?;
                    operator.apply([pressure], [out], &mut operator.scratch()?);
                    for u in out {
                        *u *= shear_modulus;
                    }
                }
                drawn
            }
        };
        Ok(Some(Self([normal, lateral, coupling])))
    }

    /// Returns the derivatives with respect to Poisson's ratio of each body at constant Young's modulus. `multipliers` are the
    /// multipliers of the displacements, and `energy` is the factor of $`x' C x`$ in the functional.
    pub(super) fn by_poisson_ratio(
        &self,
        bodies: &HalfSpace,
        region: &Region,
        loading: &Loading<'_, N>,
        multipliers: &[Vec<f64>; N],
        energy: f64,
    ) -> [f64; 2] {
        let multipliers = slices(multipliers);
        let [by_normal, by_lateral, by_coupling] = [0, 1, 2].map(|sum| {
            let moved = slices(&self.0[sum]);
            // The displacement due to a separate pressure is not part of the energy.
            let energy = if sum == 2 && N < 3 { 0.0 } else { energy };
            reduce::sum(region.layout(), |cell| {
                let stored = energy * dot(at(&loading.tractions, cell), at(&moved, cell));
                stored - dot(at(&multipliers, cell), at(&moved, cell))
            })
        });
        let mut sign = 1.0;
        bodies.pair().bodies().map(|body| {
            let (ratio, compliance) = (body.poisson_ratio(), body.youngs_modulus().recip());
            let [normal, lateral, coupling] =
                [-4.0 * ratio, 2.0 + 4.0 * ratio, -sign * (2.0 + 8.0 * ratio)];
            sign = -1.0;
            compliance * (normal * by_normal + lateral * by_lateral + coupling * by_coupling)
        })
    }
}
