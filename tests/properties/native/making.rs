//! The steps of making stones and scales agree with their solids.

use super::samples::star;
use bubblestone::cells::Cell;
use bubblestone::solid::{
    Making, PLAIN, SkinParams, Solids, Step, StoneKind, StoneParams, Surface, control_mesh, step,
    steps,
};
use glam::Vec3;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Stones of this kind with the default values.
pub fn of(kind: StoneKind) -> StoneParams {
    StoneParams {
        kind,
        ..StoneParams::default()
    }
}

/// All kinds of stones.
pub const KINDS: [StoneKind; 3] = [StoneKind::Cobble, StoneKind::Flagstone, StoneKind::Skin];

/// A step that exists.
pub fn made(cell: &Cell, params: &StoneParams, making: Making) -> Step {
    let step = step(&mut Solids::new(), cell, params, making);
    step.unwrap_or_else(|| panic!("{} of {:?}", making.word(), params.kind))
}

/// The number of Loop steps of a cell.
pub fn last_loop(cell: &Cell, params: &StoneParams) -> u32 {
    let steps = steps(cell, params);
    steps.iter().filter_map(|s| s.level()).max().expect("loops")
}

/// The corners of triangles by their bits.
fn corners(surface: &Surface) -> Vec<[[u32; 3]; 3]> {
    let bits = |k: u32| {
        (surface.positions[k as usize] + 0.0)
            .to_array()
            .map(f32::to_bits)
    };
    surface.triangles.iter().map(|t| t.map(bits)).collect()
}

/// Asserts that a step has everything that a drawing needs and is closed. Returns its volume.
pub fn assert_drawable(step: &Step, what: &str) -> f64 {
    let surface = &step.surface;
    let count = surface.positions.len();
    assert_eq!(
        (surface.normals.len(), surface.colours.len()),
        (count, count),
        "{what}"
    );
    assert!(surface.positions.iter().all(|p| p.is_finite()), "{what}");
    let unit = |n: &Vec3| (n.length() - 1.0).abs() < 1e-5;
    assert!(surface.normals.iter().all(unit), "{what}");
    assert!(
        surface
            .triangles
            .iter()
            .flatten()
            .all(|&k| (k as usize) < count),
        "{what}"
    );
    assert!(step.edges.iter().flatten().all(|p| p.is_finite()), "{what}");
    // In a closed surface, each edge occurs equally often in both directions.
    let mut ways = BTreeMap::new();
    let mut volume = 0.0;
    for [a, b, c] in corners(surface) {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            *ways.entry((from, to)).or_insert(0) += 1;
            *ways.entry((to, from)).or_insert(0) -= 1;
        }
        let [a, b, c] = [a, b, c].map(|p| Vec3::from(p.map(f32::from_bits)).as_dvec3());
        volume += a.dot(b.cross(c)) / 6.0;
    }
    assert!(ways.values().all(|&n| n == 0), "{what} is open");
    if step.making != Making::Finish {
        assert!(surface.colours.iter().all(|&c| c == PLAIN), "{what}");
    }
    volume
}

#[test]
fn the_control_step_is_the_control_mesh() {
    let cell = star(5, 20.0, 0.2, 3);
    for kind in KINDS {
        let (params, step) = (of(kind), made(&cell, &of(kind), Making::Control));
        let mesh = control_mesh(&cell, &params).expect("a mesh");
        let shown = corners(&step.surface);
        let wanted = Surface {
            positions: mesh.vertices.clone(),
            triangles: mesh.triangles.to_vec(),
            ..Surface::default()
        };
        assert_eq!(
            shown[..mesh.triangles.len()],
            corners(&wanted)[..],
            "{kind:?}"
        );
        let sides = mesh
            .triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let sides: BTreeSet<[u32; 2]> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
        assert_eq!(step.edges.len(), sides.len());
    }
}

#[test]
fn the_last_loop_step_is_the_solid() {
    for (kind, radius) in KINDS.into_iter().zip([20.0, 35.0, 24.0]) {
        let cell = star(6, radius, 0.3, 4);
        let skin = SkinParams {
            amplitude: 0.0,
            keel: 0.4,
            rings: 3,
            ..SkinParams::default()
        };
        let params = StoneParams { skin, ..of(kind) };
        let step = made(&cell, &params, Making::Loop(last_loop(&cell, &params)));
        // The finest mesh that a picture may use.
        let finer = |k| match kind {
            StoneKind::Skin => Solids::for_picture(1, k - 4),
            _ => Solids::for_picture(k as usize + 1, 0),
        };
        let all = step.surface.triangles.len();
        let solids = (0..8).map(|k| finer(k).solid(&cell, &params));
        let solids = solids.take_while(|s| s.triangles.len() < all);
        let solid = solids.last().expect("a solid");
        let shown = &step.surface;
        assert_eq!(shown.positions.len(), solid.vertices.len() + 1, "{kind:?}");
        assert_eq!(
            shown.positions[..solid.vertices.len()],
            solid.vertices[..],
            "{kind:?}"
        );
        assert_eq!(
            shown.triangles[..solid.triangles.len()],
            solid.triangles[..]
        );
        // Earlier Loop steps differ from it, and have a line for each edge of the first one.
        let first = made(&cell, &params, Making::Loop(1));
        let control = made(&cell, &params, Making::Control);
        assert!(first.edges.len() > 2 * control.edges.len() && step.edges.is_empty());
    }
}

/// The edges of a prism: those of its base or top, and the rising ones.
fn prism_edges(step: &Step) -> (Vec<[Vec3; 2]>, Vec<[Vec3; 2]>) {
    let n = step.edges.len() / 3;
    let (top, rest) = step.edges.split_at(n);
    (top.to_vec(), rest[n..].to_vec())
}

#[test]
fn sweeps_are_straight_and_as_high_as_asked_for() {
    for kind in KINDS {
        for scale in [0.8, 1.0, 1.3] {
            let cell = star(5, 20.0, 0.2, 3);
            let skin = SkinParams {
                sweep: 1.4,
                skew: 0.5,
                tilt: 0.2,
                taper: 0.3,
                ..SkinParams::default()
            };
            let params = StoneParams {
                scale,
                skin,
                height: 13.0,
                distortion: 0.4,
                ..of(kind)
            };
            let height = match kind {
                StoneKind::Skin => 1.4 * skin_size(&cell),
                _ => 13.0,
            };
            let sweep = made(&cell, &params, Making::Sweep);
            let (_, rising) = prism_edges(&sweep);
            assert_eq!(rising.len(), 5);
            for [low, high] in rising {
                assert_eq!((low.x, low.y, low.z), (high.x, high.y, 0.0), "{kind:?}");
                assert!(
                    (f64::from(high.z) - height).abs() < 0.03 * height,
                    "{kind:?}"
                );
            }
            // The base shows a plate and, in addition, the cell's outline.
            let base = made(&cell, &params, Making::Base);
            let (bottom, swept) = (&base.edges[0][0], &sweep.edges[0][0]);
            assert_eq!((bottom.x, bottom.y), (swept.x, swept.y));
            assert!(bottom.z > 0.0 && f64::from(bottom.z) < 0.1 * height);
            assert_eq!(base.edges.len(), 5 + cell.ring.len());
            // Only the top is displaced, and a displacement of 0 changes nothing.
            let displaced = made(&cell, &params, Making::Distortion);
            let (_, moved) = prism_edges(&displaced);
            let (_, rising) = prism_edges(&sweep);
            assert!(rising.iter().zip(&moved).all(|(a, b)| a[0] == b[0]));
            assert!(
                rising
                    .iter()
                    .zip(&moved)
                    .all(|(a, b)| a[1].distance(b[1]) > 1e-3)
            );
            let params = StoneParams {
                distortion: 0.0,
                ..params
            };
            let [a, b] = [Making::Sweep, Making::Distortion].map(|s| made(&cell, &params, s));
            let off = a.surface.positions.iter().zip(&b.surface.positions);
            assert!(
                off.map(|(a, b)| a.distance(*b)).all(|off| off < 1e-4),
                "{kind:?}"
            );
            assert_eq!(a.surface.triangles, b.surface.triangles);
        }
    }
}

/// The mean distance of the corners from the middle, for a cell with few corners, which its footprint keeps.
fn skin_size(cell: &Cell) -> f64 {
    let n = cell.ring.len() as f64;
    cell.ring
        .iter()
        .map(|p| (*p - cell.centre).length())
        .sum::<f64>()
        / n
}

#[test]
fn skew_moves_the_top_along_the_flow_and_taper_to_the_middle() {
    let cell = star(6, 20.0, 0.0, 3);
    let skin = SkinParams {
        skew: 1.5,
        taper: 0.25,
        ..SkinParams::default()
    };
    let params = StoneParams {
        skin,
        distortion: 0.2,
        ..of(StoneKind::Skin)
    };
    let tops = [Making::Distortion, Making::Skew, Making::Taper].map(|s| made(&cell, &params, s));
    let base = prism_edges(&tops[0]).1;
    for (k, edge) in base.iter().enumerate() {
        let [distorted, skewed, tapered] = [0, 1, 2].map(|s| prism_edges(&tops[s]).1[k][1]);
        let way = cell.axis.as_vec2() * 1.5 * 20.0;
        assert!((skewed - distorted).distance(way.extend(0.0)) < 1e-3);
        let inwards = (cell.centre.as_vec2().extend(0.0) - edge[0]) * 0.25;
        assert!((tapered - skewed).distance(inwards) < 1e-3);
    }
    // The control mesh has the same corners.
    let control = corners(&made(&cell, &params, Making::Control).surface);
    assert_eq!(control, corners(&tops[2].surface));
}

#[test]
fn a_bevel_takes_the_corners_off() {
    let cell = star(4, 20.0, 0.1, 3);
    let params = StoneParams {
        bevel_horizontal: 0.3,
        bevel_vertical: 0.2,
        ..of(StoneKind::Flagstone)
    };
    let bevel = made(&cell, &params, Making::Bevel);
    let straight = made(&cell, &params, Making::Distortion);
    let volume = |step: &Step| -> f64 {
        let dot = |[a, b, c]: [Vec3; 3]| a.as_dvec3().dot(b.as_dvec3().cross(c.as_dvec3()));
        let of = |t: &[u32; 3]| dot(t.map(|k| step.surface.positions[k as usize]));
        step.surface.triangles.iter().map(of).sum::<f64>() / 6.0
    };
    let part = volume(&bevel) / volume(&straight);
    assert!((0.7..0.99).contains(&part), "{part}");
    let mesh = control_mesh(&cell, &params).expect("a mesh");
    assert!(
        bevel
            .surface
            .positions
            .iter()
            .filter(|p| p.z > 0.0)
            .all(|p| mesh.vertices.contains(p))
    );
}

#[test]
fn noise_of_skin_is_on_it_and_ends_as_the_solid() {
    let cell = star(6, 20.0, 0.1, 3);
    let params = of(StoneKind::Skin);
    let last = last_loop(&cell, &params);
    let [smooth, rough] = [Making::Loop(last), Making::Noise].map(|s| made(&cell, &params, s));
    assert_ne!(smooth.surface.positions, rough.surface.positions);
    let solid = Solids::new().solid_of_level(&cell, &params, last);
    let off = solid.vertices.iter().zip(&rough.surface.positions);
    assert!(off.map(|(a, b)| a.distance(*b)).all(|off| off < 1e-4));
    let skin = SkinParams {
        amplitude: 0.0,
        ..params.skin
    };
    let params = StoneParams { skin, ..params };
    assert_eq!(made(&cell, &params, Making::Noise).surface, smooth.surface);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn any_cell_any_numbers(
        (corners, rough, id) in (3usize..20, 0.0..0.9f64, 0u32..1000),
        kind in prop::sample::select(KINDS.to_vec()),
        (scale, distortion, height) in (0.5..1.4f64, 0.0..=1.0f64, 1.0..60.0f64),
        (across, down) in (0.0..=1.0f64, 0.0..=1.0f64),
        (sweep, skew, taper) in (0.0..2.0f64, 0.0..2.0f64, 0.0..=1.0f64),
    ) {
        let cell = star(corners, 22.0, rough, id);
        let skin = SkinParams { sweep, skew, taper, ..SkinParams::default() };
        let params = StoneParams {
            scale,
            distortion,
            height,
            bevel_horizontal: across,
            bevel_vertical: down,
            skin,
            ..of(kind)
        };
        let mut solids = Solids::new();
        for making in steps(&cell, &params) {
            let step = step(&mut solids, &cell, &params, making).expect("a step");
            // A top that is displaced by more than its width or height may turn over.
            let volume = assert_drawable(&step, making.word());
            let may_turn = kind == StoneKind::Skin && making != Making::Base;
            assert!(may_turn || volume > 0.0, "{} has {volume}", making.word());
        }
    }
}
