//! Joint limits: which joints are held at one, which the pull would lead away, and how far a step may go.

use crate::model::joint::{Limits, Stop};
use crate::model::scaled::LIMIT;

/// The limits of all joint variables and the joints that are held at one.
#[derive(Clone, Debug)]
pub struct Holding {
    limits: Vec<Limits>,
    stops: Vec<Stop>,
}

impl Holding {
    /// Nothing is held.
    pub fn new(limits: &[Limits]) -> Self {
        Self {
            limits: limits.to_vec(),
            stops: vec![Stop::None; limits.len()],
        }
    }

    /// The stop of each joint variable.
    #[inline]
    pub fn stops(&self) -> &[Stop] {
        &self.stops
    }

    /// The limits of a joint variable.
    pub fn limits(&self, joint: usize) -> &Limits {
        &self.limits[joint]
    }

    /// Lets all joints go.
    pub fn clear(&mut self) {
        self.stops.fill(Stop::None);
    }

    /// Holds a joint or lets it go; its stop before.
    pub fn set(&mut self, joint: usize, stop: Stop) -> Stop {
        std::mem::replace(&mut self.stops[joint], stop)
    }

    /// The joints that are held.
    pub fn held(&self) -> Vec<usize> {
        let held = self.stops.iter().enumerate();
        held.filter(|(_, stop)| **stop != Stop::None)
            .map(|(joint, _)| joint)
            .collect()
    }

    /// Whether no joint is held.
    pub fn is_free(&self) -> bool {
        self.stops.iter().all(|stop| *stop == Stop::None)
    }

    /// Lets those joints go that do not stand at the limit at which they are held.
    pub fn release_away(&mut self, theta: &[f64]) {
        for ((stop, l), &t) in self.stops.iter_mut().zip(&self.limits).zip(theta) {
            if *stop != Stop::None && !((t - stop.bound(l)).abs() <= LIMIT) {
                *stop = Stop::None;
            }
        }
    }

    /// Puts the held joints at their limits.
    pub fn apply(&self, theta: &mut [f64]) {
        for ((t, stop), limits) in theta.iter_mut().zip(&self.stops).zip(&self.limits) {
            if *stop != Stop::None {
                *t = stop.bound(limits);
            }
        }
    }

    /// Puts all joints within their limits; with `hold` those that were beyond one stay held there.
    pub fn clamp(&mut self, theta: &mut [f64], hold: bool) {
        for ((t, stop), l) in theta.iter_mut().zip(&mut self.stops).zip(&self.limits) {
            let within = l.nearest(*t);
            if hold && (*t - within).abs() > LIMIT {
                *stop = if *t < within { Stop::Min } else { Stop::Max };
            }
            *t = within;
        }
    }

    /// Holds every joint that stands at a limit.
    pub fn hold_all_at(&mut self, theta: &[f64]) {
        for ((stop, &t), l) in self.stops.iter_mut().zip(theta).zip(&self.limits) {
            *stop = if t >= l.max - LIMIT {
                Stop::Max
            } else if t <= l.min + LIMIT {
                Stop::Min
            } else {
                Stop::None
            };
        }
    }

    /// The held joint that would lower the objective most, and by more than `least` per unit, by leaving its limit;
    /// `torque` is the objective's change per unit of a joint variable that is let go.
    #[inline]
    pub fn releasable(&self, least: f64, torque: impl Fn(usize) -> f64) -> Option<usize> {
        let mut best = (least, None);
        for (joint, (stop, l)) in self.stops.iter().zip(&self.limits).enumerate() {
            let inward = match stop {
                Stop::None => continue,
                Stop::Min => -torque(joint),
                Stop::Max => torque(joint),
            };
            if inward > best.0 && l.max > l.min {
                best = (inward, Some(joint));
            }
        }
        best.1
    }

    /// The largest share of a step that keeps free joints within their limits, and the joint that meets its limit there.
    /// Motions of at most `level` are rounding, and the joint `except` is left out.
    pub fn share(
        &self,
        theta: &[f64],
        step: &[f64],
        level: f64,
        except: Option<usize>,
    ) -> (f64, Option<(usize, Stop)>) {
        let mut first = (1.0, None);
        for (joint, l) in self.limits.iter().enumerate() {
            let s = step[joint];
            if s.abs() <= level || Some(joint) == except || self.stops[joint] != Stop::None {
                continue;
            }
            let (room, stop) = if s > 0.0 {
                (l.max - theta[joint], Stop::Max)
            } else {
                (theta[joint] - l.min, Stop::Min)
            };
            if room < s.abs() * first.0 {
                first = ((room / s.abs()).max(0.0), Some((joint, stop)));
            }
        }
        first
    }

    /// The free joint at a limit that the rates push hardest against it, harder than `level`.
    pub fn pushed(
        &self,
        theta: &[f64],
        rates: &[f64],
        level: f64,
        except: usize,
    ) -> Option<(usize, Stop)> {
        let mut hardest = (level, None);
        for (joint, l) in self.limits.iter().enumerate() {
            if joint == except || self.stops[joint] != Stop::None {
                continue;
            }
            if rates[joint] > hardest.0 && theta[joint] >= l.max - LIMIT {
                hardest = (rates[joint], Some((joint, Stop::Max)));
            }
            if -rates[joint] > hardest.0 && theta[joint] <= l.min + LIMIT {
                hardest = (-rates[joint], Some((joint, Stop::Min)));
            }
        }
        hardest.1
    }

    /// The first joint beyond its limit on the way from `theta` to `next`, with the part of the way up to it.
    pub fn overrun(&self, theta: &[f64], next: &[f64]) -> Option<(f64, usize, Stop)> {
        let mut first: Option<(f64, usize, Stop)> = None;
        for (joint, l) in self.limits.iter().enumerate() {
            let (beyond, stop) = if next[joint] > l.max + LIMIT {
                (l.max - theta[joint], Stop::Max)
            } else if next[joint] < l.min - LIMIT {
                (l.min - theta[joint], Stop::Min)
            } else {
                continue;
            };
            let part = (beyond / (next[joint] - theta[joint])).clamp(0.0, 1.0);
            if first.is_none_or(|(least, ..)| part < least) {
                first = Some((part, joint, stop));
            }
        }
        first
    }

    /// Whether all joints are within their limits, up to rounding.
    #[inline]
    pub fn contains(&self, theta: &[f64]) -> bool {
        let mut pairs = theta.iter().zip(&self.limits);
        pairs.all(|(t, l)| *t >= l.min - LIMIT && *t <= l.max + LIMIT)
    }

    /// Widens the limits of joints that are beyond them to where they are.
    pub fn widen(&mut self, theta: &[f64]) {
        for (l, &t) in self.limits.iter_mut().zip(theta) {
            l.min = l.min.min(t);
            l.max = l.max.max(t);
        }
    }

    /// Gives a joint variable limits of ±`most` on the sides on which it has none.
    pub fn bound(&mut self, joint: usize, most: f64) {
        let l = &mut self.limits[joint];
        if l.min == f64::NEG_INFINITY {
            l.min = -most;
        }
        if l.max == f64::INFINITY {
            l.max = most;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A joint at its limit, one within, one free.
    fn holding() -> (Holding, [f64; 3]) {
        let limits = [(-1.0, 1.0), (-2.0, 0.5), (f64::NEG_INFINITY, f64::INFINITY)];
        (
            Holding::new(&limits.map(|(min, max)| Limits { min, max })),
            [1.0, 0.0, 7.0],
        )
    }

    /// A joint 1e-3 beyond its limit is not within it, and one that rounding carried 1e-11 beyond is.
    #[test]
    fn beyond_a_limit_is_not_within() {
        let (holding, mut theta) = holding();
        theta[0] = 1.0 + 1e-11;
        assert!(holding.contains(&theta));
        theta[0] = 1.0 + 1e-3;
        assert!(!holding.contains(&theta));
        theta[0] = f64::NAN;
        assert!(!holding.contains(&theta));
    }

    #[test]
    fn a_step_ends_at_the_first_limit() {
        let (holding, _) = holding();
        let (share, hit) = holding.share(&[0.0, 0.0, 0.0], &[2.0, 2.0, 9.0], 0.0, None);
        assert_eq!((share, hit), (0.25, Some((1, Stop::Max))));
        let (share, hit) = holding.share(&[0.0, 0.0, 0.0], &[2.0, 2.0, 9.0], 0.0, Some(1));
        assert_eq!((share, hit), (0.5, Some((0, Stop::Max))));
    }

    #[test]
    fn a_joint_is_let_go_only_inwards() {
        let (mut holding, theta) = holding();
        holding.hold_all_at(&theta);
        assert_eq!(holding.held(), [0]);
        assert_eq!(holding.releasable(1e-9, |_| -1.0), None);
        assert_eq!(holding.releasable(1e-9, |_| 1.0), Some(0));
    }
}
