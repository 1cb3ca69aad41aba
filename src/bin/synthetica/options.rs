//! Options that several commands have.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum, ValueHint, value_parser};
use std::path::{Path, PathBuf};
use synthetica::exchange::export::Format;
use synthetica::exchange::pose_table::PoseTableRequest;
use synthetica::exchange::table::Headings;
use synthetica::motion::goal::MAX_FRAMES;

#[derive(Args)]
pub struct MotionOptions {
    /// The document; `-` or nothing for standard input
    #[arg(default_value = "-", hide_default_value = true, value_hint = ValueHint::FilePath)]
    pub document: PathBuf,
    #[command(flatten)]
    pub planning: Planning,
    #[command(flatten)]
    pub key_frames: KeyFrames,
    #[command(flatten)]
    pub into: Output,
    /// No warnings
    #[arg(short, long)]
    pub quiet: bool,
}

/// What a table says.
#[derive(Args)]
pub struct Tables {
    /// Of csv: units behind the names (x[mm]), plain names, or two rows, the names and below them their units
    #[arg(long, value_name = "WORD", value_parser = PossibleValuesParser::new(Headings::ALL.map(Headings::name)).try_map(|word| Headings::named(&word)))]
    pub headings: Option<Headings>,
}

/// What is planned otherwise than the document says.
#[derive(Args)]
pub struct Planning {
    /// Plan by Newton's method or by the paper's gradient, whatever the document says
    #[arg(long, value_name = "METHOD")]
    pub method: Option<Method>,
    /// Plan so many frames, whatever the document says
    #[arg(long, value_name = "N", value_parser = value_parser!(u32).range(2..=MAX_FRAMES as i64))]
    pub frames: Option<u32>,
    /// Change a parameter or any place of the document, such as base=400 or chains[0].base.x=1.2
    #[arg(long, value_name = "PLACE=VALUE")]
    pub set: Vec<String>,
}

/// Where key frames come from, where not from the document.
#[derive(Args)]
pub struct KeyFrames {
    /// Take the key frames from a table, in place of the document's: CSV, or fields parted by tabs, semicolons or blanks;
    /// the motion gets a frame for each of them where it has fewer. Rows that cannot be taken over are told
    #[arg(long, value_name = "TABLE", value_hint = ValueHint::FilePath)]
    pub key_frames: Option<PathBuf>,
    /// What is known of the table, as JSON: convention, order, angles, time, scale
    #[arg(
        long,
        value_name = "REQUEST",
        requires = "key_frames",
        default_value = "{}",
        hide_default_value = true,
        value_parser = request
    )]
    pub table: PoseTableRequest,
}

fn request(json: &str) -> Result<PoseTableRequest, String> {
    PoseTableRequest::read(json).map_err(|fault| fault.to_string())
}

#[derive(Args)]
pub struct Output {
    /// Write into this file; `-` or nothing for standard output
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,
}

impl Output {
    /// The file, if it is to be one.
    pub fn file(&self) -> Option<&Path> {
        self.output.as_deref()
    }
}

#[derive(Clone, Copy, ValueEnum)]
pub enum Table {
    Csv,
    Json,
}

impl From<Table> for Format {
    fn from(table: Table) -> Self {
        match table {
            Table::Csv => Self::Csv,
            Table::Json => Self::Json,
        }
    }
}

#[derive(Clone, Copy, ValueEnum)]
pub enum Method {
    Newton,
    Gradient,
}
