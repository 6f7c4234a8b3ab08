//! The components of displacement and stress as weighted sums of the integrals.

use super::integral::PotentialIntegral;
use std::f64::consts::PI;

/// Unit traction on the cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Load {
    /// Pressure.
    P,
    /// Traction along x.
    Qx,
    /// Traction along y.
    Qy,
}

impl Load {
    /// All tractions.
    pub(crate) const ALL: [Self; 3] = [Self::P, Self::Qx, Self::Qy];

    /// Returns the axes along which the traction changes the parity of a component.
    pub(crate) fn turns(self) -> [bool; 2] {
        [self == Self::Qx, self == Self::Qy]
    }
}

/// Component of displacement or stress per unit traction. A displacement is multiplied by the shear modulus and is then
/// a length.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FieldComponent {
    Ux,
    Uy,
    Uz,
    Sxx,
    Syy,
    Szz,
    Sxy,
    Sxz,
    Syz,
}

impl FieldComponent {
    /// Number of components.
    pub(crate) const COUNT: usize = 9;

    /// All components, displacements first.
    pub(crate) const ALL: [Self; Self::COUNT] = [
        Self::Ux,
        Self::Uy,
        Self::Uz,
        Self::Sxx,
        Self::Syy,
        Self::Szz,
        Self::Sxy,
        Self::Sxz,
        Self::Syz,
    ];

    /// Returns whether the component is a displacement.
    pub(crate) fn is_displacement(self) -> bool {
        matches!(self, Self::Ux | Self::Uy | Self::Uz)
    }

    /// Returns whether the component has exactly one index z. Such a component has the opposite sign in a body from
    /// which z points away.
    pub(crate) fn is_odd_in_z(self) -> bool {
        matches!(self, Self::Uz | Self::Sxz | Self::Syz)
    }

    /// Returns whether the component is odd in x and whether it is odd in y under a pressure. A component that is not
    /// odd is even. A traction along an axis changes the parity along this axis.
    pub(crate) fn is_odd(self) -> [bool; 2] {
        match self {
            Self::Uz | Self::Sxx | Self::Syy | Self::Szz => [false, false],
            Self::Ux | Self::Sxz => [true, false],
            Self::Uy | Self::Syz => [false, true],
            Self::Sxy => [true, true],
        }
    }
}

/// Weights of the integrals in all components. The table depends only on `nu` and `z`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Weights {
    /// Weights by load, component and integral.
    table: [[[f64; PotentialIntegral::COUNT]; FieldComponent::COUNT]; 3],
}

#[derive(Debug, Clone, Copy)]
enum EdgeAxis {
    X,
    Y,
    Z,
}

impl Weights {
    /// Computes the weights at the depth `z` for Poisson's ratio `nu`.
    pub(crate) fn new(nu: f64, z: f64) -> Self {
        let table = [[[0.0; PotentialIntegral::COUNT]; FieldComponent::COUNT]; 3];
        let mut weights = Self { table };
        weights.set_pressure(nu, z);
        weights.set_traction_x(nu, z);
        weights.set_traction_y(nu, z);
        weights
    }

    /// Returns the weights of one component, in the order of [`PotentialIntegral::index`].
    pub(crate) fn of(
        &self,
        load: Load,
        component: FieldComponent,
    ) -> &[f64; PotentialIntegral::COUNT] {
        &self.table[load as usize][component as usize]
    }

    fn set_pressure(&mut self, nu: f64, z: f64) {
        use PotentialIntegral::{Lx, Lxx, Lxy, Ly, Txxz, Txyz, Txzz, Tyyz, Tyzz, Tzzz, V};
        let e = 1.0 - 2.0 * nu;
        let load = Load::P;
        self.add(load, FieldComponent::Ux, &[(-e, Lx)]);
        self.add_trace(load, FieldComponent::Ux, z, EdgeAxis::X);
        self.add(load, FieldComponent::Uy, &[(-e, Ly)]);
        self.add_trace(load, FieldComponent::Uy, z, EdgeAxis::Y);
        self.add(load, FieldComponent::Uz, &[(2.0 * (1.0 - nu), V)]);
        self.add_trace(load, FieldComponent::Uz, z, EdgeAxis::Z);
        self.add(load, FieldComponent::Sxx, &[(-1.0, Txxz), (-e, Lxx)]);
        self.add_trace(load, FieldComponent::Sxx, e, EdgeAxis::Z);
        self.add(load, FieldComponent::Syy, &[(-1.0, Tyyz), (e, Lxx)]);
        self.add(load, FieldComponent::Szz, &[(-1.0, Tzzz)]);
        self.add(load, FieldComponent::Sxy, &[(-1.0, Txyz), (-e, Lxy)]);
        self.add(load, FieldComponent::Sxz, &[(-1.0, Txzz)]);
        self.add(load, FieldComponent::Syz, &[(-1.0, Tyzz)]);
    }

    fn set_traction_x(&mut self, nu: f64, z: f64) {
        use PotentialIntegral::{
            Lx, Lxx, Lxy, Txxx, Txxy, Txxz, Txyy, Txyz, Txzz, V, Wxx, Wxxy, Wxy, Wxyy,
        };
        let e = 1.0 - 2.0 * nu;
        let load = Load::Qx;
        self.add(
            load,
            FieldComponent::Ux,
            &[(2.0, V), (2.0 * nu, Wxx), (-z, Lxx)],
        );
        self.add(load, FieldComponent::Uy, &[(2.0 * nu, Wxy), (-z, Lxy)]);
        self.add(load, FieldComponent::Uz, &[(e, Lx)]);
        self.add_trace(load, FieldComponent::Uz, z, EdgeAxis::X);
        self.add(load, FieldComponent::Sxx, &[(-1.0, Txxx), (e, Wxyy)]);
        self.add(load, FieldComponent::Syy, &[(-1.0, Txyy), (-e, Wxyy)]);
        self.add_trace(load, FieldComponent::Syy, e, EdgeAxis::X);
        self.add(load, FieldComponent::Szz, &[(-1.0, Txzz)]);
        self.add(load, FieldComponent::Sxy, &[(-1.0, Txxy), (-e, Wxxy)]);
        self.add(load, FieldComponent::Sxz, &[(-1.0, Txxz)]);
        self.add(load, FieldComponent::Syz, &[(-1.0, Txyz)]);
    }

    /// Sets the weights for a traction along y: the weights for a traction along x with the axes exchanged. The other
    /// integrals replace `L_yy` and `W_yy`.
    fn set_traction_y(&mut self, nu: f64, z: f64) {
        use PotentialIntegral::{
            Lxx, Lxy, Ly, Txxy, Txyy, Txyz, Tyyy, Tyyz, Tyzz, V, Wxx, Wxxy, Wxy, Wxyy,
        };
        let e = 1.0 - 2.0 * nu;
        let load = Load::Qy;
        self.add(load, FieldComponent::Ux, &[(2.0 * nu, Wxy), (-z, Lxy)]);
        self.add(
            load,
            FieldComponent::Uy,
            &[(2.0 - 2.0 * nu, V), (-2.0 * nu, Wxx), (z, Lxx)],
        );
        self.add_trace(load, FieldComponent::Uy, -z, EdgeAxis::Z);
        self.add(load, FieldComponent::Uz, &[(e, Ly)]);
        self.add_trace(load, FieldComponent::Uz, z, EdgeAxis::Y);
        self.add(load, FieldComponent::Sxx, &[(-1.0, Txxy), (-e, Wxxy)]);
        self.add_trace(load, FieldComponent::Sxx, e, EdgeAxis::Y);
        self.add(load, FieldComponent::Syy, &[(-1.0, Tyyy), (e, Wxxy)]);
        self.add(load, FieldComponent::Szz, &[(-1.0, Tyzz)]);
        self.add(load, FieldComponent::Sxy, &[(-1.0, Txyy), (-e, Wxyy)]);
        self.add(load, FieldComponent::Sxz, &[(-1.0, Txyz)]);
        self.add(load, FieldComponent::Syz, &[(-1.0, Tyyz)]);
    }

    /// Adds a factor times one third of the trace of `T`, which is `-V_x`, `-V_y` or `-V_z`.
    fn add_trace(&mut self, load: Load, component: FieldComponent, factor: f64, axis: EdgeAxis) {
        use PotentialIntegral::{Txxx, Txxy, Txxz, Txyy, Txzz, Tyyy, Tyyz, Tyzz, Tzzz};
        let trace = match axis {
            EdgeAxis::X => [Txxx, Txyy, Txzz],
            EdgeAxis::Y => [Txxy, Tyyy, Tyzz],
            EdgeAxis::Z => [Txxz, Tyyz, Tzzz],
        };
        self.add(
            load,
            component,
            &trace.map(|integral| (factor / 3.0, integral)),
        );
    }

    /// Adds weights with the factor `1/(4 pi)` for displacements and `1/(2 pi)` for stresses.
    fn add(&mut self, load: Load, component: FieldComponent, parts: &[(f64, PotentialIntegral)]) {
        let divisor = if component.is_displacement() {
            4.0 * PI
        } else {
            2.0 * PI
        };
        for &(weight, integral) in parts {
            self.table[load as usize][component as usize][integral.index()] += weight / divisor;
        }
    }
}
