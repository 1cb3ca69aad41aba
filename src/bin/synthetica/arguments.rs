//! The command line: commands, options, and their help.

use crate::inputs::Inputs;
use crate::options::{KeyFrames, MotionOptions, Output, Planning, Table, Tables};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueHint, value_parser};
use clap_complete::Shell;
use std::path::PathBuf;
use synthetica::exchange::export::Format;
use synthetica::model::joint::JointKind;
use synthetica::plan::calm_form::MOST_PRICE;
use synthetica::types::enumerate::{MAX_CHAIN_CONSTRAINTS, MAX_CONSTRAINTS};

/// Closest reachable motions of spatial linkages, from documents in JSON
#[derive(Parser)]
#[command(
    name = "synthetica",
    version,
    after_help = "\
A document is a file, or standard input (`-`, or nothing). Angles are in degrees, lengths in the
document's own unit. `synthetica COMMAND --help` has examples.

Exit codes:
  0  done
  1  a document is at fault, which standard error says: FILE: where: what. Accepted: what else.
  2  the command line is wrong, or a file cannot be read or written

Examples:
  synthetica check 3rps.json
  synthetica plan 3rps.json > motion.csv
  synthetica export mjcf 3rps.json --output 3rps.xml"
)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Plan the motion closest to a document's goal and print it, a line a frame
    Plan(Plan),
    /// Say what is wrong with documents, and how well their linkages follow the goal
    Check(Check),
    /// Find the motion closest to the goal over all branches, not only the one that is followed
    Best(Best),
    /// Find all ways to assemble the linkage at a key frame, and how close the motion from each comes
    Modes(Modes),
    /// Print the planned motion for other programs, such as a model for MuJoCo
    Export(Export),
    /// Count the types of chains and assemblies, list them, find one by its number
    Enumerate(Enumerate),
    /// Print a document to begin with: a mechanism from the numbers of its paper, or a linkage of a type
    New(New),
    /// Print the JSON Schema of a document
    #[command(after_help = "\
Examples:
  synthetica schema --output document.schema.json

An editor that finds \"$schema\": \"document.schema.json\" in a document then checks it while you type.")]
    Schema {
        #[command(flatten)]
        into: Output,
    },
    /// Print what a shell needs to complete commands and options
    #[command(after_help = "\
Examples:
  synthetica completions bash > synthetica.bash
  synthetica completions zsh > _synthetica
  synthetica completions fish > synthetica.fish

bash reads such files from ~/.local/share/bash-completion/completions (there named synthetica), zsh
from the folders of $fpath, fish from ~/.config/fish/completions.")]
    Completions {
        /// The shell
        shell: Shell,
    },
}

#[derive(Args)]
#[command(after_help = "\
A maker takes the numbers of its paper as options, --base 400; `--list` has them all with what they
are and their defaults. Lengths are in the unit that is named.

Examples:
  synthetica new 3-RPS > mine.json
  synthetica new 'RPS + 2TS' | synthetica check
  synthetica new --list
  synthetica new delta --base 400 --platform 50 --arms 300,580 --unit mm > delta.json
  synthetica new 'delta?base=400&platform=50' | synthetica plan --quiet | head -n 3")]
pub struct New {
    /// A maker, delta or delta?base=400, or chains of the joints R, P, C, T (or U), S, E from base to workpiece, each with
    /// its count
    #[arg(value_name = "TYPE", required_unless_present = "list")]
    pub what: Option<String>,
    /// List the makers and their inputs
    #[arg(long, conflicts_with = "what")]
    pub list: bool,
    /// The unit of the lengths: m, cm, mm, µm or in
    #[arg(long, value_name = "UNIT")]
    pub unit: Option<String>,
    #[command(flatten)]
    pub inputs: Inputs,
    #[command(flatten)]
    pub into: Output,
}

#[derive(Args)]
#[command(after_help = "\
Warnings go to standard error. A frame that is not certified is no failure: its status says so, and
`synthetica check` exits with 1.

Examples:
  synthetica plan 3rps.json > motion.csv
  synthetica plan --frames 500 --output motion.csv 3rps.json
  synthetica plan --format json < 3rps.json
  synthetica plan 3rps.json --key-frames path.csv --table '{\"convention\": \"quaternion_wxyz\", \"scale\": 0.001}'
  synthetica plan --set motion.key_frames[1].z=0.9 3rps.json
  cat 3rps.json | synthetica plan --method gradient --frames 9 --quiet | cut -d, -f1-6")]
pub struct Plan {
    /// csv: a table with units in its headings; json: columns, report and document
    #[arg(short, long, value_name = "FORMAT", default_value = "csv")]
    pub format: Table,
    #[command(flatten)]
    pub options: MotionOptions,
}

#[derive(Args)]
#[command(after_help = "\
csv is a table, json has columns, report and document, mjcf is a model for MuJoCo with drives that follow
the motion, sensors on the workpiece and a key frame for every frame. Frames count from 0.

Examples:
  synthetica export mjcf 3rps.json > 3rps.xml
  synthetica export mjcf --gravity 3rps.json > 3rps.xml
  synthetica export csv --headings two-rows 3rps.json > 3rps.csv
  synthetica export json --frames 33 3rps.json --output motion.json
  cat 3rps.json | synthetica export csv")]
pub struct Export {
    /// What to print
    #[arg(value_parser = PossibleValuesParser::new(Format::ALL.map(Format::name)).try_map(|name| Format::named(&name)))]
    pub format: Format,
    #[command(flatten)]
    pub tables: Tables,
    /// Of mjcf: gravity along -z, in the document's unit of length
    #[arg(long)]
    pub gravity: bool,
    #[command(flatten)]
    pub options: MotionOptions,
}

#[derive(Args)]
#[command(after_help = "\
Exit codes:
  0  every frame of every document is certified: reached, closest or at_limit
  1  a document is at fault, or a frame is not certified: stalled or closure_lost
  2  the command line is wrong, or a file cannot be read

Examples:
  synthetica check 3rps.json
  synthetica check *.json
  synthetica check --json 3rps.json 2tpr.json
  synthetica check --frames 500 - < scara.json")]
pub struct Check {
    /// The documents; `-` or nothing for standard input
    #[arg(value_name = "DOCUMENT", default_value = "-", hide_default_value = true, value_hint = ValueHint::FilePath)]
    pub documents: Vec<PathBuf>,
    /// An object a line for each document; frames count from 0 there
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub planning: Planning,
}

#[derive(Args)]
#[command(after_help = "\
A plan follows one branch of the linkage; here the branches that closed walks join to the start are searched, and the
motion may change from one to another while a goal stands. f is the distance to the goal, as in a plan. Without --format
it says what was found, with it it prints the motion, every point of its closed path in order: frame is empty between
frames, branch on the way of a change of branch, and switch is 1 there.

Exit codes:
  0  every frame of the best motion is certified: reached, closest or at_limit; with --format the motion is printed
  1  a document is at fault, its joints are driven, its loops are open, or a frame is not certified
  2  the command line is wrong, or a file cannot be read or written

Examples:
  synthetica best 3rps.json
  synthetica best --json 3rps.json 2tpr.json
  synthetica best --format csv 3rps.json > best.csv
  synthetica best --format json 3rps.json --output best.json
  synthetica best --format csv --headings two-rows --calm 1e-6 3rps.json > calm.csv
  synthetica best --format csv --quiet 3rps.json --key-frames path.csv --table '{\"scale\": 0.001}' > best.csv")]
pub struct Best {
    /// The documents; `-` or nothing for standard input
    #[arg(value_name = "DOCUMENT", default_value = "-", hide_default_value = true, value_hint = ValueHint::FilePath)]
    pub documents: Vec<PathBuf>,
    /// An object a line for each document; frames count from 0 there
    #[arg(long, conflicts_with = "format")]
    pub json: bool,
    /// Print the motion of one document. csv: a table with units in its headings; json: what was found, columns, report and
    /// document
    #[arg(short, long, value_name = "FORMAT")]
    pub format: Option<Table>,
    /// Print the calm form of the motion, a row a frame: PRICE times the mean square of the joints' speeds, in rad and
    /// sizes a motion, counts as much as the mean f
    #[arg(long, value_name = "PRICE", requires = "format", value_parser = price)]
    pub calm: Option<f64>,
    #[command(flatten)]
    pub tables: Tables,
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

#[derive(Args)]
#[command(after_help = "\
Where the goal of the key frame cannot be met, the ways at the closest poses are found. From each a motion is planned; those
with most certified frames and the least mean of f, the distance to the goal, stand first. All numbers count from 0.

Exit codes:
  0  ways to assemble every document were found
  1  a document is at fault, its joints are driven, or no way was found
  2  the command line is wrong, or a file cannot be read or written

Examples:
  synthetica modes 3rps.json
  synthetica modes --key 1 --json 3rps.json
  synthetica modes 3rps.json --key 1 --key-frames path.csv --table '{\"scale\": 0.001}'
  synthetica modes --start 0 3rps.json | synthetica plan --quiet > motion.csv")]
pub struct Modes {
    /// The documents; `-` or nothing for standard input
    #[arg(value_name = "DOCUMENT", default_value = "-", hide_default_value = true, value_hint = ValueHint::FilePath)]
    pub documents: Vec<PathBuf>,
    /// The key frame, from 0
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub key: usize,
    /// An object a line for each document
    #[arg(long, conflicts_with = "start")]
    pub json: bool,
    /// Print one document with the joint values of this way, from 0, as its start
    #[arg(long, value_name = "MODE")]
    pub start: Option<usize>,
    #[command(flatten)]
    pub planning: Planning,
    #[command(flatten)]
    pub key_frames: KeyFrames,
    #[command(flatten)]
    pub into: Output,
}

#[derive(Args)]
#[command(
    disable_help_subcommand = true,
    after_help = "\
A chain imposes U = 1 to 4 constraints on its workpiece, an assembly of chains 1 to 5 together. Without
a command both tables are printed. Numbers count from 0.

Examples:
  synthetica enumerate
  synthetica enumerate chains 2
  synthetica enumerate chains 1 17
  synthetica enumerate assemblies 2 --output assemblies.txt
  synthetica enumerate assemblies 5 487990858
  synthetica enumerate find RPS RPS RPS
  synthetica enumerate --json"
)]
pub struct Enumerate {
    #[command(subcommand)]
    pub listing: Option<Listing>,
    /// JSON: the tables whole, lists as a value a line
    #[arg(long, global = true)]
    pub json: bool,
    /// Write into this file; `-` or nothing for standard output
    #[arg(short, long, global = true, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
}

#[derive(Subcommand)]
pub enum Listing {
    /// Chains: Table 2, those with U constraints, or one of them
    Chains {
        /// Constraints U that the chain imposes
        #[arg(value_name = "U", value_parser = value_parser!(u8).range(1..=MAX_CHAIN_CONSTRAINTS as i64))]
        constraints: Option<u8>,
        /// The number of one chain, from 0
        #[arg(value_name = "K")]
        number: Option<u64>,
    },
    /// Assemblies of chains: Table 3, those with U constraints, or one of them
    Assemblies {
        /// Constraints U that its chains impose together
        #[arg(value_name = "U", value_parser = value_parser!(u8).range(1..=MAX_CONSTRAINTS as i64))]
        constraints: Option<u8>,
        /// The number of one assembly, from 0
        #[arg(value_name = "K")]
        number: Option<u64>,
    },
    /// The numbers of a chain or an assembly, as `chains` and `assemblies` take them
    Find {
        /// Chains such as RPS, of the joints R, P, C, T, S, E
        #[arg(value_name = "CHAIN", required = true, value_parser = chain)]
        chains: Vec<Chain>,
    },
}

/// The joints of a chain.
pub type Chain = Vec<JointKind>;

fn price(text: &str) -> Result<f64, String> {
    let price = text.parse().ok();
    price
        .filter(|price: &f64| *price > 0.0 && *price <= MOST_PRICE)
        .ok_or_else(|| {
            format!("no price. Accepted: a number above 0, up to {MOST_PRICE}, such as 1e-6")
        })
}

fn chain(letters: &str) -> Result<Chain, String> {
    let joint = |letter: char| {
        JointKind::named(letter).ok_or_else(|| {
            format!("\u{201c}{letter}\u{201d} is no joint. Accepted: R, P, C, T, S, E")
        })
    };
    letters.chars().map(joint).collect()
}
