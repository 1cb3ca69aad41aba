//! The golden motions and a session as WebAssembly in node; tests/web.rs meets them in a browser.
#![cfg(target_arch = "wasm32")]

#[path = "common/golden.rs"]
mod golden;
#[allow(dead_code, reason = "only Newton's check is wanted")]
#[path = "common/golden_checks.rs"]
mod golden_checks;

use js_sys::{Float64Array, Reflect};
use synthetica::bind::wasm::Session;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test]
fn newton_is_as_close_as_the_reference() {
    golden_checks::newton_is_as_close_as_the_reference();
}

#[wasm_bindgen_test]
fn a_session_plans_in_portions_as_in_one_go() {
    let joints = |motion: JsValue| {
        let column = Reflect::get(&motion, &"joints".into()).expect("a column");
        column.unchecked_into::<Float64Array>().to_vec()
    };
    let sample = include_str!("../www/mechanisms/2tpr.json");
    let mut session = Session::open(sample).expect("a document");
    let whole = joints(session.plan().expect("a motion").into());
    let mut portions = 0;
    while session.advance_plan(0.0).expect("a portion") {
        portions += 1;
    }
    // The last call says that there is no more.
    assert_eq!(portions + 1, whole.len() / 8);
    let found = joints(session.plan_so_far().expect("a motion").into());
    assert_eq!(found, whole);
}
