//! A rough surface that several ranks press and shear together. The example prints the report and a hash of the bits of pressure
//! and traction, which does not depend on the number of ranks.
//!
//! `cargo run --release -p stickslip-examples --example distributed -- [cells] [--press] [--threads-as-ranks N]` (default 256
//! cells along a side, pressed and sheared, two ranks as threads). With the feature `mpi` the ranks are processes:
//! `mpirun -n 4 target/release/examples/distributed 1024`. With `--press` the surface is not sheared, which reduces the memory
//! to a fifth. With `--history FILE` the example computes twenty steps with wear instead. All ranks save the history to the file
//! after ten steps. `--from FILE` continues from this file on any number of ranks and yields the same hash.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod history;

use std::error::Error;
use std::sync::Arc;
use std::time::{Duration, Instant};

use stickslip::ranks::{Ranks, Threads};
use stickslip::surface::SelfAffine;
use stickslip::{
    Boundary, ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
    NormalSolution, Report, TangentialLoad, TangentialModel, TangentialProblem, TangentialSolution,
};

use history::{Saved, fret};

/// Side of the grid, in units of the longest wavelength.
const SIDE: f64 = 1.0;
/// Mean pressure divided by the contact modulus and the rms slope. About a tenth of the surface is in contact.
const REDUCED_PRESSURE: f64 = 0.05;
const FRICTION: f64 = 0.4;
/// Tangential force as a fraction of the friction limit.
const SHEAR: f64 = 0.6;
/// Time for which a rank waits for the others.
const PATIENCE: Duration = Duration::from_secs(600);

type Outcome<T> = Result<T, Box<dyn Error + Send + Sync>>;

struct Arguments {
    cells: usize,
    /// Whether the surface is pressed only.
    is_pressed_alone: bool,
    /// File of the history with wear, if a history is requested.
    saved: Option<Saved>,
    /// Number of threads, if ranks are threads.
    threads: Option<usize>,
}

impl Arguments {
    fn read() -> Outcome<Self> {
        let mut read = Self {
            cells: 256,
            is_pressed_alone: false,
            saved: None,
            threads: None,
        };
        let mut words = std::env::args().skip(1);
        while let Some(word) = words.next() {
            if word == "--threads-as-ranks" {
                let count = words.next().ok_or("--threads-as-ranks needs a number")?;
                read.threads = Some(count.parse()?);
            } else if word == "--press" {
                read.is_pressed_alone = true;
            } else if word == "--history" || word == "--from" {
                let file = words.next();
                let file = file.ok_or("--history and --from need a file")?.into();
                let saved = if word == "--from" {
                    Saved::From
                } else {
                    Saved::To
                };
                read.saved = Some(saved(file));
            } else {
                read.cells = word.parse()?;
            }
        }
        Ok(read)
    }
}

fn main() -> Outcome<()> {
    let arguments = Arguments::read()?;
    #[cfg(feature = "mpi")]
    if arguments.threads.is_none() {
        let work = |rank| {
            let rank: Arc<dyn Ranks> = Arc::new(rank);
            solve(&arguments, &rank)
        };
        return stickslip::ranks::Mpi::run(PATIENCE, work)?;
    }
    let ranks = arguments.threads.unwrap_or(2);
    let outcomes = Threads::run(ranks, PATIENCE, |rank| {
        let rank: Arc<dyn Ranks> = Arc::new(rank);
        solve(&arguments, &rank)
    });
    outcomes.into_iter().collect()
}

/// Solves the problem on every rank. The first rank prints the results.
fn solve(arguments: &Arguments, ranks: &Arc<dyn Ranks>) -> Outcome<()> {
    let start = Instant::now();
    let grid = Grid::square(arguments.cells, SIDE)?;
    let pair = ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?;
    let bodies = HalfSpace::distributed(grid, pair, Boundary::Periodic, Arc::clone(ranks))?;
    let rough = SelfAffine::with_rms_slope(0.1)
        .cut_off_wavelength(8.0 * grid.dx())
        .seed(1);
    let heights = rough.generate_on(&bodies)?;
    let pressure = REDUCED_PRESSURE * 0.1 * pair.contact_modulus();
    let force = pressure * grid.area();
    if let Some(saved) = &arguments.saved {
        let hash = fret(&bodies, &heights.map(|z| -z), force, saved, &**ranks)?;
        if ranks.rank() == 0 {
            println!("hash {hash:016x}");
        }
        return Ok(());
    }
    let load = NormalLoad::Force(force);
    let normal = NormalProblem::builder(&bodies, heights.map(|z| -z), load)
        .build()?
        .solve()?;
    let tangential = if arguments.is_pressed_alone {
        None
    } else {
        Some(sheared(&bodies, &normal)?)
    };
    let mut fields = vec![normal.pressure()];
    fields.extend(tangential.iter().flat_map(TangentialSolution::traction));
    let hash = hash_of_all(&**ranks, &fields)?;
    if ranks.rank() == 0 {
        let traffic = bodies.traffic();
        println!(
            "{} x {} cells on {} ranks, {:.1} s",
            grid.nx(),
            grid.ny(),
            ranks.size(),
            start.elapsed().as_secs_f64()
        );
        println!("  rows of rank 0    {:?}", bodies.grid().rows());
        println!(
            "  contact area      {:.4} of the area",
            normal.contact_area() / grid.area()
        );
        print_report("pressure", normal.report());
        if let Some(tangential) = &tangential {
            let stick = tangential.stick_ratio();
            println!("  stick ratio       {stick:.4}");
            print_report("traction", tangential.report());
        }
        println!(
            "  sent by rank 0    {} blocks, {:.1} MB; {} partial results gathered",
            traffic.blocks,
            traffic.bytes as f64 / 1e6,
            traffic.gathers
        );
        println!("hash {hash:016x}");
    }
    Ok(())
}

/// Computes the shear traction under the given pressure.
fn sheared(bodies: &HalfSpace, normal: &NormalSolution) -> Outcome<TangentialSolution> {
    let force = SHEAR * FRICTION * normal.force();
    let load = TangentialLoad::force([0.8 * force, 0.6 * force]);
    let problem = TangentialProblem::builder(bodies, normal, Friction::coulomb(FRICTION)?, load)
        .model(TangentialModel::Vector)
        .build()?;
    Ok(problem.solve()?)
}

fn print_report(what: &str, report: &Report) {
    println!(
        "  {what}          {:?}, {} iterations, {} + {} products, residual {:.1e}, error <= {:.1e}",
        report.status,
        report.iterations,
        report.double_precision_products,
        report.single_precision_products,
        report.residual,
        report.energy_error_bound()
    );
}

/// Computes a hash of the fields of all ranks that does not depend on the distribution of the rows.
fn hash_of_all(ranks: &dyn Ranks, fields: &[&Field]) -> Outcome<u64> {
    let mut own = 0_u64;
    for (field, number) in fields.iter().zip(1_u64..) {
        let first = field.grid().rows().start * field.grid().nx();
        for (cell, value) in (first as u64..).zip(field.as_slice()) {
            own = own.wrapping_add(mixed(value.to_bits() ^ mixed(cell ^ (number << 56))));
        }
    }
    let (rank, size) = (ranks.rank(), ranks.size());
    let mut all = own;
    for step in 1..size {
        let others = ranks.swap(vec![own], (rank + step) % size, (rank + size - step) % size)?;
        all = others.into_iter().fold(all, u64::wrapping_add);
    }
    Ok(all)
}

/// Applies the finaliser of splitmix64 (Steele, Lea & Flood 2014).
fn mixed(bits: u64) -> u64 {
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}
