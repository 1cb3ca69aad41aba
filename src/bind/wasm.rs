//! The bindings to JavaScript: a session is opened with a document's text and asked many times; copied columns and
//! small objects come out. No arithmetic. What a page asks by itself, without input, and no more: see wasm_study.

#[cfg(feature = "study")]
use crate::bind::searches::Searches;
#[cfg(feature = "study")]
use crate::document::comparison::Comparison;
use crate::document::fault::Fault;
use crate::document::problem::Problem;
use crate::document::report::Report;
use crate::motion::columns::{COLUMNS, Column, Kind, place};
use crate::motion::trajectory::Trajectory;
use crate::plan::planning::Planning;
use crate::source::session;
use js_sys::{Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// Smaller than that of the standard library by 6 kB.
#[cfg(not(feature = "study"))]
#[global_allocator]
static ALLOCATOR: rlsf::SmallGlobalTlsf = rlsf::SmallGlobalTlsf::new();

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("wasm.d.ts");

#[wasm_bindgen]
extern "C" {
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Motion")]
    pub type JsMotion;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Progress")]
    pub type JsProgress;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Insight")]
    pub type JsInsight;
}

/// Reports panics, which are our own defects, to the console before the instance is lost.
#[wasm_bindgen(start)]
pub fn start() {
    std::panic::set_hook(Box::new(|info| {
        web_sys::console::error_1(&info.to_string().into());
    }));
}

/// An open document: `free()` it when nothing more is asked.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Session {
    pub(crate) open: session::Session,
    pub(crate) portions: Portions,
    /// What the plan in portions has taken so far.
    milliseconds: f64,
    /// The plans with either metric, while they are made.
    #[cfg(feature = "study")]
    pub(crate) comparison: Option<Box<Comparison>>,
    #[cfg(feature = "study")]
    pub(crate) searches: Searches,
}

/// A plan in portions.
#[derive(Debug)]
pub(crate) enum Portions {
    None,
    Running(Box<Planning>),
    Done(Box<Trajectory>),
}

#[wasm_bindgen]
impl Session {
    /// Opens a document from its text.
    ///
    /// # Errors
    /// A `Fault` where the document is at fault.
    pub fn open(text: &str) -> Result<Session, JsValue> {
        Ok(Self {
            open: session::Session::open(text).map_err(|fault| refusal(&fault))?,
            portions: Portions::None,
            milliseconds: 0.0,
            #[cfg(feature = "study")]
            comparison: None,
            #[cfg(feature = "study")]
            searches: Searches::default(),
        })
    }

    /// The document with every default written out, as an object: the text of one whose numbers have 15 digits at most.
    ///
    /// # Errors
    /// Never for a reason of the caller's.
    #[cfg(not(feature = "study"))]
    pub fn document(&self) -> Result<JsValue, JsValue> {
        to_js(self.open.document())
    }

    /// Plans the motion in one go.
    ///
    /// # Errors
    /// `null` where the package that a page loads first leaves the motion to the whole one.
    pub fn plan(&self) -> Result<JsMotion, JsValue> {
        let clock = Clock::new();
        let began = clock.now();
        let mut planning = self.open.planning();
        while go_on(&mut planning)? {}
        self.motion(&planning.finish(), clock.now() - began)
    }

    /// Begins a plan in portions, in place of one that was begun before. The start is searched for here.
    pub fn begin_plan(&mut self) {
        let clock = Clock::new();
        let began = clock.now();
        self.portions = Portions::Running(Box::new(self.open.planning()));
        self.milliseconds = clock.now() - began;
    }

    /// Plans frame by frame until that time is used up, one frame where there is no clock, and begins the plan where
    /// none is. True while there is more to do.
    ///
    /// # Errors
    /// `null` where the package that a page loads first leaves the motion to the whole one.
    pub fn advance_plan(&mut self, milliseconds: f64) -> Result<bool, JsValue> {
        if matches!(self.portions, Portions::None) {
            self.begin_plan();
        }
        let clock = Clock::new();
        let began = clock.now();
        let mut more = false;
        if let Portions::Running(planning) = &mut self.portions {
            more = go_on(planning)?;
            while more && clock.is_there() && clock.now() - began < milliseconds {
                more = go_on(planning)?;
            }
        }
        if !more {
            self.portions = match std::mem::replace(&mut self.portions, Portions::None) {
                Portions::Running(planning) => Portions::Done(Box::new(planning.finish())),
                other @ (Portions::None | Portions::Done(_)) => other,
            };
        }
        self.milliseconds += clock.now() - began;
        Ok(more)
    }

    /// How far the plan in portions is.
    ///
    /// # Errors
    /// Never for a reason of the caller's.
    pub fn plan_progress(&self) -> Result<JsProgress, JsValue> {
        let progress = Object::new();
        let set = |name: &str, value: usize| {
            Reflect::set(&progress, &name.into(), &value.into()).map(drop)
        };
        set(
            "done",
            match &self.portions {
                Portions::None => 0,
                Portions::Running(planning) => planning.done(),
                Portions::Done(trajectory) => trajectory.frames(),
            },
        )?;
        set("frames", self.open.problem().frames())?;
        Ok(progress.unchecked_into())
    }

    /// The frames of the plan in portions as a motion, which is partial until there is nothing more to do. One without
    /// frames where no plan is begun.
    ///
    /// # Errors
    /// Never for a reason of the caller's.
    pub fn plan_so_far(&self) -> Result<JsMotion, JsValue> {
        match &self.portions {
            Portions::None => self.motion(&self.open.planning().so_far(), 0.0),
            Portions::Running(planning) => self.motion(&planning.so_far(), self.milliseconds),
            Portions::Done(trajectory) => self.motion(trajectory, self.milliseconds),
        }
    }

    /// What holds the workpiece at the joint values `joints` against the pull of `goal` (7 numbers).
    ///
    /// # Errors
    /// A `Fault` where the joint values or the goal are at fault, or the loops are open.
    pub fn explain(&self, joints: &[f64], goal: &[f64]) -> Result<JsInsight, JsValue> {
        let insight = self.open.explain(joints, goal);
        to_js(&insight.map_err(|fault| refusal(&fault))?).map(JsCast::unchecked_into)
    }

    pub(crate) fn motion(&self, t: &Trajectory, milliseconds: f64) -> Result<JsMotion, JsValue> {
        let motion = motion(self.open.problem(), t, milliseconds)?;
        #[cfg(feature = "study")]
        self.tell_typed(&motion)?;
        Ok(motion.unchecked_into())
    }

    /// The plan in portions, where it is complete.
    #[cfg(feature = "study")]
    pub(crate) fn planned(&self) -> Option<&Trajectory> {
        match &self.portions {
            Portions::Done(trajectory) => Some(trajectory),
            Portions::None | Portions::Running(_) => None,
        }
    }
}

fn motion(problem: &Problem, t: &Trajectory, milliseconds: f64) -> Result<Object, JsValue> {
    let motion = Object::new();
    let set = |name: &str, value: &JsValue| Reflect::set(&motion, &name.into(), value).map(drop);
    set("frames", &t.frames().into())?;
    let frames_in_all = problem.frames();
    set("partial", &(t.frames() < frames_in_all).into())?;
    set("goal_frames", &frames_in_all.into())?;
    let report = Report::new(&problem.mechanism, &problem.length_unit, t);
    set("report", &to_js(&report)?)?;
    set("milliseconds", &milliseconds.into())?;
    for column in &COLUMNS {
        set(column.name, &typed(column, t))?;
    }
    set("rows", &rows(problem, t).into())?;
    Ok(motion)
}

/// The frames of all rows, some at a time into the array that leaves: with 100,000 frames they are 200 MB, and the memory
/// of wasm never shrinks.
pub(crate) fn rows(problem: &Problem, t: &Trajectory) -> Float64Array {
    /// Frames at a time: of fewer a copy takes longer to call than to make.
    const AT_A_TIME: usize = 256;
    let index = |number: usize| u32::try_from(number).unwrap_or(u32::MAX);
    let mut numbers = Vec::new();
    let mut all = Float64Array::new_with_length(0);
    let mut written = 0;
    for frame in 0..t.frames() {
        place(&problem.frames_at(t.joints_at(frame)), &mut numbers);
        let more = t.frames() - frame - 1;
        if more == 0 && written == 0 {
            return Float64Array::from(&numbers[..]);
        }
        if more == 0 || (frame + 1).is_multiple_of(AT_A_TIME) {
            if written == 0 {
                let of_frame = numbers.len() / (frame + 1);
                all = Float64Array::new_with_length(index(of_frame * t.frames()));
            }
            let end = written + numbers.len();
            all.subarray(index(written), index(end)).copy_from(&numbers);
            written = end;
            numbers.clear();
        }
    }
    all
}

/// A column as the typed array that its kind has in wasm.d.ts.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "codes and counts are whole numbers in the range of u8 and u32"
)]
fn typed(column: &Column, t: &Trajectory) -> JsValue {
    let values = (column.values)(t);
    match column.kind {
        Kind::Status => {
            let codes: Vec<u8> = values.iter().map(|&code| code as u8).collect();
            Uint8Array::from(&codes[..]).into()
        }
        Kind::Count => {
            let counts: Vec<u32> = values.iter().map(|&count| count as u32).collect();
            Uint32Array::from(&counts[..]).into()
        }
        Kind::Time | Kind::Length | Kind::Angle | Kind::Number | Kind::Pose | Kind::Joints => {
            Float64Array::from(&values[..]).into()
        }
    }
}

/// What is thrown for a fault: the `Fault`; null where it has no words.
#[cfg(feature = "study")]
pub(crate) fn refusal(fault: &Fault) -> JsValue {
    to_js(fault).unwrap_or_else(|error| error)
}

#[cfg(not(feature = "study"))]
fn refusal(_fault: &Fault) -> JsValue {
    JsValue::NULL
}

/// The next frame; true while there are more.
fn go_on(planning: &mut Planning) -> Result<bool, JsValue> {
    let more = planning.advance();
    #[cfg(not(feature = "study"))]
    if planning.is_for_whole() {
        return Err(JsValue::NULL);
    }
    Ok(more)
}

/// Small plain data as an object, without a way through text.
pub(crate) fn to_js(value: &impl Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(JsValue::from)
}

/// The page's, the worker's or the program's clock.
pub(crate) struct Clock(Option<web_sys::Performance>);

impl Clock {
    pub(crate) fn new() -> Self {
        let clock = Reflect::get(&js_sys::global(), &"performance".into());
        Self(clock.ok().and_then(|clock| clock.dyn_into().ok()))
    }

    pub(crate) fn is_there(&self) -> bool {
        self.0.is_some()
    }

    /// Milliseconds; 0 where there is no clock.
    pub(crate) fn now(&self) -> f64 {
        self.0.as_ref().map_or(0.0, web_sys::Performance::now)
    }
}
