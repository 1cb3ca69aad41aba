//! A document's planned motion as text for other programs.

use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::schema::Document;
use crate::exchange::mjcf::mjcf;
use crate::exchange::table::{csv, json};
use crate::model::mechanism::Mechanism;
use crate::motion::trajectory::Trajectory;

/// What can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A table with units in its headings, see [`csv`].
    Csv,
    /// Columns, report and document, see [`json`].
    Json,
    /// A MuJoCo model with a key frame a frame, see [`mjcf`].
    Mjcf,
}

impl Format {
    /// All, in the order of a menu.
    pub const ALL: [Self; 3] = [Self::Csv, Self::Json, Self::Mjcf];

    /// The name by which it is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Mjcf => "mjcf",
        }
    }

    /// The format of this name.
    ///
    /// # Errors
    /// Where there is none.
    pub fn named(name: &str) -> Result<Self, Fault> {
        let found = Self::ALL.into_iter().find(|format| format.name() == name);
        found.ok_or_else(|| {
            let what = format!("\u{201c}{}\u{201d} is none", excerpt(name));
            let accepted = Self::ALL.map(Self::name).join(", ");
            let place = Place::WHOLE.field("format");
            Fault::new(FaultCode::UnknownValue, &place, &what, &accepted)
        })
    }
}

/// The motion of this document's mechanism in that format.
///
/// ```
/// use synthetica::Session;
/// use synthetica::export::{Format, write};
///
/// let session = Session::open(include_str!("../../www/mechanisms/2tpr.json"))?;
/// let motion = session.plan();
/// let csv = write(Format::Csv, session.document(), &session.problem().mechanism, &motion);
/// assert!(csv.starts_with("frame,time,status,"));
/// assert_eq!(csv.lines().count(), 1 + motion.frames());
/// # Ok::<(), synthetica::Fault>(())
/// ```
pub fn write(
    format: Format,
    document: &Document,
    mechanism: &Mechanism,
    motion: &Trajectory,
) -> String {
    match format {
        Format::Csv => csv(document, mechanism, motion),
        Format::Json => json(document, mechanism, motion),
        Format::Mjcf => mjcf(document, mechanism, motion),
    }
}
