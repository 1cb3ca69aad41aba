//! The built library in a real browser: golden motions, bindings, faults.
#![cfg(target_arch = "wasm32")]

#[path = "common/golden.rs"]
mod golden;

use js_sys::{Float64Array, Reflect};
use synthetica::bind::{wasm, wasm_study};
use synthetica::plan::follow::{Settings, plan};
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

fn refused(text: &str) -> JsValue {
    match wasm::plan(text) {
        Ok(_) => panic!("a bad document was planned"),
        Err(fault) => fault,
    }
}

#[wasm_bindgen_test]
fn golden_motions_are_met() {
    for task in golden::tasks() {
        let t = plan(
            &task.mechanism,
            &task.start,
            &task.goals,
            &Settings::default(),
        );
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
    let motion: JsValue = wasm::plan(SAMPLE).expect("a sample plans").into();
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
    let motion: JsValue = wasm::plan(SAMPLE).expect("a sample plans").into();
    let joints = &column(&motion, "joints")[..15];
    let goal = &column(&motion, "goal")[7..14];
    let pulled: JsValue = wasm::pull(SAMPLE, joints, goal).expect("a posture").into();
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

    let driven: JsValue = wasm_study::drive(SAMPLE, joints, 1.0, joints[1] + 0.1)
        .expect("a posture")
        .into();
    assert_eq!(get(&driven, "value").as_f64(), Some(joints[1] + 0.1));
    assert!(get(&driven, "obstacle").is_undefined());
    assert_eq!(column(&driven, "pose"), column(&driven, "goal"));
    let far: JsValue = wasm_study::drive(SAMPLE, joints, 1.0, -30.0)
        .expect("a posture")
        .into();
    let obstacle = get(&far, "obstacle").as_string().expect("a sentence");
    assert!(obstacle.contains("cannot close"), "{obstacle}");
    assert!(get(&far, "value").as_f64() > Some(0.0));

    let insight: JsValue = wasm::explain(SAMPLE, joints, goal)
        .expect("an insight")
        .into();
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
    let place = |fault: JsValue| get(&fault, "where").as_string();
    let pulled = wasm::pull(SAMPLE, &joints[1..], &goal).map(drop);
    assert_eq!(
        place(pulled.expect_err("too few")).as_deref(),
        Some("joints")
    );
    let driven = wasm_study::drive(SAMPLE, &joints, 0.5, 0.0).map(drop);
    assert_eq!(
        place(driven.expect_err("no index")).as_deref(),
        Some("variable")
    );
    let explained = wasm::explain(SAMPLE, &joints, &[f64::NAN; 7]).map(drop);
    assert!(place(explained.expect_err("no pose")).is_some_and(|p| p.starts_with("goal")));
}

#[wasm_bindgen_test]
fn a_fault_is_an_object_that_names_its_place() {
    let fault = refused(&SAMPLE.replacen("\"type\": \"R\"", "\"type\": \"X\"", 1));
    assert_eq!(
        get(&fault, "where").as_string().as_deref(),
        Some("chains[0].joints[0].type")
    );
    assert!(get(&fault, "message").is_string() && get(&fault, "accepted").is_string());
}

#[wasm_bindgen_test]
fn documents_come_back_whole() {
    let whole = wasm::normalise(SAMPLE).expect("a sample is a document");
    assert_eq!(wasm::normalise(&whole).expect("its own output"), whole);
    let started = wasm::find_start(&whole).expect("a sample has a start");
    assert!(started.contains("\"start\""));
    let defaults: JsValue = wasm::defaults().expect("plain data").into();
    let text = get(&defaults, "document").as_string().expect("text");
    assert!(wasm::plan(&text).is_ok(), "the default document plans");
    assert!(wasm_study::schema().contains("$schema"));
}

#[wasm_bindgen_test]
fn enumeration_is_that_of_the_paper() {
    let tables: JsValue = wasm_study::enumeration().expect("plain data").into();
    let lines: js_sys::Array = get(&tables, "assemblies").unchecked_into();
    assert_eq!(get(&lines.get(0), "total").as_f64(), Some(487_990_859.0));
    assert_eq!(wasm_study::chain_by_index(4, 0.0).as_deref(), Some("RR"));
    assert_eq!(wasm_study::chain_by_index(4, 6.0), None);
    assert_eq!(wasm_study::chain_by_index(4, 0.5), None);
    assert_eq!(
        wasm_study::assembly_by_index(5, 487_990_858.0).map(|chains| chains.is_empty()),
        Some(false)
    );
    assert_eq!(wasm_study::assembly_by_index(5, 487_990_859.0), None);
}

#[wasm_bindgen_test]
fn a_trace_is_both_courses_and_the_matrix() {
    let trace: JsValue = wasm_study::trace(SAMPLE, 60, &[]).expect("a frame").into();
    let minimum = get(&trace, "minimum").as_f64().expect("certified");
    for name in ["gradient", "newton"] {
        let course = get(&trace, name);
        let metric = column(&course, "metric");
        assert_eq!(column(&course, "joints").len(), 15 * metric.len());
        assert_eq!(column(&course, "rows").len(), 15 * 14 * metric.len());
        assert!((metric[metric.len() - 1] - minimum).abs() < 1e-7, "{name}");
        let joints = &column(&course, "joints")[..15];
        let matrix: JsValue = wasm_study::matrix(SAMPLE, joints).expect("joints").into();
        assert_eq!(get(&matrix, "rows").as_f64(), Some(20.0));
        assert_eq!(get(&matrix, "columns").as_f64(), Some(23.0));
        assert_eq!(get(&matrix, "rank").as_f64(), Some(20.0));
    }
    let fault = wasm_study::trace(SAMPLE, 999, &[])
        .map(drop)
        .expect_err("none");
    assert_eq!(
        get(&fault, "where").as_string().as_deref(),
        Some("motion.frames")
    );
}
