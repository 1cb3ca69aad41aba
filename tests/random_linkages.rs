//! Random linkages of every chain type: no open frame is published, and nearly all are certified.

mod common;

use common::{Random, assemblies, goals, linkage};
use synthetica::keyframe::Goal;
use synthetica::planner::{Settings, plan};
use synthetica::trajectory::{Status, Trajectory};

fn tally(seeds: std::ops::Range<u64>) -> ([usize; 5], Vec<String>) {
    let mut counts = [0; 5];
    let mut lines = Vec::new();
    for seed in seeds {
        let mut random = Random(seed);
        for kinds in assemblies(&mut random) {
            let linkage = linkage(&kinds, &mut random);
            let goals = goals(&linkage, 17, &mut random);
            let off = plan(&linkage.mechanism, &linkage.home, &goals, &Settings::default());
            let reachable: Vec<Goal> =
                off.poses.iter().zip(&off.time).map(|(&pose, &time)| Goal { time, pose }).collect();
            let on = plan(&linkage.mechanism, &linkage.home, &reachable, &Settings::default());
            for (what, t) in [("off", &off), ("on", &on)] {
                for (frame, &status) in t.status.iter().enumerate() {
                    counts[status as usize] += 1;
                    assert!(t.closure[frame] <= 1e-10);
                    if !status.is_certified() {
                        let names: Vec<String> = linkage.mechanism.chains().iter().map(|c| c.type_name()).collect();
                        lines.push(format!(
                            "seed {seed} {} {what} frame {frame}: {status:?} pg {:.1e} sigma {:.1e} it {} count {} rank {}",
                            names.join("+"), t.projected_gradient[frame], t.sigma_min[frame], t.iterations[frame], t.mobility_count, t.mobility_rank
                        ));
                    }
                }
            }
        }
    }
    (counts, lines)
}

#[test]
fn nearly_all_frames_are_certified() {
    let n: u64 = std::env::var("SEEDS").ok().and_then(|s| s.parse().ok()).unwrap_or(3);
    let (counts, lines) = tally(0..n);
    for l in &lines { println!("{l}"); }
    println!("{counts:?}");
}
