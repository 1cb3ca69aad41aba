//! The best motion: of all motions over the branches that closed walks join to the start, the one whose frames are closest
//! on average to their goals.
//!
//! What is known of it: every point of its path is closed; no motion over the branches known is closer than the mean of the
//! least f of every frame; and an estimate by Good and Turing of the starts that would lead to a branch not known.

use crate::model::mechanism::Mechanism;
use crate::model::scaled::Scaled;
use crate::motion::goal::Goal;
use crate::motion::trajectory::{Status, Trajectory};
use crate::plan::between::slots;
use crate::plan::branches::{Apart, Branches};
use crate::plan::building::Building;
use crate::plan::calm_form::{Calm, CalmForms};
use crate::plan::found::{Cost, Found};
use crate::plan::route::{Choice, Route};
use crate::plan::settings::{Settings, extent};
use crate::plan::task::Task;
use crate::plan::unseen::Unseen;

/// Starts of a round from each of the frames that [`Branches::start_slots`] names; after each round the best motion so far
/// is known.
const STARTS: usize = 8;
/// One start of so many is from anywhere.
const ANYWHERE: usize = 3;
/// Rounds that are made, and those that are made where the last one found a better motion or where more than this share of
/// the starts led to a branch that no other led to.
const ROUNDS: usize = 4;
const MOST_ROUNDS: usize = 8;
const UNSEEN: f64 = 0.01;
/// Share by which the mean must fall for a motion to be a better one.
const BETTER: f64 = 1e-3;

/// Share of the progress: the search; the rest is that of the calm forms.
const SEARCH: f64 = 0.8;

/// The search for the best motion, in portions.
#[derive(Clone, Debug)]
pub struct Search {
    task: Task,
    branches: Option<Branches>,
    route: Route,
    /// Slots from which starts are to be made in this round.
    waiting: Vec<usize>,
    /// Poses that are to be tried again at its end, the last one first.
    again: Vec<Apart>,
    /// Rounds that were begun.
    rounds: usize,
    /// The mean before the last round.
    before: f64,
    found: Option<Found>,
    /// The choice of its route, and the motion along another one so far.
    choice: Option<Choice>,
    building: Option<Building>,
    /// Once there are no more rounds.
    calm_forms: Option<CalmForms>,
    /// Share of the search that is done, 0 to 1; rounds that follow do not lower it.
    told: f64,
    done: bool,
}

impl Search {
    /// For a motion that was planned by [`plan`](crate::plan::follow::plan).
    pub fn new(
        mechanism: &Mechanism,
        goals: &[Goal],
        settings: &Settings,
        followed: Trajectory,
    ) -> Self {
        let task = Task {
            mechanism: mechanism.clone(),
            goals: goals.to_vec(),
            settings: settings.by_newton(),
            followed,
        };
        let branches = Branches::new(&task, slots(goals.len()));
        Self {
            task,
            done: branches.is_none(),
            branches,
            route: Route::default(),
            waiting: Vec::new(),
            again: Vec::new(),
            rounds: 0,
            before: f64::INFINITY,
            found: None,
            choice: None,
            building: None,
            calm_forms: None,
            told: 0.0,
        }
    }

    /// A small part of the search: one start, a slot of a motion, a step towards a calm form; false when there is nothing left.
    pub fn advance(&mut self) -> bool {
        if self.done {
            return false;
        }
        self.measure();
        let (Some(forms), Some(branches)) = (&mut self.calm_forms, &mut self.branches) else {
            self.search();
            return true;
        };
        let cost = forms.advance(&self.task, branches);
        if let (Some(cost), Some(found)) = (cost, &mut self.found) {
            // Between slots, and where a calm form leaves the branches that are known, it may be closer than all of them.
            found.lower_bound = found.lower_bound.min(cost.mean);
        }
        self.done = forms.are_complete();
        !self.done
    }

    /// One start, one look for the best route, or a slot of its motion.
    fn search(&mut self) {
        let Some(branches) = self.branches.as_mut() else {
            return;
        };
        let (route, task) = (&self.route, &self.task);
        if let Some(mut building) = self.building.take() {
            match building.advance(task, branches, route) {
                Some(true) => self.building = Some(building),
                Some(false) => {
                    let found = building.finish(task, branches, route);
                    // A route is chosen by the slots: over all frames of a long motion it may be farther than the one before.
                    match &mut self.found {
                        Some(before) if before.cost_of_frames() < found.cost_of_frames() => {
                            before.know(&task.followed, branches, route);
                        }
                        _ => self.found = Some(found),
                    }
                    self.choice = Some(route.choice());
                    self.end_round();
                }
                // A route that leaves the bounds is none: what was found before stays.
                None => self.end_round(),
            }
        } else if let Some(slot) = self.waiting.pop() {
            // Shifted from one pass over the slots to the next, so that each slot has starts of both kinds.
            let made = self.waiting.len();
            let pass = made / branches.start_slots().len();
            if (made + pass).is_multiple_of(ANYWHERE) {
                branches.start_anywhere(slot);
            } else {
                branches.start_from(slot);
            }
            if self.waiting.is_empty() {
                self.again = branches.apart_again(&route.values(branches));
            }
        } else if let Some(apart) = self.again.pop() {
            branches.try_again(&apart);
        } else if !self.route.continue_branch(branches)
            && !self.route.reach_branch(branches)
            && self.route.advance(branches)
        {
            let route = &self.route;
            match &mut self.found {
                _ if route.nodes().is_empty() => self.end_round(),
                Some(found) if self.choice.as_ref() == Some(&route.choice()) => {
                    found.know(&task.followed, branches, route);
                    self.end_round();
                }
                _ => self.building = Some(Building::new(task, branches)),
            }
        }
    }

    /// Begins another round, or the calm forms.
    fn end_round(&mut self) {
        if !self.begin_round() {
            let known = self.branches.as_ref().zip(self.found.as_ref());
            let forms = known.map(|(branches, found)| CalmForms::new(&self.task, branches, found));
            self.calm_forms = forms;
            self.done = self.calm_forms.is_none();
        }
    }

    /// Of each price the cost of the calm form; complete when the search is done.
    pub fn curve(&self) -> &[(f64, Cost)] {
        self.calm_forms.as_ref().map_or(&[], CalmForms::curve)
    }

    /// The calm form of what was found at a price, up to [`MOST_PRICE`](crate::plan::calm_form::MOST_PRICE); none before the
    /// search is done, or beyond.
    pub fn calm(&mut self, price: f64) -> Option<Calm> {
        let (Some(forms), Some(branches)) = (&self.calm_forms, &mut self.branches) else {
            return None;
        };
        forms.at(&self.task, branches, price)
    }

    /// Begins another round of starts; false where there have been enough.
    fn begin_round(&mut self) -> bool {
        let mean = self.found.as_ref().map_or(0.0, |found| found.cost.mean);
        let better = mean < self.before * (1.0 - BETTER);
        self.before = mean;
        let more = match self.rounds {
            // Where all goals are reached nothing is closer.
            0 => (self.task.followed.status)
                .iter()
                .any(|s| *s != Status::Reached),
            rounds if rounds < ROUNDS => true,
            rounds => rounds < MOST_ROUNDS && (better || self.unseen().share > UNSEEN),
        };
        if let Some(branches) = self.branches.as_ref().filter(|_| more) {
            let slots = branches.start_slots();
            self.waiting = std::iter::repeat_n(slots, STARTS).flatten().collect();
            self.rounds += 1;
        }
        more
    }

    /// Does all that is left; what was found, none where the loops of the followed motion do not close.
    pub fn finish(&mut self) -> Option<&Found> {
        while self.advance() {}
        self.found()
    }

    /// The best motion so far.
    pub fn found(&self) -> Option<&Found> {
        self.found.as_ref()
    }

    /// The motion that the planner follows.
    pub fn followed(&self) -> &Trajectory {
        &self.task.followed
    }

    /// How close it comes.
    pub fn followed_cost(&self) -> Cost {
        let task = &self.task;
        let scaled = Scaled::new(&task.mechanism, extent(&task.goals));
        Cost::of(&task.followed, &scaled)
    }

    /// From 0 to 1; it never falls.
    pub fn progress(&self) -> f64 {
        if self.done { 1.0 } else { self.told }
    }

    /// The share that is done, as if there were [`ROUNDS`] rounds.
    fn measure(&mut self) {
        let Some(branches) = &self.branches else {
            return;
        };
        let round = branches.start_slots().len() * STARTS;
        let made = (self.rounds * round).saturating_sub(self.waiting.len());
        let started = (made as f64 / (ROUNDS * round) as f64).min(1.0);
        let priced = self.calm_forms.as_ref().map_or(0.0, CalmForms::progress);
        let now = SEARCH * started + (1.0 - SEARCH) * priced;
        self.told = self.told.max(now.min(0.99));
    }

    /// An estimate of the starts that would lead to branches that are not known.
    pub fn unseen(&self) -> Unseen {
        let Some(branches) = &self.branches else {
            return Unseen::of(std::iter::empty(), 0);
        };
        let met = branches.list.iter().map(|b| b.starts);
        let lost = std::iter::repeat_n(1, branches.lost);
        Unseen::of(met.chain(lost), branches.arrived)
    }

    /// Starts made so far.
    pub fn starts(&self) -> usize {
        self.branches.as_ref().map_or(0, |branches| branches.starts)
    }
}
