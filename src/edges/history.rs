//! Edges of the contact of a history and of its stick zone.

use crate::edges::TangentialEdges;
use crate::edges::tangential::PartialSlipContact;
use crate::error::Result;
use crate::grid::field::Field;
use crate::grid::neighbours::neighbours;
use crate::history::{History, StepResult};
use crate::memory::fallible;
use crate::tangential::Zone;

/// Largest residual of a fit of the stick zone (root mean square, in cells). An old edge within a few cells of the new edge
/// distorts the values.
const LARGEST_MISS: f64 = 0.02;

/// Relative difference between the two measures of the dissipated energy of a cell above which the cell stuck before the step.
const STUCK: f64 = 1e-3;

impl History {
    /// Returns the edges of the contact and of the stick zone after the last step, located inside the cells. The
    /// documentation of [`edges`](crate::edges) describes the method.
    ///
    /// The value in the stick zone is the friction reserve $`\mu p - q \cdot t`$ in the direction in which a cell would slip.
    /// Here t is the unit vector of the traction in the nearest slipping cell. After a reversal this value falls to zero at the
    /// new edge. It behaves like $`2 (\mu p - |q|)`$ at the edge of a first loading. Slipping cells contribute to the fit if they
    /// stuck until the last step and this step did not change the normal load. After small steps there might be no such cells.
    /// After [`set_state`](Self::set_state), after a restart and after a rolling step, these cells cannot be identified. In both
    /// cases the edge follows only from the values in the stick zone. A cell that continues to slip while its traction rotates by
    /// a few degrees cannot be distinguished from a cell that stuck.
    ///
    /// The table is for a sphere with mu = 0.5 and forces along one axis. The grid has centre values and 128 x 128 cells on three
    /// contact radii. The table compares the errors of the raw cells and of the fit. The errors of the stick area are the mean
    /// and the maximum over 8 positions. The errors of the traction (L1 norm) are means over these positions:
    ///
    /// | force over mu W | area, counted | area, fit | traction, raw cells | traction, fit |
    /// |---|---|---|---|---|
    /// | to 0.4 in one step or four | 9.2e-3, 1.1e-2 | 1.4e-4, 2.4e-4 | 3.1e-3 | 4.9e-4 |
    /// | to 0.4 in twenty | 9.2e-3, 1.1e-2 | 4.4e-4, 9.8e-4 | 3.1e-3 | 7.8e-4 |
    /// | 0.7 to 0 in one step or four | 9.3e-3, 1.2e-2 | 1.4e-4, 3.7e-4 | 7.5e-3 | 2.5e-3 |
    /// | 0.7 to 0 in twenty | 9.3e-3, 1.2e-2 | 4.8e-4, 7.5e-4 | 7.5e-3 | 3.2e-3 |
    /// | 0.7 to -0.5, the old edge 3 cells from the new edge | 1.1e-2, 1.3e-2 | 8.4e-4, 2.7e-3 | 3.8e-3 | 2.8e-3 |
    ///
    /// The traction also has a kink at the old edge. At this edge the returned traction is the traction of the raw cells.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(96, 3.0)?;
    /// let body = Material::new(2.0, 0.0)?;
    /// let pair = ElasticPair::new(body, body)?;
    /// let bodies = HalfSpace::new(grid, pair)?.with_cell_value(CellValue::Centre)?;
    /// let hertz = analytical::HertzSphere::new(&pair, 1.0, 4.0 / 3.0)?;
    /// let ball = surface::sphere(grid, 1.0)?;
    /// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
    /// history.step(&LoadStep::hold().normal(NormalLoad::Force(4.0 / 3.0)))?;
    /// let path = [0.45, 0.0];
    /// for force in path {
    ///     history.step(&LoadStep::hold().tangential(Axis::X, TangentialControl::Force(force)))?;
    /// }
    /// let exact = analytical::MindlinDeresiewicz::new(hertz, 0.5, &path)?;
    /// let area = std::f64::consts::PI * exact.stick_radius().powi(2);
    /// let counted = history.last_step()?.stick_ratio() * history.normal().contact_area();
    /// assert!((counted / area - 1.0).abs() > 1e-2);
    /// assert!((history.edges()?.stick_area() / area - 1.0).abs() < 1e-3);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::OutdatedSolution`](crate::Error::OutdatedSolution) if the friction has changed since the last step. The tractions
    ///   still belong to the previous friction.
    /// - The errors of [`NormalSolution::edges`](crate::NormalSolution::edges).
    pub fn edges(&self) -> Result<TangentialEdges> {
        self.state.check_friction("edge of the stick zone")?;
        let [qx, qy] = self.traction().map(Field::as_slice);
        let directions = self.directions()?;
        let last_step = self.last_step().ok();
        let known_slip = last_step
            .filter(|step| pressing_is_excluded(step))
            .map(|step| {
                let fields = [
                    step.slip_distance(),
                    step.dissipation(),
                    step.dissipation_midpoint(),
                ];
                fields.map(Field::as_slice)
            });
        PartialSlipContact {
            normal: self.normal(),
            friction: self.friction(),
            zones: self.zones(),
            traction: [qx, qy],
            parts: &|i| {
                let [x, y] = directions[i];
                let along = qx[i] * x + qy[i] * y;
                [along, (qx[i] - along * x).hypot(qy[i] - along * y)]
            },
            // The slip is valid in cells that stuck before the step. If a cell had already slipped in the same direction, its
            // traction has not changed. Its dissipated energy then equals the midpoint estimate.
            slip: &|i| {
                let [slip, dissipated, mid_step] = known_slip?;
                let has_stuck = mid_step[i] < (1.0 - STUCK) * dissipated[i];
                has_stuck.then(|| slip[i])
            },
            largest_miss: LARGEST_MISS,
        }
        .edges()
    }

    /// Returns a direction for each cell. It is the direction of the traction in a slipping cell. In a sticking cell it is the
    /// direction in the nearest slipping cell. The directions are zero in contacts without slipping cells.
    fn directions(&self) -> Result<Vec<[f64; 2]>> {
        let (zones, [qx, qy]) = (self.zones(), self.traction().map(Field::as_slice));
        let (size, repeats) = (self.grid().size(), self.boundary().repeats());
        let mut directions = fallible::filled([0.0; 2], zones.len())?;
        let mut reached = Vec::new();
        for (i, direction) in directions.iter_mut().enumerate() {
            let traction = qx[i].hypot(qy[i]);
            if zones[i] == Zone::Slip && traction > 0.0 {
                *direction = [qx[i] / traction, qy[i] / traction];
                fallible::push(&mut reached, i)?;
            }
        }
        let mut done = 0;
        while let Some(&i) = reached.get(done) {
            done += 1;
            for next in neighbours(i, size, repeats).into_iter().flatten() {
                let is_new = directions[next].iter().all(|part| *part == 0.0);
                if zones[next] == Zone::Stick && is_new {
                    directions[next] = directions[i];
                    fallible::push(&mut reached, next)?;
                }
            }
        }
        Ok(directions)
    }
}

/// Returns whether a step neither rolled nor changed the pressure.
fn pressing_is_excluded(step: &StepResult) -> bool {
    let report = step.normal_report();
    let is_held = report.is_none_or(|report| report.products() == 0);
    is_held && step.creepage().is_none()
}
