//! After the first cycle, a step of a history within its window allocates no buffer, plan or spectrum. A stiffness in
//! existing buffers, a change of the gap or the friction, a wear law, and the accumulation of a cycle do not allocate
//! such memory either.

use std::ops::ControlFlow;

use kit::{rough, unit_bodies};
use stickslip::history::{Cycle, FrettingLoop, LoadPath, Rolling, wear};
use stickslip::stiffness::StiffnessWorkspace;
use stickslip::{
    Axis, Coupling, ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalLoad, TangentialControl, TangentialModel, surface,
};

/// Counts the allocations of the current thread. The steps must run on this thread.
fn allocations(mut work: impl FnMut() + Send) -> u64 {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    pool.install(|| allocation_counter::measure(&mut work))
        .count_total
}

fn assert_no_allocations(gap: &Field, load: f64, lateral: TangentialModel) {
    let grid = gap.grid();
    let bodies = unit_bodies(grid, 0.3);
    let friction = [0.4, 0.5].map(|mu| Friction::per_cell(Field::constant(grid, mu)).unwrap());
    let builder = History::builder(&bodies, gap, friction[0].clone()).tolerance(1e-6);
    let mut history = builder.model(lateral).build().unwrap();
    let spring = TangentialControl::Spring {
        position: 0.1,
        stiffness: 0.2 * load,
    };
    let dragged = LoadStep::hold().tangential(Axis::X, spring);
    // The last load is supported by only one of the models.
    let last = match lateral {
        TangentialModel::Scalar => dragged,
        _ => dragged
            .tangential(Axis::Y, TangentialControl::Force(-0.2 * load))
            .twist(1e-3),
    };
    let (mut worn, mut depth) = (gap.clone(), Field::zeros(grid));
    let mut total = Cycle::new(&history);
    let path = LoadPath::triangle([0.3 * load, 0.0], 8).unwrap();
    let fretting = FrettingLoop::new(path, LoadStep::force);
    let mut stiffness = StiffnessWorkspace::new();
    let mut cycle = || {
        let along = |tangential| LoadStep::hold().tangential(Axis::X, tangential);
        for (part, step) in [
            (1.0, LoadStep::hold()),
            (0.95, along(TangentialControl::Force(0.3 * load))),
            (0.9, along(TangentialControl::Force(-0.3 * load))),
            (0.9, along(TangentialControl::Shift(0.0))),
            (1.0, last),
        ] {
            history.set_friction(&friction[0]).unwrap();
            history
                .step(&step.normal(NormalLoad::Force(part * load)))
                .unwrap();
            let slope = history.stiffness_with(&mut stiffness, |_| ControlFlow::Continue(()));
            assert!(slope.unwrap().normal.value > 0.0);
            history.set_friction(&friction[1]).unwrap();
            history.step(&step).unwrap();
            let slip = history.last_step().unwrap().slip_distance();
            wear::archard(1e-4, history.pressure(), slip, &mut worn).unwrap();
            let energy = history.last_step().unwrap().dissipation();
            wear::energy(1e-4, energy, &mut depth).unwrap();
            let so_far = history.accumulated_dissipation();
            wear::threshold_energy(1e-4, 1.0, so_far, energy, &mut depth).unwrap();
            history.set_gap(&worn).unwrap();
        }
        fretting.cycle(&mut history, &mut total).unwrap();
        worn.add_scaled(1e-6, total.dissipation()).unwrap();
        worn.as_mut_slice().copy_from_slice(gap.as_slice());
        history.set_gap(&worn).unwrap();
    };
    // All buffers have their final size after three cycles. In the vector model one of the buffers still grows in the
    // third cycle.
    for _ in 0..3 {
        cycle();
    }
    assert_eq!(allocations(&mut cycle), 0);
}

#[test]
fn history_of_sphere_and_rough_surface_allocates_nothing() {
    let grid = Grid::square(kit::thorough(48, 96), 100.0).unwrap();
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        assert_no_allocations(&surface::sphere(grid, 300.0).unwrap(), 20.0, lateral);
        assert_no_allocations(&rough(grid, 4), 30.0, lateral);
    }
}

/// A rolling sphere under an oscillating load, with entering cells.
#[test]
fn rolling_history_allocates_nothing() {
    let grid = Grid::square(96, 100.0).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let ball = surface::sphere(grid, 300.0).unwrap();
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let builder = History::builder(&bodies, &ball, Friction::coulomb(0.4).unwrap());
        let mut history = builder.model(model).tolerance(1e-6).build().unwrap();
        let rolling = Rolling::new(1).creepage([0.02, 0.0]);
        let mut cycle = || {
            for part in [1.0, 0.9, 0.9, 1.0] {
                let press = LoadStep::hold().normal(NormalLoad::Force(20.0 * part));
                history.step(&press.roll(rolling)).unwrap();
                let drag = press.tangential(Axis::X, TangentialControl::Force(part));
                history.step(&drag.roll(Rolling::new(2))).unwrap();
            }
        };
        for _ in 0..3 {
            cycle();
        }
        assert_eq!(allocations(&mut cycle), 0);
    }
}

/// Dissimilar bodies with full and one-way coupling.
#[test]
fn history_of_dissimilar_bodies_allocates_nothing() {
    for coupling in [Coupling::Full, Coupling::OneWay] {
        assert_coupling_allocates_nothing(coupling);
    }
}

fn assert_coupling_allocates_nothing(coupling: Coupling) {
    let grid = Grid::new(40, 36, 0.1, 0.1).unwrap();
    let (soft, hard) = (Material::new(1.0, 0.1).unwrap(), Material::rigid());
    let bodies = HalfSpace::new(grid, ElasticPair::new(soft, hard).unwrap()).unwrap();
    let gap = surface::sphere(grid, 10.0).unwrap();
    let builder = History::builder(&bodies, &gap, Friction::coulomb(0.4).unwrap());
    let mut history = builder.coupling(coupling).tolerance(1e-6).build().unwrap();
    let mut worn = gap.clone();
    let mut stiffness = StiffnessWorkspace::new();
    let press = |force| LoadStep::hold().normal(NormalLoad::Force(force));
    let mut cycle = || {
        for (force, shear) in [(0.1, 0.0), (0.1, 0.02), (0.1, -0.02), (0.08, 0.01)] {
            let drag = TangentialControl::Force(shear);
            history
                .step(&press(force).tangential(Axis::X, drag))
                .unwrap();
            let slope = history.stiffness_with(&mut stiffness, |_| ControlFlow::Continue(()));
            assert!(slope.unwrap().normal.value > 0.0);
            let slip = history.last_step().unwrap().slip_distance();
            wear::archard(1e-5, history.pressure(), slip, &mut worn).unwrap();
            history.set_gap(&worn).unwrap();
        }
    };
    for _ in 0..3 {
        cycle();
    }
    assert_eq!(allocations(&mut cycle), 0);
}

/// The first cycle finds the largest window, and the contact of the next cycle grows and shrinks within this window. A
/// batch of contacts is covered as well.
#[test]
fn contact_growing_within_cycle_allocates_nothing() {
    let grid = Grid::square(64, 100.0).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let gap = surface::sphere(grid, 300.0).unwrap();
    let builder = History::builder(&bodies, &gap, Friction::coulomb(0.4).unwrap());
    let mut contacts = vec![builder.tolerance(1e-6).build().unwrap(); 3];
    let mut cycle = || {
        for part in [0.1, 0.3, 0.6, 1.0, 0.7, 0.3, 0.1] {
            let press = LoadStep::hold().normal(NormalLoad::Force(20.0 * part));
            let drag = |force| press.tangential(Axis::X, TangentialControl::Force(force));
            let loads = [2.0, 1.0, -2.0].map(|force| drag(force * part));
            assert!(History::step_all(&mut contacts, &loads).unwrap().is_empty());
        }
    };
    // Both cycles run on one thread. With several sets of buffers, the first cycle might not have used each set for
    // every purpose.
    assert!(allocations(&mut cycle) > 0);
    assert_eq!(allocations(&mut cycle), 0);
}

/// The contact alternates between two sizes, one of which is at least twice the other. The buffers of both sizes are
/// kept.
#[test]
fn contact_shrinking_and_growing_allocates_nothing() {
    let grid = Grid::square(kit::thorough(64, 96), 96.0).unwrap();
    let gap = surface::sphere(grid, 1000.0).unwrap();
    let (soft, hard) = (Material::new(1.0, 0.1).unwrap(), Material::rigid());
    let dissimilar = HalfSpace::new(grid, ElasticPair::new(soft, hard).unwrap()).unwrap();
    let similar = unit_bodies(grid, 0.3);
    for (bodies, model) in [
        (&similar, TangentialModel::Scalar),
        (&similar, TangentialModel::Vector),
        (&dissimilar, TangentialModel::Vector),
    ] {
        let builder = History::builder(bodies, &gap, Friction::coulomb(0.4).unwrap());
        let mut history = builder.model(model).tolerance(1e-6).build().unwrap();
        let mut cycle = || {
            for radius in [30.0_f64, 8.0] {
                let approach = radius * radius / 1000.0;
                let press = LoadStep::hold().normal(NormalLoad::Approach(approach));
                for part in [0.1, -0.1, 0.2, 0.0] {
                    let drag = TangentialControl::Shift(part * approach);
                    history.step(&press.tangential(Axis::X, drag)).unwrap();
                }
            }
        };
        for _ in 0..4 {
            cycle();
        }
        assert_eq!(allocations(&mut cycle), 0);
    }
}

/// A return to a state whose contact is at a different position, in a window of the same size, reuses the buffers.
#[test]
fn contact_at_different_position_allocates_nothing() {
    let grid = Grid::square(96, 96.0).unwrap();
    let (soft, hard) = (Material::new(1.0, 0.1).unwrap(), Material::rigid());
    let dissimilar = HalfSpace::new(grid, ElasticPair::new(soft, hard).unwrap()).unwrap();
    let similar = unit_bodies(grid, 0.3);
    let press = LoadStep::hold().normal(NormalLoad::Approach(0.1));
    let drag = |part: f64| press.tangential(Axis::X, TangentialControl::Shift(0.1 * part));
    for bodies in [&similar, &dissimilar] {
        let mut histories = [-20.0, 20.0].map(|centre: f64| {
            let gap = Field::from_fn(grid, |x, y| ((x - centre).powi(2) + y * y) / 2000.0);
            let builder = History::builder(bodies, &gap, Friction::coulomb(0.4).unwrap());
            let mut history = builder.tolerance(1e-6).build().unwrap();
            for part in [0.0, 0.1, -0.1] {
                history.step(&drag(part)).unwrap();
            }
            history
        });
        let [history, other] = &mut histories;
        let elsewhere = || {
            history.set_state(other.state()).unwrap();
            history.step(&drag(0.1)).unwrap();
        };
        assert_eq!(allocations(elsewhere), 0);
    }
}
