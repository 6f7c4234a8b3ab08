//! Wavy surfaces pressed together and in partial slip.

use crate::analytical::closed_form::closed_form;
use crate::material::{ElasticPair, Pair};

closed_form! {
    /// A surface with waves along x that is pressed on a half-space, in plane strain.
    ///
    /// The gap is amplitude (1 - cos(2 pi x / lambda)), with the wavelength lambda. Contact forms strips of half-width
    /// a about every crest, up to the pressure p* of full contact. Westergaard (1939); Johnson (1985), section 13.2.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair or two Materials
    ///     The bodies.
    /// amplitude : float
    ///     Amplitude of the waves, half their height (a length), positive.
    /// wavelength : float
    ///     Wavelength lambda (a length), positive.
    /// mean_pressure : float
    ///     Ratio of the load to the nominal area, positive.
    ///
    /// Raises
    /// ------
    /// NotPositive
    Westergaard(pair: Pair => &pair.0, amplitude, wavelength, mean_pressure)
    objects {
        /// The bodies.
        pair: ElasticPair,
    }
    numbers {
        /// Amplitude of the waves, half their height (a length).
        amplitude,
        /// Wavelength lambda (a length).
        wavelength,
        /// Mean pressure, the ratio of the load to the nominal area.
        mean_pressure,
        /// Lowest mean pressure of full contact, p* = pi E* amplitude / lambda.
        full_contact_pressure,
        /// Half-width of a contact strip, a = (lambda/pi) arcsin(sqrt(mean_pressure / p*)) (a length); half the
        /// wavelength in full contact.
        contact_half_width,
        /// Fraction of the nominal area in contact, 2 a / lambda.
        contact_fraction,
        /// Pressure at the crests: 2 sqrt(mean_pressure p*); in full contact mean_pressure + p*.
        max_pressure,
        /// Approach of the mean planes of the two surfaces since first touch (a length): amplitude R (1 - ln(R)) with R =
        /// mean_pressure / p*; in full contact, the amplitude.
        approach,
    }
    along {
        /// Returns the pressure at the distance x from a crest: 2 p* cos(pi x / lambda) sqrt(sin^2(pi a / lambda) -
        /// sin^2(pi x / lambda)), zero outside the contact; in full contact mean_pressure + p* cos(2 pi x / lambda).
        pressure(x),
        /// Returns the gap between the surfaces (a length) at the distance x from a crest; zero in the contact, positive
        /// outside.
        gap(x),
    }
    also {
        /// Whether the surfaces touch everywhere, that is, whether the mean pressure is at least p*.
        #[getter]
        fn is_full_contact(&self) -> bool {
            self.0.is_full_contact()
        }
    }
}

closed_form! {
    /// A wavy surface in partial slip: a constant mean pressure, then a traction along x that increases monotonically.
    ///
    /// The traction is mu times the difference between the pressure and the pressure under 1 - f of the load, with f =
    /// |mean_traction| / (mu mean_pressure). The contact strips under 1 - f of the load stick. A full contact sticks
    /// everywhere, under a uniform traction, as long as 1 - f of the load causes full contact. The solution is exact for
    /// every nu, except that the coupling between pressure and traction of dissimilar bodies is neglected. Ciavarella,
    /// Int. J. Solids Struct. 35 (1998) 2349; Jaeger, J. Tribology 120 (1998) 677.
    ///
    /// Parameters
    /// ----------
    /// contact : Westergaard
    ///     The normal contact.
    /// friction : float
    ///     Coefficient of friction mu (dimensionless), not negative.
    /// mean_traction : float
    ///     Tangential force on body 1 along x per nominal area, of either sign, at most mu mean_pressure.
    ///
    /// Raises
    /// ------
    /// NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    WestergaardPartialSlip(contact: Westergaard => contact.0, friction, mean_traction)
    objects {
        /// The normal contact.
        contact: Westergaard,
    }
    numbers {
        /// Mean traction on body 1, positive along +x: the tangential force per nominal area.
        mean_traction,
        /// Half-width c of a stick strip (a length).
        stick_half_width,
        /// Fraction of the contact area that sticks, c/a.
        stick_ratio,
    }
    along {
        /// Returns the traction on body 1 along x (a pressure, with the sign of the mean traction) at the distance x from
        /// a crest, or zero outside the contact.
        traction(x),
    }
}
