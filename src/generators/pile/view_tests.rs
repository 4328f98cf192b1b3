//! Tests of that which is seen of a pile, and of files that become components.

use super::PILE;
use super::params::PileParams;
use super::tests::recipe;
use crate::generators::{ALL, GivenFile, TurnOrder};
use crate::recipe::Recipe;
use crate::studio::Studio;

/// A closed wedge.
const WEDGE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

/// The pixels of a view, red, green and blue.
fn seen(link: &str, view: &str) -> Vec<[u8; 3]> {
    let mut studio = Studio::new(ALL, recipe(link));
    let order = TurnOrder {
        subject: String::new(),
        camera: PILE.camera(),
        size: [128; 2],
        how: view.into(),
    };
    let frame = studio.finish_frame(&order, &mut || 0.0).expect("a frame");
    let pixels = frame.rgba().chunks_exact(4);
    pixels.map(|p| [p[0], p[1], p[2]]).collect()
}

/// The share of pixels whose red, green or blue (0, 1 or 2) is much stronger than both others.
fn share(pixels: &[[u8; 3]], strong: usize) -> f64 {
    let is_strong = |p: &&[u8; 3]| {
        let others = (0..3).filter(|&k| k != strong);
        let most = others.map(|k| p[k]).max().unwrap_or(0);
        f64::from(p[strong]) > 1.25 * f64::from(most)
    };
    pixels.iter().filter(is_strong).count() as f64 / pixels.len() as f64
}

#[test]
fn depth_is_seen_inside_of_bodies_that_are_cut_open() {
    let link = "make=pile&c1=ball&variants=1&form=sphere&ps=4&size=128";
    let usual = seen(link, "depth+still");
    for strong in 0..3 {
        let part = share(&usual, strong);
        assert!(part > 0.001, "{strong}: {part}");
    }
    // A plane beyond all bodies cuts none of them: only their surface is seen.
    let whole = seen(link, "depth+still+whole=0,0,1,5");
    assert!(share(&whole, 0) < 0.0002 && share(&whole, 1) < 0.0002);
    assert!(share(&whole, 2) > 0.1);
}

/// The brightest tenth of brass is far brighter than its darkest tenth: it mirrors windows, walls and the floor.
#[test]
fn metals_mirror_bright_and_dark_parts_of_a_room() {
    let link = "make=pile&c1=nut&variants=1&form=heap&ps=5&size=128";
    let pixels = seen(link, "picture+still").into_iter();
    let brass = pixels.map(|p| p.map(u32::from));
    let brass = brass.filter(|[r, _, b]| 10 * r > 13 * b);
    let mut tones: Vec<u32> = brass.map(|p| p.iter().sum()).collect();
    tones.sort_unstable();
    let [dark, bright] = [1, 9].map(|tenths| tones[tones.len() * tenths / 10]);
    assert!(2 * bright > 5 * dark, "{dark} {bright}");
}

/// The recipe after a file was opened.
fn opened(link: &str, role: &str) -> Recipe {
    let mut studio = Studio::new(ALL, recipe(link));
    let file = GivenFile::whole("wedge.obj", WEDGE.as_bytes().to_vec());
    studio.open_file(Some(role), file).expect("an open file");
    studio.recipe().clone()
}

#[test]
fn a_component_from_a_file_is_plain_and_not_bent() {
    let alone = opened("make=pile", "file1");
    assert_eq!(alone.choice(super::keys::C1), "file");
    assert_eq!(alone.number(super::keys::VARIANTS), 1.0);
    assert_eq!(PileParams::new(&alone).dress.finishes[0].word, "clay");
    // Other types keep their variants, and a shape changes none of them.
    let mixed = opened("make=pile&c2=rice", "file1");
    assert_eq!(mixed.number(super::keys::VARIANTS), 8.0);
    let shape = opened("make=pile", "model");
    assert_eq!(shape.number(super::keys::VARIANTS), 8.0);
}
