//! The built library in a real browser: golden motions, bindings, faults.
#![cfg(target_arch = "wasm32")]

#[path = "common/golden.rs"]
mod golden;

use js_sys::{Float64Array, Reflect};
use synthetica::bind::wasm::Session;
use synthetica::bind::wasm_study;
use synthetica::plan::follow::plan;
use synthetica::plan::settings::Settings;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

const SAMPLE: &str = include_str!("../www/mechanisms/3rps.json");

fn get(object: &JsValue, name: &str) -> JsValue {
    Reflect::get(object, &name.into()).unwrap_or(JsValue::UNDEFINED)
}

fn column(motion: &JsValue, name: &str) -> Vec<f64> {
    get(motion, name).unchecked_into::<Float64Array>().to_vec()
}

fn open(text: &str) -> Session {
    Session::open(text).expect("a document")
}

/// The place that a fault names.
fn place<T>(refused: Result<T, JsValue>) -> Option<String> {
    let fault = refused.map(drop).expect_err("a fault");
    get(&fault, "where").as_string()
}

/// Every column of numbers, to the last bit; and what is said about the motion.
fn all_of(motion: &JsValue) -> String {
    let names = [
        "time",
        "goal",
        "pose",
        "joints",
        "rows",
        "metric",
        "translation_gap",
        "rotation_gap",
        "closure",
        "misfit",
        "sigma_min",
        "projected_gradient",
    ];
    let bits = |name: &str| {
        column(motion, name)
            .iter()
            .map(|x| x.to_bits())
            .collect::<Vec<_>>()
    };
    let said = js_sys::JSON::stringify(&get(motion, "report")).expect("plain data");
    format!("{said} {:?}", names.map(bits))
}

#[wasm_bindgen_test]
fn golden_motions_are_met() {
    for task in golden::tasks() {
        let t = plan(&task.mechanism, &task.start, &task.goals, &Settings::PAPER);
        for (i, (_, f)) in task.reference.iter().enumerate() {
            assert!(
                t.closure[i] <= 1e-10,
                "{} frame {i}: open by {:e}",
                task.name,
                t.closure[i]
            );
            assert!(
                t.metric[i] <= f + 1e-9,
                "{} frame {i}: f = {}, {f} is possible",
                task.name,
                t.metric[i]
            );
            assert!(
                t.status[i].is_certified(),
                "{} frame {i}: {:?}",
                task.name,
                t.status[i]
            );
        }
    }
}

#[wasm_bindgen_test]
fn a_plan_is_columns_and_a_report() {
    let motion: JsValue = open(SAMPLE).plan().expect("a sample plans").into();
    let frames = column(&motion, "time").len();
    assert!(frames >= 2);
    assert_eq!(get(&motion, "frames").as_f64(), Some(frames as f64));
    assert_eq!(column(&motion, "pose").len(), 7 * frames);
    assert_eq!(column(&motion, "joints").len(), 15 * frames);
    assert_eq!(column(&motion, "rows").len(), 15 * 14 * frames);
    assert!(column(&motion, "closure").iter().all(|e| *e <= 1e-10));
    let report = get(&motion, "report");
    assert_eq!(get(&report, "mobility_count").as_f64(), Some(3.0));
    assert_eq!(get(&report, "mobility_rank").as_f64(), Some(3.0));
}

#[wasm_bindgen_test]
fn a_posture_is_one_frame_of_columns() {
    let session = open(SAMPLE);
    let motion: JsValue = open(SAMPLE).plan().expect("a sample plans").into();
    let joints = &column(&motion, "joints")[..15];
    let goal = &column(&motion, "goal")[7..14];
    let pulled: JsValue = session.pull(joints, goal).expect("a posture").into();
    assert_eq!(column(&pulled, "joints").len(), 15);
    assert_eq!(column(&pulled, "rows").len(), 15 * 14);
    assert_eq!(column(&pulled, "goal").len(), 7);
    assert!(get(&pulled, "status").is_string() && get(&pulled, "obstacle").is_undefined());
    assert!(get(&pulled, "closure").as_f64().is_some_and(|e| e <= 1e-10));
    let near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6);
    assert!(near(
        &column(&pulled, "pose"),
        &column(&motion, "pose")[7..14]
    ));

    let driven: JsValue = session
        .drive(joints, 1.0, joints[1] + 0.1)
        .expect("a posture")
        .into();
    assert_eq!(get(&driven, "value").as_f64(), Some(joints[1] + 0.1));
    assert!(get(&driven, "obstacle").is_undefined());
    assert_eq!(column(&driven, "pose"), column(&driven, "goal"));
    let far: JsValue = session.drive(joints, 1.0, -30.0).expect("a posture").into();
    let obstacle = get(&far, "obstacle").as_string().expect("a sentence");
    assert!(obstacle.contains("cannot close"), "{obstacle}");
    assert!(get(&far, "value").as_f64() > Some(0.0));

    let insight: JsValue = session.explain(joints, goal).expect("an insight").into();
    let freedoms: js_sys::Array = get(&insight, "freedoms").unchecked_into();
    assert_eq!(freedoms.length(), 3);
    assert_eq!(get(&insight, "mobility_rank").as_f64(), Some(3.0));
    let chains: js_sys::Array = get(&insight, "chains").unchecked_into();
    assert_eq!(chains.length(), 3);
}

#[wasm_bindgen_test]
fn nonsense_about_a_posture_is_a_fault() {
    let joints = [0.0; 15];
    let goal = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let session = open(SAMPLE);
    let told = place(session.pull(&joints[1..], &goal));
    assert_eq!(told.as_deref(), Some("joints"));
    for variable in [0.5, -1.0, 15.0, f64::NAN] {
        let told = place(session.drive(&joints, variable, 0.0));
        assert_eq!(told.as_deref(), Some("variable"));
    }
    let told = place(session.explain(&joints, &[f64::NAN; 7]));
    assert!(told.is_some_and(|place| place.starts_with("goal")));
}

#[wasm_bindgen_test]
fn a_fault_is_an_object_that_names_its_place() {
    let text = SAMPLE.replacen("\"type\": \"R\"", "\"type\": \"X\"", 1);
    let fault = Session::open(&text).map(drop).expect_err("no such joint");
    assert_eq!(
        get(&fault, "where").as_string().as_deref(),
        Some("chains[0].joints[0].type")
    );
    assert!(get(&fault, "message").is_string() && get(&fault, "accepted").is_string());
}

#[wasm_bindgen_test]
fn documents_come_back_whole() {
    let whole = open(SAMPLE).text();
    assert_eq!(open(&whole).text(), whole);
    let started = open(&whole).find_start();
    assert!(started.contains("\"start\""));
    let defaults: JsValue = wasm_study::defaults().expect("plain data").into();
    let text = get(&defaults, "document").as_string().expect("text");
    assert!(open(&text).plan().is_ok(), "the default document plans");
    assert!(wasm_study::schema().contains("$schema"));
}

#[wasm_bindgen_test]
fn enumeration_is_that_of_the_paper() {
    let tables: JsValue = wasm_study::enumeration().expect("plain data").into();
    let lines: js_sys::Array = get(&tables, "assemblies").unchecked_into();
    assert_eq!(get(&lines.get(0), "total").as_f64(), Some(487_990_859.0));
    assert_eq!(wasm_study::chain_by_index(4.0, 0.0).as_deref(), Some("RR"));
    assert_eq!(wasm_study::chain_by_index(4.0, 6.0), None);
    assert_eq!(wasm_study::chain_by_index(4.0, 0.5), None);
    assert_eq!(
        wasm_study::assembly_by_index(5.0, 487_990_858.0).map(|chains| chains.is_empty()),
        Some(false)
    );
    assert_eq!(wasm_study::assembly_by_index(5.0, 487_990_859.0), None);
    for none in [-1.0, 1.5, 4_294_967_300.0, f64::NAN] {
        assert_eq!(wasm_study::chain_by_index(none, 0.0), None);
        assert_eq!(wasm_study::chain_by_index(4.0, none), None);
        assert_eq!(wasm_study::assembly_by_index(none, 0.0), None);
        assert_eq!(wasm_study::assembly_by_index(5.0, none), None);
    }
}

#[wasm_bindgen_test]
fn a_trace_is_both_courses_and_the_matrix() {
    let session = open(SAMPLE);
    let trace: JsValue = session.trace(60.0, &[]).expect("a frame").into();
    let minimum = get(&trace, "minimum").as_f64().expect("certified");
    for name in ["gradient", "newton"] {
        let course = get(&trace, name);
        let metric = column(&course, "metric");
        assert_eq!(column(&course, "joints").len(), 15 * metric.len());
        assert_eq!(column(&course, "rows").len(), 15 * 14 * metric.len());
        assert!((metric[metric.len() - 1] - minimum).abs() < 1e-7, "{name}");
        let joints = &column(&course, "joints")[..15];
        let matrix: JsValue = session.matrix(joints).expect("joints").into();
        assert_eq!(get(&matrix, "rows").as_f64(), Some(20.0));
        assert_eq!(get(&matrix, "columns").as_f64(), Some(23.0));
        assert_eq!(get(&matrix, "rank").as_f64(), Some(20.0));
    }
    for frame in [999.0, -1.0, 0.5] {
        let told = place(session.trace(frame, &[]));
        assert_eq!(told.as_deref(), Some("motion.frames"));
    }
    assert_eq!(place(session.matrix(&[])).as_deref(), Some("joints"));
    let told = [
        session.trace(1.0, &[f64::NAN; 15]).map(drop),
        session.matrix(&[f64::NAN; 15]).map(drop),
    ];
    assert_eq!(
        told.map(place),
        [0; 2].map(|_| Some("joints[0]".to_owned()))
    );
}

#[wasm_bindgen_test]
fn opened_once_it_answers_as_if_opened_anew() {
    let session = open(SAMPLE);
    let first: JsValue = session.plan().expect("a motion").into();
    let joints = &column(&first, "joints")[..15];
    let goal = &column(&first, "goal")[70..77];
    for _ in 0..3 {
        let again: JsValue = session.plan().expect("a motion").into();
        let anew: JsValue = open(SAMPLE).plan().expect("a motion").into();
        assert_eq!(all_of(&again), all_of(&first));
        assert_eq!(all_of(&anew), all_of(&first));
        let pulled: JsValue = session.pull(joints, goal).expect("a posture").into();
        let anew: JsValue = open(SAMPLE).pull(joints, goal).expect("a posture").into();
        assert_eq!(column(&pulled, "joints"), column(&anew, "joints"));
    }
}

#[wasm_bindgen_test]
fn portions_are_the_same_motion() {
    let mut session = open(SAMPLE);
    let whole: JsValue = session.plan().expect("a motion").into();
    assert_eq!(get(&whole, "partial").as_bool(), Some(false));
    let frames = get(&whole, "frames").as_f64().expect("a number");
    let done = |session: &Session| {
        let progress: JsValue = session.plan_progress().expect("plain data").into();
        assert_eq!(get(&progress, "frames").as_f64(), Some(frames));
        get(&progress, "done").as_f64()
    };
    assert_eq!(done(&session), Some(0.0));
    session.begin_plan();
    for portion in 1..=20 {
        // No time at all is one frame.
        assert!(session.advance_plan(0.0).expect("a portion"));
        assert_eq!(done(&session), Some(f64::from(portion)));
    }
    let some: JsValue = session.plan_so_far().expect("a motion").into();
    assert_eq!(get(&some, "partial").as_bool(), Some(true));
    assert_eq!(get(&some, "frames").as_f64(), Some(20.0));
    assert_eq!(get(&some, "goal_frames").as_f64(), Some(frames));
    assert_eq!(
        column(&some, "joints"),
        &column(&whole, "joints")[..20 * 15]
    );
    assert_eq!(column(&some, "sigma_min").len(), 20);

    // Other questions in between change nothing.
    session
        .pull(
            &column(&whole, "joints")[..15],
            &column(&whole, "goal")[..7],
        )
        .expect("a posture");
    while session.advance_plan(5.0).expect("a portion") {}
    assert!(
        !session.advance_plan(5.0).expect("a portion"),
        "nothing is left"
    );
    assert_eq!(done(&session), Some(frames));
    let portions: JsValue = session.plan_so_far().expect("a motion").into();
    assert_eq!(all_of(&portions), all_of(&whole));
    let exported = session.export_motion("csv", "").expect("a table");
    session.end_plan();
    assert_eq!(done(&session), Some(0.0));
    assert_eq!(session.export_motion("csv", "").expect("a table"), exported);
    assert_eq!(
        place(session.export_motion("xls", "")).as_deref(),
        Some("format")
    );
    let none: JsValue = session.plan_so_far().expect("a motion").into();
    assert_eq!(get(&none, "frames").as_f64(), Some(0.0));
}
