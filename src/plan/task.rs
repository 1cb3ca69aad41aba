//! What a search for the best motion is given.

use crate::model::mechanism::Mechanism;
use crate::motion::goal::Goal;
use crate::motion::trajectory::Trajectory;
use crate::plan::settings::Settings;

/// A mechanism, the goals of all frames, and the motion that the planner follows.
#[derive(Clone, Debug)]
pub(super) struct Task {
    pub mechanism: Mechanism,
    pub goals: Vec<Goal>,
    /// By Newton's method, whatever the document plans with.
    pub settings: Settings,
    pub followed: Trajectory,
}
