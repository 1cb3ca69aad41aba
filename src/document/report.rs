//! A planned motion as a page reads it: names, units and sentences.

use crate::document::chain_report::{ChainReport, chain};
use crate::document::problem::start_values;
#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
use crate::document::warnings::{WarningReport, warning};
#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
use crate::document::wording::Wording;
use crate::math::metric::MetricKind;
use crate::model::mechanism::Mechanism;
use crate::motion::trajectory::{Bounds, Status, Trajectory};
use serde::Serialize;

/// What is said about a motion beside its columns of numbers.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Names of the status codes.
    pub statuses: Vec<&'static str>,
    /// The chains, in the document's order.
    pub chains: Vec<ChainReport>,
    /// The driven joint variables, counted from 0 through all chains; none where the motion has goals.
    #[cfg(feature = "study")]
    pub drivers: Vec<usize>,
    /// Mobility by Eq. 10.
    pub mobility_count: isize,
    /// n − rank \[A\] at the start.
    pub mobility_rank: usize,
    /// How distances were measured.
    pub metric: MetricReport,
    /// The bounds that were used.
    pub bounds: Bounds,
    /// Largest misfit of rounded dimensions in any frame.
    pub misfit: f64,
    /// What deserves a look.
    #[cfg(any(feature = "study", not(target_arch = "wasm32")))]
    pub warnings: Vec<WarningReport>,
    /// The same.
    #[cfg(all(target_arch = "wasm32", not(feature = "study")))]
    pub warnings: first::Warnings,
    /// Joint values from which the motion was planned, degrees or lengths, chain by chain.
    pub start: Vec<Vec<f64>>,
}

/// Warnings of the package that a page loads first.
#[cfg(all(target_arch = "wasm32", not(feature = "study")))]
mod first {
    use crate::document::warnings::{WarningReport, mobility_differs};
    use crate::motion::trajectory::Warning;
    use serde::Serialize;

    /// In words where it has them, otherwise as data, for which the whole package has.
    #[derive(Clone, Debug, Serialize)]
    #[serde(untagged)]
    pub enum Warnings {
        Words(Vec<WarningReport>),
        Data(Vec<Warning>),
    }

    impl Warnings {
        pub fn new(all: &[Warning]) -> Self {
            let words = all.iter().map(|warning| {
                let Warning::MobilityDiffers { count, rank } = *warning else {
                    return None;
                };
                Some(mobility_differs(count, rank))
            });
            words
                .collect::<Option<_>>()
                .map_or_else(|| Self::Data(all.to_vec()), Self::Words)
        }
    }
}

/// The metric that was used.
#[derive(Clone, Debug, Serialize)]
pub struct MetricReport {
    /// `pose` or `dual-quaternion`.
    pub kind: &'static str,
    /// The characteristic length, in the document's unit.
    pub length: f64,
    /// Where it comes from: `given`, `mechanism`, `motion` or `none`.
    pub length_source: &'static str,
    /// The point about which `dual-quaternion` measures.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origin: Option<[f64; 3]>,
}

/// The name of a metric in documents and reports.
pub const fn metric_name(kind: MetricKind) -> &'static str {
    match kind {
        MetricKind::Pose => "pose",
        MetricKind::DualQuaternion => "dual-quaternion",
    }
}

impl Report {
    /// The report of a motion of this mechanism; `unit` is the label of the unit of length, which may be empty.
    pub fn new(mechanism: &Mechanism, unit: &str, trajectory: &Trajectory) -> Self {
        #[cfg(any(feature = "study", not(target_arch = "wasm32")))]
        let warnings = {
            let wording = Wording { mechanism, unit };
            let all = trajectory.warnings.iter();
            all.map(|w| warning(w, &wording)).collect()
        };
        #[cfg(all(target_arch = "wasm32", not(feature = "study")))]
        let (warnings, _) = (first::Warnings::new(&trajectory.warnings), unit);
        let metric = &trajectory.metric_used;
        Self {
            statuses: Status::ALL.map(Status::name).to_vec(),
            chains: mechanism.chains().iter().map(chain).collect(),
            #[cfg(feature = "study")]
            drivers: trajectory.drivers.clone(),
            mobility_count: trajectory.mobility_count,
            mobility_rank: trajectory.mobility_rank,
            metric: MetricReport {
                kind: metric_name(metric.kind),
                length: metric.length,
                length_source: trajectory.length_source.name(),
                origin: (metric.kind == MetricKind::DualQuaternion).then(|| metric.origin.into()),
            },
            bounds: trajectory.bounds,
            misfit: trajectory.misfit.iter().copied().fold(0.0, f64::max),
            warnings,
            start: start_values(mechanism, &trajectory.start),
        }
    }
}
