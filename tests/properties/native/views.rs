//! The drawings of the stages, checked by their pixels.

use crate::paving::OfPavement;
use bubblestone::generators::ALL;
use bubblestone::generators::pavement;
use bubblestone::generators::pavement::{Absence, Base, Overlay, PavementView};
use bubblestone::studio::Studio;

pub(super) const SIDE: usize = 160;

/// A finished view of a recipe, in a small picture.
fn view(link: &str, words: &str) -> Vec<u8> {
    finished(link).engine_mut().view(words).to_vec()
}

fn pixel(rgba: &[u8], x: usize, y: usize) -> [i32; 3] {
    std::array::from_fn(|c| i32::from(rgba[4 * (y * SIDE + x) + c]))
}

/// The amount by which red exceeds blue.
fn warmth(rgba: &[u8], x: usize, y: usize) -> i32 {
    let [red, _, blue] = pixel(rgba, x, y);
    red - blue
}

pub(super) fn differing(a: &[u8], b: &[u8]) -> usize {
    let pairs = a.chunks(4).zip(b.chunks(4));
    pairs.filter(|(a, b)| a != b).count()
}

/// The picture rotated by a quarter turn.
fn turned(rgba: &[u8]) -> Vec<u8> {
    let place = |k: usize| (k % SIDE) * SIDE + SIDE - 1 - k / SIDE;
    let pixels = (0..SIDE * SIDE).map(|k| 4 * place(k));
    pixels.flat_map(|at| rgba[at..at + 4].to_vec()).collect()
}

const KINDS: [&str; 4] = ["square", "rectangle", "circle", "ellipse"];

#[test]
fn every_kind_has_a_potential_of_its_own() {
    let views = KINDS.map(|kind| view(&format!("kind={kind}"), "potential"));
    let half = SIDE / 2;
    for (k, rgba) in views.iter().enumerate() {
        assert!(warmth(rgba, half, half) > 60, "{}: no hill", KINDS[k]);
        assert_eq!(pixel(rgba, 1, 1), pixel(rgba, SIDE - 2, SIDE - 2));
        for other in &views[..k] {
            assert!(differing(rgba, other) > 1000);
        }
    }
    // If the cells are symmetric under a quarter turn, so is the drawing, except for soft edges.
    for (rgba, alike) in views.iter().zip([true, false, true, false]) {
        let others = differing(rgba, &turned(rgba));
        assert_eq!(others < SIDE * SIDE / 5, alike, "{others}");
    }
}

#[test]
fn squares_have_wells_at_their_edges_and_circles_all_around() {
    // The stable distance in this picture.
    let l0 = SIDE as f64 / 3.6;
    let along = |rgba: &[u8], degrees: f64| {
        let ray = |r: f64| {
            let (x, y) = (
                libm::cos(degrees.to_radians()),
                libm::sin(degrees.to_radians()),
            );
            let half = SIDE as f64 / 2.0;
            warmth(
                rgba,
                (half + r * l0 * x) as usize,
                (half + r * l0 * y) as usize,
            )
        };
        // These radii avoid the white lines and dots.
        (80..95).map(|r| ray(f64::from(r) / 100.0)).min().unwrap()
    };
    let square = view("kind=square", "potential");
    let circle = view("kind=circle", "potential");
    assert!(along(&square, 8.0) < -20, "{}", along(&square, 8.0));
    assert!(along(&square, 98.0) < -20);
    assert!(along(&square, 45.0) > 0);
    for degrees in [12.0, 45.0, 78.0, 200.0] {
        assert!(along(&circle, degrees) < -20, "{degrees}");
    }
}

#[test]
fn a_longer_cell_has_a_longer_ring() {
    let wide = |ca: &str| {
        let rgba = view(&format!("kind=ellipse&ca={ca}"), "potential");
        (0..SIDE)
            .filter(|&y| warmth(&rgba, SIDE / 2, y) < -10)
            .count()
    };
    assert!(wide("4") < wide("1.5"));
}

#[test]
fn packed_cells_are_drawn_in_their_shapes() {
    let views = KINDS.map(|kind| view(&format!("outline=square&kind={kind}"), "packed"));
    for (k, rgba) in views.iter().enumerate() {
        for other in &views[..k] {
            assert!(differing(rgba, other) > 2000);
        }
    }
}

#[test]
fn the_fields_show_what_shapes_them() {
    let plain = view("outline=square", "direction");
    for more in [
        "lines=0.2,0.5,0.8,0.5",
        "strokes=0.2,0.3,0.8,0.6",
        "spots=0.5,0.5,0.3,0.5",
    ] {
        let rgba = view(&format!("outline=square&{more}"), "direction");
        assert!(differing(&plain, &rgba) > 150, "{more}");
    }
    let stretched = view("outline=square&kind=ellipse", "direction");
    let spot = view(
        "outline=square&kind=ellipse&stretch=0.5,0.5,0.3,4",
        "direction",
    );
    assert!(differing(&stretched, &spot) > 150);
}

#[test]
fn singular_points_are_marked_by_their_sign() {
    let half = SIDE / 2;
    let round = view("outline=square&dir=circular", "direction");
    assert!(
        warmth(&round, half, half) > 80,
        "{:?}",
        pixel(&round, half, half)
    );
    // Around a stroke that turns back, the direction field rotates in the opposite sense.
    let cold = |link: &str| {
        let rgba = view(link, "direction");
        (0..SIDE * SIDE)
            .filter(|&k| warmth(&rgba, k % SIDE, k / SIDE) < -60)
            .count()
    };
    assert!(cold("outline=crossing&kind=ellipse") > 10);
    assert_eq!(cold("outline=square&dir=constant"), 0);
}

#[test]
fn lone_triangles_stand_out_only_among_cells_with_corners() {
    let warm = |link: &str| {
        let rgba = view(link, "mesh");
        (0..SIDE * SIDE)
            .filter(|&k| warmth(&rgba, k % SIDE, k / SIDE) > 70)
            .count()
    };
    assert_eq!(warm("outline=square&kind=circle"), 0);
    assert!(warm("outline=square&dir=spiral") > 50);
}

#[test]
fn a_tile_has_no_outline_and_no_seam() {
    let rgba = view("tile=1&kind=circle&palette=marble", "packed");
    let apart = |x: usize, y: usize, u: usize, v: usize| {
        let (a, b) = (pixel(&rgba, x, y), pixel(&rgba, u, v));
        (0..3).map(|c| (a[c] - b[c]).abs()).sum::<i32>()
    };
    // If images across the edges were missing, both values would be far above those inside.
    let column = |x: usize| -> i32 { (0..SIDE).map(|y| apart(x, y, (x + 1) % SIDE, y)).sum() };
    let row = |y: usize| -> i32 { (0..SIDE).map(|x| apart(x, y, x, (y + 1) % SIDE)).sum() };
    assert!(column(SIDE - 1) <= (0..SIDE - 1).map(column).max().unwrap());
    assert!(row(SIDE - 1) <= (0..SIDE - 1).map(row).max().unwrap());
}

pub(super) fn finished(link: &str) -> Studio {
    crate::common::finished(&format!("size={SIDE}&cs=14&{link}"))
}

/// The parts of a view that show nothing.
fn absent(studio: &mut Studio, words: &str) -> Vec<(&'static str, &'static str)> {
    studio.inspect().absences(words)
}

#[test]
fn what_shows_nothing_says_why() {
    const ALL: &str =
        "height+size+packed+energy+cells+mesh+anisotropy+direction+forces+singularities";
    // A ring has squares of one size, and its direction field has no singular point inside.
    let mut ring = finished("");
    let ours = [
        ("size", Absence::OneSize.word()),
        ("anisotropy", Absence::AllEven.word()),
        ("singularities", Absence::NoPoint.word()),
    ];
    assert_eq!(absent(&mut ring, ALL), ours);
    assert_eq!(absent(&mut ring, "auto+direction"), []);
    let mut full = finished("outline=star&kind=ellipse&gx=0.5");
    assert_eq!(absent(&mut full, ALL), []);
    // Squares in rows that fill a tile repel each other equally from all sides.
    let mut rows = crate::common::finished(&format!("size={SIDE}&tile=1&dir=constant&cs=20"));
    assert_eq!(
        absent(&mut rows, "forces"),
        [("forces", Absence::AtRest.word())]
    );
}

#[test]
fn what_is_still_to_come_is_missed_until_then() {
    let (recipe, _) = pavement::recipe(&format!("size={SIDE}&cs=14&outline=star"));
    let mut studio = Studio::new(ALL, recipe);
    for _ in 0..3 {
        studio.step(&mut || 0.0);
    }
    let coming = absent(&mut studio, "ids+packed+energy+cells+mesh+forces");
    let words: Vec<&str> = coming.iter().map(|(word, _)| *word).collect();
    assert_eq!(words, ["ids", "cells", "mesh"]);
    assert!(coming.iter().all(|(_, why)| *why == Absence::NotYet.word()));
    assert_eq!(studio.inspect().height_range(), 0.0);
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    assert_eq!(absent(&mut studio, "ids+cells+mesh"), []);
    assert!(studio.inspect().height_range() > 5.0);
}

#[test]
fn words_that_name_nothing_are_passed_over() {
    for (words, same) in [
        ("", "auto"),
        ("nothing", "auto"),
        ("+", "auto"),
        ("picture+nothing+mesh+", "picture+mesh"),
        ("mesh+picture", "picture+mesh"),
        ("picture+height", "picture"),
        ("mesh+mesh", "mesh"),
        ("potential+mesh", "potential"),
    ] {
        assert_eq!(
            PavementView::of_words(words),
            PavementView::of_words(same),
            "{words}"
        );
    }
    assert_eq!(PavementView::of_words("packed"), Base::Packed.into());
    assert_ne!(PavementView::of_words("paper+packed"), Base::Packed.into());
    let overlays: Vec<Overlay> = PavementView::of_words("auto+forces+size")
        .overlays()
        .collect();
    assert_eq!(overlays, [Overlay::Size, Overlay::Forces]);
}

#[test]
fn planes_have_views_of_their_own() {
    let mut studio = finished("outline=star&wet=0.4");
    let words = [
        "picture",
        "height",
        "normals",
        "albedo",
        "roughness",
        "ao",
        "ids",
    ];
    let views = words.map(|word| studio.engine_mut().view(word).to_vec());
    for (k, view) in views.iter().enumerate() {
        for other in &views[..k] {
            assert!(differing(view, other) > SIDE * SIDE / 4, "{}", words[k]);
        }
    }
    let planes = studio.pavement().planes.unwrap();
    let at = SIDE * SIDE / 2 + SIDE / 2;
    assert_eq!(views[3][4 * at..][..3], planes.colour[at]);
    assert_eq!(views[5][4 * at..][..3], [planes.occlusion[at]; 3]);
}

/// A studio in the middle of its work: after some packing steps, or `past` slices after the packing.
fn midway(link: &str, past: Option<u32>) -> Studio {
    let (recipe, notices) = pavement::recipe(link);
    assert!(notices.is_empty(), "{notices:?}");
    let mut studio = Studio::new(ALL, recipe);
    (0..4).for_each(|_| studio.step(&mut || 0.0));
    if let Some(slices) = past {
        while studio.stage() != "planes" {
            studio.tick(&mut || 0.0, 0.0, 1);
        }
        (0..slices).for_each(|_| _ = studio.tick(&mut || 0.0, 0.0, 1));
    }
    studio
}

#[test]
fn a_drawing_made_in_pieces_is_the_one_made_at_once() {
    let plain = "size=320&cs=14";
    let tile = "size=320&cs=14&tile=1&lines=0.2,0.3,0.8,0.6&kind=ellipse";
    for (link, words, past) in [
        (plain, "auto", None),
        (tile, "auto", None),
        (plain, "packed", Some(0)),
        (tile, "cells", Some(0)),
        (plain, "mesh", Some(0)),
        (plain, "auto", Some(0)),
        (plain, "auto", Some(40)),
        (plain, "paper", None),
    ] {
        let view = words;
        let [mut whole, mut pieces] = [(); 2].map(|()| midway(link, past));
        let mut count = 1;
        while !pieces.engine_mut().prepare(view, &mut || 0.0, 0.0) {
            count += 1;
        }
        assert!((3..30).contains(&count), "{words}: {count} pieces");
        assert!(
            whole.engine_mut().view(view) == pieces.engine_mut().view(view),
            "{link}: {words}"
        );
        // A drawing is prepared only once, until something changes.
        assert!(pieces.engine_mut().prepare(view, &mut || 0.0, 0.0));
    }
}

#[test]
fn work_in_between_begins_a_drawing_again() {
    let [mut whole, mut pieces] = [(); 2].map(|()| midway("size=320&cs=14", None));
    let view = "auto";
    for _ in 0..3 {
        assert!(!pieces.engine_mut().prepare(view, &mut || 0.0, 0.0));
        pieces.step(&mut || 0.0);
        whole.step(&mut || 0.0);
    }
    assert!(whole.engine_mut().view(view) == pieces.engine_mut().view(view));
}

#[test]
fn pictures_and_planes_need_no_preparation() {
    let mut studio = Studio::new(ALL, pavement::recipe("size=96&cs=14").0);
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    for words in ["auto", "picture", "height", "albedo", "direction"] {
        assert!(
            studio.engine_mut().prepare(words, &mut || 0.0, 0.0),
            "{words}"
        );
    }
}
