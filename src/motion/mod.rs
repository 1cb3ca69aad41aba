//! Motions of the workpiece: the goal through its key frames, and the planned motion as columns.

pub mod columns;
mod double_quaternion;
#[cfg(feature = "study")]
pub mod drivers;
pub mod goal;
pub mod key_frames;
mod quaternion_spline;
mod screw_motion;
pub mod trajectory;
