//! Types of linkages (Section 4): counted, listed, and made into linkages.

pub mod enumerate;
pub mod example;
mod fit;
pub mod leg;
pub mod mobility;
pub mod notation;
pub mod sized;
pub mod sizes;
pub mod tables;
