//! The linkage and its motion as a MuJoCo model (MJCF): every joint explicit, the loops closed by welds, drives on as many
//! joints as there are freedoms, sensors on the workpiece.
//!
//! Each chain is a branch of the tree of bodies: the base at G, a body for each row of the table with the
//! row's joints, H behind the last. The workpiece is the end of the first chain; the end of every other
//! chain is welded to it. The model's reference position is the first frame, so that a viewer opens it
//! closed; the joints' values are the planner's all the same (`ref`), and every frame is a key frame, counted from 0,
//! with the controls that hold it: the values of the joints that have drives.
//!
//! MuJoCo has no units: lengths are in the document's unit, times in seconds, masses in kilograms say. Moments and
//! moments of inertia grow with the square of the size, so that a linkage moves the same in millimetres and in metres.

use crate::document::bounds::{MAX_ANGLE, MAX_LENGTH};
use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::report::Report;
use crate::document::schema::Document;
use crate::exchange::drives::drives;
use crate::exchange::table::{number, variable_name};
use crate::exchange::xml::{Xml, escaped, numbers, vector};
use crate::model::chain::Chain;
use crate::model::dh::{x_displacement, z_displacement};
use crate::model::joint::{Limits, Moves};
use crate::model::mechanism::Mechanism;
use crate::motion::trajectory::{Status, Trajectory};
use nalgebra::Vector3;

/// The radius of a link as a share of the mechanism's size.
const LINK: f64 = 1.0 / 60.0;
/// Inertia of a motor, as the joint feels it: kg, of a hinge beside the square of the size. About that of all links.
const MOTOR: f64 = 1.0;
/// How stiff a drive holds its motor, rad/s, and the share of the critical damping. A drive is late by 2 DAMPING/STIFF,
/// 0.2 ms, and gives way to gravity by 1e-6 m for each kilogram that it carries.
const STIFF: f64 = 3000.0;
const DAMPING: f64 = 0.3;
/// Seconds a step: less than a radian of the stiffest motion there is.
const STEP: f64 = 0.00025;
/// Friction, kg/s, and inertia, kg, of every joint without a drive, of a hinge beside the square of the size: little beside
/// a drive's, and enough that no part is so light that the welds give way.
const FRICTION: f64 = 0.001;
const BEARING: f64 = 0.001;
/// How far a drive goes beyond its motion where the joint has no limit, rad or shares of the size.
const BEYOND: f64 = 0.01;
/// Gravity, m/s², and the units of length in which it can be said: how many of them are a metre.
const GRAVITY: f64 = 9.81;
const UNITS: [(&str, f64); 5] = [
    ("m", 1.0),
    ("cm", 100.0),
    ("mm", 1000.0),
    ("\u{b5}m", 1e6),
    ("in", 1.0 / 0.0254),
];
/// Colours of the chains, taken in turn, and of the workpiece: red, green, blue, opacity.
const CHAINS: [&str; 6] = [
    "0.26 0.47 0.75 1",
    "0.80 0.45 0.20 1",
    "0.25 0.58 0.38 1",
    "0.62 0.35 0.62 1",
    "0.70 0.60 0.20 1",
    "0.30 0.60 0.65 1",
];
const WORKPIECE: &str = "0.85 0.72 0.35 1";

/// What MuJoCo reads. Lengths stay in the document's unit; frames whose loops are open are left out of
/// the key frames.
///
/// # Errors
/// Where gravity is asked for and the document's unit of length is none of m, cm, mm, µm and in.
pub fn mjcf(
    document: &Document,
    mechanism: &Mechanism,
    t: &Trajectory,
    with_gravity: bool,
) -> Result<String, Fault> {
    let gravity = if with_gravity {
        GRAVITY * units_a_metre(&document.length_unit)?
    } else {
        0.0
    };
    let frames: Vec<usize> = (0..t.frames())
        .filter(|&i| t.status[i] != Status::ClosureLost)
        .collect();
    let first = frames.first().map_or(&t.start[..], |&i| t.joints_at(i));
    let drives = drives(mechanism, t, &frames);
    let mut xml = Xml::default();
    xml.open(&format!("<mujoco model=\"{}\">", escaped(&document.name)));
    head(&mut xml, document, mechanism, t, gravity);
    xml.open("<worldbody>");
    let report = Report::new(mechanism, &document.length_unit, t);
    let (mut fixed, mut actuators) = (Vec::new(), Vec::new());
    for (i, (chain, values)) in mechanism.split(first).enumerate() {
        let offset = mechanism.chains()[..i].iter().map(Chain::freedoms).sum();
        let branch = Branch {
            number: i,
            chain,
            labels: report.chains[i]
                .variables
                .iter()
                .map(|v| &v.label[..])
                .collect(),
            values,
            offset,
            size: mechanism.size_or(1.0),
            drives: &drives,
        };
        branch.write(&mut xml, mechanism, t, &mut fixed);
        actuators.extend(branch.actuators(t, &frames));
    }
    xml.close("</worldbody>");
    if mechanism.chains().len() > 1 || !fixed.is_empty() {
        let welds = (2..=mechanism.chains().len()).map(|i| {
            format!(
                "<weld name=\"chain{i}_closes\" body1=\"workpiece\" body2=\"chain{i}_end\" relpose=\"0 0 0 1 0 0 0\"/>"
            )
        });
        xml.list("equality", welds.chain(fixed));
    }
    if !actuators.is_empty() {
        xml.line("<!-- Controls are values of joints; those of key frame frame0 hold the linkage where it begins. -->");
        xml.list("actuator", actuators);
    }
    let sensors = [
        ("framepos", "position"),
        ("framequat", "rotation"),
        ("framelinvel", "velocity"),
        ("frameangvel", "angular_velocity"),
    ];
    let sensor = |(kind, name): (&str, &str)| {
        format!("<{kind} name=\"workpiece_{name}\" objtype=\"site\" objname=\"workpiece\"/>")
    };
    xml.list("sensor", sensors.map(sensor));
    if !frames.is_empty() {
        if frames.len() < t.frames() {
            xml.line("<!-- Frames whose loops are open are left out. -->");
        }
        let controls = |joints: &[f64]| {
            let own = numbers(drives.iter().map(|&k| joints[k]));
            if own.is_empty() {
                own
            } else {
                format!(" ctrl=\"{own}\"")
            }
        };
        let key = |&i: &usize| {
            let joints = t.joints_at(i);
            format!(
                "<key name=\"frame{i}\" time=\"{}\" qpos=\"{}\"{}/>",
                number(t.time[i]),
                numbers(joints.iter().copied()),
                controls(joints)
            )
        };
        xml.list("keyframe", frames.iter().map(key));
    }
    xml.close("</mujoco>");
    Ok(xml.text)
}

fn units_a_metre(unit: &str) -> Result<f64, Fault> {
    // The Greek letter is the same sign as that for a millionth.
    let plain = unit.trim().replace('\u{3bc}', "\u{b5}");
    let found = UNITS.iter().find(|(name, _)| *name == plain);
    found.map(|(_, count)| *count).ok_or_else(|| {
        let what = if plain.is_empty() {
            "gravity needs one, and there is none".to_owned()
        } else {
            format!("gravity in \u{201c}{}\u{201d} is not known", excerpt(unit))
        };
        let accepted = UNITS.map(|(name, _)| name).join(", ");
        let place = Place::WHOLE.field("length_unit");
        Fault::new(FaultCode::UnknownValue, &place, &what, &accepted)
    })
}

fn head(xml: &mut Xml, document: &Document, mechanism: &Mechanism, t: &Trajectory, gravity: f64) {
    xml.line("<!-- Angles in radians, lengths in the unit named below. Masses only make the model move. -->");
    // MuJoCo refuses bodies lighter than 1e-15, and the parts of a small linkage would be.
    let size = mechanism.size_or(1.0);
    let light = (1e-9 * size * size).clamp(1e-14, 1e-9);
    xml.line(&format!(
        "<compiler angle=\"radian\" boundmass=\"1e-6\" boundinertia=\"{}\"/>",
        number(light)
    ));
    if gravity == 0.0 {
        xml.line("<!-- No gravity, unless it is asked for: \"0 0 -9.81\" for metres. -->");
    }
    xml.line(&format!(
        "<option gravity=\"{}\" timestep=\"{STEP}\" integrator=\"implicitfast\"/>",
        numbers([0.0, 0.0, -gravity])
    ));
    let middle = (t.poses.iter()).fold(Vector3::zeros(), |sum, pose| sum + pose.translation.vector);
    let bases = (mechanism.chains().iter()).fold(Vector3::zeros(), |sum, chain| {
        sum + chain.base().translation.vector
    });
    let centre =
        0.5 * middle / t.frames().max(1) as f64 + 0.5 * bases / mechanism.chains().len() as f64;
    xml.line(&format!(
        "<statistic center=\"{}\" extent=\"{}\"/>",
        vector(&centre),
        number(1.2 * mechanism.size_or(1.0))
    ));
    xml.line("<visual><headlight ambient=\"0.4 0.4 0.4\" diffuse=\"0.5 0.5 0.5\"/></visual>");
    xml.line("<asset><texture type=\"skybox\" builtin=\"gradient\" rgb1=\"0.9 0.92 0.95\" rgb2=\"0.6 0.66 0.74\" width=\"64\" height=\"64\"/></asset>");
    if !document.length_unit.is_empty() {
        let unit = escaped(&document.length_unit);
        let text = format!("<text name=\"length_unit\" data=\"{unit}\"/>");
        xml.list("custom", [text]);
    }
    // As stiff as the step allows, and with hardly any share of the load left over: MuJoCo's usual welds give way by a
    // hundredth of the size where the drives pull.
    let defaults = [
        "<geom mass=\"0.1\" contype=\"0\" conaffinity=\"0\"/>",
        "<equality solref=\"0.001 1\" solimp=\"0.9999 0.9999 0.001\"/>",
    ];
    xml.list("default", defaults);
}

/// A chain as a branch of the tree.
struct Branch<'a> {
    /// From 0.
    number: usize,
    chain: &'a Chain,
    /// Of its variables, such as θ1.
    labels: Vec<&'a str>,
    /// Joint values in the reference position.
    values: &'a [f64],
    /// Where its variables begin among all.
    offset: usize,
    /// Of the mechanism.
    size: f64,
    /// The variables with drives, among all.
    drives: &'a [usize],
}

impl Branch<'_> {
    fn write(&self, xml: &mut Xml, mechanism: &Mechanism, t: &Trajectory, fixed: &mut Vec<String>) {
        let (name, r) = (format!("chain{}", self.number + 1), LINK * self.size);
        let colour = CHAINS[self.number % CHAINS.len()];
        xml.body(&format!("{name}_base"), self.chain.base());
        xml.geom("box", "0 0 0", &[1.6 * r, 1.6 * r, 1.6 * r], colour);
        let (mut variable, mut row, mut depth) = (0, 0, 1);
        for joint in self.chain.joints() {
            // A joint variable's limits stand in the order of the variables.
            let mut limits = joint.limits().iter();
            for (i, dh) in joint.rows().iter().enumerate() {
                let moves = joint.kind().moves(i);
                let turn = (moves != Moves::Slides).then(|| {
                    variable += 1;
                    variable - 1
                });
                let slide = (moves != Moves::Turns).then(|| {
                    variable += 1;
                    variable - 1
                });
                let value = |k: Option<usize>| k.map_or(0.0, |k| self.values[k]);
                let seat = x_displacement(dh.alpha, dh.a);
                let moved = seat * z_displacement(dh.theta + value(turn), dh.d + value(slide));
                // The link runs along the common normal and, to a joint that turns, on along its axis.
                xml.capsule(&Vector3::zeros(), &seat.translation.vector, r, colour);
                if slide.is_none() {
                    xml.capsule(
                        &seat.translation.vector,
                        &moved.translation.vector,
                        r,
                        colour,
                    );
                }
                row += 1;
                depth += 1;
                xml.body(&format!("{name}_link{row}"), &moved);
                for (k, kind) in [(turn, "hinge"), (slide, "slide")] {
                    if let (Some(k), Some(limits)) = (k, k.and_then(|_| limits.next())) {
                        self.joint(xml, k, kind, limits, fixed);
                    }
                }
                xml.geom("sphere", "0 0 0", &[1.5 * r], colour);
                if let Some(k) = slide {
                    // A rod back to where the slider sits, as long as the motion needs it.
                    let longest = (0..t.frames())
                        .map(|f| dh.d + t.joints_at(f)[self.offset + k])
                        .fold(
                            dh.d + value(slide),
                            |m, x| if x.abs() > m.abs() { x } else { m },
                        );
                    xml.capsule(
                        &Vector3::zeros(),
                        &Vector3::new(0.0, 0.0, -longest),
                        0.7 * r,
                        colour,
                    );
                }
            }
        }
        if self.number == 0 {
            xml.body("workpiece", self.chain.gripper());
            xml.line("<site name=\"workpiece\" group=\"4\"/>");
            xml.geom("sphere", "0 0 0", &[1.5 * r], WORKPIECE);
            for chain in mechanism.chains() {
                let end = chain.gripper().inverse().translation.vector;
                xml.capsule(&Vector3::zeros(), &end, 1.2 * r, WORKPIECE);
            }
        } else {
            xml.body(&format!("{name}_end"), self.chain.gripper());
        }
        for _ in 0..=depth {
            xml.close("</body>");
        }
    }

    /// A hinge about z or a slide along it; a joint whose limits leave it one value is held by an
    /// equality, since MuJoCo's ranges are not empty.
    fn joint(&self, xml: &mut Xml, k: usize, kind: &str, limits: &Limits, fixed: &mut Vec<String>) {
        let name = variable_name(self.number, self.labels[k]);
        let value = self.values[k];
        let open = if kind == "hinge" {
            MAX_ANGLE.to_radians()
        } else {
            MAX_LENGTH
        };
        let mut range = String::new();
        if !(limits.min < limits.max) {
            let held = number(limits.min - value);
            fixed.push(format!(
                "<joint name=\"{name}_held\" joint1=\"{name}\" polycoef=\"{held} 0 0 0 0\"/>"
            ));
        } else if limits.min.is_finite() || limits.max.is_finite() {
            let ends = [limits.min.max(-open), limits.max.min(open)];
            range = format!(" range=\"{}\"", numbers(ends));
        }
        let scale = self.scale(kind == "hinge");
        let inertia = if self.drives.contains(&(self.offset + k)) {
            MOTOR
        } else {
            BEARING
        };
        xml.line(&format!(
            "<joint name=\"{name}\" type=\"{kind}\" axis=\"0 0 1\" ref=\"{}\" damping=\"{}\" armature=\"{}\"{range}/>",
            number(value),
            number(FRICTION * scale),
            number(inertia * scale)
        ));
    }

    /// What moments and moments of inertia have that forces and masses have not.
    fn scale(&self, turns: bool) -> f64 {
        if turns { self.size * self.size } else { 1.0 }
    }

    /// The drives of this chain: each holds its joint at the value that is its control. Controls go to the joint's
    /// limits, or to what the motion needs and a little beyond.
    fn actuators(&self, t: &Trajectory, frames: &[usize]) -> Vec<String> {
        let variables = self.chain.turns().zip(self.chain.limits()).enumerate();
        let driven = variables.filter(|(k, _)| self.drives.contains(&(self.offset + k)));
        let actuator = |(k, (turns, limits)): (usize, (bool, Limits))| {
            let values = frames.iter().map(|&f| t.joints_at(f)[self.offset + k]);
            let (least, most) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| {
                (a.min(x), b.max(x))
            });
            let beyond = BEYOND * if turns { 1.0 } else { self.size };
            let or = |limit: f64, other: f64| if limit.is_finite() { limit } else { other };
            let ends = [
                or(limits.min, least - beyond),
                or(limits.max, most + beyond),
            ];
            let name = variable_name(self.number, self.labels[k]);
            let stiff = MOTOR * self.scale(turns) * STIFF;
            format!(
                "<position name=\"{name}_drive\" joint=\"{name}\" kp=\"{}\" kv=\"{}\" ctrlrange=\"{}\"/>",
                number(stiff * STIFF),
                number(stiff * 2.0 * DAMPING),
                numbers(ends)
            )
        };
        driven.map(actuator).collect()
    }
}
