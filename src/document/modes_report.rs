//! The ways to assemble a document's linkage at a key frame, as a page and the command read them: plain numbers under the names
//! of their JSON. Everything counts from 0.

use crate::document::bounds::no_index;
use crate::document::fault::{Fault, Place};
use crate::document::problem::{Problem, start_values};
use crate::document::schema::MotionEntry;
use crate::motion::columns::placed;
use crate::motion::trajectory::Trajectory;
use crate::plan::assemblies::{Assemblies, Mode};
use serde::Serialize;

/// The search so far.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ModesReport {
    /// The key frame.
    pub key: usize,
    /// The frame at its time, or the nearest: its goal is the pose that is asked for.
    pub frame: usize,
    /// From 0 to 1; the search is the first half, planning from each way the second.
    pub progress: f64,
    /// Starts made so far.
    pub starts: usize,
    /// The estimated share of starts that lead to a way not known (Good and Turing).
    pub unseen: f64,
    /// That share is at most this, with a confidence of 95 %.
    pub unseen_bound: f64,
    /// The nearest first; when motions are planned from all, those with most certified frames and the least mean first.
    pub found: Vec<ModeReport>,
}

/// A way to assemble.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ModeReport {
    /// Its place in the list.
    pub index: usize,
    /// Joint values, rad or lengths.
    pub joints: Vec<f64>,
    /// The same as a document has them: degrees or lengths, chain by chain.
    pub start: Vec<Vec<f64>>,
    /// The frames of all rows, as a motion has them: x y z, then a quaternion x y z w, each.
    pub rows: Vec<f64>,
    /// The workpiece: x y z, then a quaternion x y z w.
    pub pose: Vec<f64>,
    /// f at the key frame.
    pub metric: f64,
    /// Whether the goal is met there.
    pub reached: bool,
    /// Starts that led to it.
    pub starts: usize,
    /// It is the assembly of the document's start.
    pub is_start: bool,
    /// Mean of f of the motion planned from it; not there before.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean: Option<f64>,
    /// Its largest f.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub largest: Option<f64>,
    /// Its certified frames.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub certified: Option<usize>,
}

impl ModesReport {
    /// Of a search at any time, which was begun by [`Problem::modes`] for that key frame.
    pub fn new(problem: &Problem, at: KeyAt, search: &Assemblies) -> Self {
        let unseen = search.unseen();
        let modes = search.modes().iter().enumerate();
        Self {
            key: at.key,
            frame: at.frame,
            progress: search.progress(),
            starts: search.starts(),
            unseen: unseen.share,
            unseen_bound: unseen.bound,
            found: modes
                .map(|(index, mode)| ModeReport::new(problem, index, mode))
                .collect(),
        }
    }
}

impl ModeReport {
    fn new(problem: &Problem, index: usize, mode: &Mode) -> Self {
        Self {
            index,
            start: start_values(&problem.mechanism, &mode.joints),
            rows: placed(&problem.frames_at(&mode.joints)),
            joints: mode.joints.clone(),
            pose: placed([&mode.pose]),
            metric: mode.value,
            reached: mode.reached,
            starts: mode.starts,
            is_start: mode.is_start,
            mean: mode.planned.map(|(cost, _)| cost.mean),
            largest: mode.planned.map(|(cost, _)| cost.largest),
            certified: mode.planned.map(|(_, certified)| certified),
        }
    }
}

/// A key frame and the frame at its time, or the nearest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KeyAt {
    /// The key frame, from 0.
    pub key: usize,
    /// The frame, from 0.
    pub frame: usize,
}

impl Problem {
    /// Where the key frame `key` of the document's motion is among the frames.
    ///
    /// # Errors
    /// When there is no such key frame, or joints are driven.
    pub fn key_at(&self, motion: &MotionEntry, key: usize) -> Result<KeyAt, Fault> {
        self.check_goals()?;
        let keys = &motion.key_frames;
        if key >= keys.len() {
            let place = Place::WHOLE.field("motion");
            return Err(no_index(&place.field("key_frames"), key, keys.len()));
        }
        let (first, last) = (self.goals[0].time, self.goals[self.goals.len() - 1].time);
        // Without times they are equally spaced.
        let time = keys[key].time.unwrap_or_else(|| {
            first + (last - first) * (key as f64 / (keys.len() - 1).max(1) as f64)
        });
        let away = |frame: &usize| (self.goals[*frame].time - time).abs();
        let frame = (0..self.goals.len()).min_by(|a, b| away(a).total_cmp(&away(b)));
        Ok(KeyAt {
            key,
            frame: frame.unwrap_or(0),
        })
    }

    /// The search for all ways to assemble the linkage there, beside the motion that was planned.
    pub fn modes(&self, at: KeyAt, followed: &Trajectory) -> Assemblies {
        let (mechanism, goals) = (&self.mechanism, &self.goals);
        Assemblies::new(mechanism, goals, at.frame, &self.settings, followed)
    }
}

#[cfg(test)]
mod tests {
    use super::ModesReport;
    use crate::document::fault::FaultCode;
    use crate::source::session::Session;

    #[test]
    fn key_frames_are_found_among_frames() {
        let text = include_str!("../../www/mechanisms/3rps.json");
        let session = Session::open(text).expect("a sample");
        let (problem, motion) = (session.problem(), &session.document().motion);
        let last = motion.key_frames.len() - 1;
        let at = |key| problem.key_at(motion, key).map(|at| at.frame);
        assert_eq!(at(0), Ok(0));
        assert_eq!(at(last), Ok(problem.frames() - 1));
        let fault = at(last + 1).expect_err("no key frame");
        assert_eq!(fault.place, "motion.key_frames");
        let driven = include_str!("../../www/mechanisms/slider-crank.json");
        let driven = Session::open(driven).expect("a sample");
        let fault = (driven.problem()).key_at(&driven.document().motion, 0);
        assert_eq!(fault.expect_err("no goals").code, FaultCode::NoGoals);
    }

    #[test]
    fn a_report_has_the_costs_once_motions_are_planned() {
        let text = include_str!("../../www/mechanisms/scara.json");
        let session = Session::open(text).expect("a sample");
        let problem = session.problem();
        let at = problem
            .key_at(&session.document().motion, 0)
            .expect("a key frame");
        let mut search = problem.modes(at, &session.plan());
        let before = ModesReport::new(problem, at, &search);
        assert_eq!((before.found.len(), before.progress), (0, 0.0));
        search.finish();
        let after = ModesReport::new(problem, at, &search);
        assert!(after.progress >= 1.0);
        assert_eq!(after.found.iter().filter(|mode| mode.is_start).count(), 1);
        for (index, mode) in after.found.iter().enumerate() {
            assert_eq!(mode.index, index);
            assert!(mode.mean.is_some() && mode.certified.is_some());
            assert_eq!(mode.joints.len(), problem.mechanism.variables());
            assert_eq!(mode.rows.len(), 7 * problem.frames_at(&mode.joints).len());
        }
    }
}
