//! Documents with expressions, chains by their axes, tables and frames in other conventions.

use synthetica::document::fault::Fault;
use synthetica::motion::trajectory::{Status, Warning};
use synthetica::{Session, source::typed::Typed};

fn session(text: &str) -> Session {
    Session::open(text).unwrap_or_else(|fault| panic!("{fault}\n{text}"))
}

fn fault(text: &str) -> Fault {
    Session::open(text).expect_err("a fault")
}

/// A delta robot by its axes: the numbers are those of its drawing.
fn delta(parameters: &str) -> String {
    let arm = |i: usize| {
        let point = |radius: &str, height: &str| {
            format!(r#"["({radius})*cos({i}*120)", "({radius})*sin({i}*120)", "{height}"]"#)
        };
        let tangent = format!(r#"["-sin({i}*120)", "cos({i}*120)", 0]"#);
        let across =
            format!(r#"["height*cos({i}*120)", "height*sin({i}*120)", "platform-base-upper"]"#);
        format!(
            r#"{{"joints": [
                {{"type": "R", "point": {}, "axis": {tangent}}},
                {{"type": "U", "point": {}, "axis": {tangent}, "second": {across}}},
                {{"type": "U", "point": {}, "axis": {across}, "second": {tangent}}}]}}"#,
            point("base", "0"),
            point("base+upper", "0"),
            point("platform", "-height"),
        )
    };
    let arms: Vec<String> = (0..3).map(arm).collect();
    format!(
        r#"{{"version": 1, "length_unit": "mm", "parameters": {{{parameters}}},
            "home": {{"z": "-height"}}, "chains": [{}],
            "motion": {{"key_frames": [{{"z": "-height"}}, {{"x": 60, "y": -30, "z": "-height-40"}}]}}}}"#,
        arms.join(",")
    )
}

const DELTA: &str = r#""height": "sqrt(lower^2-(base+upper-platform)^2)", "base": 200, "platform": 50, "upper": 300, "lower": 580"#;

#[test]
fn a_delta_by_its_axes_is_closed_at_home_and_moves() {
    let open = session(&delta(DELTA));
    let motion = open.plan();
    assert!(motion.warnings.is_empty(), "{:?}", motion.warnings);
    assert_eq!(motion.mobility_rank, 3);
    assert!(motion.start.iter().all(|&value| value == 0.0));
    assert!(
        motion.status.iter().all(|s| *s == Status::Reached),
        "{:?}",
        motion.status
    );
    let height = (580.0_f64 * 580.0 - 450.0 * 450.0).sqrt();
    let parameters = open.typed().parameters.list();
    assert!((parameters[0].value - height).abs() < 1e-12 * height);
    assert!(!parameters[0].input && parameters[1].input);
    let value = |path: &str| {
        let mut all = open.typed().expressions.iter();
        all.find(|one| one.path == path).map(|one| one.value)
    };
    assert_eq!(value("home.z"), Some(-parameters[0].value));
    assert_eq!(value("chains[0].joints[1].point[0]"), Some(500.0));
    assert_eq!(value("motion.key_frames[1].x"), None);
}

#[test]
fn a_parameter_is_told_by_its_name() {
    let told = fault(&delta(&DELTA.replace("200", "\"200+\""))).to_string();
    assert!(
        told.starts_with("Parameter \u{201c}base\u{201d}: "),
        "{told}"
    );
}

#[test]
fn what_was_typed_is_kept_with_its_defaults() {
    let text = session(&delta(DELTA)).text();
    for typed in [
        r#""parameters": {"height": "#,
        r#""home": {"z": "-height"}"#,
        r#""(base+upper)*cos(0*120)""#,
    ] {
        assert!(text.contains(typed), "{typed}\n{text}");
    }
    for hidden in ["rows", "gripper", "\"base\": {", "start"] {
        assert!(!text.contains(hidden), "{hidden}\n{text}");
    }
    assert!(text.contains(r#""interpolation": "bezier""#), "{text}");
    assert_eq!(session(&text).text(), text);
    let started = session(&text).text_with_start();
    assert!(started.contains(r#""start": [0, 0, 0, 0, 0]"#), "{started}");
    assert_eq!(
        session(&started).plan().joints,
        session(&text).plan().joints
    );
}

#[test]
fn plain_documents_stay_as_they_are() {
    let text = include_str!("../www/mechanisms/3rps.json");
    let typed = Typed::read(text).expect("a sample");
    assert!(!typed.is_typed());
    assert_eq!(typed.text(), typed.document.text());
}

const COPIED: &str = include_str!("field/cobra600-copied.json");

#[test]
fn a_standard_table_as_printed_needs_its_convention_named() {
    let modified = session(COPIED).plan();
    assert!(
        modified.warnings.contains(&Warning::StandardTable),
        "{:?}",
        modified.warnings
    );
    let named = COPIED.replacen(
        "\"name\": \"arm\",",
        "\"name\": \"arm\", \"convention\": \"standard\",",
        1,
    );
    assert_ne!(named, COPIED);
    let open = session(&named);
    let motion = open.plan();
    assert!(!motion.warnings.contains(&Warning::StandardTable));
    for frame in [0, 16, 32] {
        assert_eq!(motion.status[frame], Status::Reached, "frame {frame}");
    }
    let text = open.text();
    assert!(text.contains(r#""convention": "standard""#), "{text}");
    assert_eq!(session(&text).text(), text);
}

#[test]
fn a_universal_joint_may_be_called_u() {
    let open = session(include_str!("field/universal-u.json"));
    assert_eq!(open.problem().mechanism.chains()[0].type_name(), "T");
    assert!(open.text().contains(r#""type": "T""#));
}

#[test]
fn radians_are_degrees() {
    let degrees = r#"{"version": 1, "chains": [{"base": {"longitude": 30}, "gripper": {"x": 1}, "start": [45, 10],
        "joints": [{"type": "T", "rows": [{"theta": 20}, {"alpha": 90}], "limits": [{"min": -180}, null]}]}],
        "motion": {"key_frames": [{"x": 1, "roll": 90}, {"y": 1, "roll": "45 deg"}]}}"#;
    let radians = r#"{"version": 1, "angles": "radians", "chains": [{"base": {"longitude": "pi/6"}, "gripper": {"x": 1}, "start": ["pi/4", "10 deg"],
        "joints": [{"type": "T", "rows": [{"theta": "20 deg"}, {"alpha": 1.5707963267948966}], "limits": [{"min": "-pi"}, null]}]}],
        "motion": {"key_frames": [{"x": 1, "roll": "pi/2"}, {"y": 1, "roll": "pi/4"}]}}"#;
    let (d, r) = (session(degrees), session(radians));
    assert_eq!(d.problem().start, r.problem().start);
    assert_eq!(d.plan().joints, r.plan().joints);
    assert_eq!(session(&r.text()).text(), r.text());
    // Written in the document's unit.
    let started = session(&r.text_with_start());
    assert_eq!(started.problem().start.len(), 1);
    let (a, b) = (started.start()[0], r.start()[0]);
    assert!((a - b).abs() < 1e-12, "{a} {b}");
}

#[test]
fn rotations_are_given_in_any_form() {
    let with = |rotation: &str| {
        format!(
            r#"{{"version": 1, "chains": [{{"joints": [{{"type": "S", "rows": [{{}}, {{"alpha": 90}}, {{"alpha": -90}}]}}]}}],
            "motion": {{"key_frames": [{{"name": "a", {rotation}}}, {{"roll": 5}}]}}}}"#
        )
    };
    // 90 degrees about x, then 90 about the fixed z: columns y, z, x.
    let forms = [
        r#""roll_pitch_yaw": [90, 0, 90]"#,
        r#""roll_pitch_yaw": [90, 0, 90], "order": "xyz""#,
        r#""roll_pitch_yaw": [90, 90, 0], "order": "ZXY""#,
        r#""quaternion_wxyz": [0.5, 0.5, 0.5, 0.5]"#,
        r#""quaternion_xyzw": [0.5, 0.5, 0.5, 0.5]"#,
        r#""matrix": [[0, 0, 1], [1, 0, 0], [0, 1, 0]]"#,
    ];
    for form in forms {
        let open = session(&with(form));
        let first = open.problem().goals[0].pose.rotation * nalgebra::Vector3::x();
        assert!(
            (first - nalgebra::Vector3::y()).norm() < 1e-14,
            "{form}: {first}"
        );
        let text = open.text();
        assert!(
            !text.contains(r#""name": "a", "x": 0, "y": 0, "z": 0, "longitude""#),
            "{text}"
        );
        assert_eq!(session(&text).text(), text);
    }
    for (rotation, place) in [
        (
            r#""quaternion_wxyz": [1, 0, 0]"#,
            "motion.key_frames[0].quaternion_wxyz",
        ),
        (
            r#""quaternion_wxyz": [1, 1, 0, 0]"#,
            "motion.key_frames[0].quaternion_wxyz",
        ),
        (
            r#""matrix": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]"#,
            "motion.key_frames[0].matrix",
        ),
        (
            r#""matrix": [[1, 0, 0], [0, 1, 0], 3]"#,
            "motion.key_frames[0].matrix[2]",
        ),
        (
            r#""roll_pitch_yaw": [1, 0, 0], "order": "xyx2""#,
            "motion.key_frames[0].order",
        ),
        (r#""order": "xyz""#, "motion.key_frames[0].order"),
        (
            r#""quaternion_wxyz": [1, 0, 0, 0], "order": "xyz""#,
            "motion.key_frames[0].order",
        ),
        (
            r#""roll_pitch_yaw": [0, 1e300, 0]"#,
            "motion.key_frames[0].roll_pitch_yaw[1]",
        ),
        (
            r#""roll": 3, "roll_pitch_yaw": [1, 0, 0]"#,
            "motion.key_frames[0].roll",
        ),
        (
            r#""quaternion_wxyz": [1, 0, 0, 0], "roll_pitch_yaw": [1, 0, 0]"#,
            "motion.key_frames[0].roll_pitch_yaw",
        ),
        (r#""pitch": 3"#, "motion.key_frames[0].pitch"),
    ] {
        assert_eq!(fault(&with(rotation)).place, place, "{rotation}");
    }
}

#[test]
fn every_fault_has_its_place() {
    let good = delta(DELTA);
    let broken = |from: &str, to: &str| {
        assert!(good.contains(from), "{from}");
        fault(&good.replacen(from, to, 1))
    };
    for (from, to, place) in [
        (r#""base": 200"#, r#""base": true"#, "parameters.base"),
        (r#""base": 200"#, r#""base": "200+""#, "parameters.base"),
        (r#""base": 200"#, r#""base": "height""#, "parameters.height"),
        (r#""lower": 580"#, r#""lower": 400"#, "parameters.height"),
        (
            r#""z": "-height"}, "chains""#,
            r#""z": "-heigth"}, "chains""#,
            "home.z",
        ),
        (
            r#""type": "U", "point""#,
            r#""type": "U", "pint""#,
            "chains[0].joints[1].pint",
        ),
        (
            r#""type": "R""#,
            r#""type": "Q""#,
            "chains[0].joints[0].type",
        ),
        (r#""x": 60"#, r#""x": "60 mm""#, "motion.key_frames[1].x"),
        (
            r#"{"joints""#,
            r#"{"base": {"x": 1}, "joints""#,
            "chains[0].base",
        ),
        (
            r#"{"joints""#,
            r#"{"convention": "standard", "joints""#,
            "chains[0].convention",
        ),
        (r#""length_unit""#, r#""lenght_unit""#, "lenght_unit"),
        (
            r#""length_unit""#,
            r#""angles": "gradians", "length_unit""#,
            "angles",
        ),
        (
            r#""axis": ["-sin(0*120)", "cos(0*120)", 0]"#,
            r#""axis": [0, "0*base", 0]"#,
            "chains[0].joints[0].axis",
        ),
        (
            r#""axis": ["-sin(0*120)", "cos(0*120)", 0]"#,
            r#""axis": [0, 0]"#,
            "chains[0].joints[0].axis",
        ),
        (
            r#""point": ["(base)*cos(0*120)", "(base)*sin(0*120)", "0"]"#,
            r#""point": [1, 2, 1e13]"#,
            "chains[0].joints[0].point[2]",
        ),
        (
            r#""point": ["(base)*cos(0*120)", "(base)*sin(0*120)", "0"],"#,
            "",
            "chains[0].joints[0].point",
        ),
    ] {
        let fault = broken(from, to);
        assert_eq!(fault.place, place, "{from} -> {to}: {fault}");
        assert!(
            !fault.accepted.is_empty() && fault.message.len() < 400,
            "{fault}"
        );
    }
}

#[test]
fn a_fault_of_a_standard_table_is_at_the_row_that_was_typed() {
    let with = |first: &str, second: &str| {
        format!(
            r#"{{"version": 1, "chains": [{{"convention": "standard", "joints": [
                {{"type": "R", "rows": [{{{first}}}]}}, {{"type": "T", "rows": [{{{second}}}, {{"a": 1}}]}}]}}],
            "motion": {{"key_frames": [{{"x": 1}}, {{"roll": 5}}]}}}}"#
        )
    };
    let right = r#""alpha": 90"#;
    assert_eq!(
        session(&with(right, right)).problem().mechanism.variables(),
        3
    );
    for (first, second, place) in [
        (r#""a": 1e13"#, right, "chains[0].joints[0].rows[0].a"),
        (
            r#""alpha": 1e7"#,
            right,
            "chains[0].joints[0].rows[0].alpha",
        ),
        (
            r#""alpha": null"#,
            right,
            "chains[0].joints[0].rows[0].alpha",
        ),
        (r#""a": true"#, right, "chains[0].joints[0].rows[0].a"),
        ("", r#""alpha": 80"#, "chains[0].joints[1].rows[0].alpha"),
        (
            "",
            r#""alpha": 90, "a": 1"#,
            "chains[0].joints[1].rows[0].a",
        ),
        (
            "",
            r#""alpha": 90, "d": 1e13"#,
            "chains[0].joints[1].rows[0].d",
        ),
    ] {
        let fault = fault(&with(first, second));
        assert_eq!(fault.place, place, "{fault}");
    }
}

#[test]
fn rows_too_long_for_a_document_are_told_at_the_axes() {
    let with = |x: &str, home: &str| {
        format!(
            r#"{{"version": 1, "home": {{{home}}}, "chains": [{{"joints": [{{"type": "R", "point": [0, 0, 0], "axis": [0, 0, 1]}},
                {{"type": "R", "point": [{x}, 0, 0], "axis": [0, 0.00001, 1]}}]}}],
            "motion": {{"key_frames": [{{"x": 1}}, {{"x": 2}}]}}}}"#
        )
    };
    assert_eq!(session(&with("1", "")).problem().mechanism.variables(), 2);
    let far = with("1", "").replace("\"point\": [1, 0, 0]", "\"point\": [0, 1e9, 0]");
    let fault = fault(&far);
    assert!(fault.place.starts_with("chains[0].joints["), "{fault}");
    assert!(fault.message.contains("common normal"), "{fault}");
}
