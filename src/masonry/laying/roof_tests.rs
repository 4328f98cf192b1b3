//! Properties of quoins, tiles, raking bricks and copings.

use super::{CellSort, Feature, Laying, LayingParams, MasonryCell, Measures};
use crate::building::{Building, Module, Rule};
use crate::masonry::block::Polyhedron;
use crate::masonry::module::{ASHLAR, BLOCK};
use crate::masonry::plan::thicknesses;
use crate::masonry::tree::{PRESETS, PatternGenerator, TreePreset};
use glam::DVec3;
use std::sync::Arc;

fn laid(rule: Rule, tree: &TreePreset, module: Module) -> Laying {
    let numbers: Vec<f64> = rule.numbers().iter().map(|number| number.default).collect();
    let building = Arc::new(Building::new(&rule.draft(&module, &numbers)).expect("a building"));
    let thick = thicknesses(&building).expect("a mesh");
    let params = LayingParams {
        module,
        is_by_hand: false,
        seed: 1,
    };
    let deep = |face: crate::building::FaceId| thick[face.index()];
    let mut laying = Laying::new(building, tree.tree(), params, deep).expect("a plan");
    while !laying.advance(16) {}
    laying
}

fn of(word: &str, rule: Rule) -> Laying {
    let tree = TreePreset::of_word(word).expect("a tree");
    laid(rule, tree, Module::NORMAL)
}

fn made_by(laying: &Laying, generator: PatternGenerator) -> Vec<&MasonryCell> {
    let cells = laying.cells().iter();
    cells.filter(|cell| cell.generator == generator).collect()
}

/// The least and the greatest coordinate of a body along an axis.
fn extent(body: &Polyhedron, axis: DVec3) -> [f64; 2] {
    let along = body.vertices().iter().map(|p| p.dot(axis));
    along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
        [low.min(v), high.max(v)]
    })
}

#[test]
fn every_tree_covers_every_building() {
    for tree in &PRESETS {
        let module = match tree.word {
            "rgb" => BLOCK,
            "ashlar" => ASHLAR,
            _ => Module::NORMAL,
        };
        for rule in Rule::ALL {
            let laying = laid(rule, tree, module);
            let found = Measures::new(&laying);
            assert!(laying.cells().len() > 20, "{} {rule:?}", tree.word);
            for cell in laying.cells() {
                assert!(
                    cell.claimed.is_sound() && cell.claimed.is_convex(0.01),
                    "{cell:?}"
                );
                assert!(cell.claims.iter().all(|(_, claim)| claim.area() > 0.0));
            }
            // The trees for steps have tests of their own.
            let is_whole = !["cement", "rgb"].contains(&tree.word);
            assert!(
                !is_whole || laying.warnings().is_empty(),
                "{} {rule:?}",
                tree.word
            );
            let fits = found.gap <= 0.012 && found.shared_volume <= 0.004;
            assert!(!is_whole || fits, "{} {rule:?} {found:?}", tree.word);
        }
    }
}

#[test]
fn tiles_lie_on_each_other_by_their_lap() {
    let laying = of("bricks", Rule::Gabled);
    let tiles = made_by(&laying, PatternGenerator::Tiles);
    let slope = tiles[tiles.len() / 2].outwards;
    let up = (DVec3::Y - slope * slope.y).normalize();
    let own: Vec<&MasonryCell> = tiles
        .into_iter()
        .filter(|cell| matches!(cell.feature, Feature::Face(_)) && cell.outwards.dot(slope) > 0.999)
        .collect();
    let whole = own.iter().filter(|cell| !cell.claims.is_empty());
    let mut tails: Vec<f64> = whole.map(|cell| extent(&cell.claimed, up)[0]).collect();
    tails.sort_by(f64::total_cmp);
    tails.dedup_by(|next, kept| (*next - *kept).abs() < 1e-3);
    assert!(tails.len() > 10);
    let gauge = (tails[tails.len() - 1] - tails[0]) / (tails.len() - 1) as f64;
    // The lap is half of the length, or a little more, since rows end at the ridge.
    assert!(
        tails.windows(2).all(|w| (w[1] - w[0] - gauge).abs() < 1e-6),
        "{tails:?}"
    );
    assert!((0.13..=0.15 + 1e-9).contains(&gauge), "{gauge}");
    let mut lying = 0;
    for upper in own.iter().filter(|cell| !cell.claims.is_empty()) {
        let under = upper_side(&upper.claimed, slope);
        let on = own.iter().filter(|lower| {
            let top = lower
                .claimed
                .planes()
                .find(|plane| plane.normal.dot(under) > 1.0 - 1e-9);
            let touches = |p: &DVec3| top.is_some_and(|plane| plane.distance(*p).abs() < 1e-6);
            upper
                .claimed
                .vertices()
                .iter()
                .filter(|p| touches(p))
                .count()
                >= 3
        });
        lying += usize::from(on.count() > 0);
    }
    assert!(lying * 10 > own.len() * 8, "{lying} of {}", own.len());
    let found = Measures::new(&laying);
    assert!(found.shared_volume < 1e-3, "{found:?}");
}

/// The normal of a tile's upper side, to which its lower side is parallel.
fn upper_side(body: &Polyhedron, slope: DVec3) -> DVec3 {
    let planes = body.planes().map(|plane| plane.normal);
    planes.fold(DVec3::Y, |best, normal| {
        if normal.dot(slope) > best.dot(slope) {
            normal
        } else {
            best
        }
    })
}

#[test]
fn roofs_are_covered_up_to_their_ridges_and_valleys() {
    for rule in [Rule::Gabled, Rule::LHouse] {
        let laying = of("bricks", rule);
        let roofs: Vec<_> = laying
            .textured_faces()
            .filter(|&face| laying.building().face(face).labels == ["Roof"])
            .collect();
        assert_eq!(roofs.len(), if rule == Rule::LHouse { 4 } else { 2 });
        for face in roofs {
            let map = laying.face_map(face);
            assert!(
                map.gap() < 1e-3 * map.area(),
                "{rule:?} {} {}",
                map.gap(),
                map.area()
            );
        }
        let ridge = made_by(&laying, PatternGenerator::Tiles)
            .into_iter()
            .filter(|cell| matches!(cell.feature, Feature::Edge(_)));
        assert!(ridge.count() > 10);
    }
}

#[test]
fn quoins_alternate_and_end_on_course_lines() {
    for rule in [Rule::Gabled, Rule::LHouse, Rule::Block] {
        let laying = of("quoins", rule);
        let quoins = made_by(&laying, PatternGenerator::Quoins);
        assert!(
            quoins
                .iter()
                .any(|cell| matches!(cell.feature, Feature::Corner(_)))
        );
        let mut alternating = 0;
        for id in laying.building().edge_ids() {
            let edge = laying.building().edge(id);
            let corners = edge.corners.map(|corner| corner.map(Feature::Corner));
            let is_own = |cell: &&&MasonryCell| {
                cell.feature == Feature::Edge(id) || corners.contains(&Some(cell.feature))
            };
            let are_walls = edge.labels.is_empty() && edge.is_vertical();
            let Some(face) = edge.faces[0].filter(|_| are_walls) else {
                continue;
            };
            let mut stones: Vec<(f64, f64)> = Vec::new();
            for cell in quoins.iter().filter(is_own) {
                let on = cell.claims.iter().filter(|claim| claim.0 == face);
                for [low, high] in on.map(|(_, claim)| claim.bounds()) {
                    let lines = &laying.plan().grid(face).t;
                    for t in [low.y, high.y] {
                        assert!(
                            lines.iter().any(|line| (line - t).abs() < 1e-5),
                            "{rule:?} {t}"
                        );
                    }
                    stones.push((low.y, high.x - low.x));
                }
            }
            stones.sort_by(|a, b| a.0.total_cmp(&b.0));
            // Between a corner and a window of the L-shaped house there is no room for long stones.
            if rule == Rule::LHouse {
                continue;
            }
            let ratios = stones.windows(2).map(|w| w[0].1 / w[1].1);
            for (k, ratio) in ratios.enumerate() {
                assert!(
                    (ratio.max(1.0 / ratio) - 1.5).abs() < 0.2,
                    "{rule:?} {k} {ratio}"
                );
                alternating += 1;
            }
        }
        assert!(
            rule == Rule::LHouse || alternating > 8,
            "{rule:?} {alternating}"
        );
    }
}

#[test]
fn raking_bricks_follow_the_slopes_of_gables() {
    for rule in [Rule::Gabled, Rule::LHouse] {
        let laying = of("bricks", rule);
        let raking = made_by(&laying, PatternGenerator::Raking);
        let whole = raking.iter().filter(|cell| cell.sort == CellSort::Whole);
        assert!(whole.count() * 10 > raking.len() * 8 && raking.len() > 60);
        assert!(Measures::new(&laying).raked > 0.0);
    }
}

#[test]
fn copings_stand_on_their_wall_and_over_both_sides() {
    for rule in [Rule::Wall, Rule::Gate, Rule::Ring, Rule::Tower] {
        let laying = of("coped", rule);
        let top = laying
            .building()
            .vertices()
            .iter()
            .map(|v| v.position.y)
            .fold(0.0, f64::max);
        let stones = made_by(&laying, PatternGenerator::Coping);
        assert!(stones.len() > 4, "{rule:?}");
        let mut volume = 0.0;
        for stone in &stones {
            let [low, high] = extent(&stone.claimed, DVec3::Y);
            assert!(
                (low - top).abs() < 1e-9 && (high - top - 0.06).abs() < 1e-9,
                "{rule:?}"
            );
            volume += stone.claimed.volume();
        }
        let face = laying.textured_faces().find(|&face| {
            let place = laying.building().face(face).bounds()[0];
            let frame = laying.building().face(face).surface.frame(place.x, place.y);
            frame.normal.y > 0.99 && (frame.origin.y - top).abs() < 1e-6
        });
        // All of the top is under a stone.
        let area = laying.face_map(face.expect("a top")).area();
        assert!(
            volume > 0.06 * area && volume < 0.06 * area * 1.5,
            "{rule:?} {volume} {area}"
        );
        assert!(Measures::new(&laying).shared_volume < 5e-3, "{rule:?}");
    }
}
