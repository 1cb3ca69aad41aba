//! Positions that may be ways to assemble: combinations of the chains' configurations, and positions drawn anew.

use crate::plan::assemblies::{AT_A_TIME, Assemblies, MOST, Mode};

impl Assemblies {
    /// Tries some combinations of the chains' configurations, from this one on; true while there are more.
    pub(super) fn combine(&mut self, first: usize) -> bool {
        let counts: Vec<usize> = self.configurations.iter().map(Vec::len).collect();
        let all = counts.iter().fold(1_usize, |all, n| all.saturating_mul(*n));
        let tried = all.min(MOST);
        if self.poses == 0 {
            self.combinations = all;
        }
        for number in first..tried.min(first + AT_A_TIME) {
            // Of more combinations than are tried some from all over.
            let mut rest = if all > MOST {
                number * (all / MOST)
            } else {
                number
            };
            let (mut theta, mut starts) = (Vec::new(), usize::MAX);
            for (configurations, count) in self.configurations.iter().zip(&counts) {
                let one = &configurations[rest % count];
                rest /= count;
                theta.extend_from_slice(&one.own);
                starts = starts.min(one.starts);
            }
            self.take(&theta, starts);
        }
        first + AT_A_TIME < tried
    }

    /// A position drawn anew.
    pub(super) fn draw(&mut self) {
        self.starts += 1;
        let mut theta = Vec::new();
        for variables in &self.variables {
            let drawn = variables.iter().map(|v| v.draw(true, &mut self.random));
            theta.extend(drawn);
        }
        self.take(&theta, 1);
    }

    /// Closes a position, moves it to the closest pose, and keeps it where it is a way that is not known.
    fn take(&mut self, theta: &[f64], starts: usize) {
        let mut joints = self.solver.scaled().left(theta);
        let tolerance = self.settings.dimension_tolerance;
        if !self
            .anywhere
            .close_start(&mut joints, tolerance)
            .is_closed()
        {
            return;
        }
        let goal = self.goals[self.frame].pose;
        let predicted = joints.clone();
        self.solver.clear_holding();
        let solved = self.solver.solve(&goal, &mut joints, &predicted);
        if !solved.end.is_minimum() {
            return;
        }
        self.taken += 1;
        let scaled = self.solver.scaled();
        let theta = self.written_short(&scaled.entered(&joints));
        let axes = self.places.axes(&theta);
        let places = &self.places;
        let same = |mode: &Mode| places.are_joined_still(&theta, &axes, &mode.theta, &mode.axes);
        if let Some(known) = self.modes.iter().position(same) {
            self.modes[known].starts += 1;
            self.modes[known].met += 1;
            return;
        }
        let start = self.start.as_ref();
        let is_start = start.is_some_and(|start| {
            places.are_joined_still(&theta, &axes, start, &places.axes(start))
        });
        let scaled = self.solver.scaled();
        let pose = scaled.leave_pose(&scaled.chains()[0].pose(&theta));
        let joints = scaled.left(&theta);
        self.modes.push(Mode {
            value: self.solver.value(&goal, &joints),
            reached: solved.reached,
            joints,
            pose,
            starts,
            is_start,
            planned: None,
            met: 1,
            used: false,
            theta,
            axes,
        });
        let nearer = |a: &Mode, b: &Mode| a.value.total_cmp(&b.value);
        self.modes.sort_by(nearer);
    }

    /// Angles within ±π where the limits allow it.
    fn written_short(&self, theta: &[f64]) -> Vec<f64> {
        let variables = self.variables.iter().flatten();
        variables.zip(theta).map(|(v, &x)| v.wrapped(x)).collect()
    }
}
