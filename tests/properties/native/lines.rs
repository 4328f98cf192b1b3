//! Constraint lines, the parts that they cut, and the periodic picture.

use bubblestone::domain::{Domain, Outline, Walls};
use bubblestone::random::{Purpose, Random};
use glam::DVec2;

const SIDE: f64 = 512.0;

fn p(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// A square from 100 to 400 with a hole from 200 to 300.
pub fn outline(lines: Vec<Vec<DVec2>>) -> Outline {
    let ring = |a: f64, b: f64| vec![p(a, a), p(b, a), p(b, b), p(a, b)];
    let mut hole = ring(200.0, 300.0);
    hole.reverse();
    Outline {
        rings: vec![ring(100.0, 400.0), hole],
        lines,
    }
}

fn domain(lines: Vec<Vec<DVec2>>) -> Domain {
    let (checked, notices) = outline(lines).check(SIDE).unwrap();
    assert_eq!(notices, vec![]);
    Domain::from_checked(&checked)
}

#[test]
fn lines_are_clipped_to_the_inside_and_cut_where_they_cross() {
    let across = domain(vec![vec![p(0., 250.), p(500., 250.)]]);
    assert_eq!(
        across.lines(),
        [
            [p(100., 250.), p(200., 250.)],
            [p(300., 250.), p(400., 250.)]
        ]
    );
    assert_eq!(across.junctions().len(), 4);
    assert_eq!(across.parts(), 2);
    assert_eq!(across.part(p(250., 150.)), 0);
    assert_eq!(across.part(p(250., 350.)), 1);
    let cross = domain(vec![
        vec![p(120., 150.), p(180., 150.)],
        vec![p(150., 120.), p(150., 180.)],
    ]);
    let middle = p(150., 150.);
    assert_eq!(cross.lines()[0], [p(120., 150.), middle, p(180., 150.)]);
    assert_eq!(cross.lines()[1], [p(150., 120.), middle, p(150., 180.)]);
    assert_eq!(cross.parts(), 1);
    let outside = domain(vec![vec![p(0., 50.), p(500., 50.)]]);
    assert!(outside.lines().is_empty() && outside.nearest_line(middle).is_none());
}

#[test]
fn lines_that_nearly_touch_do() {
    // The ends fall short of the outline and overshoot the hole by a tenth of a unit.
    let short = domain(vec![
        vec![p(100.1, 130.), p(399.9, 170.)],
        vec![p(250., 200.1), p(250., 150.1)],
    ]);
    assert_eq!(short.parts(), 2);
    let dangling = domain(vec![vec![p(100., 150.), p(390., 150.)]]);
    assert_eq!(dangling.parts(), 1);
    // A line along the outline, and a line given twice.
    let doubled = domain(vec![
        vec![p(100., 100.), p(400., 100.)],
        vec![p(100., 150.), p(400., 150.)],
        vec![p(150., 150.), p(350., 150.)],
    ]);
    assert_eq!((doubled.parts(), doubled.lines().len()), (2, 1));
}

#[test]
fn closed_lines_make_parts_and_parts_are_numbered_from_the_top() {
    let island = vec![p(120., 320.), p(180., 320.), p(180., 380.), p(120., 320.)];
    let made = domain(vec![vec![p(350., 300.), p(350., 50.)], island.clone()]);
    assert_eq!(made.lines()[1], island);
    assert_eq!(made.parts(), 2);
    assert_eq!(made.part(p(170., 350.)), 1);
    // Lines from the hole to the outline at two places give two parts.
    let cut = domain(vec![
        vec![p(300., 200.), p(400., 100.)],
        vec![p(250., 300.), p(250., 400.)],
    ]);
    assert_eq!(cut.parts(), 2);
    assert_eq!((cut.part(p(150., 150.)), cut.part(p(350., 250.))), (0, 1));
    // A place outside belongs to the nearest part.
    assert_eq!(cut.part(p(450., 250.)), 1);
}

#[test]
fn faults_of_lines_are_sentences() {
    let sentence = |lines| outline(lines).check(SIDE).unwrap_err().to_string();
    assert_eq!(
        sentence(vec![vec![p(150., 150.); 3]]),
        "Line 1 needs at least 2 different points."
    );
    assert_eq!(
        sentence(vec![vec![p(150., f64::NAN), p(1., 1.)]]),
        "Point 1 of line 1 is not a pair of finite numbers."
    );
    assert_eq!(
        sentence(vec![vec![p(150., 9.), p(1., 1e9)]]),
        "Line 1 has a point far outside the picture, at (1, 1e9); \
         at most half of the picture's side is allowed."
    );
    let many: Vec<DVec2> = (0..600).map(|k| p(f64::from(k), 0.)).collect();
    assert_eq!(
        sentence(vec![many]),
        "The lines have 600 points; at most 512 are allowed."
    );
}

#[test]
fn lines_face_from_both_sides_and_hide_what_is_behind() {
    let made = domain(vec![vec![p(150., 100.), p(150., 160.)]]);
    let walls = Walls::new(&made, 60.0);
    let mut near = Vec::new();
    let mut points = |q: DVec2| {
        walls.project(q, 60.0, &mut near);
        near.iter().map(|f| f.point).collect::<Vec<_>>()
    };
    assert_eq!(
        points(p(140., 130.)),
        [p(150., 130.), p(140., 100.), p(100., 130.)]
    );
    assert_eq!(
        points(p(160., 130.)),
        [p(150., 130.), p(160., 100.), p(200., 200.)][..2]
    );
    // The free end of a line is a tip; an end at the outline is not.
    assert_eq!(points(p(150., 170.))[0], p(150., 160.));
    assert!(made.crosses_line(p(140., 130.), p(160., 131.)));
    assert!(!made.crosses_line(p(140., 170.), p(160., 170.)));
    assert_eq!(made.nearest_line(p(140., 130.)).unwrap().distance, 10.0);
}

#[test]
fn a_torus_has_no_boundary_and_wraps_lines() {
    let plain = Domain::torus(SIDE, &[]);
    assert_eq!(plain.area(), SIDE * SIDE);
    assert!(plain.contains(p(0., 0.)) && plain.nearest(p(1., 1.)).distance > 1e6);
    assert_eq!(plain.space().wrap(p(-1., 513.)), p(511., 1.));
    assert_eq!(plain.space().shortest(p(500., -300.)), p(-12., 212.));
    // One line all around does not divide a torus, but two lines do, or a closed one.
    let around = |x: f64| vec![p(x, -10.), p(x, 502.)];
    assert_eq!(Domain::torus(SIDE, &[around(100.)]).parts(), 1);
    let two = Domain::torus(SIDE, &[around(100.), around(300.)]);
    assert_eq!(two.parts(), 2);
    assert_eq!(two.part(p(10., 10.)), two.part(p(500., 500.)));
    assert_ne!(two.part(p(10., 10.)), two.part(p(200., 10.)));
    let ring = vec![
        p(500., 500.),
        p(560., 500.),
        p(560., 560.),
        p(500., 560.),
        p(500., 500.),
    ];
    let island = Domain::torus(SIDE, &[ring]);
    assert_eq!(island.parts(), 2);
    assert_eq!(island.part(p(5., 5.)), island.part(p(505., 505.)));
    assert_ne!(island.part(p(5., 5.)), island.part(p(60., 60.)));
    assert!(island.crosses_line(p(40., 5.), p(60., 5.)));
    assert!(island.crosses_line(p(505., 495.), p(505., 505.)));
    assert_eq!(island.nearest_line(p(40., 5.)).unwrap().point, p(48., 5.));
    let walls = Walls::new(&island, 30.0);
    let mut near = Vec::new();
    walls.project(p(509., -7.), 30.0, &mut near);
    let points: Vec<DVec2> = near.iter().map(|f| f.point).collect();
    assert_eq!(points, [p(509., -12.), p(500., -7.)]);
}

/// If a straight path crosses no line, its ends lie in the same part. Checked over random lines.
#[test]
fn a_way_that_crosses_nothing_stays_in_its_part() {
    let mut random = Random::new(7, Purpose::Noise, 0);
    let mut many = 0;
    for _ in 0..60 {
        let mut point = || p(80.0 + 340.0 * random.unit(), 80.0 + 340.0 * random.unit());
        let lines: Vec<Vec<DVec2>> = (0..4).map(|_| (0..3).map(|_| point()).collect()).collect();
        let domains = [domain(lines.clone()), Domain::torus(SIDE, &lines)];
        many += usize::from(domains[0].parts() > 1);
        for made in domains {
            for _ in 0..300 {
                let a = p(100.0 + 300.0 * random.unit(), 100.0 + 300.0 * random.unit());
                let b = a + p(random.signed(), random.signed()) * 15.0;
                let free = [a, b].map(|q| made.nearest(q).distance > 11.0);
                if free == [true; 2] && !made.crosses_line(a, b) {
                    assert_eq!(made.part(a), made.part(b), "{a} {b} {lines:?}");
                }
                let (from, to) = (made.part(a), made.part(made.space().wrap(a + SIDE)));
                assert!(made.space().period().is_none() || from == to);
            }
        }
    }
    assert!(many > 20);
}
