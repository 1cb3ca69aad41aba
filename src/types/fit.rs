//! One leg fitted between two points: its links to its length, its joint values to the point where it ends.

use crate::math::pose::{FrameCoordinates, Pose};
use crate::model::chain::{Chain, ChainState};
use crate::model::dh::DhRow;
use crate::model::joint::{Joint, JointKind};
use crate::types::leg::{Leg, base, two_digits};
use nalgebra::{Matrix3, Translation3, UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_2;

/// Where a leg stands and ends, before it is turned about the vertical to its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    /// Where the base is.
    pub(crate) base: Vector3<f64>,
    /// Direction in the ground plan in which the leg's back looks, rad from x.
    pub(crate) facing: f64,
    /// How far the base leans from its upright place, rad: inwards, and to the side.
    pub(crate) lean: [f64; 2],
    /// Where the last joint is to be.
    pub(crate) end: Vector3<f64>,
    /// Of the leg, without the slide that carries it.
    pub(crate) length: f64,
    /// Of the slider that carries the leg, if one does.
    pub(crate) slide: Option<f64>,
    /// All turning axes vertical?
    pub(crate) planar: bool,
}

/// A leg that ends where it is to end, if its type allows it.
#[derive(Clone, Debug)]
pub(crate) struct Fit {
    pub(crate) base: Pose,
    pub(crate) joints: Vec<Joint>,
    /// Rad or lengths.
    pub(crate) values: Vec<f64>,
}

/// The leg at its place. Where its joints cannot bring its end there, its base is tilted; a leg that has no length, such as
/// a single turning joint, stays on the base circle.
pub(crate) fn fitted(kinds: &[JointKind], leg: &Leg, place: &Place) -> Fit {
    let foot = base_at(kinds, place);
    let mut plain = Fit {
        base: foot,
        joints: leg.joints.clone(),
        values: leg.start.clone(),
    };
    if place.planar {
        plain.joints = flat(&plain.joints);
    }
    if kinds[0] == JointKind::S {
        plain.stand_on_ball(kinds);
    }
    let (from, end) = plain.ends(place.slide.is_some());
    let natural = (end - from).norm();
    if natural > SMALL {
        let scale = place.length / natural;
        for short in [true, false] {
            let mut fit = plain.scaled(scale, if short { place.length } else { 0.0 });
            if let Some(slide) = place.slide {
                fit.values[0] = slide;
            }
            if fit.reach(place) {
                fit.align_end(place);
                return fit;
            }
        }
    }
    let (_, natural) = plain.ends(false);
    let wanted = place.end - foot.translation.vector;
    if natural.norm() <= SMALL {
        return plain.scaled(place.length, 0.0);
    }
    let mut fit = plain.scaled(wanted.norm() / natural.norm(), 0.0);
    let tilt = UnitQuaternion::rotation_between(&natural, &wanted)
        .unwrap_or_else(|| UnitQuaternion::new(Vector3::x() * std::f64::consts::PI));
    fit.base.rotation = tilt * fit.base.rotation;
    fit.align_end(place);
    fit
}

/// Length of a leg on a base circle of radius 1 that is none.
const SMALL: f64 = 1e-6;

/// The base at its place.
fn base_at(kinds: &[JointKind], place: &Place) -> Pose {
    let mut at = if place.planar {
        // A slider goes along the circle's tangent, its y axis upwards; else z upwards, x inwards.
        let slides = kinds[0] == JointKind::P;
        FrameCoordinates {
            roll: std::f64::consts::PI,
            ..FrameCoordinates::default()
        }
        .pose()
            * FrameCoordinates {
                latitude: if slides { -FRAC_PI_2 } else { 0.0 },
                ..FrameCoordinates::default()
            }
            .pose()
    } else {
        let [inwards, aside] = place.lean;
        let upright = UnitQuaternion::new(Vector3::z() * place.facing);
        let lean = UnitQuaternion::new(Vector3::new(aside, -inwards, 0.0));
        let leaning = upright * lean * upright.inverse();
        Pose::from_parts(Translation3::identity(), leaning)
            * base(kinds[0], place.facing.to_degrees())
    };
    at.translation = Translation3::from(place.base);
    at
}

/// The joints with all turning axes parallel, and the sliders square to them.
fn flat(joints: &[Joint]) -> Vec<Joint> {
    let mut flat: Vec<Joint> = Vec::new();
    for joint in joints {
        let mut row = joint.rows()[0];
        if joint.kind() == JointKind::R
            && flat
                .last()
                .is_some_and(|before| before.kind() == JointKind::R)
        {
            row.alpha = 0.0;
        }
        flat.push(Joint::new(joint.kind(), vec![row], vec![]).expect("one row"));
    }
    flat
}

impl Fit {
    /// The chain without its gripper.
    fn chain(&self) -> Chain {
        Chain::new(
            String::new(),
            self.base,
            self.joints.clone(),
            Pose::identity(),
        )
        .expect("freedoms of a chain")
    }

    /// From where the leg's length counts, and where it ends, both measured from the base: beside a base circle that is far
    /// larger than the leg their difference would lose its last digits.
    fn ends(&self, carried: bool) -> (Vector3<f64>, Vector3<f64>) {
        let mut upon = self.clone();
        upon.base.translation = Translation3::identity();
        let frames = upon.chain().frames(&self.values);
        let from = if carried { frames[1].0 } else { frames[0].0 };
        (
            from.translation.vector,
            frames[frames.len() - 1].1.translation.vector,
        )
    }

    /// A ball joint at the base turns like the R in its place would, about its third axis.
    fn stand_on_ball(&mut self, kinds: &[JointKind]) {
        let mut turning = kinds.to_vec();
        turning[0] = JointKind::R;
        let alike = Leg::plain(&turning);
        self.values.splice(..3, [0.0, FRAC_PI_2, alike.start[0]]);
        self.values.splice(3.., alike.start[1..].iter().copied());
        let ball = Chain::new(
            String::new(),
            Pose::identity(),
            vec![self.joints[0].clone()],
            Pose::identity(),
        );
        let turned = ball
            .expect("a chain of one joint")
            .pose(&[0.0, FRAC_PI_2, 0.0]);
        self.base.rotation *= turned.rotation.inverse();
    }

    /// The leg with all lengths multiplied; links to about a hundredth of `length`, if there are several.
    fn scaled(&self, scale: f64, length: f64) -> Self {
        let several = self
            .joints
            .iter()
            .filter(|joint| joint.rows()[0].a > 0.0)
            .count()
            > 1;
        let length_of = |a: f64| match several && length > 0.0 && a > 0.0 {
            true => two_digits(a * scale),
            false => a * scale,
        };
        let joints = self.joints.iter().map(|joint| {
            let rows = joint.rows().iter();
            let rows = rows.map(|row| DhRow {
                a: length_of(row.a),
                d: row.d * scale,
                ..*row
            });
            Joint::new(joint.kind(), rows.collect(), vec![]).expect("rows of the kind")
        });
        let values = self
            .chain()
            .turns()
            .zip(&self.values)
            .map(|(turns, value)| if turns { *value } else { value * scale })
            .collect();
        Self {
            base: self.base,
            joints: joints.collect(),
            values,
        }
    }

    /// Changes the joint values by the least steps until the leg ends at its place; false if they do not come there.
    fn reach(&mut self, place: &Place) -> bool {
        const STEPS: usize = 100;
        /// Largest step, rad or leg lengths.
        const LARGEST: f64 = 0.3;
        /// Keeps directions out in which no joint moves the end.
        const DAMPING: f64 = 1e-9;
        const THERE: f64 = 1e-12;
        let chain = self.chain();
        // A slider that leans carries the leg to another place.
        let upright = place.lean.iter().all(|lean| *lean == 0.0);
        let held = usize::from(place.slide.is_some() && upright);
        let turns: Vec<bool> = chain.turns().collect();
        let mut state = ChainState::default();
        for _ in 0..STEPS {
            chain.evaluate(&self.values, &mut state);
            let gap = (place.end - state.pose.translation.vector) / place.length;
            if gap.norm() < THERE {
                return true;
            }
            let columns: Vec<Vector3<f64>> = (0..turns.len())
                .map(|i| {
                    let column = state.jacobian[i].fixed_rows::<3>(0).into_owned();
                    if turns[i] {
                        column / place.length
                    } else {
                        column
                    }
                })
                .collect();
            let square = columns[held..]
                .iter()
                .fold(Matrix3::identity() * DAMPING, |sum, c| {
                    sum + c * c.transpose()
                });
            let Some(inverse) = square.try_inverse() else {
                return false;
            };
            let pull = inverse * gap;
            let steps: Vec<f64> = columns.iter().map(|column| column.dot(&pull)).collect();
            let largest = steps[held..]
                .iter()
                .fold(0.0, |most: f64, step| most.max(step.abs()));
            let share = (LARGEST / largest).min(1.0);
            for i in held..turns.len() {
                self.values[i] += share * steps[i] * if turns[i] { 1.0 } else { place.length };
            }
        }
        false
    }

    /// Turns the last joint, if it is a ball or an axis along the platform's edge, so that the gripper is one length, the
    /// platform's radius, with right angles.
    fn align_end(&mut self, place: &Place) {
        let frames = self.chain().frames(&self.values);
        let last = self.joints[self.joints.len() - 1].kind();
        let many = self.values.len();
        if last == JointKind::R && self.joints.len() > 1 {
            const SQUARE: f64 = 1e-9;
            let seat = frames[frames.len() - 1].0;
            let outwards = Vector3::new(place.end.x, place.end.y, 0.0);
            let outwards = seat.rotation.inverse() * outwards;
            // Only an axis square to that direction can turn the gripper's x axis into it.
            if outwards.z.abs() <= SQUARE * outwards.norm() {
                self.values[many - 1] = libm::atan2(outwards.y, outwards.x);
            }
        }
        if last != JointKind::S || self.joints.len() == 1 {
            return;
        }
        let seat = frames[frames.len() - 3].0.rotation.to_rotation_matrix();
        // The frame behind the ball: x outwards and z upwards; or turned so that z is level.
        let turned = |latitude: f64, longitude: f64| {
            FrameCoordinates {
                latitude,
                longitude,
                ..FrameCoordinates::default()
            }
            .pose()
            .rotation
            .to_rotation_matrix()
        };
        let candidates = [
            turned(0.0, 0.0),
            turned(0.0, FRAC_PI_2),
            turned(FRAC_PI_2, 0.0),
        ];
        /// Sine of the angle between the ball's first and third axis from which on it is far from gimbal lock.
        const FAR: f64 = 0.3;
        let sine = |m: &Matrix3<f64>| libm::hypot(m[(0, 2)], m[(1, 2)]);
        let within = candidates.map(|frame| *(seat.inverse() * frame).matrix());
        let fine = within.iter().find(|m| sine(m) > FAR);
        let m = fine.unwrap_or_else(|| {
            within
                .iter()
                .max_by(|a, b| sine(a).total_cmp(&sine(b)))
                .expect("three")
        });
        // Z(θ₁) X(90°) Z(θ₂) X(−90°) Z(θ₃) = Z(θ₁) Y(−θ₂) Z(θ₃).
        self.values[many - 3] = libm::atan2(m[(1, 2)], m[(0, 2)]);
        self.values[many - 2] = -libm::atan2(sine(m), m[(2, 2)]);
        self.values[many - 1] = libm::atan2(m[(2, 1)], -m[(2, 0)]);
    }
}
