//! Dragging: the cells flow meanwhile, and the final result is the one of the link.

use crate::common::{finished_recipe, recipe};
use crate::paving::OfPavement;
use bubblestone::domain::Outline;
use bubblestone::generators::ALL;
use bubblestone::generators::pavement::PavementRecipe;
use bubblestone::recipe::Recipe;
use bubblestone::studio::Studio;
use glam::DVec2;

/// Small pavements with all kinds of cells, lines, cells on the edge, parts, spots, and tiles.
const LINKS: [&str; 8] = [
    "size=128&cs=13",
    "size=128&cs=13&kind=rectangle&ca=2&edge=on",
    "size=128&cs=13&kind=circle&vs=0.2",
    "size=128&cs=13&kind=ellipse&ca=2&stone=skin&move=rk4",
    "size=128&cs=12&lines=0.2,0.2,0.8,0.8;0.3,0.8,0.8,0.3&edge=on",
    "size=128&cs=12&lines=0.1,0.5,0.9,0.5&parts=0.5,0.2,2&kind=rectangle",
    "size=128&cs=14&tile=1&lines=0.2,0.2,0.8,0.8",
    "size=128&cs=12&pop=off&start=quadtree&spots=0.4,0.4,0.2,0.6&tile=1&kind=circle",
];

fn clock() -> impl FnMut() -> f64 {
    let mut time = 0.0;
    move || {
        time += 1.0;
        time
    }
}

/// A free outline with a hole. `t` moves one of its corners and the end of the first line.
fn dragged(recipe: &Recipe, t: f64) -> Recipe {
    let mut recipe = recipe.clone();
    let ring = |points: &[(f64, f64)]| points.iter().map(|&p| 128.0 * DVec2::from(p)).collect();
    let outline = Outline {
        rings: vec![
            ring(&[
                (0.1, 0.1),
                (0.9 - 0.4 * t, 0.1 + 0.3 * t),
                (0.9, 0.9),
                (0.1, 0.9),
            ]),
            ring(&[
                (0.3 + 0.1 * t, 0.6),
                (0.5 + 0.1 * t, 0.6),
                (0.4 + 0.1 * t, 0.75),
            ]),
        ],
        ..Outline::default()
    };
    assert!(recipe.set_polygon(&outline).is_ok());
    let lines = recipe.get("lines");
    if !lines.is_empty() {
        let line = format!("0.2,{},0.8,0.8", 0.2 + 0.2 * t);
        assert!(recipe.set("lines", &line).is_ok());
    }
    if !recipe.get("spots").is_empty() {
        let spot = format!("{},0.4,0.2,0.6", 0.4 + 0.2 * t);
        assert!(recipe.set("spots", &spot).is_ok());
    }
    recipe
}

#[test]
fn what_stays_is_what_the_link_gives() {
    for link in LINKS {
        let first = recipe(link);
        let mut studio = finished_recipe(&first);
        let mut clock = clock();
        let mut last = first.clone();
        studio.set_live(true);
        for k in 1..=8 {
            last = dragged(&first, f64::from(k) / 8.0);
            studio.set_recipe(last.clone());
            assert_eq!(studio.stage(), "packing", "{link}");
            assert!(!studio.done() && studio.digest().is_empty());
            for _ in 0..k % 4 {
                // The cells flow even if the page is paused and allows no steps.
                assert!(studio.tick(&mut clock, 8.0, 0), "{link}");
                assert!(
                    studio.progress().cells > 5,
                    "{link}: {:?}",
                    studio.progress()
                );
                assert!(studio.engine_mut().energy().is_finite());
                studio.engine_mut().view("auto");
            }
        }
        assert_eq!(studio.recipe().link(), last.link());
        studio.set_live(false);
        // On a tile without lines only a spot was dragged, because it has no outline.
        let moved = link.contains("tile=1") && !link.contains("lines=");
        let first_stale = if moved { "fields" } else { "domain" };
        assert_eq!(studio.stage(), first_stale, "{link}");
        let fresh = finished_recipe(&last);
        assert_eq!(studio.finish(&mut clock), Ok(()));
        assert_eq!(studio.digest(), fresh.digest(), "{link}");
        assert_eq!(studio.picture(), fresh.picture(), "{link}");
        assert_eq!(studio.progress(), fresh.progress(), "{link}");
    }
}

#[test]
fn flowing_cells_fill_what_is_dragged() {
    for link in LINKS {
        let first = recipe(link);
        let mut studio = finished_recipe(&first);
        let mut clock = clock();
        studio.set_live(true);
        for k in 1..=10 {
            studio.set_recipe(dragged(&first, f64::from(k) / 10.0));
            studio.tick(&mut clock, 8.0, 1);
        }
        while studio.tick(&mut clock, 8.0, 1) {}
        let fresh = finished_recipe(studio.recipe());
        let [warm, cold] = [&studio, &fresh].map(|s| s.pavement().packing.unwrap().particles());
        let more = warm.len() as f64 / cold.len() as f64;
        assert!(
            (0.75..1.25).contains(&more),
            "{link}: {} {}",
            warm.len(),
            cold.len()
        );
        let domain = fresh.pavement().domain.unwrap();
        for (k, cell) in warm.iter().enumerate() {
            let depth = domain.nearest(cell.centre).distance;
            assert!(depth > -1e-6, "{link}: {cell:?}");
            assert!(warm[..k].iter().all(|other| other.id != cell.id), "{link}");
        }
    }
}

#[test]
fn the_draft_is_seen_until_the_new_packing_has_ended() {
    let first = recipe(LINKS[0]);
    let last = dragged(&first, 1.0);
    let mut studio = finished_recipe(&first);
    let mut clock = clock();
    let picture = studio.engine_mut().view("auto").to_vec();
    studio.set_live(true);
    studio.set_recipe(last.clone());
    while studio.tick(&mut clock, 8.0, 0) {}
    let draft = studio.engine_mut().view("auto").to_vec();
    assert_ne!(draft, picture);
    studio.set_live(false);
    while ["domain", "fields", "packing"].contains(&studio.stage()) {
        assert_eq!(studio.engine_mut().view("auto"), draft);
        studio.tick(&mut clock, 0.0, 1);
    }
    assert_ne!(studio.engine_mut().view("auto"), draft);
    // In a paused studio, the start of the new packing is shown instead.
    let mut held = finished_recipe(&first);
    held.set_live(true);
    held.set_recipe(last);
    held.tick(&mut clock, 8.0, 0);
    held.set_live(false);
    while held.tick(&mut clock, 8.0, 0) {}
    assert_eq!((held.stage(), held.progress().steps), ("packing", 0));
    let mut plain = Studio::new(ALL, held.recipe().clone());
    while plain.tick(&mut clock, 8.0, 0) {}
    assert_eq!(
        held.engine_mut().view("packed"),
        plain.engine_mut().view("packed")
    );
}

#[test]
fn where_nothing_changes_nothing_is_done_again() {
    let first = recipe(LINKS[0]);
    let mut studio = finished_recipe(&first);
    let (digest, mut clock) = (studio.digest(), clock());
    studio.set_live(true);
    studio.set_recipe(dragged(&first, 0.5));
    assert!(studio.tick(&mut clock, 8.0, 1));
    assert_eq!(studio.digest(), "");
    studio.set_recipe(first.clone());
    assert!(studio.done());
    assert_eq!(studio.digest(), digest);
    // A change that affects only later stages is worked on as usual.
    let mut lit = first;
    assert_eq!(lit.set("az", "10"), Ok(vec![]));
    studio.set_recipe(lit);
    assert_eq!(studio.stage(), "shading");
    studio.set_live(false);
    assert_eq!(studio.finish(&mut clock), Ok(()));
    assert_eq!(studio.digest(), digest);
}

#[test]
fn cells_that_lie_elsewhere_start_anew() {
    let first = recipe(LINKS[0]);
    let mut studio = finished_recipe(&first);
    let mut away = first.clone();
    let corner = |x: f64, y: f64| DVec2::new(x, y);
    let outer = vec![
        corner(2., 2.),
        corner(30., 2.),
        corner(30., 12.),
        corner(2., 12.),
    ];
    let rings = Outline {
        rings: vec![outer],
        ..Outline::default()
    };
    assert!(away.set_polygon(&rings).is_ok());
    studio.set_live(true);
    studio.set_recipe(away.clone());
    studio.tick(&mut clock(), 8.0, 1);
    let cells = studio.pavement().packing.unwrap().particles();
    assert!(!cells.is_empty());
    let inside = |p: DVec2| p.x > 2.0 && p.x < 30.0 && p.y > 2.0 && p.y < 12.0;
    assert!(cells.iter().all(|cell| inside(cell.centre)));
    // Finishing the work also ends the live mode.
    assert_eq!(studio.finish(&mut clock()), Ok(()));
    assert_eq!(studio.digest(), finished_recipe(&away).digest());
}
