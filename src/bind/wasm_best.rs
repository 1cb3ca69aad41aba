//! The bindings of the searches that a person asks for and waits for: the best motion, its calm forms, and all ways to
//! assemble. They go on in portions, with what is found so far.

use crate::bind::wasm::{Clock, JsMotion, Session, refusal, rows, to_js};
use crate::document::best_report::{BestReport, CostReport};
use crate::document::bounds::out_of_range;
use crate::document::fault::{Fault, FaultCode, Place};
use crate::document::modes_report::ModesReport;
use crate::exchange::export::{Format, Options};
use crate::exchange::path_table;
use crate::motion::columns::placed;
use crate::motion::trajectory::Trajectory;
use crate::plan::best::Search;
use crate::plan::calm_form::{Calm, MOST_PRICE};
use crate::plan::path::path_motion;
use crate::source::session::index;
use js_sys::{Array, Float64Array, Int32Array, Object, Reflect};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Best")]
    pub type JsBest;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "BestPath")]
    pub type JsBestPath;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "CalmMotion")]
    pub type JsCalmMotion;
    /// A type of wasm.d.ts.
    #[wasm_bindgen(typescript_type = "Modes")]
    pub type JsModes;
}

#[wasm_bindgen]
impl Session {
    /// Begins the search for the best motion, in place of one begun before. A plan in portions that is complete is not made
    /// again.
    ///
    /// # Errors
    /// A `Fault` where joints are driven.
    pub fn begin_best(&mut self) -> Result<(), JsValue> {
        let problem = self.open.problem();
        problem.check_goals().map_err(|fault| refusal(&fault))?;
        let search = problem.best(self.followed());
        self.searches.best = Some(Box::new(search.map_err(|fault| refusal(&fault))?));
        Ok(())
    }

    /// Searches until that time is used up, one start where there is no clock, and begins the search where none is. True
    /// while there is more to do.
    ///
    /// # Errors
    /// A `Fault` where joints are driven.
    pub fn advance_best(&mut self, milliseconds: f64) -> Result<bool, JsValue> {
        self.ensure_best()?;
        let search = self.searches.best.as_mut();
        Ok(search.is_some_and(|search| advance(milliseconds, || search.advance())))
    }

    /// What the search for the best motion found so far.
    ///
    /// # Errors
    /// A `Fault` where joints are driven.
    pub fn best(&mut self) -> Result<JsBest, JsValue> {
        self.ensure_best()?;
        let mut report = BestReport::new(self.search());
        // Long lists are copied as they are.
        let metrics: Vec<_> = (report.branches.iter_mut())
            .map(|branch| std::mem::take(&mut branch.metric))
            .collect();
        let object = to_js(&report)?;
        typed(&object, "lane", |array| Int32Array::new(array).into())?;
        let branches = Array::from(&Reflect::get(&object, &"branches".into())?);
        for (branch, metric) in branches.iter().zip(&metrics) {
            typed(&branch, "metric", |_| {
                Float64Array::from(&metric[..]).into()
            })?;
        }
        Ok(object.unchecked_into())
    }

    /// The best motion found so far, one frame a goal: the followed one until branches are known.
    ///
    /// # Errors
    /// A `Fault` where joints are driven.
    pub fn best_motion(&mut self) -> Result<JsMotion, JsValue> {
        self.ensure_best()?;
        let search = self.search();
        let found = search.found().map(|found| &found.motion);
        self.motion(found.unwrap_or_else(|| search.followed()), 0.0)
    }

    /// All points of the best motion found so far, in order.
    ///
    /// # Errors
    /// A `Fault` where joints are driven.
    pub fn best_path(&mut self) -> Result<JsBestPath, JsValue> {
        self.ensure_best()?;
        let (search, problem) = (self.search(), self.open.problem());
        let path = search.found().map(|found| {
            let (goals, settings) = (&problem.goals, &problem.settings);
            let frames = found.path.iter().map(|point| point.frame);
            let frames: Vec<i32> = frames.map(number).collect();
            let motion = path_motion(&problem.mechanism, goals, settings, found);
            (motion, frames)
        });
        let (motion, frames) = path.unwrap_or_else(|| {
            let followed = search.followed();
            let frames = (0..followed.frames()).map(|i| number(Some(i))).collect();
            (followed.clone(), frames)
        });
        let object = Object::new();
        let set =
            |name: &str, value: &JsValue| Reflect::set(&object, &name.into(), value).map(drop);
        let numbers = |name, values: &[f64]| set(name, &Float64Array::from(values));
        set("points", &motion.frames().into())?;
        set("frame", &Int32Array::from(&frames[..]))?;
        numbers("time", &motion.time)?;
        numbers("metric", &motion.metric)?;
        numbers("closure", &motion.closure)?;
        numbers("joints", &motion.joints)?;
        numbers("pose", &placed(&motion.poses))?;
        set("rows", &rows(problem, &motion))?;
        Ok(object.unchecked_into())
    }

    /// The calm form of the best motion at a price of joint motion. The search is completed first.
    ///
    /// # Errors
    /// A `Fault` where joints are driven, or the price is no number from 0 to 1.
    pub fn calm_motion(&mut self, price: f64) -> Result<JsCalmMotion, JsValue> {
        let Some(calm) = self.calm_form(price)? else {
            // The loops do not close: there is nothing to make calm.
            let search = self.search();
            return self.calm(search.followed(), search.followed_cost().into());
        };
        self.calm(&calm.motion, calm.cost.into())
    }

    /// The best motion found so far as `export_motion` writes a motion, or its calm form at a price, for which the search is
    /// completed first. As CSV and JSON the best motion has all points of its closed path.
    ///
    /// # Errors
    /// A `Fault` where there is no such format, an option does not go with it, joints are driven, or the price is no number
    /// from 0 to 1.
    pub fn export_best(
        &mut self,
        format: &str,
        options: &str,
        price: Option<f64>,
    ) -> Result<String, JsValue> {
        let asked = || {
            let (format, options) = (Format::named(format)?, Options::read(options)?);
            options.check(format)?;
            Ok((format, options))
        };
        let (format, options) = asked().map_err(|fault: Fault| refusal(&fault))?;
        let calm = match price {
            Some(price) => self.calm_form(price)?,
            None => self.ensure_best().map(|()| None)?,
        };
        let (search, problem) = (self.search(), self.open.problem());
        let document = self.open.document();
        path_table::write(format, options, document, problem, search, calm.as_ref())
            .map_err(|fault| refusal(&fault))
    }

    /// Begins the search for all ways to assemble at a key frame, counted from 0, in place of one begun before.
    ///
    /// # Errors
    /// A `Fault` where there is no such key frame, or joints are driven.
    pub fn begin_modes(&mut self, key: f64) -> Result<(), JsValue> {
        let problem = self.open.problem();
        let motion = &self.open.document().motion;
        problem.check_goals().map_err(|fault| refusal(&fault))?;
        const MOTION: Place<'static> = Place::WHOLE.field("motion");
        let key = entry(key, motion.key_frames.len(), &MOTION.field("key_frames"))?;
        let at = problem
            .key_at(motion, key)
            .map_err(|fault| refusal(&fault))?;
        let search = problem.modes(at, &self.followed());
        self.searches.modes = Some((at, Box::new(search)));
        Ok(())
    }

    /// Searches, and then plans from each way, until that time is used up. True while there is more to do.
    pub fn advance_modes(&mut self, milliseconds: f64) -> bool {
        let search = self.searches.modes.as_mut();
        search.is_some_and(|(_, search)| advance(milliseconds, || search.advance()))
    }

    /// The ways to assemble found so far.
    ///
    /// # Errors
    /// A `Fault` where no search was begun.
    pub fn modes(&self) -> Result<JsModes, JsValue> {
        let Some((at, search)) = &self.searches.modes else {
            return Err(refusal(&no_search()));
        };
        let object = to_js(&ModesReport::new(self.open.problem(), *at, search))?;
        for mode in Array::from(&Reflect::get(&object, &"found".into())?).iter() {
            for name in ["joints", "rows", "pose"] {
                typed(&mode, name, |array| Float64Array::new(array).into())?;
            }
        }
        Ok(object.unchecked_into())
    }

    /// The document's text with a way to assemble as its start, counted from 0 as in `modes`.
    ///
    /// # Errors
    /// A `Fault` where there is no such way.
    pub fn text_with_mode(&self, number: f64) -> Result<String, JsValue> {
        let Some((_, search)) = &self.searches.modes else {
            return Err(refusal(&no_search()));
        };
        let modes = search.modes();
        let number = entry(number, modes.len(), &Place::WHOLE.field("index"))?;
        Ok(self.open.text_started_at(&modes[number].joints))
    }
}

impl Session {
    /// Begins the search where none is.
    fn ensure_best(&mut self) -> Result<(), JsValue> {
        match self.searches.best {
            Some(_) => Ok(()),
            None => self.begin_best(),
        }
    }

    /// The calm form at a price, once the search is complete; none where the loops do not close.
    fn calm_form(&mut self, price: f64) -> Result<Option<Calm>, JsValue> {
        if !(0.0..=MOST_PRICE).contains(&price) {
            const PRICE: Place<'static> = Place::WHOLE.field("price");
            let fault = out_of_range(&PRICE, price, "a number from 0 to 1");
            return Err(refusal(&fault));
        }
        self.ensure_best()?;
        let search = self.searches.best.as_mut();
        Ok(search.and_then(|search| {
            search.finish();
            search.calm(price)
        }))
    }

    /// The search, once it is begun.
    fn search(&self) -> &Search {
        self.searches.best.as_ref().expect("begun")
    }

    /// The motion that the planner follows.
    fn followed(&self) -> Trajectory {
        self.planned().cloned().unwrap_or_else(|| self.open.plan())
    }

    fn calm(&self, motion: &Trajectory, cost: CostReport) -> Result<JsCalmMotion, JsValue> {
        let object = to_js(&cost)?;
        Reflect::set(&object, &"motion".into(), &self.motion(motion, 0.0)?.into())?;
        Ok(object.unchecked_into())
    }
}

fn no_search() -> Fault {
    const MODES: Place<'static> = Place::WHOLE.field("modes");
    let accepted = "what is asked after begin_modes";
    Fault::new(
        FaultCode::OutOfRange,
        &MODES,
        "no search was begun",
        accepted,
    )
}

/// The entry of a list of `count` that a number from JavaScript means.
fn entry(number: f64, count: usize, place: &Place<'_>) -> Result<usize, JsValue> {
    let entry = index(number).and_then(|entry| usize::try_from(entry).ok());
    let found = entry.filter(|entry| *entry < count);
    found.ok_or_else(|| {
        let accepted = match count {
            0 => "nothing: there is none".to_owned(),
            _ => format!("a whole number from 0 to {}", count - 1),
        };
        refusal(&out_of_range(place, number, &accepted))
    })
}

/// Goes on until that time is used up; once where there is no clock.
fn advance(milliseconds: f64, mut step: impl FnMut() -> bool) -> bool {
    let clock = Clock::new();
    let began = clock.now();
    let mut more = step();
    while more && clock.is_there() && clock.now() - began < milliseconds {
        more = step();
    }
    more
}

/// Puts a typed array in the place of an array.
fn typed(object: &JsValue, name: &str, make: impl Fn(&JsValue) -> JsValue) -> Result<(), JsValue> {
    let array = Reflect::get(object, &name.into())?;
    Reflect::set(object, &name.into(), &make(&array)).map(drop)
}

/// A frame's number; −1 between frames.
fn number(frame: Option<usize>) -> i32 {
    frame.map_or(-1, |frame| i32::try_from(frame).unwrap_or(i32::MAX))
}
