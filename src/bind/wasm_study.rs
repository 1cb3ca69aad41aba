//! The bindings that a page asks for only now and then: a joint driven by hand, the planners' iterations, exports,
//! tables of types, linkages of a type, the schema. The package that a page loads first is built without them (feature `study`).

use crate::bind::wasm::{self, JsPosture, index, placed, problem, refusal, to_js};
use crate::document::example_document;
use crate::document::problem::Problem;
use crate::document::schema::SCHEMA;
use crate::document::text;
use crate::exchange::export::{self, Format};
use crate::math::pose::Pose;
use crate::solve::gradient::Arrival;
use crate::study::iterations::History;
use crate::types::{enumerate, tables};
use js_sys::{Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Trace")]
    pub type JsTrace;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Matrix")]
    pub type JsMatrix;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Enumeration")]
    pub type JsEnumeration;
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
    wasm::posture(&problem, &posture).map(JsCast::unchecked_into)
}

/// The iterations of both planners at one frame, from the joint values `joints` of the frame before;
/// from the document's start if there are none.
///
/// # Errors
/// A `Fault` where the document, the frame or the joint values are at fault.
#[wasm_bindgen]
pub fn trace(text: &str, frame: f64, joints: &[f64]) -> Result<JsTrace, JsValue> {
    let problem = problem(text)?;
    // No index is no frame.
    let frame = index(frame).and_then(|k| usize::try_from(k).ok());
    let trace = problem
        .trace(frame.unwrap_or(usize::MAX), joints)
        .map_err(|fault| refusal(&fault))?;
    let object = Object::new();
    let set = |name: &str, value: &JsValue| Reflect::set(&object, &name.into(), value).map(drop);
    set("goal", &Float64Array::from(&placed([&trace.goal])[..]))?;
    set("minimum", &trace.minimum.into())?;
    set("gradient", &history(&problem, &trace.gradient)?.into())?;
    set("newton", &history(&problem, &trace.newton)?.into())?;
    Ok(object.unchecked_into())
}

/// \[A\] of Eq. 21 at the joint values `joints`, with its singular values.
///
/// # Errors
/// A `Fault` where the document or the joint values are at fault.
#[wasm_bindgen]
pub fn matrix(text: &str, joints: &[f64]) -> Result<JsMatrix, JsValue> {
    let matrix = problem(text)?
        .matrix(joints)
        .map_err(|fault| refusal(&fault))?;
    to_js(&matrix).map(JsCast::unchecked_into)
}

/// The planned motion as text for other programs: `csv`, `json` or `mjcf`.
///
/// # Errors
/// A `Fault` where the document is at fault, or where there is no such format.
#[wasm_bindgen]
pub fn export_motion(text: &str, format: &str) -> Result<String, JsValue> {
    let written = Format::named(format).and_then(|format| {
        let document = text::parse(text)?;
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

/// A document with a linkage of this type, such as 3RPS or RPS+2TS, closed at its start.
///
/// # Errors
/// A `Fault` where the text is no type.
#[wasm_bindgen]
pub fn assemble(kinds: &str) -> Result<String, JsValue> {
    let document = example_document::example(kinds).map_err(|fault| refusal(&fault))?;
    Ok(document.text())
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
    to_js(&tables::tables()).map(JsCast::unchecked_into)
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

fn history(problem: &Problem, history: &History) -> Result<Object, JsValue> {
    let object = Object::new();
    let set = |name: &str, value: &JsValue| Reflect::set(&object, &name.into(), value).map(drop);
    let numbers = |name, values: &[f64]| set(name, &Float64Array::from(values));
    let rows: Vec<Pose> = history
        .joints
        .iter()
        .flat_map(|joints| problem.frames_at(joints))
        .collect();
    let arrivals =
        |part: fn(&Arrival) -> f64| history.arrivals.iter().map(part).collect::<Vec<_>>();
    set("iteration", &Uint32Array::from(&history.iteration[..]))?;
    numbers("joints", &history.joints.concat())?;
    numbers("pose", &placed(&history.poses))?;
    numbers("rows", &placed(&rows))?;
    numbers("metric", &history.metric)?;
    numbers("projected_gradient", &history.projected_gradient)?;
    numbers("closure", &history.closure_error)?;
    numbers("sigma_min", &history.sigma_min)?;
    numbers("share", &arrivals(|a| a.share))?;
    numbers("opening", &arrivals(|a| a.opening))?;
    numbers("corrections", &arrivals(|a| a.corrections as f64))?;
    numbers("correction", &arrivals(|a| a.correction))?;
    let guarded: Vec<u8> = history.guarded.iter().map(|g| u8::from(*g)).collect();
    set("guarded", &Uint8Array::from(&guarded[..]))?;
    set("last", &history.last.into())?;
    set("converged", &history.converged.into())?;
    Ok(object)
}
