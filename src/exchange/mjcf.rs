//! The linkage and its motion as a MuJoCo model (MJCF): every joint explicit, the loops closed by welds.
//!
//! Each chain is a branch of the tree of bodies: the base at G, a body for each row of the table with the
//! row's joints, H behind the last. The workpiece is the end of the first chain; the end of every other
//! chain is welded to it. The model's reference position is the first frame, so that a viewer opens it
//! closed; the joints' values are the planner's all the same (`ref`), and every frame is a key frame.

use crate::document::bounds::{MAX_ANGLE, MAX_LENGTH};
use crate::document::report::Report;
use crate::document::schema::Document;
use crate::exchange::table::{number, variable_name};
use crate::math::pose::Pose;
use crate::model::chain::Chain;
use crate::model::dh::{x_displacement, z_displacement};
use crate::model::joint::{Limits, Moves};
use crate::model::mechanism::Mechanism;
use crate::motion::trajectory::{Status, Trajectory};
use nalgebra::Vector3;
use std::fmt::Write;

/// The radius of a link as a share of the mechanism's size.
const LINK: f64 = 1.0 / 60.0;
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
pub fn mjcf(document: &Document, mechanism: &Mechanism, t: &Trajectory) -> String {
    let frames: Vec<usize> = (0..t.frames())
        .filter(|&i| t.status[i] != Status::ClosureLost)
        .collect();
    let first = frames.first().map_or(&t.start[..], |&i| t.joints_at(i));
    let mut xml = Xml::default();
    xml.open(&format!("<mujoco model=\"{}\">", escaped(&document.name)));
    head(&mut xml, document, mechanism, t);
    xml.open("<worldbody>");
    let report = Report::new(mechanism, &document.length_unit, t);
    let mut fixed = Vec::new();
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
            radius: LINK * mechanism.size_or(1.0),
        };
        branch.write(&mut xml, mechanism, t, &mut fixed);
    }
    xml.close("</worldbody>");
    if mechanism.chains().len() > 1 || !fixed.is_empty() {
        xml.open("<equality>");
        for i in 2..=mechanism.chains().len() {
            xml.line(&format!(
                "<weld name=\"chain{i}_closes\" body1=\"workpiece\" body2=\"chain{i}_end\" relpose=\"0 0 0 1 0 0 0\"/>"
            ));
        }
        for line in &fixed {
            xml.line(line);
        }
        xml.close("</equality>");
    }
    if !frames.is_empty() {
        if frames.len() < t.frames() {
            xml.line("<!-- Frames whose loops are open are left out. -->");
        }
        xml.open("<keyframe>");
        for &i in &frames {
            xml.line(&format!(
                "<key name=\"frame{}\" time=\"{}\" qpos=\"{}\"/>",
                i + 1,
                number(t.time[i]),
                numbers(t.joints_at(i).iter().copied())
            ));
        }
        xml.close("</keyframe>");
    }
    xml.close("</mujoco>");
    xml.text
}

fn head(xml: &mut Xml, document: &Document, mechanism: &Mechanism, t: &Trajectory) {
    xml.line("<!-- Angles in radians, lengths in the unit named below. Masses only make the model move. -->");
    // MuJoCo refuses bodies lighter than 1e-15, and the parts of a small linkage would be.
    xml.line("<compiler angle=\"radian\" boundmass=\"1e-6\" boundinertia=\"1e-9\"/>");
    xml.line("<!-- No gravity, so that the linkage stays where a key frame puts it: \"0 0 -9.81\" for metres. -->");
    xml.line("<option gravity=\"0 0 0\"/>");
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
        xml.open("<custom>");
        xml.line(&format!(
            "<text name=\"length_unit\" data=\"{}\"/>",
            escaped(&document.length_unit)
        ));
        xml.close("</custom>");
    }
    xml.open("<default>");
    xml.line("<geom mass=\"0.1\" contype=\"0\" conaffinity=\"0\"/>");
    xml.line("<joint damping=\"0.05\"/>");
    xml.line("<equality solref=\"0.005 1\"/>");
    xml.close("</default>");
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
    radius: f64,
}

impl Branch<'_> {
    fn write(&self, xml: &mut Xml, mechanism: &Mechanism, t: &Trajectory, fixed: &mut Vec<String>) {
        let (name, r) = (format!("chain{}", self.number + 1), self.radius);
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
        xml.line(&format!(
            "<joint name=\"{name}\" type=\"{kind}\" axis=\"0 0 1\" ref=\"{}\"{range}/>",
            number(value)
        ));
    }
}

/// Lines of XML with their depth.
#[derive(Default)]
struct Xml {
    text: String,
    depth: usize,
}

impl Xml {
    fn line(&mut self, line: &str) {
        let indent = 2 * self.depth;
        let _ = writeln!(self.text, "{:indent$}{line}", "");
    }

    fn open(&mut self, tag: &str) {
        self.line(tag);
        self.depth += 1;
    }

    fn close(&mut self, tag: &str) {
        self.depth -= 1;
        self.line(tag);
    }

    fn body(&mut self, name: &str, pose: &Pose) {
        let q = pose.rotation.coords;
        self.open(&format!(
            "<body name=\"{name}\" pos=\"{}\" quat=\"{}\">",
            vector(&pose.translation.vector),
            numbers([q.w, q.x, q.y, q.z])
        ));
    }

    fn geom(&mut self, kind: &str, place: &str, size: &[f64], colour: &str) {
        self.line(&format!(
            "<geom type=\"{kind}\" pos=\"{place}\" size=\"{}\" rgba=\"{colour}\"/>",
            rounded(size)
        ));
    }

    /// Nothing where the two ends are within its radius.
    fn capsule(&mut self, from: &Vector3<f64>, to: &Vector3<f64>, radius: f64, colour: &str) {
        if (to - from).norm() > radius {
            let ends = [from.x, from.y, from.z, to.x, to.y, to.z];
            self.line(&format!(
                "<geom type=\"capsule\" fromto=\"{}\" size=\"{}\" rgba=\"{colour}\"/>",
                rounded(&ends),
                rounded(&[radius])
            ));
        }
    }
}

fn numbers(values: impl IntoIterator<Item = f64>) -> String {
    let texts: Vec<String> = values.into_iter().map(number).collect();
    texts.join(" ")
}

fn vector(v: &Vector3<f64>) -> String {
    numbers([v.x, v.y, v.z])
}

/// What is only looked at needs six decimals of the largest of these.
fn rounded(values: &[f64]) -> String {
    let largest = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let mut per_unit = 1e6;
    while largest > 0.0 && largest * per_unit < 1e6 {
        per_unit *= 10.0;
    }
    numbers(values.iter().map(|x| (x * per_unit).round() / per_unit))
}

/// A text within an attribute; characters that XML cannot hold are dropped.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => {}
            c => out.push(c),
        }
    }
    out
}
