//! Roads: from any branch to any other that known walks join it to, along branches and over crossings and bridges, while the
//! goal stands.

use crate::plan::branches::{Branches, Edge};
use crate::plan::places::Form;
use crate::plan::walk::Walk;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A known walk from one branch to another.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Link {
    /// By its number.
    Crossing(usize),
    /// By its key.
    Bridge((usize, usize, usize)),
}

impl Link {
    /// The branches and slots of its two ends.
    fn ends(self, branches: &Branches) -> [(usize, usize); 2] {
        match self {
            Self::Crossing(number) => {
                let crossing = &branches.crossings[number];
                crossing.branches.map(|branch| (branch, crossing.slot))
            }
            Self::Bridge((slot, from, to)) => [
                (branches.nodes[slot - 1][from].branch, slot - 1),
                (branches.nodes[slot][to].branch, slot),
            ],
        }
    }

    fn edge(self, branches: &Branches) -> &Edge {
        match self {
            Self::Crossing(number) => &branches.crossings[number].edge,
            Self::Bridge(key) => &branches.bridges[&key],
        }
    }
}

/// The walks of a road in order, and which are taken backwards.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Road(Vec<(Link, bool)>);

impl Road {
    /// Its walks, those along branches too, from a branch at a slot to the last branch at another.
    pub fn edges(&self, branches: &Branches, from: (usize, usize), to: usize) -> Vec<Edge> {
        let variables = branches.nodes[0][0].theta.len();
        let along = |(branch, slot): (usize, usize), to: usize| Edge {
            walk: branches.walk_along(branch, slot, to),
            form: Form::same(variables),
        };
        let (mut at, mut edges) = (from, Vec::new());
        for &(link, back) in &self.0 {
            let ends = link.ends(branches);
            let [enter, leave] = if back { [ends[1], ends[0]] } else { ends };
            edges.push(along(at, enter.1));
            let edge = link.edge(branches);
            edges.push(if back {
                let (branch, slot) = ends[0];
                let node = branches.list[branch].node(slot).expect("an end of a walk");
                reversed(edge, &branches.nodes[slot][node].theta)
            } else {
                edge.clone()
            });
            at = leave;
        }
        edges.push(along(at, to));
        edges
    }
}

/// The walk of an edge, which begins at `start`, in the other direction.
fn reversed(edge: &Edge, start: &[f64]) -> Edge {
    let form = edge.form.inverse();
    let Walk { points, length } = edge.walk.reversed(start);
    let written = |point: &Vec<f64>| Form::apply(&form, point);
    Edge {
        walk: Walk {
            points: points.iter().map(written).collect(),
            length,
        },
        form,
    }
}

/// All known walks between branches, as a graph: of walk i the ends are stops 2i and 2i + 1.
pub(super) struct Roads<'a> {
    branches: &'a Branches,
    price: f64,
    links: Vec<Link>,
    /// Branch and slot.
    stops: Vec<(usize, usize)>,
    /// The stops before and after on the same branch.
    beside: Vec<[Option<usize>; 2]>,
    /// The stops of each branch, in the order of their slots.
    of: Vec<Vec<usize>>,
}

/// The least cost at each stop.
pub(super) struct Reached {
    cost: Vec<f64>,
    /// The stop before; at the first of a road the node that it begins at.
    from: Vec<From>,
}

#[derive(Clone, Copy)]
enum From {
    /// A node, along its branch.
    Node(usize),
    /// A stop of the same branch.
    Along(usize),
    /// The other end of the walk.
    Over(usize),
}

impl<'a> Roads<'a> {
    /// With a price of each rad or size that joints move.
    pub fn new(branches: &'a Branches, price: f64) -> Self {
        let crossings = (0..branches.crossings.len()).map(Link::Crossing);
        let bridges = branches.bridges.keys().copied().map(Link::Bridge);
        let links: Vec<Link> = crossings.chain(bridges).collect();
        let stops: Vec<_> = links.iter().flat_map(|link| link.ends(branches)).collect();
        let mut of = vec![Vec::new(); branches.list.len()];
        for (stop, &(branch, _)) in stops.iter().enumerate() {
            of[branch].push(stop);
        }
        let mut beside = vec![[None; 2]; stops.len()];
        for own in &mut of {
            own.sort_by_key(|&stop| stops[stop].1);
            for pair in own.windows(2) {
                beside[pair[0]][1] = Some(pair[1]);
                beside[pair[1]][0] = Some(pair[0]);
            }
        }
        Self {
            branches,
            price,
            links,
            stops,
            beside,
            of,
        }
    }

    /// What it costs to go along a branch.
    fn along(&self, branch: usize, from: usize, to: usize) -> f64 {
        self.price * self.branches.list[branch].length(from, to)
    }

    /// From all nodes of a slot, at these costs: Dijkstra's search.
    pub fn reach(&self, slot: usize, costs: &[f64]) -> Reached {
        let mut reached = Reached {
            cost: vec![f64::INFINITY; self.stops.len()],
            from: vec![From::Node(0); self.stops.len()],
        };
        // Costs are not negative: their bits are in their order.
        let mut open = BinaryHeap::new();
        let take =
            |reached: &mut Reached, open: &mut BinaryHeap<_>, stop: usize, cost: f64, from| {
                if cost < reached.cost[stop] {
                    reached.cost[stop] = cost;
                    reached.from[stop] = from;
                    open.push(Reverse((cost.to_bits(), stop)));
                }
            };
        for (node, &cost) in costs.iter().enumerate() {
            let branch = self.branches.nodes[slot][node].branch;
            for &stop in &self.of[branch] {
                let cost = cost + self.along(branch, slot, self.stops[stop].1);
                take(&mut reached, &mut open, stop, cost, From::Node(node));
            }
        }
        while let Some(Reverse((bits, stop))) = open.pop() {
            let cost = reached.cost[stop];
            if bits != cost.to_bits() {
                continue;
            }
            let length = self.links[stop / 2].edge(self.branches).walk.length;
            let over = cost + self.price * length;
            take(&mut reached, &mut open, stop ^ 1, over, From::Over(stop));
            let (branch, at) = self.stops[stop];
            for next in self.beside[stop].into_iter().flatten() {
                let cost = cost + self.along(branch, at, self.stops[next].1);
                take(&mut reached, &mut open, next, cost, From::Along(stop));
            }
        }
        reached
    }

    /// The least cost of a branch at a slot, and the last stop before it.
    pub fn least(&self, reached: &Reached, branch: usize, slot: usize) -> Option<(f64, usize)> {
        let stops = self.of[branch].iter();
        stops
            .map(|&stop| {
                let rest = self.along(branch, self.stops[stop].1, slot);
                (reached.cost[stop] + rest, stop)
            })
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// The node that the road to a stop begins at, and its walks.
    pub fn road(&self, reached: &Reached, last: usize) -> (usize, Road) {
        let (mut walks, mut stop) = (Vec::new(), last);
        loop {
            match reached.from[stop] {
                From::Node(node) => {
                    walks.reverse();
                    return (node, Road(walks));
                }
                From::Along(before) => stop = before,
                From::Over(before) => {
                    walks.push((self.links[stop / 2], before % 2 == 1));
                    stop = before;
                }
            }
        }
    }
}
