//! The height of stones, Hs, over its whole range: joints, shadows and picture.

use crate::common::finished;
use crate::paving::OfPavement;
use bubblestone::generators::pavement;
use bubblestone::heightfield::GROUND;
use bubblestone::solid::{StoneKind, StoneParams, joint_depth};
use bubblestone::studio::Studio;

const KINDS: [StoneKind; 2] = [StoneKind::Cobble, StoneKind::Flagstone];
/// The default ring at half the side, with the same number of stones, and the factor of its lengths.
const SMALL: &str = "size=256&cs=11.5";
const UNIT: f64 = 0.5;

/// Calls `look` with the finished pictures at some heights, which are given for a picture of 512 pixels.
fn at_heights(more: &str, heights: &[f64], mut look: impl FnMut(&Studio)) {
    let mut studio = finished(&format!("{SMALL}{more}"));
    for height in heights {
        let (recipe, notices) = pavement::recipe(&format!("{SMALL}{more}&hs={}", height * UNIT));
        assert!(notices.is_empty(), "{notices:?}");
        studio.set_recipe(recipe);
        assert_eq!(studio.finish(&mut || 0.0), Ok(()));
        look(&studio);
    }
}

/// The mean difference of two pictures, as a fraction of the full scale.
fn difference(a: &[u8], b: &[u8]) -> f64 {
    let apart: u64 = a
        .iter()
        .zip(b)
        .map(|(a, b)| u64::from(a.abs_diff(*b)))
        .sum();
    // The fourth channel is the same everywhere.
    apart as f64 / (a.len() / 4 * 3) as f64 / 255.0
}

#[test]
fn pictures_tell_low_stones_from_high_ones() {
    for more in ["", "&stone=flag"] {
        let mut before: Option<Vec<u8>> = None;
        at_heights(more, &[4.0, 9.0, 20.0, 40.0], |studio| {
            let picture = studio.picture().unwrap().to_vec();
            if let Some(before) = before.replace(picture.clone()) {
                let apart = difference(&before, &picture);
                assert!(apart > 0.01, "{more}: {apart}");
            }
        });
    }
}

/// The mean height of stones minus that of joints, and the mean occlusion of joints.
fn joints(studio: &Studio) -> [f64; 2] {
    let planes = studio.pavement().planes.unwrap();
    // Joint pixels lie near stones: at least on two opposite sides.
    let side = planes.side;
    let near = |i: usize| {
        let [x, y] = [i % side, i / side];
        let stone = |x: usize, y: usize| planes.id[y * side + x] != GROUND;
        (3..side - 3).contains(&x)
            && (3..side - 3).contains(&y)
            && (stone(x - 3, y) && stone(x + 3, y) || stone(x, y - 3) && stone(x, y + 3))
    };
    let mean = |of: &dyn Fn(usize) -> f64, is: &dyn Fn(usize) -> bool| {
        let chosen: Vec<f64> = (0..side * side).filter(|&i| is(i)).map(of).collect();
        assert!(chosen.len() > 500, "{} pixels", chosen.len());
        chosen.iter().sum::<f64>() / chosen.len() as f64
    };
    let height = |i: usize| f64::from(planes.bump[i]);
    let joint = |i: usize| planes.id[i] == GROUND && near(i);
    let stones = mean(&height, &|i| planes.id[i] != GROUND);
    let open = |i: usize| f64::from(planes.occlusion[i]);
    [stones - mean(&height, &joint), mean(&open, &joint)]
}

#[test]
fn joints_are_deeper_and_darker_the_higher_the_stones() {
    for more in ["", "&stone=flag"] {
        let mut before = [0.0, 256.0];
        at_heights(
            more,
            &[2.0, 4.0, 9.0, 14.0, 20.0, 30.0, 40.0, 80.0, 240.0],
            |studio| {
                let [deep, open] = joints(studio);
                assert!(
                    deep > before[0] + 0.1 && open < before[1],
                    "{more}: {deep} {open}"
                );
                before = [deep, open];
            },
        );
    }
}

#[test]
fn joints_grow_with_the_height_and_with_the_size() {
    for kind in KINDS {
        for bevel_vertical in [0.0, 0.2, 1.0] {
            let deep = |height: f64, size: f64| {
                let params = StoneParams {
                    kind,
                    height,
                    bevel_vertical,
                    ..StoneParams::default()
                };
                joint_depth(&params, size)
            };
            for size in [4.0, 23.0, 150.0] {
                for height in (1..128).map(f64::from) {
                    let here = deep(height, size);
                    assert!(here > 0.0 && here < height, "{height} {size}: {here}");
                    assert!(deep(height + 1.0, size) > here, "{height} {size}: {here}");
                    assert!(deep(height, size + 1.0) >= here, "{height} {size}: {here}");
                }
            }
        }
    }
}

#[test]
fn the_ground_swallows_no_stone_however_low() {
    for more in ["&dr=1", "&dr=1&af=8&stone=flag"] {
        // The number of pixels of each stone, for low stones and for high ones.
        let [low, high] = [1, 20].map(|hs| {
            let studio = finished(&format!("size=256&cs=40&hs={hs}{more}"));
            let mut seen = vec![0usize; studio.pavement().cells.len()];
            for &id in &studio.pavement().planes.unwrap().id {
                if id != GROUND {
                    seen[id as usize - 1] += 1;
                }
            }
            seen
        });
        for (low, high) in low.iter().zip(high) {
            assert!(5 * low > 4 * high, "{more}: {low} pixels of {high}");
        }
    }
}

#[test]
fn a_lamp_stands_on_the_ground_whatever_height_stones_have() {
    // Ground far from stones is lit alike between low and high ones.
    let at = |hs: u32| {
        let studio = finished(&format!(
            "size=128&cs=9&hs={hs}&light=point&lx=0.5&ly=0.5&lz=0.2"
        ));
        let side = studio.side();
        let picture = studio.picture().unwrap();
        let middle = side / 2 - 8..side / 2 + 8;
        let sum: u64 = middle
            .clone()
            .flat_map(|y| middle.clone().map(move |x| (y * side + x) * 4))
            .map(|at| u64::from(picture[at]))
            .sum();
        sum as f64 / (middle.len() * middle.len()) as f64
    };
    let [low, high] = [at(6), at(120)];
    assert!((low - high).abs() < 4.0, "{low} {high}");
}
