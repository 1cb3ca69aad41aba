//! The configurations of each chain at one pose of the workpiece, from starts at random.

use crate::math::metric::Metric;
use crate::plan::assemblies::{Assemblies, Configuration};
use crate::plan::one_chain::joined_still;
use crate::plan::seeds::Shape;
use crate::plan::unseen::Unseen;

/// Starts of each chain: at least, at most, and the bound on the share of configurations not seen with which they end.
const STARTS: usize = 24;
const MOST_STARTS: usize = 96;
const SURE: f64 = 0.1;
/// How near a chain comes to a pose that it can have, as ½‖q − g‖² with the size as length.
const THERE: f64 = 1e-9;

impl Assemblies {
    /// Finds a chain's configurations at the pose.
    pub(super) fn configure(&mut self, chain: usize) {
        let known = std::mem::take(&mut self.configurations[chain]);
        self.arrived[chain] = 0;
        let range = self.parts[chain].range.clone();
        // The start's own configuration, and those at the pose before, are the first starts.
        let own = self
            .start
            .as_ref()
            .map(|start| start[range.clone()].to_vec());
        let mut first: Vec<Vec<f64>> = known.into_iter().map(|c| c.own).chain(own).collect();
        for count in 0..MOST_STARTS {
            let from = first.pop().unwrap_or_else(|| {
                let variables = self.variables[chain].iter();
                let positive = count % 2 == 1;
                variables
                    .map(|v| v.draw(positive, &mut self.random))
                    .collect()
            });
            self.starts += 1;
            self.start_chain(chain, from);
            if count + 1 >= STARTS {
                let met = self.configurations[chain].iter().map(|c| c.starts);
                let unseen = Unseen::of(met, self.arrived[chain]);
                let nothing = self.arrived[chain] == 0;
                if nothing || (unseen.share == 0.0 && unseen.bound <= SURE) {
                    break;
                }
            }
        }
        if self.poses == 0 {
            let met = self.configurations[chain].iter().map(|c| c.starts);
            let parts = self.parts.len();
            self.unseen
                .push(Unseen::of_part(met, self.arrived[chain], parts));
        }
    }

    /// One start of a chain at the pose.
    fn start_chain(&mut self, chain: usize, mut own: Vec<f64>) {
        let part = &mut self.parts[chain];
        part.go(&self.pose, &mut own);
        let there = part.chain.pose(&own);
        let size = Metric::default();
        if !(size.value(&there, &self.pose) <= THERE) {
            return;
        }
        let range = self.parts[chain].range.clone();
        let part = &self.parts[chain];
        self.arrived[chain] += 1;
        let here = self.whole(chain, &own);
        let axes = self.places.axes(&here);
        let same = |other: &Configuration| {
            let there = self.whole(chain, &other.own);
            let written = self.places.form_near(&here, &there).apply(&there);
            self.places.are_axes_same(&self.places.axes(&there), &axes)
                || joined_still(&part.chain, &own, &written[range.clone()])
        };
        let known = self.configurations[chain].iter().position(same);
        let Some(known) = known.map(|known| &mut self.configurations[chain][known]) else {
            self.configurations[chain].push(Configuration { own, starts: 1 });
            return;
        };
        known.starts += 1;
        // Written with sliders of positive length, and small angles.
        let variables = &self.variables[chain];
        if Shape::new(variables, &own).before(&Shape::new(variables, &known.own)) {
            known.own = own;
        }
    }

    /// A position with one chain as it is given and all others at the joint values 0.
    fn whole(&self, chain: usize, own: &[f64]) -> Vec<f64> {
        let mut whole = vec![0.0; self.solver.scaled().variables()];
        whole[self.parts[chain].range.clone()].copy_from_slice(own);
        whole
    }
}
