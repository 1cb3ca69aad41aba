//! The legs of a linkage made of a type: their links, their joint values at the start, and variations of both.

use crate::math::pose::{FrameCoordinates, Pose};
use crate::math::random::Random;
use crate::model::chain::Chain;
use crate::model::joint::{Joint, JointKind};
use crate::types::mobility::generic_rank;

/// Length of a link in legs of few and of many links; the bases stand on a circle of radius 1, and legs of both are about
/// as long as that.
const LINK: f64 = 0.7;
const SHORT_LINK: f64 = 0.5;
/// Links of a leg from which on they are the short ones.
const MANY_LINKS: usize = 3;
/// Shortest and longest link of a drawing that can be read, in units of the base circle's radius.
pub(crate) const LINKS: (f64, f64) = (0.3, 1.5);
/// Variations by which the amount grows from none to its full range.
const GROWTH: u32 = 12;

/// A chain's joints with their links, its joint values at the start, and the turn of its base about the vertical from its
/// place on the circle, degrees.
#[derive(Clone, Debug)]
pub(crate) struct Leg {
    pub(crate) joints: Vec<Joint>,
    pub(crate) start: Vec<f64>,
    pub(crate) turn: f64,
    /// Independent joints in any dimensions.
    pub(crate) rank: usize,
}

impl Leg {
    /// The leg of these joints by the rules of thumb.
    pub(crate) fn plain(kinds: &[JointKind]) -> Self {
        Self {
            joints: joints(kinds),
            start: start(kinds),
            turn: 0.0,
            rank: generic_rank(kinds),
        }
    }

    /// The joints' kinds.
    pub(crate) fn kinds(&self) -> Vec<JointKind> {
        self.joints.iter().map(Joint::kind).collect()
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
pub(crate) fn base(first: JointKind, around: f64) -> Pose {
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
        // Twist and length of the link, and whether a turning axis is parallel to the last one.
        let (alpha, a, again) = match (before, kind) {
            (None, _) => (0.0_f64, 0.0, false),
            (Some(E), P) => (40.0, 0.0, false),
            (Some(P), E) => (30.0, LINKS.0, false),
            (Some(_), E) => (30.0, link, false),
            (Some(E), R | C) => (60.0, link, false),
            (Some(P), P) => (90.0, 0.0, false),
            (Some(_), P) if planar >= 3 => (30.0, 0.0, false),
            (Some(_), P) => (-90.0, 0.0, false),
            (Some(P), R | C) if parallel >= 2 || planar >= 3 => (30.0, 0.0, false),
            (Some(P), R | C) => (90.0, 0.0, true),
            (Some(P), T | S) => (0.0, 0.0, false),
            // A third parallel axis would add nothing that the plane of the two has not.
            (Some(_), R | C) if parallel >= 2 || planar >= 3 => (90.0, link, false),
            (Some(_), R | C | T | S) => (0.0, link, true),
        };
        (parallel, planar) = match kind {
            R | C if again => (parallel + 1, planar + 1),
            P => (parallel, planar + 1),
            R | C | T => (1, 1),
            S | E => (0, 0),
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
pub(crate) const LENGTHS: f64 = 100.0;

pub(crate) fn rounded(x: f64, per_unit: f64) -> f64 {
    (x * per_unit).round() / per_unit
}

/// A length with two digits, such as 850.
pub(crate) fn two_digits(x: f64) -> f64 {
    let unit = libm::pow(10.0, libm::floor(libm::log10(x.abs())) - 1.0);
    // Above 1 by whole numbers, below it by whole parts of 1: both keep decimal numbers short.
    if unit >= 1.0 {
        (x / unit).round() * unit
    } else {
        let per_unit = (1.0 / unit).round();
        (x * per_unit).round() / per_unit
    }
}

/// Changes to a leg, of an amount that grows with the number of the attempt; none at attempt 0.
pub(crate) struct Variation {
    random: Random,
    amount: f64,
    /// Change the links as well as the joint values and the place of the base?
    pub(crate) links_too: bool,
}

impl Variation {
    pub(crate) fn new(attempt: u32) -> Self {
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

    /// A lean of the base from where it stands, rad about two axes.
    pub(crate) fn lean(&mut self) -> [f64; 2] {
        const LEAN: f64 = 30.0;
        [(); 2].map(|()| self.angle(0.0, LEAN))
    }

    fn angle(&mut self, radians: f64, degrees: f64) -> f64 {
        self.vary(radians.to_degrees(), degrees, DEGREES)
            .to_radians()
    }

    /// The leg with its changes.
    pub(crate) fn leg(&mut self, leg: &Leg) -> Leg {
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
