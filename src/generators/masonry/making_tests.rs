//! Properties of the steps in which blocks are made.

use super::MasonryEngine;
use super::tests::laid;
use crate::generators::Engine;
use crate::generators::scene_picture::SceneSource;
use crate::scene::Scene;
use glam::Vec3;
use std::collections::BTreeSet;
use std::sync::Arc;

fn engine(link: &str) -> MasonryEngine {
    laid(&format!("make=masonry&size=128&{link}")).expect("a building")
}

/// The words of the steps of all blocks, each list once.
fn lists(engine: &MasonryEngine) -> BTreeSet<Vec<&'static str>> {
    let count = engine.made.cells.made().map_or(0, |all| all.cells().len());
    let ids = 1..=count as u32;
    ids.map(|id| engine.made.block_steps(id)).collect()
}

/// The box around the body with this id (units of the scene).
fn size(scene: &Scene, id: u32) -> Vec3 {
    let own = scene.instances.iter().filter(|instance| instance.id == id);
    let places = own.flat_map(|instance| {
        let body = &scene.bodies[instance.body as usize];
        let positions = body.levels[0].positions.iter();
        positions.map(|&p| instance.place.of(p))
    });
    let start = (Vec3::MAX, Vec3::MIN);
    let (low, high) = places.fold(start, |(low, high), p| (low.min(p), high.max(p)));
    high - low
}

#[test]
fn bricks_are_clipped_shrunk_and_chamfered_and_stones_are_rounded() {
    let bricks = lists(&engine("building=gate&pattern=bricks&dressing=same"));
    assert!(bricks.contains(&vec!["claim", "joints", "chamfer", "set"]));
    assert!(bricks.contains(&vec!["clip", "claim", "joints", "chamfer", "set"]));
    assert!(bricks.iter().flatten().all(|&word| word != "bumps"));
    let stones = lists(&engine(
        "building=block&pattern=ashlar&module=ashlar&walls=honey&rough=0.5",
    ));
    assert_eq!(
        Vec::from_iter(stones),
        [["claim", "joints", "round", "bumps", "set"]]
    );
}

#[test]
fn each_step_shows_the_block_and_it_becomes_smaller() {
    let links = [
        "building=gate&pattern=bricks&dressing=same",
        "building=gate&pattern=ashlar&module=ashlar&walls=honey&rough=0.5",
    ];
    for link in links {
        let engine = engine(link);
        let count = engine.made.cells.made().expect("cells").cells().len() as u32;
        for id in (1..=count).step_by(37) {
            let steps = engine.made.block_steps(id);
            let scene = |at| engine.made.step_scene("", (id, at)).expect("a scene");
            let sizes: Vec<Vec3> = (0..steps.len()).map(|at| size(&scene(at), id)).collect();
            let claim = steps
                .iter()
                .position(|&word| word == "claim")
                .expect("a claim");
            for (at, size) in sizes.iter().enumerate() {
                assert!(size.min_element() > 0.0, "{link}, {id}: {}", steps[at]);
            }
            // Joints take a part of the claim, unless something stands out of the wall. Edges take a part of the rest.
            let cell = &engine.made.cells.made().expect("cells").cells()[id as usize - 1];
            let first = claim + usize::from(!Arc::ptr_eq(&cell.claimed, &cell.body));
            for pair in sizes[first..=claim + 2].windows(2) {
                assert!(
                    (pair[1] - pair[0]).max_element() < 1e-4,
                    "{link}, {id}: {sizes:?}"
                );
            }
            // The claim fills the picture. It is turned, so the box around it is larger than its own.
            let diagonal = sizes[claim].length();
            assert!((1.4..3.0).contains(&diagonal), "{link}, {id}: {diagonal}");
            let set = scene(steps.len() - 1);
            let others = set.instances.iter().filter(|other| other.id != id);
            assert!(others.count() >= 2, "{link}, {id}");
        }
    }
}

#[test]
fn only_blocks_that_are_laid_have_steps() {
    let engine = engine("building=block&pattern=bricks");
    let count = engine.made.cells.made().expect("cells").cells().len() as u32;
    for id in [0, count + 1, u32::MAX] {
        assert!(engine.made.block_steps(id).is_empty(), "{id}");
        assert!(engine.made.step_scene("", (id, 0)).is_none(), "{id}");
    }
    assert!(engine.made.step_scene("", (1, 99)).is_none());
}

#[test]
fn a_picked_block_tells_its_steps_in_views_of_blocks() {
    let mut engine = engine("building=block&pattern=bricks");
    for view in ["picture", "sizes", "features"] {
        engine.view(view);
        assert_eq!(engine.states(1), engine.made.block_steps(1), "{view}");
    }
    engine.view("plan");
    assert_eq!(engine.states(1), [""; 0]);
}
