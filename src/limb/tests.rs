//! Limbs of any measures to random targets and along paths, against searches that know nothing of the closed form.

use super::*;

/// Random numbers from a seed (SplitMix64).
struct Random(u64);

impl Random {
    /// From 0 to 1.
    fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.part()
    }

    fn vector(&mut self, size: f64) -> DVec3 {
        DVec3::new(self.between(-size, size), self.between(-size, size), self.between(-size, size))
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let vector = self.vector(1.0);
            if (0.01..1.0).contains(&vector.length()) {
                return vector.normalize();
            }
        }
    }

    fn rotation(&mut self) -> DQuat {
        DQuat::from_axis_angle(self.direction(), self.between(-PI, PI))
    }

    /// A limb of any measures. Some have bones across the hinge as robots do, some one side of the range, some no length.
    fn limb(&mut self) -> Limb {
        let axis = self.direction();
        let (mut upper, mut lower) =
            (self.direction() * self.between(0.1, 2.0), self.direction() * self.between(0.1, 2.0));
        match (self.part() * 8.0) as u32 {
            0 => return Limb::free(upper, lower, axis),
            1 => return Limb::free(upper, upper * self.between(0.5, 2.0), axis),
            2 | 3 => {
                upper = axis.any_orthonormal_vector() * upper.length();
                lower = upper * self.between(0.5, 1.5);
            }
            4 => lower = DVec3::ZERO,
            5 if self.part() < 0.3 => upper = DVec3::ZERO,
            _ => {}
        }
        let low = self.between(-PI, PI * 0.9);
        Limb { upper, lower, axis, range: [low, self.between(low, PI)] }
    }

    fn stance(&mut self, limb: &Limb) -> Stance {
        Stance { root: self.rotation(), angle: self.between(limb.range[0], limb.range[1]) }
    }
}

fn check_whole(limb: &Limb, stance: Stance) {
    assert!(stance.root.is_finite() && (stance.root.length() - 1.0).abs() < 1e-9, "{limb:?}: {stance:?}");
    assert!((limb.range[0]..=limb.range[1]).contains(&stance.angle), "{limb:?}: {stance:?}");
}

/// The smallest and the largest distance, by looking at many angles.
fn distances_seen(limb: &Limb) -> [f64; 2] {
    const STEPS: u32 = 20_000;
    let [low, high] = limb.range;
    let distance = |step: u32| {
        let angle = low + (high - low) * f64::from(step) / f64::from(STEPS);
        (limb.upper + DQuat::from_axis_angle(limb.axis, angle) * limb.lower).length()
    };
    (0..=STEPS).map(distance).fold([f64::MAX, 0.0], |[least, most], found| [least.min(found), most.max(found)])
}

#[test]
fn targets_are_met_or_the_nearest_point_that_bones_and_range_allow() {
    let mut random = Random(1);
    for _ in 0..250 {
        let limb = random.limb();
        let [least, most] = distances_seen(&limb);
        for _ in 0..400 {
            let from = random.stance(&limb);
            let target = random.vector(2.0) * random.part();
            let stance = limb.reach(from, target);
            check_whole(&limb, stance);
            let off = limb.end(stance).distance(target);
            let least_off = (target.length() - target.length().clamp(least, most)).abs();
            assert!(off <= least_off + 1e-4, "{limb:?} from {from:?} to {target}: {off} off, not {least_off}");
        }
    }
}

/// A search knows nothing of the closed form: it tries turns of both joints, smaller and smaller ones.
#[test]
fn a_search_finds_no_nearer_point() {
    let mut random = Random(2);
    let mut met = 0;
    for _ in 0..400 {
        let limb = random.limb();
        let target = random.vector(2.0);
        let off = |stance: Stance| limb.end(stance).distance(target);
        let reached = off(limb.reach(random.stance(&limb), target));
        let mut best = f64::MAX;
        for _ in 0..3 {
            let mut stance = random.stance(&limb);
            let mut step = 1.0;
            for _ in 0..700 {
                let root = DQuat::from_axis_angle(random.direction(), random.between(-step, step)) * stance.root;
                let angle = (stance.angle + random.between(-step, step)).clamp(limb.range[0], limb.range[1]);
                let tried = Stance { root, angle };
                if off(tried) < off(stance) {
                    stance = tried;
                } else {
                    step = f64::max(step * 0.98, 1e-4);
                }
            }
            best = best.min(off(stance));
        }
        assert!(reached <= best + 1e-6, "{limb:?} to {target}: {reached} off, and a search finds {best}");
        met += usize::from(best - reached < 0.01);
    }
    assert!(met > 380, "the search is worth nothing: it met {met} of 400");
}

/// The stances along a path, each from the one before.
fn follow(limb: &Limb, mut stance: Stance, path: impl Fn(f64) -> DVec3, steps: u32) -> Vec<Stance> {
    let step = |step: u32| {
        stance = limb.reach(stance, path(f64::from(step) / f64::from(steps)));
        check_whole(limb, stance);
        stance
    };
    (0..=steps).map(step).collect()
}

fn middle(limb: &Limb, stance: Stance) -> DVec3 {
    stance.root * limb.upper
}

#[test]
fn paths_through_the_straight_limb_are_continuous_and_keep_the_plane() {
    let mut random = Random(3);
    for index in 0..1000 {
        let upper = random.direction() * random.between(0.5, 1.5);
        let lower = random.direction() * random.between(0.5, 1.5);
        let across = upper.normalize().any_orthonormal_vector();
        let limb = match index % 3 {
            0 => Limb::free(upper, lower, across),
            1 => Limb::free(upper, upper * 0.8, across),
            _ => Limb { upper, lower: upper * 0.9, axis: across, range: [0.0, 2.6] },
        };
        let [least, most] = limb.distances();
        // From within reach to beyond it and back, in a plane that goes by the root joint.
        let (side, ahead) = (random.direction(), random.direction());
        let near = most * random.between(0.5, 0.9) + least * 0.1;
        let path = |part: f64| {
            let out = (part * PI).sin() * most * 1.5;
            ahead * (near + out) + side * (0.3 * most * (part * TAU).sin())
        };
        let start = limb.reach(random.stance(&limb), path(0.0));
        let stances = follow(&limb, start, path, 1500);
        let jumps = stances.windows(2).map(|pair| {
            let turned = pair[0].root.angle_between(pair[1].root);
            middle(&limb, pair[0]).distance(middle(&limb, pair[1])).max(turned)
        });
        // Near the straight limb the bend goes as the root of the distance: 0.15 is what a step of the path may come to.
        let largest = jumps.fold(0.0, f64::max);
        assert!(largest < 0.15, "path {index}, {limb:?}: a jump by {largest}");
        let is_bent_to_its_side = |stance: &Stance| (stance.angle - limb.straight_angle()).sin() >= -1e-9;
        assert!(stances.iter().all(is_bent_to_its_side), "path {index}: the limb bends to the other side");
        let off = limb.end(stances[1500]).distance(path(1.0));
        assert!(off < 1e-6, "path {index}, {limb:?}: it comes back {off} off");
    }
}

#[test]
fn a_target_that_passes_the_root_joint_keeps_the_plane() {
    let mut random = Random(4);
    for _ in 0..1000 {
        let upper = random.direction() * random.between(0.5, 1.5);
        let limb = Limb::free(upper, random.direction() * upper.length(), DVec3::Y);
        let from = random.stance(&limb);
        let ahead = limb.end(from).normalize();
        // What rounding or a hand does beside the line.
        let beside = random.direction() * 1e-7;
        let stances = follow(&limb, from, |part| ahead * (0.8 - 1.6 * part) + beside, 101);
        for stance in stances {
            let normal = stance.root * limb.axis;
            let turned = normal.dot(from.root * limb.axis).abs().min(1.0).acos();
            assert!(turned < 1e-3, "{limb:?}: its plane turned by {turned}");
        }
    }
}

#[test]
fn a_swivel_keeps_the_end_and_facing_turns_the_last_node_least() {
    let mut random = Random(5);
    for _ in 0..500 {
        let limb = random.limb();
        let from = random.stance(&limb);
        if limb.end(from).length() < 1e-3 {
            continue;
        }
        let turned = limb.swivelled(from, random.between(-7.0, 7.0)).unwrap();
        assert!(limb.end(turned).distance(limb.end(from)) < 1e-9);
        let (last_in_upper, wanted) = (random.rotation(), random.rotation());
        let last = |stance: Stance| stance.root * DQuat::from_axis_angle(limb.axis, stance.angle) * last_in_upper;
        let off = |stance: Stance| last(stance).dot(wanted).abs().min(1.0).acos();
        let least = off(limb.facing(from, last_in_upper, wanted));
        for step in 0..90 {
            let tried = limb.swivelled(from, f64::from(step) * TAU / 90.0).unwrap();
            assert!(least <= off(tried) + 1e-9, "{limb:?}: {least} off, and {step} is {}", off(tried));
        }
    }
    let nowhere = Limb { upper: DVec3::ZERO, lower: DVec3::ZERO, axis: DVec3::X, range: [0.0, 1.0] };
    let from = Stance { root: DQuat::IDENTITY, angle: 0.5 };
    assert_eq!(nowhere.swivelled(from, 1.0), None);
    assert_eq!(nowhere.reach(from, DVec3::ONE), from);
}
