//! The command `synthetica`, run as a shell runs it: every command on every sample, what it says and which code it
//! leaves.
#![cfg(not(target_arch = "wasm32"))]

use serde_json::Value;
use std::fs;
use std::io::{Read, Write};
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use synthetica::document::number::readable;
use synthetica::document::{problem::Problem, schema};
use synthetica::exchange::export;
use synthetica::makers::from_type::from_type;
use synthetica::makers::list::list as makers;
use synthetica::source::session::Session;
use synthetica::types::tables::tables;

const SAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/mechanisms");

fn synthetica(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_synthetica"));
    command
        .args(arguments)
        .current_dir(SAMPLES)
        .stdin(Stdio::null());
    command
}

/// What it printed, what it said on standard error, its exit code.
fn run(arguments: &[&str]) -> (String, String, i32) {
    said(synthetica(arguments).output().expect("the command runs"))
}

/// The same with a text as standard input.
fn fed(arguments: &[&str], input: &str) -> (String, String, i32) {
    let mut command = synthetica(arguments);
    command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut child = command.spawn().expect("the command runs");
    let mut stdin = child.stdin.take().expect("a pipe");
    stdin
        .write_all(input.as_bytes())
        .expect("it reads all of it");
    drop(stdin);
    said(child.wait_with_output().expect("it ends"))
}

fn said(output: Output) -> (String, String, i32) {
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    let code = output.status.code().expect("no signal");
    (text(output.stdout), text(output.stderr), code)
}

/// What it printed, where all is well.
fn printed(arguments: &[&str]) -> String {
    let (out, err, code) = run(arguments);
    assert_eq!(code, 0, "{arguments:?}: {err}");
    out
}

fn samples() -> Vec<String> {
    let index = fs::read_to_string(format!("{SAMPLES}/index.json")).expect("the samples' index");
    let index: Vec<Value> = serde_json::from_str(&index).expect("a list");
    assert!(!index.is_empty());
    let file = |entry: &Value| entry["file"].as_str().expect("a file's name").to_owned();
    index.iter().map(file).collect()
}

fn sample(name: &str) -> String {
    fs::read_to_string(format!("{SAMPLES}/{name}")).expect("a sample")
}

/// A new folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

#[test]
fn every_sample_is_planned_and_exported_as_the_library_does() {
    for name in samples() {
        let session = Session::open(&sample(&name)).expect("a document");
        let document = session.document();
        let problem = Problem::new(document).expect("a problem");
        let motion = problem.plan();
        for format in export::Format::ALL {
            let expected = export::write(
                format,
                export::Options::default(),
                document,
                &problem.mechanism,
                &motion,
            )
            .expect("a text");
            let exported = printed(&["export", format.name(), &name]);
            assert!(exported == expected, "{name}, {}", format.name());
        }
        assert_eq!(
            printed(&["plan", &name]),
            printed(&["export", "csv", &name])
        );
        let json = printed(&["plan", "--format", "json", &name]);
        assert_eq!(json, printed(&["export", "json", &name]));
    }
}

#[test]
fn every_sample_passes_the_check() {
    let names = samples();
    let arguments: Vec<&str> = ["check"]
        .into_iter()
        .chain(names.iter().map(String::as_str))
        .collect();
    let text = printed(&arguments);
    for name in &names {
        assert!(text.contains(&format!("{name}: ")), "{name}: {text}");
    }
    let mobility = text.lines().filter(|line| line.contains("by rank"));
    assert_eq!(mobility.count(), names.len());

    let arguments: Vec<&str> = ["check", "--json"]
        .into_iter()
        .chain(names.iter().map(String::as_str))
        .collect();
    let text = printed(&arguments);
    assert_eq!(text.lines().count(), names.len());
    for (line, name) in text.lines().zip(&names) {
        let verdict: Value = serde_json::from_str(line).expect("JSON");
        assert_eq!(
            (&verdict["file"], &verdict["ok"]),
            (&Value::from(name.as_str()), &Value::from(true))
        );
        assert_eq!(verdict["uncertified"], Value::Array(Vec::new()));
        let statuses = verdict["statuses"].as_object().expect("an object");
        let frames: u64 = statuses.values().filter_map(Value::as_u64).sum();
        assert_eq!(verdict["frames"], frames);
        assert!(verdict["report"]["mobility_rank"].is_u64());
    }
}

/// The metric with its length, what either metric gives, leaps and nearly singular frames, in words and as JSON.
#[test]
fn a_check_says_how_it_was_measured() {
    let text = printed(&["check", "3rps.json"]);
    assert!(
        text.contains(
            "  metric    dual-quaternion about (0, 0, 0) m, length 1 m (as the document says)\n"
        ),
        "{text}"
    );
    assert!(
        text.contains("  leaps     none\n  singular  none\n"),
        "{text}"
    );
    assert!(text.contains(", at most 1.0e-10\n"), "{text}");
    assert!(!text.contains("  misfit "), "{text}");
    let verdict: Value =
        serde_json::from_str(&printed(&["check", "--json", "3rps.json"])).expect("JSON");
    let [pose, paper] = verdict["metrics"].as_array().expect("a list").as_slice() else {
        panic!("{}", verdict["metrics"]);
    };
    assert_eq!(
        (&pose["metric"], &paper["metric"]),
        (&"pose".into(), &"dual-quaternion".into())
    );
    for gap in ["translation_gap", "rotation_gap"] {
        assert_eq!(paper[gap], verdict[gap], "its own metric");
        assert_ne!(pose[gap], verdict[gap], "the other one");
    }
    let gaps = |of: &Value| {
        let number = |name| of[name].as_f64().expect("a number");
        format!(
            "{} {} m, {}°",
            of["metric"].as_str().expect("a name"),
            readable(number("translation_gap")),
            readable(number("rotation_gap"))
        )
    };
    let line = format!("  compared  {} | {}\n", gaps(pose), gaps(paper));
    assert!(text.contains(&line), "{line:?} is not in {text}");

    // Overconstrained, with exact dimensions.
    let text = printed(&["check", "--json", "bennett.json"]);
    let verdict: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(verdict["leaps"], Value::Array(Vec::new()));
    assert_eq!(verdict["report"]["metric"]["length_source"], "given");
    assert_eq!(verdict["misfit"], verdict["report"]["misfit"]);
}

/// A Bennett linkage with 3.732 for the tangent of 75°: its misfit is told with its bound.
#[test]
fn a_check_tells_the_misfit_of_rounded_dimensions() {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/field/bennett-3.732-mm.json"
    );
    let (text, _, code) = run(&["check", file]);
    assert_eq!(code, 0, "{text}");
    let line = text
        .lines()
        .find(|line| line.starts_with("  misfit "))
        .unwrap_or_else(|| panic!("{text}"));
    assert!(line.ends_with("e-6, at most 3.0e-4"), "{line}");
    let verdict: Value = serde_json::from_str(&run(&["check", "--json", file]).0).expect("JSON");
    let misfit = verdict["misfit"].as_f64().expect("a number");
    assert!((1e-6..3e-4).contains(&misfit), "{misfit}");
}

/// The gradient planner knows no joint limits: the SCARA's frames beyond one are not certified.
#[test]
fn frames_that_are_not_certified_fail_the_check_and_not_the_plan() {
    let planning = ["--method", "gradient", "--frames", "9"];
    let with = |command: &[&'static str]| [command, &planning, &["scara.json"]].concat();
    let (out, err, code) = run(&with(&["check"]));
    assert_eq!((err.as_str(), code), ("", 1));
    assert!(
        out.contains("  warning   3 of 9 frames are not certified: 4 to 6 stalled.\n"),
        "{out}"
    );
    let (out, _, code) = run(&with(&["check", "--json"]));
    assert_eq!(code, 1);
    let verdict: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(verdict["ok"], false);
    assert_eq!(verdict["uncertified"][0]["first"], 3);
    assert_eq!(verdict["uncertified"][0]["last"], 5);

    let (out, err, code) = run(&with(&["plan"]));
    assert_eq!((out.lines().count(), code), (10, 0));
    assert!(
        err.contains("scara.json: warning: 3 of 9 frames are not certified"),
        "{err}"
    );
    let (quiet, err, code) = run(&with(&["plan", "--quiet"]));
    assert_eq!((quiet, err.as_str(), code), (out, "", 0));
}

/// The document inside a motion is the one that was planned.
#[test]
fn options_stand_in_the_document_that_is_answered() {
    let text = printed(&[
        "plan",
        "-f",
        "json",
        "--frames",
        "5",
        "--method",
        "gradient",
        "3rps.json",
    ]);
    let motion: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(motion["frames"], 5);
    assert_eq!(motion["document"]["motion"]["frames"], 5);
    assert_eq!(motion["document"]["planner"]["method"], "gradient");
}

#[test]
fn standard_input_is_a_document_too() {
    let text = sample("2tpr.json");
    let expected = printed(&["plan", "2tpr.json"]);
    for arguments in [&["plan"][..], &["plan", "-"], &["export", "csv"]] {
        assert_eq!(fed(arguments, &text), (expected.clone(), String::new(), 0));
    }
    let (out, _, code) = fed(&["check", "3rps.json", "-"], &text);
    assert_eq!(code, 0);
    assert!(out.contains("\nstandard input: 2TPR\n"), "{out}");
}

#[test]
fn a_maker_makes_what_its_options_say() {
    let sizes = ["--base", "400", "--platform", "50", "--arms", "300,580"];
    let made = printed(&[&["new", "delta"][..], &sizes, &["--unit", "mm"]].concat());
    let asked = "delta?base=400&platform=50&arms=300,580&unit=mm";
    assert_eq!(printed(&["new", asked]), made);
    assert_eq!(made, from_type(asked).expect("a delta"));
    // Inputs in the name and as options together.
    let some = [
        "new",
        "delta?base=400&platform=50",
        "--arms",
        "300,580",
        "--unit",
        "mm",
    ];
    assert_eq!(printed(&some), made);
    let (out, err, code) = fed(&["check"], &made);
    assert_eq!((err.as_str(), code), ("", 0), "{out}");
    assert!(out.contains("  mobility  3 by rank"), "{out}");

    let list = printed(&["new", "--list"]);
    for maker in makers() {
        assert!(
            list.contains(&format!("{}: {}\n", maker.name, maker.title)),
            "{list}"
        );
        for input in &maker.inputs {
            assert!(list.contains(&format!("  --{} ", input.name)), "{list}");
        }
    }
    assert_eq!(printed(&["new", "3-RPS"]), printed(&["new", "RPS+RPS+RPS"]));
    for (arguments, accepted) in [
        (
            &["new", "delta", "--base", "4oo"][..],
            "Base: \u{201c}4oo\u{201d} is no number. Accepted: a length above 0.",
        ),
        (&["new", "delta", "--base", "-4"], "-4 is out of range"),
        (
            &["new", "delta", "--base", "2000"],
            "do not reach the platform",
        ),
        (&["new", "delta", "--bose", "4"], "'--base'"),
        (&["new", "delta", "--unit", "mile"], "mm"),
        (&["new", "dleta"], "\u{201c}delta\u{201d} may be meant"),
        (
            &["new", "2TPR", "--base", "4"],
            "there is no maker \u{201c}2TPR\u{201d}",
        ),
        (&["new", "RSSR"], "RS + RS"),
        (&["new"], "<TYPE>"),
    ] {
        let (out, err, code) = run(arguments);
        assert_eq!((out.as_str(), code), ("", 2), "{arguments:?}: {err}");
        assert!(err.contains(accepted), "{arguments:?}: {err}");
    }
}

/// Documents with expressions and axes, and what `--set` changes in them and in others.
#[test]
fn numbers_of_a_document_are_set() {
    let delta = printed(&["new", "delta"]);
    let larger = printed(&["new", "delta", "--base", "200"]);
    let as_made = fed(&["plan"], &larger);
    assert_eq!(as_made.2, 0);
    assert_eq!(fed(&["plan", "--set", "base=200"], &delta), as_made);
    assert_eq!(
        fed(&["export", "csv", "--set", "base=100*2"], &delta),
        as_made
    );
    assert_ne!(fed(&["plan"], &delta), as_made);

    let given = printed(&["plan", "3rps.json"]);
    let moved = printed(&["plan", "--set", "motion.key_frames.1.z=0.9", "3rps.json"]);
    assert_ne!(moved, given);
    assert_eq!(
        printed(&["plan", "--set", "motion.key_frames[1].z:0.9", "3rps.json"]),
        moved
    );
    let nine = printed(&["plan", "--set", "motion.frames=9", "3rps.json"]);
    assert_eq!(nine, printed(&["plan", "--frames", "9", "3rps.json"]));
    for (change, said) in [
        ("base", "no change of a document"),
        ("width=3", "no such place"),
        ("chains[9].base.x=3", "an entry from 0 to 2"),
        ("chains[0].base.x=wide", "wide"),
        ("motion.frames=1", "Motion, frames: "),
    ] {
        let (out, err, code) = run(&["check", "--set", change, "3rps.json"]);
        assert_eq!((out.as_str(), code), ("", 1), "{change}: {err}");
        assert!(
            err.starts_with("3rps.json: ") && err.contains(said),
            "{change}: {err}"
        );
    }
}

#[test]
fn output_goes_into_a_file_only_when_there_is_some() {
    let folder = folder("output");
    let file = folder.join("motion.csv");
    let path = file.to_str().expect("a path");
    assert_eq!(printed(&["plan", "scara.json", "--output", path]), "");
    let written = fs::read_to_string(&file).expect("a file");
    assert_eq!(written, printed(&["plan", "scara.json", "-o", "-"]));
    let (_, err, code) = fed(&["plan", "-o", path], "{}");
    assert_eq!((code, err.is_empty()), (1, false));
    assert_eq!(fs::read_to_string(&file).expect("the same file"), written);
    let nowhere = folder.join("none/motion.csv");
    let nowhere = nowhere.to_str().expect("a path");
    for command in [
        &["plan", "scara.json"][..],
        &["schema"],
        &["enumerate"],
        &["enumerate", "chains", "1"],
    ] {
        let (out, err, code) = run(&[command, &["-o", nowhere]].concat());
        assert_eq!((out.as_str(), code), ("", 2), "{command:?}");
        assert!(err.starts_with(&format!("{nowhere}: ")), "{err}");
    }
}

#[test]
fn a_document_at_fault_is_named_with_the_place() {
    let scara = sample("scara.json");
    let cases = [
        (
            "",
            "standard input: The document: there is no text. Accepted: ",
        ),
        (
            "{\n  nonsense",
            "standard input: Line 2, column 3. The document: this is not JSON, ",
        ),
        (
            &scara.replacen("\"frames\"", "\"pictures\"", 1),
            "standard input: Motion, pictures: there is no field",
        ),
        (
            &scara.replacen("\"version\": 1", "\"version\": 2", 1),
            "standard input: Version: this is version 2 of the format. Accepted: 1.",
        ),
    ];
    for (text, message) in cases {
        for command in [&["plan"][..], &["check"], &["export", "mjcf"]] {
            let (out, err, code) = fed(command, text);
            assert_eq!((out.as_str(), code), ("", 1), "{command:?}: {err}");
            assert!(
                err.starts_with(message),
                "{err:?} does not start with {message:?}"
            );
            assert_eq!(err.lines().count(), 1, "{err}");
        }
        let (out, err, code) = fed(&["check", "--json"], text);
        assert_eq!((err.as_str(), code), ("", 1));
        let verdict: Value = serde_json::from_str(&out).expect("JSON");
        let fault = verdict["fault"]["message"].as_str().expect("a message");
        assert_eq!(
            format!("standard input: {fault}"),
            fed(&["check"], text).1.trim_end()
        );
    }
}

#[test]
fn what_is_no_text_is_at_fault() {
    let file = folder("bytes").join("bytes.json");
    fs::write(&file, b"{\"version\": \xff}").expect("a file");
    let path = file.to_str().expect("a path");
    let (_, err, code) = run(&["plan", path]);
    assert_eq!(
        (err, code),
        (
            format!("{path}: The document: byte 12 is no text. Accepted: JSON text in UTF-8.\n"),
            1
        )
    );
    let (_, err, code) = run(&[
        "plan",
        &format!("{SAMPLES}/3rps.json"),
        "--key-frames",
        path,
    ]);
    assert_eq!(
        (err, code),
        (
            format!("{path}: The table: byte 12 is no text. Accepted: text in UTF-8.\n"),
            1
        )
    );
}

/// The others are checked all the same, and the worst decides.
#[test]
fn a_file_that_is_not_there_gives_no_answer() {
    for command in [&["plan"][..], &["check"], &["export", "json"]] {
        let (out, err, code) = run(&[command, &["none.json"]].concat());
        assert_eq!((out.as_str(), code), ("", 2));
        assert!(err.starts_with("none.json: No such file"), "{err}");
    }
    let (out, err, code) = run(&["check", "none.json", "index.json", "2tpr.json"]);
    assert_eq!((out.lines().next(), code), (Some("2tpr.json: 2TPR"), 2));
    assert_eq!(err.lines().count(), 2, "{err}");
}

#[test]
fn a_table_has_its_units_where_they_are_asked_for() {
    let head = |arguments: &[&str]| -> Vec<String> {
        let out = printed(&[&["export", "csv", "--frames", "2", "scara.json"], arguments].concat());
        let short = out
            .lines()
            .map(|line| line.split(',').take(4).collect::<Vec<_>>().join(","));
        short.take(2).collect()
    };
    let [named, first] = &head(&[])[..] else {
        panic!("two lines")
    };
    assert_eq!(named, "frame,time,status,x[m]");
    assert!(first.starts_with("0,0,reached,"), "{first}");
    assert_eq!(head(&["--headings", "units"]), head(&[]));
    assert_eq!(
        head(&["--headings", "plain"]),
        ["frame,time,status,x", first.as_str()]
    );
    assert_eq!(
        head(&["--headings", "two-rows"]),
        ["frame,time,status,x", ",,,m"]
    );
}

#[test]
fn gravity_needs_a_unit_of_length() {
    let model = printed(&["export", "mjcf", "--gravity", "delta.json"]);
    assert!(model.contains("<option gravity=\"0 0 -9810\""));
    let place = ["--set", "length_unit=furlong"];
    let (out, err, code) =
        run(&[&["export", "mjcf", "--gravity", "delta.json"][..], &place].concat());
    assert_eq!((out.as_str(), code), ("", 1));
    assert!(
        err.contains("furlong") && err.contains("Accepted: m, cm, mm, \u{b5}m, in"),
        "{err}"
    );
}

/// In place of the document's, with a frame for each; the rows that cannot be taken over are told, and the rest is planned.
#[test]
fn key_frames_come_from_a_table() {
    let name = format!("synthetica-{}.csv", std::process::id());
    let path = std::env::temp_dir().join(name);
    let rows: String = (0..40).map(|i| format!("{i} 0 0 {}\n", 600 + i)).collect();
    fs::write(&path, format!("t x y z\n{rows}39 0 0 what\n")).expect("a file");
    let table = path.to_str().expect("a path");
    let asked = ["plan", "3rps.json", "--frames", "2", "--key-frames", table];
    let (out, err, code) =
        run(&[&asked[..], &["--quiet", "--table", "{\"scale\": 0.001}"]].concat());
    assert_eq!((out.lines().count(), code), (3, 0), "{err}");
    assert!(
        err.contains("row 42: \u{201c}what\u{201d} in column 4 is no number"),
        "{err}"
    );
    let last: Vec<&str> = out.lines().last().expect("a line").split(',').collect();
    let goal = out
        .lines()
        .next()
        .expect("headings")
        .split(',')
        .position(|h| h == "goal_z[m]");
    assert_eq!(last[goal.expect("a column")], "0.639");
    // Without --frames the document's are raised to the number of key frames, and never lowered.
    let own = printed(&["plan", "3rps.json", "--quiet"]).lines().count();
    let (out, _, _) = run(&[
        "plan",
        "3rps.json",
        "--quiet",
        "--key-frames",
        table,
        "--table",
        "{\"scale\": 0.001}",
    ]);
    assert_eq!(out.lines().count(), own.max(41));
    let (_, err, code) = run(&["plan", "3rps.json", "--table", "{}"]);
    assert!(code == 2 && err.contains("--key-frames"), "{err}");
    fs::remove_file(&path).expect("it was there");
}

/// Standard input gives one text: a table, or a document.
#[test]
fn standard_input_is_not_read_twice() {
    for arguments in [
        &["plan", "--key-frames", "-"][..],
        &["export", "csv", "-", "--key-frames", "-"],
        &["best", "3rps.json", "2tpr.json", "--key-frames", "-"],
        &["modes", "--key-frames", "-"],
    ] {
        let (out, err, code) = run(arguments);
        assert_eq!((out.as_str(), code), ("", 2), "{arguments:?}");
        let accepted = "Accepted: one document, from a file, with it";
        assert!(err.contains(accepted), "{arguments:?}: {err}");
    }
    for command in ["check", "best", "modes"] {
        let (out, err, code) = run(&[command, "-", "-"]);
        assert_eq!((out.as_str(), code), ("", 2), "{command}");
        assert!(err.contains("Accepted: - once"), "{command}: {err}");
    }
    let table = "x y z\n0 0 0.6\n0 0 0.61\n";
    let arguments = ["plan", "3rps.json", "--quiet", "--key-frames", "-"];
    let (out, err, code) = fed(&arguments, table);
    assert!(code == 0 && out.lines().count() > 2, "{err}");
}

/// The best motion and the ways to assemble take the same table; of a motion that cannot be certified the warnings are left out.
#[test]
fn the_best_motion_has_the_options_of_a_plan() {
    let name = format!("synthetica-best-{}.csv", std::process::id());
    let path = std::env::temp_dir().join(name);
    let rows: String = (0..12).map(|i| format!("0 0 {}\n", 600 + i)).collect();
    fs::write(&path, format!("x y z\n{rows}0 0 what\n")).expect("a file");
    let table = path.to_str().expect("a path");
    let of = [
        "3rps.json",
        "--frames",
        "12",
        "--key-frames",
        table,
        "--table",
        "{\"scale\": 0.001}",
    ];
    let with = |command: &[&str]| run(&[command, &of[..]].concat());
    let (out, err, code) = with(&["best", "--json"]);
    assert_eq!(code, 0, "{err}");
    assert!(err.contains("row 14: "), "{err}");
    assert_eq!(json(&out)["frames"], 12);
    let (out, err, code) = with(&["best", "-f", "csv", "--headings", "two-rows"]);
    assert_eq!(code, 0, "{err}");
    let mut lines = out.lines();
    let [names, units] = [lines.next(), lines.next()].map(|line| line.expect("headings"));
    assert!(
        names.contains(",goal_z,") && units.contains(",m,"),
        "{units}"
    );
    let goal = names.split(',').position(|name| name == "goal_z");
    let last: Vec<&str> = out.lines().last().expect("a line").split(',').collect();
    assert_eq!(last[goal.expect("a column")], "0.611");
    let (out, err, code) = with(&["modes", "--key", "11", "--json"]);
    assert_eq!((json(&out)["frame"].as_u64(), code), (Some(11), 0), "{err}");
    fs::remove_file(&path).expect("it was there");

    let (_, err, code) = run(&["best", "-f", "json", "--headings", "plain", "3rps.json"]);
    assert!(code == 2 && err.contains("Accepted"), "{err}");
    let (out, _, _) = run(&["best", LOCAL]);
    let (quiet, err, _) = run(&["best", "--quiet", LOCAL]);
    let kept: Vec<&str> = (out.lines())
        .filter(|line| !line.starts_with("  warning   "))
        .collect();
    assert_eq!(
        (quiet.lines().collect::<Vec<_>>(), err.as_str()),
        (kept, "")
    );
}

#[test]
fn a_wrong_command_line_says_what_would_be_accepted() {
    for (arguments, accepted) in [
        (&["plan", "--format", "xls"][..], "csv, json"),
        (&["export", "xls"], "csv, json, mjcf"),
        (
            &["export", "csv", "--headings", "none"],
            "units, plain, two-rows",
        ),
        (
            &["export", "json", "--headings", "plain", "3rps.json"],
            "Headings: the format json has none. Accepted: headings with the format csv.",
        ),
        (
            &["export", "csv", "--gravity", "3rps.json"],
            "Accepted: gravity with the format mjcf.",
        ),
        (&["plan", "--frames", "1"], "2..=100001"),
        // The fault is that of the option, and not of the table's file, which is not read.
        (
            &[
                "best",
                "3rps.json",
                "--key-frames",
                "none.csv",
                "--table",
                "{\"order\": \"abc\"}",
            ],
            "for '--table <REQUEST>': Order: \u{201c}abc\u{201d}",
        ),
        (
            &[
                "plan",
                "--key-frames",
                "none.csv",
                "--table",
                "{\"scale\": }",
            ],
            "for '--table <REQUEST>': Line 1, column 11.",
        ),
        (&["plan", "--method", "guess"], "newton, gradient"),
        (&["enumerate", "chains", "5"], "1..=4"),
        (&["enumerate", "chains", "4", "6"], "Accepted: 0 to 5"),
        (&["enumerate", "find", "RXP"], "Accepted: R, P, C, T, S, E"),
        (
            &["enumerate", "find", "SS"],
            "Accepted: chains that impose 1 to 4",
        ),
        (&["draw"], "--help"),
        (&[], "Usage: synthetica <COMMAND>"),
    ] {
        let (out, err, code) = run(arguments);
        assert_eq!((out.as_str(), code), ("", 2), "{arguments:?}");
        assert!(err.contains(accepted), "{arguments:?}: {err}");
    }
}

#[test]
fn the_schema_is_the_published_one() {
    assert_eq!(printed(&["schema"]), schema::SCHEMA);
}

#[test]
fn tables_and_lists_are_those_of_the_library() {
    let text = printed(&["enumerate"]);
    assert!(
        text.contains("\n1  I         all                139\n"),
        "{text}"
    );
    assert!(
        text.contains("\n5            all          487990859\n"),
        "{text}"
    );
    let whole: Value = serde_json::from_str(&printed(&["enumerate", "--json"])).expect("JSON");
    assert_eq!(whole, serde_json::to_value(tables()).expect("JSON"));
    for (table, list) in [("chains", "classes"), ("assemblies", "assemblies")] {
        assert!(text.contains(printed(&["enumerate", table]).trim_end()));
        let part: Value =
            serde_json::from_str(&printed(&["enumerate", table, "--json"])).expect("JSON");
        assert_eq!(part, whole[list]);
    }

    let chains = printed(&["enumerate", "chains", "1"]);
    assert_eq!(chains.lines().count(), 139);
    for (k, chain) in chains.lines().enumerate().step_by(23) {
        assert_eq!(
            printed(&["enumerate", "chains", "1", &k.to_string()]),
            format!("{chain}\n")
        );
        assert_eq!(
            printed(&["enumerate", "find", chain]),
            format!("chains 1 {k}\n")
        );
    }
    let assemblies = printed(&["enumerate", "assemblies", "2"]);
    assert_eq!(assemblies.lines().count(), 9_781);
    let last = printed(&["enumerate", "assemblies", "5", "487990858", "--json"]);
    assert_eq!(last, "[\"TT\",\"E\"]\n");
}

/// Long enough to be shown on a terminal; standard error is none here.
#[test]
fn progress_is_not_written_into_pipes() {
    let file = folder("progress").join("assemblies.txt");
    let path = file.to_str().expect("a path");
    let said = run(&["enumerate", "assemblies", "3", "--output", path]);
    assert_eq!(said, (String::new(), String::new(), 0));
    let written = fs::read_to_string(&file).expect("a file");
    assert_eq!(written.lines().count(), 464_417);
}

#[test]
fn the_end_of_a_pipe_is_the_end_quietly() {
    for arguments in [
        &["enumerate", "assemblies", "4"][..],
        &["plan", "--frames", "2000", "scara.json"],
        &["export", "mjcf", "--frames", "2000", "scara.json"],
        &["check", "3rps.json"],
        &["completions", "bash"],
    ] {
        let mut command = synthetica(arguments);
        let mut child = command
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command runs");
        let mut first = [0];
        let mut stdout = child.stdout.take().expect("a pipe");
        stdout.read_exact(&mut first).expect("some output");
        drop(stdout);
        let output = child.wait_with_output().expect("it ends");
        assert_eq!(
            said(output),
            (String::new(), String::new(), 0),
            "{arguments:?}"
        );
    }
}

const COMMANDS: [&str; 9] = [
    "new",
    "plan",
    "check",
    "best",
    "modes",
    "export",
    "enumerate",
    "schema",
    "completions",
];

/// Runs lines of a shell, in a new folder with the samples and a table of poses.
fn run_in_shell(folder_name: &str, lines: &[&str]) {
    let folder = folder(folder_name);
    for name in samples() {
        fs::copy(format!("{SAMPLES}/{name}"), folder.join(name)).expect("a copy");
    }
    // A tool path in another program's table, for the examples that take one.
    let path = "x,y,z,qw,qx,qy,qz\n0,0,600,1,0,0,0\n10,0,600,1,0,0,0\n";
    fs::write(folder.join("path.csv"), path).expect("a file");
    let built = PathBuf::from(env!("CARGO_BIN_EXE_synthetica"));
    let built = built.parent().expect("a folder").display().to_string();
    let path = format!("{built}:{}", std::env::var("PATH").unwrap_or_default());
    for line in lines {
        let mut bash = Command::new("bash");
        bash.args(["-c", &format!("set -eo pipefail; {line}")]);
        bash.current_dir(&folder)
            .env("PATH", &path)
            .stdin(Stdio::null());
        let (_, err, code) = said(bash.output().expect("bash"));
        assert_eq!(code, 0, "{line}: {err}");
    }
}

/// Every line under "Examples:" runs.
#[test]
fn the_examples_of_the_help_run() {
    let mut helps = vec![vec!["--help"]];
    helps.extend(COMMANDS.map(|command| vec![command, "--help"]));
    for help in helps {
        let text = printed(&help);
        let (_, examples) = text.split_once("\nExamples:\n").expect("examples");
        let examples = examples.lines().take_while(|line| line.starts_with("  "));
        let examples: Vec<&str> = examples.map(str::trim).collect();
        assert!(!examples.is_empty(), "{help:?}");
        run_in_shell("examples", &examples);
    }
}

/// The site's page on the command names every command and option, and its examples run.
#[test]
fn the_reference_of_the_site_is_whole() {
    let page = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/www/pages/reference/50-command-line.md"
    );
    let page = fs::read_to_string(page).expect("the page");
    for command in COMMANDS {
        assert!(page.contains(&format!("| `{command}")), "{command}");
        let help = printed(&[command, "--help"]);
        let (help, _) = help.split_once("\nExamples:\n").expect("examples");
        for option in help.split_whitespace().filter(|w| w.starts_with("--")) {
            assert!(
                option == "--help" || page.contains(option),
                "{command} {option}"
            );
        }
    }
    let (_, examples) = page.split_once("```sh\n").expect("a block");
    let (examples, _) = examples.split_once("```").expect("its end");
    run_in_shell("reference", &examples.lines().collect::<Vec<_>>());
}

#[test]
fn completions_name_the_commands() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = printed(&["completions", shell]);
        for word in ["enumerate", "assemblies", "frames", "gradient"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
    let script = folder("completions").join("synthetica.bash");
    fs::write(&script, printed(&["completions", "bash"])).expect("a file");
    let checked = Command::new("bash")
        .arg("-n")
        .arg(&script)
        .output()
        .expect("bash");
    assert_eq!(said(checked), (String::new(), String::new(), 0));
}

/// A document with driven joints: a table without goals, and a verdict without gaps.
#[test]
fn driven_joints_are_planned() {
    let text = fs::read_to_string(format!("{SAMPLES}/four-bar.json")).expect("a sample");
    let mut document: Value = serde_json::from_str(&text).expect("JSON");
    let values = serde_json::json!([{"time": 0, "value": 90}, {"time": 1, "value": 110}]);
    document["motion"] = serde_json::json!({
        "frames": 5, "drivers": [{"chain": 1, "joint": 1, "values": values}]
    });
    let (out, err, code) = fed(&["plan", "-"], &document.to_string());
    assert_eq!(code, 0, "{err}");
    assert_eq!(out.lines().count(), 6, "{out}");
    assert!(
        out.lines().skip(1).all(|line| line.contains(",reached,")),
        "{out}"
    );
    let (out, err, code) = fed(&["check", "-"], &document.to_string());
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("  driven    θ₁ of crank\n"), "{out}");
    assert!(!out.contains("  gap ") && !out.contains("NaN"), "{out}");
    let (out, _, _) = fed(&["check", "--json", "-"], &document.to_string());
    let verdict: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(verdict["report"]["drivers"], serde_json::json!([0]));
    assert!(
        verdict["translation_gap"].is_null() && verdict["metrics"][0]["rotation_gap"].is_null()
    );
}

/// A linkage whose followed motion stays in a local minimum.
const LOCAL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/field/local-RRCP.json");

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

#[test]
fn the_best_motion_is_told() {
    let text = printed(&["best", "scara.json"]);
    assert!(
        text.starts_with("scara.json: SCARA\n  followed  mean f "),
        "{text}"
    );
    for line in [
        "  result    the followed motion is the best: no motion over the branches known is closer\n",
        "  switches  none\n",
        " % of further starts would lead to others, at most ",
    ] {
        assert!(text.contains(line), "{line:?} is not in {text}");
    }
    let text = printed(&["best", LOCAL]);
    for line in [
        "  result    f falls to ",
        "  switches  before frame ",
        " points, loops closed to ",
    ] {
        assert!(text.contains(line), "{line:?} is not in {text}");
    }

    let out = printed(&["best", "--json", "scara.json", LOCAL]);
    let [scara, local] = &out.lines().map(json).collect::<Vec<_>>()[..] else {
        panic!("{out}")
    };
    assert_eq!(
        (&scara["ok"], &scara["file"]),
        (&true.into(), &"scara.json".into())
    );
    assert_eq!(scara["best"]["mean"], scara["followed"]["mean"]);
    let [mean, followed, bound] = [
        &local["best"]["mean"],
        &local["followed"]["mean"],
        &local["lower_bound"],
    ]
    .map(|number| number.as_f64().expect("a number"));
    assert!(bound <= mean && mean < 0.1 * followed, "{local}");
    assert_eq!(local["switches"].as_array().map(Vec::len), Some(1));
    assert_eq!(local["lane"].as_array().map(Vec::len), Some(33));
    assert_eq!(local["progress"], 1.0);
}

/// Every row of the table closes the loops, and with the angles in radians it is the library's path.
#[test]
fn the_best_motion_is_written_with_all_points() {
    let session =
        Session::open(&fs::read_to_string(LOCAL).expect("a document")).expect("a document");
    let problem = session.problem();
    let mut search = problem.best(session.plan()).expect("goals");
    let found = search.finish().expect("closed loops");

    let csv = printed(&["best", "--format", "csv", LOCAL]);
    let mut lines = csv.lines();
    let head: Vec<&str> = lines.next().expect("headings").split(',').collect();
    assert_eq!(head[..5], ["frame", "branch", "switch", "time", "status"]);
    let column = |name: &str| {
        let own = head.iter().position(|head| head.starts_with(name));
        own.unwrap_or_else(|| panic!("{name} is not in {head:?}"))
    };
    let joints: Vec<usize> = (0..head.len())
        .filter(|&i| head[i].starts_with("chain"))
        .collect();
    let (closure, mut rows, mut ways) = (column("closure"), 0, 0);
    for (line, point) in lines.zip(&found.path) {
        let fields: Vec<&str> = line.split(',').collect();
        assert_eq!(fields.len(), head.len(), "{line}");
        let frame = point.frame.map(|frame| frame.to_string());
        assert_eq!(fields[0], frame.unwrap_or_default(), "{line}");
        let number = |i: usize| -> f64 { fields[i].parse().expect("a number") };
        assert!(number(closure) <= 1e-10, "{line}");
        let values = joints.iter().map(|&i| {
            if head[i].ends_with("[deg]") {
                number(i).to_radians()
            } else {
                number(i)
            }
        });
        let values: Vec<f64> = values.collect();
        for (own, given) in values.iter().zip(&point.joints) {
            assert!((own - given).abs() <= 1e-12 * (1.0 + given.abs()), "{line}");
        }
        let ends: Vec<_> = (problem.mechanism.split(&values))
            .map(|(chain, values)| chain.pose(values).to_homogeneous())
            .collect();
        assert!(
            ends.iter().all(|end| (end - ends[0]).norm() <= 1e-9),
            "{line}"
        );
        assert_eq!(
            fields[1].is_empty(),
            fields[2] == "1" && fields[0].is_empty(),
            "{line}"
        );
        assert_eq!(fields[4] == "passing", fields[0].is_empty(), "{line}");
        (rows, ways) = (rows + 1, ways + usize::from(fields[2] == "1"));
    }
    assert_eq!(
        (rows, csv.lines().count()),
        (found.path.len(), found.path.len() + 1)
    );
    assert_eq!(ways, found.switches[0].points);

    let path = json(&printed(&["best", "-f", "json", LOCAL]));
    assert_eq!(path["format"], "synthetica path");
    assert_eq!(
        (&path["frames"], &path["points"]),
        (&33.into(), &rows.into())
    );
    for name in ["followed", "best", "lower_bound", "switches", "unseen"] {
        assert!(!path["best"][name].is_null(), "{name}");
    }
    assert_eq!(
        path["best"]["switches"][0]["frame"],
        found.switches[0].frame
    );
    assert!(path["report"]["bounds"]["closure"].is_number());
    assert_eq!(path["document"]["name"], session.document().name);
    let columns = path["columns"].as_array().expect("a list");
    let names: Vec<&str> = columns
        .iter()
        .filter_map(|column| column["name"].as_str())
        .collect();
    let plain = head
        .iter()
        .map(|head| head.split('[').next().expect("a name"));
    assert_eq!(names, plain.collect::<Vec<_>>());
    assert_eq!(columns[0]["values"][0], Value::Null);
    let frames = columns[0]["values"].as_array().expect("a list").iter();
    let frames: Vec<f64> = frames.filter_map(Value::as_f64).collect();
    assert_eq!(frames, (0..33).map(f64::from).collect::<Vec<f64>>());
}

/// A row a frame; the larger the price, the slower the fastest joint.
#[test]
fn a_calm_form_has_its_price() {
    let step = |price: &str| {
        let motion = json(&printed(&["best", "-f", "json", "--calm", price, LOCAL]));
        assert_eq!(motion["format"], "synthetica motion");
        assert_eq!(motion["frames"], 33);
        let columns = motion["columns"].as_array().expect("a list");
        let joint = |column: &&Value| column["name"].as_str().is_some_and(|n| n.contains("theta"));
        let steps = columns.iter().filter(joint).flat_map(|column| {
            let values = column["values"].as_array().expect("a list");
            let values: Vec<f64> = values.iter().filter_map(Value::as_f64).collect();
            values
                .windows(2)
                .map(|w| (w[1] - w[0]).abs())
                .collect::<Vec<_>>()
        });
        steps.fold(0.0, f64::max)
    };
    let [little, much] = ["1e-7", "1e-4"].map(step);
    assert!(much < 0.5 * little, "{much}°, {little}°");
    let (out, err, code) = run(&["best", "--calm", "-1", "--format", "csv", LOCAL]);
    assert_eq!((out.as_str(), code), ("", 2), "{err}");
    let (_, err, code) = run(&["best", "--calm", "0", "--format", "csv", LOCAL]);
    assert!(
        code == 2 && err.contains("Accepted: a number above 0"),
        "{err}"
    );
    let (_, err, code) = run(&["best", "--calm", "1e-6", LOCAL]);
    assert!(code == 2 && err.contains("--format"), "{err}");
    let (_, err, code) = run(&["best", "--format", "csv", LOCAL, "scara.json"]);
    assert!(code == 2 && err.contains("one document"), "{err}");
}

#[test]
fn driven_joints_have_neither_best_motion_nor_modes() {
    let expected = "slider-crank.json: Motion: its joints are driven, and there is no goal that another motion could be closer to. Accepted: a motion with key frames.\n";
    for command in [&["best"][..], &["best", "-f", "csv"], &["modes"]] {
        let (out, err, code) = run(&[command, &["slider-crank.json"]].concat());
        assert_eq!(
            (out.as_str(), err.as_str(), code),
            ("", expected, 1),
            "{command:?}"
        );
    }
    for command in ["best", "modes"] {
        let (out, err, code) = run(&[command, "--json", "slider-crank.json", "scara.json"]);
        assert_eq!(
            (out.lines().count(), err.as_str(), code),
            (2, "", 1),
            "{command}"
        );
        let verdict = json(out.lines().next().expect("a line"));
        assert_eq!(
            (&verdict["ok"], &verdict["fault"]["code"]),
            (&false.into(), &"no-goals".into())
        );
        assert_eq!(verdict["fault"]["where"], "motion");
    }
}

#[test]
fn modes_are_told_and_start_a_document() {
    let text = printed(&["modes", "delta.json"]);
    assert!(text.starts_with("delta.json: "), "{text}");
    assert_eq!(text.matches(", the start's\n").count(), 1, "{text}");
    let verdict = json(&printed(&["modes", "--json", "--key", "1", "delta.json"]));
    assert_eq!((&verdict["ok"], &verdict["key"]), (&true.into(), &1.into()));
    let found = verdict["found"].as_array().expect("a list");
    assert!(
        text.lines()
            .filter(|line| line.starts_with("  mode "))
            .count()
            > 1,
        "{text}"
    );
    assert_eq!(
        found.iter().filter(|mode| mode["is_start"] == true).count(),
        1
    );

    let other = found.iter().position(|mode| mode["is_start"] == false);
    let other = other.expect("another way").to_string();
    let document = printed(&["modes", "--key", "1", "--start", &other, "delta.json"]);
    let started = Session::open(&document).expect("a document");
    let index: usize = other.parse().expect("an index");
    let values = &found[index]["joints"];
    for (own, given) in started
        .start()
        .iter()
        .zip(values.as_array().expect("a list"))
    {
        assert!(
            (own - given.as_f64().expect("a number")).abs() < 1e-9,
            "{own}, {given}"
        );
    }
    let (out, err, code) = run(&["modes", "--start", "99", "delta.json"]);
    assert_eq!((out.as_str(), code), ("", 1));
    assert!(err.contains("mode 99 is none. Accepted: 0 to "), "{err}");
    let (_, err, code) = run(&["modes", "--key", "99", "delta.json"]);
    assert!(code == 1 && err.contains("99 is out of range"), "{err}");
}
