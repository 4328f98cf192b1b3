//! Tests of bricks that are turned by hand.

use super::tests::recipe;
use super::view_tests::{engine, laying};
use super::{MasonryEngine, SCHEMA};
use crate::building::{Bend, FaceId};
use crate::generators::Engine;
use crate::masonry::laying::{Feature, Laying, MasonryCell};
use crate::notice::Code;
use crate::recipe::Recipe;
use std::collections::BTreeSet;

/// A cell's feature and vertices, as a value that can be compared.
fn key(cell: &MasonryCell) -> (Feature, String) {
    (cell.feature, format!("{:?}", cell.body.vertices()))
}

/// The faces around an edge: its own, and those at its corners.
fn around(laying: &Laying, edge: usize) -> BTreeSet<FaceId> {
    let building = laying.building();
    let edge = &building.edges()[edge];
    let corners = edge.corners.iter().flatten();
    let beside = corners.flat_map(|&id| building.corner(id).faces.iter().flatten());
    edge.faces.iter().flatten().chain(beside).copied().collect()
}

#[test]
fn a_turned_edge_changes_only_what_is_around_it() {
    for hand in ["solved", "stored"] {
        for pattern in ["bricks", "ashlar"] {
            let link = format!("building=block&hand={hand}&pattern={pattern}");
            let before = engine(&link);
            let edges = laying(&before).building().edges();
            let upright =
                |edge: &crate::building::Edge| edge.is_vertical() && edge.bend == Bend::Convex;
            let edge = edges.iter().position(upright).expect("an edge");
            let after = engine(&format!("{link}&flips=1,{edge}"));
            let near = around(laying(&before), edge);
            let far = |engine: &MasonryEngine| -> BTreeSet<(Feature, String)> {
                let cells = laying(engine).cells().iter();
                let is_far =
                    |cell: &&MasonryCell| !cell.claims.iter().any(|(face, _)| near.contains(face));
                cells.filter(is_far).map(key).collect()
            };
            assert!(far(&before).len() > 20);
            assert_eq!(far(&before), far(&after), "{link}");
            let turned = |engine: &MasonryEngine| -> Vec<(Feature, String)> {
                let cells = laying(engine).cells().iter();
                let own = cells
                    .filter(|cell| matches!(cell.feature, Feature::Edge(id) if id.index() == edge));
                own.map(key).collect()
            };
            assert_ne!(turned(&before), turned(&after), "{link}");
            let twice = engine(&format!("{link}&flips=1,{edge};1,{edge}"));
            assert_eq!(before.digest(), twice.digest());
            assert_ne!(before.digest(), after.digest());
        }
    }
}

#[test]
fn a_turned_corner_turns_its_own_brick() {
    let before = engine("building=gate");
    let corners = laying(&before)
        .cells()
        .iter()
        .filter_map(|cell| match cell.feature {
            Feature::Corner(id) => Some((id, key(cell))),
            _ => None,
        });
    let changed = corners.filter(|(id, brick)| {
        let after = engine(&format!("building=gate&flips=0,{}", id.0));
        let cells = laying(&after).cells().iter();
        cells.map(key).all(|cell| cell != *brick)
    });
    assert!(changed.take(3).count() == 3);
}

#[test]
fn flips_of_nothing_are_told() {
    let engine = engine("building=block&flips=1,900;0,1;0,77");
    let told = engine.remarks();
    assert_eq!(told.len(), 1);
    assert_eq!(told[0].code, Code::MasonryFlips);
    assert!(told[0].to_string().contains('2'), "{}", told[0]);
    let refused = |flips: &str| {
        let (recipe, notices) =
            Recipe::from_link(&[&SCHEMA], &format!("make=masonry&flips={flips}"));
        assert!(recipe.rows(super::keys::FLIPS).is_empty());
        notices.len()
    };
    let many = |count: usize| vec!["0,1"; count].join(";");
    assert_eq!(["2,1", "0,-1", "0,1,2", "1,9999999"].map(refused), [1; 4]);
    assert_eq!(refused(&many(257)), 1);
    let most = recipe(&format!("make=masonry&flips={}", many(256)));
    assert_eq!(most.rows(super::keys::FLIPS).len(), 256);
}
