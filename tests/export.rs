//! What other programs are given: the table, the JSON and the MuJoCo model of a motion. (That MuJoCo
//! finds the loops closed is tested by tests/mujoco.)

#[path = "common/fixtures.rs"]
mod fixtures;

use fixtures::{SAMPLES, scaled};
use serde_json::Value;
use synthetica::document::fault::FaultCode;
use synthetica::document::problem::Problem;
use synthetica::document::schema::{Document, LimitsEntry};
use synthetica::document::text;
use synthetica::exchange::export::{Format, Options, write};
use synthetica::motion::trajectory::Trajectory;
use synthetica::source::session::Session;

const THREE_RPS: &str = include_str!("../www/mechanisms/3rps.json");
const SCARA: &str = include_str!("../www/mechanisms/scara.json");
const BENNETT: &str = include_str!("../www/mechanisms/bennett.json");

fn read(text: &str) -> Document {
    text::parse(text).expect("a document")
}

fn exported(document: &Document, format: Format) -> (String, Trajectory) {
    let problem = Problem::new(document).expect("a problem");
    let motion = problem.plan();
    let options = Options::default();
    let text = write(format, options, document, &problem.mechanism, &motion);
    (text.expect("a text"), motion)
}

/// The values of an attribute of every element of this name, in order.
fn attributes<'a>(xml: &'a str, element: &str, name: &str) -> Vec<&'a str> {
    xml.lines()
        .map(str::trim_start)
        .filter_map(|line| line.strip_prefix('<')?.strip_prefix(element))
        .filter_map(|rest| {
            let (_, value) = rest.split_once(&format!(" {name}=\""))?;
            value.split('"').next()
        })
        .collect()
}

#[test]
fn the_table_has_units_in_its_headings_and_every_digit() {
    let (text, motion) = exported(&read(THREE_RPS), Format::Csv);
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines.len(), motion.frames() + 1);
    assert!(lines.iter().all(|line| line.len() == lines[0].len()));
    let column = |heading: &str| {
        let found = lines[0].iter().position(|h| *h == heading);
        found.unwrap_or_else(|| panic!("no column {heading}: {:?}", lines[0]))
    };
    let number = |frame: usize, heading: &str| -> f64 {
        lines[frame + 1][column(heading)].parse().expect("a number")
    };
    let same = |a: f64, b: f64| assert_eq!(a.to_bits(), b.to_bits());
    for frame in [0, 64, 128] {
        assert_eq!(lines[frame + 1][column("frame")], frame.to_string());
        let joints = motion.joints_at(frame);
        same(number(frame, "chain1_theta1[deg]"), joints[0].to_degrees());
        same(number(frame, "chain1_d2[m]"), joints[1]);
        same(number(frame, "chain3_theta5[deg]"), joints[14].to_degrees());
        same(number(frame, "x[m]"), motion.poses[frame].translation.x);
        same(
            number(frame, "rotation_gap[deg]"),
            motion.rotation_gap[frame].to_degrees(),
        );
        assert_eq!(
            lines[frame + 1][column("status")],
            motion.status[frame].name()
        );
    }
    let mut document = read(SCARA);
    document.length_unit = "mm, \"rough\"".into();
    let (text, _) = exported(&document, Format::Csv);
    assert!(text.starts_with("frame,time,status,\"x[mm, \"\"rough\"\"]\","));
    document.length_unit.clear();
    let (text, _) = exported(&document, Format::Csv);
    assert!(text.starts_with("frame,time,status,x[length],"));
}

#[test]
fn the_json_has_the_columns_and_the_document() {
    let mut document = read(SCARA);
    document.name = "a \"b\" \\ c".into();
    let (text, motion) = exported(&document, Format::Json);
    let value: Value = serde_json::from_str(&text).expect("JSON");
    let columns = value["columns"].as_array().expect("columns");
    let (table, _) = exported(&document, Format::Csv);
    let headings = table.lines().next().expect("headings").split(',');
    let names: Vec<String> = columns
        .iter()
        .map(|c| match (&c["name"], &c["unit"]) {
            (Value::String(name), Value::String(unit)) if unit.is_empty() => name.clone(),
            (Value::String(name), Value::String(unit)) => format!("{name}[{unit}]"),
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(names, headings.collect::<Vec<_>>());
    for column in columns {
        let values = column["values"].as_array().map(Vec::len);
        assert_eq!(values, Some(motion.frames()), "{}", column["name"]);
    }
    assert_eq!(value["name"], "a \"b\" \\ c");
    assert_eq!(value["frames"], motion.frames());
    assert_eq!(
        (&columns[0]["name"], &columns[0]["values"][0]),
        (&"frame".into(), &0.into())
    );
    let last = motion.frames() - 1;
    assert_eq!(columns[0]["values"][last], last);
    let kept = text::parse(&value["document"].to_string()).expect("the document");
    assert_eq!(kept.text(), document.text());
}

#[test]
fn the_model_has_a_joint_a_variable_and_a_weld_a_loop() {
    let (xml, motion) = exported(&read(THREE_RPS), Format::Mjcf);
    let joints = attributes(&xml, "joint", "name");
    assert_eq!(joints.len(), motion.variables);
    assert_eq!(
        joints[..6],
        [
            "chain1_theta1",
            "chain1_d2",
            "chain1_theta3",
            "chain1_theta4",
            "chain1_theta5",
            "chain2_theta1"
        ]
    );
    assert_eq!(
        attributes(&xml, "weld", "body2"),
        ["chain2_end", "chain3_end"]
    );
    assert_eq!(attributes(&xml, "weld", "body1"), ["workpiece"; 2]);
    let bodies = attributes(&xml, "body", "name");
    assert_eq!(bodies.len(), 3 * (1 + 5 + 1));
    assert_eq!(xml.matches("</body>").count(), bodies.len());
    let keys = attributes(&xml, "key", "qpos");
    assert_eq!(keys.len(), motion.frames());
    for (frame, key) in keys.iter().enumerate() {
        let values: Vec<f64> = key.split(' ').map(|x| x.parse().expect("x")).collect();
        assert_eq!(values, motion.joints_at(frame));
    }
    let names = attributes(&xml, "key", "name");
    assert_eq!((names[0], names[128]), ("frame0", "frame128"));
    let references: Vec<f64> = (attributes(&xml, "joint", "ref").iter())
        .map(|x| x.parse().expect("a number"))
        .collect();
    assert_eq!(references, motion.joints_at(0));
}

/// The joints that have drives, in order.
fn drives(document: &Document) -> Vec<String> {
    let (xml, _) = exported(document, Format::Mjcf);
    let own = attributes(&xml, "position", "joint");
    own.into_iter().map(str::to_owned).collect()
}

/// As many drives as there are freedoms, on the joints that machines drive where those command the motion; what each key
/// frame asks of them is what the joints have there.
#[test]
fn drives_are_where_they_command_the_motion() {
    let sample = |text| drives(Session::open(text).expect("a sample").document());
    let (tripod, delta) = (
        include_str!("../www/mechanisms/tripod.json"),
        include_str!("../www/mechanisms/delta.json"),
    );
    assert_eq!(sample(tripod), ["chain1_d2", "chain2_d2", "chain3_d2"]);
    assert_eq!(
        sample(delta),
        ["chain1_theta1", "chain2_theta1", "chain3_theta1"]
    );
    // Its slider stands still where the crank is at a dead point.
    let crank = include_str!("../www/mechanisms/slider-crank.json");
    assert_eq!(sample(crank), ["chain1_theta1"]);
    assert_eq!(sample(SCARA).len(), 4);
    // Its sliders, locked, leave the workpiece loose between the frames 123 and 124.
    let legs = sample(THREE_RPS);
    assert_ne!(legs, ["chain1_d2", "chain2_d2", "chain3_d2"]);
    assert_eq!(legs.len(), 3);

    let (xml, motion) = exported(&read(THREE_RPS), Format::Mjcf);
    let joints = attributes(&xml, "joint", "name");
    let driven: Vec<usize> = (attributes(&xml, "position", "joint").iter())
        .map(|name| joints.iter().position(|joint| joint == name).expect("one"))
        .collect();
    assert_eq!(driven.len(), 3);
    for (frame, controls) in attributes(&xml, "key", "ctrl").iter().enumerate() {
        let values: Vec<f64> = controls.split(' ').map(|x| x.parse().expect("x")).collect();
        let own = driven.iter().map(|&k| motion.joints_at(frame)[k]);
        assert_eq!(values, own.collect::<Vec<_>>());
    }
    // A joint that is held needs none.
    let mut held = read(BENNETT);
    let at = Some(45.0);
    held.chains[1].joints[0].limits = Some(vec![Some(LimitsEntry { min: at, max: at })]);
    assert!(!drives(&held).contains(&"chain2_theta1".to_owned()));
}

/// The slider of an engine turns back twice a turn, also where no frame is at that point.
#[test]
fn a_drive_passes_no_dead_point_between_two_frames() {
    let crank = include_str!("../www/mechanisms/slider-crank.json");
    let mut document = Session::open(crank).expect("a sample").document().clone();
    for frames in [8, 20, 121] {
        document.motion.frames = frames;
        let problem = Problem::new(&document).expect("a problem");
        let mut motion = problem.plan();
        // As if nobody had said what drives it.
        motion.drivers.clear();
        let options = Options::default();
        let (mechanism, format) = (&problem.mechanism, Format::Mjcf);
        let xml = write(format, options, &document, mechanism, &motion).expect("a model");
        let own = attributes(&xml, "position", "joint");
        assert!(
            own.len() == 1 && own[0].contains("theta"),
            "{frames} frames: {own:?}"
        );
    }
}

#[test]
fn the_model_has_sensors_on_the_workpiece_and_gravity_where_it_is_asked_for() {
    let mut document = read(THREE_RPS);
    let problem = Problem::new(&document).expect("a problem");
    let motion = problem.plan();
    let (xml, _) = exported(&document, Format::Mjcf);
    for kind in ["framepos", "framequat", "framelinvel", "frameangvel"] {
        assert_eq!(attributes(&xml, kind, "objname"), ["workpiece"], "{kind}");
    }
    assert_eq!(attributes(&xml, "site", "name"), ["workpiece"]);
    assert_eq!(attributes(&xml, "option", "gravity"), ["0 0 0"]);
    let model = |document: &Document, gravity| {
        let options = Options {
            gravity: Some(gravity),
            ..Options::default()
        };
        write(Format::Mjcf, options, document, &problem.mechanism, &motion)
    };
    for (unit, gravity) in [
        ("m", "0 0 -9.81"),
        ("mm", "0 0 -9810"),
        ("cm", "0 0 -981"),
        ("\u{3bc}m", "0 0 -9.81e6"),
    ] {
        document.length_unit = unit.into();
        let heavy = model(&document, true).expect("a model");
        assert_eq!(attributes(&heavy, "option", "gravity"), [gravity], "{unit}");
        let light = model(&document, false).expect("a model");
        assert_eq!(attributes(&light, "option", "gravity"), ["0 0 0"]);
    }
    for unit in ["", "cubit"] {
        document.length_unit = unit.into();
        assert!(model(&document, false).is_ok());
        let fault = model(&document, true).expect_err("no gravity in it");
        assert_eq!(fault.place, "length_unit");
        assert_eq!(fault.accepted, "m, cm, mm, \u{b5}m, in");
    }
}

#[test]
fn options_are_words_of_their_format() {
    let read = |text: &str| Options::read(text);
    assert_eq!(read(""), Ok(Options::default()));
    let plain = read("{\"headings\": \"plain\"}").expect("options");
    assert!(plain.check(Format::Csv).is_ok());
    for (fault, place) in [
        (read("{\"headings\": \"none\"}"), "headings"),
        (read("{\"gravity\": 9.81}"), "gravity"),
        (read("{\"units\": true}"), "units"),
        (plain.check(Format::Mjcf).map(|()| plain), "headings"),
        (
            read("{\"gravity\": false}").and_then(|own| own.check(Format::Csv).map(|()| own)),
            "gravity",
        ),
    ] {
        let fault = fault.expect_err(place);
        assert_eq!(fault.place, place, "{fault}");
        assert!(!fault.accepted.is_empty(), "{fault}");
    }
    let fault = read("{\"headings\": \"none\"}").expect_err("none");
    assert!(fault.accepted.contains("units, plain, two-rows"), "{fault}");
}

/// What is only looked at has rounded numbers, by its own size: that of a linkage of a micrometre is there too.
#[test]
fn a_small_linkage_is_drawn() {
    for text in SAMPLES {
        let large = exported(&read(text), Format::Mjcf).0;
        let small = exported(&scaled(&read(text), 1e-6), Format::Mjcf).0;
        for name in ["size", "fromto", "pos"] {
            let (large, small) = (
                attributes(&large, "geom", name),
                attributes(&small, "geom", name),
            );
            assert_eq!(large.len(), small.len());
            for (large, small) in large.iter().zip(small) {
                for (a, b) in large.split(' ').zip(small.split(' ')) {
                    let [a, b] = [a, b].map(|x| x.parse::<f64>().expect("a number"));
                    assert!(
                        (a * 1e-6 - b).abs() <= 1e-6 * a.abs().max(1e-3) * 1e-3,
                        "{name}: {a}, {b}"
                    );
                }
            }
        }
    }
}

/// A C is a hinge and a slide in one body; a single chain needs no weld.
#[test]
fn a_cylindric_joint_is_a_hinge_and_a_slide() {
    let (xml, _) = exported(&read(SCARA), Format::Mjcf);
    let kinds = attributes(&xml, "joint", "type");
    assert_eq!(kinds, ["hinge", "hinge", "hinge", "slide"]);
    let names = attributes(&xml, "joint", "name");
    assert_eq!(names[2..], ["chain1_theta3", "chain1_d3"]);
    assert_eq!(attributes(&xml, "body", "name").len(), 5);
    assert!(!xml.contains("<equality>"));
}

#[test]
fn limits_are_ranges_and_a_fixed_joint_is_held() {
    let mut document = read(BENNETT);
    let limits = |min, max| Some(vec![Some(LimitsEntry { min, max })]);
    let joints = &mut document.chains[0].joints;
    joints[0].limits = limits(Some(-360.0), None);
    joints[1].limits = limits(Some(-720.0), Some(720.0));
    document.chains[1].joints[0].limits = limits(Some(45.0), Some(45.0));
    let (xml, _) = exported(&document, Format::Mjcf);
    let ranges: Vec<f64> = (attributes(&xml, "joint", "range").iter())
        .flat_map(|range| range.split(' ').map(|x| x.parse().expect("a number")))
        .collect();
    let degrees = [-360.0_f64, 1e6, -720.0, 720.0];
    assert_eq!(ranges, degrees.map(f64::to_radians));
    assert_eq!(
        attributes(&xml, "joint", "joint1"),
        ["chain2_theta1"],
        "{xml}"
    );
}

#[test]
fn a_model_of_open_loops_has_no_key_frames_and_any_name_is_text() {
    let mut document = read(BENNETT);
    document.name = "<a> & \"b\"\u{1}".into();
    document.chains[0].joints[1].rows[0].alpha = 31.0;
    let (xml, motion) = exported(&document, Format::Mjcf);
    assert!(motion.closure.iter().all(|&opening| opening > 1e-6));
    assert!(!xml.contains("<keyframe>") && !xml.contains("<actuator>"));
    assert!(xml.starts_with("<mujoco model=\"&lt;a&gt; &amp; &quot;b&quot;\">"));
}

#[test]
fn formats_are_asked_for_by_name() {
    for format in Format::ALL {
        assert_eq!(Format::named(format.name()), Ok(format));
    }
    let fault = Format::named("xls").expect_err("none");
    assert_eq!(fault.code, FaultCode::UnknownValue);
    assert_eq!(
        fault.message,
        "Format: “xls” is none. Accepted: csv, json, mjcf."
    );
}
