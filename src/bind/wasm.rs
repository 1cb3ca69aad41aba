//! The bindings to JavaScript: text in, copied columns and small objects out, no arithmetic.

use crate::document::defaults;
use crate::document::fault::Fault;
use crate::document::problem::Problem;
use crate::document::questions::Posture;
use crate::document::report::Report;
use crate::document::text;
use crate::math::pose::Pose;
use crate::motion::trajectory::Trajectory;
use js_sys::{Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use serde::Serialize;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("wasm.d.ts");

#[wasm_bindgen]
extern "C" {
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Motion")]
    pub type JsMotion;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Posture")]
    pub type JsPosture;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Insight")]
    pub type JsInsight;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Defaults")]
    pub type JsDefaults;
}

/// Reports panics, which are our own defects, to the console before the instance is lost.
#[wasm_bindgen(start)]
pub fn start() {
    std::panic::set_hook(Box::new(|info| {
        web_sys::console::error_1(&info.to_string().into());
    }));
}

/// Plans a document.
///
/// # Errors
/// A `Fault` where the document is at fault.
#[wasm_bindgen]
pub fn plan(text: &str) -> Result<JsMotion, JsValue> {
    let began = now();
    let problem = problem(text)?;
    let trajectory = problem.plan();
    let milliseconds = now() - began;
    motion(&problem, &trajectory, milliseconds).map(JsCast::unchecked_into)
}

/// The closest reachable pose to `goal` (7 numbers) from the joint values `joints`, along their branch.
///
/// # Errors
/// A `Fault` where the document, the joint values or the goal are at fault.
#[wasm_bindgen]
pub fn pull(text: &str, joints: &[f64], goal: &[f64]) -> Result<JsPosture, JsValue> {
    let problem = problem(text)?;
    let posture = problem
        .pull(joints, goal)
        .map_err(|fault| refusal(&fault))?;
    self::posture(&problem, &posture).map(JsCast::unchecked_into)
}

/// What holds the workpiece at the joint values `joints` against the pull of `goal` (7 numbers).
///
/// # Errors
/// A `Fault` where the document, the joint values or the goal are at fault, or the loops are open.
#[wasm_bindgen]
pub fn explain(text: &str, joints: &[f64], goal: &[f64]) -> Result<JsInsight, JsValue> {
    let insight = problem(text)?
        .explain(joints, goal)
        .map_err(|fault| refusal(&fault))?;
    to_js(&insight).map(JsCast::unchecked_into)
}

/// The document with every default written out.
///
/// # Errors
/// A `Fault` where the document is at fault.
#[wasm_bindgen]
pub fn normalise(text: &str) -> Result<String, JsValue> {
    let document = text::parse(text).map_err(|fault| refusal(&fault))?;
    Problem::new(&document).map_err(|fault| refusal(&fault))?;
    Ok(document.text())
}

/// The document with the start that the planner uses written into it.
///
/// # Errors
/// A `Fault` where the document is at fault.
#[wasm_bindgen]
pub fn find_start(text: &str) -> Result<String, JsValue> {
    let mut document = text::parse(text).map_err(|fault| refusal(&fault))?;
    let problem = Problem::new(&document).map_err(|fault| refusal(&fault))?;
    document.set_start(&problem.mechanism, &problem.find_start());
    Ok(document.text())
}

/// What a page starts from: one of everything that can be added to a document.
///
/// # Errors
/// Never for a reason of the caller's.
#[wasm_bindgen]
pub fn defaults() -> Result<JsDefaults, JsValue> {
    to_js(&defaults::defaults()).map(JsCast::unchecked_into)
}

pub(crate) fn problem(text: &str) -> Result<Problem, JsValue> {
    text::parse(text)
        .and_then(|document| Problem::new(&document))
        .map_err(|fault| refusal(&fault))
}

fn motion(problem: &Problem, t: &Trajectory, milliseconds: f64) -> Result<Object, JsValue> {
    let motion = Object::new();
    let set = |name: &str, value: &JsValue| Reflect::set(&motion, &name.into(), value).map(drop);
    let numbers = |values: &[f64]| Float64Array::from(values);
    set("frames", &t.frames().into())?;
    set("report", &to_js(&Report::new(&problem.mechanism, t))?)?;
    set("milliseconds", &milliseconds.into())?;
    set("time", &numbers(&t.time))?;
    set("goal", &numbers(&placed(&t.goals)))?;
    set("pose", &numbers(&placed(&t.poses)))?;
    set("joints", &numbers(&t.joints))?;
    set("rows", &numbers(&placed(&problem.row_frames(t))))?;
    set("metric", &numbers(&t.metric))?;
    set("translation_gap", &numbers(&t.translation_gap))?;
    set("rotation_gap", &numbers(&t.rotation_gap))?;
    set("closure", &numbers(&t.closure))?;
    set("sigma_min", &numbers(&t.sigma_min))?;
    set("projected_gradient", &numbers(&t.projected_gradient))?;
    set("iterations", &Uint32Array::from(&t.iterations[..]))?;
    let codes: Vec<u8> = t.status.iter().map(|s| *s as u8).collect();
    set("status", &Uint8Array::from(&codes[..]))?;
    Ok(motion)
}

pub(crate) fn posture(problem: &Problem, posture: &Posture) -> Result<Object, JsValue> {
    let object = Object::new();
    let set = |name: &str, value: &JsValue| Reflect::set(&object, &name.into(), value).map(drop);
    let numbers = |values: &[f64]| Float64Array::from(values);
    let t = &posture.frame;
    set("joints", &numbers(&t.joints))?;
    set("pose", &numbers(&placed(&t.poses)))?;
    set("rows", &numbers(&placed(&problem.row_frames(t))))?;
    set("goal", &numbers(&placed(&t.goals)))?;
    set("status", &t.status[0].name().into())?;
    set("metric", &t.metric[0].into())?;
    set("translation_gap", &t.translation_gap[0].into())?;
    set("rotation_gap", &t.rotation_gap[0].into())?;
    set("closure", &t.closure[0].into())?;
    set("sigma_min", &t.sigma_min[0].into())?;
    set("projected_gradient", &t.projected_gradient[0].into())?;
    set("iterations", &t.iterations[0].into())?;
    if let Some(value) = posture.value {
        set("value", &value.into())?;
    }
    if let Some(obstacle) = &posture.obstacle {
        set("obstacle", &obstacle.into())?;
    }
    Ok(object)
}

/// x y z qx qy qz qw of each pose.
pub(crate) fn placed<'a>(poses: impl IntoIterator<Item = &'a Pose>) -> Vec<f64> {
    let mut column = Vec::new();
    for pose in poses {
        column.extend_from_slice(pose.translation.vector.as_slice());
        column.extend_from_slice(pose.rotation.coords.as_slice());
    }
    column
}

pub(crate) fn refusal(fault: &Fault) -> JsValue {
    to_js(fault).unwrap_or_else(|error| error)
}

pub(crate) fn to_js(value: &impl Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(JsValue::from)
}

/// A whole number from JavaScript, exact up to 2⁵³.
pub(crate) fn index(k: f64) -> Option<u64> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "in range by the same line"
    )]
    let whole = k as u64;
    ((0.0..9_007_199_254_740_992.0).contains(&k) && k.fract() == 0.0).then_some(whole)
}

/// Milliseconds of the page's, the worker's or the program's clock; 0 where there is none.
fn now() -> f64 {
    Reflect::get(&js_sys::global(), &"performance".into())
        .ok()
        .and_then(|clock| clock.dyn_into::<web_sys::Performance>().ok())
        .map_or(0.0, |clock| clock.now())
}
