//! The golden motions as WebAssembly in node; tests/web.rs meets them in a browser.
#![cfg(target_arch = "wasm32")]

#[path = "common/golden.rs"]
mod golden;
#[allow(dead_code, reason = "only Newton's check is wanted")]
#[path = "common/golden_checks.rs"]
mod golden_checks;

use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test]
fn newton_is_as_close_as_the_reference() {
    golden_checks::newton_is_as_close_as_the_reference();
}
