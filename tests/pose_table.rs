//! Tables of poses as key frames: every convention, every way to write a table, and what cannot be taken over.

use serde_json::{Value, json};
use synthetica::document::fault::FaultCode;
use synthetica::document::problem::Problem;
use synthetica::document::schema::KeyFrameEntry;
use synthetica::document::text::parse;
use synthetica::exchange::delimited::Separator;
use synthetica::exchange::export::{Format, Options, write};
use synthetica::exchange::pose_columns::Convention;
use synthetica::exchange::pose_table::{
    AngleUnit, PoseTable, PoseTableRequest, read_pose_table, read_pose_table_asked,
};
use synthetica::exchange::table::Headings;
use synthetica::math::pose::{FrameCoordinates, Pose, gaps};
use synthetica::motion::goal::MAX_FRAMES;
use synthetica::motion::key_frames::MAX_KEY_FRAMES;

fn read(text: &str) -> PoseTable {
    read_pose_table(text, &PoseTableRequest::default())
        .unwrap_or_else(|fault| panic!("{text}: {fault}"))
}

fn asked(text: &str, request: &Value) -> PoseTable {
    read_pose_table_asked(text, &request.to_string())
        .unwrap_or_else(|fault| panic!("{text}: {fault}"))
}

fn pose(key: &KeyFrameEntry) -> Pose {
    FrameCoordinates {
        x: key.x,
        y: key.y,
        z: key.z,
        longitude: key.longitude.to_radians(),
        latitude: key.latitude.to_radians(),
        roll: key.roll.to_radians(),
    }
    .pose()
}

/// One pose in every convention: 30° about x, then 40° about the fixed y, then 50° about the fixed z.
struct Written {
    position: [f64; 3],
    pose: Pose,
    /// w x y z
    quaternion: [f64; 4],
    matrix: [[f64; 3]; 3],
    llr: [f64; 3],
}

fn written() -> Written {
    let (sx, cx) = libm::sincos(30_f64.to_radians());
    let (sy, cy) = libm::sincos(40_f64.to_radians());
    let (sz, cz) = libm::sincos(50_f64.to_radians());
    // Rz Ry Rx, written out.
    let matrix = [
        [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
        [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
        [-sy, cy * sx, cy * cx],
    ];
    // From the matrix to a quaternion where the scalar is not small.
    let w = 0.5 * (1.0 + matrix[0][0] + matrix[1][1] + matrix[2][2]).sqrt();
    let part = |i: usize, j: usize| (matrix[i][j] - matrix[j][i]) / (4.0 * w);
    let quaternion = [w, part(2, 1), part(0, 2), part(1, 0)];
    // Third column (sin λ cos β, sin β, cos λ cos β), second row cos β (sin ρ, cos ρ, ·).
    let llr = [
        libm::atan2(matrix[0][2], matrix[2][2]).to_degrees(),
        libm::asin(matrix[1][2]).to_degrees(),
        libm::atan2(matrix[1][0], matrix[1][1]).to_degrees(),
    ];
    let position = [100.0, -20.5, 3.25];
    let [x, y, z] = position;
    let key = KeyFrameEntry {
        x,
        y,
        z,
        longitude: llr[0],
        latitude: llr[1],
        roll: llr[2],
        ..KeyFrameEntry::default()
    };
    Written {
        position,
        pose: pose(&key),
        quaternion,
        matrix,
        llr,
    }
}

fn line(lists: &[&[f64]], separator: &str) -> String {
    lists
        .concat()
        .iter()
        .map(f64::to_string)
        .collect::<Vec<_>>()
        .join(separator)
}

#[track_caller]
fn is_that_pose(table: &PoseTable) {
    let key = &table.key_frames[0];
    let (shift, turn) = gaps(&pose(key), &written().pose);
    assert!(
        shift < 1e-12 && turn < 1e-9,
        "{key:?}: {shift:e}, {turn:e} rad away"
    );
}

#[test]
fn every_convention_gives_the_same_pose() {
    let Written {
        position,
        quaternion: [w, x, y, z],
        matrix,
        llr,
        ..
    } = written();
    let in_rows_of_4: Vec<f64> = (0..3)
        .flat_map(|i| [matrix[i][0], matrix[i][1], matrix[i][2], position[i]])
        .collect();
    let rad = |degrees: f64| degrees.to_radians();
    let cases: [(Vec<f64>, Value); 12] = [
        ([&position[..], &llr].concat(), json!({})),
        (
            [&position[..], &llr].concat(),
            json!({"convention": "longitude_latitude_roll"}),
        ),
        (
            [&position[..], &llr.map(rad)].concat(),
            json!({"angles": "radians"}),
        ),
        ([&position[..], &[x, y, z, w]].concat(), json!({})),
        (
            [&position[..], &[x, y, z, w]].concat(),
            json!({"convention": "quaternion_xyzw"}),
        ),
        (
            [&position[..], &[w, x, y, z]].concat(),
            json!({"convention": "quaternion_wxyz"}),
        ),
        (
            [&position[..], matrix.as_flattened()].concat(),
            json!({"convention": "matrix"}),
        ),
        (in_rows_of_4.clone(), json!({})),
        (
            [&in_rows_of_4[..], &[0.0, 0.0, 0.0, 1.0]].concat(),
            json!({}),
        ),
        (
            [&position[..], &[30.0, 40.0, 50.0]].concat(),
            json!({"convention": "roll_pitch_yaw"}),
        ),
        (
            [&position[..], &[50.0, 40.0, 30.0]].concat(),
            json!({"convention": "roll_pitch_yaw", "order": "ZYX"}),
        ),
        (
            [&position.map(|x| x / 1000.0)[..], &llr].concat(),
            json!({"scale": 1000}),
        ),
    ];
    for (numbers, request) in &cases {
        let row = line(&[numbers], ",");
        let table = asked(&row, request);
        is_that_pose(&table);
        assert_eq!(
            (
                table.skipped_count,
                table.understood.header,
                table.understood.time
            ),
            (0, false, false)
        );
        // The same with a time and a name, and over two rows.
        let timed = format!("start,0,{row}\nend,1.5,{row}");
        let table = asked(&timed, request);
        is_that_pose(&table);
        assert_eq!(table.key_frames[1].time, Some(1.5), "{request}");
        assert_eq!(table.key_frames[1].name, "end");
    }
}

#[test]
fn headings_say_what_columns_are_in_any_order() {
    let Written {
        position: [x, y, z],
        quaternion: [qw, qx, qy, qz],
        matrix,
        llr,
        ..
    } = written();
    let m = matrix.as_flattened();
    for (headings, numbers) in [
        (
            "x,y,z,longitude,latitude,roll",
            vec![x, y, z, llr[0], llr[1], llr[2]],
        ),
        (
            "roll [deg],z,y,x,Latitude (deg),Longitude [deg]",
            vec![llr[2], z, y, x, llr[1], llr[0]],
        ),
        ("x,y,z,qw,qx,qy,qz", vec![x, y, z, qw, qx, qy, qz]),
        ("x,y,z,qx,qy,qz,qw", vec![x, y, z, qx, qy, qz, qw]),
        ("x,y,z,w,x,y,z", vec![x, y, z, qw, qx, qy, qz]),
        (
            "Pos X,Pos Y,Pos Z,rx,ry,rz",
            vec![x, y, z, 30.0, 40.0, 50.0],
        ),
        ("yaw,pitch,roll,x,y,z", vec![50.0, 40.0, 30.0, x, y, z]),
        (
            "rx[rad],ry[rad],rz[rad],x[mm],y[mm],z[mm]",
            vec![
                30_f64.to_radians(),
                40_f64.to_radians(),
                50_f64.to_radians(),
                x,
                y,
                z,
            ],
        ),
        (
            "x,y,z,r11,r12,r13,r21,r22,r23,r31,r32,r33",
            [&[x, y, z][..], m].concat(),
        ),
        (
            "m00,m01,m02,m10,m11,m12,m20,m21,m22,x,y,z",
            [m, &[x, y, z][..]].concat(),
        ),
    ] {
        let table = read(&format!("{headings}\n{}\n", line(&[&numbers], ",")));
        is_that_pose(&table);
        assert!(table.understood.header, "{headings}");
        assert!(
            table
                .understood
                .columns
                .iter()
                .all(|column| !column.role.is_empty()),
            "{headings}"
        );
    }
    let table = read("name,t,x,y,z,force\nA,0,1,2,3,9\nB,2,1,2,4,9\n");
    assert_eq!(table.understood.convention, Convention::Positions);
    assert_eq!(table.understood.columns[5].role, "");
    assert_eq!(
        (
            &*table.key_frames[1].name,
            table.key_frames[1].time,
            table.key_frames[1].z
        ),
        ("B", Some(2.0), 4.0)
    );
    // Asked to leave the times out.
    let table = asked(
        "name,t,x,y,z\nA,5,1,2,3\nB,2,1,2,4\n",
        &json!({"time": false}),
    );
    assert_eq!(
        (table.key_frames.len(), table.key_frames[0].time),
        (2, None)
    );
}

#[test]
fn every_way_to_write_a_table_is_read() {
    let plain = read("1.5 -2.5 1000").key_frames;
    for (text, separator) in [
        ("\u{feff}x\ty\tz\r\n1,5\t-2,5\t1e3\r\n", Separator::Tab),
        ("1,5;\u{2212}2,5;1000", Separator::Semicolon),
        ("x;y;z;\n1.5;-2.5;1000;\n", Separator::Semicolon),
        (
            "# a comment\n\n1.5, -2.5, +1000\n# another\n",
            Separator::Comma,
        ),
        ("  1,5   -2,5   1000  ", Separator::Blanks),
        ("\"1.5\",\"-2.5\",\"1000\"", Separator::Comma),
        ("x y z\r1.5 -2.5 1000\r", Separator::Blanks),
    ] {
        let table = read(text);
        assert_eq!(table.key_frames, plain, "{text}");
        assert_eq!(
            (table.understood.separator, table.skipped_count),
            (separator, 0),
            "{text}"
        );
    }
    let named = read("\"a, \"\"b\"\"\",1,2,3");
    assert_eq!(named.key_frames[0].name, "a, \"b\"");
}

#[test]
fn a_guess_is_told() {
    let sixes = read("1 2 3 10 20 30");
    assert_eq!(
        sixes.understood.convention,
        Convention::LongitudeLatitudeRoll
    );
    assert!(
        sixes
            .understood
            .assumed
            .iter()
            .any(|said| said.contains("may be roll, pitch and yaw"))
    );
    assert!(
        sixes
            .understood
            .assumed
            .iter()
            .any(|said| said.contains("degrees"))
    );
    let sevens = read("1 2 3 0 0 0.6 0.8");
    assert_eq!(sevens.understood.convention, Convention::QuaternionXyzw);
    assert!(
        sevens
            .understood
            .assumed
            .iter()
            .any(|said| said.contains("scalar last"))
    );
    // Four numbers that are no unit quaternion: a time and six.
    let timed = read("0 1 2 3 10 20 30\n1 1 2 4 10 20 30");
    assert_eq!(
        (timed.understood.convention, timed.understood.time),
        (Convention::LongitudeLatitudeRoll, true)
    );
    assert!(
        timed
            .understood
            .assumed
            .iter()
            .any(|said| said.contains("time"))
    );
    // Headings that say it leave nothing to assume.
    assert_eq!(
        read("x,y,z,qw,qx,qy,qz\n1,2,3,1,0,0,0").understood.assumed,
        [""; 0]
    );
    let unread = read("x;y;z;a;b;c\n1;2;3;4;5;6");
    assert!(unread.understood.assumed[0].contains("No headings of rotations"));
    let nearly = read("x,y,z,qw,qx,qy,qz\n1,2,3,1.0005,0,0,0");
    assert!(
        nearly.understood.assumed[0].contains("5.0e-4"),
        "{:?}",
        nearly.understood.assumed
    );
}

#[test]
fn what_cannot_be_taken_over_is_listed_and_the_rest_is_read() {
    let text = "name,time,x,y,z,qw,qx,qy,qz
good,0,1,2,3,1,0,0,0
word,1,one,2,3,1,0,0,0
short,1,1,2
long,1,1,2,3,1,0,0,0,7
empty,1,1,,3,1,0,0,0
not finite,1,nan,2,3,1,0,0,0
far,1,1e13,2,3,1,0,0,0
quaternion,1,1,2,3,1,1,0,0
zero,1,1,2,3,0,0,0,0
again,0,1,2,3,1,0,0,0
\"open,1,1,2,3,1,0,0,0
good,1,1,2,3,0.9995,0,0,0
";
    let table = read(text);
    assert_eq!(table.key_frames.len(), 2);
    let said: Vec<(usize, &str)> = table.skipped.iter().map(|s| (s.row, &*s.what)).collect();
    let expected = [
        (3, "\u{201c}one\u{201d} in column 3 is no number"),
        (4, "column 5 is empty"),
        (5, "it has 10 columns"),
        (6, "column 4 is empty"),
        (7, "\u{201c}nan\u{201d} in column 3 is no number"),
        (8, "1e13 is out of range"),
        (9, "the quaternion has the length 1.4142"),
        (10, "the quaternion has the length 0"),
        (11, "its time 0 is not later than 0, that of the row before"),
        (12, "a quotation mark is not closed"),
    ];
    assert_eq!(said, expected);
    assert_eq!(table.skipped_count, expected.len());
    assert!(table.skipped.iter().all(|s| !s.accepted.is_empty()));
    // Matrices.
    let matrices =
        read("1 0 0 1 0 1 0 2 0 0 1 3\n1 0 0 1 0 1 0 2 0 0 -1 3\n2 0 0 1 0 1 0 2 0 0 1 3");
    assert!((matrices.key_frames[0].z - 3.0).abs() < 1e-15);
    assert!(matrices.skipped[0].what.contains("mirrors"));
    assert!(matrices.skipped[1].what.contains("no rotation"));
}

#[test]
fn complaints_are_counted_beyond_a_hundred() {
    let rows: String = (0..300)
        .map(|i| if i % 2 == 0 { "1 2 3\n" } else { "1 2 x\n" })
        .collect();
    let table = read(&rows);
    assert_eq!(
        (
            table.key_frames.len(),
            table.skipped.len(),
            table.skipped_count
        ),
        (150, 100, 150)
    );
    let many: String = (0..MAX_KEY_FRAMES + 5)
        .map(|i| format!("{i} 2 3\n"))
        .collect();
    let table = read(&many);
    assert_eq!(
        (table.key_frames.len(), table.skipped_count),
        (MAX_KEY_FRAMES, 5)
    );
    assert_eq!(table.skipped[0].row, MAX_KEY_FRAMES + 1);
}

#[test]
fn tables_that_cannot_be_told_are_faults_that_name_what_is_accepted() {
    for (text, code) in [
        ("", FaultCode::EmptyText),
        ("# only\n\n", FaultCode::EmptyText),
        ("1 2", FaultCode::WrongCount),
        ("1 2 3 4 5", FaultCode::WrongCount),
        ("a,b,c\nd,e,f", FaultCode::WrongCount),
        ("x,y,z\n", FaultCode::WrongType),
        ("x,y,z\n1,2,what", FaultCode::WrongType),
    ] {
        let fault = read_pose_table(text, &PoseTableRequest::default()).expect_err(text);
        assert_eq!(
            (fault.code, &*fault.place),
            (code, "table"),
            "{text}: {fault}"
        );
    }
    for (request, place) in [
        ("{\"order\": \"xyq\"}", "order"),
        ("{\"scale\": 0}", "scale"),
        ("{\"time\": 1}", "time"),
        ("{\"convention\": \"euler\"}", "convention"),
        ("{\"angle\": \"degrees\"}", ""),
        ("{", ""),
    ] {
        let fault = read_pose_table_asked("1 2 3", request).expect_err(request);
        assert!(fault.place.starts_with(place), "{request}: {fault}");
        assert!(!fault.accepted.is_empty());
    }
}

/// The table that `synthetica export csv` and the page write.
#[test]
fn a_written_motion_reads_back() {
    let document = parse(include_str!("../www/mechanisms/3rps.json")).expect("a sample");
    let problem = Problem::new(&document).expect("a problem");
    let motion = problem.plan();
    for headings in Headings::ALL {
        let options = Options {
            headings: Some(headings),
            ..Options::default()
        };
        let text = write(Format::Csv, options, &document, &problem.mechanism, &motion);
        let table = read(&text.expect("a table"));
        assert_eq!(
            (table.key_frames.len(), table.skipped_count),
            (motion.frames(), 0),
            "{headings:?}"
        );
        assert!(table.understood.time && table.understood.header);
        assert!(table.understood.assumed.is_empty());
        for (key, reached) in table.key_frames.iter().zip(&motion.poses) {
            let (shift, turn) = gaps(&pose(key), reached);
            assert!(shift < 1e-12 && turn < 1e-9, "{shift:e}, {turn:e}");
        }
        let mut times = table.key_frames.iter().zip(&motion.time);
        assert!(times.all(|(key, &time)| key.time == Some(time)));
    }
}

/// The units of the row below the headings are those of the columns; a row that only lacks numbers is told.
#[test]
fn a_row_of_units_is_read() {
    let angles = "name\tx\ty\tz\trx\try\trz\n\tmm\tmm\tmm\trad\trad\trad\na\t1\t2\t3\t0\t0\t1.5\n";
    let table = read(angles);
    assert_eq!((table.key_frames.len(), table.skipped_count), (1, 0));
    assert_eq!(table.understood.angles, AngleUnit::Radians);
    assert_eq!(table.understood.columns[1].heading, "x[mm]");
    let missing = read("x,y,z\nnone,none,?\n1,2,3\n");
    assert_eq!((missing.key_frames.len(), missing.skipped[0].row), (1, 2));
    let said = read("x[mm],y[mm],z[mm]\nmm,mm,mm\n1,2,3\n");
    assert_eq!((said.key_frames.len(), said.skipped[0].row), (1, 2));
}

#[test]
fn angles_in_radians_are_degrees_in_the_document() {
    let table = asked(
        "0 0 0 0.7853981633974483 0 0",
        &json!({"angles": "radians"}),
    );
    assert_eq!(table.understood.angles, AngleUnit::Radians);
    assert!((table.key_frames[0].longitude - 45.0).abs() < 1e-12);
}

/// A tool path of as many poses as there may be, every one a frame.
#[test]
fn a_path_of_the_most_poses_opens() {
    let rows: String = (0..MAX_KEY_FRAMES)
        .map(|i| {
            let (s, c) = libm::sincos(i as f64 * 0.01);
            format!(
                "{i};{};{};{}\n",
                100.0 * c,
                100.0 * s,
                -500.0 - i as f64 * 1e-3
            )
        })
        .collect();
    let table = asked(&rows, &json!({"convention": "positions", "time": true}));
    let mut document = parse(include_str!("field/helix-1000.json")).expect("a document");
    document.motion.key_frames = table.key_frames;
    document.motion.frames = u32::try_from(MAX_FRAMES).expect("a count");
    let text = document.text();
    let document = parse(&text).expect("its own text");
    let problem = Problem::new(&document).expect("a problem");
    assert_eq!(problem.goals.len(), MAX_FRAMES);
    assert_eq!(document.text(), text);
}

/// Whatever is pasted: an answer or a fault, never a panic; every row is read or complained about.
#[test]
fn arbitrary_tables_are_read_or_refused() {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let mut random = move |below: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        usize::try_from(state % below as u64).expect("below a usize")
    };
    const PIECES: [&str; 40] = [
        "1",
        "-2.5",
        "0",
        "1e308",
        "-1e-308",
        "1e999",
        "nan",
        "inf",
        "1,5",
        ",",
        ";",
        "\t",
        " ",
        "\n",
        "\r\n",
        "\"",
        "\"\"",
        "#",
        "x",
        "y",
        "z",
        "qw",
        "qx",
        "qy",
        "qz",
        "time",
        "name",
        "roll",
        "pitch",
        "yaw",
        "r11",
        "longitude",
        "[deg]",
        "(rad)",
        "\u{feff}",
        "\u{2212}1",
        "ä",
        "\u{1f600}",
        "\0",
        "0.5",
    ];
    const REQUESTS: [&str; 6] = [
        "",
        "{\"convention\": \"matrix\"}",
        "{\"convention\": \"quaternion_wxyz\", \"time\": true}",
        "{\"convention\": \"roll_pitch_yaw\", \"order\": \"ZXZ\", \"angles\": \"radians\"}",
        "{\"convention\": \"positions\", \"scale\": 1e18}",
        "{\"time\": false}",
    ];
    let mut read = 0;
    for _ in 0..20_000 {
        let text: String = (0..random(60))
            .map(|_| {
                let piece = PIECES[random(PIECES.len())];
                // Most of them in rows of numbers.
                if random(3) == 0 {
                    format!("{piece}\n0 1 2\n")
                } else {
                    format!("{piece} ")
                }
            })
            .collect();
        match read_pose_table_asked(&text, REQUESTS[random(REQUESTS.len())]) {
            Ok(table) => {
                read += 1;
                let lines = text.split(['\n', '\r']).count();
                assert!(
                    table.key_frames.len() + table.skipped_count <= lines,
                    "{text:?}"
                );
                assert!(
                    table
                        .skipped
                        .iter()
                        .all(|s| s.row >= 1 && s.row <= lines && !s.what.is_empty()),
                    "{text:?}"
                );
                for key in &table.key_frames {
                    assert!(
                        [key.x, key.y, key.z, key.longitude, key.latitude, key.roll]
                            .iter()
                            .all(|n| n.is_finite())
                    );
                }
            }
            Err(fault) => assert!(
                !fault.what.is_empty() && !fault.accepted.is_empty(),
                "{text:?}"
            ),
        }
    }
    assert!(read > 1000, "only {read} of them were read");
}
