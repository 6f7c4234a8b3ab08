//! Contact conditions that every solution fulfils, checked on small random problems.

use kit::{Random, l2_difference};
use proptest::prelude::*;
use stickslip::{
    ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
    NormalSolution, TangentialLoad, TangentialProblem, TangentialSolution, Zone,
};

/// Parameters of a random contact. They cover odd, even and slender grids, smooth and noisy gaps, and any load.
#[derive(Debug, Clone)]
struct RandomContact {
    size: [usize; 2],
    sides: [f64; 2],
    poisson_ratio: f64,
    seed: u64,
    roughness: f64,
    /// Load relative to the contact modulus times the area.
    load: f64,
    /// Tangential force relative to the friction limit.
    fraction: f64,
}

fn random_contact() -> impl Strategy<Value = RandomContact> {
    (
        (1..20_usize, 1..20_usize, 0.3..3.0_f64),
        (0.0..0.5_f64, any::<u64>(), -4.0..-1.0_f64),
        // The bodies barely touch in one of ten cases. In one of ten cases the contact is close to gross slip.
        (
            prop_oneof![9 => -3.0..-0.5_f64, 1 => Just(-9.0)],
            prop_oneof![9 => -0.95..0.95_f64, 1 => Just(0.9999)],
        ),
    )
        .prop_map(
            |((nx, ny, dy), (poisson_ratio, seed, roughness), (load, fraction))| RandomContact {
                size: [nx, ny],
                sides: [1.0, dy],
                poisson_ratio,
                seed,
                roughness: 10_f64.powf(roughness),
                load: 10_f64.powf(load),
                fraction,
            },
        )
}

const FRICTION: f64 = 0.7;

/// Random contact in a given system of units.
struct TestProblem {
    bodies: HalfSpace,
    gap: Field,
    force: f64,
}

impl RandomContact {
    /// Creates the problem with lengths and pressures multiplied by the two units.
    fn to_units(&self, length: f64, pressure: f64) -> TestProblem {
        let [nx, ny] = self.size;
        let grid = Grid::new(nx, ny, self.sides[0] * length, self.sides[1] * length).unwrap();
        let body = Material::new(2.0 * pressure, self.poisson_ratio).unwrap();
        let bodies = HalfSpace::new(grid, ElasticPair::new(body, body).unwrap()).unwrap();
        let mut random = Random(self.seed);
        let extent = nx.max(ny) as f64;
        let gap = Field::from_fn(grid, |x, y| {
            let (x, y) = (x / length, y / length);
            let height = 0.05 * (x * x + 0.5 * y * y) / extent;
            length * (height + self.roughness * extent * random.uniform(0.0, 1.0))
        });
        let force = self.load * pressure * grid.area();
        TestProblem { bodies, gap, force }
    }
}

impl TestProblem {
    fn press(&self) -> NormalSolution {
        self.press_by(NormalLoad::Force(self.force))
    }

    fn press_by(&self, load: NormalLoad) -> NormalSolution {
        let builder = NormalProblem::builder(&self.bodies, &self.gap, load).tolerance(1e-11);
        kit::solve(builder)
    }

    fn shear(&self, normal: &NormalSolution, force: [f64; 2]) -> TangentialSolution {
        let friction = Friction::coulomb(FRICTION).unwrap();
        let load = TangentialLoad::force(force);
        let builder = TangentialProblem::builder(&self.bodies, normal, friction, load);
        kit::solve(builder.tolerance(1e-11))
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(22, 64)))]

    /// Pressures are not negative, bodies do not overlap, and no cell has both a pressure and a gap.
    #[test]
    fn normal_contact_is_complementary(case in random_contact()) {
        let problem = case.to_units(1.0, 1.0);
        let solution = problem.press();
        // Errors are relative to the largest displacement. The range of the gap is not a suitable scale, because it
        // does not depend on the contact.
        let gaps = solution.gap().as_slice().iter().zip(problem.gap.as_slice());
        let displacement = gaps.map(|(g, h)| g - (h - solution.approach())).fold(0.0, f64::max);
        let round_off = 1e-15 * (problem.gap.max() + solution.approach().abs());
        prop_assert!((solution.force() / problem.force - 1.0).abs() < 1e-12);
        for (p, g) in solution.pressure().as_slice().iter().zip(solution.gap().as_slice()) {
            prop_assert!(*p >= 0.0);
            prop_assert!(*g >= -1e-10 * displacement - round_off);
            prop_assert!(*p == 0.0 || g.abs() <= 1e-10 * displacement + round_off);
        }
    }

    /// Tractions stay within the friction limit, sticking cells do not slip, and slip opposes the traction and
    /// dissipates energy.
    #[test]
    fn tangential_contact_is_complementary(case in random_contact()) {
        let problem = case.to_units(1.0, 1.0);
        let normal = problem.press();
        let limit = FRICTION * problem.force;
        let solution = problem.shear(&normal, [case.fraction * limit, 0.0]);
        prop_assert!((solution.force()[0] - case.fraction * limit).abs() <= 1e-12 * limit);
        let fields = normal.pressure().as_slice().iter().zip(solution.traction()[0].as_slice());
        for ((p, q), (s, zone)) in fields.zip(solution.slip()[0].as_slice().iter().zip(solution.zones())) {
            match zone {
                Zone::Separated => prop_assert!(*p == 0.0 && *q == 0.0 && *s == 0.0),
                Zone::Stick => prop_assert!(q.abs() < FRICTION * p && *s == 0.0),
                Zone::Slip => {
                    prop_assert!((q.abs() / (FRICTION * p) - 1.0).abs() < 1e-15);
                    prop_assert!(q * s <= q.abs() * 1e-9 * solution.shift()[0].abs());
                }
            }
        }
        prop_assert!(solution.dissipated_energy() >= -1e-10 * limit * solution.shift()[0].abs());
    }

    /// A uniform offset of the gap changes the approach by the same amount and has no other effect.
    #[test]
    fn datum_of_gap_only_shifts_approach(case in random_contact(), lift in -10.0..10.0_f64) {
        let problem = case.to_units(1.0, 1.0);
        let samples = problem.gap.as_slice().iter().map(|h| h + lift).collect();
        let lifted = TestProblem {
            gap: Field::from_vec(problem.gap.grid(), samples).unwrap(),
            bodies: problem.bodies.clone(),
            ..problem
        };
        let (a, b) = (problem.press(), lifted.press());
        let scale = problem.gap.max() + a.approach().abs() + lift.abs();
        prop_assert!((b.approach() - a.approach() - lift).abs() < 1e-10 * scale);
        // The offset adds round-off to the gap. For the lightest contacts this round-off exceeds the approach itself.
        if case.load > 1e-6 {
            prop_assert!(l2_difference(b.pressure().as_slice(), a.pressure().as_slice()) < 1e-6);
        }
    }

    /// A larger force reduces the stick zone. For a Poisson's ratio of zero, the smaller stick zone is part of the
    /// larger one.
    #[test]
    fn stick_zone_shrinks_with_force(case in random_contact()) {
        let case = RandomContact { poisson_ratio: 0.0, ..case };
        let problem = case.to_units(1.0, 1.0);
        let normal = problem.press();
        let mut wider: Option<TangentialSolution> = None;
        for f in [0.0, 0.3, 0.6, 0.9, 1.0] {
            let solution = problem.shear(&normal, [f * FRICTION * normal.force(), 0.0]);
            if let Some(wider) = &wider {
                for (narrow, wide) in solution.zones().iter().zip(wider.zones()) {
                    prop_assert!(*narrow != Zone::Stick || *wide == Zone::Stick);
                }
                prop_assert!(solution.shift()[0] >= wider.shift()[0]);
            }
            wider = Some(solution);
        }
        prop_assert!(wider.unwrap().is_gross_slip());
    }

    /// A larger approach increases the force. The force is zero up to first touch.
    #[test]
    fn force_increases_with_approach(case in random_contact()) {
        let problem = case.to_units(1.0, 1.0);
        let span = problem.gap.max() - problem.gap.min() + 0.1;
        let mut last = 0.0;
        for approach in [-0.5, 0.0, 0.1, 0.3, 1.0, 3.0] {
            let solution = problem.press_by(NormalLoad::Approach(problem.gap.min() + approach * span));
            prop_assert!(solution.force() >= last);
            prop_assert_eq!(solution.force() > 0.0, approach > 0.0);
            last = solution.force();
        }
    }
}
