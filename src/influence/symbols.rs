//! Coefficients in Fourier space: the response of an infinite half-space to a wave of traction.

use std::f64::consts::TAU;

use crate::bodies::component::Component;
use crate::bodies::kernel::{Kernel, KernelSource};
use crate::bodies::layers::Response;
use crate::bodies::material::Compliances;
use crate::grid::Grid;
use crate::influence::integrals::Integral;

/// Symbol of one coefficient for the waves that fit a periodic grid.
///
/// A wave of traction `exp(i k.x)` displaces the surface by the symbol times the same wave. The symbol is real for
/// components with the same parity along both axes, and imaginary for the other components. A mean traction is a wave
/// of infinite length. The displacement under it is undefined and set to zero.
#[derive(Debug, Clone)]
pub(crate) struct Symbols {
    component: Component,
    compliances: Compliances,
    /// Kernel of bodies whose symbols are not sums of the symbols of half-spaces.
    other: Option<Box<Kernel>>,
    size: [usize; 2],
    /// Wave numbers of one period over the grid along x and y.
    steps: [f64; 2],
}

impl Symbols {
    pub(crate) fn new(grid: Grid, kernel: &Kernel, component: Component) -> Self {
        let pair = kernel.pair();
        let size = [grid.nx(), grid.ny()];
        let sides = [grid.nx() as f64 * grid.dx(), grid.ny() as f64 * grid.dy()];
        Self {
            component,
            compliances: pair.compliances(),
            other: (!pair.is_homogeneous()).then(|| Box::new(kernel.clone())),
            size,
            steps: sides.map(|side| TAU / side),
        }
    }

    pub(crate) fn component(&self) -> Component {
        self.component
    }

    /// Returns the symbol, or its imaginary part, of the wave with the given numbers of periods along x and y. The
    /// numbers are at most half the number of cells.
    pub(crate) fn at(&self, periods: [usize; 2]) -> f64 {
        let odd = self.component.is_odd();
        // The direction of a wave of two cells per period is undetermined, so its odd components vanish.
        let is_lost = (0..2).any(|axis| odd[axis] && 2 * periods[axis] == self.size[axis]);
        if is_lost || periods == [0, 0] {
            return 0.0;
        }
        let [x, y] = [0, 1].map(|axis| self.steps[axis] * periods[axis] as f64);
        if let Some(kernel) = &self.other {
            return self.component.symbol(kernel, [x, y]);
        }
        let parts = self.component.parts(self.compliances);
        parts
            .map(|(weight, integral)| weight * integral.symbol(x, y))
            .sum()
    }
}

impl Component {
    /// Returns the symbol of bodies, or its imaginary part, at the wave vector.
    fn symbol(self, kernel: &Kernel, [x, y]: [f64; 2]) -> f64 {
        if let Some(KernelSource::Orthotropic(response)) = kernel.given() {
            return response([x, y]).component(self);
        }
        let k = x.hypot(y);
        self.of_response(kernel.times_k(k), [x / k, y / k]) / k
    }

    /// Returns this component of a response in the direction of the wave vector (a unit vector), or its
    /// imaginary part.
    pub(crate) fn of_response(self, found: Response, [x, y]: [f64; 2]) -> f64 {
        match self {
            Self::ZZ => found.normal,
            Self::XX => found.along * x * x + found.across * y * y,
            Self::YY => found.along * y * y + found.across * x * x,
            Self::XY | Self::YX => (found.along - found.across) * x * y,
            Self::ZX => -found.coupling * x,
            Self::ZY => -found.coupling * y,
            Self::XZ => found.coupling * x,
            Self::YZ => found.coupling * y,
        }
    }
}

impl Integral {
    /// Returns the Fourier transform of the kernel over `2 pi`, or its imaginary part.
    fn symbol(self, x: f64, y: f64) -> f64 {
        let k = x.hypot(y);
        let (x, y) = (x / k, y / k);
        let direction = match self {
            Self::Potential => 1.0,
            Self::AlongX => y * y,
            Self::Diagonal => -x * y,
            Self::RadialX => -x,
            Self::RadialY => -y,
        };
        direction / k
    }
}
