//! The last steps of making stones and scales, which need the planes. All steps can be drawn.

use super::making::{KINDS, assert_drawable, last_loop, of};
use super::samples::{cell, painted, small, star};
use crate::common::finished;
use crate::paving::OfPavement;
use bubblestone::cells::Cell;
use bubblestone::heightfield::{Planes, Surfaces, TextureParams};
use bubblestone::solid::{Making, PLAIN, Solids, Step, StoneKind};
use glam::{DVec2, Vec3};

/// Stones of each kind.
const LINKS: [&str; 3] = [
    "size=128&cs=24",
    "size=128&cs=24&stone=flag",
    "size=128&cs=24&stone=skin&sc=0.6&tilt=0.1",
];

/// Cells of some pictures, with the parameters and planes of their stones.
fn pictures() -> Vec<(Vec<Cell>, TextureParams, Planes)> {
    let picture = |link| {
        let studio = finished(link);
        let pavement = studio.pavement();
        let cells = pavement.scales.to_vec();
        let params = TextureParams {
            side: 128,
            size: 24.0,
            stone: pavement.stones,
            amplitude: 2.0,
            ..TextureParams::default()
        };
        let planes = painted(params, &cells);
        (cells, params, planes)
    };
    LINKS.map(picture).into()
}

#[test]
fn steps_come_in_order_and_can_be_drawn() {
    for (cells, params, planes) in pictures() {
        assert!(cells.len() > 8);
        let middle = match params.stone.kind {
            StoneKind::Cobble => &["control"][..],
            StoneKind::Flagstone => &["bevel", "control"],
            StoneKind::Skin => &["skew", "taper", "control"],
        };
        let (surfaces, mut solids) = (Surfaces::new(params, usize::MAX), Solids::new());
        for (index, cell) in cells.iter().enumerate() {
            let making = surfaces.making(cell);
            let words: Vec<&str> = making.iter().map(|s| s.word()).collect();
            let loops = last_loop(cell, &params.stone);
            let loops: Vec<String> = (1..=loops).map(|k| format!("loop{k}")).collect();
            let wanted = ["base", "sweep", "distortion"].into_iter();
            let wanted = wanted.chain(middle.iter().copied());
            let wanted = wanted.chain(loops.iter().map(String::as_str));
            let wanted: Vec<&str> = wanted.chain(["noise", "mask", "finish"]).collect();
            assert_eq!(words, wanted);
            assert!(loops.len() >= 2);
            for step in making {
                let made = surfaces.step(&mut solids, (cell, index), &planes, step);
                let made = made.expect("a step");
                assert_eq!(made.making, step);
                // Cells at the edge of the picture may be almost invisible.
                if step != Making::Mask || !made.surface.triangles.is_empty() {
                    let volume = assert_drawable(&made, &format!("{} of {}", step.word(), cell.id));
                    assert!(volume > 0.0, "{} has {volume}", step.word());
                }
            }
        }
    }
}

/// The number of squares of a sheet.
fn squares(step: &Step) -> usize {
    step.surface
        .normals
        .iter()
        .zip(&step.surface.positions)
        .filter(|(n, _)| n.z == -1.0)
        .count()
        / 4
}

#[test]
fn the_mask_is_what_the_planes_have_of_a_stone() {
    for (cells, params, planes) in pictures() {
        let (surfaces, mut solids) = (Surfaces::new(params, usize::MAX), Solids::new());
        for (index, cell) in cells.iter().enumerate() {
            let mut of = |making| {
                surfaces
                    .step(&mut solids, (cell, index), &planes, making)
                    .unwrap()
            };
            let (noise, mask, finish) = (of(Making::Noise), of(Making::Mask), of(Making::Finish));
            let seen = planes
                .id
                .iter()
                .filter(|&&id| id == index as u32 + 1)
                .count();
            assert_eq!(squares(&mask), seen);
            let stone = &params.stone;
            let level = last_loop(cell, stone);
            let solid = solids.solid_of_level(cell, stone, level);
            assert_eq!(finish.surface, surfaces.close(&solid, cell, index, &planes));
            assert!(finish.surface.colours.iter().any(|&c| c != PLAIN));
            if stone.kind == StoneKind::Skin {
                let high = mask
                    .surface
                    .positions
                    .iter()
                    .fold(0.0, |high: f32, p| high.max(p.z));
                let top = solid
                    .vertices
                    .iter()
                    .fold(0.0, |high: f32, p| high.max(p.z));
                assert!((high - top).abs() < 0.03 * top, "{high} of {top}");
                assert!(mask.edges.len() >= 4);
                continue;
            }
            // The sheet surrounds the stone and shows its noise alone.
            let low = noise
                .surface
                .positions
                .iter()
                .fold(Vec3::MAX, |low, p| low.min(*p));
            let high = noise
                .surface
                .positions
                .iter()
                .fold(Vec3::MIN, |high, p| high.max(*p));
            let around = |p: &DVec2| p.x as f32 > low.x && (p.x as f32) < high.x;
            assert!(cell.ring.iter().all(around) && squares(&noise) > seen);
            let top = noise.surface.positions.iter().filter(|p| p.z > 0.0);
            let rough = high.z - top.fold(f32::MAX, |low, p| low.min(p.z));
            assert!(rough > 0.5 && rough < stone.height as f32, "{rough}");
            assert_eq!(noise.edges, mask.edges);
            let on_noise = |p: &Vec3| noise.surface.positions.contains(p);
            assert!(mask.surface.positions.iter().all(on_noise));
        }
    }
}

#[test]
fn bigger_pictures_have_the_same_steps() {
    let cells = [star(5, 20.0, 0.2, 3)];
    for kind in KINDS {
        let params = TextureParams {
            stone: of(kind),
            pixel_scale: 3,
            ..small()
        };
        let planes = painted(params, &cells);
        let surfaces = Surfaces::new(params, usize::MAX);
        let of = |making| {
            surfaces
                .step(&mut Solids::new(), (&cells[0], 0), &planes, making)
                .unwrap()
        };
        let (mask, finish) = (of(Making::Mask), of(Making::Finish));
        assert!(assert_drawable(&mask, "a mask") > 0.0);
        let none = [f32::MAX, f32::MIN];
        let wider = |[low, high]: [f32; 2], x: f32| [low.min(x), high.max(x)];
        let shown = mask.surface.positions.iter().map(|p| p.x);
        let pixels = (0..planes.id.len()).filter(|&k| planes.id[k] == 1);
        let seen = pixels.map(|k| (k % planes.side) as f32 / 3.0);
        let spans = [shown.fold(none, wider), seen.fold(none, wider)];
        let [[from, to], [low, high]] = spans;
        let off = (from - low).abs() + (to - high).abs();
        assert!(off < 2.0 && to - from > 20.0, "{kind:?}: {spans:?}");
        assert!(finish.surface.colours.iter().all(|&c| c != [128; 3]));
    }
}

#[test]
fn what_is_no_step_of_a_cell_is_not_made() {
    let p = DVec2::new;
    let hair = cell(1, vec![p(5., 5.), p(95., 5.), p(95., 5.001)]);
    let square = star(4, 20.0, 0.0, 1);
    let mut solids = Solids::new();
    for kind in KINDS {
        let params = TextureParams {
            stone: of(kind),
            ..small()
        };
        let (surfaces, planes) = (Surfaces::new(params, usize::MAX), Planes::new(96));
        for ring in [vec![], hair.ring.clone(), vec![p(f64::NAN, 1.0); 4]] {
            let cell = Cell {
                ring,
                ..hair.clone()
            };
            assert_eq!(surfaces.making(&cell), []);
            for making in [Making::Base, Making::Loop(1), Making::Mask, Making::Finish] {
                assert_eq!(
                    surfaces.step(&mut solids, (&cell, 0), &planes, making),
                    None
                );
            }
        }
        let other = match kind {
            StoneKind::Skin => Making::Bevel,
            _ => Making::Taper,
        };
        for making in [other, Making::Loop(0), Making::Loop(99)] {
            assert_eq!(
                surfaces.step(&mut solids, (&square, 0), &planes, making),
                None
            );
        }
        // This cell lies outside the picture.
        let mask = surfaces.step(&mut solids, (&square, 0), &planes, Making::Mask);
        assert!(mask.is_some_and(|mask| mask.surface.triangles.is_empty()));
    }
}

#[test]
fn masks_of_a_tile_go_on_beyond_its_edges() {
    let mut split = star(5, 20.0, 0.2, 3);
    for p in split.ring.iter_mut().chain([&mut split.centre]) {
        *p -= DVec2::splat(48.0);
    }
    for kind in KINDS {
        let params = TextureParams {
            stone: of(kind),
            tile: true,
            ..small()
        };
        let planes = painted(params, std::slice::from_ref(&split));
        let surfaces = Surfaces::new(params, usize::MAX);
        let mask = surfaces.step(&mut Solids::new(), (&split, 0), &planes, Making::Mask);
        let mask = mask.expect("a mask");
        assert!(assert_drawable(&mask, "a mask") > 0.0);
        assert_eq!(
            squares(&mask),
            planes.id.iter().filter(|&&id| id == 1).count()
        );
    }
}
