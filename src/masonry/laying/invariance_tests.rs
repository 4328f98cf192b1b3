//! Changes that must leave the cells as they are, and areas that must add up.

use super::site::PIXELS;
use super::tests::{BRICKS, TREES, begun, draft, laid};
use super::{CellSort, Laying, Measures};
use crate::building::{
    CircularArc, Draft, FaceId, FaceSurface, Module, Path, Piece, Rule, Sweep, labels,
};
use crate::masonry::tree::PatternGenerator;
use glam::DVec3;

/// The rules whose buildings have flat faces and cylinders, no sectors of disks.
const SWEPT: [Rule; 7] = [
    Rule::Block,
    Rule::LHouse,
    Rule::Gabled,
    Rule::Wall,
    Rule::Gate,
    Rule::Steps,
    Rule::Sheet,
];

/// A draft whose places and directions are turned or mirrored about the origin.
fn mapped(draft: &Draft, map: impl Fn(DVec3) -> DVec3) -> Draft {
    let mut draft = draft.clone();
    let is_mirror = map(DVec3::X).cross(map(DVec3::Y)).dot(map(DVec3::Z)) < 0.0;
    let piece = |piece: &Piece| match *piece {
        // The direction of s turns round in a mirror, so that s, t and the normal stay right-handed.
        Piece::Line { from, to } if is_mirror => Piece::Line {
            from: map(to),
            to: map(from),
        },
        Piece::Line { from, to } => Piece::Line {
            from: map(from),
            to: map(to),
        },
        Piece::Arc(arc) => Piece::Arc(CircularArc {
            centre: map(arc.centre),
            x: map(arc.x),
            y: map(arc.y),
            ..arc
        }),
    };
    for vertex in &mut draft.vertices {
        *vertex = map(*vertex);
    }
    for arc in &mut draft.arcs {
        (arc.centre, arc.axis) = (map(arc.centre), map(arc.axis));
    }
    for face in &mut draft.faces {
        if is_mirror {
            face.loops.iter_mut().for_each(|ring| ring.reverse());
        }
        if let Some(FaceSurface::Sweep(sweep)) = &face.surface {
            let pieces = sweep.profile().pieces().iter().map(piece).collect();
            face.surface = Some(FaceSurface::Sweep(Sweep::new(
                Path::new(pieces),
                map(sweep.direction()),
            )));
        }
    }
    draft.sorted()
}

/// The numbers of bricks and of cut ones. Those of roofs and slopes do not count: their rows begin at one end.
fn counts(laying: &Laying) -> [usize; 2] {
    let of_roof = [PatternGenerator::Tiles, PatternGenerator::Raking];
    let bricks = laying.cells().iter();
    let bricks =
        bricks.filter(|cell| !of_roof.contains(&cell.generator) && cell.sort != CellSort::Raked);
    let cut = bricks.clone().filter(|cell| cell.sort == CellSort::Cut);
    [bricks.count(), cut.count()]
}

#[test]
fn the_order_of_faces_does_not_change_the_cells() {
    for (rule, tree) in Rule::ALL
        .into_iter()
        .flat_map(|rule| TREES.map(|tree| (rule, tree)))
    {
        let first = draft(rule, &tree.1);
        let mut turned = first.clone();
        turned.faces.reverse();
        let cells = |draft: Draft| laid(&draft.sorted(), tree, 1).cells().to_vec();
        assert!(cells(first) == cells(turned), "{rule:?}");
    }
}

#[test]
fn a_turned_building_has_as_many_bricks() {
    for rule in SWEPT {
        let draft = draft(rule, &Module::NORMAL);
        let first = counts(&laid(&draft.clone().sorted(), BRICKS, 1));
        let turned = mapped(&draft, |p| DVec3::new(p.z, p.y, -p.x));
        assert_eq!(first, counts(&laid(&turned, BRICKS, 1)), "{rule:?}");
    }
}

#[test]
fn a_mirrored_building_has_as_many_bricks() {
    // Only buildings with straight heads: `mapped` does not turn the direction of arcs round.
    let straight = [
        Rule::Block.draft(&Module::NORMAL, &[]),
        Rule::LHouse.draft(&Module::NORMAL, &[36.0, 24.0, 12.0, 12.0, 36.0, 2.0, 0.0]),
        Rule::Steps.draft(&Module::NORMAL, &[]),
    ];
    for draft in straight {
        let first = counts(&laid(&draft.clone().sorted(), BRICKS, 1));
        let mirrored = mapped(&draft, |p| DVec3::new(-p.x, p.y, p.z));
        assert_eq!(first, counts(&laid(&mirrored, BRICKS, 1)));
    }
}

#[test]
fn claims_and_gaps_of_bricks_make_the_faces() {
    for rule in [Rule::Block, Rule::Wall, Rule::Gate, Rule::Steps, Rule::Ring] {
        let laying = laid(&draft(rule, &Module::NORMAL), BRICKS, 1);
        for face in laying.textured_faces() {
            let map = laying.face_map(face);
            let sum = map.claimed() + map.gap() - map.area();
            let overlap = map.overlap();
            assert!(
                (-1e-6..overlap + 1e-6).contains(&sum),
                "{rule:?} {face:?} {sum} {overlap}"
            );
            assert!(overlap < 1e-4 * map.area(), "{rule:?} {face:?} {overlap}");
        }
    }
}

#[test]
fn finer_pixels_change_hardly_a_cell() {
    for rule in [Rule::Gabled, Rule::Gate, Rule::Tower] {
        let draft = draft(rule, &Module::NORMAL);
        let coarse = laid(&draft, BRICKS, 1);
        let mut fine = begun(&draft, BRICKS, 1).expect("a plan");
        fine.site.pixels = 2.0 * PIXELS;
        while !fine.advance(64) {}
        let [a, b] = [&coarse, &fine].map(|laying| laying.cells());
        let other = a.iter().filter(|cell| !b.contains(cell)).count();
        assert!(other * 100 <= a.len(), "{rule:?}: {other} of {}", a.len());
    }
}

#[test]
fn every_tree_is_laid_on_every_building() {
    for (rule, tree) in Rule::ALL
        .into_iter()
        .flat_map(|rule| TREES.map(|tree| (rule, tree)))
    {
        let laying = laid(&draft(rule, &tree.1), tree, 1);
        assert_eq!(laying.warnings(), [], "{rule:?} {tree:?}");
        let (building, found) = (laying.building(), Measures::new(&laying));
        let has = |face: FaceId, wanted: &str| {
            let mut own = building.face(face).labels.iter();
            own.any(|label| label == wanted)
        };
        // Tiles leave the undersides and the ends of a roof bare; blocks cover all of it.
        let is_bare = |&face: &FaceId| {
            let is_tiled = tree != TREES[0] && has(face, labels::ROOF);
            has(face, labels::GLASS) || (is_tiled && !laying.site.is_roof(face))
        };
        let clad = building.face_ids().filter(|face| !is_bare(face)).count();
        assert_eq!(laying.textured_faces().count(), clad, "{rule:?} {tree:?}");
        assert!(
            found.gap < 0.01 && found.shared_volume < 0.01,
            "{rule:?} {tree:?} {found:?}"
        );
    }
}
