//! A linkage of any type, such as 3RPS or RPS+2TS: chains of those joints around a workpiece, closed at its start,
//! well proportioned, with the mobility that its type has whatever the dimensions.
//!
//! The links are chosen by a few rules of thumb, which keep common shapes recognisable. Where they make a linkage special
//! (more mobile than its type, or nearly so), dimensions, joint values and base angles are varied until it is not. What
//! closes the loops is the gripper frame, H = (G K(θ))⁻¹ D, which can be had for every chain.

use crate::math::pose::{FrameCoordinates, Pose};
use crate::math::random::Random;
use crate::model::chain::{Chain, MAX_FREEDOMS};
use crate::model::joint::{Joint, JointKind};
use crate::model::mechanism::{MAX_CHAINS, Mechanism};
use crate::model::scaled::Scaled;
use crate::solve::singular_values::SingularValues;
use crate::solve::tangent::Tangent;
use crate::types::enumerate::letters;
use crate::types::mobility::{chain_singular_values, generic_mobility, generic_rank, mobility};

/// Length of a link in legs of few and of many links; the bases stand on a circle of radius 1, and legs of both are about
/// as long as that.
const LINK: f64 = 0.7;
const SHORT_LINK: f64 = 0.5;
/// Links of a leg from which on they are the short ones.
const MANY_LINKS: usize = 3;
/// How far the workpiece is above the ends of the chains.
const RISE: f64 = 0.3;

/// Shortest and longest link of a drawing that can be read, in units of the base circle's radius.
const LINKS: (f64, f64) = (0.3, 1.5);
/// The same of a gripper, the arm from the last joint to the workpiece.
const GRIPPERS: (f64, f64) = (0.2, 1.5);
/// Lowest and highest workpiece, in the same units.
const HEIGHTS: (f64, f64) = (0.3, 2.0);

/// Smallest singular value of the loop equations wanted at the start, in units of the mechanism's size: three times the
/// bound below which a position is reported as nearly singular, so that a motion has room around the start.
const FAR_FROM_SINGULAR: f64 = 3e-2;
/// Smallest singular value wanted of one chain's Jacobian, in units of the base circle's radius: no joint must turn more
/// than ten times as fast as the workpiece.
const INDEPENDENT_JOINTS: f64 = 0.1;

/// Variations of one chain, and of the assembly of all, before the best of them is taken. Of all chains four in five need
/// none and the rest at most 60; of the tests' assemblies two in three need none and one in a hundred more than 42.
const CHAIN_ATTEMPTS: u32 = 200;
const ASSEMBLY_ATTEMPTS: u32 = 300;
/// Variations by which the amount grows from none to its full range.
const GROWTH: u32 = 12;
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

/// A text that names no type of linkage.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoType {
    /// The part of the text that is none.
    pub text: String,
}

/// The chains that a type names: counts and joint letters from base to workpiece, with + or blanks between.
///
/// # Errors
/// Where the text is no type.
pub fn chains_of(text: &str) -> Result<Vec<Vec<JointKind>>, NoType> {
    let no_type = |text: &str| NoType {
        text: text.to_owned(),
    };
    let mut chains = Vec::new();
    for term in text
        .split(|c: char| c == '+' || c.is_whitespace())
        .filter(|term| !term.is_empty())
    {
        let joints = term.trim_start_matches(|c: char| c.is_ascii_digit());
        let count = &term[..term.len() - joints.len()];
        let count = if count.is_empty() {
            Some(1)
        } else {
            count.parse().ok()
        };
        let kinds: Option<Vec<JointKind>> = joints
            .chars()
            .map(|c| {
                JointKind::ALL
                    .into_iter()
                    .find(|kind| kind.letter() == c.to_ascii_uppercase())
            })
            .collect();
        let kinds = kinds.filter(|kinds| {
            (1..=MAX_FREEDOMS).contains(&kinds.iter().map(|kind| kind.freedoms()).sum())
        });
        let (Some(count @ 1..=MAX_CHAINS), Some(kinds)) = (count, kinds) else {
            return Err(no_type(term));
        };
        chains.extend(std::iter::repeat_n(kinds, count));
    }
    if (1..=MAX_CHAINS).contains(&chains.len()) {
        Ok(chains)
    } else {
        Err(no_type(text))
    }
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
fn best<T>(attempts: u32, make: impl Fn(u32) -> (f64, T)) -> T {
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

/// A chain's joints with their links, its joint values at the start, and the turn of its base about the vertical from its
/// place on the circle, degrees.
#[derive(Clone, Debug)]
struct Leg {
    joints: Vec<Joint>,
    start: Vec<f64>,
    turn: f64,
    /// Independent joints in any dimensions.
    rank: usize,
}

/// A leg of these joints that is well proportioned, and whose joints do not depend on each other.
fn well_shaped(kinds: &[JointKind]) -> Leg {
    let plain = Leg {
        joints: joints(kinds),
        start: start(kinds),
        turn: 0.0,
        rank: generic_rank(kinds),
    };
    best(CHAIN_ATTEMPTS, |attempt| {
        let mut variation = Variation::new(attempt);
        variation.links_too = true;
        let leg = variation.leg(&plain);
        let alone = assembled(std::slice::from_ref(&leg));
        (
            alone.chain_quality(&[leg.rank]).min(alone.proportion()),
            leg,
        )
    })
}

/// The legs around their workpiece, each with its gripper.
fn assembled(legs: &[Leg]) -> Example {
    let many = legs.len();
    let start: Vec<f64> = legs.iter().flat_map(|leg| leg.start.clone()).collect();
    let chain = |i: usize, gripper: Pose| {
        let kinds: Vec<JointKind> = legs[i].joints.iter().map(Joint::kind).collect();
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
    /// How good the start is: 1 or more where nothing is wrong, 0 where the linkage is more mobile than its type.
    fn quality(&self, mobility_of_type: usize, ranks: &[usize]) -> f64 {
        if mobility(&self.mechanism, &self.start) != mobility_of_type {
            return 0.0;
        }
        let proportion = self.proportion().min(self.chain_quality(ranks));
        let scaled = Scaled::new(&self.mechanism, 1.0);
        let theta = scaled.entered(&self.start);
        // Equations that repeat others in every linkage of the type.
        let repeated = mobility_of_type.saturating_add_signed(-self.mechanism.mobility_count());
        let mut tangent = Tangent::new(scaled.chains());
        tangent.evaluate(scaled.chains(), &theta);
        let sigma = SingularValues::default().smallest(tangent.jacobians(), repeated);
        proportion.min(sigma / FAR_FROM_SINGULAR)
    }

    /// How far the joints of each chain are from depending on each other, 1 or more where that is enough.
    fn chain_quality(&self, ranks: &[usize]) -> f64 {
        let least = self
            .mechanism
            .split(&self.start)
            .zip(ranks)
            .map(|((chain, theta), &rank)| chain_singular_values(chain, theta)[rank - 1]);
        least.fold(f64::INFINITY, f64::min) / INDEPENDENT_JOINTS
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

/// The lengths of a chain's links at the joint values `theta`, slides included: from each joint to the next, and of a
/// slider at the end to its own end. A slider may begin at the centre of the joint before it; there is no link between.
///
/// # Panics
/// When `theta` is shorter than the chain's freedoms.
pub fn links(chain: &Chain, theta: &[f64]) -> Vec<f64> {
    let frames = chain.frames(theta);
    let joints = chain.joints();
    let mut row = 0;
    let mut lengths = Vec::new();
    for (i, joint) in joints.iter().enumerate() {
        let seat = frames[row].0.translation.vector;
        row += joint.rows().len();
        let slides = joint.kind() == JointKind::P;
        let next = match joints.get(i + 1) {
            Some(next) if next.kind() == JointKind::P && next.rows()[0].a == 0.0 && !slides => None,
            Some(_) => Some(frames[row].0),
            None => slides.then(|| frames[row - 1].1),
        };
        lengths.extend(next.map(|next| (next.translation.vector - seat).norm()));
    }
    lengths
}

/// The base frame on the circle, its first axis along the circle so that the leg swings towards the middle; a slider that
/// comes first stands upright. `around` is in degrees.
fn base(first: JointKind, around: f64) -> Pose {
    let (sine, cosine) = libm::sincos(around.to_radians());
    // x inwards, and y upwards or z upwards: X(±90°) of the frame that is turned about the vertical.
    let upright = FrameCoordinates {
        roll: (around + 180.0).to_radians(),
        ..FrameCoordinates::default()
    };
    let tilt = if first == JointKind::P {
        0.0
    } else {
        -90.0_f64
    };
    let tilted = FrameCoordinates {
        latitude: tilt.to_radians(),
        ..FrameCoordinates::default()
    };
    Pose::translation(cosine, sine, 0.0) * upright.pose() * tilted.pose()
}

/// The joints with links before them: turning axes follow each other in parallel pairs, so that legs bend like knees;
/// a slider goes square to the axis before it, and the axis behind it is parallel to that again. What would lie in the
/// plane of a planar joint, or repeat a plane that has its three freedoms, leans out of it.
fn joints(kinds: &[JointKind]) -> Vec<Joint> {
    use JointKind::{C, E, P, R, S, T};
    let link = if kinds.len() > MANY_LINKS {
        SHORT_LINK
    } else {
        LINK
    };
    // Freedoms of the plane across the last turning axis that the joints behind each other use up: turns, and all.
    let (mut parallel, mut planar) = (0, 0);
    let mut joints = Vec::new();
    for (i, &kind) in kinds.iter().enumerate() {
        let before = i.checked_sub(1).map(|before| kinds[before]);
        let (alpha, a) = match (before, kind) {
            (None, _) => (0.0_f64, 0.0),
            (Some(E), P) => (40.0, 0.0),
            (Some(P), E) => (30.0, LINKS.0),
            (Some(_), E) => (30.0, link),
            (Some(E), R | C) => (60.0, link),
            (Some(P), P) => (90.0, 0.0),
            (Some(_), P) if planar >= 3 => (30.0, 0.0),
            (Some(_), P) => (-90.0, 0.0),
            (Some(P), R | C) if parallel >= 2 || planar >= 3 => (30.0, 0.0),
            (Some(P), R | C) => (90.0, 0.0),
            (Some(P), T | S) => (0.0, 0.0),
            // A third parallel axis would add nothing that the plane of the two has not.
            (Some(_), R | C) if parallel >= 2 || planar >= 3 => (90.0, link),
            (Some(_), R | C | T | S) => (0.0, link),
        };
        let square = before == Some(P) && alpha == 90.0;
        (parallel, planar) = match (kind, before) {
            (R | C, Some(_)) if alpha == 0.0 || square => (parallel + 1, planar + 1),
            (R | C, _) => (1, 1),
            (P, _) => (parallel, planar + 1),
            (T, _) => (1, 1),
            (S | E, _) => (0, 0),
        };
        // A second slider is square to both axes before it; the plane of an E that comes first lies flat.
        let theta = match (kind, kinds.get(i + 1)) {
            (P, Some(P)) | (E, _) => 90.0_f64,
            _ => 0.0,
        };
        let mut rows = Joint::standard(kind).rows().to_vec();
        rows[0].alpha = alpha.to_radians();
        rows[0].a = a;
        rows[0].theta = theta.to_radians();
        joints.push(Joint::new(kind, rows, vec![]).expect("rows of the kind"));
    }
    joints
}

/// Joint values at the start, rad or lengths: a leg that leans inwards with its knee bent, no axes in line.
fn start(kinds: &[JointKind]) -> Vec<f64> {
    use JointKind::{C, E, P, R, S, T};
    /// A slide is square to the x axis that a turn moves: what follows x elsewhere is a quarter turn ahead of it.
    const SQUARE: f64 = 90.0;
    let mut values = Vec::new();
    for (i, kind) in kinds.iter().enumerate() {
        let before = &kinds[..i];
        let turned = before.iter().any(|kind| *kind != P);
        let slid = before.contains(&P);
        let mut turn: f64 = match (turned, slid) {
            (true, _) => -50.0,
            (false, true) => 30.0,
            (false, false) => 70.0,
        };
        if turned && before.last() == Some(&P) {
            turn += SQUARE;
        }
        let ahead = if kinds.get(i + 1) == Some(&P) {
            SQUARE
        } else {
            0.0
        };
        match kind {
            R => values.push((turn - ahead).to_radians()),
            P => values.push(if slid { 0.6 } else { 0.9 }),
            C => values.extend([(turn - ahead).to_radians(), 0.1]),
            T => values.extend([turn.to_radians(), (25.0 - ahead).to_radians()]),
            S => values.extend([20.0, 50.0, -30.0].map(f64::to_radians)),
            E => values.extend([0.2, 0.3, 30_f64.to_radians()]),
        }
    }
    values
}

/// Whole degrees and hundredths of a length: numbers that can be read.
const DEGREES: f64 = 1.0;
const LENGTHS: f64 = 100.0;

fn rounded(x: f64, per_unit: f64) -> f64 {
    (x * per_unit).round() / per_unit
}

/// Changes to a leg, of an amount that grows with the number of the attempt; none at attempt 0.
struct Variation {
    random: Random,
    amount: f64,
    /// Change the links as well as the joint values and the place of the base?
    links_too: bool,
}

impl Variation {
    fn new(attempt: u32) -> Self {
        Self {
            random: Random::new(u64::from(attempt)),
            amount: (f64::from(attempt) / f64::from(GROWTH)).min(1.0),
            links_too: false,
        }
    }

    /// `value` changed by up to `range`, rounded.
    fn vary(&mut self, value: f64, range: f64, per_unit: f64) -> f64 {
        let range = range * self.amount;
        rounded(value + self.random.between(-range, range), per_unit)
    }

    fn angle(&mut self, radians: f64, degrees: f64) -> f64 {
        self.vary(radians.to_degrees(), degrees, DEGREES)
            .to_radians()
    }

    fn leg(&mut self, leg: &Leg) -> Leg {
        // Full ranges: within them legs stay well proportioned more often than not.
        const JOINT: f64 = 40.0;
        const SLIDE: f64 = 0.3;
        const TURN: f64 = 15.0;
        const TWIST: f64 = 40.0;
        const LENGTH: f64 = 0.2;
        /// Least part of a slide that is left.
        const LEFT: f64 = 0.5;
        let mut values = leg.start.iter();
        let mut start = Vec::new();
        let mut joints = Vec::new();
        for (i, joint) in leg.joints.iter().enumerate() {
            let kind = joint.kind();
            let mut rows = joint.rows().to_vec();
            let first = &mut rows[0];
            if self.links_too {
                if i > 0 {
                    first.alpha = self.angle(first.alpha, TWIST);
                }
                if first.a > 0.0 {
                    first.a = self.vary(first.a, LENGTH, LENGTHS).max(LINKS.0);
                }
                // Of the others θ is an offset of their own variable.
                if matches!(kind, JointKind::P | JointKind::E) {
                    first.theta = self.angle(first.theta, TWIST);
                }
            }
            let turns = Chain::new(
                String::new(),
                Pose::identity(),
                vec![joint.clone()],
                Pose::identity(),
            );
            let turns: Vec<bool> = turns.expect("a chain of one joint").turns().collect();
            for (turns, value) in turns.into_iter().zip(&mut values) {
                start.push(if turns {
                    self.angle(*value, JOINT)
                } else {
                    self.vary(*value, SLIDE.min(value * LEFT), LENGTHS)
                });
            }
            joints.push(Joint::new(kind, rows, vec![]).expect("rows of the kind"));
        }
        Leg {
            joints,
            start,
            turn: self.vary(leg.turn, TURN, DEGREES),
            rank: leg.rank,
        }
    }
}
