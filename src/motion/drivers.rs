//! A motion given by joint variables over time, in place of poses of the workpiece.

/// How a driven joint goes from one of its values to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Ramp {
    /// At constant speed.
    #[default]
    Linear,
    /// At rest at each value: speed and acceleration are 0 there.
    Smooth,
}

/// A joint variable whose values are given.
#[derive(Clone, Debug, PartialEq)]
pub struct Driver {
    /// The variable, counted from 0 through all chains.
    pub variable: usize,
    /// Times, each later than the one before, and the values there: rad or lengths in the mechanism's unit.
    pub values: Vec<(f64, f64)>,
    /// What is between them.
    pub ramp: Ramp,
}

impl Driver {
    /// The value at a time: the first one before the first time, and the last one after the last.
    ///
    /// # Panics
    /// When there is no value.
    pub fn at(&self, time: f64) -> f64 {
        let behind = self.values.partition_point(|(t, _)| *t <= time);
        let (from, value) = self.values[behind.saturating_sub(1)];
        let Some(&(to, next)) = self.values.get(behind).filter(|_| behind > 0) else {
            return value;
        };
        let u = (time - from) / (to - from);
        let share = match self.ramp {
            Ramp::Linear => u,
            // The polynomial of least degree that is at rest at both ends.
            Ramp::Smooth => u * u * u * (10.0 + u * (6.0 * u - 15.0)),
        };
        value + (next - value) * share
    }
}

/// The drivers of a motion and the number of its frames.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// One or more, each with two or more values, no variable twice.
    pub drivers: Vec<Driver>,
    /// Two or more.
    pub frames: usize,
}

impl Schedule {
    /// The driven variables, in the order of the drivers.
    pub fn variables(&self) -> Vec<usize> {
        self.drivers.iter().map(|driver| driver.variable).collect()
    }

    /// The first and the last time of all drivers.
    pub fn interval(&self) -> (f64, f64) {
        let times = || self.drivers.iter().flat_map(|driver| &driver.values);
        let first = times().map(|(t, _)| *t).fold(f64::INFINITY, f64::min);
        let last = times().map(|(t, _)| *t).fold(f64::NEG_INFINITY, f64::max);
        (first, last)
    }

    /// The time of a frame: they are equally spaced from the first time to the last.
    pub fn time(&self, frame: usize) -> f64 {
        let (first, last) = self.interval();
        if frame + 1 >= self.frames {
            last
        } else {
            first + (last - first) * (frame as f64 / (self.frames - 1) as f64)
        }
    }

    /// The times between two others at which a driver comes to one of its values.
    pub fn breaks(&self, from: f64, to: f64) -> Vec<f64> {
        let times = self.drivers.iter().flat_map(|driver| &driver.values);
        let mut breaks: Vec<f64> = times
            .map(|(t, _)| *t)
            .filter(|t| from < *t && *t < to)
            .collect();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        breaks
    }

    /// The values of all drivers at a time.
    pub fn values(&self, time: f64) -> Vec<f64> {
        self.drivers.iter().map(|driver| driver.at(time)).collect()
    }

    /// How far the driver of `variable` goes; 0 where it is not driven.
    pub fn range(&self, variable: usize) -> f64 {
        let own = self.drivers.iter().filter(|d| d.variable == variable);
        let values = || own.clone().flat_map(|d| d.values.iter().map(|(_, v)| *v));
        let least = values().fold(f64::INFINITY, f64::min);
        (values().fold(f64::NEG_INFINITY, f64::max) - least).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn driver(ramp: Ramp) -> Driver {
        Driver {
            variable: 0,
            values: vec![(1.0, -2.0), (2.0, 4.0), (4.0, 4.0), (5.0, 0.0)],
            ramp,
        }
    }

    #[test]
    fn values_are_met_and_held_outside() {
        for ramp in [Ramp::Linear, Ramp::Smooth] {
            let driver = driver(ramp);
            for (time, value) in [(0.0, -2.0), (9.0, 0.0)].iter().chain(&driver.values) {
                assert_eq!(
                    driver.at(*time).to_bits(),
                    value.to_bits(),
                    "{ramp:?} {time}"
                );
            }
            // Half way in half of the time, and still where it dwells.
            assert!((driver.at(1.5) - 1.0).abs() < 1e-15);
            assert!((driver.at(3.1) - 4.0).abs() < 1e-15);
        }
        assert!((driver(Ramp::Linear).at(1.25) + 0.5).abs() < 1e-15);
    }

    #[test]
    fn a_smooth_ramp_rests_at_its_values() {
        let speed = |ramp, t: f64| (driver(ramp).at(t + 1e-5) - driver(ramp).at(t - 1e-5)) / 2e-5;
        for t in [1.0, 2.0, 4.0, 5.0] {
            assert!(speed(Ramp::Smooth, t).abs() < 1e-6, "{t}");
            assert!(speed(Ramp::Linear, t).abs() > 1.0, "{t}");
        }
    }

    #[test]
    fn frames_are_equally_spaced_over_all_drivers() {
        let late = Driver {
            variable: 2,
            values: vec![(3.0, 0.0), (6.0, 1.0)],
            ramp: Ramp::Linear,
        };
        let schedule = Schedule {
            drivers: vec![driver(Ramp::Linear), late],
            frames: 6,
        };
        let times: Vec<f64> = (0..6).map(|i| schedule.time(i)).collect();
        assert_eq!(times, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(schedule.values(1.0), [-2.0, 0.0]);
        assert_eq!(schedule.breaks(1.0, 5.0), [2.0, 3.0, 4.0]);
        assert!((schedule.range(0) - 6.0).abs() < 1e-15 && schedule.range(1) == 0.0);
    }
}
