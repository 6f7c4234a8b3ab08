//! Results of a history: the bits of its state, and numbers that must not depend on the pose of the scene.

use stickslip::{Field, History};

use super::{Scene, UnitTransform};

/// Returns the complete state of a history and of its last step, in bits.
pub fn bits(history: &History) -> Vec<u8> {
    let (mut bits, step) = (history.to_bytes(), history.last_step().unwrap());
    let [x, y] = step.slip();
    let fields = [
        x,
        y,
        step.slip_distance(),
        step.dissipation(),
        step.dissipation_midpoint(),
    ];
    let samples = fields.into_iter().flat_map(Field::as_slice);
    let numbers = known(history);
    let numbers = samples.chain(&numbers);
    bits.extend(numbers.flat_map(|value| value.to_le_bytes()));
    bits
}

/// Returns the results of a history and of its last step that are available on every rank.
pub fn known(history: &History) -> Vec<f64> {
    let (step, normal) = (history.last_step().unwrap(), history.normal());
    let energy = step.energy();
    let ([fx, fy], [dx, dy], [mx, my]) = (
        history.tangential_force(),
        history.shift(),
        normal.moments(),
    );
    let [width, height] = normal.contact_extent().unwrap_or_default();
    let mut known = vec![
        fx,
        fy,
        dx,
        dy,
        mx,
        my,
        width,
        height,
        history.moment(),
        history.approach(),
        history.friction_capacity(),
        normal.force(),
        normal.contact_cells() as f64,
        normal.contact_area_corrected(),
        normal.yielded_cells() as f64,
        energy.work,
        energy.elastic_before,
        energy.elastic_after,
        energy.dissipated_energy,
        energy.dissipated_energy_midpoint,
        energy.released,
        energy.residual,
        step.stick_ratio(),
        step.warnings().len() as f64,
    ];
    known.extend(step.creepage().unwrap_or_default());
    for report in [step.normal_report(), step.tangential_report()] {
        known.extend(report.into_iter().flat_map(|report| {
            [
                report.residual,
                report.iterations as f64,
                report.double_precision_products as f64,
                report.single_precision_products as f64,
            ]
        }));
    }
    known
}

/// Returns the results of a history in each cell.
pub fn cells(history: &History) -> Vec<[f64; 8]> {
    let ([qx, qy], step) = (history.traction(), history.last_step().unwrap());
    let fields = [
        history.pressure(),
        history.normal().gap(),
        qx,
        qy,
        history.accumulated_slip(),
        history.accumulated_dissipation(),
        step.slip_distance(),
    ]
    .map(Field::as_slice);
    let cell = |i: usize| {
        let [p, g, x, y, s, e, d] = fields.map(|field| field[i]);
        [p, g, x, y, s, e, d, f64::from(history.zones()[i] as u8)]
    };
    (0..history.grid().cells()).map(cell).collect()
}

/// Numbers of all steps, transformed back to the scene without its pose. Round-off is measured relative to the largest
/// number of each group.
#[derive(Debug, Default)]
pub struct Measured {
    pub pressures: Vec<f64>,
    pub lengths: Vec<f64>,
    pub energies: Vec<f64>,
    pub forces: Vec<f64>,
    pub creepages: Vec<f64>,
}

impl Measured {
    /// Returns the numbers of all steps of a scene.
    pub fn run(scene: &Scene, pose: &UnitTransform) -> Self {
        let mut history = scene.history(&scene.half_space(pose), pose);
        let mut measured = Self::default();
        for step in &scene.path {
            scene.take(&mut history, step, pose);
            measured.add(scene, pose, &history);
        }
        measured
    }

    pub fn groups(&self) -> [(&'static str, &[f64]); 5] {
        [
            ("pressures", &self.pressures),
            ("lengths", &self.lengths),
            ("energies", &self.energies),
            ("forces", &self.forces),
            ("creepages", &self.creepages),
        ]
    }

    /// Adds the samples of a field in its unit to a group.
    pub(super) fn add_field(
        &mut self,
        pose: &UnitTransform,
        group: impl Fn(&mut Self) -> &mut Vec<f64>,
        field: &Field,
        unit: f64,
    ) {
        let samples = pose.cells_back(field).into_iter();
        group(self).extend(samples.map(|value| value / unit));
    }

    /// Adds the samples of a vector field in its unit to a group.
    pub(super) fn add_vectors(
        &mut self,
        pose: &UnitTransform,
        group: impl Fn(&mut Self) -> &mut Vec<f64>,
        fields: [&Field; 2],
        unit: f64,
    ) {
        for (axis, field) in pose.swapped(fields).into_iter().enumerate() {
            let sign = pose.swapped(pose.signs)[axis] * pose.side();
            self.add_field(pose, &group, field, sign * unit);
        }
    }

    fn add(&mut self, scene: &Scene, pose: &UnitTransform, history: &History) {
        let step = history.last_step().unwrap();
        let (length, pressure) = (pose.length, pose.pressure);
        let energy = scene.energy_unit(pose);
        self.add_field(pose, |of| &mut of.pressures, history.pressure(), pressure);
        for field in [history.accumulated_slip(), step.slip_distance()] {
            self.add_field(pose, |of| &mut of.lengths, field, length);
        }
        self.add_field(pose, |of| &mut of.energies, step.dissipation(), energy);
        self.add_vectors(pose, |of| &mut of.pressures, history.traction(), pressure);
        for fields in [history.slip(), step.slip()] {
            self.add_vectors(pose, |of| &mut of.lengths, fields, length);
        }
        self.lengths.push(history.approach() / length);
        let vector = |vector: [f64; 2]| pose.back(vector).map(|value| pose.side() * value);
        self.lengths
            .extend(vector(history.shift()).map(|shift| shift / length));
        let force = vector(history.tangential_force());
        self.forces
            .extend(force.map(|force| force * length / energy));
        self.creepages
            .extend(vector(step.creepage().unwrap_or_default()));
        let balance = step.energy();
        let energies = [
            balance.work,
            balance.elastic_after,
            balance.dissipated_energy,
            balance.dissipated_energy_midpoint,
            pose.turn() * history.moment(),
        ];
        self.energies.extend(energies.map(|value| value / energy));
    }
}
