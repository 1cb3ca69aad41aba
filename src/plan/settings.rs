//! What a plan needs beside mechanism and goals: method, metric, tolerance of dimensions, limits of iterations.

use crate::math::metric::{Metric, MetricKind};
use crate::math::norm::norm;
use crate::model::mechanism::{Mechanism, ROUNDING};
use crate::model::scaled::Scaled;
use crate::motion::goal::Goal;
use crate::motion::trajectory::LengthSource;
use crate::solve::solver::Solver;
use nalgebra::Vector3;

/// Which of the two planners.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// Newton's method on the linkage's freedoms.
    #[default]
    Newton,
    /// The paper's projected gradient (Fig. 3), for reference and teaching.
    Gradient,
}

/// How far dimensions may contradict each other and still count as rounded, as a share of the mechanism's size and in
/// rad: numbers with four decimals of the size pass, and a Bennett linkage with 149.9° in place of 150° (3e-3, rigid)
/// does not. The surplus constraints of rounded linkages are within 1e-5 to 3e-4 of dependence, all others of linkages
/// that move are off it by 0.1 and more.
pub const DIMENSION_TOLERANCE: f64 = 3e-4;

/// The package that a page loads first: what a motion needs only sometimes is in the whole one.
pub const IS_FIRST: bool = cfg!(all(target_arch = "wasm32", not(feature = "study")));

/// How to find the closest motion: plain data, as a document holds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The planner.
    pub method: Method,
    /// How distances between poses are measured.
    pub metric: MetricKind,
    /// Characteristic length of the metric, in the mechanism's unit: a translation by it weighs as much as a rotation
    /// by 1 rad. `None` for [`characteristic_length`].
    pub metric_length: Option<f64>,
    /// The point about which the metric [`MetricKind::DualQuaternion`] measures; `None` for the fixed frame's origin.
    pub metric_origin: Option<Vector3<f64>>,
    /// How far rounded dimensions may contradict each other, as a share of the size and in rad; 0 for exact dimensions
    /// only.
    pub dimension_tolerance: f64,
    /// Iterations a frame may take before it counts as stalled; `None` for the method's own limit.
    pub max_iterations: Option<usize>,
}

impl Default for Settings {
    /// Newton, poses compared about the goal's origin in a length of the mechanism.
    fn default() -> Self {
        Self {
            method: Method::default(),
            metric: MetricKind::default(),
            metric_length: None,
            metric_origin: None,
            dimension_tolerance: DIMENSION_TOLERANCE,
            max_iterations: None,
        }
    }
}

impl Settings {
    /// The paper's metric (L = 1, about the fixed frame's origin).
    pub const PAPER: Self = Self {
        method: Method::Newton,
        metric: MetricKind::DualQuaternion,
        metric_length: Some(Metric::PAPER.length),
        metric_origin: None,
        dimension_tolerance: DIMENSION_TOLERANCE,
        max_iterations: None,
    };

    /// The same with Newton's method, for what does not depend on the document's method.
    pub fn by_newton(&self) -> Self {
        Self {
            method: Method::Newton,
            ..*self
        }
    }

    /// The metric for this mechanism and a motion of this extent.
    pub fn metric_for(&self, mechanism: &Mechanism, extent: f64) -> Metric {
        Metric {
            kind: self.metric,
            length: self
                .metric_length
                .unwrap_or_else(|| characteristic_length(mechanism, extent).0),
            origin: self.metric_origin.unwrap_or_default(),
        }
    }

    /// A solver of this mechanism for a motion of this extent.
    pub fn solver(&self, mechanism: &Mechanism, extent: f64) -> Solver {
        let scaled = Scaled::new(mechanism, extent);
        Solver::new(
            scaled,
            &self.metric_for(mechanism, extent),
            self.iterations(),
        )
    }

    /// Is it the paper's projected gradient? The package that a page loads first has only Newton's method, and leaves other
    /// documents to the whole one.
    pub const fn is_gradient(&self) -> bool {
        !IS_FIRST && matches!(self.method, Method::Gradient)
    }

    /// Iterations that a frame may take.
    pub fn iterations(&self) -> usize {
        let own = if self.is_gradient() {
            GRADIENT_ITERATIONS
        } else {
            NEWTON_ITERATIONS
        };
        self.max_iterations.unwrap_or(own)
    }
}

/// Linear systems that a frame may take: more than any certified frame was seen to need.
pub const NEWTON_ITERATIONS: usize = 500;
/// Gradient steps that a frame may take; near gimbal lock the 3RPS takes some 20,000.
pub const GRADIENT_ITERATIONS: usize = 30_000;

/// The length by which a metric weighs translations where none is given: the mechanism's size, so that a turn by 1 rad
/// weighs as much as the way that it carries the workpiece at the end of the longest chain; else the extent of the
/// motion; else 1.
pub fn characteristic_length(mechanism: &Mechanism, extent: f64) -> (f64, LengthSource) {
    let source = match mechanism.size_beside(extent) {
        Some(_) => LengthSource::Mechanism,
        None if extent > 0.0 => LengthSource::Motion,
        None => LengthSource::None,
    };
    (mechanism.size_or(extent), source)
}

/// The extent of a motion: the largest distance of its positions from the first; 0 where it is rounding beside their
/// distances from the fixed frame's origin.
pub fn extent(goals: &[Goal]) -> f64 {
    let positions = || goals.iter().map(|goal| goal.pose.translation.vector);
    let Some(first) = positions().next() else {
        return 0.0;
    };
    let away = positions()
        .map(|position| norm(&position))
        .fold(0.0, f64::max);
    let extent = positions()
        .map(|position| norm(&(position - first)))
        .fold(0.0, f64::max);
    if extent > ROUNDING * away {
        extent
    } else {
        0.0
    }
}
