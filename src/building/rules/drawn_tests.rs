//! Properties of drawn plans: their walls, and their faults.

use super::{DrawnFault, DrawnPlan, Module, OpeningFault, Rule};
use crate::building::{Bend, Building, Draft, labels};

/// A plan of corners and openings.
fn plan(corners: &[[i64; 2]], openings: &[[i64; 6]]) -> DrawnPlan {
    DrawnPlan {
        corners: corners.to_vec(),
        openings: openings.to_vec(),
    }
}

/// The draft of a plan with walls two modules thick, and its faults. Its building has to be closed.
fn drawn(corners: &[[i64; 2]], openings: &[[i64; 6]]) -> (Draft, Vec<DrawnFault>) {
    let (draft, faults) = plan(corners, openings).draft(&Module::NORMAL, &[24.0, 2.0]);
    let building = Building::new(&draft).expect("a building");
    assert!(building.edges().iter().all(|edge| edge.bend != Bend::Open));
    assert!(building.warnings().is_empty());
    (draft, faults)
}

const YARD: [[i64; 2]; 5] = [[0, 0], [30, 0], [30, -20], [0, -20], [0, 0]];

/// The faults of an opening in the walls of the yard.
fn faults_of(opening: [i64; 6]) -> Vec<OpeningFault> {
    let (_, faults) = drawn(&YARD, &[opening]);
    let why = |fault| match fault {
        DrawnFault::Opening { opening: 1, why } => why,
        other => panic!("{other:?}"),
    };
    faults.into_iter().map(why).collect()
}

#[test]
fn a_line_becomes_walls_whichever_way_it_turns() {
    let open = [[0, 0], [10, 0], [16, 6], [30, 6], [30, 20]];
    let back: Vec<[i64; 2]> = open.iter().rev().copied().collect();
    for corners in [&open[..], &back] {
        let (draft, faults) = drawn(corners, &[]);
        assert_eq!(faults, []);
        // Two sides of each wall, two ends, top and bottom.
        assert_eq!(draft.faces.len(), 4 * 2 + 4);
    }
    let turned: Vec<[i64; 2]> = YARD.iter().rev().copied().collect();
    for corners in [&YARD[..], &turned] {
        let (draft, faults) = drawn(corners, &[]);
        assert_eq!((faults.len(), draft.faces.len()), (0, 4 * 2 + 2));
    }
    // The yard's outside is 30 modules long; if the line is walked the other way round, its inside
    // is 30 modules long.
    let width = |corners: &[[i64; 2]]| {
        let (draft, _) = drawn(corners, &[]);
        draft.vertices.iter().map(|v| v.x).fold(0.0, f64::max) * 2.0
    };
    let module = Module::NORMAL;
    assert!((width(&YARD) - module.pier(30.0)).abs() < 1e-9);
    assert!((width(&turned) - module.pier(34.0)).abs() < 1e-9);
}

#[test]
fn gates_divide_the_ground_and_windows_do_not() {
    let gates = [
        [1, 4, 0, 6, 10, 2],
        [1, 16, 0, 6, 10, 0],
        [3, 6, 0, 6, 10, 1],
    ];
    for (count, ground) in [(0, 1), (1, 1), (2, 2), (3, 3)] {
        let (draft, faults) = drawn(&YARD, &gates[..count]);
        assert_eq!(faults, []);
        let is_below = |face: &&crate::building::DraftFace| {
            face.loops
                .iter()
                .flatten()
                .all(|&v| draft.vertices[v as usize].y == 0.0)
        };
        assert_eq!(
            draft.faces.iter().filter(is_below).count(),
            ground,
            "{count}"
        );
    }
    let (draft, faults) = drawn(&YARD, &[[1, 4, 8, 6, 8, 0], [2, 4, 8, 6, 8, 1]]);
    assert_eq!((faults.len(), draft.faces.len()), (0, 10 + 4 + 4));
}

#[test]
fn walls_that_go_on_straight_are_one() {
    let split = [
        [0, 0],
        [12, 0],
        [30, 0],
        [30, -20],
        [14, -20],
        [0, -20],
        [0, 0],
    ];
    // The second drawn wall begins 12 modules along the first, the fifth 16 along the fourth.
    let openings = [[2, 2, 8, 6, 8, 0], [5, 4, 8, 6, 8, 0]];
    let joined = [[1, 14, 8, 6, 8, 0], [3, 20, 8, 6, 8, 0]];
    assert_eq!(drawn(&split, &openings), drawn(&YARD, &joined));
    // A closed line that begins within a straight wall.
    let middle = [[12, 0], [30, 0], [30, -20], [0, -20], [0, 0], [12, 0]];
    let (draft, faults) = drawn(&middle, &[[1, 2, 8, 6, 8, 0], [5, 4, 8, 4, 8, 0]]);
    let (other, _) = drawn(&YARD, &[[1, 14, 8, 6, 8, 0], [1, 4, 8, 4, 8, 0]]);
    assert_eq!(faults, []);
    assert_eq!(draft.vertices.len(), other.vertices.len());
}

#[test]
fn closed_plans_that_turn_one_way_may_have_a_roof() {
    let turned: Vec<[i64; 2]> = YARD.iter().rev().copied().collect();
    let square = [[0, 0], [20, 0], [20, -20], [0, -20], [0, 0]];
    let bays = [[0, 0], [30, 0], [38, -9], [30, -20], [0, -20], [0, 0]];
    let window = [[1, 4, 8, 6, 8, 0]];
    for corners in [&YARD[..], &turned, &square, &bays] {
        let walls = corners.len() - 1;
        let (draft, faults) = plan(corners, &window).draft(&Module::NORMAL, &[24.0, 2.0, 40.0]);
        assert_eq!(faults, []);
        let building = Building::new(&draft).expect("a building");
        assert!(building.edges().iter().all(|edge| edge.bend != Bend::Open));
        assert!(building.warnings().is_empty());
        let roof = draft
            .faces
            .iter()
            .filter(|face| face.labels == [labels::ROOF]);
        // A slope over each wall, and the ceiling.
        assert_eq!(roof.count(), walls + 1);
        // Two sides of each wall, the ground, and the window's reveal.
        assert_eq!(draft.faces.len(), 3 * walls + 1 + 1 + 4);
        assert!(draft.extras.iter().any(|extra| extra.name == "pane"));
    }
    let angle = [
        [0, 0],
        [30, 0],
        [30, -30],
        [15, -30],
        [15, -15],
        [0, -15],
        [0, 0],
    ];
    for corners in [&YARD[..4], &angle] {
        let numbers = [24.0, 2.0, 40.0];
        let (draft, faults) = plan(corners, &window).draft(&Module::NORMAL, &numbers);
        assert_eq!(faults, [DrawnFault::Roofless]);
        assert_eq!(draft, drawn(corners, &window).0);
    }
}

#[test]
fn bad_plans_give_way_to_the_usual_one() {
    let usual = Rule::Plan.draft(&Module::NORMAL, &[]);
    let fault = |corners: &[[i64; 2]]| {
        let (draft, mut faults) = drawn(corners, &[[1, 9, 9, 9, 9, 9]]);
        assert_eq!(draft, usual);
        faults.remove(0)
    };
    let few = DrawnFault::Few {
        corners: 2,
        least: 3,
    };
    assert_eq!(fault(&[[0, 0], [9, 0], [0, 0]]), few);
    let few = DrawnFault::Few {
        corners: 1,
        least: 2,
    };
    assert_eq!(fault(&[[5, 5], [5, 5]]), few);
    let short = fault(&[[0, 0], [1, 0], [1, 9]]);
    assert!(
        matches!(short, DrawnFault::Short { wall: 1, length } if length < 2.0),
        "{short:?}"
    );
    // The inside is two modules shorter at each end.
    let short = fault(&[[0, 0], [20, 0], [20, -5], [0, -5], [0, 0]]);
    assert!(
        matches!(short, DrawnFault::Short { wall: 2, length } if (length - 1.16).abs() < 1e-9),
        "{short:?}"
    );
    let sharp = fault(&[[0, 0], [20, 0], [0, 5]]);
    assert!(matches!(sharp, DrawnFault::Sharp { corner: 2, angle } if (angle - 14.04).abs() < 0.1));
    assert!(matches!(
        fault(&[[0, 0], [20, 0], [0, 0], [9, 9]]),
        DrawnFault::Sharp { .. }
    ));
    let bow = [[0, 0], [20, 0], [20, -20], [10, -20], [10, 10]];
    let crossing = fault(&bow);
    assert!(
        matches!(crossing, DrawnFault::Crossing { at: [x, y] } if (x - 10.0).abs() < 2.0 && y.abs() < 2.0),
        "{crossing:?}"
    );
    // The end comes to stand just beside the first wall.
    let touching = [[0, 0], [20, 0], [20, -20], [10, -20], [10, -2]];
    assert!(matches!(fault(&touching), DrawnFault::Crossing { .. }));
    let apart = [[0, 0], [20, 0], [20, -20], [10, -20], [10, -4]];
    assert_eq!(drawn(&apart, &[]).1, []);
}

#[test]
fn far_corners_are_moved() {
    let (draft, faults) = drawn(&[[-999, 0], [20, 0], [20, 1 << 28]], &[]);
    assert_eq!(faults, [DrawnFault::Far { corners: 2 }]);
    assert_eq!(draft, drawn(&[[-120, 0], [20, 0], [20, 120]], &[]).0);
}

#[test]
fn openings_that_do_not_fit_are_left_out() {
    use OpeningFault as Fault;
    let fits = [1, 4, 8, 6, 8, 0];
    assert_eq!(faults_of(fits), []);
    for wall in [-3, 0, 5, i64::MAX] {
        let [_, rest @ ..] = fits;
        let [a, b, c, d, e] = rest;
        let none = Fault::NoWall { wall, walls: 4 };
        assert_eq!(faults_of([wall, a, b, c, d, e]), [none]);
    }
    // Between the inner corners, two modules remain at each end.
    let beyond = |ends| Fault::Beyond {
        wall: 1,
        ends,
        allowed: [4, 26],
    };
    assert_eq!(faults_of([1, 3, 8, 6, 8, 0]), [beyond([3, 9])]);
    assert_eq!(faults_of([1, 4, 8, 22, 8, 0]), []);
    assert_eq!(faults_of([1, 5, 8, 22, 8, 0]), [beyond([5, 27])]);
    assert_eq!(faults_of([2, 4, 8, 13, 8, 0]), [Fault::Full { wall: 2 }]);
    let high = Fault::High {
        top: 21.0,
        most: 20.0,
    };
    assert_eq!(faults_of([1, 4, 8, 6, 13, 0]), [high]);
    assert!(matches!(
        faults_of([1, 4, 8, 10, 8, 2])[..],
        [Fault::High { .. }]
    ));
    let number = |place, range, moved| Fault::Number {
        place,
        range,
        moved,
    };
    assert_eq!(
        faults_of([1, 4, -1, 1, 3, 7]),
        [
            number(3, [0, 60], [-1, 0]),
            number(4, [2, 24], [1, 2]),
            number(5, [4, 60], [3, 4]),
            number(6, [0, 2], [7, 2]),
        ]
    );
    let over = |openings: &[[i64; 6]]| drawn(&YARD, openings).1;
    let fault = [DrawnFault::Opening {
        opening: 2,
        why: Fault::Over { other: 1 },
    }];
    assert_eq!(over(&[fits, fits]), fault);
    assert_eq!(over(&[fits, [1, 11, 8, 6, 8, 0]]), fault);
    assert_eq!(over(&[fits, [1, 12, 8, 6, 8, 0]]), []);
    let low = [1, 4, 3, 6, 4, 0];
    assert_eq!(over(&[low, [1, 4, 10, 6, 6, 0]]), fault);
    assert_eq!(over(&[low, [1, 4, 11, 6, 6, 0]]), []);
}
