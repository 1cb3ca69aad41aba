//! The best motion with all points of its closed path: CSV, and JSON with the search and the document beside it. Frames and
//! branches count from 0; between frames there is no frame.

use crate::document::best_report::BestReport;
use crate::document::fault::Fault;
use crate::document::problem::Problem;
use crate::document::report::Report;
use crate::document::schema::Document;
use crate::exchange::export::{self, Format, Options};
use crate::exchange::table::{
    Column, Headings, Values, columns, columns_in_csv, columns_in_json, object,
};
use crate::motion::trajectory::Trajectory;
use crate::plan::best::Search;
use crate::plan::calm_form::Calm;
use crate::plan::found::Found;
use crate::plan::path::{Place, path_motion, places};

/// Version of the JSON of a path.
pub const VERSION: u32 = 1;

/// The best motion found so far in a format, or its calm form: as CSV and JSON the best motion has all points of its closed path,
/// and where there is none the followed motion is written.
///
/// # Errors
/// Where an option does not go with the format, or the format cannot have the motion.
pub fn write(
    format: Format,
    options: Options,
    document: &Document,
    problem: &Problem,
    search: &Search,
    calm: Option<&Calm>,
) -> Result<String, Fault> {
    options.check(format)?;
    let motion = match (calm, search.found(), format) {
        (Some(calm), ..) => &calm.motion,
        (None, Some(found), Format::Csv) => {
            let headings = options.headings.unwrap_or_default();
            return Ok(csv(document, problem, found, headings));
        }
        (None, Some(found), Format::Json) => {
            return Ok(json(document, problem, found, &BestReport::new(search)));
        }
        (None, Some(found), Format::Mjcf) => &found.motion,
        (None, None, _) => search.followed(),
    };
    export::write(format, options, document, &problem.mechanism, motion)
}

/// A row a point, in order: the columns of a motion, and before them `frame`, `branch` and `switch`. `frame` is empty between
/// frames, `branch` on the way of a change of branch; `switch` is 1 on such a way, the frame's own point at its end included,
/// else 0.
fn csv(document: &Document, problem: &Problem, found: &Found, headings: Headings) -> String {
    let path = path(problem, found);
    let report = Report::new(&problem.mechanism, &document.length_unit, &path);
    let columns = with_places(columns(document, &report, &path), found);
    columns_in_csv(&columns, path.frames(), headings)
}

/// The same as one JSON object, with what is known of the search, the report of the motion, and the document that it answers.
fn json(document: &Document, problem: &Problem, found: &Found, best: &BestReport) -> String {
    let path = path(problem, found);
    let report = Report::new(&problem.mechanism, &document.length_unit, &path);
    let columns = with_places(columns(document, &report, &path), found);
    let best = serde_json::to_string(best).expect("plain data becomes JSON");
    let counts = [
        ("frames", found.motion.frames().to_string()),
        ("points", path.frames().to_string()),
        ("best", best),
    ];
    let columns = columns_in_json(&columns, path.frames());
    object(
        "synthetica path",
        VERSION,
        document,
        &counts,
        &columns,
        &report,
    )
}

fn path(problem: &Problem, found: &Found) -> Trajectory {
    path_motion(&problem.mechanism, &problem.goals, &problem.settings, found)
}

/// The columns of places in the stead of the column `frame` that every motion has first.
fn with_places(mut columns: Vec<Column>, found: &Found) -> Vec<Column> {
    let places = places(found);
    let index = |of: fn(&Place) -> Option<usize>| -> Values {
        let number = |place| of(place).map_or(f64::NAN, |index| index as f64);
        Values::Numbers(places.iter().map(number).collect())
    };
    let own = [
        ("frame", index(|place| place.frame)),
        ("branch", index(|place| place.lane)),
        ("switch", index(|place| Some(usize::from(place.switch)))),
    ];
    let own = own.map(|(name, values)| Column::number(name, values));
    columns.splice(..1, own);
    columns
}
