//! Whether a table was copied from a source with the other convention.

use crate::document::problem::Problem;
use crate::document::reader::Node;
use crate::document::schema::Document;
use crate::document::text::{document_of, json, node_of};
use crate::math::pose::gaps;
use crate::source::chains;

/// Do the rows, read as standard tables, put every chain on the first key frame at its given start, and do they not as
/// they are read?
pub(crate) fn looks_standard(document: &Document, problem: &Problem) -> bool {
    /// Share of the size, or rad: starts and key frames with six digits.
    const MEETS: f64 = 1e-5;
    let is_met = |problem: &Problem| distance(problem).is_some_and(|distance| distance <= MEETS);
    // Most documents end here.
    let Some(distance) = distance(problem) else {
        return false;
    };
    distance > MEETS && as_standard(document).is_some_and(|standard| is_met(&standard))
}

/// How far any chain is from the first goal at its start, as a share of the size or in rad; `None` where a chain has no
/// start.
fn distance(problem: &Problem) -> Option<f64> {
    let mechanism = &problem.mechanism;
    let size = mechanism.size().unwrap_or(1.0);
    let goal = problem.goals.first()?;
    let mut farthest: f64 = 0.0;
    for (chain, start) in mechanism.chains().iter().zip(&problem.start) {
        let (shift, turn) = gaps(&chain.pose(start.as_ref()?), &goal.pose);
        farthest = farthest.max(shift / size).max(turn);
    }
    Some(farthest)
}

fn as_standard(document: &Document) -> Option<Problem> {
    let mut document = document.clone();
    // Only the first key frame is looked at, and there may be 100,000.
    document.motion.key_frames.truncate(2);
    let mut node = node_of(&json(&document)).ok()?;
    let chains = node
        .field_mut("chains")
        .map_or(&mut [][..], Node::items_mut);
    for chain in chains {
        chain.set("convention", Node::Text("standard".to_owned()));
    }
    chains::to_plain(&mut node).ok()?;
    Problem::new(&document_of(&node).ok()?).ok()
}
