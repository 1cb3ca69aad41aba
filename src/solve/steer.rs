//! Several joint variables driven along a path while the loops stay closed and the other joints follow.
//!
//! The slopes dθ/dq of all joints by the driven ones belong to a position, whatever the speeds: of all joint rates that
//! keep the loops closed and move the driven joints so, those with the least sum of squares (rad, and lengths as shares
//! of the mechanism's size). A step predicts along them and closes the loops with the driven joints held. It counts only
//! if the correction is short against it, and if the slopes behind it resemble those before it: so the branch is kept.
//!
//! Next to a singular position, where branches meet, slopes are rounding: the last ones before it are carried on. Where
//! there are none, at a start in such a position, or where the driven joints stand still in all free directions, short
//! steps into the free directions are tried, and the least motion that leads on is taken.

use crate::math::linalg::dot;
use crate::model::joint::{Limits, Stop};
use crate::model::scaled::{SOLVED, Scaled};
use crate::solve::close::{Closer, Reach, Shortest};
use crate::solve::drive::Obstacle;
use crate::solve::limits::Holding;
use crate::solve::slopes::{
    APART, Slopes, along, bend, free_directions, freedoms, less, near_dependence, slopes_at,
};

/// Longest step, the root of the joints' squared motions: 0.1 still resembles its tangent.
const STEP: f64 = 0.1;
/// Motion of the driven joints, rad or sizes, below which no step is shortened: where a dead point is, is then known to
/// within about as much.
const SMALLEST: f64 = 1e-10;
/// Corrections, and changes of the slopes, are at most this share of the step.
const CORRECTED: f64 = 0.5;
/// Rate of a joint that is rounding.
const LEVEL: f64 = 1e-9;
/// Steps out of a position in which the driven joints stand still, or branches meet.
const KICKS: [f64; 2] = [1e-2, 1e-3];
/// Least progress of the driven joints that such a step must bring: above the error of a dead point.
const PROGRESS: f64 = 1e-9;
/// How often that is done on one path.
const MOST_KICKS: usize = 8;
/// How far out a slider may move on a side on which it has no limit, in units of the size.
const FARTHEST: f64 = 20.0;
/// Steps of one path: a hundred turns of a linkage that moves as its crank does.
const STEPS: usize = 10_000;

/// The driven joints of a linkage, and what is known of the branch that it is on.
#[derive(Clone, Debug)]
pub struct Steering {
    variables: Vec<usize>,
    /// Without limits for the driven joints: their values are given.
    holding: Holding,
    /// Combinations of constraints near dependence at an ordinary position: the surplus.
    usual: usize,
    slopes: Option<Slopes>,
    /// The slopes before the last step, and the motion of the driven joints in it.
    before: Option<(Slopes, Vec<f64>)>,
    /// A branch was chosen among several.
    chose: bool,
    iterations: usize,
}

/// How a step ends.
enum Taken {
    /// At its end.
    Whole,
    /// Not at all: to be tried again, cut to this share.
    Shorter(f64),
    /// Not at all: this joint would pass its limit, which is met at this share.
    Beyond(usize, Stop, f64),
    /// There is no direction.
    Blocked,
}

impl Steering {
    /// For these driven variables, from the closed position `theta`. `others` are ordinary positions near it.
    pub fn new(
        scaled: &Scaled,
        closer: &mut Closer,
        variables: &[usize],
        theta: &[f64],
        others: &[Vec<f64>],
    ) -> Self {
        let mut limits = scaled.limits().to_vec();
        for &variable in variables {
            limits[variable] = Limits::NONE;
        }
        let mut holding = Holding::new(&limits);
        for (joint, &turns) in scaled.turns().iter().enumerate() {
            if !turns && !variables.contains(&joint) {
                holding.bound(joint, FARTHEST);
            }
        }
        holding.widen(theta);
        let all = std::iter::once(theta).chain(others.iter().map(Vec::as_slice));
        let usual = all.map(|at| near_dependence(scaled, closer, at)).min();
        Self {
            variables: variables.to_vec(),
            holding,
            usual: usual.unwrap_or(0),
            slopes: None,
            before: None,
            chose: false,
            iterations: 0,
        }
    }

    /// The driven variables.
    pub fn variables(&self) -> &[usize] {
        &self.variables
    }

    /// The values of the driven joints.
    pub fn driven(&self, theta: &[f64]) -> Vec<f64> {
        self.variables.iter().map(|&v| theta[v]).collect()
    }

    /// Linear systems solved since this was last asked.
    pub fn take_iterations(&mut self) -> usize {
        std::mem::take(&mut self.iterations)
    }

    /// Was a branch chosen among several since this was last asked?
    pub fn take_choice(&mut self) -> bool {
        std::mem::take(&mut self.chose)
    }

    /// Drives the joints along `path`, from its part 0 to 1, as far as it goes; `theta` receives where that led, closed.
    /// None where it goes all the way.
    pub fn follow(
        &mut self,
        scaled: &Scaled,
        closer: &mut Closer,
        theta: &mut Vec<f64>,
        path: &dyn Fn(f64) -> Vec<f64>,
    ) -> Option<Obstacle> {
        let (mut done, mut step, mut kicks) = (0.0, 1.0, 0);
        for _ in 0..STEPS {
            if done >= 1.0 {
                return None;
            }
            let next = if done + step > 1.0 - LEVEL {
                1.0
            } else {
                done + step
            };
            // Where a step out of a singular position has left the path, the rest leads back to it.
            let (at, behind) = (self.driven(theta), (1.0 - next) / (1.0 - done));
            let entries = path(next).into_iter().zip(path(done)).zip(&at);
            let to: Vec<f64> = entries
                .map(|((to, from), at)| to + (at - from) * behind)
                .collect();
            let shift: Vec<f64> = to.iter().zip(&at).map(|(to, at)| to - at).collect();
            let distance = dot(&shift, &shift).sqrt();
            if !(distance > 0.0) {
                done = next;
                continue;
            }
            let taken = self.step(scaled, closer, theta, &to, &shift);
            match taken {
                Taken::Whole => {
                    done = next;
                    step *= 2.0;
                    continue;
                }
                Taken::Shorter(share) | Taken::Beyond(.., share) if distance > SMALLEST => {
                    step = (next - done) * share;
                    continue;
                }
                Taken::Beyond(joint, stop, _) => {
                    if self.put_at_limit(scaled, closer, theta, joint, stop) {
                        continue;
                    }
                    return Some(Obstacle::Limits(vec![joint]));
                }
                Taken::Shorter(_) | Taken::Blocked => {}
            }
            let held = self.holding.held();
            kicks += 1;
            // A dead point that was come to step by step has slopes, and no other way on.
            let stands = matches!(taken, Taken::Blocked)
                || near_dependence(scaled, closer, theta) > self.usual;
            if stands
                && held.is_empty()
                && kicks <= MOST_KICKS
                && self.kick(scaled, closer, theta, &shift)
            {
                step = 1.0 - done;
                continue;
            }
            return Some(match held.is_empty() {
                false => Obstacle::Limits(held),
                true if freedoms(scaled, closer, theta) > 0 => Obstacle::DeadPoint,
                true => Obstacle::Immobile,
            });
        }
        Some(Obstacle::TooFar)
    }

    /// One step of the driven joints by `shift` to the values `to`.
    fn step(
        &mut self,
        scaled: &Scaled,
        closer: &mut Closer,
        theta: &mut Vec<f64>,
        to: &[f64],
        shift: &[f64],
    ) -> Taken {
        let near = near_dependence(scaled, closer, theta) > self.usual;
        let slopes = if near {
            // What was held before may leave its limit.
            self.holding.clear();
            self.slopes.clone()
        } else {
            self.slopes_towards(scaled, closer, theta, shift)
        };
        let Some(slopes) = slopes else {
            return Taken::Blocked;
        };
        let mut moves = along(&slopes, shift);
        if let Some(before) = &self.before {
            bend(before, &slopes, shift, &mut moves);
        }
        let length = dot(&moves, &moves).sqrt();
        if length > STEP {
            return Taken::Shorter((0.9 * STEP / length).max(1e-3));
        }
        let mut next: Vec<f64> = theta.iter().zip(&moves).map(|(t, m)| t + m).collect();
        if !self.close(scaled, closer, &mut next, Some(to), CORRECTED * length) {
            return Taken::Shorter(0.5);
        }
        if let Some((share, joint, stop)) = self.holding.overrun(theta, &next) {
            return if share > 0.0 {
                Taken::Beyond(joint, stop, share.min(0.999))
            } else {
                Taken::Beyond(joint, stop, 0.5)
            };
        }
        // Next to a singular position the slopes say nothing: those from before are carried on.
        if near_dependence(scaled, closer, &next) <= self.usual {
            let Some(behind) = self.slopes_at(scaled, closer, &next) else {
                return Taken::Shorter(0.5);
            };
            let (before, after) = (along(&slopes, shift), along(&behind, shift));
            let change: Vec<f64> = before.iter().zip(&after).map(|(a, b)| b - a).collect();
            if !(dot(&change, &change).sqrt() <= CORRECTED * dot(&before, &before).sqrt()) {
                return Taken::Shorter(0.5);
            }
            self.slopes = Some(behind);
        }
        self.before = Some((slopes, shift.to_vec()));
        *theta = next;
        Taken::Whole
    }

    /// The slopes at `theta` with those joints held that a motion by `shift` would push beyond a limit.
    fn slopes_towards(
        &mut self,
        scaled: &Scaled,
        closer: &mut Closer,
        theta: &[f64],
        shift: &[f64],
    ) -> Option<Slopes> {
        self.holding.clear();
        loop {
            let slopes = self.slopes_at(scaled, closer, theta)?;
            let mut rates = along(&slopes, shift);
            let length = dot(&rates, &rates).sqrt();
            rates.iter_mut().for_each(|rate| *rate /= length);
            match self.holding.pushed(theta, &rates, LEVEL, usize::MAX) {
                Some((joint, stop)) => self.holding.set(joint, stop),
                None => return Some(slopes),
            };
        }
    }

    fn slopes_at(&mut self, scaled: &Scaled, closer: &mut Closer, theta: &[f64]) -> Option<Slopes> {
        self.iterations += 1;
        slopes_at(scaled, closer, theta, &self.variables, &self.holding)
    }

    /// Closes the loops near `theta` with the driven joints at `driven`, or free; false if they do not close by
    /// corrections of at most `reach` together.
    fn close(
        &mut self,
        scaled: &Scaled,
        closer: &mut Closer,
        theta: &mut [f64],
        driven: Option<&[f64]>,
        reach: f64,
    ) -> bool {
        let mut stops = self.holding.clone();
        stops.apply(theta);
        for (&variable, &value) in self.variables.iter().zip(driven.unwrap_or_default()) {
            theta[variable] = value;
            // `Min` or `Max`: it is only held.
            stops.set(variable, Stop::Min);
        }
        let reach = Reach {
            shortest: Shortest::Joints,
            each: f64::INFINITY,
            all: reach,
        };
        closer.close(scaled, stops.stops(), &reach, theta, &mut self.iterations)
            // Of rounded dimensions a combination with the held joints may have been left out.
            && (!closer.dependence().is_rounded() || closer.closure(scaled, theta).0 <= 2.0 * SOLVED)
    }

    /// Puts a joint that has come to its limit exactly there, the driven joints as they are; false where the loops do not
    /// close so.
    fn put_at_limit(
        &mut self,
        scaled: &Scaled,
        closer: &mut Closer,
        theta: &mut Vec<f64>,
        joint: usize,
        stop: Stop,
    ) -> bool {
        let mut next = theta.clone();
        let driven = self.driven(theta);
        let before = self.holding.set(joint, stop);
        let closed = self.close(scaled, closer, &mut next, Some(&driven), 10.0 * KICKS[1]);
        self.holding.set(joint, before);
        let moved = closed && next.iter().zip(&*theta).any(|(a, b)| (a - b).abs() > 0.0);
        if moved {
            *theta = next;
        }
        moved
    }

    /// A short step in a free direction after which the driven joints are further along `shift`: in the direction of the
    /// slopes from before if that leads on, else in that of the least motion.
    fn kick(
        &mut self,
        scaled: &Scaled,
        closer: &mut Closer,
        theta: &mut Vec<f64>,
        shift: &[f64],
    ) -> bool {
        let distance = dot(shift, shift).sqrt();
        let at = self.driven(theta);
        let mut ways: Vec<Vec<f64>> = self.slopes.iter().map(|s| along(s, shift)).collect();
        let kept = ways.len();
        ways.extend(free_directions(scaled, closer, theta, &self.holding));
        for length in KICKS {
            // Motion per progress, its direction, and where it leads.
            let mut found: Vec<(f64, Vec<f64>, Vec<f64>)> = Vec::new();
            for (i, way) in ways.iter().enumerate() {
                let norm = dot(way, way).sqrt();
                for side in [1.0, -1.0] {
                    let scale = side * length / norm;
                    let mut next: Vec<f64> =
                        theta.iter().zip(way).map(|(t, w)| t + scale * w).collect();
                    if !self.close(scaled, closer, &mut next, None, CORRECTED * length)
                        || self.holding.overrun(theta, &next).is_some()
                    {
                        continue;
                    }
                    let gained: Vec<f64> = self
                        .driven(&next)
                        .iter()
                        .zip(&at)
                        .map(|(a, b)| a - b)
                        .collect();
                    let progress = dot(&gained, shift) / distance;
                    // Aside is not along.
                    if !(progress > PROGRESS && dot(&gained, &gained) <= 2.0 * progress * progress)
                    {
                        continue;
                    }
                    if i < kept && side > 0.0 {
                        *theta = next;
                        self.before = None;
                        return true;
                    }
                    let moved: Vec<f64> = next.iter().zip(&*theta).map(|(a, b)| a - b).collect();
                    let norm = dot(&moved, &moved).sqrt();
                    let unit: Vec<f64> = moved.iter().map(|m| m / norm).collect();
                    let same = |other: &Vec<f64>| {
                        unit.iter().zip(other).all(|(a, b)| (a - b).abs() <= APART)
                    };
                    if !found.iter().any(|(_, other, _)| same(other)) {
                        found.push((norm / progress, unit, next));
                    }
                }
            }
            self.chose |= found.len() > 1;
            if let Some((.., next)) = found.into_iter().min_by(less) {
                *theta = next;
                (self.slopes, self.before) = (None, None);
                return true;
            }
        }
        false
    }
}
