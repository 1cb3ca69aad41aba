//! `best`: the motion closest to the goal over all branches that closed walks join to the start, and what is known of it.

use crate::arguments::Best;
use crate::check::{Refused, line, warnings};
use crate::failure::{AT_FAULT, Failure, NO_ANSWER, at_fault, tell};
use crate::files::{self, Out};
use crate::motion::{check, warn};
use crate::options::Table;
use crate::planned::{Planned, check_inputs, planned};
use crate::progress::{PARTS, Progress, part};
use serde::Serialize;
use std::path::Path;
use synthetica::Trajectory;
use synthetica::document::best_report::{BestReport, CostReport, SwitchReport};
use synthetica::document::number::readable;
use synthetica::document::report::Report;
use synthetica::exchange::export::Options;
use synthetica::exchange::path_table;
use synthetica::motion::trajectory::Status;
use synthetica::plan::best::Search;
use synthetica::plan::found::Found;

/// Share by which the mean must fall for a motion to be called closer.
const CLOSER: f64 = 1e-3;

/// Says it of each document, or prints the motion of one.
pub fn best(asked: &Best) -> Result<(), Failure> {
    check_inputs(&asked.documents, asked.key_frames.key_frames.as_deref())?;
    match (asked.format, &asked.documents[..]) {
        (None, _) if asked.tables.headings.is_some() => {
            tell("error: --headings is of a table. Accepted: --format csv with it");
            Err(Failure::Said(NO_ANSWER))
        }
        (None, _) => report(asked),
        (Some(format), [document]) => motion(asked, format, document),
        (Some(_), _) => {
            tell("error: --format prints one motion. Accepted: one document with it");
            Err(Failure::Said(NO_ANSWER))
        }
    }
}

/// A document, its followed motion, and the complete search.
struct Searched {
    planned: Planned,
    search: Search,
}

impl Searched {
    fn new(asked: &Best, file: &Path) -> Result<Self, Failure> {
        let planned = planned(file, &asked.planning, Some(&asked.key_frames))?;
        let followed = planned.motion.clone();
        let mut search = at_fault(&planned.file, planned.problem().best(followed))?;
        let mut progress = Progress::new("part", PARTS);
        while search.advance() {
            progress.at(part(search.progress()));
        }
        drop(progress);
        Ok(Self { planned, search })
    }

    /// The best motion; where the loops do not close, the followed one.
    fn motion(&self) -> &Trajectory {
        let found = self.search.found();
        found.map_or(self.search.followed(), |found| &found.motion)
    }
}

fn report(asked: &Best) -> Result<(), Failure> {
    let mut out = Out::new(asked.into.file())?;
    let mut worst = 0;
    for file in &asked.documents {
        let code = match Searched::new(asked, file) {
            Ok(searched) => {
                let verdict = Verdict::new(&searched);
                out.write(&if asked.json {
                    line(&verdict)
                } else {
                    words(&verdict, &searched, asked.quiet)
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

fn motion(asked: &Best, format: Table, file: &Path) -> Result<(), Failure> {
    let wished = Options {
        headings: asked.tables.headings,
        ..Options::default()
    };
    check(wished, format.into())?;
    let mut searched = Searched::new(asked, file)?;
    let calm = asked.calm.map(|price| searched.search.calm(price));
    let Searched { planned, search } = &searched;
    let found = search.found();
    let (Some(found), None | Some(Some(_))) = (found, &calm) else {
        tell(&format!("{}: {OPEN}", planned.file));
        return Err(Failure::Said(AT_FAULT));
    };
    let calm = calm.as_ref().and_then(Option::as_ref);
    if !asked.quiet {
        warn(planned, calm.map_or(&found.motion, |calm| &calm.motion));
    }
    let (document, problem) = (planned.document(), planned.problem());
    let text = path_table::write(format.into(), wished, document, problem, search, calm);
    files::write(asked.into.file(), &at_fault(&planned.file, text)?)
}

/// What is said of a document with goals. Frames count from 0, as they do in the library.
#[derive(Serialize)]
struct Verdict<'a> {
    file: &'a str,
    /// Is every frame of the best motion certified?
    ok: bool,
    name: &'a str,
    frames: usize,
    /// Points of the closed path; 0 where the loops of the start are open.
    points: usize,
    /// Largest closure error of all points, lengths as shares of the mechanism's size or rad.
    closure: f64,
    #[serde(flatten)]
    best: BestReport,
}

impl<'a> Verdict<'a> {
    fn new(searched: &'a Searched) -> Self {
        let motion = searched.motion();
        let path = searched.search.found().map_or(&[][..], |found| &found.path);
        let closure = path.iter().map(|point| point.closure);
        Self {
            file: &searched.planned.file,
            ok: !path.is_empty() && motion.status.iter().all(|status| status.is_certified()),
            name: &searched.planned.document().name,
            frames: motion.frames(),
            points: path.len(),
            closure: closure.fold(0.0, f64::max),
            best: BestReport::new(&searched.search),
        }
    }
}

const OPEN: &str = "the loops of the start are open, and there is no closed motion to search from";

/// For a person.
fn words(verdict: &Verdict, searched: &Searched, quiet: bool) -> String {
    let (best, motion) = (&verdict.best, searched.motion());
    let mut lines = vec![
        format!("{}: {}", verdict.file, verdict.name),
        format!("  followed  {}", cost(&best.followed)),
    ];
    if let Some(found) = searched.search.found() {
        lines.push(format!("  best      {}", cost(&best.best)));
        lines.push(format!(
            "  bound     mean f {} over the branches that are known",
            readable(best.lower_bound)
        ));
        lines.push(format!("  result    {}", result(best, found)));
        lines.push(format!("  switches  {}", switches(&best.switches)));
        lines.push(format!("  starts    {}", starts(best)));
        let statuses: Vec<String> = (Status::ALL.iter())
            .filter_map(|status| {
                let frames = motion.status.iter().filter(|own| *own == status).count();
                (frames > 0).then(|| format!("{frames} {}", status.name()))
            })
            .collect();
        lines.push(format!(
            "  frames    {}: {}",
            verdict.frames,
            statuses.join(", ")
        ));
        if !best.found_where_lost.is_empty() {
            lines.push(format!(
                "  found     {}, where the followed motion has no certified pose",
                spans(&best.found_where_lost)
            ));
        }
        lines.push(format!(
            "  path      {} points, loops closed to {:.1e}, at most {:.1e}",
            verdict.points, verdict.closure, motion.bounds.closure
        ));
    } else {
        lines.push(format!("  result    {OPEN}"));
    }
    if !quiet {
        let problem = searched.planned.problem();
        let report = Report::new(&problem.mechanism, &problem.length_unit, motion);
        let said = warnings(&report, motion);
        lines.extend(said.iter().map(|said| format!("  warning   {said}")));
    }
    lines.join("\n") + "\n"
}

fn cost(cost: &CostReport) -> String {
    let [mean, largest, step] = [cost.mean, cost.largest, cost.largest_step].map(readable);
    format!("mean f {mean}, largest {largest}; largest joint step {step} rad or sizes")
}

/// What it means, in a sentence.
fn result(best: &BestReport, found: &Found) -> String {
    let (mean, followed) = (best.best.mean, best.followed.mean);
    if found.motion.status.iter().all(|s| *s == Status::Reached) && mean <= followed {
        return "every goal is reached: no motion is closer".to_owned();
    }
    let at_bound = mean <= best.lower_bound * (1.0 + CLOSER);
    if mean < followed * (1.0 - CLOSER) {
        let share = readable(100.0 * mean / followed);
        let end = if at_bound {
            "no motion over the branches known is closer".to_owned()
        } else {
            let less = readable(100.0 * best.lower_bound / followed);
            format!("over the branches known none is below {less} %")
        };
        format!("f falls to {share} % of the followed motion's mean; {end}")
    } else if mean > followed * (1.0 + CLOSER) {
        "no closed motion that was found is as close as the followed one, in which closed walks do not join all frames"
            .to_owned()
    } else if at_bound {
        "the followed motion is the best: no motion over the branches known is closer".to_owned()
    } else {
        "no closer motion was found than the followed one".to_owned()
    }
}

/// Frames count from 1 here.
fn switches(switches: &[SwitchReport]) -> String {
    let list: Vec<String> = switches
        .iter()
        .map(|switch| {
            let [time, length, largest] =
                [switch.time, switch.length, switch.largest].map(readable);
            let (frame, from, to) = (switch.frame + 1, switch.from, switch.to);
            format!(
                "before frame {frame} (time {time}) from branch {from} to {to}: joint motion {length} rad and sizes, f up to {largest}"
            )
        })
        .collect();
    if list.is_empty() {
        "none".to_owned()
    } else {
        list.join("; ")
    }
}

/// The estimate of Good and Turing in words.
fn starts(best: &BestReport) -> String {
    let (starts, branches) = (best.starts, best.branches.len());
    let branches = match branches {
        1 => "1 branch is known".to_owned(),
        n => format!("{n} branches are known"),
    };
    if starts == 0 {
        return format!("none were needed; {branches}");
    }
    let [share, bound] = [best.unseen, best.unseen_bound].map(|x| readable(100.0 * x));
    format!(
        "{starts}, {branches}; an estimated {share} % of further starts would lead to others, at most {bound} % with 95 % confidence"
    )
}

/// Runs of frames, which count from 1 here.
fn spans(frames: &[usize]) -> String {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for &frame in frames {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == frame => *last = frame,
            _ => runs.push((frame, frame)),
        }
    }
    let words = |&(first, last): &(usize, usize)| match (first + 1, last + 1) {
        (one, same) if one == same => one.to_string(),
        (first, last) => format!("{first} to {last}"),
    };
    runs.iter().map(words).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::spans;

    #[test]
    fn frames_are_told_as_runs() {
        assert_eq!(spans(&[3]), "4");
        assert_eq!(spans(&[0, 1, 2, 7, 8]), "1 to 3, 8 to 9");
    }
}
