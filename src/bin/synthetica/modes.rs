//! `modes`: all ways to assemble a linkage at a key frame, and how close the motion from each comes.

use crate::arguments::Modes;
use crate::check::{Refused, line};
use crate::failure::{AT_FAULT, Failure, NO_ANSWER, at_fault, tell};
use crate::files::{self, Out};
use crate::planned::{Planned, check_inputs, planned};
use crate::progress::{PARTS, Progress, part};
use serde::Serialize;
use std::path::Path;
use synthetica::document::modes_report::{ModeReport, ModesReport};
use synthetica::document::number::readable;

/// Says it of each document, or prints one with another start.
pub fn modes(asked: &Modes) -> Result<(), Failure> {
    check_inputs(&asked.documents, asked.key_frames.key_frames.as_deref())?;
    match (asked.start, &asked.documents[..]) {
        (None, _) => report(asked),
        (Some(mode), [document]) => restarted(asked, mode, document),
        (Some(_), _) => {
            tell("error: --start prints one document. Accepted: one document with it");
            Err(Failure::Said(NO_ANSWER))
        }
    }
}

fn searched(asked: &Modes, file: &Path) -> Result<(Planned, ModesReport), Failure> {
    let planned = planned(file, &asked.planning, Some(&asked.key_frames))?;
    let problem = planned.problem();
    let at = problem.key_at(&planned.document().motion, asked.key);
    let at = at_fault(&planned.file, at)?;
    let mut search = problem.modes(at, &planned.motion);
    let mut progress = Progress::new("part", PARTS);
    while search.advance() {
        progress.at(part(search.progress()));
    }
    drop(progress);
    let mut report = ModesReport::new(problem, at, &search);
    // For drawing.
    report.found.iter_mut().for_each(|mode| mode.rows.clear());
    Ok((planned, report))
}

/// The document with the joint values of a way as its start.
fn restarted(asked: &Modes, mode: usize, file: &Path) -> Result<(), Failure> {
    let (planned, report) = searched(asked, file)?;
    let Some(mode) = report.found.get(mode) else {
        let accepted = match report.found.len() {
            0 => "none: no way to assemble was found".to_owned(),
            count => format!("0 to {}", count - 1),
        };
        tell(&format!(
            "{}: mode {mode} is none. Accepted: {accepted}",
            planned.file
        ));
        return Err(Failure::Said(AT_FAULT));
    };
    files::write(asked.into.file(), &planned.text_with_start(&mode.joints))
}

fn report(asked: &Modes) -> Result<(), Failure> {
    let mut out = Out::new(asked.into.file())?;
    let mut worst = 0;
    for file in &asked.documents {
        let code = match searched(asked, file) {
            Ok((planned, report)) => {
                let verdict = Verdict {
                    file: &planned.file,
                    ok: !report.found.is_empty(),
                    name: &planned.document().name,
                    report,
                };
                out.write(&if asked.json {
                    line(&verdict)
                } else {
                    words(&verdict, planned.motion.frames())
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

/// What is said of a document with goals. All counts are from 0.
#[derive(Serialize)]
struct Verdict<'a> {
    file: &'a str,
    /// Was a way found?
    ok: bool,
    name: &'a str,
    #[serde(flatten)]
    report: ModesReport,
}

/// For a person.
fn words(verdict: &Verdict, frames: usize) -> String {
    let report = &verdict.report;
    let reached = report.found.iter().filter(|mode| mode.reached).count();
    let (key, frame, count) = (report.key, report.frame, report.found.len());
    let mut lines = vec![
        format!("{}: {}", verdict.file, verdict.name),
        format!("  at        key frame {key}, frame {frame}"),
        format!(
            "  found     {}, of which {reached} meet the goal there",
            counted(count, "way to assemble", "ways to assemble")
        ),
        format!(
            "  starts    {}; an estimated {} % of further starts would lead to others, at most {} % with 95 % confidence",
            report.starts,
            readable(100.0 * report.unseen),
            readable(100.0 * report.unseen_bound)
        ),
    ];
    lines.extend(report.found.iter().map(|mode| words_of(mode, frames)));
    lines.join("\n") + "\n"
}

fn words_of(mode: &ModeReport, frames: usize) -> String {
    let planned = match (mode.mean, mode.largest, mode.certified) {
        (Some(mean), Some(largest), Some(certified)) => format!(
            "motion: mean f {}, largest {}, {certified} of {frames} frames certified",
            readable(mean),
            readable(largest)
        ),
        _ => "no motion".to_owned(),
    };
    let own = if mode.is_start { ", the start's" } else { "" };
    format!(
        "  mode {:<4} f {} there; {planned}; {}{own}",
        mode.index,
        readable(mode.metric),
        counted(mode.starts, "start", "starts")
    )
}

fn counted(count: usize, one: &str, many: &str) -> String {
    let what = if count == 1 { one } else { many };
    format!("{count} {what}")
}
