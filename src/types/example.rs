//! A linkage of any type, such as 3RPS or RPS+2TS: chains of those joints around a workpiece, closed at its start,
//! well proportioned, with the mobility that its type has whatever the dimensions.
//!
//! The links are chosen by a few rules of thumb, which keep common shapes recognisable. Where they make a linkage special
//! (more mobile than its type, or nearly so), dimensions, joint values and base angles are varied until it is not. What
//! closes the loops is the gripper frame, H = (G K(θ))⁻¹ D, which can be had for every chain.

use crate::math::pose::{FrameCoordinates, Pose};
use crate::model::chain::Chain;
use crate::model::joint::JointKind;
use crate::model::mechanism::Mechanism;
use crate::model::scaled::Scaled;
use crate::solve::singular_values::SingularValues;
use crate::solve::tangent::Tangent;
use crate::types::enumerate::letters;
use crate::types::leg::{LENGTHS, LINKS, Leg, Variation, base, links, rounded};
use crate::types::mobility::{chain_singular_values, generic_mobility, mobility};

/// How far the workpiece is above the ends of the chains.
const RISE: f64 = 0.3;

/// Shortest and longest gripper, the arm from the last joint to the workpiece, in units of the base circle's radius.
const GRIPPERS: (f64, f64) = (0.2, 1.5);
/// Lowest and highest workpiece, in the same units.
const HEIGHTS: (f64, f64) = (0.3, 2.0);

/// Smallest singular value of the loop equations wanted at the start, in units of the mechanism's size: three times the
/// bound below which a position is reported as nearly singular, so that a motion has room around the start.
pub(crate) const FAR_FROM_SINGULAR: f64 = 3e-2;
/// Smallest singular value wanted of one chain's Jacobian, in units of the base circle's radius: no joint must turn more
/// than ten times as fast as the workpiece.
pub(crate) const INDEPENDENT_JOINTS: f64 = 0.1;

/// Variations of one chain, and of the assembly of all, before the best of them is taken. Of all chains four in five need
/// none and the rest at most 60; of the tests' assemblies two in three need none and one in a hundred more than about 40.
const CHAIN_ATTEMPTS: u32 = 200;
const ASSEMBLY_ATTEMPTS: u32 = 300;
/// Variations of an assembly in which chains of one type keep equal links.
const EQUAL_LEGS: u32 = 16;

/// A linkage and what it is to do.
#[derive(Clone, Debug)]
pub struct Example {
    /// The linkage.
    pub mechanism: Mechanism,
    /// Joint values that close it, rad or lengths.
    pub start: Vec<f64>,
    /// Where the workpiece is at the start, and where it is to go.
    pub key_frames: [Pose; 2],
}

/// A linkage of these chains. The same chains give the same linkage.
///
/// # Panics
/// When the kinds do not make a mechanism: no chain or too many, a chain without joints or with more than
/// five freedoms.
pub fn example(kinds: &[Vec<JointKind>]) -> Example {
    let mut legs: Vec<Leg> = Vec::new();
    for (i, kind) in kinds.iter().enumerate() {
        let equal = kinds[..i].iter().position(|before| before == kind);
        let leg = equal.map_or_else(|| well_shaped(kind), |equal| legs[equal].clone());
        legs.push(leg);
    }
    let ranks: Vec<usize> = legs.iter().map(|leg| leg.rank).collect();
    let wanted = generic_mobility(kinds);
    best(ASSEMBLY_ATTEMPTS, |attempt| {
        let mut variation = Variation::new(attempt);
        variation.links_too = attempt > EQUAL_LEGS;
        let varied: Vec<Leg> = legs.iter().map(|leg| variation.leg(leg)).collect();
        let example = assembled(&varied);
        let quality = example.quality(wanted, &ranks);
        (quality, example)
    })
}

/// The first of the attempts whose quality is 1, or the best.
pub(crate) fn best<T>(attempts: u32, make: impl Fn(u32) -> (f64, T)) -> T {
    let mut best = make(0);
    for attempt in 1..attempts {
        if best.0 >= 1.0 {
            break;
        }
        let next = make(attempt);
        if next.0 > best.0 {
            best = next;
        }
    }
    best.1
}

/// A leg of these joints that is well proportioned, and whose joints do not depend on each other.
pub(crate) fn well_shaped(kinds: &[JointKind]) -> Leg {
    let plain = Leg::plain(kinds);
    best(CHAIN_ATTEMPTS, |attempt| {
        let mut variation = Variation::new(attempt);
        variation.links_too = true;
        let leg = variation.leg(&plain);
        let alone = assembled(std::slice::from_ref(&leg));
        (alone.shape(&[leg.rank]), leg)
    })
}

/// The legs around their workpiece, each with its gripper.
fn assembled(legs: &[Leg]) -> Example {
    let many = legs.len();
    let start: Vec<f64> = legs.iter().flat_map(|leg| leg.start.clone()).collect();
    let chain = |i: usize, gripper: Pose| {
        let kinds = legs[i].kinds();
        let name = format!("{} {}", letters(&kinds), i + 1);
        let around = 360.0 * i as f64 / many as f64 + legs[i].turn;
        let base = base(kinds[0], around);
        Chain::new(name, base, legs[i].joints.clone(), gripper).expect("freedoms of a chain")
    };
    let ends: Vec<Pose> = (0..many)
        .map(|i| chain(i, Pose::identity()).pose(&legs[i].start))
        .collect();
    let height = ends.iter().map(|end| end.translation.z).sum::<f64>() / many as f64;
    let begin = Pose::translation(0.0, 0.0, rounded(height + RISE, LENGTHS));
    let chains = ends
        .iter()
        .enumerate()
        .map(|(i, end)| chain(i, end.inverse() * begin));
    let away = FrameCoordinates {
        x: 0.2,
        y: 0.1,
        z: 0.15,
        latitude: 12_f64.to_radians(),
        longitude: 0.0,
        roll: 20_f64.to_radians(),
    };
    Example {
        mechanism: Mechanism::new(chains.collect()).expect("chains of a mechanism"),
        start,
        key_frames: [begin, begin * away.pose()],
    }
}

impl Example {
    /// How good the start is: 1 where nothing is wrong, less where it is nearly singular, least where it is out of
    /// proportion, 0 where the linkage is more mobile than its type.
    fn quality(&self, mobility_of_type: usize, ranks: &[usize]) -> f64 {
        if mobility(&self.mechanism, &self.start) != mobility_of_type {
            return 0.0;
        }
        let scaled = Scaled::new(&self.mechanism, 1.0);
        let theta = scaled.entered(&self.start);
        // Equations that repeat others in every linkage of the type.
        let repeated = mobility_of_type.saturating_add_signed(-self.mechanism.mobility_count());
        let mut tangent = Tangent::new(scaled.chains());
        tangent.evaluate(scaled.chains(), &theta);
        let sigma = SingularValues::default().smallest(tangent.jacobians(), repeated);
        self.shape(ranks).min(sigma / FAR_FROM_SINGULAR)
    }

    /// The same of the chains by themselves: their proportion, and how far their joints are from depending on each other.
    fn shape(&self, ranks: &[usize]) -> f64 {
        /// What is out of proportion is worse than what is a hundred times nearer to singular than wanted.
        const OUT_OF_PROPORTION: f64 = 0.01;
        let proportion = self.proportion();
        if proportion < 1.0 {
            return OUT_OF_PROPORTION * proportion;
        }
        let least = self
            .mechanism
            .split(&self.start)
            .zip(ranks)
            .map(|((chain, theta), &rank)| chain_singular_values(chain, theta)[rank - 1]);
        least.fold(1.0, |least: f64, sigma| {
            least.min(sigma / INDEPENDENT_JOINTS)
        })
    }

    /// 1 for links and grippers that can be read in a drawing, else how much too short or too long the worst is.
    fn proportion(&self) -> f64 {
        let within = |x: f64, (least, most): (f64, f64)| (x / least).min(most / x).min(1.0);
        let mut worst = within(self.key_frames[0].translation.z, HEIGHTS);
        for (chain, theta) in self.mechanism.split(&self.start) {
            worst = worst.min(within(chain.gripper().translation.vector.norm(), GRIPPERS));
            for length in links(chain, theta) {
                worst = worst.min(within(length, LINKS));
            }
        }
        worst.max(0.0)
    }
}
