//! Tests of that which is seen of a pile.

use super::PILE;
use super::tests::recipe;
use crate::generators::{ALL, TurnOrder};
use crate::studio::Studio;

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
