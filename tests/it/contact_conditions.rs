//! Monotonic dependence of solutions on their loads, and independence of the datum, for small random problems.

use kit::{Random, l2_difference};
use proptest::prelude::*;
use stickslip::{
    Field, Grid, HalfSpace, NormalLoad, NormalSolution, TangentialLoad, TangentialSolution, Zone,
};

/// A random contact on an odd, even or slender grid, with a smooth or noisy gap.
#[derive(Debug, Clone)]
struct RandomContact {
    bodies: HalfSpace,
    gap: Field,
    /// Load relative to the contact modulus times the area.
    load: f64,
}

fn random_contact(poisson_ratio: f64) -> impl Strategy<Value = RandomContact> {
    let grid = (1..20_usize, 1..20_usize, 0.3..3.0_f64);
    // The bodies barely touch in one of ten cases.
    let load = prop_oneof![9 => -3.0..-0.5_f64, 1 => Just(-9.0)];
    (grid, 0.0..0.5_f64, any::<u64>(), -4.0..-1.0_f64, load).prop_map(
        move |((nx, ny, dy), part, seed, roughness, load)| {
            let grid = Grid::new(nx, ny, 1.0, dy).unwrap();
            let bodies = HalfSpace::new(grid, kit::alike(2.0, poisson_ratio * part / 0.5)).unwrap();
            let (mut random, extent) = (Random(seed), nx.max(ny) as f64);
            let gap = Field::from_fn(grid, |x, y| {
                let noise = 10_f64.powf(roughness) * extent * random.uniform(0.0, 1.0);
                0.05 * (x * x + 0.5 * y * y) / extent + noise
            });
            let load = 10_f64.powf(load);
            RandomContact { bodies, gap, load }
        },
    )
}

const FRICTION: f64 = 0.7;

impl RandomContact {
    fn press(&self) -> NormalSolution {
        self.press_by(NormalLoad::Force(self.load * self.gap.grid().area()))
    }

    fn press_by(&self, load: NormalLoad) -> NormalSolution {
        kit::press(&self.bodies, &self.gap, load, 1e-11)
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(22, 64)))]

    /// A uniform offset of the gap changes the approach by the same amount and has no other effect.
    #[test]
    fn datum_of_gap_only_shifts_approach(case in random_contact(0.5), lift in -10.0..10.0_f64) {
        let lifted = RandomContact { gap: case.gap.map(|h| h + lift), ..case.clone() };
        let (a, b) = (case.press(), lifted.press());
        let scale = case.gap.max() + a.approach().abs() + lift.abs();
        prop_assert!((b.approach() - a.approach() - lift).abs() < 1e-10 * scale);
        // The offset adds round-off to the gap. For the lightest contacts this round-off exceeds the approach itself.
        if case.load > 1e-6 {
            prop_assert!(l2_difference(b.pressure().as_slice(), a.pressure().as_slice()) < 1e-6);
        }
    }

    /// A larger force reduces the stick zone. For a Poisson's ratio of zero, the smaller stick zone is part of the
    /// larger stick zone.
    #[test]
    fn stick_zone_shrinks_with_force(case in random_contact(0.0)) {
        let (normal, friction) = (case.press(), kit::coulomb(FRICTION));
        let mut wider: Option<TangentialSolution> = None;
        for f in [0.0, 0.3, 0.6, 0.9, 1.0] {
            let load = TangentialLoad::force([f * FRICTION * normal.force(), 0.0]);
            let solution = kit::shear(&case.bodies, &normal, &friction, load, 1e-11);
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
    fn force_increases_with_approach(case in random_contact(0.5)) {
        let span = case.gap.max() - case.gap.min() + 0.1;
        let mut last = 0.0;
        for approach in [-0.5, 0.0, 0.1, 0.3, 1.0, 3.0] {
            let solution = case.press_by(NormalLoad::Approach(case.gap.min() + approach * span));
            prop_assert!(solution.force() >= last);
            prop_assert_eq!(solution.force() > 0.0, approach > 0.0);
            last = solution.force();
        }
    }
}
