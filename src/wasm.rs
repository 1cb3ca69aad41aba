//! The bindings to JavaScript: text in, copied columns and small objects out, no arithmetic.

use crate::defaults;
use crate::document::SCHEMA;
use crate::enumerate;
use crate::export::{self, Format};
use crate::fault::Fault;
use crate::gradient::Arrival;
use crate::json;
use crate::pose::Pose;
use crate::posture::Posture;
use crate::problem::Problem;
use crate::report::Report;
use crate::trace::{self, Course};
use crate::trajectory::Trajectory;
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
    #[wasm_bindgen(typescript_type = "Trace")]
    pub type JsTrace;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Matrix")]
    pub type JsMatrix;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Defaults")]
    pub type JsDefaults;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Enumeration")]
    pub type JsEnumeration;
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

/// One joint variable, counted through all chains, driven to `value` (rad or length) from the joint
/// values `joints`.
///
/// # Errors
/// A `Fault` where the document, the joint values, the variable or the value are at fault.
#[wasm_bindgen]
pub fn drive(text: &str, joints: &[f64], variable: f64, value: f64) -> Result<JsPosture, JsValue> {
    let problem = problem(text)?;
    // No index is no variable.
    let variable = index(variable).and_then(|k| usize::try_from(k).ok());
    let posture = problem
        .drive(joints, variable.unwrap_or(usize::MAX), value)
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

/// The iterations of both planners at one frame, from the joint values `joints` of the frame before;
/// from the document's start if there are none.
///
/// # Errors
/// A `Fault` where the document, the frame or the joint values are at fault.
#[wasm_bindgen]
pub fn trace(text: &str, frame: usize, joints: &[f64]) -> Result<JsTrace, JsValue> {
    let problem = problem(text)?;
    let trace = trace::trace(&problem, frame, joints).map_err(|fault| refusal(&fault))?;
    let object = Object::new();
    let set = |name: &str, value: &JsValue| Reflect::set(&object, &name.into(), value).map(drop);
    set("goal", &Float64Array::from(&placed([&trace.goal])[..]))?;
    set("minimum", &trace.minimum.into())?;
    set("gradient", &course(&problem, &trace.gradient)?.into())?;
    set("newton", &course(&problem, &trace.newton)?.into())?;
    Ok(object.unchecked_into())
}

/// \[A\] of Eq. 21 at the joint values `joints`, with its singular values.
///
/// # Errors
/// A `Fault` where the document or the joint values are at fault.
#[wasm_bindgen]
pub fn matrix(text: &str, joints: &[f64]) -> Result<JsMatrix, JsValue> {
    let matrix = trace::matrix(&problem(text)?, joints).map_err(|fault| refusal(&fault))?;
    to_js(&matrix).map(JsCast::unchecked_into)
}

/// The document with every default written out.
///
/// # Errors
/// A `Fault` where the document is at fault.
#[wasm_bindgen]
pub fn normalise(text: &str) -> Result<String, JsValue> {
    let document = json::parse(text).map_err(|fault| refusal(&fault))?;
    Problem::new(&document).map_err(|fault| refusal(&fault))?;
    Ok(document.text())
}

/// The document with the start that the planner uses written into it.
///
/// # Errors
/// A `Fault` where the document is at fault.
#[wasm_bindgen]
pub fn find_start(text: &str) -> Result<String, JsValue> {
    let mut document = json::parse(text).map_err(|fault| refusal(&fault))?;
    let problem = Problem::new(&document).map_err(|fault| refusal(&fault))?;
    document.set_start(&problem.mechanism, &problem.find_start());
    Ok(document.text())
}

/// The planned motion as text for other programs: `csv`, `json` or `mjcf`.
///
/// # Errors
/// A `Fault` where the document is at fault, or where there is no such format.
#[wasm_bindgen]
pub fn export_motion(text: &str, format: &str) -> Result<String, JsValue> {
    let written = Format::named(format).and_then(|format| {
        let document = json::parse(text)?;
        let problem = Problem::new(&document)?;
        let motion = problem.plan();
        Ok(export::write(
            format,
            &document,
            &problem.mechanism,
            &motion,
        ))
    });
    written.map_err(|fault| refusal(&fault))
}

/// What a page starts from: one of everything that can be added to a document.
///
/// # Errors
/// Never for a reason of the caller's.
#[wasm_bindgen]
pub fn defaults() -> Result<JsDefaults, JsValue> {
    to_js(&defaults::defaults()).map(JsCast::unchecked_into)
}

/// The JSON Schema of a document.
#[wasm_bindgen]
pub fn schema() -> String {
    SCHEMA.to_owned()
}

/// Chain classes (Table 2) and assembly categories (Table 3) with their counts.
///
/// # Errors
/// Never for a reason of the caller's.
#[wasm_bindgen]
pub fn enumeration() -> Result<JsEnumeration, JsValue> {
    to_js(&enumerate::tables()).map(JsCast::unchecked_into)
}

/// The k-th chain with this degree of constraint, such as RPS; undefined if there is none.
#[wasm_bindgen]
pub fn chain_by_index(constraints: usize, k: f64) -> Option<String> {
    enumerate::chain(constraints, index(k)?).map(|kinds| enumerate::letters(&kinds))
}

/// The k-th assembly with this total degree of constraint, as chain names; undefined if there is none.
#[wasm_bindgen]
pub fn assembly_by_index(constraints: usize, k: f64) -> Option<Vec<String>> {
    let chains = enumerate::assembly(constraints, index(k)?)?;
    Some(
        chains
            .iter()
            .map(|kinds| enumerate::letters(kinds))
            .collect(),
    )
}

fn problem(text: &str) -> Result<Problem, JsValue> {
    json::parse(text)
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

fn posture(problem: &Problem, posture: &Posture) -> Result<Object, JsValue> {
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

fn course(problem: &Problem, course: &Course) -> Result<Object, JsValue> {
    let object = Object::new();
    let set = |name: &str, value: &JsValue| Reflect::set(&object, &name.into(), value).map(drop);
    let numbers = |name, values: &[f64]| set(name, &Float64Array::from(values));
    let rows: Vec<Pose> = course
        .joints
        .iter()
        .flat_map(|joints| problem.frames_at(joints))
        .collect();
    let arrivals = |part: fn(&Arrival) -> f64| course.arrivals.iter().map(part).collect::<Vec<_>>();
    set("iteration", &Uint32Array::from(&course.iteration[..]))?;
    numbers("joints", &course.joints.concat())?;
    numbers("pose", &placed(&course.poses))?;
    numbers("rows", &placed(&rows))?;
    numbers("metric", &course.metric)?;
    numbers("projected_gradient", &course.projected_gradient)?;
    numbers("closure", &course.opening)?;
    numbers("sigma_min", &course.sigma_min)?;
    numbers("share", &arrivals(|a| a.share))?;
    numbers("opening", &arrivals(|a| a.opening))?;
    numbers("corrections", &arrivals(|a| a.corrections as f64))?;
    numbers("correction", &arrivals(|a| a.correction))?;
    let guarded: Vec<u8> = course.guarded.iter().map(|g| u8::from(*g)).collect();
    set("guarded", &Uint8Array::from(&guarded[..]))?;
    set("last", &course.last.into())?;
    set("converged", &course.converged.into())?;
    Ok(object)
}

/// x y z qx qy qz qw of each pose.
fn placed<'a>(poses: impl IntoIterator<Item = &'a Pose>) -> Vec<f64> {
    let mut column = Vec::new();
    for pose in poses {
        column.extend_from_slice(pose.translation.vector.as_slice());
        column.extend_from_slice(pose.rotation.coords.as_slice());
    }
    column
}

fn refusal(fault: &Fault) -> JsValue {
    to_js(fault).unwrap_or_else(|error| error)
}

fn to_js(value: &impl Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(JsValue::from)
}

/// A whole number from JavaScript, exact up to 2⁵³.
fn index(k: f64) -> Option<u64> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "in range by the same line"
    )]
    let whole = k as u64;
    ((0.0..9_007_199_254_740_992.0).contains(&k) && k.fract() == 0.0).then_some(whole)
}

/// Milliseconds of the window's or the worker's clock; 0 where there is none.
fn now() -> f64 {
    let global = js_sys::global();
    let clock = match global.dyn_ref::<web_sys::WorkerGlobalScope>() {
        Some(worker) => worker.performance(),
        None => global
            .dyn_ref::<web_sys::Window>()
            .and_then(web_sys::Window::performance),
    };
    clock.map_or(0.0, |clock| clock.now())
}
