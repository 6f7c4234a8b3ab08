//! Jaeger's superposition: partial slip as the difference of two normal contacts.

use crate::bodies::material::ElasticPair;
use crate::error::{Error, Result, check_converged, non_negative};
use crate::grid::field::Field;
use crate::memory::fallible;
use crate::normal::NormalSolution;
use crate::parallel::reduce;
use crate::support::debug::shown;
use crate::tangential::Zone;

/// Tangential contact under `F = mu (W - W_stick)`, from the normal contacts under `W` and `W_stick`.
///
/// ```math
/// q = \mu\,[p(W) - p(W_{stick})], \qquad
/// \delta_x = \mu\,\kappa\,[\delta(W) - \delta(W_{stick})], \qquad
/// \kappa = \frac{2 - \nu}{2 (1 - \nu)}
/// ```
///
/// The stick zone is the contact area under the smaller load. The superposition is exact if the tangential compliance
/// is proportional to the normal compliance. It is exact on any surface for Poisson's ratio zero, and on spheres for
/// any Poisson's ratio. On ellipsoids the traction is exact, but the factor of the shift differs from `kappa`. On rough
/// surfaces with Poisson's ratio 0.29 and contact on 2 to 40 % of the area, the error was measured on 64 x 64 and
/// 128 x 128 cells. Under 0.1 to 0.6 of the sliding force, the traction has an error of 2 to 5 % (sum of the differences),
/// and the shift an error of at most 0.5 %.
///
/// See Jaeger, J. Tribology 120 (1998) 677, <https://doi.org/10.1115/1.2833765>. Ciavarella proved the superposition for
/// plane contacts in Int. J. Solids Struct. 35 (1998) 2349, <https://doi.org/10.1016/S0020-7683(97)00154-6>. He proved
/// it for three-dimensional contacts at Poisson's ratio zero, and for axisymmetric contacts at any Poisson's ratio, in
/// J. Appl. Mech. 65 (1998) 998.
#[derive(Clone, PartialEq)]
pub struct JaegerSuperposition {
    traction: Field,
    zones: Vec<Zone>,
    shift: f64,
    force: f64,
}

shown!(JaegerSuperposition: traction, shift, force);

/// Largest force by which the pressure under the smaller load exceeds the pressure under the larger load, relative to the larger
/// load. Solves to a coarse tolerance differ at single cells of the edge.
const LARGEST_EXCESS: f64 = 1e-3;

impl JaegerSuperposition {
    /// Creates the superposition from two contacts, the pair and the coefficient of friction. The contact `full`
    /// carries the load W. The contact `stick` carries the load `W - F/mu` (a prescribed force, zero at sliding). The
    /// coupling between pressure and traction of dissimilar bodies is neglected.
    ///
    /// # Errors
    /// - [`Error::UnsupportedForCoatings`] if a body is coated. On a stiff coating, a larger load decreases the pressure of some
    ///   cells.
    /// - [`Error::NegativeOrNotFinite`] if the coefficient is negative or `stick` carries more load than `full`.
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`] or [`Error::CellValueMismatch`] if the two contacts
    ///   differ in these properties.
    /// - [`Error::MaterialMismatch`] if a contact belongs to a different pair.
    /// - [`Error::NotConverged`] with its report if a contact has not converged.
    /// - [`Error::EmptyContact`] if `full` carries no pressure.
    /// - [`Error::OutdatedSolution`] if the contacts have different gaps. The pressure of `stick` then exceeds the pressure of
    ///   `full` in some cells, by more than 1e-3 of the load of `full` in total.
    pub fn new(
        full: &NormalSolution,
        stick: &NormalSolution,
        pair: &ElasticPair,
        friction: f64,
    ) -> Result<Self> {
        non_negative("coefficient of friction", friction)?;
        pair.check_homogeneous("the superposition", "solve the tangential problem")?;
        let grid = full.grid();
        grid.check_equal("lighter contact", stick.grid())?;
        if stick.boundary() != full.boundary() {
            let quantity = "lighter contact";
            return Err(Error::BoundaryMismatch { quantity });
        }
        if stick.cell_value() != full.cell_value() {
            let quantity = "lighter contact";
            return Err(Error::CellValueMismatch { quantity });
        }
        for (quantity, contact) in [("full contact", full), ("lighter contact", stick)] {
            if contact.pair() != pair {
                return Err(Error::MaterialMismatch { quantity });
            }
            contact.check_elastic("the superposition")?;
        }
        check_converged(full.report())?;
        check_converged(stick.report())?;
        if full.contact_cells() == 0 {
            return Err(Error::EmptyContact);
        }
        // The forces of two contacts under the same load may differ by round-off.
        let force = friction * (full.force() - stick.force());
        if force < -1e-12 * friction * full.force() {
            return Err(Error::NegativeOrNotFinite {
                quantity: "tangential force of the superposition",
                value: force,
            });
        }
        let cells = grid.cells();
        let pressures = full
            .pressure()
            .as_slice()
            .iter()
            .zip(stick.pressure().as_slice());
        // On the same gap, a larger load increases the pressure of every cell. Stiff coatings, which are rejected above, are an
        // exception.
        let [heavy, light] = [full, stick].map(|contact| contact.pressure().as_slice());
        let excess = reduce::sum(&grid.layout(), |cell| (light[cell] - heavy[cell]).max(0.0));
        if excess * grid.cell_area() > LARGEST_EXCESS * full.force() {
            return Err(Error::OutdatedSolution {
                quantity: "heavier contact",
                changed: "the gap",
                remedy: "compute both contacts with the same gap",
            });
        }
        let traction = pressures
            .clone()
            .map(|(full, stick)| friction * (full - stick));
        let traction = fallible::collected(cells, traction)?;
        let zones = pressures.map(|(&full, &stick)| match (full > 0.0, stick > 0.0) {
            (false, _) => Zone::Separated,
            (true, true) => Zone::Stick,
            (true, false) => Zone::Slip,
        });
        let zones = fallible::collected(cells, zones)?;
        let nu = pair.equivalent_poisson_ratio();
        let ratio = (2.0 - nu) / (2.0 * (1.0 - nu));
        Ok(Self {
            traction: Field::from_vec(grid, traction)?,
            zones,
            shift: friction * ratio * (full.approach() - stick.approach()),
            force,
        })
    }

    /// Returns the shear traction q on body 1 along the direction of the load (a pressure).
    #[must_use]
    pub fn traction(&self) -> &Field {
        &self.traction
    }

    /// Returns the zone of every cell, row-major with x fastest.
    #[must_use]
    pub fn zones(&self) -> &[Zone] {
        &self.zones
    }

    /// Returns the shift, the rigid motion of body 2 relative to body 1 (a length).
    #[must_use]
    pub fn shift(&self) -> f64 {
        self.shift
    }

    /// Returns the tangential force `mu (W - W_stick)`.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.force
    }
}
