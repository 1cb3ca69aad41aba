//! Every analytic derivative against finite differences, over all joints and all 214 chain types.

mod common;

use common::{Linkage, Random, assemblies, chain, goals, linkage};
use nalgebra::{Matrix6, SVector, Vector3, Vector6};
use std::f64::consts::{FRAC_PI_2, PI};
use synthetica::math::metric::Metric;
use synthetica::math::pose::{
    DualQuaternion, Pose, difference, dual_quaternion, from_dual_quaternion,
};
use synthetica::model::chain::{Chain, ChainState};
use synthetica::model::dh::DhRow;
use synthetica::model::joint::{Joint, JointKind, Stop};
use synthetica::model::mechanism::Mechanism;
use synthetica::motion::goal::Goal;
use synthetica::plan::follow::plan;
use synthetica::plan::settings::Settings;
use synthetica::solve::dependent::Dependence;
use synthetica::solve::free::Free;
use synthetica::solve::objective::objective;
use synthetica::solve::paper_matrix::{condition_rates, linearise, twist_of_rates};
use synthetica::solve::tangent::Tangent;
use synthetica::types::enumerate;

/// Step of first central differences: h² and 1e-16/h are then both some 1e-11.
const H: f64 = 1e-5;

/// The pose moved by the twist ξ: origin d + v, rotation exp(ω) R.
fn moved(pose: &Pose, xi: &Vector6<f64>) -> Pose {
    let omega = Vector3::new(xi[3], xi[4], xi[5]);
    let turn = nalgebra::UnitQuaternion::from_scaled_axis(omega);
    let d = pose.translation.vector + Vector3::new(xi[0], xi[1], xi[2]);
    Pose::from_parts(d.into(), turn * pose.rotation)
}

fn jacobian_agrees(chain: &Chain, theta: &[f64]) {
    let mut state = ChainState::default();
    chain.evaluate(theta, &mut state);
    for (j, column) in state.jacobian[..theta.len()].iter().enumerate() {
        let at = |h: f64| {
            let mut theta = theta.to_vec();
            theta[j] += h;
            chain.pose(&theta)
        };
        let rate = difference(&at(H), &at(-H)) / (2.0 * H);
        // (h²/6) ∂³: of a turn that is the column again. And the rounding of two poses.
        let bound = column.norm() * H * H / 6.0
            + 8.0 * f64::EPSILON * (1.0 + chain.reach() + state.pose.translation.vector.norm()) / H;
        let error = (rate - column).norm();
        assert!(
            error <= bound,
            "{} variable {j}: {error:e} > {bound:e}",
            chain.type_name()
        );
    }
    assert!(
        state.jacobian[theta.len()..]
            .iter()
            .all(|c| *c == Vector6::zeros())
    );
}

/// Eq. 15 for each kind alone, both signs of its inner twists and offsets in every place a row has.
#[test]
fn jacobians_of_single_joints() {
    let mut random = Random(15);
    for kind in JointKind::ALL {
        for signs in 0..8 {
            let mut rows = Joint::standard(kind).rows().to_vec();
            rows[0] = DhRow {
                alpha: 0.7,
                a: 0.4,
                theta: -0.3,
                d: 0.2,
            };
            for (i, row) in rows.iter_mut().enumerate().skip(1) {
                row.alpha = if signs >> i & 1 == 0 {
                    FRAC_PI_2
                } else {
                    -FRAC_PI_2
                };
            }
            if kind == JointKind::E && signs & 1 == 1 {
                rows[1].theta = -FRAC_PI_2;
            }
            let joint = Joint::new(kind, rows, vec![]).expect("rows of the kind");
            let c = Chain::new(
                "one".into(),
                random.pose(1.0, PI),
                vec![joint],
                random.pose(1.0, PI),
            )
            .expect("a chain");
            for _ in 0..10 {
                let theta: Vec<f64> = (0..kind.freedoms())
                    .map(|_| random.between(-PI, PI))
                    .collect();
                jacobian_agrees(&c, &theta);
                drawn_where_it_is(&c, &theta);
            }
        }
    }
}

/// Eq. 15 for every chain type at random positions.
#[test]
fn jacobians_of_all_chains() {
    let mut random = Random(1);
    let mut types = 0;
    for constraints in 1..=4 {
        for k in 0..enumerate::chain_count(constraints) {
            let kinds = enumerate::chain(constraints, k).expect("an index in range");
            let home = random.pose(1.0, PI);
            let (c, theta) = chain(&kinds, &home, &mut random);
            jacobian_agrees(&c, &theta);
            let elsewhere: Vec<f64> = theta
                .iter()
                .map(|t| t + random.between(-2.0, 2.0))
                .collect();
            jacobian_agrees(&c, &elsewhere);
            drawn_where_it_is(&c, &elsewhere);
            types += 1;
        }
    }
    assert_eq!(types, 214);
}

/// The frames for drawing, made of Eq. 1's screw displacements, end where the fast kinematics do.
fn drawn_where_it_is(c: &Chain, theta: &[f64]) {
    let (_, last) = c.frames(theta)[c.frames(theta).len() - 1];
    let error = difference(&(last * c.gripper()), &c.pose(theta)).norm();
    assert!(
        error < 1e-14 * (10.0 + c.reach() + theta.iter().map(|x| x.abs()).sum::<f64>()),
        "{}: {error:e}",
        c.type_name()
    );
}

/// Eq. 19–20: [J_E] q̇ is the twist and [C] q̇ = 0 along any motion; both are exact derivatives.
#[test]
fn rates_of_dual_quaternions() {
    let mut random = Random(19);
    for _ in 0..500 {
        let pose = random.pose(2.0, PI);
        let q = dual_quaternion(&pose, 1.0);
        let xi = Vector6::from_fn(|_, _| random.between(-1.0, 1.0));
        // So near that the quaternion keeps its sign.
        let at = |h: f64| dual_quaternion(&moved(&pose, &(xi * h)), 1.0);
        let rate = (at(H) - at(-H)) / (2.0 * H);
        assert!((twist_of_rates(&q) * rate - xi).norm() < 1e-9);
        assert!((condition_rates(&q) * rate).norm() < 1e-9);
        // The conditions are quadratic: central differences are exact but for rounding.
        let dq = SVector::<f64, 8>::from_fn(|_, _| random.between(-1.0, 1.0));
        let conditions = |q: &DualQuaternion| {
            let (r, d) = (q.fixed_rows::<4>(0), q.fixed_rows::<4>(4));
            nalgebra::Vector2::new(r.norm_squared() - 1.0, r.dot(&d))
        };
        let rate = (conditions(&(q + dq * H)) - conditions(&(q - dq * H))) / (2.0 * H);
        assert!((condition_rates(&q) * dq - rate).norm() < 1e-9);
    }
}

/// Dual quaternions and poses are each other's inverse, in any unit and with either sign.
#[test]
fn dual_quaternions_come_back() {
    let mut random = Random(20);
    for _ in 0..500 {
        let (pose, length) = (random.pose(3.0, PI), random.between(0.1, 10.0));
        let q = dual_quaternion(&pose, length);
        for q in [q, -q] {
            assert!(difference(&from_dual_quaternion(&q, length), &pose).norm() < 1e-13);
        }
        assert!(
            Metric {
                length,
                ..Metric::PAPER
            }
            .value(&pose, &pose)
                < 1e-28
        );
    }
}

/// Eq. 21 for all chain types: at closed loops [A] Δr is the change of E in every direction of r,
/// those that break the conditions on q included. E has the sign D(θ) − D(q).
#[test]
fn dense_matrix_is_the_derivative_of_the_residual() {
    let mut random = Random(21);
    for kinds in assemblies(&mut random) {
        let Linkage { mechanism, home } = linkage(&kinds, &mut random);
        let q = dual_quaternion(&mechanism.chains()[0].pose(&home), 1.0);
        let linear = linearise(mechanism.chains(), &home, &q);
        assert_eq!(linear.rows.len(), 6 * mechanism.chains().len() + 2);
        assert!(
            linear.residual.iter().all(|e| e.abs() < 1e-13),
            "closed at home"
        );
        for _ in 0..3 {
            let dr: Vec<f64> = (0..home.len() + 8)
                .map(|_| random.between(-1.0, 1.0))
                .collect();
            let at = |h: f64| {
                let theta: Vec<f64> = home.iter().zip(&dr).map(|(t, d)| t + h * d).collect();
                let dq = DualQuaternion::from_column_slice(&dr[home.len()..]);
                linearise(mechanism.chains(), &theta, &(q + dq * h)).residual
            };
            let (ahead, back) = (at(H), at(-H));
            for (i, row) in linear.rows.iter().enumerate() {
                let expected: f64 = row.iter().zip(&dr).map(|(a, d)| a * d).sum();
                let found = (ahead[i] - back[i]) / (2.0 * H);
                // Third derivatives are some (freedoms)³ times the size; rounding 1e-16/h.
                assert!(
                    (found - expected).abs() < 1e-8,
                    "row {i}: {found} for {expected}"
                );
            }
        }
    }
}

/// A closed path through `theta` along the joint rates `along`: its point at ±h, or None where the
/// loops do not close again.
fn on_closed_path(
    tangent: &mut Tangent,
    m: &Mechanism,
    theta: &[f64],
    along: &[f64],
    h: f64,
) -> Option<Pose> {
    let mut at: Vec<f64> = theta.iter().zip(along).map(|(t, r)| t + h * r).collect();
    let stops = vec![Stop::None; theta.len()];
    let (mut correction, mut step) = (Vec::new(), vec![0.0; theta.len()]);
    let mut last = f64::INFINITY;
    for _ in 0..12 {
        let open = tangent.evaluate(m.chains(), &at);
        // As closed as rounding allows: the second difference divides what is left by h².
        if open < 1e-12 && open >= 0.5 * last {
            break;
        }
        last = open;
        tangent
            .factor(&stops, Dependence::FOUND)
            .close(&mut correction, &mut step);
        at.iter_mut().zip(&step).for_each(|(t, s)| *t += s);
    }
    let astray = at
        .iter()
        .zip(theta)
        .zip(along)
        .map(|((a, t), r)| (a - t - h * r).abs())
        .fold(0.0, f64::max);
    // The path leaves its tangent by its curvature, which is some 1/σ.
    (last < 1e-12 && astray <= 0.1 * h.abs() + 1e-12).then(|| *tangent.pose())
}

/// The second derivative of `f` along the closed path, by fourth-order differences, and an estimate
/// of their error.
fn bend(
    tangent: &mut Tangent,
    m: &Mechanism,
    theta: &[f64],
    along: &[f64],
    f: &dyn Fn(&Pose) -> f64,
) -> Option<(f64, f64)> {
    let h = 4e-3 / along.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    let middle = f(&on_closed_path(tangent, m, theta, along, 0.0)?);
    let mut at = |h: f64| {
        let sides = [h, -h].map(|h| on_closed_path(tangent, m, theta, along, h));
        let [Some(ahead), Some(back)] = sides else {
            return None;
        };
        Some((f(&ahead) - 2.0 * middle + f(&back)) / (h * h))
    };
    let (wide, half, quarter) = (at(h)?, at(0.5 * h)?, at(0.25 * h)?);
    let (first, second) = ((4.0 * half - wide) / 3.0, (4.0 * quarter - half) / 3.0);
    Some((second, (second - first).abs() + 1e-14 / (h * h)))
}

/// Compares the reduced Hessian at `theta` with second differences of `f` along every free direction
/// and every sum of two. Counts (compared, left out because the position is singular).
fn second_order_agrees(
    m: &Mechanism,
    theta: &[f64],
    gradient: &dyn Fn(&Free<'_>) -> Vector6<f64>,
    hessian: &Matrix6<f64>,
    f: &dyn Fn(&Pose) -> f64,
) -> (usize, usize) {
    let mut tangent = Tangent::new(m.chains());
    tangent.evaluate(m.chains(), theta);
    let free = tangent
        .factor(&vec![Stop::None; theta.len()], Dependence::FOUND)
        .free();
    let pull = gradient(&free);
    let mut held = free.balance(&pull);
    let n = held.free().count();
    let mut reduced = Vec::new();
    held.reduced_hessian(hessian, &mut reduced);
    let rates: Vec<Vec<f64>> = (0..n).map(|i| held.free().rates(i).to_vec()).collect();
    let entry = |i: usize, j: usize| reduced[i.min(j) * n + i.max(j)];
    let (mut compared, mut singular) = (0, 0);
    for i in 0..n {
        for j in 0..=i {
            let (along, expected): (Vec<f64>, f64) = if i == j {
                (rates[i].clone(), entry(i, i))
            } else {
                let sum = rates[i].iter().zip(&rates[j]).map(|(a, b)| a + b).collect();
                (sum, entry(i, i) + 2.0 * entry(i, j) + entry(j, j))
            };
            let Some((found, error)) = bend(&mut tangent, m, theta, &along, f) else {
                singular += 1;
                continue;
            };
            let size = expected.abs().max(1.0);
            if error > 1e-4 * size {
                // A path so bent that its differences say nothing: close to a singular position.
                singular += 1;
                continue;
            }
            assert!(
                (found - expected).abs() <= 4.0 * error + 1e-7 * size,
                "directions {i}, {j}: {found} by differences (± {error:e}), {expected} by formula"
            );
            compared += 1;
        }
    }
    (compared, singular)
}

/// The constraints' own second-order term (errata, point 3): the work of a wrench that the chains
/// hold in balance, along closed paths from the home positions of linkages of all chain types.
#[test]
fn curvature_of_the_constraints() {
    let mut random = Random(3);
    let (mut compared, mut singular) = (0, 0);
    for kinds in assemblies(&mut random) {
        let Linkage { mechanism, home } = linkage(&kinds, &mut random);
        let wanted = Vector6::from_fn(|_, _| random.between(-1.0, 1.0));
        let start = mechanism.chains()[0].pose(&home);
        // What is left of a random wrench across all free twists: the part that the loops can hold.
        let held = |free: &Free<'_>| {
            let mut basis: Vec<Vector6<f64>> = Vec::new();
            for mut t in free.twists() {
                for _ in 0..2 {
                    basis.iter().for_each(|b| t -= b * b.dot(&t));
                }
                if t.norm() > 1e-9 {
                    basis.push(t.normalize());
                }
            }
            let mut left = wanted;
            for _ in 0..2 {
                basis.iter().for_each(|b| left -= b * b.dot(&left));
            }
            left
        };
        let mut tangent = Tangent::new(mechanism.chains());
        tangent.evaluate(mechanism.chains(), &home);
        let free = tangent
            .factor(&vec![Stop::None; home.len()], Dependence::FOUND)
            .free();
        let wrench = held(&free);
        // 2 sin(φ/2) times the axis is ω to third order: no second derivative of its own.
        let work = |pose: &Pose| wrench.dot(&difference(pose, &start));
        let (c, s) = second_order_agrees(&mechanism, &home, &held, &Matrix6::zeros(), &work);
        compared += c;
        singular += s;
    }
    assert!(compared > 700, "{compared} compared");
    assert!(
        singular * 20 < compared,
        "{singular} of {compared} too close to singular positions"
    );
}

/// The whole reduced Hessian where it counts: at the closest poses to goals off the workspace, for
/// linkages of all chain types and of one to five chains.
#[test]
fn second_derivative_of_the_distance() {
    let mut random = Random(31);
    let (mut compared, mut singular) = (0, 0);
    let mut by_chains = [0; 6];
    let mut all = assemblies(&mut random);
    for k in 1..=5 {
        // k chains of one constraint each.
        for _ in 0..5 {
            all.push(
                (0..k)
                    .map(|_| {
                        enumerate::chain(1, random.bits() % enumerate::chain_count(1))
                            .expect("an index")
                    })
                    .collect(),
            );
        }
    }
    for kinds in all {
        let l = linkage(&kinds, &mut random);
        let goals: Vec<Goal> = goals(&l, 5, &mut random);
        let t = plan(&l.mechanism, &l.home, &goals, &Settings::PAPER);
        for i in (0..5).filter(|&i| t.status[i].is_certified() && t.metric[i] > 1e-6) {
            let goal = goals[i].pose;
            let target = Metric::PAPER.target(&goal, &t.poses[i].rotation);
            let model = objective(&t.poses[i], &target);
            let f = |pose: &Pose| target.value(pose);
            let (c, s) = second_order_agrees(
                &l.mechanism,
                t.joints_at(i),
                &|_| model.gradient,
                &model.hessian,
                &f,
            );
            compared += c;
            singular += s;
            by_chains[kinds.len()] += c;
        }
    }
    assert!(compared > 3000, "{compared} compared");
    assert!(by_chains[1..].iter().all(|c| *c > 10), "{by_chains:?}");
    assert!(
        singular * 10 < compared,
        "{singular} of {compared} too close to singular positions"
    );
}
