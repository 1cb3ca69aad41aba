use synthetica::document::{problem::Problem, text};
use synthetica::plan::follow::Planning;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let text = std::fs::read_to_string(&a[1]).unwrap();
    let frame: usize = a[2].parse().unwrap();
    let p = Problem::new(&text::parse(&text).unwrap()).unwrap();
    let mut pl = Planning::new(&p.mechanism, &p.find_start(), &p.goals, &p.settings);
    while pl.done() < frame && pl.advance() {}
    let t = pl.so_far();
    let from = if frame > 0 { t.joints_at(frame - 1).to_vec() } else { t.start.clone() };
    let mut s = p.settings.solver(&p.mechanism, p.extent());
    let mut j = from.clone();
    println!("{:?} size {} tol {:?}", s.close_start(&mut j, 3e-4), s.scaled().unit(), s.tolerances());
    let pr = j.clone();
    let r = s.solve_watched(&p.goals[frame].pose, &mut j, &pr, &mut |i| println!("g {:e} open {:e} guarded {} {:?}", i.projected_gradient, i.closure_error, i.guarded, i.theta));
    println!("{r:?}");
}
