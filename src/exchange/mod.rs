//! Planned motions for other programs, as CSV, JSON, MuJoCo; key frames from tables.

#[cfg(feature = "study")]
pub mod delimited;
pub mod drives;
pub mod export;
pub mod mjcf;
#[cfg(feature = "study")]
pub mod path_table;
#[cfg(feature = "study")]
pub mod pose_columns;
#[cfg(feature = "study")]
pub mod pose_rows;
#[cfg(feature = "study")]
pub mod pose_table;
pub mod table;
pub mod xml;
