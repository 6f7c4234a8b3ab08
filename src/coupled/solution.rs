//! Solution of a coupled contact.

use crate::cgm::reduce;
use crate::coupled::increment::CoupledIncrement;
use crate::coupled::{CoupledProblem, CoupledReport, N, SensitivityInput};
use crate::error::Result;
use crate::grid::field::Field;
use crate::grid::record::record;
use crate::half_space::HalfSpace;
use crate::memory::fallible::{try_each, unwrap_or_abort};
use crate::normal::NormalSolution;
use crate::parallel::layout::Layout;
use crate::support::debug::shown;
use crate::tangential::TangentialSolution;
use crate::warning::Warning;

record! {
    /// Normal and tangential solution of a coupled contact, with the displacements that pressure and tractions cause
    /// together. Equality compares the results and ignores the report.
    pub struct CoupledSolution {
        buffers {
            normal: NormalSolution,
            tangential: TangentialSolution,
            displacement: [Field; N],
        }
        values {}
        ignored {
            report: CoupledReport,
        }
        local {
            /// Elastic energy of the whole grid, if the fields are a slab.
            whole_energy: Option<f64>,
        }
    }
    #[serde(remote = "CoupledSolution")]
    check(read) {
        let grid = read.normal.grid();
        grid.check_equal("tangential solution", read.tangential.grid())?;
        let mut fields = read.displacement.iter();
        fields.try_for_each(|field| field.check("displacement", grid))
    }
}

shown!(CoupledSolution: normal, tangential, elastic_energy(), report());

impl CoupledSolution {
    /// Creates a solution without contact.
    pub(super) fn empty(bodies: &HalfSpace, gap: &Field) -> Result<Self> {
        let (grid, boundary) = (bodies.grid(), bodies.boundary());
        Ok(Self {
            normal: NormalSolution::empty(gap, (boundary, bodies.cell_value()), bodies.pair())?,
            tangential: TangentialSolution::empty(bodies)?,
            displacement: try_each(|_| Field::try_zeros(grid))?,
            report: CoupledReport::unsolved(),
            whole_energy: None,
        })
    }

    pub(super) fn fill(&mut self, of: &CoupledProblem, increment: &CoupledIncrement) {
        let (bodies, gap) = (&of.bodies, &of.gap);
        increment.write(gap, of.hardness.as_ref(), &mut self.normal);
        self.normal.measure_scale(bodies, gap);
        let input = (None, &of.friction, of.relative.as_ref());
        self.tangential
            .fill(bodies, input, &increment.answer(), increment.report());
        let pair = bodies.pair();
        self.tangential
            .set_coupled(pair.is_coupled().then(|| pair.coupling_strength()));
        for (field, values) in self.displacement.iter_mut().zip(increment.displacement()) {
            field.as_mut_slice().copy_from_slice(values);
        }
        self.report.clone_from(increment.full_report());
        let layout = bodies.grid_layout();
        let growth = SensitivityInput {
            gap: gap.as_slice(),
            before: None,
            pressure: self.normal.pressure().as_slice(),
            traction: self.tangential.traction().map(Field::as_slice),
        };
        let is_at_once = pair.is_coupled() && growth.is_at_once(&layout);
        self.tangential.set_pressed_at_once(is_at_once);
        self.whole_energy = bodies.is_shared().then(|| self.energy_over(&layout));
    }

    pub(super) fn normal_mut(&mut self) -> &mut NormalSolution {
        &mut self.normal
    }

    /// Returns the normal solution: pressure, gap under load, approach and contact area. Its report describes the whole
    /// solve. Its elastic energy and its displacement exclude the displacement due to the tractions.
    #[must_use]
    pub fn normal(&self) -> &NormalSolution {
        &self.normal
    }

    /// Returns the tangential solution: tractions along both axes, slip, zones and shift. Its report describes the
    /// whole solve. Its elastic energy and its displacement exclude the displacement due to the pressure.
    #[must_use]
    pub fn tangential(&self) -> &TangentialSolution {
        &self.tangential
    }

    /// Returns the displacements of all cells along x, y and z due to pressure and traction together (lengths). Along x
    /// and y they are the displacement of body 1 minus the displacement of body 2. Along z they are the sum of the
    /// displacements of both bodies. The `displacement` functions of the normal and the tangential solution compute the
    /// displacements due to the pressure alone or the tractions alone.
    #[must_use]
    pub fn displacement(&self) -> [&Field; 3] {
        let [z, x, y] = &self.displacement;
        [x, y, z]
    }

    /// Returns the elastic energy of both bodies, $`\tfrac A2 \sum (p\,u_z + q \cdot u_t)`$ (force times length). It is the
    /// total energy of the coupled contact. For dissimilar bodies it differs from the sum of the energies of
    /// [`normal`](Self::normal) and [`tangential`](Self::tangential) by $`A \sum p\,w`$. Here w is the normal displacement due to
    /// the tractions.
    #[must_use]
    pub fn elastic_energy(&self) -> f64 {
        let of_own = || self.energy_over(&self.normal.grid().layout());
        self.whole_energy.unwrap_or_else(of_own)
    }

    /// Computes the elastic energy over the cells of a layout.
    fn energy_over(&self, layout: &Layout) -> f64 {
        let [z, x, y] = self.displacement.each_ref().map(Field::as_slice);
        let [qx, qy] = self.tangential.traction().map(Field::as_slice);
        let p = self.normal.pressure().as_slice();
        let sum = reduce::sum(layout, |i| p[i] * z[i] + qx[i] * x[i] + qy[i] * y[i]);
        0.5 * self.normal.grid().cell_area() * sum
    }

    /// Returns the report of the solve: status, cost and certificates.
    #[must_use]
    pub fn report(&self) -> &CoupledReport {
        &self.report
    }

    /// Returns the warnings about results that may be misleading. See [`Warning`].
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        unwrap_or_abort(self.try_warnings())
    }

    /// Returns the same warnings as [`Self::warnings`], or an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn try_warnings(&self) -> Result<Vec<Warning>> {
        let mut warnings = self.normal.try_warnings()?;
        let tangential = &self.tangential;
        warnings.extend(
            tangential
                .zone_warnings()
                .chain(tangential.pressing_warning())
                .chain(tangential.load_warnings()),
        );
        Ok(warnings)
    }
}
