//! Properties of whole buildings.

use super::{
    CellSort, Feature, Laying, LayingParams, LayingPass, LayingWarning, MasonryCell, Measures, view,
};
use crate::building::{Bend, Building, Draft, EdgeId, FaceId, Misfit, Module, Rule, obj};
use crate::masonry::module::{ASHLAR, BLOCK};
use crate::masonry::plan::{FaceGrid, PlanFault, is_wall, thicknesses};
use crate::masonry::tree::{PRESETS, PatternGenerator, PatternTree, WindowPart};
use std::sync::Arc;

/// The paper's three trees with their modules.
pub(super) const TREES: [(usize, Module); 3] = [(0, BLOCK), (1, Module::NORMAL), (2, ASHLAR)];
pub(super) const BRICKS: (usize, Module) = TREES[1];

pub(super) fn draft(rule: Rule, module: &Module) -> Draft {
    let numbers: Vec<f64> = rule.numbers().iter().map(|number| number.default).collect();
    rule.draft(module, &numbers)
}

pub(super) fn begun(
    draft: &Draft,
    (tree, module): (usize, Module),
    seed: u64,
) -> Result<Laying, PlanFault> {
    let building = Arc::new(Building::new(draft).expect("a building"));
    let params = LayingParams {
        module,
        is_by_hand: false,
        seed,
    };
    let tree: PatternTree = PRESETS[tree].tree();
    let thick = thicknesses(&building).expect("a mesh");
    Laying::new(building, tree, params, |face| thick[face.index()])
}

pub(super) fn laid(draft: &Draft, tree: (usize, Module), seed: u64) -> Laying {
    let mut laying = begun(draft, tree, seed).expect("a plan");
    while !laying.advance(16) {}
    laying
}

#[test]
fn cells_are_closed_convex_and_leave_room_for_mortar() {
    for rule in [Rule::Gate, Rule::Steps, Rule::Ring, Rule::Gabled] {
        for tree in TREES {
            let laying = laid(&draft(rule, &tree.1), tree, 1);
            assert!(laying.cells().len() > 20);
            for cell in laying.cells() {
                assert!(
                    cell.claimed.is_sound() && cell.claimed.is_convex(0.01),
                    "{rule:?} {cell:?}"
                );
                assert!(cell.claims.iter().all(|(_, claim)| claim.area() > 0.0));
                assert!(cell.body.volume() >= cell.claimed.volume() - 1e-9);
            }
        }
    }
}

/// The bounds of bricks on a rule's building: the greatest gap, shared volume, and shares of cut bricks and of
/// straight joints.
const LIMITS: [(Rule, [f64; 4]); 10] = [
    (Rule::Block, [5e-4, 3e-4, 0.0, 0.0]),
    (Rule::LHouse, [0.0015, 3e-4, 0.05, 0.01]),
    (Rule::Gabled, [0.0015, 3e-4, 0.06, 0.01]),
    (Rule::Wall, [0.0015, 3e-4, 0.05, 0.01]),
    (Rule::Gate, [0.0015, 3e-4, 0.05, 0.01]),
    (Rule::Steps, [5e-4, 3e-4, 0.0, 0.03]),
    (Rule::Tower, [5e-4, 0.002, 0.0, 0.01]),
    (Rule::Ring, [5e-4, 3e-4, 0.03, 0.0]),
    (Rule::Sheet, [5e-4, 3e-4, 0.0, 0.0]),
    (Rule::Plan, [0.0015, 3e-4, 0.05, 0.01]),
];

#[test]
fn bricks_fill_walls_without_conflicts_or_overlaps() {
    for (rule, [gap, shared, cut, straight]) in LIMITS {
        let laying = laid(&draft(rule, &Module::NORMAL), BRICKS, 1);
        let found = Measures::new(&laying);
        assert_eq!(
            (found.conflicts, laying.warnings()),
            (0, &[][..]),
            "{rule:?}"
        );
        assert!(found.course > 0.9999, "{rule:?} {found:?}");
        assert!(
            found.gap <= gap && found.shared_volume <= shared,
            "{rule:?} {found:?}"
        );
        assert!(
            found.cut <= cut && found.straight <= straight,
            "{rule:?} {found:?}"
        );
    }
}

/// With stone quoins, the arch of a gate has an odd number of stones on both sides of the wall.
#[test]
fn arches_beside_quoins_are_of_stone() {
    let draft = draft(Rule::Gate, &Module::NORMAL);
    let laying = laid(&draft, (3, Module::NORMAL), 1);
    let found = Measures::new(&laying);
    assert!(
        found.gap < 0.0015 && found.shared_volume < 3e-4,
        "{found:?}"
    );
    let springing = 16.0 * Module::NORMAL.course;
    for side in [1.0, -1.0] {
        let stones = laying.cells().iter().filter(|cell| {
            cell.generator == PatternGenerator::ArchStones
                && cell.claimed.bounds()[1].y > springing + 0.01
                && side * cell.outwards.z > 0.5
        });
        let heights: Vec<f64> = stones.map(|cell| cell.claimed.bounds()[1].y).collect();
        let highest = heights.iter().copied().fold(f64::MIN, f64::max);
        let keystones = heights.iter().filter(|&&y| y == highest).count();
        // The keystone ends at a course line, so no brick above it is cut to a thin strip.
        let is_line = |face: FaceId| {
            let lines = &laying.plan().grid(face).t;
            lines.iter().any(|line| (line - highest).abs() < 1e-6)
        };
        let fronts = laying.building().face_ids();
        let mut fronts = fronts.filter(|&id| is_wall(laying.building().face(id)));
        assert!(fronts.any(is_line), "{highest}");
        assert_eq!((heights.len(), keystones), (15, 1), "{heights:?}");
    }
}

/// Doors, as windows, have a lintel, with a stone in its middle and not a joint.
#[test]
fn straight_heads_are_odd_rows_of_stones() {
    let quoins_and_coped = [3, 5].map(|tree| (tree, Module::NORMAL));
    let trees = [BRICKS, TREES[2], quoins_and_coped[0], quoins_and_coped[1]];
    for tree in trees {
        let mut heads = [0; 2];
        for rule in [Rule::Gabled, Rule::Wall] {
            let laying = laid(&draft(rule, &tree.1), tree, 1);
            let building = laying.building();
            for id in building.edge_ids() {
                let seen = view(building, Feature::Edge(id));
                let labels = ["Window", "Door"].map(|label| seen.labels.contains(&label));
                let is_straight = !seen.labels.contains(&"Arch") && labels != [false; 2];
                // Panes are behind concave edges, which have no lintel.
                let is_front = building.edge(id).bend == Bend::Convex;
                if seen.window != WindowPart::Top || !is_straight || !is_front {
                    continue;
                }
                let cells = laying.cells().iter();
                let own = cells.filter(|cell| {
                    cell.feature == Feature::Edge(id)
                        && cell.generator == PatternGenerator::ArchStones
                });
                let own = own.count();
                assert_eq!(own % 2, 1, "{rule:?} {tree:?} {labels:?} {own}");
                heads[usize::from(labels[1])] += 1;
            }
        }
        assert!(heads[0] > 2 && heads[1] > 0, "{tree:?} {heads:?}");
    }
}

#[test]
fn claims_and_gaps_make_the_faces() {
    for tree in TREES {
        let laying = laid(&draft(Rule::Wall, &tree.1), tree, 1);
        for face in laying.textured_faces() {
            let map = laying.face_map(face);
            let sum = map.claimed() + map.gap();
            let overlap = map.overlap();
            // A claim may also stand out of the face, so overlaps bound the difference.
            assert!(
                sum > map.area() - 1e-6 && sum < map.area() + overlap + 1e-6,
                "{sum} {overlap}"
            );
            assert!(overlap < 0.02 * map.area(), "{overlap}");
        }
    }
}

#[test]
fn slices_and_seeds_decide_nothing_and_everything() {
    let draft = draft(Rule::Wall, &Module::NORMAL);
    let whole = laid(&draft, TREES[2], 1);
    let mut sliced = begun(&draft, TREES[2], 1).unwrap();
    let (mut slices, mut before, mut most) = (0, 0, 0);
    while !sliced.advance(1) {
        slices += 1;
        let laid = sliced.cells().len();
        most = most.max(laid - before);
        before = laid;
    }
    assert!(slices > 20);
    assert_eq!(whole.cells(), sliced.cells());
    assert!(most < 100, "{most} stones in a part");
    assert_ne!(whole.cells(), laid(&draft, TREES[2], 2).cells());
}

#[test]
fn corners_come_before_edges_and_edges_before_faces() {
    let laying = laid(&draft(Rule::Block, &Module::NORMAL), BRICKS, 1);
    let passes: Vec<LayingPass> = laying.cells().iter().map(MasonryCell::pass).collect();
    assert!(passes.is_sorted());
    use LayingPass::{Corners, Edges, Faces};
    assert!(
        [Corners, Edges, Faces]
            .iter()
            .all(|pass| passes.contains(pass))
    );
}

#[test]
fn openings_lie_on_course_lines() {
    for rule in [Rule::LHouse, Rule::Wall, Rule::Tower] {
        let laying = laid(&draft(rule, &Module::NORMAL), BRICKS, 1);
        let building = laying.building();
        let mut looked_at = 0;
        for id in building.edge_ids() {
            let edge = building.edge(id);
            let is_opening = edge.labels.iter().any(|label| label == "Window");
            for face in edge
                .faces
                .into_iter()
                .flatten()
                .filter(|&face| is_wall(building.face(face)))
            {
                for p in edge
                    .corners
                    .iter()
                    .flatten()
                    .map(|&corner| building.place(corner))
                {
                    let t = building.face(face).surface.project(p).y;
                    let lines = &laying.plan().grid(face).t;
                    let line = lines[FaceGrid::line_at(lines, t)];
                    assert!(
                        !is_opening || (line - t).abs() < 1e-3,
                        "{rule:?} {t} {line}"
                    );
                    looked_at += usize::from(is_opening);
                }
            }
        }
        assert!(looked_at > 10);
    }
}

#[test]
fn modules_that_do_not_suit_a_building_are_refused() {
    let small = draft(
        Rule::Block,
        &Module {
            half: 0.0025,
            course: 0.0025,
            joint: 0.0002,
        },
    );
    let stones = Module {
        half: 0.6,
        course: 0.6,
        joint: 0.01,
    };
    let refused = begun(&small, (1, stones), 1).map(|_| ());
    assert!(
        matches!(refused, Err(PlanFault::Misfit(Misfit::ModuleTooLarge { width, .. })) if width < 0.1),
        "{refused:?}"
    );
    let bad = Module {
        joint: 1.0,
        ..Module::NORMAL
    };
    assert!(matches!(
        begun(&small, (1, bad), 1).map(|_| ()),
        Err(PlanFault::Module(_))
    ));
}

#[test]
fn what_the_tree_does_not_expect_is_told() {
    let text = r#"{"type":"WindowBottomBricks"}"#;
    let building = Arc::new(Building::new(&draft(Rule::Block, &Module::NORMAL)).unwrap());
    let params = LayingParams {
        module: Module::NORMAL,
        is_by_hand: false,
        seed: 1,
    };
    let tree = PatternTree::read(text).unwrap();
    let mut laying = Laying::new(building, tree, params, |_| f64::INFINITY).unwrap();
    while !laying.advance(9) {}
    let faces = laying.warnings().iter().filter(|warning| {
        matches!(warning, LayingWarning::Unexpected { feature: Feature::Face(_), path } if path.is_empty())
    });
    assert_eq!(faces.count(), 6);
    assert!(laying.cells().iter().all(|cell| cell.sort != CellSort::Cut));
}

#[test]
fn by_hand_the_bit_of_an_edge_turns_its_bricks() {
    let mut draft = draft(Rule::Block, &Module::NORMAL);
    let building = Building::new(&draft).unwrap();
    let upright = |id: &EdgeId| building.edge(*id).is_vertical();
    let id = building
        .edge_ids()
        .find(upright)
        .expect("a block has upright edges");
    // The claims of the edge's bricks on its first face, from the bottom up.
    let areas = |draft: &Draft| {
        let building = Arc::new(Building::new(draft).unwrap());
        let params = LayingParams {
            module: Module::NORMAL,
            is_by_hand: true,
            seed: 1,
        };
        let face = building.edge(id).faces[0].unwrap();
        let mut laying =
            Laying::new(building, PRESETS[1].tree(), params, |_| f64::INFINITY).unwrap();
        while !laying.advance(100) {}
        let own = laying
            .cells()
            .iter()
            .filter(|cell| cell.feature == Feature::Edge(id));
        let mut rows: Vec<(f64, f64)> = own
            .flat_map(|cell| cell.claims.iter().filter(move |claim| claim.0 == face))
            .map(|(_, claim)| (claim.centre().y, claim.area()))
            .collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        rows.into_iter().map(|row| row.1).collect::<Vec<f64>>()
    };
    let before = areas(&draft);
    let ends = building
        .edge(id)
        .corners
        .map(|corner| building.place(corner.unwrap()));
    let vertex = |p: glam::DVec3| {
        draft
            .vertices
            .iter()
            .position(|q| q.distance(p) < 1e-6)
            .unwrap() as u32
    };
    let flip = ends.map(vertex);
    draft.edge_flips.push(flip);
    let after = areas(&draft);
    assert!(before.len() > 4 && before.len() == after.len());
    for (k, w) in before.windows(2).enumerate() {
        assert!((w[0] / w[1]).max(w[1] / w[0]) > 1.5, "rows alternate");
        assert!((after[k] - w[1]).abs() < 0.1 * w[1], "{k}");
    }
}

/// A cylinder of 24 facets with a lid of its own group, as an OBJ file (metres).
fn lidded(radius: f64, height: f64, is_closed: bool) -> String {
    const FACETS: usize = 24;
    let mut file = String::from("g Tower\n");
    for k in 0..FACETS {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / FACETS as f64);
        let (x, z) = (radius * cos, -radius * sin);
        file += &format!("v {x} 0 {z}\nv {x} {height} {z}\n");
    }
    let low = |k: usize| 2 * (k % FACETS) + 1;
    for k in 0..FACETS {
        let [a, b] = [low(k), low(k + 1)];
        file += &format!("f {a} {b} {} {}\n", b + 1, a + 1);
    }
    let ring = |way: &mut dyn Iterator<Item = usize>| -> String {
        let corners = way.map(|v| format!(" {v}"));
        format!("f{}\n", corners.collect::<String>())
    };
    file += "g Cap\n";
    file += &ring(&mut (0..FACETS).map(|k| low(k) + 1));
    if is_closed {
        file += &ring(&mut (0..FACETS).rev().map(low));
    }
    file
}

#[test]
fn no_cell_of_a_lid_with_a_circle_for_its_outline_lies_outside_of_the_building() {
    let (radius, height) = (1.6, 3.0);
    for is_closed in [false, true] {
        let file = lidded(radius, height, is_closed);
        let read = obj::read(file.as_bytes(), &obj::FileSpace::METRES).expect("a building");
        assert!(read.curved.len() == 1 && read.curved[0].is_whole);
        let laying = laid(&read.draft, BRICKS, 1);
        for cell in laying.cells() {
            for p in cell.claimed.vertices() {
                let away = libm::hypot(p.x, p.z);
                assert!(away < radius + 2e-3, "{:?} {p}", cell.feature);
                assert!(
                    (-2e-3..height + 2e-3).contains(&p.y),
                    "{:?} {p}",
                    cell.feature
                );
            }
        }
        let found = Measures::new(&laying);
        assert!(found.overlap < 0.002 && found.gap < 0.02, "{found:?}");
    }
}
