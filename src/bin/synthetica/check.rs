//! `check`: what is wrong with documents, and how well their linkages follow the goal.

use crate::arguments::Check;
use crate::failure::{AT_FAULT, Failure};
use crate::files::Out;
use crate::planned::{Planned, check_inputs, planned};
use serde::Serialize;
use std::collections::BTreeMap;
use synthetica::document::comparison::MetricGaps;
use synthetica::document::fault::Fault;
use synthetica::document::number::readable;
use synthetica::document::report::Report;
use synthetica::motion::trajectory::{Status, Trajectory, Warning};

/// Says it of each document; fails where one is at fault, or has a frame that is not certified.
pub fn check(asked: &Check) -> Result<(), Failure> {
    check_inputs(&asked.documents, None)?;
    let mut out = Out::new(None)?;
    let mut worst = 0;
    for file in &asked.documents {
        let code = match planned(file, &asked.planning, None) {
            Ok(planned) => {
                let verdict = Verdict::new(&planned);
                out.write(&if asked.json {
                    line(&verdict)
                } else {
                    words(&verdict, &planned)
                })?;
                if verdict.ok { 0 } else { AT_FAULT }
            }
            Err(Failure::Fault { file, fault }) if asked.json => {
                out.write(&line(&Refused::new(file, fault)))?;
                AT_FAULT
            }
            Err(failure) => {
                failure.tell();
                failure.code()
            }
        };
        // In step with what goes to standard error.
        out.flush()?;
        worst = worst.max(code);
    }
    match worst {
        0 => Ok(()),
        code => Err(Failure::Said(code)),
    }
}

/// What is said of a document that plans. Frames count from 0, as they do in the library.
#[derive(Serialize)]
struct Verdict<'a> {
    file: &'a str,
    /// Is every frame certified?
    ok: bool,
    name: &'a str,
    frames: usize,
    statuses: BTreeMap<&'a str, usize>,
    uncertified: Vec<Run>,
    /// Largest distance from the goal; null where joints are driven, and there is none.
    translation_gap: f64,
    /// The same of the rotation, degrees.
    rotation_gap: f64,
    /// Largest closure error, lengths as shares of the mechanism's size or rad.
    closure: f64,
    /// By how much rounded dimensions contradict each other at most, as `closure`.
    misfit: f64,
    /// The largest gaps of the motion planned with either metric, rotations in degrees.
    metrics: [MetricGaps; 2],
    /// Frames between which the linkage leaps.
    leaps: Vec<Frames>,
    /// Frames near a singular position.
    near_singular: Vec<Frames>,
    report: Report,
}

/// Frames that a warning is about.
#[derive(Serialize)]
struct Frames {
    first: usize,
    last: usize,
}

/// What is said of a document that does not.
#[derive(Serialize)]
pub struct Refused {
    file: String,
    ok: bool,
    fault: Box<Fault>,
}

impl Refused {
    pub fn new(file: String, fault: Box<Fault>) -> Self {
        let ok = false;
        Self { file, ok, fault }
    }
}

/// Neighbouring frames with the same status, not certified.
#[derive(Serialize)]
struct Run {
    first: usize,
    last: usize,
    status: &'static str,
}

impl<'a> Verdict<'a> {
    fn new(planned: &'a Planned) -> Self {
        let motion = &planned.motion;
        let metrics = planned
            .problem()
            .compare_metrics_of(motion)
            .map(|gaps| MetricGaps {
                rotation_gap: gaps.rotation_gap.to_degrees(),
                ..gaps
            });
        let mut statuses = BTreeMap::new();
        for status in &motion.status {
            *statuses.entry(status.name()).or_default() += 1;
        }
        Self {
            file: &planned.file,
            ok: motion.status.iter().all(|status| status.is_certified()),
            name: &planned.document().name,
            frames: motion.frames(),
            statuses,
            uncertified: uncertified(motion),
            translation_gap: largest(&motion.translation_gap),
            rotation_gap: largest(&motion.rotation_gap).to_degrees(),
            closure: largest(&motion.closure),
            misfit: largest(&motion.misfit),
            metrics,
            leaps: leaps(motion),
            near_singular: near_singular(motion),
            report: Report::new(
                &planned.problem().mechanism,
                &planned.problem().length_unit,
                motion,
            ),
        }
    }
}

/// For a program: one line.
pub fn line(value: &impl Serialize) -> String {
    let text = serde_json::to_string(value).expect("plain data becomes JSON");
    text + "\n"
}

/// For a person.
fn words(verdict: &Verdict, planned: &Planned) -> String {
    let report = &verdict.report;
    let chains: Vec<&str> = report.chains.iter().map(|c| c.kind.as_str()).collect();
    let statuses: Vec<String> = (Status::ALL.iter())
        .filter_map(|status| verdict.statuses.get_key_value(status.name()))
        .map(|(status, frames)| format!("{frames} {status}"))
        .collect();
    let unit = match planned.document().length_unit.as_str() {
        "" => "lengths",
        unit => unit,
    };
    let (rank, count) = (report.mobility_rank, report.mobility_count);
    let (shift, turn) = (verdict.translation_gap, verdict.rotation_gap);
    let mut lines = vec![
        format!("{}: {}", verdict.file, verdict.name),
        format!("  chains    {}", chains.join(", ")),
        format!("  mobility  {rank} by rank, {count} by count"),
        format!("  frames    {}: {}", verdict.frames, statuses.join(", ")),
        if report.drivers.is_empty() {
            let (shift, turn) = (readable(shift), readable(turn));
            format!("  gap       up to {shift} {unit} and {turn}°")
        } else {
            let wording = planned.problem().wording();
            let driven = report.drivers.iter().map(|&v| wording.variable(v));
            let driven: Vec<String> = driven.collect();
            format!("  driven    {}", driven.join(", "))
        },
        format!(
            "  loops     {} {:.1e}, at most {:.1e}",
            if verdict.closure <= report.bounds.closure {
                "closed to"
            } else {
                "open by"
            },
            verdict.closure,
            report.bounds.closure
        ),
    ];
    if verdict.misfit > report.bounds.closure {
        lines.push(format!(
            "  misfit    {:.1e}, at most {:.1e}",
            verdict.misfit, report.bounds.misfit
        ));
    }
    if report.drivers.is_empty() {
        lines.push(format!("  metric    {}", metric(report, unit)));
        let either = verdict.metrics.each_ref().map(|gaps| {
            let MetricGaps {
                metric,
                translation_gap: shift,
                rotation_gap: turn,
                ..
            } = gaps;
            format!("{metric} {} {unit}, {}°", readable(*shift), readable(*turn))
        });
        lines.push(format!("  compared  {}", either.join(" | ")));
    }
    lines.push(format!(
        "  leaps     {}",
        list(&verdict.leaps, "between frames ", " and ")
    ));
    lines.push(format!(
        "  singular  {}",
        list(&verdict.near_singular, "nearly, in frames ", " to ")
    ));
    let said = warnings(report, &planned.motion);
    lines.extend(said.iter().map(|said| format!("  warning   {said}")));
    lines.join("\n") + "\n"
}

/// Such as: pose, length 0.5 m (from the mechanism's size).
fn metric(report: &Report, unit: &str) -> String {
    let used = &report.metric;
    let source = match used.length_source {
        "given" => "as the document says",
        "mechanism" => "the mechanism's size",
        "motion" => "the extent of the motion",
        _ => "there is no other length",
    };
    let about = used.origin.map(|[x, y, z]| {
        let [x, y, z] = [x, y, z].map(readable);
        format!(" about ({x}, {y}, {z}) {unit}")
    });
    format!(
        "{}{}, length {} {unit} ({source})",
        used.kind,
        about.unwrap_or_default(),
        readable(used.length)
    )
}

/// Frames count from 1 here.
fn list(frames: &[Frames], before: &str, between: &str) -> String {
    let spans: Vec<String> = frames
        .iter()
        .map(|f| format!("{}{between}{}", f.first + 1, f.last + 1))
        .collect();
    if spans.is_empty() {
        "none".to_owned()
    } else {
        format!("{before}{}", spans.join(", "))
    }
}

fn leaps(motion: &Trajectory) -> Vec<Frames> {
    let mut leaps = Vec::new();
    for warning in &motion.warnings {
        if let Warning::BranchJump { first, .. } = *warning {
            leaps.push(Frames {
                first,
                last: first + 1,
            });
        }
    }
    leaps
}

fn near_singular(motion: &Trajectory) -> Vec<Frames> {
    let mut intervals = Vec::new();
    for warning in &motion.warnings {
        if let Warning::NearSingular { first, last, .. } = *warning {
            intervals.push(Frames { first, last });
        }
    }
    intervals
}

/// What deserves a look, in sentences.
pub fn warnings(report: &Report, motion: &Trajectory) -> Vec<String> {
    let mut said: Vec<String> = (report.warnings.iter())
        .map(|warning| warning.message.clone())
        .collect();
    let runs = uncertified(motion);
    if !runs.is_empty() {
        let frames: usize = runs.iter().map(|run| run.last - run.first + 1).sum();
        let list: Vec<String> = runs.iter().map(Run::words).collect();
        let (all, list) = (motion.frames(), list.join(", "));
        said.push(format!(
            "{frames} of {all} frames are not certified: {list}."
        ));
    }
    said
}

/// Frames of a calm motion are passing because that was asked for.
fn uncertified(motion: &Trajectory) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for (frame, status) in motion.status.iter().enumerate() {
        let name = status.name();
        match runs.last_mut() {
            _ if status.is_certified() || *status == Status::Passing => {}
            Some(run) if run.status == name && run.last + 1 == frame => run.last = frame,
            _ => runs.push(Run {
                first: frame,
                last: frame,
                status: name,
            }),
        }
    }
    runs
}

impl Run {
    /// Frames count from 1 here.
    fn words(&self) -> String {
        let (first, last, status) = (self.first + 1, self.last + 1, self.status);
        if first == last {
            format!("{first} {status}")
        } else {
            format!("{first} to {last} {status}")
        }
    }
}

/// No number where there is none: the gaps of a motion without goals.
fn largest(values: &[f64]) -> f64 {
    let known = values.iter().copied().filter(|value| !value.is_nan());
    known.reduce(f64::max).unwrap_or(f64::NAN)
}
