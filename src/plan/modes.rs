//! Where a motion starts: the given joint values, or the assembly nearest to the first key frame that is
//! found from many seeds.
//!
//! A seed is closed in three steps. Every chain goes alone to one target pose, as near as it comes; the
//! target becomes the mean of the chains' ends, and again (alternating projections), since loops that are
//! open by more than the size seldom close; then all loops are closed together, and the assembly moves
//! along its branch to its pose nearest to the goal. Two seeds of three are the best assembly so far with
//! all joints moved at random (basin hopping, Wales and Doye 1997): that finds nearer ones sooner.
//!
//! All lengths are in units of the mechanism's size, and digits that are rounding are dropped between the
//! steps, so that the same linkage in another unit of length has the same start.

use crate::math::metric::{Metric, MetricKind};
use crate::math::pose::{Pose, mean};
use crate::math::random::Random;
use crate::model::mechanism::Mechanism;
use crate::model::scaled::Scaled;
use crate::plan::given::outside_limits;
use crate::plan::one_chain::{Part, relax};
use crate::plan::seeds::{Assembly, Shape, Variable};
use crate::plan::settings::Settings;
use crate::solve::close_start::Start;
use crate::solve::solver::{End, Solver};

/// Linear systems that one chain or assembly may take here: it need not be certified.
const ITERATIONS: usize = 100;
/// Seeds while no assembly is found.
const MOST_SEEDS: usize = 400;
/// Joint variables up to which that many seeds are tried, six chains of five; the time of a seed grows
/// with the cube of their number, and the number of seeds falls with it.
const USUAL_VARIABLES: usize = 30;
/// Seeds tried for any linkage.
const FEWEST_SEEDS: usize = 32;
/// Seeds that look for the nearest assembly where none meets the goal, and how many of them must be
/// tried since the last nearer one. Of 200 random linkages with a goal 1.5 sizes and 2.5 rad off, 2 have
/// a nearer assembly that this does not find and 1,400 seeds do.
const SEEDS: usize = 96;
const PATIENCE: usize = 48;
/// Seeds where an assembly meets the goal: none is nearer, and its chains are looked at one by one.
const SEEDS_REACHED: usize = 16;
/// Seeds that close but for the misfit of rounded dimensions, where none closes exactly, after which they
/// count as found: near a singular position one in a hundred seems so by chance.
const ROUNDED: usize = 8;
/// One seed of so many is drawn anew, the others are hops from the best.
const DRAWN: usize = 3;
/// Largest motion of a joint in a hop, rad or sizes: with 1 too many hops end where they began.
const HOP: f64 = 2.0;
/// Common targets on the way to a closed assembly. With the goal as the first target of all seeds, 9 of the 200
/// linkages are not found, and 14 with one target only; more than three bring no more.
const TARGETS: usize = 3;
/// Other configurations of one chain that are tried at the best pose, and how often all chains are.
const OTHERS: usize = 8;
const ROUNDS: usize = 2;
/// How near a chain must come to the workpiece to be in another configuration at the same pose, as ½‖q − g‖²
/// with the size as length: loops open by a thousandth close at once.
const SAME_POSE: f64 = 1e-6;
/// Joint motion, rad or sizes, below which two configurations are the same.
const SAME: f64 = 1e-3;

/// Joint values (rad or lengths) for a mechanism of which some chains have none: the assembly that comes
/// nearest to `first`, or, where some chains have values, to the pose that they give the workpiece.
/// Among assemblies equally near, sliders of positive length (offset and variable together) are
/// preferred, then small joint values. Angles are within ±π where the limits allow it.
///
/// The same input gives the same start. Where no assembly closes, the last seed is returned, open; given values outside
/// their limits come back as they are.
///
/// # Panics
/// When `given` does not have one entry a chain, with one value a joint variable.
pub fn find(
    mechanism: &Mechanism,
    given: &[Option<Vec<f64>>],
    first: &Pose,
    extent: f64,
    settings: &Settings,
) -> Vec<f64> {
    assert_eq!(given.len(), mechanism.chains().len(), "one entry a chain");
    if given.iter().all(Option::is_some) {
        return given.iter().flatten().flatten().copied().collect();
    }
    let chains = mechanism.chains().iter().zip(given);
    let whole: Vec<f64> = chains
        .flat_map(|(chain, values)| values.clone().unwrap_or(vec![0.0; chain.freedoms()]))
        .collect();
    let scaled = Scaled::new(mechanism, extent);
    let metric = settings
        .metric_for(mechanism, extent)
        .within(scaled.unit(), scaled.origin());
    let settings = Settings {
        metric_length: Some(metric.length),
        metric_origin: Some(metric.origin),
        max_iterations: Some(ITERATIONS),
        ..*settings
    };
    let mut search = Search::new(mechanism, given, &whole, first, &scaled, settings);
    let mut joints = scaled.left(&search.run());
    for outside in outside_limits(mechanism, &whole, extent) {
        if search.variables[outside.variable].given {
            joints[outside.variable] = outside.value;
        }
    }
    joints
}

struct Search {
    parts: Vec<Part>,
    variables: Vec<Variable>,
    together: Solver,
    /// Given values, and 0 or what is nearest to it within the limits.
    start: Vec<f64>,
    goal: Pose,
    metric: Metric,
    /// How far rounded dimensions may contradict each other.
    tolerance: f64,
    /// The most that rotations or a translation by the size count in the metric.
    scale: f64,
}

impl Search {
    /// `whole` has any values for the chains that have none; the lengths of `settings` are in units of the size.
    fn new(
        mechanism: &Mechanism,
        given: &[Option<Vec<f64>>],
        whole: &[f64],
        first: &Pose,
        scaled: &Scaled,
        settings: Settings,
    ) -> Self {
        let alone = Settings {
            metric: MetricKind::Pose,
            metric_length: Some(1.0),
            ..settings
        };
        let near = Mechanism::new(scaled.chains().to_vec()).expect("as many chains as before");
        let metric = settings.metric_for(&near, 1.0);
        let mut start = scaled.entered(whole);
        let mut goal = scaled.enter_pose(first);
        let (mut parts, mut variables) = (Vec::new(), Vec::new());
        let chains = scaled.chains().iter().zip(mechanism.chains()).zip(given);
        for ((chain, unscaled), values) in chains {
            let given = values.is_some();
            let range = variables.len()..variables.len() + chain.freedoms();
            variables.extend(Variable::of(chain, unscaled, scaled.unit(), given));
            if given && parts.iter().all(|part: &Part| !part.given) {
                goal = chain.pose(&start[range.clone()]);
            }
            let one = Mechanism::new(vec![chain.clone()]).expect("one chain is a mechanism");
            parts.push(Part {
                chain: chain.clone(),
                solver: alone.solver(&one, 1.0),
                range,
                given,
            });
        }
        for (x, variable) in start.iter_mut().zip(&variables) {
            if !variable.given {
                *x = variable.within(*x);
            }
        }
        Self {
            together: settings.solver(&near, 1.0),
            parts,
            variables,
            start,
            goal,
            metric,
            tolerance: settings.dimension_tolerance,
            scale: (0.25 / (metric.length * metric.length)).max(1.0),
        }
    }

    fn run(&mut self) -> Vec<f64> {
        let cube = |n: usize| n * n * n;
        let variables = self.variables.len().max(USUAL_VARIABLES);
        let most = FEWEST_SEEDS.max(MOST_SEEDS * cube(USUAL_VARIABLES) / cube(variables));
        let mut best: Option<Assembly> = None;
        let mut last = Vec::new();
        let (mut nearest, mut rounded) = (0, 0);
        for seed in 0..most {
            let enough = best.as_ref().is_some_and(|best| {
                let waited = seed >= SEEDS && seed - nearest > PATIENCE;
                let sure = best.exact || rounded >= ROUNDED;
                sure && (waited || (best.reached && seed >= SEEDS_REACHED))
            });
            if enough {
                break;
            }
            let joints = match &best {
                Some(best) if best.exact && seed % DRAWN != 0 => self.hop(seed, &best.joints),
                _ => self.gathered(seed),
            };
            last.clone_from(&joints);
            if let Some(found) = self.close(joints, best.as_ref()) {
                rounded += usize::from(!found.exact);
                if best.as_ref().is_none_or(|best| found.nearer(best)) {
                    nearest = seed;
                }
                if best.as_ref().is_none_or(|best| found.before(best)) {
                    best = Some(found);
                }
            }
        }
        match best {
            Some(best) => self.refine(best).joints,
            None => last,
        }
    }

    /// The best assembly with all joints moved at random, but for those with given values.
    fn hop(&self, seed: usize, best: &[f64]) -> Vec<f64> {
        let mut random = Random::new(seed as u64);
        let pairs = best.iter().zip(&self.start).zip(&self.variables);
        pairs
            .map(|((x, start), variable)| {
                let moved = x + HOP * (2.0 * random.unit() - 1.0);
                if variable.given {
                    *start
                } else {
                    variable.within(moved)
                }
            })
            .collect()
    }

    /// A seed drawn anew (the first one is 0 for all, as drawn in the tables), with the chains brought
    /// together: near the goal, or every other time near where a random chain has the workpiece.
    fn gathered(&mut self, seed: usize) -> Vec<f64> {
        let mut random = Random::new(seed as u64);
        let draw = seed / DRAWN;
        let mut joints = self.start.clone();
        if seed > 0 {
            for (x, variable) in joints.iter_mut().zip(&self.variables) {
                if !variable.given {
                    *x = variable.draw(draw % 2 == 1, &mut random);
                }
            }
        }
        let anyone = self.parts.iter().any(|part| part.given);
        let mut target = self.goal;
        if draw % 4 >= 2 && !anyone {
            let part = &self.parts[draw / 4 % self.parts.len()];
            target = part.chain.pose(&joints[part.range.clone()]);
        }
        // One chain alone, or beside one that is given, has nothing to agree upon.
        let targets = if anyone || self.parts.len() == 1 {
            1
        } else {
            TARGETS
        };
        for _ in 0..targets {
            let ends: Vec<Pose> = (self.parts.iter_mut())
                .map(|part| {
                    let own = &mut joints[part.range.clone()];
                    if !part.given {
                        part.go(&target, own);
                        for (x, variable) in own.iter_mut().zip(&self.variables[part.range.clone()])
                        {
                            *x = variable.rounded(*x);
                        }
                    }
                    part.chain.pose(own)
                })
                .collect();
            target = mean(&ends);
        }
        joints
    }

    /// The closed assembly next to `joints`, moved to its pose nearest to the goal; its inner freedoms are
    /// made use of for its shape, unless `best` is nearer.
    fn close(&mut self, mut joints: Vec<f64>, best: Option<&Assembly>) -> Option<Assembly> {
        // The second time it is closed but for the rounding.
        let mut exact = false;
        for _ in 0..2 {
            for (x, variable) in joints.iter_mut().zip(&self.variables) {
                *x = variable.rounded(*x);
            }
            exact = self.closes(&mut joints, exact)?;
        }
        let assembled = joints.clone();
        let solved = self.together.solve(&self.goal, &mut joints, &assembled);
        if solved.end == End::Open {
            return None;
        }
        let found = self.judge(joints, exact, solved.reached);
        if best.is_some_and(|best| best.nearer(&found)) {
            return Some(found);
        }
        let mut joints = found.joints.clone();
        for part in &self.parts {
            if !part.given {
                relax(&part.chain, &mut joints[part.range.clone()]);
            }
        }
        let exact = self.closes(&mut joints, exact);
        let relaxed = exact.map(|exact| self.judge(joints, exact, found.reached));
        // It is at the same pose but for rounding.
        Some(
            relaxed
                .filter(|relaxed| !found.before(relaxed))
                .unwrap_or(found),
        )
    }

    /// Whether all loops close exactly, or but for the misfit of rounded dimensions (false), if that is allowed;
    /// none if they do not.
    fn closes(&mut self, joints: &mut [f64], exactly: bool) -> Option<bool> {
        let tolerance = if exactly { 0.0 } else { self.tolerance };
        match self.together.close_start(joints, tolerance) {
            Start::Closed => Some(true),
            Start::Rounded => Some(false),
            Start::Open { .. } | Start::Rigid { .. } => None,
        }
    }

    fn judge(&self, mut joints: Vec<f64>, exact: bool, reached: bool) -> Assembly {
        for (x, variable) in joints.iter_mut().zip(&self.variables) {
            *x = variable.wrapped(*x);
        }
        let first = &self.parts[0];
        let pose = first.chain.pose(&joints[first.range.clone()]);
        Assembly {
            distance: self.metric.value(&pose, &self.goal) / self.scale,
            shape: Shape::new(&self.variables, &joints),
            exact,
            reached,
            pose,
            joints,
        }
    }

    /// Tries other configurations of each chain at the best pose: where the goal is met, those of better
    /// shape; else all, since the assembly can then come nearer.
    fn refine(&mut self, mut best: Assembly) -> Assembly {
        let mut random = Random::new(0);
        let count = self.parts.len();
        let mut unchanged = 0;
        for turn in 0..ROUNDS * count {
            unchanged += 1;
            if !self.parts[turn % count].given
                && self.refine_chain(turn % count, &mut best, &mut random)
            {
                unchanged = 0;
            }
            if unchanged == count {
                break;
            }
        }
        best
    }

    fn refine_chain(&mut self, chain: usize, best: &mut Assembly, random: &mut Random) -> bool {
        let range = self.parts[chain].range.clone();
        let mut improved = false;
        let mut seen = vec![best.joints[range.clone()].to_vec()];
        for other in 0..OTHERS {
            let variables = &self.variables[range.clone()];
            let part = &mut self.parts[chain];
            let mut own = self.start[range.clone()].to_vec();
            if other > 0 {
                let draw = |v: &Variable| v.draw(other % 2 == 1, random);
                own = variables.iter().map(draw).collect();
            }
            part.go(&best.pose, &mut own);
            let by_size = Metric::default();
            let away = by_size.value(&part.chain.pose(&own), &best.pose);
            if !(away <= SAME_POSE) {
                continue;
            }
            for (x, variable) in own.iter_mut().zip(variables) {
                *x = variable.wrapped(*x);
            }
            relax(&part.chain, &mut own);
            let present = Shape::new(variables, &best.joints[range.clone()]);
            let better = Shape::new(variables, &own).before(&present);
            if seen.iter().any(|s| is_same(s, &own)) || (best.reached && !better) {
                continue;
            }
            let mut joints = best.joints.clone();
            joints[range.clone()].copy_from_slice(&own);
            seen.push(own);
            if let Some(found) = self.close(joints, Some(best))
                && found.before(best)
            {
                *best = found;
                improved = true;
                // At the new pose they are others.
                seen.clear();
            }
        }
        improved
    }
}

fn is_same(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME)
}
