//! The options that makers take, `--base 400`: one for every name of an input.

use clap::{Arg, ArgMatches, Args, Command, Error, FromArgMatches};
use std::collections::BTreeSet;
use synthetica::makers::list::list;

/// The inputs that are given, by name.
pub struct Inputs(pub Vec<(String, String)>);

/// The names of all makers' inputs, each once.
fn names() -> BTreeSet<&'static str> {
    let inputs = list().iter().flat_map(|maker| &maker.inputs);
    inputs.map(|input| input.name.as_str()).collect()
}

impl Args for Inputs {
    fn augment_args(command: Command) -> Command {
        // There are many, of which a mechanism takes few: `new --list` has them, and not the help.
        let option = |name| {
            let option = Arg::new(name).long(name).value_name("NUMBERS");
            option.allow_hyphen_values(true).hide(true)
        };
        command.args(names().into_iter().map(option))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Inputs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let given = names().into_iter().filter_map(|name| {
            let value = matches.get_one::<String>(name)?;
            Some((name.to_owned(), value.clone()))
        });
        Ok(Self(given.collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
