//! A plan in portions, of either kind of motion: towards goals, or with driven joints.

#[cfg(not(feature = "study"))]
pub use crate::plan::follow::Planning;

#[cfg(feature = "study")]
use crate::{motion::trajectory::Trajectory, plan::driven, plan::follow};

/// A plan in portions: frame by frame, and at any time what there is so far.
#[cfg(feature = "study")]
#[derive(Clone, Debug)]
pub enum Planning {
    /// Towards goals.
    Goals(Box<follow::Planning>),
    /// With driven joints.
    Driven(Box<driven::Planning>),
}

#[cfg(feature = "study")]
impl Planning {
    /// Frames in all.
    pub fn frames(&self) -> usize {
        match self {
            Self::Goals(planning) => planning.frames(),
            Self::Driven(planning) => planning.frames(),
        }
    }

    /// Frames planned so far.
    pub fn done(&self) -> usize {
        match self {
            Self::Goals(planning) => planning.done(),
            Self::Driven(planning) => planning.done(),
        }
    }

    /// Plans one more frame, or a portion of one, or computes what is left of the report; false when there is nothing
    /// left. Frames may be taken back, so that [`Planning::done`] falls.
    pub fn advance(&mut self) -> bool {
        match self {
            Self::Goals(planning) => planning.advance(),
            Self::Driven(planning) => planning.advance(),
        }
    }

    /// The frames planned so far as a motion with its report.
    pub fn so_far(&self) -> Trajectory {
        match self {
            Self::Goals(planning) => planning.so_far(),
            Self::Driven(planning) => planning.so_far(),
        }
    }

    /// Plans the rest; the whole motion.
    pub fn finish(self) -> Trajectory {
        match self {
            Self::Goals(planning) => planning.finish(),
            Self::Driven(planning) => planning.finish(),
        }
    }
}
