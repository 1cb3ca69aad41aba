//! A document's planned motion as text for other programs.

use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::reader::Node;
use crate::document::schema::Document;
use crate::document::text::not_json;
use crate::exchange::mjcf::mjcf;
use crate::exchange::table::{Headings, csv, json};
use crate::model::mechanism::Mechanism;
use crate::motion::trajectory::Trajectory;
use serde::Deserialize;

/// What can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A table, see [`csv`].
    Csv,
    /// Columns, report and document, see [`json`].
    Json,
    /// A MuJoCo model with drives, sensors and a key frame a frame, see [`mjcf`].
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

/// What is written otherwise than usual.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Options {
    /// Of CSV: where the units stand; in the headings without.
    pub headings: Option<Headings>,
    /// Of a MuJoCo model: whether it has gravity, along −z; none without.
    pub gravity: Option<bool>,
}

impl Options {
    /// From JSON; empty text is none of them.
    ///
    /// # Errors
    /// Where the text is not JSON, or has another field or value.
    pub fn read(text: &str) -> Result<Self, Fault> {
        if text.trim().is_empty() {
            return Ok(Self::default());
        }
        let node: Node = serde_json::from_str(text).map_err(|error| not_json(&error))?;
        Self::deserialize(&node).map_err(|refusal| refusal.fault(&Place::WHOLE))
    }

    /// Whether they go with this format.
    ///
    /// # Errors
    /// Where one is of another.
    pub fn check(&self, format: Format) -> Result<(), Fault> {
        let set = [
            ("headings", self.headings.is_some(), Format::Csv),
            ("gravity", self.gravity.is_some(), Format::Mjcf),
        ];
        for (name, is_set, own) in set {
            if is_set && format != own {
                let what = format!("the format {} has none", format.name());
                let accepted = format!("{name} with the format {}", own.name());
                let place = Place::WHOLE.field(name);
                return Err(Fault::new(
                    FaultCode::UnknownField,
                    &place,
                    &what,
                    &accepted,
                ));
            }
        }
        Ok(())
    }
}

/// The motion of this document's mechanism in that format. Frames count from 0.
///
/// ```
/// use synthetica::Session;
/// use synthetica::export::{Format, Options, write};
///
/// let session = Session::open(include_str!("../../www/mechanisms/2tpr.json"))?;
/// let (mechanism, motion) = (&session.problem().mechanism, session.plan());
/// let csv = write(Format::Csv, Options::default(), session.document(), mechanism, &motion)?;
/// assert!(csv.starts_with("frame,time,status,"));
/// assert_eq!(csv.lines().count(), 1 + motion.frames());
/// # Ok::<(), synthetica::Fault>(())
/// ```
///
/// # Errors
/// Where an option does not go with the format, or gravity is asked for in a length unit that is not known.
pub fn write(
    format: Format,
    options: Options,
    document: &Document,
    mechanism: &Mechanism,
    motion: &Trajectory,
) -> Result<String, Fault> {
    options.check(format)?;
    match format {
        Format::Csv => {
            let headings = options.headings.unwrap_or_default();
            Ok(csv(document, mechanism, motion, headings))
        }
        Format::Json => Ok(json(document, mechanism, motion)),
        Format::Mjcf => mjcf(document, mechanism, motion, options.gravity == Some(true)),
    }
}
