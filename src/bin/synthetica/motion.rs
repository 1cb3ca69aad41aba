//! `plan` and `export`: a document's motion as text.

use crate::arguments::{Export, Plan};
use crate::check::warnings;
use crate::failure::{Failure, NO_ANSWER, tell};
use crate::files;
use crate::options::MotionOptions;
use crate::planned::{Planned, check_inputs, planned};
use std::slice;
use synthetica::Trajectory;
use synthetica::document::report::Report;
use synthetica::exchange::export::{Format, Options, write};

/// The motion as a table or as JSON.
pub fn plan(asked: &Plan) -> Result<(), Failure> {
    print(asked.format.into(), Options::default(), &asked.options)
}

/// The motion for another program.
pub fn export(asked: &Export) -> Result<(), Failure> {
    let wished = Options {
        headings: asked.tables.headings,
        gravity: asked.gravity.then_some(true),
    };
    check(wished, asked.format)?;
    print(asked.format, wished, &asked.options)
}

/// Whether a format can have what is wished.
pub fn check(wished: Options, format: Format) -> Result<(), Failure> {
    wished.check(format).map_err(|fault| {
        tell(&format!("error: {fault}"));
        Failure::Said(NO_ANSWER)
    })
}

/// Says on standard error what a person should know of a motion.
pub fn warn(planned: &Planned, motion: &Trajectory) {
    let problem = planned.problem();
    let report = Report::new(&problem.mechanism, &problem.length_unit, motion);
    for said in warnings(&report, motion) {
        tell(&format!("{}: warning: {said}", planned.file));
    }
}

fn print(format: Format, wished: Options, options: &MotionOptions) -> Result<(), Failure> {
    check_inputs(
        slice::from_ref(&options.document),
        options.key_frames.key_frames.as_deref(),
    )?;
    let planned = planned(
        &options.document,
        &options.planning,
        Some(&options.key_frames),
    )?;
    if !options.quiet {
        warn(&planned, &planned.motion);
    }
    let mechanism = &planned.problem().mechanism;
    let text = write(
        format,
        wished,
        planned.document(),
        mechanism,
        &planned.motion,
    )
    .map_err(|fault| Failure::Fault {
        file: planned.file.clone(),
        fault: Box::new(fault),
    })?;
    files::write(options.into.file(), &text)
}
