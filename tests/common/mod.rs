//! Random linkages that are closed at a home pose, from a fixed seed.
#![allow(dead_code, reason = "every test and bench uses its own part")]

pub mod golden;

use std::f64::consts::{FRAC_PI_2, PI};
use synthetica::math::pose::{FrameCoordinates, Pose};
use synthetica::model::chain::Chain;
use synthetica::model::dh::DhRow;
use synthetica::model::joint::{Joint, JointKind};
use synthetica::model::mechanism::Mechanism;
use synthetica::motion::goal::Goal;
use synthetica::types::enumerate;

/// SplitMix64: a few lines, and the same numbers everywhere.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn below(&mut self, n: usize) -> usize {
        let below = self.bits() % n as u64;
        usize::try_from(below).expect("below a usize")
    }

    pub fn pose(&mut self, length: f64, angle: f64) -> Pose {
        FrameCoordinates {
            x: self.between(-length, length),
            y: self.between(-length, length),
            z: self.between(-length, length),
            longitude: self.between(-angle, angle),
            latitude: self.between(-angle, angle),
            roll: self.between(-angle, angle),
        }
        .pose()
    }
}

/// A linkage and joint values that close it.
pub struct Linkage {
    pub mechanism: Mechanism,
    pub home: Vec<f64>,
}

/// A chain of these joints with random links, its base placed so that it holds the workpiece at
/// `home`, and its joint values there. Twists are multiples of 30° and 45° half of the time, so that
/// parallel, perpendicular and intersecting axes occur.
pub fn chain(kinds: &[JointKind], home: &Pose, random: &mut Random) -> (Chain, Vec<f64>) {
    let mut joints = Vec::new();
    let mut values = Vec::new();
    for (i, &kind) in kinds.iter().enumerate() {
        let mut rows = Joint::standard(kind).rows().to_vec();
        for row in rows.iter_mut().skip(1) {
            row.alpha = if random.below(2) == 0 {
                FRAC_PI_2
            } else {
                -FRAC_PI_2
            };
        }
        if i > 0 {
            let twists = [0.0, PI / 6.0, PI / 4.0, PI / 3.0, FRAC_PI_2, -FRAC_PI_2];
            rows[0].alpha = if random.below(2) == 0 {
                twists[random.below(6)]
            } else {
                random.between(-PI, PI)
            };
            rows[0].a = if random.below(4) == 0 {
                0.0
            } else {
                random.between(0.1, 0.8)
            };
        }
        rows[0] = DhRow {
            theta: random.between(-PI, PI),
            d: random.between(-0.3, 0.3),
            ..rows[0]
        };
        let joint = Joint::new(kind, rows, vec![]).expect("rows of the kind");
        joints.push(joint);
    }
    let gripper = random.pose(0.5, PI);
    let unplaced =
        Chain::new("free".into(), Pose::identity(), joints.clone(), gripper).expect("a chain");
    for turns in unplaced.turns() {
        values.push(if turns {
            random.between(-PI, PI)
        } else {
            random.between(-0.4, 0.8)
        });
    }
    let base = home * unplaced.pose(&values).inverse();
    (
        Chain::new("placed".into(), base, joints, gripper).expect("a chain"),
        values,
    )
}

/// Chains of the given kinds around one workpiece.
pub fn linkage(kinds: &[Vec<JointKind>], random: &mut Random) -> Linkage {
    let home_pose = random.pose(1.0, PI);
    let mut chains = Vec::new();
    let mut home = Vec::new();
    for kinds in kinds {
        let (chain, values) = chain(kinds, &home_pose, random);
        chains.push(chain);
        home.extend(values);
    }
    Linkage {
        mechanism: Mechanism::new(chains).expect("a mechanism"),
        home,
    }
}

/// Every chain type of Table 2 once, each with random partners that leave it a freedom or more by
/// count.
pub fn assemblies(random: &mut Random) -> Vec<Vec<Vec<JointKind>>> {
    let mut all = Vec::new();
    for constraints in 1..=4 {
        for k in 0..enumerate::chain_count(constraints) {
            let mut chains = vec![enumerate::chain(constraints, k).expect("an index in range")];
            let mut left = 5 - constraints;
            while left > 0 && random.below(4) > 0 {
                let u = 1 + random.below(left.min(4));
                let k = random.bits() % enumerate::chain_count(u);
                chains.push(enumerate::chain(u, k).expect("an index in range"));
                left -= u;
            }
            all.push(chains);
        }
    }
    all
}

/// Goals from the home pose to a random one beside it and on to another, in `frames` steps: as a
/// rule off the workspace.
pub fn goals(linkage: &Linkage, frames: usize, random: &mut Random) -> Vec<Goal> {
    let home = linkage.mechanism.chains()[0].pose(&linkage.home);
    let ends = [random.pose(0.4, 0.5), random.pose(0.6, 0.7)].map(|step| step * home);
    (0..frames)
        .map(|i| {
            let s = 2.0 * i as f64 / (frames - 1) as f64;
            let (a, b, s) = if s <= 1.0 {
                (&home, &ends[0], s)
            } else {
                (&ends[0], &ends[1], s - 1.0)
            };
            let rotation = a.rotation.nlerp(&b.rotation, s);
            let translation = a.translation.vector.lerp(&b.translation.vector, s);
            Goal {
                time: i as f64,
                pose: Pose::from_parts(translation.into(), rotation),
            }
        })
        .collect()
}
