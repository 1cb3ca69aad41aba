//! Linkages that move although a count of their freedoms says otherwise, by the exact formulas of the literature, as
//! axes in one position. Lengths are of the order of 1.

use super::by_axes::{Line, chain};
use nalgebra::{Point3, Translation3, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};
use synthetica::mechanism::Mechanism;
use synthetica::pose::Pose;

/// A linkage in one position.
pub struct Overconstrained {
    pub name: &'static str,
    /// Joint letters and axes of each chain.
    pub chains: Vec<(String, Vec<Line>)>,
    /// Freedoms that the linkage has indeed.
    pub mobility: usize,
    /// How far joint variable 0 can be driven at least, rad.
    pub drive: f64,
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

impl Overconstrained {
    /// The linkage `scale` times as large and moved to `place`; its workpiece at `home` as drawn, with all joint
    /// variables 0 there.
    pub fn mechanism(&self, home: &Pose, place: &Pose, scale: f64) -> Mechanism {
        let placed = |&(point, axis): &Line| -> Line {
            let point = place * (Point3::from(point) * scale);
            (point.into(), (place * Vector3::from(axis)).into())
        };
        let mut home = *home;
        home.translation.vector *= scale;
        let chains = self.chains.iter().map(|(letters, lines)| {
            let lines: Vec<Line> = lines.iter().map(placed).collect();
            chain(letters, &lines, &(place * home))
        });
        Mechanism::new(chains.collect()).expect("a mechanism")
    }
}

/// All of them; some linkages are there twice, with the workpiece on another link.
pub fn linkages() -> Vec<Overconstrained> {
    let four = planar(&[[0.0, 0.0], [0.5, 0.9], [2.6, 1.4], [3.0, 0.0]]);
    let rocker = planar(&[[0.0, 0.0], [0.1, 0.6], [2.0, 1.5], [2.2, 0.0]]);
    let double_crank = planar(&[[0.0, 0.0], [-0.4, 1.6], [1.3, 2.0], [0.6, 0.0]]);
    let double_rocker = planar(&[[0.0, 0.0], [0.7, 1.8], [1.5, 1.7], [2.5, 0.0]]);
    let parallelogram = planar(&[[0.0, 0.0], [0.4, 0.9], [2.4, 1.0], [2.0, 0.1]]);
    let rhombus = planar(&[[0.0, 0.0], [0.8, 0.6], [1.8, 0.6], [1.0, 0.0]]);
    let kite = planar(&[[0.0, 0.0], [0.0, 1.0], [1.5, 1.5], [1.0, 0.0]]);
    let one = |name, letters, lines: &[Line], split, mobility, drive| Overconstrained {
        name,
        chains: split_loop(letters, lines, split),
        mobility,
        drive,
    };
    let mut all = vec![
        one("planar 4R", "RRRR", &four, 2, 1, 0.5),
        one("planar 4R, crank and rocker", "RRRR", &rocker, 3, 1, 0.6),
        one("planar 4R, two cranks", "RRRR", &double_crank, 2, 1, 0.6),
        one("planar 4R, two rockers", "RRRR", &double_rocker, 1, 1, 0.35),
        one("parallelogram", "RRRR", &parallelogram, 2, 1, 0.5),
        one("rhombus", "RRRR", &rhombus, 3, 1, 0.4),
        one("kite", "RRRR", &kite, 2, 1, 0.5),
    ];
    let spherical = |directions: &[[f64; 3]]| directions.iter().map(|&d| ([0.0; 3], d)).collect();
    let wide: Vec<Line> = spherical(&[Z, [0.5, 0.2, 1.0], [0.8, 0.9, 0.7], [1.0, -0.2, 0.3]]);
    let narrow: Vec<Line> = spherical(&[Z, [0.3, 0.1, 1.0], [0.5, 0.5, 1.0], [0.1, 0.6, 1.0]]);
    let cardan: Vec<Line> = spherical(&[Z, X, [0.0, 1.0, -0.5], [0.0, 0.5, 1.0]]);
    all.extend([
        one("spherical 4R", "RRRR", &wide, 2, 1, 0.5),
        one("spherical 4R, RRR and R", "RRRR", &wide, 3, 1, 0.5),
        one("spherical 4R, narrow", "RRRR", &narrow, 2, 1, 0.4),
        one("Cardan's joint", "RRRR", &cardan, 2, 1, 0.6),
    ]);
    let isogram = isogram([1.0, 0.0, 0.4], [0.3, 0.8, -0.4]);
    let steep = self::isogram([1.2, 0.1, 0.7], [-0.2, 0.6, -0.7]);
    let frames = bennett(FRAC_PI_2, 1.0, PI / 6.0, 1.9);
    let oblique = bennett(1.1, 1.2, 0.5, -1.4);
    all.extend([
        one("Bennett, isogram", "RRRR", &isogram, 2, 1, 0.5),
        one("Bennett, steep isogram", "RRRR", &steep, 3, 1, 0.5),
        one("Bennett", "RRRR", &frames.map(|f| axis(&f)), 2, 1, 0.6),
        one(
            "Bennett, oblique",
            "RRRR",
            &oblique.map(|f| axis(&f)),
            3,
            1,
            0.4,
        ),
        one("Goldberg 5R", "RRRRR", &goldberg(0.8, 1.5), 3, 1, 0.4),
        one(
            "Goldberg 5R, RR and RRR",
            "RRRRR",
            &goldberg(1.2, -1.2),
            2,
            1,
            0.4,
        ),
        one("Sarrus", "RRRRRR", &sarrus(90.0), 3, 1, 0.4),
        one(
            "Sarrus, planes at 65 degrees",
            "RRRRRR",
            &sarrus(65.0),
            3,
            1,
            0.4,
        ),
        one(
            "Bricard, line-symmetric",
            "RRRRRR",
            &line_symmetric(),
            3,
            1,
            0.4,
        ),
        one(
            "Bricard, line-symmetric, RRRR and RR",
            "RRRRRR",
            &line_symmetric(),
            4,
            1,
            0.4,
        ),
        one(
            "Bricard, plane-symmetric",
            "RRRRRR",
            &plane_symmetric(),
            3,
            1,
            0.35,
        ),
        one("Bricard, threefold", "RRRRRR", &threefold(), 3, 1, 0.35),
    ]);
    let five = planar(&[[0.0, 0.0], [-0.3, 1.0], [0.9, 1.6], [2.2, 0.9], [1.8, 0.0]]);
    let slider = |offset: f64| {
        let mut lines = planar(&[[0.0, 0.0], [0.4, 0.7], [2.2, offset]]);
        lines.push(([2.2, offset, 0.0], X));
        lines
    };
    let mut inverted = planar(&[[0.0, 0.0], [0.5, 0.6]]);
    inverted.push(([0.5, 0.6, 0.0], [1.3, -0.6, 0.0]));
    inverted.extend(planar(&[[1.8, 0.0]]));
    all.extend([
        one("planar 5R, RRR and RR", "RRRRR", &five, 3, 2, 0.4),
        one("planar 5R, RR and RRR", "RRRRR", &five, 2, 2, 0.4),
        one("slider and crank", "RRRP", &slider(0.0), 3, 1, 0.6),
        one("slider and crank, offset", "RRRP", &slider(0.3), 2, 1, 0.6),
        one("slider on a rocker", "RRPR", &inverted, 2, 1, 0.4),
    ]);
    let crank = |[x, y]: [f64; 2]| ("RR".to_owned(), planar(&[[x, y], [x + 0.4, y + 0.9]]));
    let arm = |points: [[f64; 2]; 3]| ("RRR".to_owned(), planar(&points));
    all.extend([
        Overconstrained {
            name: "parallelogram with three cranks",
            chains: vec![crank([0.0, 0.0]), crank([2.0, 0.1]), crank([1.1, -0.5])],
            mobility: 1,
            drive: 0.5,
        },
        Overconstrained {
            name: "planar 3-RRR",
            chains: vec![
                arm([[0.0, 0.0], [0.1, 0.7], [0.8, 0.6]]),
                arm([[2.0, 0.0], [2.1, 0.8], [1.3, 0.6]]),
                arm([[1.0, 2.2], [1.6, 1.7], [1.0, 1.1]]),
            ],
            mobility: 3,
            drive: 0.35,
        },
    ]);
    all
}

/// Two chains of a loop of joints: the first `split`, and the others from the other end.
fn split_loop(letters: &str, lines: &[Line], split: usize) -> Vec<(String, Vec<Line>)> {
    let there = (letters[..split].to_owned(), lines[..split].to_vec());
    let letters = letters[split..].chars().rev().collect();
    vec![
        there,
        (letters, lines[split..].iter().rev().copied().collect()),
    ]
}

fn planar(points: &[[f64; 2]]) -> Vec<Line> {
    points.iter().map(|&[x, y]| ([x, y, 0.0], Z)).collect()
}

/// Bennett's linkage as a skew isogram: corners one, two and their images by a half turn about z, axes across them.
fn isogram([a, b, c]: [f64; 3], [d, e, f]: [f64; 3]) -> [Line; 4] {
    let corners = [[a, b, c], [d, e, f], [-a, -b, c], [-d, -e, f]];
    let at = |i: usize| Vector3::from(corners[i % 4]);
    [0, 1, 2, 3].map(|i| {
        let axis = (at(i + 1) - at(i)).cross(&(at(i + 3) - at(i)));
        (corners[i], axis.into())
    })
}

/// Rotation about x by `alpha` and shift along it by `a`.
fn link(alpha: f64, a: f64) -> Pose {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), alpha);
    Pose::from_parts(Translation3::new(a, 0.0, 0.0), turn)
}

fn turn(theta: f64) -> Pose {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), theta);
    Pose::from_parts(Translation3::identity(), turn)
}

fn axis(frame: &Pose) -> Line {
    let z = frame.rotation * Vector3::z();
    (frame.translation.vector.into(), z.into())
}

/// Bennett's linkage by twists and lengths, a / sin α = b / sin β (Bennett, A new mechanism, 1903): the frames of its
/// four joints, seen from the first link, at the first joint angle `theta`.
fn bennett(alpha: f64, a: f64, beta: f64, theta: f64) -> [Pose; 4] {
    let b = a * libm::sin(beta) / libm::sin(alpha);
    let product = libm::sin(0.5 * (beta + alpha)) / libm::sin(0.5 * (beta - alpha));
    let phi = 2.0 * libm::atan(product / libm::tan(0.5 * theta));
    let second = link(alpha, a);
    let third = second * turn(phi) * link(beta, b);
    let fourth = third * turn(-theta) * link(alpha, a);
    let back = fourth * turn(-phi) * link(beta, b) * turn(theta);
    let open = back.to_homogeneous() - Pose::identity().to_homogeneous();
    assert!(open.norm() < 1e-14, "Bennett's loop is open by {open}");
    [Pose::identity(), second, third, fourth]
}

/// Two of Bennett's linkages with one link in common, which is left out, and their links at its one end made one
/// (Goldberg, New five-bar and six-bar linkages in three dimensions, 1943).
fn goldberg(first: f64, second: f64) -> [Line; 5] {
    let [_, q, a2, a3] = bennett(PI / 3.0, 1.0, 0.5, first);
    let [_, _, b2, b3] = bennett(PI / 3.0, 1.0, 1.4, second);
    [a3, b3, b2, q, a2].map(|f| axis(&f))
}

/// Two planar arms in planes at this angle: the platform rises without turning (Sarrus, 1853).
fn sarrus(degrees: f64) -> Vec<Line> {
    let arm = |points: [[f64; 2]; 3], degrees: f64| {
        let (s, c) = libm::sincos(degrees.to_radians());
        points.map(|[r, z]| ([r * c, r * s, z], [-s, c, 0.0]))
    };
    let up = arm([[1.0, 0.0], [1.4, 0.5], [1.0, 1.0]], 0.0);
    let mut down = arm([[1.0, 0.0], [1.5, 0.4], [0.9, 1.0]], degrees);
    down.reverse();
    [up, down].concat()
}

/// Three axes and their images by a half turn about z (Bricard, 1897).
fn line_symmetric() -> Vec<Line> {
    let lines: [Line; 3] = [
        ([1.0, 0.1, -0.3], [0.2, 0.9, 0.4]),
        ([0.8, 0.7, 0.5], [-0.5, 0.3, 0.8]),
        ([0.1, 1.1, 0.2], [0.9, 0.4, -0.1]),
    ];
    let turned = lines.map(|([x, y, z], [u, v, w])| ([-x, -y, z], [-u, -v, w]));
    [lines, turned].concat()
}

/// Two axes in the plane y = 0, and two between them on each side, the ones mirrored from the others (Bricard, 1897).
fn plane_symmetric() -> Vec<Line> {
    let (first, last) = (
        ([1.2, 0.0, 0.1], [0.3, 0.0, 1.0]),
        ([-1.0, 0.0, 0.3], [0.8, 0.0, 0.7]),
    );
    let second: Line = ([0.8, 0.9, 0.4], [-0.6, 0.5, 0.4]);
    let third: Line = ([-0.4, 1.0, -0.2], [0.3, 0.9, 0.5]);
    let mirrored = |([x, y, z], [u, v, w]): Line| ([x, -y, z], [u, -v, w]);
    vec![
        first,
        second,
        third,
        last,
        mirrored(third),
        mirrored(second),
    ]
}

/// Six axes in three planes through z, alike in turn: plane-symmetric three times over.
fn threefold() -> Vec<Line> {
    let line = |i: usize| {
        let (s, c) = libm::sincos(i as f64 * PI / 3.0);
        let (radius, height, (tilt, upright)) = if i.is_multiple_of(2) {
            (1.0, 0.2, (0.6, 0.8))
        } else {
            (0.8, -0.3, (-0.8, 0.6))
        };
        (
            [radius * c, radius * s, height],
            [tilt * c, tilt * s, upright],
        )
    };
    (0..6).map(line).collect()
}
