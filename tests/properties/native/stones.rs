//! Stones and planes: properties that hold for any cell.

use super::samples::{SIDE, cell, painted, pavement, small, star};
use bubblestone::cells::Cell;
use bubblestone::field::CellKind;
use bubblestone::heightfield::{GROUND, TextureParams};
use bubblestone::material::{GROUNDS, Gloss, PALETTES, material_table};
use bubblestone::solid::{
    Distribution, Footprint, Solid, Solids, StoneKind, StoneParams, joint_depth,
};
use glam::{DVec2, Vec3};
use proptest::prelude::*;

fn stone(kind: StoneKind, distortion: f64, scale: f64) -> StoneParams {
    StoneParams {
        kind,
        distortion,
        scale,
        ..StoneParams::default()
    }
}

fn flat(v: &Vec3) -> DVec2 {
    DVec2::new(f64::from(v.x), f64::from(v.y))
}

/// The distance of a point from a ring enlarged `scale` times about `centre`; 0 inside.
fn outside(ring: &[DVec2], centre: DVec2, scale: f64, p: DVec2) -> f64 {
    let q = centre + (p - centre) / scale;
    let (mut inside, mut distance) = (false, f64::MAX);
    for (i, &a) in ring.iter().enumerate() {
        let b = ring[(i + 1) % ring.len()];
        if (a.y > q.y) != (b.y > q.y) && q.x < a.x + (q.y - a.y) / (b.y - a.y) * (b.x - a.x) {
            inside = !inside;
        }
        let along = b - a;
        let t = ((q - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        distance = distance.min((a + along * t - q).length());
    }
    if inside { 0.0 } else { distance }
}

fn assert_inside(cell: &Cell, solid: &Solid, scale: f64) {
    for v in &solid.vertices {
        assert!(v.is_finite());
        let out = outside(&cell.ring, cell.centre, scale, flat(v));
        assert!(out < 1e-3, "{out} outside, scale {scale}");
    }
}

#[test]
fn stones_of_all_corner_counts_stay_in_their_cells() {
    let mut solids = Solids::new();
    for kind in [StoneKind::Cobble, StoneKind::Flagstone] {
        for n in (3..=12).chain([20, 40, 60]) {
            for (rough, distortion) in [(0.0, 0.0), (0.2, 0.3), (0.4, 1.0)] {
                let cell = star(n, 30.0, rough, n as u32);
                for scale in [0.5, 0.8, 1.0] {
                    let solid = solids.solid(&cell, &stone(kind, distortion, scale));
                    assert!(!solid.vertices.is_empty());
                    assert_inside(&cell, &solid, 1.0);
                }
            }
        }
    }
}

#[test]
fn scale_above_one_is_the_only_way_out() {
    let cell = star(4, 20.0, 0.0, 1);
    for distribution in [Distribution::Uniform, Distribution::Normal] {
        let params = StoneParams {
            distribution,
            ..stone(StoneKind::Cobble, 0.6, 1.2)
        };
        let solid = Solids::new().solid(&cell, &params);
        assert_inside(&cell, &solid, 1.2);
        let out = |v: &Vec3| outside(&cell.ring, cell.centre, 1.0, flat(v)) > 0.1;
        assert!(solid.vertices.iter().any(out));
    }
}

#[test]
fn cells_that_no_centre_sees_whole_are_filled_from_within() {
    let corners = [10., 10., 60., 10., 60., 60., 10., 60.];
    let notch = [10., 50., 50., 50., 50., 20., 10., 20.];
    let points: Vec<f64> = corners.into_iter().chain(notch).collect();
    let ring = points.chunks(2).map(|p| DVec2::new(p[0], p[1])).collect();
    let cell = cell(3, ring);
    let solid = Solids::new().solid(&cell, &stone(StoneKind::Flagstone, 0.3, 1.0));
    assert!(!solid.vertices.is_empty());
    assert_inside(&cell, &solid, 1.0);
}

#[test]
fn a_ring_of_many_points_is_looked_at_evenly() {
    let wavy = |points: usize| {
        let at = |k: usize| {
            let angle = std::f64::consts::TAU * k as f64 / points as f64;
            let reach = 40.0 + 9.0 * libm::sin(5.0 * angle);
            DVec2::new(libm::cos(angle), libm::sin(angle)) * reach
        };
        (0..points).map(at).collect::<Vec<_>>()
    };
    // Every other point of the longer ring is one of the shorter ring.
    let whole = Footprint::new(&wavy(1_000), DVec2::ZERO).unwrap();
    let twice = Footprint::new(&wavy(2_000), DVec2::ZERO).unwrap();
    assert_eq!(twice.corners, whole.corners);
    // The work grows with the square of the points: all of these would take minutes.
    let many = Footprint::new(&wavy(300_000), DVec2::ZERO).unwrap();
    assert_eq!(many.corners.len(), whole.corners.len());
    assert!((many.size / whole.size - 1.0).abs() < 1e-3);
}

#[test]
fn no_distortion_moves_nothing_and_distortion_does() {
    let mut solids = Solids::new();
    let (a, b) = (star(4, 20.0, 0.0, 1), star(4, 20.0, 0.0, 2));
    let mut vertices = |cell, dr| {
        let params = stone(StoneKind::Cobble, dr, 1.0);
        solids.solid(cell, &params).vertices
    };
    assert_eq!(vertices(&a, 0.0), vertices(&b, 0.0));
    assert_ne!(vertices(&a, 0.3), vertices(&b, 0.3));
}

#[test]
fn stones_reach_their_height_and_their_cells_sides() {
    let cell = star(4, 20.0, 0.0, 1);
    for kind in [StoneKind::Cobble, StoneKind::Flagstone] {
        let params = stone(kind, 0.0, 1.0);
        let solid = Solids::new().solid(&cell, &params);
        let top = solid.vertices.iter().map(|v| v.z).fold(0.0, f32::max);
        let high = f64::from(top) / params.height;
        assert!((0.9..=1.001).contains(&high), "{high} of the height");
        let reach = solid.vertices.iter().map(|v| (v.x - 48.0).abs());
        let reach = reach.fold(0.0, f32::max);
        assert!(reach > 14.0, "only {reach} of 20 to the corner");
    }
}

#[test]
fn tops_are_watertight_and_face_up() {
    for n in 3..=12 {
        let cell = star(n, 25.0, 0.0, 7);
        let solid = Solids::new().solid(&cell, &stone(StoneKind::Cobble, 0.0, 1.0));
        let mut sides: Vec<[u32; 2]> = Vec::new();
        for &[a, b, c] in solid.triangles.iter() {
            sides.extend([[a, b], [b, c], [c, a]]);
            let [p, q, r] = [a, b, c].map(|i| flat(&solid.vertices[i as usize]));
            let up = (q - p).perp_dot(r - p);
            assert!(up > -1e-3, "a triangle leans over by {up}");
        }
        sides.sort_unstable();
        assert!(sides.windows(2).all(|w| w[0] != w[1]), "one sense of turn");
        let lone = |s: &&[u32; 2]| sides.binary_search(&[s[1], s[0]]).is_err();
        let base = |i: u32| solid.vertices[i as usize].z.abs() < 1e-4;
        for [a, b] in sides.iter().filter(lone) {
            assert!(base(*a) && base(*b), "only the base is open");
        }
    }
}

#[test]
fn one_connectivity_is_shared() {
    let mut solids = Solids::new();
    let params = StoneParams::default();
    let a = solids.solid(&star(4, 20.0, 0.0, 1), &params);
    let b = solids.solid(&star(4, 20.0, 0.1, 2), &params);
    assert!(std::rc::Rc::ptr_eq(&a.triangles, &b.triangles));
}

#[test]
fn degenerate_cells_do_no_harm() {
    let p = DVec2::new;
    let square = |from: f64, to: f64| vec![p(from, from), p(to, from), p(to, to), p(from, to)];
    let rings = [
        vec![],
        vec![p(5., 5.)],
        vec![p(5., 5.), p(9., 9.)],
        vec![p(5., 5.), p(7., 7.), p(9., 9.)],
        vec![p(5., 5.); 6],
        vec![p(5., 5.), p(5.001, 5.), p(5., 5.001)],
        vec![p(5., 5.), p(95., 5.), p(95., 5.01), p(5., 5.01)],
        vec![p(5., 5.), p(f64::NAN, 5.), p(9., 9.)],
        vec![p(5., 5.), p(9., 5.), p(5., 9.), p(9., 9.)],
        square(-50., -20.),
        square(80., 140.),
    ];
    let cells: Vec<Cell> = (0..)
        .zip(rings)
        .map(|(id, ring)| Cell {
            id,
            centre: p(5., 5.),
            kind: CellKind::Square,
            size: 4.0,
            aspect: 1.0,
            axis: DVec2::ZERO,
            ring,
        })
        .collect();
    let planes = painted(small(), &cells);
    assert!(planes.bump.iter().all(|h| h.is_finite()));
    let last = planes.id[SIDE * SIDE - 1];
    assert_eq!(last, cells.len() as u32, "cut by the picture's edge");
}

#[test]
fn planes_are_finite_and_stones_stand_above_the_ground() {
    let params = small();
    let planes = painted(params, &pavement(16.0));
    let level = params.stone.height - joint_depth(&params.stone, params.size);
    let (mut stones, mut sum) = (0usize, 0.0);
    for (i, &h) in planes.bump.iter().enumerate() {
        assert!(h.is_finite() && f64::from(h) < params.stone.height * 1.6);
        if planes.id[i] == GROUND {
            assert_eq!(planes.material[i], 0);
        } else {
            stones += 1;
            sum += f64::from(h);
            assert!((1..=3).contains(&planes.material[i]));
        }
    }
    let covered = stones as f64 / (80.0 * 80.0);
    assert!((0.6..1.05).contains(&covered), "stones cover {covered}");
    assert!(sum / stones as f64 > level + 0.4 * (params.stone.height - level));
}

#[test]
fn planes_are_the_same_each_time_and_follow_the_seed() {
    let cells = pavement(16.0);
    let first = painted(small(), &cells);
    assert_eq!(first.digest(), painted(small(), &cells).digest());
    let reseeded = TextureParams { seed: 2, ..small() };
    assert_ne!(first.digest(), painted(reseeded, &cells).digest());
    let mut other = first.clone();
    other.occlusion[77] ^= 1;
    assert_ne!(first.digest(), other.digest());
}

#[test]
fn joints_see_less_of_the_sky_than_tops() {
    let planes = painted(small(), &pavement(16.0));
    let inner = |i: usize| (20..76).contains(&(i % SIDE)) && (20..76).contains(&(i / SIDE));
    let mean = |wanted: &dyn Fn(usize) -> bool| {
        let chosen: Vec<f64> = (0..SIDE * SIDE)
            .filter(|&i| inner(i) && wanted(i))
            .map(|i| f64::from(planes.occlusion[i]))
            .collect();
        chosen.iter().sum::<f64>() / chosen.len() as f64
    };
    let joints = mean(&|i| planes.id[i] == GROUND);
    let tops = mean(&|i| planes.bump[i] > 16.5);
    assert!(joints + 40.0 < tops, "joints {joints}, tops {tops}");
}

#[test]
fn every_palette_on_every_ground_gives_stones_of_many_tones() {
    let cells = pavement(21.0);
    for palette in PALETTES {
        for ground in GROUNDS {
            let params = TextureParams {
                palette: palette.name,
                ground: ground.name,
                size: 21.0,
                ..small()
            };
            let planes = painted(params, &cells);
            let tone = |c: &Cell| {
                let at = c.centre.y as usize * SIDE + c.centre.x as usize;
                planes.colour[at].map(u32::from).iter().sum::<u32>() / 6
            };
            let mut tones: Vec<u32> = cells.iter().map(tone).collect();
            tones.sort_unstable();
            tones.dedup();
            assert!(tones.len() >= 6, "{} on {}", palette.name, ground.name);
        }
        assert_eq!(material_table(palette.name, "sand", Gloss::Own).len(), 19);
    }
}

/// A stone over the corner of a tile is complete, and the ground continues across the edges.
#[test]
fn tiles_repeat_without_a_seam() {
    let tile = TextureParams {
        tile: true,
        ..small()
    };
    let whole = star(9, 20.0, 0.1, 1);
    let mut split = whole.clone();
    for p in split.ring.iter_mut().chain([&mut split.centre]) {
        *p -= DVec2::splat(48.0);
    }
    let [inside, over] = [whole, split].map(|cell| painted(tile, &[cell]));
    let last = SIDE - 1;
    for corner in [0, last, last * SIDE, last * SIDE + last] {
        assert_eq!(over.id[corner], 1);
    }
    let moved = |k: usize| ((k / SIDE + 48) % SIDE) * SIDE + (k % SIDE + 48) % SIDE;
    let other = (0..SIDE * SIDE).filter(|&k| over.id[k] != inside.id[moved(k)]);
    // Relief and ground differ at another place, which decides a few pixels of the rim.
    let other = other.count();
    assert!(other < 80, "{other} pixels");
    let open = |planes: &bubblestone::heightfield::Planes, id: u32| {
        let of = (0..SIDE * SIDE).filter(|&k| planes.id[k] == id);
        of.clone()
            .map(|k| f64::from(planes.occlusion[k]))
            .sum::<f64>()
            / of.count() as f64
    };
    assert!((open(&inside, 1) - open(&over, 1)).abs() < 3.0);
    let bare = painted(tile, &[]);
    let jump = |x: usize| {
        let steps =
            (0..SIDE).map(|y| bare.bump[y * SIDE + x] - bare.bump[y * SIDE + (x + 1) % SIDE]);
        steps.map(f32::abs).sum::<f32>()
    };
    let mean = (0..last).map(jump).sum::<f32>() / last as f32;
    assert!(jump(last) < 1.5 * mean);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn any_ring_any_numbers(
        n in 3usize..60,
        radius in prop_oneof![Just(0.01), 0.5f64..60.0, Just(150.0)],
        rough in 0.0f64..0.95,
        (flag, normal) in any::<(bool, bool)>(),
        dr in 0.0f64..=1.0,
        sv in 0.5f64..=1.3,
        hs in 1.0f64..=60.0,
        (bh, bv) in (0.0f64..=1.0, 0.0f64..=1.0),
    ) {
        let cell = star(n, radius, rough, 9);
        let params = StoneParams {
            kind: if flag { StoneKind::Flagstone } else { StoneKind::Cobble },
            distribution: if normal { Distribution::Normal } else { Distribution::Uniform },
            height: hs,
            scale: sv,
            distortion: dr,
            bevel_horizontal: bh,
            bevel_vertical: bv,
            skin: Default::default(),
            seed: 4,
        };
        let solid = Solids::new().solid(&cell, &params);
        for v in &solid.vertices {
            prop_assert!(v.is_finite());
            prop_assert!(v.z > -0.5 * hs as f32 && v.z < 1.5 * hs as f32, "height {}", v.z);
            if sv <= 1.0 {
                let out = outside(&cell.ring, cell.centre, 1.0, flat(v));
                prop_assert!(out < 2e-4 * radius.max(5.0), "{} outside", out);
            }
        }
        let planes = painted(TextureParams { stone: params, size: radius, ..small() }, &[cell]);
        prop_assert!(planes.bump.iter().all(|h| h.is_finite()));
    }
}
