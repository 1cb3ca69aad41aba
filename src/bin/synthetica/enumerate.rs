//! `enumerate`: Tables 2 and 3, the lists behind their counts, and one by its number or the other way round.

use crate::arguments::{Arguments, Chain, Enumerate, Listing};
use crate::failure::Failure;
use crate::files::{self, Out};
use crate::progress::Progress;
use clap::CommandFactory;
use clap::error::ErrorKind;
use serde::Serialize;
use synthetica::types::enumerate::{
    assembly, assembly_count, assembly_index, chain, chain_count, chain_index, letters,
};
use synthetica::types::tables::{AssemblyLine, ClassLine, tables};

/// Prints what is asked for.
pub fn enumerate(asked: &Enumerate) -> Result<(), Failure> {
    match &asked.listing {
        None => print(asked, &tables(), |t| {
            format!("{}\n\n{}", table_2(&t.classes), table_3(&t.assemblies))
        }),
        Some(Listing::Chains {
            constraints: None, ..
        }) => print(asked, &tables().classes, |classes| table_2(classes)),
        Some(Listing::Assemblies {
            constraints: None, ..
        }) => print(asked, &tables().assemblies, |lines| table_3(lines)),
        Some(Listing::Chains {
            constraints: Some(u),
            number,
        }) => {
            let u = usize::from(*u);
            let what = List {
                one: "chain",
                constraints: u,
                count: chain_count(u),
            };
            what.print(
                asked,
                *number,
                |k| chain(u, k).map(|joints| letters(&joints)),
                String::clone,
            )
        }
        Some(Listing::Assemblies {
            constraints: Some(u),
            number,
        }) => {
            let u = usize::from(*u);
            let what = List {
                one: "assembly",
                constraints: u,
                count: assembly_count(u),
            };
            let names = |chains: Vec<Chain>| chains.iter().map(|joints| letters(joints)).collect();
            what.print(
                asked,
                *number,
                |k| assembly(u, k).map(names),
                |names: &Vec<String>| names.join(" "),
            )
        }
        Some(Listing::Find { chains }) => find(asked, chains),
    }
}

/// Things with so many constraints, by their numbers.
struct List {
    one: &'static str,
    constraints: usize,
    count: u64,
}

impl List {
    /// The one of this number, or all, a line each.
    fn print<T: Serialize>(
        &self,
        asked: &Enumerate,
        number: Option<u64>,
        get: impl Fn(u64) -> Option<T>,
        words: impl Fn(&T) -> String,
    ) -> Result<(), Failure> {
        let numbers = match number {
            None => 0..self.count,
            Some(k) if k < self.count => k..k + 1,
            Some(k) => {
                let Self {
                    one,
                    constraints,
                    count,
                } = self;
                wrong(&format!(
                    "there is no {one} {k} with U = {constraints}. Accepted: 0 to {}",
                    count - 1
                ))
            }
        };
        let mut out = Out::new(asked.output.as_deref())?;
        let mut progress = Progress::new(self.one, self.count).beside(&out);
        for k in numbers {
            if let Some(thing) = get(k) {
                out.write(&text(asked, &thing, &words))?;
            }
            progress.at(k + 1);
        }
        out.flush()
    }
}

/// Where a chain, or several together, stand in the lists.
fn find(asked: &Enumerate, chains: &[Chain]) -> Result<(), Failure> {
    let (list, found) = match chains {
        [chain] => ("chains", chain_index(chain)),
        _ => ("assemblies", assembly_index(chains)),
    };
    let Some((constraints, number)) = found else {
        wrong(
            "not in the lists. Accepted: chains that impose 1 to 4 constraints, with up to three sliders, and 1 to 5 together",
        )
    };
    #[derive(Serialize)]
    struct Place {
        list: &'static str,
        constraints: usize,
        number: u64,
    }
    print(
        asked,
        &Place {
            list,
            constraints,
            number,
        },
        |_| format!("{list} {constraints} {number}"),
    )
}

fn print<T: Serialize>(
    asked: &Enumerate,
    thing: &T,
    words: impl Fn(&T) -> String,
) -> Result<(), Failure> {
    files::write(asked.output.as_deref(), &text(asked, thing, words))
}

/// A line, or the lines of a table.
fn text<T: Serialize>(asked: &Enumerate, thing: &T, words: impl Fn(&T) -> String) -> String {
    let mut text = if asked.json {
        serde_json::to_string(thing).expect("plain data becomes JSON")
    } else {
        words(thing)
    };
    text.push('\n');
    text
}

/// Refuses the command line as clap does, with its exit code.
fn wrong(message: &str) -> ! {
    let mut command = Arguments::command();
    command.build();
    let own = command
        .find_subcommand_mut("enumerate")
        .expect("this command");
    own.error(ErrorKind::ValueValidation, message).exit()
}

fn table_2(classes: &[ClassLine]) -> String {
    let mut lines = vec!["Table 2: chains by the constraints U that they impose".to_owned()];
    lines.push(row(["U", "category", "class", "chains"]));
    for (i, class) in classes.iter().enumerate() {
        let u = class.constraints;
        lines.push(row([
            &u.to_string(),
            class.category,
            &class.name,
            &class.count.to_string(),
        ]));
        if classes.get(i + 1).is_none_or(|next| next.constraints != u) {
            lines.push(row([
                &u.to_string(),
                class.category,
                "all",
                &chain_count(u).to_string(),
            ]));
        }
    }
    lines.join("\n")
}

fn table_3(assemblies: &[AssemblyLine]) -> String {
    let mut lines = vec!["Table 3: assemblies by the constraints U of their chains".to_owned()];
    lines.push(row(["U", "", "category", "assemblies"]));
    for line in assemblies {
        let u = line.constraints.to_string();
        for category in &line.categories {
            lines.push(row([&u, "", &category.name, &category.count.to_string()]));
        }
        lines.push(row([&u, "", "all", &line.total.to_string()]));
    }
    lines.join("\n")
}

fn row([u, category, name, count]: [&str; 4]) -> String {
    format!("{u:<3}{category:<10}{name:<12}{count:>10}")
}
