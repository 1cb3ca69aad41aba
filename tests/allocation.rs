//! The Newton solver does not allocate once its buffers have grown.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{Random, assemblies, goals, linkage};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};
use std::alloc::System;
use synthetica::model::chain::ChainState;
use synthetica::model::mechanism::Mechanism;
use synthetica::plan::settings::Settings;
use synthetica::solve::close_start::Start;
use synthetica::solve::singular_values::SingularValues;

#[global_allocator]
static GLOBAL: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Allocations of runs over the same motion after a first one: the fewest of three, since the test
/// harness's own thread is counted too.
fn allocations(
    mechanism: &Mechanism,
    start: &[f64],
    goals: &[synthetica::motion::goal::Goal],
) -> usize {
    let mut solver = Settings::PAPER.solver(mechanism, 1.0);
    let mut joints = start.to_vec();
    let mut predicted = start.to_vec();
    assert_eq!(solver.close_start(&mut joints, 0.0), Start::Closed);
    let mut run = |joints: &mut Vec<f64>| {
        for goal in goals {
            predicted.copy_from_slice(joints);
            solver.solve(&goal.pose, joints, &predicted);
        }
    };
    run(&mut joints);
    let again = (0..3).map(|_| {
        joints.copy_from_slice(start);
        let region = Region::new(GLOBAL);
        run(&mut joints);
        region.change().allocations
    });
    again.min().unwrap_or(usize::MAX)
}

/// Allocations of one more call: the fewest of three, as above.
fn allocations_of_singular_values(linkage: &common::Linkage, surplus: usize) -> usize {
    let mut state = ChainState::default();
    let jacobians: Vec<_> = linkage
        .mechanism
        .split(&linkage.home)
        .map(|(chain, theta)| {
            chain.evaluate(theta, &mut state);
            state.jacobian[..theta.len()].to_vec()
        })
        .collect();
    let mut values = SingularValues::default();
    let mut smallest = || values.smallest(jacobians.iter().map(Vec::as_slice), surplus);
    smallest();
    let again = (0..3).map(|_| {
        let region = Region::new(GLOBAL);
        smallest();
        region.change().allocations
    });
    again.min().unwrap_or(usize::MAX)
}

/// One test, so that no other test allocates meanwhile.
#[test]
fn a_frame_allocates_nothing() {
    let region = Region::new(GLOBAL);
    drop(vec![0_u8; 100]);
    assert!(region.change().allocations > 0, "the counter counts");
    for task in common::golden::tasks() {
        assert_eq!(
            allocations(&task.mechanism, &task.start, &task.goals),
            0,
            "{}",
            task.name
        );
    }
    let mut random = Random(5);
    for kinds in assemblies(&mut random) {
        let linkage = linkage(&kinds, &mut random);
        let goals = goals(&linkage, 9, &mut random);
        assert_eq!(
            allocations(&linkage.mechanism, &linkage.home, &goals),
            0,
            "{kinds:?}"
        );
        for surplus in [0, 2] {
            let found = allocations_of_singular_values(&linkage, surplus);
            assert_eq!(found, 0, "{kinds:?}");
        }
    }
}
