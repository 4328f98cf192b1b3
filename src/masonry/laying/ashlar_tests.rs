//! Properties of random ashlar, and of lintels and sills, on whole buildings.

use super::tests::{draft, laid};
use super::{Feature, Measures};
use crate::building::{EdgeId, Module, Piece, Rule};
use crate::masonry::module::ASHLAR;
use crate::masonry::plan::is_wall;
use crate::masonry::tree::PatternGenerator;

/// The bounds of random ashlar on a rule's building: the greatest gap and shared volume.
const ASHLAR_LIMITS: [(Rule, [f64; 2]); 7] = [
    (Rule::Block, [3e-3, 1e-3]),
    (Rule::LHouse, [3e-3, 1e-3]),
    (Rule::Gabled, [3e-3, 1e-3]),
    (Rule::Wall, [3e-3, 1e-3]),
    (Rule::Gate, [3e-3, 1e-3]),
    (Rule::Steps, [3e-3, 1e-3]),
    (Rule::Tower, [3e-3, 2e-3]),
];

#[test]
fn ashlar_fills_walls_and_hardly_ever_meets_in_crosses() {
    for (rule, [gap, shared]) in ASHLAR_LIMITS {
        for seed in 1..4 {
            let laying = laid(&draft(rule, &ASHLAR), (2, ASHLAR), seed);
            let found = Measures::new(&laying);
            assert!(found.course > 0.9999, "{rule:?} {found:?}");
            assert!(
                found.gap <= gap && found.shared_volume <= shared,
                "{rule:?} {found:?}"
            );
            assert!(found.straight <= 0.1, "{rule:?} {found:?}");
        }
    }
}

/// A straight lintel and a sill end on the wall beside their window, and none ends in the opening.
#[test]
fn lintels_and_sills_lie_on_the_wall() {
    for tree in [(1, Module::NORMAL), (2, ASHLAR)] {
        let module = tree.1;
        let laying = laid(&draft(Rule::Wall, &module), tree, 1);
        let building = laying.building();
        let is_level = |id: &EdgeId| {
            let edge = building.edge(*id);
            let is_line = matches!(edge.path.pieces(), [Piece::Line { .. }]);
            is_line && !edge.is_vertical() && edge.labels.iter().any(|label| label == "Window")
        };
        let mut lintels = 0;
        for id in building.edge_ids().filter(is_level) {
            let cells = laying.cells().iter();
            let own = cells.filter(|cell| {
                cell.feature == Feature::Edge(id) && cell.generator == PatternGenerator::ArchStones
            });
            let ends = own
                .map(|cell| cell.claimed.bounds())
                .reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]);
            let Some([low, high]) = ends else { continue };
            lintels += 1;
            let path = &building.edge(id).path;
            let [a, b] = [path.point(0.0), path.point(path.length())];
            for (end, beyond) in [(a.min(b).x, -1.0), (a.max(b).x, 1.0)] {
                let found = if beyond < 0.0 {
                    end - low.x
                } else {
                    high.x - end
                };
                assert!(found > 0.5 * module.half, "{id:?} {beyond} {found}");
            }
        }
        assert!(lintels >= 4, "{lintels}");
    }
}

/// No stone of the default L-shaped house is a strip: the line of the wing's gable gives way to those of windows.
#[test]
fn lines_of_gables_make_no_strips() {
    let laying = laid(&draft(Rule::LHouse, &ASHLAR), (2, ASHLAR), 1);
    for id in laying.building().face_ids() {
        if is_wall(laying.building().face(id)) {
            for w in laying.plan().grid(id).s.windows(2) {
                assert!(w[1] - w[0] > 0.5 * ASHLAR.half, "{id:?} {w:?}");
            }
        }
    }
}
