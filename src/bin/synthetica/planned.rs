//! A document read, changed as the options ask, and planned.

use crate::failure::{Failure, NO_ANSWER, tell};
use crate::files::{self, is_standard};
use crate::options::{KeyFrames, Method, Planning};
use crate::progress::Progress;
use std::path::{Path, PathBuf};
use synthetica::document::fault::Fault;
use synthetica::document::schema::KeyFrameEntry;
use synthetica::exchange::pose_rows::SkippedRow;
use synthetica::exchange::pose_table::read_pose_table;
use synthetica::motion::trajectory::Trajectory;
use synthetica::source::overrides::{change, set, set_key_frames};
use synthetica::source::typed::Typed;
use synthetica::{Document, Problem, Session};

/// A document and its motion.
pub struct Planned {
    /// As messages call the file.
    pub file: String,
    session: Session,
    pub motion: Trajectory,
}

impl Planned {
    /// As the planner has it: plain, whatever was typed.
    pub fn document(&self) -> &Document {
        self.session.document()
    }

    pub fn problem(&self) -> &Problem {
        self.session.problem()
    }

    /// The document as it was typed, with these joint values (rad or lengths) as its start.
    pub fn text_with_start(&self, joints: &[f64]) -> String {
        self.session.text_started_at(joints)
    }
}

/// Refuses standard input where more than one text would come from it: its end comes once.
pub fn check_inputs(documents: &[PathBuf], key_frames: Option<&Path>) -> Result<(), Failure> {
    let from_input = documents.iter().filter(|file| is_standard(file)).count();
    if key_frames.is_some_and(is_standard) && (documents.len() != 1 || from_input > 0) {
        tell(
            "error: --key-frames - takes the table from standard input, which gives one text. Accepted: one document, from a file, with it",
        );
        return Err(Failure::Said(NO_ANSWER));
    }
    if from_input > 1 {
        tell(
            "error: - is there more than once, and standard input gives one text. Accepted: - once, beside files",
        );
        return Err(Failure::Said(NO_ANSWER));
    }
    Ok(())
}

/// Plans the document of this file.
pub fn planned(
    file: &Path,
    planning: &Planning,
    key_frames: Option<&KeyFrames>,
) -> Result<Planned, Failure> {
    let text = files::read(file, &files::DOCUMENT)?;
    let table = match key_frames {
        Some(asked) => read_key_frames(asked)?,
        None => None,
    };
    let file = files::name(file);
    let opened = changed(text, planning, table).and_then(|text| Session::open(&text));
    let session = match opened {
        Ok(session) => session,
        Err(fault) => {
            let fault = Box::new(fault);
            return Err(Failure::Fault { file, fault });
        }
    };
    let mut progress = Progress::new("frame", session.problem().frames() as u64);
    let mut planning = session.planning();
    while planning.advance() {
        progress.at(planning.done() as u64);
    }
    let motion = planning.finish();
    Ok(Planned {
        file,
        session,
        motion,
    })
}

/// The key frames of a table, if one is given; what cannot be taken over goes to standard error.
fn read_key_frames(asked: &KeyFrames) -> Result<Option<Vec<KeyFrameEntry>>, Failure> {
    let Some(path) = &asked.key_frames else {
        return Ok(None);
    };
    let (text, file) = (files::read(path, &files::TABLE)?, files::name(path));
    let table = read_pose_table(&text, &asked.table).map_err(|fault| Failure::Fault {
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

/// The text with what the options change.
fn changed(
    mut text: String,
    planning: &Planning,
    table: Option<Vec<KeyFrameEntry>>,
) -> Result<String, Fault> {
    for asked in &planning.set {
        let (place, value) = change(asked)?;
        text = set(&text, place, value)?;
    }
    if let Some(key_frames) = table {
        text = set_key_frames(&text, &key_frames)?;
        // A frame for each of them: a tool path would be cut short between them.
        if Typed::read(&text)?.document.motion.frames as usize <= key_frames.len() {
            text = set(&text, "motion.frames", &key_frames.len().to_string())?;
        }
    }
    if let Some(method) = planning.method {
        let name = match method {
            Method::Newton => "newton",
            Method::Gradient => "gradient",
        };
        text = set(&text, "planner.method", name)?;
    }
    if let Some(frames) = planning.frames {
        text = set(&text, "motion.frames", &frames.to_string())?;
    }
    Ok(text)
}
