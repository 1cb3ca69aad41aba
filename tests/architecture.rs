//! The floors of src/: every file imports only from files after it in the list that the crate's documentation prints, so
//! that there are no circles; and the command on top of the library, which the library does not know.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The list in the crate's documentation: rooms from the top down, and in each its files from the top down.
const FLOORS: &str = include_str!("../src/floors.md");

/// The command's files, from the top down.
const COMMAND: [&str; 14] = [
    "main",
    "best",
    "modes",
    "motion",
    "check",
    "planned",
    "enumerate",
    "new",
    "progress",
    "files",
    "failure",
    "arguments",
    "options",
    "inputs",
];

/// Most lines of a file in src/, its own tests not counted.
const MOST_LINES: usize = 400;

/// Room and file in the order of the list.
fn listed() -> Vec<(&'static str, &'static str)> {
    let rooms = FLOORS.lines().filter(|line| !line.starts_with("```"));
    rooms
        .flat_map(|line| {
            let mut words = line.split_whitespace();
            let room = words.next().expect("a room");
            words.map(move |file| (room, file))
        })
        .collect()
}

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A file without its own tests.
fn code(text: &str) -> &str {
    text.split("#[cfg(test)]\nmod tests")
        .next()
        .unwrap_or_default()
}

/// A file without its own tests and without comments.
fn stripped(text: &str) -> String {
    let lines: Vec<&str> = code(text)
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default())
        .collect();
    lines.join("\n")
}

/// The paths that a file names after `crate::`, as far as they have names of files or rooms: `["model", "chain"]`.
fn imports(text: &str) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    for rest in stripped(text).split("crate::").skip(1) {
        expand(rest, &mut Vec::new(), &mut found);
    }
    found
}

/// Reads `a::b::{c::D, e}` into its paths.
fn expand<'a>(mut rest: &'a str, path: &mut Vec<String>, found: &mut Vec<Vec<String>>) -> &'a str {
    let depth = path.len();
    loop {
        rest = rest.trim_start();
        if let Some(mut list) = rest.strip_prefix('{') {
            loop {
                list = expand(list, path, found).trim_start();
                match list.strip_prefix(',') {
                    Some(more) if !more.trim_start().starts_with('}') => list = more,
                    more => {
                        path.truncate(depth);
                        let end = more.unwrap_or(list).trim_start();
                        return end.strip_prefix('}').unwrap_or(end);
                    }
                }
            }
        }
        let end = rest
            .find(|c: char| !c.is_ascii_alphanumeric() && c != '_')
            .unwrap_or(rest.len());
        path.push(rest[..end].to_owned());
        rest = &rest[end..];
        match rest.strip_prefix("::") {
            Some(more) => rest = more,
            None => {
                found.push(path.clone());
                path.truncate(depth);
                return rest;
            }
        }
    }
}

#[test]
fn imports_point_down() {
    let listed = listed();
    for (at, (room, file)) in listed.iter().enumerate() {
        for path in imports(&read(&format!("{room}/{file}.rs"))) {
            let target = listed
                .iter()
                .position(|(r, f)| *r == path[0] && path.get(1).is_some_and(|name| name == f));
            let target = target.unwrap_or_else(|| {
                panic!(
                    "{room}/{file} names crate::{}, which is no file of the list",
                    path.join("::")
                )
            });
            assert!(
                at <= target,
                "{room}/{file} imports {}, which is not below it",
                path.join("::")
            );
        }
    }
}

/// A path through `super` would be an import that [`imports`] does not see.
#[test]
fn imports_begin_at_the_crate() {
    let library = listed()
        .into_iter()
        .map(|(room, file)| format!("{room}/{file}.rs"));
    let command = COMMAND.map(|file| format!("bin/synthetica/{file}.rs"));
    for path in library.chain(command) {
        let text = stripped(&read(&path));
        assert!(!text.contains("super::"), "{path} imports by super::");
    }
}

#[test]
fn the_list_has_every_file() {
    let listed: BTreeSet<String> = listed()
        .iter()
        .map(|(room, file)| format!("{room}/{file}"))
        .collect();
    let mut there = BTreeSet::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for room in fs::read_dir(&root)
        .expect("src")
        .flatten()
        .filter(|room| room.path().is_dir())
    {
        let name = room.file_name().into_string().expect("a name");
        if name == "bin" {
            continue;
        }
        for file in fs::read_dir(room.path()).expect("a room").flatten() {
            let file = file.file_name().into_string().expect("a name");
            if let Some(stem) = file.strip_suffix(".rs").filter(|stem| *stem != "mod") {
                there.insert(format!("{name}/{stem}"));
            }
        }
    }
    assert_eq!(listed, there);
}

#[test]
fn the_list_has_every_file_of_the_command() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/bin/synthetica");
    let there: BTreeSet<String> = fs::read_dir(root)
        .expect("the command")
        .map(|file| file.expect("a file").file_name())
        .map(|name| name.into_string().expect("a name"))
        .collect();
    let listed = COMMAND.map(|file| format!("{file}.rs"));
    assert_eq!(BTreeSet::from(listed), there);
}

#[test]
fn the_command_points_down() {
    for (at, file) in COMMAND.iter().enumerate() {
        for path in imports(&read(&format!("bin/synthetica/{file}.rs"))) {
            let target = COMMAND.iter().position(|name| *name == path[0]);
            let target = target.unwrap_or_else(|| panic!("{file} names {}", path.join("::")));
            assert!(
                at < target,
                "{file} imports {}, which is not below it",
                path[0]
            );
        }
    }
}

/// Only the command reads a command line: the library does not name clap.
#[test]
fn the_library_has_no_command_line() {
    for (room, file) in listed() {
        assert!(
            !read(&format!("{room}/{file}.rs")).contains("clap"),
            "{room}/{file}"
        );
    }
}

#[test]
fn files_are_short() {
    let command = COMMAND
        .iter()
        .map(|file| format!("bin/synthetica/{file}.rs"));
    let library = listed();
    let library = library
        .iter()
        .map(|(room, file)| format!("{room}/{file}.rs"));
    for path in library.chain(command) {
        let lines = code(&read(&path)).lines().count();
        assert!(lines <= MOST_LINES, "{path}: {lines} lines");
    }
}

#[test]
fn reads_imports() {
    let text = "use crate::a::B;\nuse crate::{\n c::{D, e::F},\n f,\n};\n// crate::x\nlet y = crate::j::k();\n#[cfg(test)]\nmod tests { use crate::z; }";
    let paths: Vec<String> = imports(text).iter().map(|path| path.join("::")).collect();
    assert_eq!(paths, ["a::B", "c::D", "c::e::F", "f", "j::k"]);
}
