//! Properties of features: classes of corners, angles of edges, sizes in modules.

use super::tests::{all, built};
use super::*;
use glam::DVec3;
use std::collections::BTreeMap;

/// The number of corners by their edges, convex edges and concave edges.
fn classes(building: &Building) -> BTreeMap<[usize; 3], usize> {
    let mut all = BTreeMap::new();
    for corner in building.corners() {
        let class = &corner.class;
        *all.entry([class.valence, class.convex, class.concave])
            .or_insert(0) += 1;
    }
    all
}

#[test]
fn corners_have_the_classes_of_the_paper() {
    let of =
        |rule: Rule, numbers: &[f64]| built(rule.word(), &rule.draft(&Module::NORMAL, numbers));
    assert_eq!(
        classes(&of(Rule::Block, &[])),
        BTreeMap::from([([3, 3, 0], 8)])
    );
    // An L with its door alone, and with a window in each of the other walls, too. The wing's roof meets the main house at
    // three corners: in the slope, above the inner corner, and at the foot of the other valley. Each opening has four rim
    // corners, and four at its pane.
    let l = [0.0, 1.0].map(|windows| {
        let numbers = [44.0, 36.0, 18.0, 16.0, 34.0, windows, 0.0];
        of(Rule::LHouse, &numbers)
    });
    for (building, openings) in l.iter().zip([1, 6]) {
        let panes = building.faces().iter();
        let panes = panes.filter(|face| face.labels == [labels::GLASS]);
        assert_eq!(panes.count(), openings);
        let wanted = [
            ([3, 0, 3], 4 * openings),
            ([3, 1, 2], 1),
            ([3, 2, 1], 2 + 4 * openings),
            ([3, 3, 0], 13),
            ([4, 2, 2], 1),
        ];
        assert_eq!(classes(building), BTreeMap::from(wanted));
    }
    let [bare, windows] = l;
    let mut inner = bare
        .corners()
        .iter()
        .filter(|corner| corner.class.concave == 1 && bare.vertex(corner.vertex).position.y == 0.0);
    assert_eq!(
        inner.next().map(|corner| corner.class.single_concave),
        Some(Some(Heading::Up))
    );
    let is_rim = |corner: &&Corner| corner.labels.iter().any(|label| label == labels::SILL);
    for corner in windows.corners().iter().filter(is_rim) {
        assert_eq!(corner.class.single_concave, Some(Heading::Level));
    }
}

#[test]
fn dihedral_angles_are_those_of_the_solid() {
    use std::f64::consts::{PI, TAU};
    for walls in 3..=12 {
        let numbers = [f64::from(walls), 20.0, 10.0, 2.0];
        let ring = built("ring", &Rule::Ring.draft(&Module::NORMAL, &numbers));
        let outer = PI - TAU / f64::from(walls);
        let mut found = [0, 0];
        for edge in ring.edges().iter().filter(|edge| edge.is_vertical()) {
            let k = usize::from(edge.bend == Bend::Concave);
            let wanted = if k == 0 { outer } else { TAU - outer };
            assert!(
                (edge.dihedral - wanted).abs() < 1e-9,
                "{walls} {}",
                edge.dihedral
            );
            found[k] += 1;
        }
        assert_eq!(found, [walls, walls]);
    }
}

#[test]
fn sizes_are_counted_as_masons_do() {
    let module = Module::NORMAL;
    for (name, _, building) in all() {
        let is_plain = ["block", "lhouse", "wall"]
            .iter()
            .any(|rule| name.starts_with(rule));
        for edge in building
            .edges()
            .iter()
            .filter(|edge| is_plain && edge.is_vertical() && edge.path.tangent(0.0).y.abs() > 0.999)
        {
            let courses = edge.length() / module.course;
            let over = edge.length() - courses.round() * module.course;
            let joints = over / module.joint;
            // A solid is whole courses less a joint, an opening whole courses and a joint. From one to the other they
            // are whole.
            assert!(
                (joints - joints.round()).abs() < 1e-6 && joints.abs() < 1.5,
                "{name} {over}"
            );
        }
    }
}

#[test]
fn edges_are_walked_by_their_first_face() {
    for (name, _, building) in all() {
        for id in building.edge_ids() {
            let frame = building.edge_frame(id, 0.5 * building.edge(id).length());
            for (side, face) in building.edge(id).faces.iter().enumerate() {
                let (Some(face), Some(inward)) = (*face, frame.inward[side]) else {
                    continue;
                };
                let surface = &building.face(face).surface;
                let flat = |p: DVec3| surface.project(p).truncate();
                let (inside, outside) = (
                    flat(frame.origin + inward * 1e-4),
                    flat(frame.origin - inward * 1e-4),
                );
                let rings = &building.face(face).rings;
                let covers = |p: glam::DVec2| {
                    let period = surface.period().unwrap_or(0.0);
                    [-period, 0.0, period].iter().any(|shift| {
                        let p = p + glam::DVec2::X * *shift;
                        let within = rings
                            .iter()
                            .filter(|ring| crate::domain::ring_contains(ring, p));
                        within.count() % 2 == 1
                    })
                };
                // Chords of arcs lie inside of them, by less than a millimetre here.
                let is_straight = matches!(building.edge(id).path.pieces(), [Piece::Line { .. }]);
                if is_straight {
                    assert!(covers(inside) && !covers(outside), "{name} {face:?}");
                }
            }
        }
    }
}
