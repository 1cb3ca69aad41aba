//! `plan` and `export`: a document's motion as text.

use crate::arguments::{Export, MotionOptions, Plan, Table};
use crate::check::warnings;
use crate::failure::{Failure, tell};
use crate::files;
use crate::planned::planned;
use synthetica::document::report::Report;
use synthetica::exchange::export::{Format, write};

/// The motion as a table or as JSON.
pub fn plan(asked: &Plan) -> Result<(), Failure> {
    let format = match asked.format {
        Table::Csv => Format::Csv,
        Table::Json => Format::Json,
    };
    print(format, &asked.options)
}

/// The motion for another program.
pub fn export(asked: &Export) -> Result<(), Failure> {
    print(asked.format, &asked.options)
}

fn print(format: Format, options: &MotionOptions) -> Result<(), Failure> {
    let planned = planned(
        &options.document,
        &options.planning,
        Some(&options.key_frames),
    )?;
    if !options.quiet {
        let report = Report::new(
            &planned.problem().mechanism,
            &planned.problem().length_unit,
            &planned.motion,
        );
        for said in warnings(&report, &planned.motion) {
            tell(&format!("{}: warning: {said}", planned.file));
        }
    }
    let mechanism = &planned.problem().mechanism;
    let text = write(format, planned.document(), mechanism, &planned.motion);
    files::write(options.into.file(), &text)
}
