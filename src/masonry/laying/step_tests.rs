//! Properties of the patterns of steps (Legakis, Dorsey, Gortler 2001, section 5.5, fig. 8).

use super::measures::pairs;
use super::{
    CellSort, Feature, Laying, LayingParams, LayingPass, LayingWarning, MasonryCell, Measures,
};
use crate::building::{Building, FaceId, Module, Rule};
use crate::masonry::footprint::Footprint;
use crate::masonry::plan::{is_wall, thicknesses};
use crate::masonry::tree::{PatternGenerator, PatternTree, TreePreset};
use std::sync::Arc;

/// The two trees of figure 8.
const TREES: [&str; 2] = ["diagonal", "cement"];

/// The steps with columns of this width and height (modules and courses).
fn steps(column: f64, height: f64) -> Vec<f64> {
    vec![4.0, 16.0, 2.0, 2.0, column, height]
}

fn laid(rule: Rule, numbers: &[f64], tree: PatternTree) -> Laying {
    let draft = rule.draft(&Module::NORMAL, numbers);
    let building = Arc::new(Building::new(&draft).expect("a building"));
    let thick = thicknesses(&building).expect("a mesh");
    let params = LayingParams {
        module: Module::NORMAL,
        is_by_hand: false,
        seed: 1,
    };
    let mut laying =
        Laying::new(building, tree, params, |face| thick[face.index()]).expect("a plan");
    while !laying.advance(16) {}
    laying
}

fn preset(rule: Rule, numbers: &[f64], word: &str) -> Laying {
    laid(
        rule,
        numbers,
        TreePreset::of_word(word).expect("a tree").tree(),
    )
}

fn of(laying: &Laying, generator: PatternGenerator) -> Vec<&MasonryCell> {
    let own = laying
        .cells()
        .iter()
        .filter(|cell| cell.generator == generator);
    own.collect()
}

#[test]
fn both_trees_lay_every_building_without_a_fault() {
    for rule in Rule::ALL {
        let numbers: Vec<f64> = rule.numbers().iter().map(|number| number.default).collect();
        let plain = Measures::new(&preset(rule, &numbers, "bricks"));
        for word in TREES {
            let laying = preset(rule, &numbers, word);
            let found = Measures::new(&laying);
            let told = laying.warnings();
            assert!(told.is_empty(), "{rule:?} {word}: {told:?}");
            let faces = laying.building().face_ids();
            // Tiles leave the undersides and the ends of a roof bare.
            let is_bare = |face: FaceId| {
                let labels = &laying.building().face(face).labels;
                let is_roof = labels.iter().any(|label| label == "Roof");
                let is_glass = labels.iter().any(|label| label == "Glass");
                is_glass || (is_roof && !laying.site.is_roof(face))
            };
            let textured: Vec<FaceId> = laying.textured_faces().collect();
            assert!(
                faces
                    .into_iter()
                    .all(|face| is_bare(face) != textured.contains(&face))
            );
            assert_eq!(found.conflicts, plain.conflicts);
            // Gaps, overlaps and cuts are no worse than with plain bricks. Bricks of special shapes count apart from
            // cut ones.
            assert!(
                found.gap <= plain.gap + 5e-4 && found.shared_volume <= plain.shared_volume + 1e-4,
                "{rule:?} {word}: {found:?} {plain:?}"
            );
            assert!(
                found.cut <= plain.cut + 0.01 && found.straight <= plain.straight + 0.01,
                "{rule:?} {word}: {found:?} {plain:?}"
            );
            assert_eq!(found.special > 0.0, rule == Rule::Steps, "{rule:?} {word}");
            let are_sound =
                |cell: &MasonryCell| cell.claimed.is_sound() && cell.claimed.is_convex(0.01);
            assert!(laying.cells().iter().all(are_sound), "{rule:?} {word}");
        }
    }
}

#[test]
fn panels_of_all_faces_come_before_the_rest_of_any() {
    let laying = preset(Rule::Steps, &steps(8.0, 22.0), "diagonal");
    let passes: Vec<LayingPass> = laying.cells().iter().map(MasonryCell::pass).collect();
    assert!(passes.is_sorted());
    let panels = passes.iter().filter(|&&pass| pass == LayingPass::Panels);
    assert!(panels.count() > 100 && passes.contains(&LayingPass::Faces));
}

/// The faces with a panel, and the panel's rectangle on each.
fn panels(laying: &Laying) -> Vec<(FaceId, Footprint)> {
    let mut found: Vec<(FaceId, Vec<glam::DVec2>)> = Vec::new();
    for cell in of(laying, PatternGenerator::Panel) {
        for (face, claim) in &cell.claims {
            assert_eq!(cell.feature, Feature::Face(*face));
            let places = claim.places();
            match found.iter_mut().find(|(own, _)| own == face) {
                Some((_, all)) => all.extend(places),
                None => found.push((*face, places.collect())),
            }
        }
    }
    let hulls = found
        .into_iter()
        .map(|(face, places)| (face, Footprint::hull(&places).expect("a hull")));
    hulls.collect()
}

#[test]
fn panels_fill_their_rectangles_and_the_bond_meets_them() {
    for (column, height, size) in [
        (6.0, 16.0, [2, 9]),
        (8.0, 20.0, [4, 11]),
        (10.0, 22.0, [6, 11]),
    ] {
        let laying = preset(Rule::Steps, &steps(column, height), "diagonal");
        let panels = panels(&laying);
        assert_eq!(panels.len(), 8);
        for (face, hull) in panels {
            let [low, high] = hull.bounds();
            let size = glam::DVec2::new(
                f64::from(size[0]) * Module::NORMAL.half,
                f64::from(size[1]) * Module::NORMAL.course,
            );
            assert!(
                (high - low - size).abs().max_element() < 0.015,
                "{low} {high}"
            );
            let own = of(&laying, PatternGenerator::Panel);
            let claims = own.iter().flat_map(|cell| &cell.claims);
            let sum: f64 = claims
                .filter(|claim| claim.0 == face)
                .map(|(_, claim)| claim.area())
                .sum();
            assert!((sum - (high - low).element_product()).abs() < 1e-6, "{sum}");
            check_bond_beside(&laying, face, &hull);
        }
    }
}

/// In the rows beside a panel, half bricks never stand on each other.
fn check_bond_beside(laying: &Laying, face: FaceId, panel: &Footprint) {
    let [low, high] = panel.bounds();
    let half = 1.2 * Module::NORMAL.half;
    let mut rows: Vec<(f64, bool)> = Vec::new();
    let claims = laying.face_map(face).claims().list();
    for claim in claims {
        let [from, to] = claim.polygon.bounds();
        let is_beside =
            (to.x - low.x).abs() < 1e-6 && from.y > low.y - 1e-6 && to.y < high.y + 1e-6;
        let is_own = laying.cells()[claim.cell as usize].generator == PatternGenerator::Panel;
        if is_beside && !is_own {
            rows.push((from.y, to.x - from.x < half));
        }
    }
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert!(rows.len() >= 8, "{}", rows.len());
    assert!(rows.windows(2).all(|w| !(w[0].1 && w[1].1)), "{rows:?}");
}

#[test]
fn baskets_are_woven_in_whole_squares() {
    let text = r#"{"type":"Seq","children":[{"type":"ByFeature","face":
        {"type":"ByLabel","cases":{"Column":
            {"type":"Orientation","vertical":{"type":"Panel","bond":1}}}}},{"type":"Bricks"}]}"#;
    let laying = laid(
        Rule::Steps,
        &steps(8.0, 20.0),
        PatternTree::read(text).unwrap(),
    );
    let woven = of(&laying, PatternGenerator::Panel);
    assert_eq!(woven.len(), 8 * 2 * 3 * 3);
    assert!(woven.iter().all(|cell| cell.sort == CellSort::Whole));
    assert!(Measures::new(&laying).gap < 1e-3);
}

#[test]
fn panels_without_room_are_told_and_the_face_goes_on() {
    let laying = preset(Rule::Steps, &steps(4.0, 16.0), "diagonal");
    let told = laying.warnings();
    let is_told = |told: &LayingWarning| matches!(told, LayingWarning::NoRoom { .. });
    assert!(told.len() == 8 && told.iter().all(is_told), "{told:?}");
    assert!(of(&laying, PatternGenerator::Panel).is_empty());
    assert!(Measures::new(&laying).gap < 1e-3);
    // No panel is laid over another one.
    let text = r#"{"type":"ByFeature","face":{"type":"Seq","children":[{"type":"Panel"},{"type":"Panel"}]}}"#;
    let twice = laid(
        Rule::Block,
        &[20.0, 14.0, 18.0],
        PatternTree::read(text).unwrap(),
    );
    assert_eq!(twice.warnings().len(), 6);
    assert!(Measures::new(&twice).overlap < 1e-6);
}

#[test]
fn three_bricks_two_of_them_diagonal_fill_a_top_corner() {
    let text = r#"{"type":"ByFeature","corner":{"type":"StepCorners"}}"#;
    let laying = laid(
        Rule::Block,
        &[20.0, 14.0, 18.0],
        PatternTree::read(text).unwrap(),
    );
    let cells = of(&laying, PatternGenerator::StepCorners);
    // Three bricks at each of the four top corners, one at each of the four below.
    assert_eq!(cells.len(), 4 * 3 + 4);
    assert!(pairs(laying.cells()).iter().all(|&[a, b]| {
        let [a, b] = [a, b].map(|k| &laying.cells()[k as usize].claimed);
        a.shared_volume(b) < 1e-9
    }));
    let top = laying.building().face_ids().find(|&face| {
        let face = laying.building().face(face);
        !is_wall(face) && face.surface.frame(0.0, 0.0).normal.y > 0.9
    });
    let map = laying.face_map(top.expect("a top"));
    let side = 2.0 * Module::NORMAL.half;
    assert!(
        (map.claimed() / (4.0 * side * side) - 1.0).abs() < 0.03,
        "{}",
        map.claimed()
    );
    let special = cells.iter().filter(|cell| cell.sort == CellSort::Special);
    let special: Vec<&MasonryCell> = special.copied().collect();
    for three in special.chunks(3) {
        assert!(three.iter().all(|cell| cell.feature == three[0].feature));
        // The two diagonal ones meet the walls, the third does not.
        assert_eq!([0, 1, 2].map(|k| three[k].claims.len()), [2, 2, 1]);
        let oblique = |cell: &MasonryCell| {
            let mut normals = cell.claimed.planes().map(|plane| plane.normal);
            normals.any(|n| n.x.abs() > 0.1 && n.z.abs() > 0.1)
        };
        assert_eq!([0, 1, 2].map(|k| oblique(three[k])), [true, true, false]);
    }
}

#[test]
fn cement_stones_lie_along_the_treads_with_bricks_between() {
    let laying = preset(Rule::Steps, &steps(6.0, 16.0), "cement");
    let stones = of(&laying, PatternGenerator::CementStones);
    let (corners, edges): (Vec<&MasonryCell>, Vec<&MasonryCell>) = stones
        .iter()
        .copied()
        .partition(|cell| matches!(cell.feature, Feature::Corner(_)));
    // Four steps have two top corners in front, the landing has two at its back, and each cap has four.
    assert_eq!(corners.len(), 10 + 8);
    assert!(edges.len() >= 10, "{}", edges.len());
    for cell in &stones {
        let [low, high] = cell.claimed.bounds();
        assert!((high.y - low.y - Module::NORMAL.course).abs() < 0.01);
        let [from, to] = cell.body.bounds();
        let out = (to - from) - (high - low);
        // Corner stones stand out on two sides, stones of edges in front only.
        let is_corner = matches!(cell.feature, Feature::Corner(_));
        let count = [out.x, out.z]
            .iter()
            .filter(|by| (**by - 0.04).abs() < 1e-9)
            .count();
        assert_eq!(
            (count, out.y.abs() < 1e-9),
            (1 + usize::from(is_corner), true)
        );
        for (plane, side) in cell.body.planes().zip(cell.body.sides()) {
            assert_eq!(side.roughness > 0.0, plane.normal.y.abs() < 0.5);
        }
    }
    // Risers and sides between the stones are bricks.
    let bricks = of(&laying, PatternGenerator::Bricks).len();
    assert!(bricks > 4 * stones.len(), "{bricks}");
}
