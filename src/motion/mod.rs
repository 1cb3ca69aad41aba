//! Motions of the workpiece: the goal through its key frames, and the planned motion as columns.

pub mod goal;
mod quaternion_spline;
pub mod trajectory;
