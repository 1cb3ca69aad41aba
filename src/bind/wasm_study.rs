//! The bindings that a page asks for only when a person does something: the linkage pulled or driven by hand, the planners'
//! iterations, exports, tables of types, linkages of a type, the schema. The package that a page loads first is built
//! without them (feature `study`).

use crate::bind::wasm::{Clock, Portions, Session, refusal, rows, to_js};
use crate::document::defaults;
use crate::document::fault::Fault;
use crate::document::make;
use crate::document::problem::Problem;
use crate::document::questions::Posture;
use crate::document::schema::SCHEMA;
use crate::document::text::{self};
use crate::document::warnings::{WarningReport, warning};
use crate::exchange::export::{self, Format, Options};
use crate::exchange::pose_table::read_pose_table_asked;
use crate::makers::from_type;
use crate::makers::list;
use crate::math::pose::Pose;
use crate::motion::columns::{COLUMNS, Kind, placed};
use crate::motion::trajectory::Warning;
use crate::solve::gradient::Arrival;
use crate::source::session::{self, index};
use crate::study::iterations::History;
use crate::types::{enumerate, tables};
use js_sys::{Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Defaults")]
    pub type JsDefaults;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Posture")]
    pub type JsPosture;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Trace")]
    pub type JsTrace;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Matrix")]
    pub type JsMatrix;
    /// Types of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "[MetricGaps, MetricGaps]")]
    pub type JsMetricGapsList;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Enumeration")]
    pub type JsEnumeration;
    /// Types of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Report['warnings']")]
    pub type JsWarnings;
    /// Types of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Maker[]")]
    pub type JsMakerList;
}

#[wasm_bindgen]
impl Session {
    /// The document with every default written out.
    pub fn text(&self) -> String {
        self.open.text()
    }

    /// The document with the start that the planner uses written into it.
    pub fn find_start(&self) -> String {
        self.open.text_with_start()
    }

    /// Forgets the plan in portions.
    pub fn end_plan(&mut self) {
        self.portions = Portions::None;
    }

    /// The closest reachable pose to `goal` (7 numbers) from the joint values `joints`, along their branch.
    ///
    /// # Errors
    /// A `Fault` where the joint values or the goal are at fault.
    pub fn pull(&self, joints: &[f64], goal: &[f64]) -> Result<JsPosture, JsValue> {
        posture(&self.open, self.open.pull(joints, goal))
    }

    /// Warnings of a motion that the package without this module planned, in words: its report's, as they stand there.
    ///
    /// # Errors
    /// Where they are none.
    pub fn in_words(&self, warnings: JsValue) -> Result<JsWarnings, JsValue> {
        let warnings: Vec<Warning> = serde_wasm_bindgen::from_value(warnings)?;
        let wording = self.open.problem().wording();
        let told: Vec<WarningReport> = warnings.iter().map(|w| warning(w, &wording)).collect();
        to_js(&told).map(JsCast::unchecked_into)
    }

    /// The document as the planner has it: numbers, degrees, rows.
    pub fn plain(&self) -> String {
        self.open.document().text()
    }

    /// Adds what a document of expressions, axes and other conventions stands for.
    pub(crate) fn tell_typed(&self, motion: &Object) -> Result<(), JsValue> {
        let typed = self.open.typed();
        if !typed.is_typed() {
            return Ok(());
        }
        let set = |name: &str, value: &JsValue| Reflect::set(motion, &name.into(), value).map(drop);
        set("plain", &js_sys::JSON::parse(&self.plain())?)?;
        set("parameters", &to_js(&typed.parameters.list())?)?;
        set("expressions", &to_js(&typed.expressions)?)
    }

    /// A chain, counted from 0, given by its axes: `{chain, home}` as JSON, in the document's unit of angles.
    ///
    /// # Errors
    /// A `Fault` where it cannot be given so.
    pub fn by_axes(&self, chain: f64) -> Result<String, JsValue> {
        let rewritten = self.open.by_axes(chain).map_err(|fault| refusal(&fault))?;
        Ok(rewritten.text())
    }

    /// Would the rows, read as a standard table, be closed at the given start, and are they not as they are read?
    pub fn looks_standard(&self) -> bool {
        let notes = &self.open.problem().notes;
        notes.contains(&Warning::StandardTable)
    }

    /// One joint variable, counted through all chains, driven to `value` (rad or length) from the joint
    /// values `joints`.
    ///
    /// # Errors
    /// A `Fault` where the joint values, the variable or the value are at fault.
    pub fn drive(&self, joints: &[f64], variable: f64, value: f64) -> Result<JsPosture, JsValue> {
        let variable = self.open.variable(variable);
        let driven = variable.and_then(|variable| self.open.drive(joints, variable, value));
        posture(&self.open, driven)
    }

    /// The iterations of both planners at one frame, from the joint values `joints` of the frame before;
    /// from the document's start if there are none.
    ///
    /// # Errors
    /// A `Fault` where the frame or the joint values are at fault.
    pub fn trace(&self, frame: f64, joints: &[f64]) -> Result<JsTrace, JsValue> {
        let problem = self.open.problem();
        let trace = self
            .open
            .frame(frame)
            .and_then(|frame| problem.trace(frame, joints));
        let trace = trace.map_err(|fault| refusal(&fault))?;
        let object = Object::new();
        let set =
            |name: &str, value: &JsValue| Reflect::set(&object, &name.into(), value).map(drop);
        set("goal", &Float64Array::from(&placed([&trace.goal])[..]))?;
        set("minimum", &trace.minimum.into())?;
        set("gradient", &history(problem, &trace.gradient)?.into())?;
        set("newton", &history(problem, &trace.newton)?.into())?;
        Ok(object.unchecked_into())
    }

    /// \[A\] of Eq. 21 at the joint values `joints`, with its singular values.
    ///
    /// # Errors
    /// A `Fault` where the joint values are at fault.
    pub fn matrix(&self, joints: &[f64]) -> Result<JsMatrix, JsValue> {
        let matrix = self.open.problem().matrix(joints);
        to_js(&matrix.map_err(|fault| refusal(&fault))?).map(JsCast::unchecked_into)
    }

    /// Plans with either metric, for `compare_metrics`, until that time is used up; one frame where there is no clock.
    /// True while there is more to do.
    pub fn advance_comparison(&mut self, milliseconds: f64) -> bool {
        let clock = Clock::new();
        let began = clock.now();
        let open = &self.open;
        let comparison = self
            .comparison
            .get_or_insert_with(|| Box::new(open.comparison()));
        let mut more = comparison.advance();
        while more && clock.is_there() && clock.now() - began < milliseconds {
            more = comparison.advance();
        }
        more
    }

    /// The largest gaps of the motion with the metric `pose` and with `dual-quaternion`; what is not planned yet is
    /// planned in one go.
    ///
    /// # Errors
    /// Never for a reason of the caller's.
    pub fn compare_metrics(&mut self) -> Result<JsMetricGapsList, JsValue> {
        let comparison = self.comparison.take();
        let comparison =
            comparison.map_or_else(|| self.open.comparison(), |comparison| *comparison);
        to_js(&comparison.finish()).map(JsCast::unchecked_into)
    }

    /// The planned motion as text for other programs: `csv`, `json` or `mjcf`, asked for by `ExportOptions` as JSON, or
    /// an empty text. A plan in portions that is complete is not made again.
    ///
    /// # Errors
    /// A `Fault` where there is no such format, or an option does not go with it.
    pub fn export_motion(&self, format: &str, options: &str) -> Result<String, JsValue> {
        let (document, mechanism) = (self.open.document(), &self.open.problem().mechanism);
        let written = || {
            let format = Format::named(format)?;
            let options = Options::read(options)?;
            options.check(format)?;
            match self.planned() {
                Some(motion) => export::write(format, options, document, mechanism, motion),
                None => export::write(format, options, document, mechanism, &self.open.plan()),
            }
        };
        written().map_err(|fault| refusal(&fault))
    }
}

/// What a page starts from: one of everything that can be added to a document.
///
/// # Errors
/// Never for a reason of the caller's.
#[wasm_bindgen]
pub fn defaults() -> Result<JsDefaults, JsValue> {
    to_js(&defaults::defaults()).map(JsCast::unchecked_into)
}

/// A document with a linkage of this type, such as 3RPS or RPS+2TS, closed at its start; or one that a maker makes, such as
/// `delta?base=400&platform=50`.
///
/// # Errors
/// A `Fault` where the text is no type and no maker; its `where` is `type` or an input of the maker.
#[wasm_bindgen]
pub fn assemble(kinds: &str) -> Result<String, JsValue> {
    from_type::from_type(kinds).map_err(|fault| refusal(&fault))
}

/// The makers that there are, with the inputs that each asks for.
///
/// # Errors
/// Never for a reason of the caller's.
#[wasm_bindgen]
pub fn makers() -> Result<JsMakerList, JsValue> {
    to_js(&list::list()).map(JsCast::unchecked_into)
}

/// A document made by the maker of this name. `inputs` is an object as JSON, of a text or a number for each input that is
/// not to have its default; lengths are in `unit`, that of the maker where there is none.
///
/// # Errors
/// A `Fault` where there is no such maker, or an input is at fault, whose name `where` is.
#[expect(
    clippy::needless_pass_by_value,
    reason = "an optional text comes by value"
)]
#[wasm_bindgen]
pub fn make_named(name: &str, inputs: &str, unit: Option<String>) -> Result<String, JsValue> {
    from_type::make_named(name, inputs, unit.as_deref()).map_err(|fault| refusal(&fault))
}

/// A document made from a type and sizes: a `MakeRequest` as JSON.
///
/// # Errors
/// A `Fault` whose `where` is a field of the request: where the type is none, a size is missing or out of range, or no
/// such linkage would move.
#[wasm_bindgen]
pub fn make(request: &str) -> Result<String, JsValue> {
    let document = make::make_from_text(request).map_err(|fault| refusal(&fault))?;
    Ok(document.text())
}

/// Key frames from the text of a table: a `PoseTable` as JSON, asked for by a `PoseTableRequest` as JSON.
///
/// # Errors
/// A `Fault` where the request does not fit or no row can be taken over.
#[wasm_bindgen]
pub fn read_poses(table: &str, request: &str) -> Result<String, JsValue> {
    let table = read_pose_table_asked(table, request).map_err(|fault| refusal(&fault))?;
    Ok(text::json(&table))
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
pub fn chain_by_index(constraints: f64, k: f64) -> Option<String> {
    let constraints = usize::try_from(index(constraints)?).ok()?;
    enumerate::chain(constraints, index(k)?).map(|kinds| enumerate::letters(&kinds))
}

/// The k-th assembly with this total degree of constraint, as chain names; undefined if there is none.
#[wasm_bindgen]
pub fn assembly_by_index(constraints: f64, k: f64) -> Option<Vec<String>> {
    let constraints = usize::try_from(index(constraints)?).ok()?;
    let chains = enumerate::assembly(constraints, index(k)?)?;
    Some(
        chains
            .iter()
            .map(|kinds| enumerate::letters(kinds))
            .collect(),
    )
}

fn posture(
    session: &session::Session,
    posture: Result<Posture, Fault>,
) -> Result<JsPosture, JsValue> {
    let posture = posture.map_err(|fault| refusal(&fault))?;
    let object = Object::new();
    let set = |name: &str, value: &JsValue| Reflect::set(&object, &name.into(), value).map(drop);
    let t = &posture.frame;
    for column in &COLUMNS {
        let values = (column.values)(t);
        match column.kind {
            Kind::Status => set(column.name, &t.status[0].name().into())?,
            Kind::Pose | Kind::Joints => set(column.name, &Float64Array::from(&values[..]))?,
            Kind::Time => {}
            Kind::Length | Kind::Angle | Kind::Number | Kind::Count => {
                set(column.name, &values[0].into())?;
            }
        }
    }
    set("rows", &rows(session.problem(), t))?;
    if let Some(value) = posture.value {
        set("value", &value.into())?;
    }
    if let Some(obstacle) = &posture.obstacle {
        set("obstacle", &obstacle.into())?;
    }
    Ok(object.unchecked_into())
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
    numbers("misfit", &history.misfit)?;
    numbers("sigma_min", &history.sigma_min)?;
    numbers("share", &arrivals(|a| a.share))?;
    numbers("opening", &arrivals(|a| a.residual))?;
    numbers("corrections", &arrivals(|a| a.corrections as f64))?;
    numbers("correction", &arrivals(|a| a.correction))?;
    let guarded: Vec<u8> = history.guarded.iter().map(|g| u8::from(*g)).collect();
    set("guarded", &Uint8Array::from(&guarded[..]))?;
    set("last", &history.last.into())?;
    set("converged", &history.converged.into())?;
    Ok(object)
}
