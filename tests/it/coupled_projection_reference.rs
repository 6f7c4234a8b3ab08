//! Histories of dissimilar bodies compared with repeated projections onto Coulomb's cone. The reference uses dense
//! matrices, and neither active sets, nor Newton's method, nor Krylov spaces.

use kit::{Random, max_difference};
use rayon::prelude::*;
use stickslip::history::EntryRule;
use stickslip::influence::Direction::{X, Y, Z};
use stickslip::layers::Layer;
use stickslip::{
    Boundary, ElasticPair, Field, Grid, HalfSpace, History, LoadStep, Material, NormalLoad,
    Operator,
};

/// Pressures and tractions of all cells. The z component is the first.
type Tractions = Vec<[f64; 3]>;

/// Motion of the bodies in a step.
#[derive(Debug, Clone, Copy)]
struct Load {
    approach: f64,
    shift: [f64; 2],
    twist: f64,
}

/// A pair of bodies, its state after the last step, and its dense compliance.
struct ProjectionReference {
    grid: Grid,
    /// `matrix[i][j]` maps the tractions of cell j to the displacements of cell i.
    matrix: Vec<Vec<[[f64; 3]; 3]>>,
    step: f64,
    x: Tractions,
    /// Displacement minus rigid motion after the last step.
    behind: Vec<[f64; 2]>,
}

impl ProjectionReference {
    fn new(bodies: &HalfSpace) -> Self {
        let (grid, cells) = (bodies.grid(), bodies.grid().cells());
        let tensor = bodies.tensor_operator([Z, X, Y]).unwrap();
        let mut workspace = tensor.scratch().unwrap();
        let mut matrix = vec![vec![[[0.0; 3]; 3]; cells]; cells];
        for cell in 0..cells {
            for c in 0..3 {
                let mut unit = [(); 3].map(|()| vec![0.0; cells]);
                let mut moved = unit.clone();
                unit[c][cell] = 1.0;
                let out = moved.each_mut().map(Vec::as_mut_slice);
                tensor.apply(unit.each_ref().map(Vec::as_slice), out, &mut workspace);
                for i in 0..cells {
                    for (r, moved) in moved.iter().enumerate() {
                        matrix[i][cell][r][c] = moved[i];
                    }
                }
            }
        }
        let mut reference = Self {
            grid,
            matrix,
            step: 0.0,
            x: vec![[0.0; 3]; cells],
            behind: vec![[0.0; 2]; cells],
        };
        reference.step = 1.0 / reference.largest_eigenvalue();
        reference
    }

    fn displacement(&self, x: &Tractions) -> Tractions {
        let row = |row: &Vec<[[f64; 3]; 3]>| {
            let mut sum = [0.0; 3];
            for (block, x) in row.iter().zip(x) {
                for (sum, block) in sum.iter_mut().zip(block) {
                    *sum += block[0] * x[0] + block[1] * x[1] + block[2] * x[2];
                }
            }
            sum
        };
        self.matrix.iter().map(row).collect()
    }

    /// Returns a slight overestimate of the largest eigenvalue, from the power method.
    fn largest_eigenvalue(&self) -> f64 {
        let mut x: Tractions = (0..self.x.len())
            .map(|i| [1.0, 0.1 * (i % 3) as f64, 0.3])
            .collect();
        let mut size = 0.0;
        for _ in 0..100 {
            let u = self.displacement(&x);
            size = u.iter().flatten().map(|u| u * u).sum::<f64>().sqrt();
            x = u.iter().map(|u| u.map(|u| u / size)).collect();
        }
        1.1 * size
    }

    /// Takes a step by fixed-point iteration of the projection (de Saxce & Feng's bipotential).
    fn take_step(&mut self, gap: &Field, friction: f64, load: Load) {
        let grid = self.grid;
        let moved = |i: usize| {
            let (x, y) = (grid.x(i % grid.nx()), grid.y(i / grid.nx()));
            [
                load.shift[0] - load.twist * y,
                load.shift[1] + load.twist * x,
            ]
        };
        for _ in 0..400_000 {
            let u = self.displacement(&self.x);
            let (mut change, mut largest) = (0.0_f64, 0.0_f64);
            for (i, u) in u.iter().enumerate() {
                let (motion, behind) = (moved(i), self.behind[i]);
                let slip = [0, 1].map(|c| u[1 + c] - behind[c] - motion[c]);
                let opening = gap.as_slice()[i] + u[0] - load.approach;
                let [p, x, y] = self.x[i];
                let p = p - self.step * (opening + friction * slip[0].hypot(slip[1]));
                let q = [x - self.step * slip[0], y - self.step * slip[1]];
                let next = project_onto_cone(p, q, friction);
                for (next, last) in next.iter().zip(self.x[i]) {
                    change = change.max((next - last).abs());
                    largest = largest.max(next.abs());
                }
                self.x[i] = next;
            }
            if change <= 1e-14 * largest {
                break;
            }
        }
        let u = self.displacement(&self.x);
        for (i, behind) in self.behind.iter_mut().enumerate() {
            let motion = moved(i);
            *behind = [0, 1].map(|c| u[i][1 + c] - motion[c]);
        }
    }
}

/// Returns the nearest point of the cone `|q| <= friction p`.
fn project_onto_cone(p: f64, q: [f64; 2], friction: f64) -> [f64; 3] {
    let size = q[0].hypot(q[1]);
    if size <= friction * p {
        [p, q[0], q[1]]
    } else if friction * size <= -p {
        [0.0; 3]
    } else {
        let p = (p + friction * size) / (1.0 + friction * friction);
        [p, q[0] * friction * p / size, q[1] * friction * p / size]
    }
}

/// Checks a history of a random pair of bodies. They are pressed, sheared, twisted, unloaded and worn. The friction
/// coefficient is then changed, and they are pressed further. Body 1 has the given coating, if any.
fn assert_scene_agrees(scene: u64, coating: Option<Layer>) {
    let mut random = Random(scene);
    let (nx, ny) = (random.integer(2, 6), random.integer(3, 6));
    let grid = Grid::new(nx, ny, 1.0, random.decade(-0.6, 0.6)).unwrap();
    let body = |random: &mut Random| {
        let nu = random.uniform(0.0, 0.5);
        Material::new(random.decade(-0.5, 0.5), nu).unwrap()
    };
    let soft = body(&mut random);
    let pair = if random.chance(0.4) {
        ElasticPair::new(soft, Material::rigid())
    } else {
        ElasticPair::new(soft, body(&mut random))
    };
    let [one, two] = pair.unwrap().bodies();
    let one = one.coated(coating.as_slice()).unwrap();
    let pair = ElasticPair::new(one, two);
    let (boundary, is_free) = if random.chance(0.4) {
        (Boundary::Periodic, false)
    } else {
        (Boundary::NonPeriodic, true)
    };
    let bodies = HalfSpace::with_boundary(grid, pair.unwrap(), boundary).unwrap();
    let mut gap = Field::from_fn(grid, |x, y| {
        0.05 * (x * x + y * y) + 0.3 * random.uniform(0.0, 1.0)
    });
    let mut friction = random.decade(-1.3, 0.3);
    let builder = History::builder(&bodies, &gap, kit::coulomb(friction));
    let mut history = builder
        .entry_rule(EntryRule::WholeStep)
        .tolerance(1e-12)
        .build()
        .unwrap();
    let mut reference = ProjectionReference::new(&bodies);
    let depth = if is_free {
        1.0
    } else {
        0.7 * (gap.integral() / grid.area() - gap.min())
    };
    let (least, mut twist) = (gap.min(), 0.0);
    for number in 0..4 {
        if number == 3 {
            let worn = Field::from_fn(grid, |_, _| 0.02 * random.uniform(0.0, 1.0));
            gap.add_scaled(1.0, &worn).unwrap();
            friction *= random.uniform(0.7, 1.4);
            history.set_gap(&gap).unwrap();
            history.set_friction(&kit::coulomb(friction)).unwrap();
        }
        let part = [0.6, 0.8, 0.4, 1.0][number];
        let shift = |random: &mut Random| depth * random.uniform(-0.3, 0.3);
        let load = Load {
            approach: least + depth * part * random.uniform(0.6, 1.0),
            shift: [shift(&mut random), shift(&mut random)],
            twist: if is_free {
                random.uniform(-0.05, 0.05)
            } else {
                0.0
            },
        };
        twist = if number == 1 { load.twist } else { twist };
        let load = Load { twist, ..load };
        let step = LoadStep::shift(load.shift)
            .twist(load.twist)
            .normal(NormalLoad::Approach(load.approach));
        history.step(&step).unwrap();
        reference.take_step(&gap, friction, load);
        let largest = history.pressure().max();
        let [x, y] = history.traction();
        for (c, field) in [history.pressure(), x, y].into_iter().enumerate() {
            let expected: Vec<f64> = reference.x.iter().map(|x| x[c]).collect();
            let error = max_difference(field.as_slice(), &expected) / largest;
            assert!(error < 1e-8, "{scene} {number} {c}: {error:e}");
        }
    }
}

#[test]
fn histories_match_cone_projections() {
    (0..kit::thorough(8, 100))
        .into_par_iter()
        .for_each(|scene| assert_scene_agrees(scene, None));
}

/// Coatings are softer and stiffer than the substrate, and thinner and thicker than the cells.
#[test]
fn coated_histories_match_cone_projections() {
    (0..kit::thorough(6_u8, 16))
        .into_par_iter()
        .for_each(|scene| {
            let (modulus, thickness) = ([0.1, 0.5, 3.0, 10.0], [0.2, 0.6, 2.0]);
            let (n, m) = (usize::from(scene) % 4, usize::from(scene) % 3);
            let coating = Layer::new(modulus[n], 0.1 * f64::from(scene % 5), thickness[m]).unwrap();
            assert_scene_agrees(u64::from(scene), Some(coating));
        });
}
