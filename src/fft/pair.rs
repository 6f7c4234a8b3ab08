//! Two tractions and two displacements at once: products with the tensor of the lateral coefficients.

use crate::fft::convolution::padded;
use crate::fft::length::smooth_length;
use crate::fft::plan::{Buffers, ColumnScratch, ColumnTask, Plan, blocks};
use crate::fft::real::Real;
use crate::fft::single::largest_magnitude;
use crate::fft::spectrum::{PairSpectrum, Spectrum};
use crate::fft::tiles::{self, TILE_COLUMNS, exchange};
use crate::influence::{Symbols, Table};
use crate::operator::Operator;
use crate::parallel;

/// `(u_x, u_y)` of every cell from the tractions `(q_x, q_y)` of all cells: one transform each way for
/// each component. Fields lie one behind the other, x first.
#[derive(Debug, Clone)]
pub(crate) struct PairConvolution {
    plan: Plan<f64>,
    spectrum: PairSpectrum<f64>,
    single: SinglePair,
    lower_bound: f64,
}

/// Where the spectra of the three components `xx`, `yy` and `xy` come from.
pub(crate) enum PairSource<'a> {
    /// Free surroundings: tables, on any window.
    Tables([&'a Table; 3]),
    /// A grid that repeats.
    Symbols([Symbols; 3]),
}

impl PairSource<'_> {
    fn spectrum(&self, torus: [usize; 2]) -> PairSpectrum<f64> {
        let [xx, yy, xy] = match self {
            Self::Tables(tables) => tables.map(|table| Spectrum::of_table(table, torus)),
            Self::Symbols(symbols) => [0, 1, 2].map(|k| Spectrum::of_symbols(&symbols[k])),
        };
        PairSpectrum { xx, yy, xy }
    }

    fn is_periodic(&self) -> bool {
        matches!(self, Self::Symbols(_))
    }
}

impl PairConvolution {
    /// On `[nx, ny]` cells.
    pub(crate) fn new(size: [usize; 2], source: &PairSource<'_>) -> Self {
        let torus = if source.is_periodic() {
            size
        } else {
            padded(size)
        };
        let spectrum = source.spectrum(torus);
        let [low, high] = spectrum.extremes(source.is_periodic());
        let normalisation = 1.0 / (torus[0] * torus[1]) as f64;
        Self {
            plan: Plan::new(size, torus),
            single: SinglePair::new(size, torus, &spectrum),
            spectrum: spectrum.map(|tensor| tensor.map(|value| value * normalisation)),
            // What the transform itself rounds off is taken from the bound; a single cell that repeats
            // has no wave to be bounded.
            lower_bound: if low.is_finite() {
                (low - 1e-14 * high).max(0.0)
            } else {
                0.0
            },
        }
    }
}

/// Buffers of products with a tensor.
#[derive(Debug, Clone)]
pub(crate) struct PairWorkspace {
    double: [Buffers<f64>; 2],
    single: Option<PairSingleWorkspace>,
}

/// Buffers of products in single precision.
#[derive(Debug, Clone)]
pub(crate) struct PairSingleWorkspace([Buffers<f32>; 2]);

impl Operator for PairConvolution {
    type Workspace = PairWorkspace;

    fn len(&self) -> usize {
        2 * self.plan.nx * self.plan.ny
    }

    fn workspace(&self) -> PairWorkspace {
        PairWorkspace {
            double: [self.plan.workspace(), self.plan.workspace()],
            single: None,
        }
    }

    fn apply(&self, x: &[f64], out: &mut [f64], workspace: &mut PairWorkspace) {
        convolve(
            &self.plan,
            &self.spectrum,
            x,
            out,
            [1.0; 2],
            &mut workspace.double,
        );
    }

    fn apply_roughly(&self, x: &[f64], out: &mut [f64], workspace: &mut PairWorkspace) {
        let buffers = workspace
            .single
            .get_or_insert_with(|| self.single.workspace());
        self.single.apply(x, out, buffers);
    }

    fn lower_bound(&self) -> f64 {
        self.lower_bound
    }
}

/// The inverse of the nearest periodic tensor, in single precision: a preconditioner.
#[derive(Debug, Clone)]
pub(crate) struct PairInverse {
    single: SinglePair,
}

impl PairInverse {
    /// With eigenvalues below `floor` raised to it.
    pub(crate) fn new(size: [usize; 2], source: &PairSource<'_>, floor: f64) -> Self {
        let torus = if source.is_periodic() {
            size
        } else {
            size.map(smooth_length)
        };
        let spectrum = source.spectrum(torus);
        let [_, high] = spectrum.extremes(false);
        // A single cell that repeats has no wave but the mean: anything will do.
        let high = if high > 0.0 { high } else { 1.0 };
        let floor = floor.max(1e-12 * high);
        let inverse = spectrum.map(|tensor| inverted(tensor, floor, high));
        Self {
            single: SinglePair::new(size, torus, &inverse),
        }
    }
}

/// Inverse of a symmetric tensor `[xx, yy, xy]`, its eigenvalues raised to a floor; a tensor of zeros, the
/// mean of a grid that repeats, weighs as much as the largest.
fn inverted([xx, yy, xy]: [f64; 3], floor: f64, high: f64) -> [f64; 3] {
    if xx == 0.0 && yy == 0.0 {
        return [1.0 / high.max(floor), 1.0 / high.max(floor), 0.0];
    }
    let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
    let radius = half.hypot(xy);
    let [low, large] = [mean - radius, mean + radius].map(|value| 1.0 / value.max(floor));
    let (centre, spread) = (0.5 * (low + large), 0.5 * (large - low));
    let [cosine, sine] = if radius > 0.0 {
        [half / radius, xy / radius]
    } else {
        [0.0, 0.0]
    };
    [
        centre + spread * cosine,
        centre - spread * cosine,
        spread * sine,
    ]
}

impl Operator for PairInverse {
    type Workspace = PairSingleWorkspace;

    fn len(&self) -> usize {
        2 * self.single.plan.nx * self.single.plan.ny
    }

    fn workspace(&self) -> PairSingleWorkspace {
        self.single.workspace()
    }

    fn apply(&self, x: &[f64], out: &mut [f64], workspace: &mut PairSingleWorkspace) {
        self.single.apply(x, out, workspace);
    }
}

/// Plan and spectra in single precision, scaled to values about one.
#[derive(Debug, Clone)]
struct SinglePair {
    plan: Plan<f32>,
    spectrum: PairSpectrum<f32>,
    scale: f64,
}

impl SinglePair {
    fn new(size: [usize; 2], torus: [usize; 2], spectrum: &PairSpectrum<f64>) -> Self {
        let largest = spectrum.largest_component();
        let scale = if largest > 0.0 { largest } else { 1.0 };
        Self {
            plan: Plan::new(size, torus),
            spectrum: spectrum.map(|tensor| tensor.map(|value| value / scale)),
            scale: scale / (torus[0] * torus[1]) as f64,
        }
    }

    fn workspace(&self) -> PairSingleWorkspace {
        PairSingleWorkspace([self.plan.workspace(), self.plan.workspace()])
    }

    fn apply(&self, x: &[f64], out: &mut [f64], buffers: &mut PairSingleWorkspace) {
        let largest = largest_magnitude(x);
        if largest.is_normal() {
            let scales = [1.0 / largest, largest * self.scale];
            convolve(&self.plan, &self.spectrum, x, out, scales, &mut buffers.0);
        } else {
            // Nothing, or nothing that could be scaled; a broken input stays broken.
            let is_nothing = x.iter().all(|x| x.abs() < f64::MIN_POSITIVE);
            out.fill(if is_nothing { 0.0 } else { f64::NAN });
        }
    }
}

/// `out = inverse(spectrum * forward(x))` of two fields.
fn convolve<T: Real>(
    plan: &Plan<T>,
    spectrum: &PairSpectrum<T>,
    x: &[f64],
    out: &mut [f64],
    scales: [f64; 2],
    buffers: &mut [Buffers<T>; 2],
) {
    let cells = plan.nx * plan.ny;
    assert!(
        x.len() == 2 * cells && out.len() == 2 * cells,
        "fields must be those of the {} x {} cells of the operator, x then y",
        plan.nx,
        plan.ny
    );
    for (x, buffers) in x.chunks_exact(cells).zip(&mut *buffers) {
        let Buffers {
            by_rows,
            occupied,
            by_columns,
            row_scratch,
            ..
        } = buffers;
        plan.forward_rows(x, scales[0], by_rows, occupied, row_scratch);
        exchange(by_rows, by_columns, plan.tiles_across());
    }
    columns(plan, spectrum, buffers);
    for (out, buffers) in out.chunks_exact_mut(cells).zip(buffers) {
        let Buffers {
            by_rows,
            by_columns,
            row_scratch,
            ..
        } = buffers;
        exchange(by_columns, by_rows, plan.tiles_down());
        plan.inverse_rows(by_rows, out, scales[1], row_scratch);
    }
}

fn columns<T: Real>(plan: &Plan<T>, spectrum: &PairSpectrum<T>, buffers: &mut [Buffers<T>; 2]) {
    let [first, second] = buffers;
    let (stride, tasks) = (plan.column_stride(), first.column_scratch.len());
    let (band, per_task) = (plan.tiles_down(), plan.tiles_across().div_ceil(tasks));
    let occupied = [&first.occupied[..], &second.occupied[..]];
    let part = |tiles, scratch| (blocks(tiles, per_task * band), blocks(scratch, 1));
    let data = (
        part(&mut first.by_columns, &mut first.column_scratch),
        part(&mut second.by_columns, &mut second.column_scratch),
    );
    let work = |task: usize, (x, y): (ColumnTask<'_, T>, ColumnTask<'_, T>)| {
        let ColumnScratch {
            columns: columns_x,
            transform,
        } = &mut x.1.items[0];
        let ColumnScratch {
            columns: columns_y, ..
        } = &mut y.1.items[0];
        let bands =
            x.0.items
                .chunks_exact_mut(band)
                .zip(y.0.items.chunks_exact_mut(band));
        for (index, (tiles_x, tiles_y)) in bands.enumerate() {
            let first = (task * per_task + index) * TILE_COLUMNS;
            tiles::gather(tiles_x, occupied[0], columns_x, stride);
            tiles::gather(tiles_y, occupied[1], columns_y, stride);
            let pairs = columns_x
                .chunks_exact_mut(stride)
                .zip(columns_y.chunks_exact_mut(stride));
            for (c, (x, y)) in pairs.take(plan.width() - first).enumerate() {
                let (x, y) = (plan.waves_of(x, transform), plan.waves_of(y, transform));
                spectrum.multiply(first + c, [&mut *x, &mut *y]);
                plan.column_inverse.process_with_scratch(x, transform);
                plan.column_inverse.process_with_scratch(y, transform);
            }
            tiles::scatter(columns_x, stride, tiles_x);
            tiles::scatter(columns_y, stride, tiles_y);
        }
    };
    parallel::sweep(0..tasks, data, &work, &|(), ()| ());
}
