//! Planned motions for other programs: CSV, JSON, MuJoCo.

pub mod export;
pub mod mjcf;
pub mod table;
