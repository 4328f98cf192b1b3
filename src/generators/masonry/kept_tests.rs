//! After an edit only what changed is laid again.

use super::MasonryEngine;
use super::kept::marks;
use super::stages::LAYING;
use super::tests::{laid, recipe};
use crate::generators::Engine;
use crate::solid::Surface;
use std::collections::BTreeSet;
use std::rc::Rc;

const BEFORE: &str = "make=masonry&building=gabled&pattern=bricks";
/// The recipe with segmental heads of openings.
const AFTER: &str = "make=masonry&building=gabled&pattern=bricks&gabled_head=1";

/// Works up to the end of the laying. Returns the number of steps, and how many kept blocks stood at the first step.
fn lay(engine: &mut MasonryEngine) -> (usize, usize) {
    let (mut steps, mut stood) = (0, None);
    while engine.at().is_some_and(|at| at <= LAYING) {
        steps += usize::from(engine.is_step());
        engine.advance();
        if engine.progress().steps > 0 && stood.is_none() {
            stood = Some(engine.made.kept.after(0).len());
        }
    }
    (steps, stood.expect("a step"))
}

/// The surfaces of the bodies of a wall.
fn bodies(engine: &MasonryEngine) -> Vec<Rc<[Surface]>> {
    let wall = engine.made.laid.made().expect("a wall");
    wall.bodies.iter().map(|body| body.levels.clone()).collect()
}

#[test]
fn after_an_edit_blocks_that_stay_stand_still() {
    let mut engine = laid(BEFORE).expect("a wall");
    let before = bodies(&engine);
    engine.ask(&recipe(AFTER));
    engine.take_up();
    let (steps, stood) = lay(&mut engine);
    let fresh = laid(AFTER).expect("a wall");
    let all = lay(&mut MasonryEngine::new(&recipe(AFTER)));
    let count = fresh.progress().cells;
    assert_eq!(all.1, 0);
    assert!(2 * stood > count, "{stood} of {count} stood still");
    assert!(2 * steps < all.0, "{steps} of {} steps", all.0);
    while engine.at().is_some_and(|at| at < 4) {
        engine.advance();
    }
    assert_eq!(engine.digest(), fresh.digest());
    // Blocks that stay take their bodies from the last wall.
    let is_old = |body: &Rc<[Surface]>| before.iter().any(|old| Rc::ptr_eq(old, body));
    let after = bodies(&engine);
    let old = after.iter().filter(|body| is_old(body)).count();
    assert!(2 * old > after.len(), "{old} of {}", after.len());
    // Without an edit all is laid again, and no body of a block is made anew.
    engine.forget_steps();
    assert_eq!(lay(&mut engine), all);
    let again = bodies(&engine);
    let is_known = |body: &Rc<[Surface]>| after.iter().any(|old| Rc::ptr_eq(old, body));
    let wall = engine.made.laid.made().expect("a wall");
    let blocks = wall.instances.iter().filter(|one| one.id > 0);
    let blocks: BTreeSet<u32> = blocks.map(|one| one.body).collect();
    assert!(blocks.len() > 10);
    for body in blocks {
        assert!(is_known(&again[body as usize]), "body {body}");
    }
}

#[test]
fn another_colour_changes_block_by_block() {
    let mut engine = laid(BEFORE).expect("a wall");
    let all = lay(&mut MasonryEngine::new(&recipe(BEFORE)));
    engine.ask(&recipe(&format!("{BEFORE}&walls=yellow")));
    engine.take_up();
    let (steps, stood) = lay(&mut engine);
    assert_eq!((steps, stood > 0), (all.0, true));
}

#[test]
fn marks_tell_the_cells_of_a_house_apart() {
    let engine = laid("make=masonry&building=lhouse").expect("a house");
    let all = marks(engine.made.cells.made().expect("cells").cells());
    let different: BTreeSet<u32> = all.iter().copied().collect();
    assert!(
        different.len() + 3 > all.len(),
        "{} of {}",
        different.len(),
        all.len()
    );
}
