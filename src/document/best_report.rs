//! What the search for the best motion found so far, as a page and the command read it: plain numbers under the names of its
//! JSON. Frames count from 0.

use crate::document::fault::{Fault, FaultCode, Place};
use crate::document::problem::Problem;
use crate::motion::trajectory::Trajectory;
use crate::plan::best::Search;
use crate::plan::found::Cost;
use crate::plan::found::Found;
use crate::plan::found::Lane;
use crate::plan::found::Switch;
use serde::Serialize;

/// The search so far.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BestReport {
    /// From 0 to 1.
    pub progress: f64,
    /// Starts made so far.
    pub starts: usize,
    /// How close the motion that the planner follows comes.
    pub followed: CostReport,
    /// How close the best motion so far comes: the followed one until branches are known. It may be farther where the followed
    /// one leaps as no linkage can.
    pub best: CostReport,
    /// Mean over the frames of the least f seen there: no motion over the branches known is closer. 0 until branches are
    /// known.
    pub lower_bound: f64,
    /// The estimated share of starts that lead to a branch not known (Good and Turing).
    pub unseen: f64,
    /// That share is at most this, with a confidence of 95 %.
    pub unseen_bound: f64,
    /// Runs of frames; the first is the followed motion.
    pub branches: Vec<BranchReport>,
    /// The branch of each frame of the best motion, an index of `branches`; −1 where there is none.
    pub lane: Vec<i32>,
    /// Where the best motion changes its branch.
    pub switches: Vec<SwitchReport>,
    /// Closer to calmer, prices rising; empty until the search is complete.
    pub curve: Vec<CalmPoint>,
    /// Frames in which the followed motion has no certified pose, and the best has.
    pub found_where_lost: Vec<usize>,
}

/// How close a motion comes to its goals.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CostReport {
    /// Mean of f over the frames.
    pub mean: f64,
    /// Largest f.
    pub largest: f64,
    /// Largest joint motion from one frame to the next, rad or sizes.
    pub largest_step: f64,
}

/// A branch: f over its frames.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BranchReport {
    /// Its first frame.
    pub first: usize,
    /// f, frame by frame; of long motions linear between the frames that are searched.
    pub metric: Vec<f64>,
}

/// A change of branch.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SwitchReport {
    /// It comes before this frame, while its goal stands; before frame 0 it comes after the start.
    pub frame: usize,
    /// Time of that frame.
    pub time: f64,
    /// The branch before it.
    pub from: usize,
    /// The branch after it.
    pub to: usize,
    /// Joint motion on the way, root of squares, rad and sizes.
    pub length: f64,
    /// Largest f on the way.
    pub largest: f64,
    /// Points on the way, the frame's own included.
    pub points: usize,
}

/// The calm form at a price.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CalmPoint {
    /// The price of joint motion.
    pub price: f64,
    /// How close it comes.
    #[serde(flatten)]
    pub cost: CostReport,
}

impl BestReport {
    /// Of a search at any time.
    pub fn new(search: &Search) -> Self {
        let (followed, unseen) = (search.followed(), search.unseen());
        let found = search.found();
        let own = search.followed_cost();
        Self {
            progress: search.progress(),
            starts: search.starts(),
            followed: own.into(),
            best: found.map_or(own, |found| found.cost).into(),
            lower_bound: found.map_or(0.0, |found| found.lower_bound),
            unseen: unseen.share,
            unseen_bound: unseen.bound,
            branches: branches(found, followed),
            lane: lane(found, followed),
            switches: found.map_or_else(Vec::new, |found| {
                let switches = found.switches.iter();
                switches
                    .map(|switch| SwitchReport::new(switch, &found.motion))
                    .collect()
            }),
            curve: search.curve().iter().map(CalmPoint::of).collect(),
            found_where_lost: found.map_or_else(Vec::new, |found| found.found_where_lost.clone()),
        }
    }
}

fn branches(found: Option<&Found>, followed: &Trajectory) -> Vec<BranchReport> {
    let report = |lane: &Lane| BranchReport {
        first: lane.first,
        metric: lane.values.clone(),
    };
    match found {
        Some(found) => found.lanes.iter().map(report).collect(),
        None => vec![BranchReport {
            first: 0,
            metric: followed.metric.clone(),
        }],
    }
}

fn lane(found: Option<&Found>, followed: &Trajectory) -> Vec<i32> {
    match found {
        Some(found) => (found.lane.iter())
            .map(|&lane| i32::try_from(lane).unwrap_or(-1))
            .collect(),
        None => (followed.status.iter())
            .map(|status| if status.is_certified() { 0 } else { -1 })
            .collect(),
    }
}

impl SwitchReport {
    fn new(switch: &Switch, motion: &Trajectory) -> Self {
        let &Switch {
            frame,
            from,
            to,
            length,
            largest,
            points,
        } = switch;
        Self {
            frame,
            time: motion.time[frame],
            from,
            to,
            length,
            largest,
            points,
        }
    }
}

impl CalmPoint {
    fn of(&(price, cost): &(f64, Cost)) -> Self {
        Self {
            price,
            cost: cost.into(),
        }
    }
}

impl From<Cost> for CostReport {
    fn from(cost: Cost) -> Self {
        Self {
            mean: cost.mean,
            largest: cost.largest,
            largest_step: cost.largest_step,
        }
    }
}

impl Problem {
    /// The search for the best motion, beside the motion that was planned.
    ///
    /// # Errors
    /// Where joints are driven: there is no goal that a motion could be closer to.
    pub fn best(&self, followed: Trajectory) -> Result<Search, Fault> {
        self.check_goals()?;
        Ok(Search::new(
            &self.mechanism,
            &self.goals,
            &self.settings,
            followed,
        ))
    }

    /// Whether the motion has goals.
    ///
    /// # Errors
    /// Where joints are driven.
    pub fn check_goals(&self) -> Result<(), Fault> {
        if self.goals.is_empty() {
            let what = "its joints are driven, and there is no goal that another motion could be closer to";
            let accepted = "a motion with key frames";
            let place = Place::WHOLE.field("motion");
            return Err(Fault::new(FaultCode::NoGoals, &place, what, accepted));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::BestReport;
    use crate::document::fault::FaultCode;
    use crate::source::session::Session;

    /// A linkage that reaches all goals: nothing is searched for.
    #[test]
    fn a_report_has_its_names_before_and_after_the_search() {
        let text = include_str!("../../www/mechanisms/scara.json");
        let session = Session::open(text).expect("a sample");
        let problem = session.problem();
        let mut search = problem.best(session.plan()).expect("goals");
        let before = BestReport::new(&search);
        assert_eq!((before.best, before.lower_bound), (before.followed, 0.0));
        search.finish().expect("closed loops");
        let after = BestReport::new(&search);
        assert_eq!(after.followed, before.followed);
        assert!(after.best.mean <= after.followed.mean);
        assert!(after.lower_bound <= after.best.mean);
        for report in [&before, &after] {
            assert_eq!(report.lane.len(), problem.frames());
            assert_eq!(report.branches[0].metric.len(), problem.frames());
            let json = serde_json::to_value(report).expect("JSON");
            for name in [
                "progress",
                "starts",
                "followed",
                "best",
                "lower_bound",
                "unseen",
            ] {
                assert!(json.get(name).is_some(), "{name}");
            }
            for name in ["mean", "largest", "largest_step"] {
                assert!(json["best"][name].is_number(), "{name}");
            }
        }
        assert_eq!((after.progress, before.curve.len()), (1.0, 0));
        assert!(after.curve.len() > 1);
        assert!(after.curve.is_sorted_by(|a, b| a.price < b.price));
    }

    #[test]
    fn driven_joints_have_no_best_motion() {
        let text = include_str!("../../www/mechanisms/slider-crank.json");
        let session = Session::open(text).expect("a document");
        let fault = (session.problem().best(session.plan())).expect_err("no goals");
        assert_eq!(
            (fault.code, fault.place.as_str()),
            (FaultCode::NoGoals, "motion")
        );
        assert_eq!(fault.accepted, "a motion with key frames");
    }
}
