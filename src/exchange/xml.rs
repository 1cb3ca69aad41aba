//! Lines of XML: elements with their depth, numbers and texts in attributes.

use crate::exchange::table::number;
use crate::math::pose::Pose;
use nalgebra::Vector3;
use std::fmt::Write;

/// Lines of XML with their depth.
#[derive(Default)]
pub(crate) struct Xml {
    pub(crate) text: String,
    depth: usize,
}

impl Xml {
    pub(crate) fn line(&mut self, line: &str) {
        let indent = 2 * self.depth;
        let _ = writeln!(self.text, "{:indent$}{line}", "");
    }

    pub(crate) fn open(&mut self, tag: &str) {
        self.line(tag);
        self.depth += 1;
    }

    pub(crate) fn close(&mut self, tag: &str) {
        self.depth -= 1;
        self.line(tag);
    }

    /// An element with these lines inside.
    pub(crate) fn list(&mut self, name: &str, lines: impl IntoIterator<Item = impl AsRef<str>>) {
        self.open(&format!("<{name}>"));
        lines.into_iter().for_each(|line| self.line(line.as_ref()));
        self.close(&format!("</{name}>"));
    }

    pub(crate) fn body(&mut self, name: &str, pose: &Pose) {
        let q = pose.rotation.coords;
        self.open(&format!(
            "<body name=\"{name}\" pos=\"{}\" quat=\"{}\">",
            vector(&pose.translation.vector),
            numbers([q.w, q.x, q.y, q.z])
        ));
    }

    pub(crate) fn geom(&mut self, kind: &str, place: &str, size: &[f64], colour: &str) {
        self.line(&format!(
            "<geom type=\"{kind}\" pos=\"{place}\" size=\"{}\" rgba=\"{colour}\"/>",
            rounded(size)
        ));
    }

    /// Nothing where the two ends are within its radius.
    pub(crate) fn capsule(
        &mut self,
        from: &Vector3<f64>,
        to: &Vector3<f64>,
        radius: f64,
        colour: &str,
    ) {
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

pub(crate) fn numbers(values: impl IntoIterator<Item = f64>) -> String {
    let texts: Vec<String> = values.into_iter().map(number).collect();
    texts.join(" ")
}

pub(crate) fn vector(v: &Vector3<f64>) -> String {
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
pub(crate) fn escaped(text: &str) -> String {
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
