//! A document read, changed as the options ask, and planned.

use crate::arguments::{Method, Planning};
use crate::failure::Failure;
use crate::files;
use crate::progress::Progress;
use std::path::Path;
use synthetica::document::problem::Problem;
use synthetica::document::schema::Document;
use synthetica::document::text;
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
pub fn planned(file: &Path, planning: &Planning) -> Result<Planned, Failure> {
    let text = files::read(file)?;
    let file = files::name(file);
    let posed = text::parse(&text).and_then(|mut document| {
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
