//! A document read, changed as the options ask, and planned.

use crate::arguments::{KeyFrames, Method, Planning};
use crate::failure::{Failure, tell};
use crate::files;
use crate::progress::Progress;
use std::path::Path;
use synthetica::document::problem::Problem;
use synthetica::document::schema::{Document, KeyFrameEntry};
use synthetica::document::text;
use synthetica::exchange::pose_rows::SkippedRow;
use synthetica::exchange::pose_table::read_pose_table_asked;
use synthetica::motion::trajectory::Trajectory;
use synthetica::plan::settings;

/// A document and its motion.
pub struct Planned {
    /// As messages call the file.
    pub file: String,
    pub document: Document,
    pub problem: Problem,
    pub motion: Trajectory,
}

/// Plans the document of this file.
pub fn planned(
    file: &Path,
    planning: &Planning,
    key_frames: Option<&KeyFrames>,
) -> Result<Planned, Failure> {
    let text = files::read(file)?;
    let table = match key_frames {
        Some(asked) => read_key_frames(asked)?,
        None => None,
    };
    let file = files::name(file);
    let posed = text::parse(&text).and_then(|mut document| {
        if let Some(key_frames) = table {
            // A frame for each of them: a tool path would be cut short between them.
            let count = u32::try_from(key_frames.len()).unwrap_or(u32::MAX);
            document.motion.frames = document.motion.frames.max(count);
            document.motion.key_frames = key_frames;
        }
        change(&mut document, planning);
        Ok((Problem::new(&document)?, document))
    });
    let (problem, document) = match posed {
        Ok(posed) => posed,
        Err(fault) => {
            let fault = Box::new(fault);
            return Err(Failure::Fault { file, fault });
        }
    };
    let mut progress = Progress::new("frame", problem.frames() as u64);
    let mut planning = problem.planning(&problem.find_start());
    while planning.advance() {
        progress.at(planning.done() as u64);
    }
    let motion = planning.finish();
    Ok(Planned {
        file,
        document,
        problem,
        motion,
    })
}

/// The key frames of a table, if one is given; what cannot be taken over goes to standard error.
fn read_key_frames(asked: &KeyFrames) -> Result<Option<Vec<KeyFrameEntry>>, Failure> {
    let Some(path) = &asked.key_frames else {
        return Ok(None);
    };
    let (text, file) = (files::read(path)?, files::name(path));
    let table = read_pose_table_asked(&text, &asked.table).map_err(|fault| Failure::Fault {
        file: file.clone(),
        fault: Box::new(fault),
    })?;
    for said in &table.understood.assumed {
        tell(&format!("{file}: {said}"));
    }
    for SkippedRow {
        row,
        what,
        accepted,
    } in &table.skipped
    {
        tell(&format!("{file}: row {row}: {what}. Accepted: {accepted}."));
    }
    let more = table.skipped_count - table.skipped.len();
    if more > 0 {
        tell(&format!("{file}: {more} more rows cannot be taken over"));
    }
    Ok(Some(table.key_frames))
}

fn change(document: &mut Document, planning: &Planning) {
    if let Some(method) = planning.method {
        document.planner.method = match method {
            Method::Newton => settings::Method::Newton,
            Method::Gradient => settings::Method::Gradient,
        };
    }
    if let Some(frames) = planning.frames {
        document.motion.frames = frames;
    }
}
