//! Many histories over one `HalfSpace` at once, on threads of the caller or within pools, come to the same
//! bits as each alone; so does one that is saved, restored and goes on on another thread.

use std::thread;

use kit::{rough, unit_bodies, unit_pair};
use stickslip::history::LoadPath;
use stickslip::{
    Axis, Boundary, Error, Field, Friction, Grid, HalfSpace, History, LoadStep, NormalControl,
    TangentialControl, TangentialModel, surface,
};

/// One history: where it starts from, and the loads it takes.
struct Course {
    gap: Field,
    friction: Friction,
    lateral: TangentialModel,
    steps: Vec<LoadStep>,
}

impl Course {
    fn history(&self, bodies: &HalfSpace) -> History {
        let builder = History::builder(bodies, &self.gap, self.friction.clone());
        builder.model(self.lateral).tolerance(1e-7).build().unwrap()
    }

    /// All that the history is and its last step did, in bits.
    fn run(&self, bodies: &HalfSpace) -> Vec<u8> {
        let mut history = self.history(bodies);
        go_on(&mut history, &self.steps);
        bits(&history)
    }
}

fn go_on(history: &mut History, steps: &[LoadStep]) {
    for step in steps {
        history.step(step).unwrap();
    }
}

fn bits(history: &History) -> Vec<u8> {
    let (mut bits, step) = (history.to_bytes(), history.last_step());
    let fields = [step.slip_distance(), step.dissipated_energy()];
    let samples = fields.into_iter().flat_map(Field::as_slice);
    let (energy, reports) = (
        step.energy(),
        [step.normal_report(), step.tangential_report()],
    );
    let counts = reports.map(|report| report.map_or(0, |report| report.double_precision_products));
    let scalars = [energy.work, energy.dissipated_energy, energy.residual];
    bits.extend(
        samples
            .chain(&scalars)
            .flat_map(|value| value.to_le_bytes()),
    );
    bits.extend(counts.iter().flat_map(|count| count.to_le_bytes()));
    bits
}

/// Different loads on different gaps, along an axis and in the plane.
fn courses(grid: Grid) -> Vec<Course> {
    let sphere = surface::sphere(grid, 40.0).unwrap();
    let path = |number: usize| {
        let amplitudes = [2.0, 1.5].map(|force| force * (1.0 - 0.1 * number as f64));
        match number % 2 {
            0 => LoadPath::sine([amplitudes[0], 0.0], 4),
            _ => LoadPath::ellipse(amplitudes, 0.4, 4),
        }
    };
    let course = |number: usize| {
        let is_in_plane = number % 2 == 1;
        let mut steps = vec![LoadStep::hold().normal(NormalControl::Force(6.0))];
        for [x, y] in path(number).unwrap().cycles(1) {
            let step = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(x));
            steps.push(if is_in_plane {
                step.tangential(Axis::Y, TangentialControl::Force(y))
            } else {
                step
            });
        }
        // A wider contact needs another window and other plans.
        steps.push(LoadStep::hold().normal(NormalControl::Force(20.0 + number as f64)));
        Course {
            gap: if number % 3 == 0 {
                sphere.clone()
            } else {
                rough(grid, number as u64)
            },
            friction: Friction::coulomb(0.4 + 0.02 * number as f64).unwrap(),
            lateral: if is_in_plane {
                TangentialModel::Vector
            } else {
                TangentialModel::Scalar
            },
            steps,
        }
    };
    (0..6).map(course).collect()
}

fn both_boundaries() -> [HalfSpace; 2] {
    let grid = Grid::new(36, 40, 0.7, 0.6).unwrap();
    [
        unit_bodies(grid, 0.3),
        HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap(),
    ]
}

/// Each on bodies of its own, which nobody else has prepared.
fn alone(bodies: &HalfSpace, courses: &[Course]) -> Vec<Vec<u8>> {
    let run = |course: &Course| {
        let own = HalfSpace::with_boundary(bodies.grid(), *bodies.pair(), bodies.boundary());
        course.run(&own.unwrap())
    };
    courses.iter().map(run).collect()
}

#[test]
fn on_threads_that_share_the_bodies() {
    for bodies in both_boundaries() {
        let courses = courses(bodies.grid());
        let expected = alone(&bodies, &courses);
        // All begin at once with bodies that have no operator yet.
        let together: Vec<_> = thread::scope(|scope| {
            let bodies = &bodies;
            let run = |course| scope.spawn(move || Course::run(course, bodies));
            let threads: Vec<_> = courses.iter().map(run).collect();
            threads
                .into_iter()
                .map(|thread| thread.join().unwrap())
                .collect()
        });
        assert!(together == expected);
    }
}

#[test]
fn restored_on_another_thread() {
    for bodies in both_boundaries() {
        let courses = courses(bodies.grid());
        for (course, expected) in courses.iter().zip(alone(&bodies, &courses)) {
            let mut history = course.history(&bodies);
            let (first, then) = course.steps.split_at(3);
            go_on(&mut history, first);
            let saved = history.to_bytes();
            // One is saved and restored, the other itself handed over.
            let elsewhere = bodies.clone();
            let restored = thread::scope(|scope| {
                let restored = scope.spawn(move || {
                    let mut restored = History::from_bytes(&elsewhere, &saved).unwrap();
                    go_on(&mut restored, then);
                    bits(&restored)
                });
                let handed_over = scope.spawn(move || {
                    go_on(&mut history, then);
                    bits(&history)
                });
                [restored, handed_over].map(|thread| thread.join().unwrap())
            });
            assert!(restored == [expected.clone(), expected]);
        }
    }
}

#[cfg(feature = "parallel")]
mod within_pools {
    use super::{Course, alone, both_boundaries, courses};
    use rayon::prelude::*;

    fn pool(threads: usize) -> rayon::ThreadPool {
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
        builder.build().unwrap()
    }

    #[test]
    fn of_one_thread_and_of_three() {
        for bodies in both_boundaries() {
            let courses = courses(bodies.grid());
            let expected = alone(&bodies, &courses);
            for threads in [1, 3] {
                // Tasks of the pool that wait for tasks of their own, and steal one another's.
                let run = || {
                    courses
                        .par_iter()
                        .map(|course| course.run(&bodies))
                        .collect()
                };
                let together: Vec<_> = pool(threads).install(run);
                assert!(together == expected, "{threads} threads");
            }
        }
    }

    #[test]
    fn within_a_pool() {
        for bodies in both_boundaries() {
            let courses = courses(bodies.grid());
            let expected = alone(&bodies, &courses);
            let inner = pool(1);
            let run = |course: &Course| inner.install(|| course.run(&bodies));
            let together: Vec<_> = pool(3).install(|| courses.par_iter().map(run).collect());
            assert!(together == expected);
        }
    }
}

#[test]
fn all_in_one_call() {
    for bodies in both_boundaries() {
        let courses = courses(bodies.grid());
        let expected = alone(&bodies, &courses);
        for threads in [1, 2, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            let mut histories: Vec<_> = courses.iter().map(|c| c.history(&bodies)).collect();
            pool.build().unwrap().install(|| {
                for step in 0..courses[0].steps.len() {
                    let loads: Vec<_> = courses.iter().map(|c| c.steps[step]).collect();
                    let failed = History::step_all(&mut histories, &loads).unwrap();
                    assert!(failed.is_empty(), "{failed:?}");
                }
            });
            let found: Vec<_> = histories.iter().map(bits).collect();
            assert!(found == expected, "{threads} threads");
        }
        let mut histories = vec![courses[0].history(&bodies)];
        let before = histories[0].to_bytes();
        assert!(matches!(
            History::step_all(&mut histories, &[]),
            Err(Error::Length {
                expected: 1,
                found: 0,
                ..
            })
        ));
        assert_eq!(histories[0].to_bytes(), before);
        assert!(History::step_all(&mut [], &[]).unwrap().is_empty());
    }
}
