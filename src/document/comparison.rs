//! A document's motion planned with either metric, to be put side by side.

use crate::document::problem::Problem;
use crate::document::report::metric_name;
use crate::math::metric::MetricKind;
use crate::motion::trajectory::Trajectory;
use crate::plan::follow::Planning;
use crate::plan::settings::Settings;
use serde::Serialize;

/// The largest gaps of a motion that was planned with one metric.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MetricGaps {
    /// `pose` or `dual-quaternion`.
    pub metric: &'static str,
    /// The metric's characteristic length, in the document's unit.
    pub length: f64,
    /// Largest distance from goal to reached origin, in the document's unit.
    pub translation_gap: f64,
    /// Largest angle from goal to reached rotation, rad.
    pub rotation_gap: f64,
}

impl MetricGaps {
    /// Those of a planned motion.
    pub fn of(motion: &Trajectory) -> Self {
        // No number where there are no goals.
        let largest = |gaps: &[f64]| {
            let known = gaps.iter().copied().filter(|gap| !gap.is_nan());
            known.reduce(f64::max).unwrap_or(f64::NAN)
        };
        Self {
            metric: metric_name(motion.metric_used.kind),
            length: motion.metric_used.length,
            translation_gap: largest(&motion.translation_gap),
            rotation_gap: largest(&motion.rotation_gap),
        }
    }
}

/// Both plans, in portions.
#[derive(Clone, Debug)]
pub struct Comparison {
    plans: [Planning; 2],
}

impl Comparison {
    /// Begins both plans from the same joint values, so that they are of the same assembly.
    ///
    /// # Panics
    /// When `start` does not have one value a joint variable.
    pub fn new(problem: &Problem, start: &[f64]) -> Self {
        let plan = |kind| plan_with(problem, start, kind);
        Self {
            plans: MetricKind::ALL.map(plan),
        }
    }

    /// Plans one more frame; false when there is none left.
    pub fn advance(&mut self) -> bool {
        let [first, second] = &mut self.plans;
        first.advance() || second.advance()
    }

    /// Plans the rest; the gaps in the order of [`MetricKind::ALL`].
    pub fn finish(self) -> [MetricGaps; 2] {
        self.plans.map(|plan| MetricGaps::of(&plan.finish()))
    }
}

impl Problem {
    /// The largest gaps of the motion with the metric `pose` and with `dual-quaternion`, all other settings and the start
    /// as the document has them.
    pub fn compare_metrics(&self) -> [MetricGaps; 2] {
        Comparison::new(self, &self.find_start()).finish()
    }

    /// The same, where the document's own motion is planned already.
    pub fn compare_metrics_of(&self, motion: &Trajectory) -> [MetricGaps; 2] {
        MetricKind::ALL.map(|kind| {
            if kind == motion.metric_used.kind {
                MetricGaps::of(motion)
            } else {
                MetricGaps::of(&plan_with(self, &motion.start, kind).finish())
            }
        })
    }
}

fn plan_with(problem: &Problem, start: &[f64], metric: MetricKind) -> Planning {
    let settings = Settings {
        metric,
        ..problem.settings
    };
    Planning::new(&problem.mechanism, start, &problem.goals, &settings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::text;

    const SAMPLE: &str = include_str!("../../www/mechanisms/2tpr.json");

    /// One of the two is the document's own motion; the other one differs.
    #[test]
    fn both_metrics_are_planned() {
        let document = text::parse(SAMPLE).expect("a sample");
        let problem = Problem::new(&document).expect("a sample");
        let motion = problem.plan();
        let gaps = problem.compare_metrics();
        assert_eq!(
            gaps.each_ref().map(|g| g.metric),
            ["pose", "dual-quaternion"]
        );
        assert_eq!(gaps[1], MetricGaps::of(&motion));
        assert!(
            (gaps[0].rotation_gap - gaps[1].rotation_gap).abs() > 1e-6,
            "{gaps:?}"
        );
        assert!(
            gaps.iter()
                .all(|g| (g.length - 1.0).abs() < 1e-12 && g.translation_gap > 0.0),
            "{gaps:?}"
        );
        assert_eq!(problem.compare_metrics_of(&motion), gaps);
    }

    #[test]
    fn portions_are_the_same_comparison() {
        let document = text::parse(SAMPLE).expect("a sample");
        let problem = Problem::new(&document).expect("a sample");
        let mut comparison = Comparison::new(&problem, &problem.find_start());
        let mut frames = 1;
        while comparison.advance() {
            frames += 1;
        }
        assert!(frames >= 2 * problem.goals.len() - 2, "{frames}");
        assert_eq!(comparison.finish(), problem.compare_metrics());
    }
}
