//! Stones on surfaces of rows of cells.

use super::fixture::*;
use super::*;
use crate::heightfield::GROUND;
use crate::scene::Scene;
use crate::solid::{SkinParams, Solids, StoneKind, StoneParams};
use crate::trimesh::{TangentFrame, TriMesh};
use glam::{DVec2, DVec3, Vec3};

const NO_WEATHER: WeatherParams = WeatherParams {
    wear: 0.0,
    moss: 0.0,
    dirt: 0.0,
    wet: 0.0,
};

type Named = (&'static str, Rows, Box<dyn Fn(DVec2) -> DVec3>);

/// Surfaces with cells of a fifth to a tenth of their radius.
fn surfaces() -> Vec<Named> {
    vec![
        ("torus", rows([30, 12], [true, true]), Box::new(torus(0.4))),
        ("tube", rows([30, 5], [true, false]), Box::new(tube(1.0))),
        ("ball", rows([30, 12], [true, false]), Box::new(ball)),
        ("bowl", rows([30, 5], [true, false]), Box::new(bowl)),
        ("saddle", rows([8, 8], [false, false]), Box::new(saddle)),
        ("horn", rows([20, 20], [true, false]), Box::new(horn)),
    ]
}

fn skin() -> StoneParams {
    StoneParams {
        kind: StoneKind::Skin,
        scale: 1.2,
        distortion: 0.0,
        skin: SkinParams {
            sweep: 0.45,
            skew: 0.9,
            tilt: 0.28,
            taper: 0.25,
            keel: 0.4,
            dimension: 1.2,
            amplitude: 0.0,
            ..SkinParams::DEFAULT
        },
        ..StoneParams::default()
    }
}

fn build(params: StonesParams, mesh: &TriMesh, cells: &[SurfaceCell]) -> Scene {
    let links = links(cells);
    let paving = Paving {
        cells,
        links: &links,
        coats: &[],
        claws: &[],
    };
    let mut stones = Stones::new(params, mesh, cells);
    while !stones.advance(mesh, paving) {}
    stones.finish()
}

#[test]
fn a_flat_stone_stays_as_it_is_and_nothing_is_mirrored() {
    // Seen from above, with x to the right, z points down.
    for stone in [StoneParams::default(), skin()] {
        let cells = rows([5, 5], [false, false]).cells(&flat);
        let cell = &cells[12];
        let unit = 24.0 / cell.size;
        let mut laid = UnfoldedCell::new(cell, unit);
        let solid = Solids::new().solid_of_level(&laid.cell, &stone, 2);
        laid.bend.stand(0.0, [0.0, 40.0]);
        for v in &solid.vertices {
            let flat = v.as_dvec3();
            let bent = laid.placed(flat) * unit;
            // The picture's x is the axis. Its y points to the right of that, seen from above, as y points down.
            let (right, out) = (laid.axes[0], laid.axes[2]);
            let down = -out.cross(right);
            let there = right * flat.x + down * flat.y + out * flat.z;
            assert!((bent - there).length() < 1e-9, "{bent} {there}");
        }
    }
}

#[test]
fn an_asymmetric_ring_is_laid_flat_as_it_is_seen() {
    let mut cell = rows([5, 5], [false, false]).cells(&flat).swap_remove(12);
    // A cell drawn out along z.
    let (at, axis) = (cell.centre.at, DVec3::Z);
    cell.axis = TangentFrame::of(cell.centre.normal).within(axis);
    cell.ring = [(-1.0, -1.0), (-1.0, 2.0), (1.5, 1.0), (1.0, -1.0)]
        .map(|(x, z)| at + DVec3::new(x, 0.0, z) * 0.1)
        .to_vec();
    let laid = UnfoldedCell::new(&cell, 10.0);
    // Seen from above, with x to the right, z points down: the axis points down, and the picture's y to the left.
    let mut seen: Vec<[i64; 2]> = laid
        .cell
        .ring
        .iter()
        .map(|p| [(p.x * 10.0).round() as i64, (p.y * 10.0).round() as i64])
        .collect();
    assert!(crate::domain::signed_area(&laid.cell.ring) > 0.0);
    seen.sort_unstable();
    assert_eq!(seen, [[-10, -10], [-10, 10], [10, -15], [20, 10]]);
}

#[test]
fn bent_corners_are_shared_and_the_ring_is_nearly_bent_so_without_help() {
    for (name, rows, patch) in surfaces() {
        let cells = rows.cells(&patch);
        let unit = 24.0 / mean_size(&cells);
        let (mut off, mut worst, mut count) = (0.0, 0.0f64, 0.0);
        for cell in &cells {
            let laid = UnfoldedCell::new(cell, unit);
            let n = cell.ring.len();
            let mut bare = QuadricPatch::new(&[], &[], &[]);
            bare.shape = laid.bend.shape;
            for (k, &corner) in cell.ring.iter().enumerate() {
                let flat = laid.cell.ring[n - 1 - k].extend(0.0);
                let bent = cell.centre.at + laid.placed(flat);
                assert!((bent - corner).length() < 1e-12 * 24.0, "{name}");
                let miss = (cell.centre.at + laid.out(bare.bent(flat)) - corner).length();
                (off, count) = (off + miss / cell.size, count + 1.0);
                worst = worst.max(miss / cell.size);
            }
        }
        let mean = off / count;
        assert!(mean < 0.013 && worst < 0.05, "{name}: {mean} {worst}");
    }
}

/// The tops of neighbours, up to half a radius of curvature high, keep the gap that they have in the plane.
#[test]
fn tops_stay_apart() {
    for (name, patch, closes) in [
        ("ball", &ball as Patch, [true, false]),
        ("bowl", &bowl, [true, false]),
        ("torus", &torus(0.4), [true, true]),
    ] {
        let rows = rows([24, 10], closes);
        let cells = rows.cells(patch);
        let unit = 24.0 / mean_size(&cells);
        for k in 0..cells.len() - 1 {
            let (a, b) = (&cells[k], &cells[k + 1]);
            if (k + 1) % 24 == 0 {
                continue;
            }
            for high in [0.2, 0.5] {
                let [left, right] = [a, b].map(|cell| {
                    let mut laid = UnfoldedCell::new(cell, unit);
                    let [least, most] = laid.bend.curvatures();
                    let radius = 1.0 / least.abs().max(most.abs());
                    laid.bend.stand(0.0, [0.0, high * radius]);
                    (laid, high * radius)
                });
                // The middles of the walls that face each other, a tenth inside.
                let wall = |(laid, high): &(UnfoldedCell, f64), side: f64, cell: &SurfaceCell| {
                    let half = 0.5 * cell.size * cell.aspect.sqrt() * unit;
                    let p = DVec3::new(side * 0.9 * half, 0.0, *high);
                    cell.centre.at + laid.placed(p)
                };
                let (from, to) = (wall(&left, 1.0, a), wall(&right, -1.0, b));
                let along = (b.centre.at - a.centre.at).normalize();
                let gap = (to - from).dot(along) / a.size;
                let least = 0.1 * (1.0 - high) - 0.06;
                assert!(gap > least, "{name} {k}: {gap} at {high}");
            }
        }
    }
}

/// Triangles of a closed surface face outwards: its volume by the divergence theorem is positive, and about that of
/// the flat stone.
#[test]
fn nothing_turns_inside_out() {
    let volume = |surface: &crate::solid::Surface| {
        let six = surface.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| surface.positions[v as usize].as_dvec3());
            a.dot(b.cross(c))
        });
        six.sum::<f64>() / 6.0
    };
    for kind in [StoneKind::Cobble, StoneKind::Flagstone, StoneKind::Skin] {
        for (name, rows, patch) in surfaces() {
            let cells = rows.cells(&patch);
            let stone = match kind {
                StoneKind::Skin => skin(),
                kind => StoneParams {
                    kind,
                    ..StoneParams::default()
                },
            };
            let texture = TextureParams {
                size: 24.0,
                stone,
                ..TextureParams::default()
            };
            let mesh = rows.mesh(&patch);
            let params = StonesParams::new(texture, NO_WEATHER, &cells);
            let scene = build(params, &mesh, &cells);
            assert!(scene.fault().is_none(), "{name}");
            let scale = Fit::new(&mesh).scale;
            for instance in scene.instances.iter().filter(|i| i.id != GROUND) {
                let cell = &cells[instance.id as usize - 1];
                let body = &scene.bodies[instance.body as usize];
                let size = cell.size * scale;
                for level in body.levels.iter() {
                    let part = volume(level) / (size * size * size);
                    assert!(part > 0.02, "{name} {kind:?}: {part}");
                    let sides = level
                        .triangles
                        .iter()
                        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
                    let mut sides: Vec<[u32; 2]> = sides.collect();
                    sides.sort_unstable();
                    let is_closed = sides
                        .iter()
                        .all(|&[a, b]| sides.binary_search(&[b, a]).is_ok());
                    assert!(is_closed, "{name} {kind:?}");
                }
            }
        }
    }
}

#[test]
fn stones_over_a_hollow_are_lower() {
    let mut bend = QuadricPatch::new(&[], &[], &[]);
    bend.shape = [-0.05, 0.0, 0.01];
    bend.stand(4.0, [0.0, 24.0]);
    assert!((bend.rise * 20.0 - 10.0).abs() < 1e-12);
    bend.stand(24.0, [0.0, 24.0]);
    assert_eq!(bend.rise, 1.0);
    bend.shape = [0.1, 0.0, 0.01];
    bend.stand(24.0, [0.0, 24.0]);
    assert!((bend.rise * 24.0 - 5.0).abs() < 1e-12);
}

/// The top of a scale leans along its axis, whichever way the surface faces, and the scale is not mirrored.
#[test]
fn scales_lean_along_their_axes() {
    let rows = rows([30, 12], [true, false]);
    let cells = rows.cells(&ball);
    let mut stone = skin();
    (stone.skin.skew_angle, stone.skin.tilt, stone.skin.keel) = (0.5, 0.0, 0.0);
    let texture = TextureParams {
        size: 24.0,
        stone,
        ..TextureParams::default()
    };
    let mesh = rows.mesh(&ball);
    let scene = build(
        StonesParams::new(texture, NO_WEATHER, &cells),
        &mesh,
        &cells,
    );
    for instance in scene.instances.iter().filter(|i| i.id != GROUND) {
        let cell = &cells[instance.id as usize - 1];
        if cell.on_border {
            continue;
        }
        let level = &scene.bodies[instance.body as usize].levels[0];
        let out = cell.centre.normal.as_vec3();
        // Weighted by area, because the kept vertices are not symmetric.
        let mean = |over: &dyn Fn(f32) -> bool| {
            let (mut sum, mut whole) = (Vec3::ZERO, 0.0);
            for t in &level.triangles {
                let [a, b, c] = t.map(|v| level.positions[v as usize]);
                let middle = (a + b + c) / 3.0;
                if over(middle.dot(out)) {
                    let area = (b - a).cross(c - a).length();
                    (sum, whole) = (sum + middle * area, whole + area);
                }
            }
            sum / whole
        };
        let heights = level.positions.iter().map(|p| p.dot(out));
        let highest = heights.fold(0.0, f32::max);
        let lean = mean(&|h| h > 0.5 * highest) - mean(&|h| h < 0.0);
        let lean = TangentFrame::of(cell.centre.normal)
            .within(lean.as_dvec3())
            .normalize();
        // The angle is clockwise seen from outside.
        let wanted = DVec2::new(libm::cos(0.5), -libm::sin(0.5)).rotate(cell.axis);
        assert!(lean.dot(wanted) > 0.97, "{lean} {wanted}");
    }
}

#[test]
fn a_scene_is_the_same_however_it_is_cut_and_told_by_its_digest() {
    let rows = rows([24, 10], [true, true]);
    let shape = torus(0.4);
    let (mesh, cells) = (rows.mesh(&shape), rows.cells(&shape));
    let texture = TextureParams {
        size: 24.0,
        ..TextureParams::default()
    };
    let params = StonesParams::new(texture, NO_WEATHER, &cells);
    let scene = build(params, &mesh, &cells);
    assert_eq!(
        scene.instances.iter().filter(|i| i.id != GROUND).count(),
        240
    );
    assert_eq!(scene.digest(), build(params, &mesh, &cells).digest());
    let mossy = WeatherParams {
        moss: 0.5,
        ..NO_WEATHER
    };
    let params = StonesParams {
        weather: mossy,
        ..params
    };
    assert_ne!(scene.digest(), build(params, &mesh, &cells).digest());
    let (_, radius) = scene.ball();
    assert!((0.45..1.1).contains(&radius), "{radius}");
}

/// The tops of stones lie on the surface, and the ground is as deep as in the plane.
#[test]
fn tops_lie_on_the_surface_and_the_ground_below() {
    let rows = rows([30, 6], [true, false]);
    let patch = tube(1.0);
    let (mesh, cells) = (rows.mesh(&patch), rows.cells(&patch));
    let texture = TextureParams {
        size: 24.0,
        amplitude: 0.0,
        stone: StoneParams {
            kind: StoneKind::Flagstone,
            distortion: 0.0,
            ..StoneParams::default()
        },
        ..TextureParams::default()
    };
    let params = StonesParams::new(texture, NO_WEATHER, &cells);
    let scene = build(params, &mesh, &cells);
    let scale = Fit::new(&mesh).scale as f32;
    let far = |p: Vec3| (p.x * p.x + p.z * p.z).sqrt() / scale;
    let depth = (texture.depth() / params.unit) as f32;
    let mut sheets = 0;
    for instance in &scene.instances {
        let levels = &scene.bodies[instance.body as usize].levels;
        // However coarse the ground, its depth differs little.
        for level in levels.iter().filter(|_| instance.id == GROUND) {
            for triangle in &level.triangles {
                let corners = triangle.map(|v| level.positions[v as usize] + instance.place.origin);
                if corners.iter().all(|&p| far(p) > 1.0 - 1.1 * depth) {
                    let middle = far((corners[0] + corners[1] + corners[2]) / 3.0);
                    assert!(middle > 1.0 - 1.7 * depth, "{middle} {depth}");
                    sheets += 1;
                }
            }
        }
        let level = &levels[0];
        let radii = level
            .positions
            .iter()
            .map(|&p| far(p + instance.place.origin));
        let highest = radii.fold(0.0, f32::max);
        let wanted = match instance.id {
            GROUND => 1.0 - depth,
            _ => 1.0,
        };
        assert!((highest - wanted).abs() < 0.012, "{highest} {wanted}");
    }
    assert!(sheets > 20, "{sheets}");
}

#[test]
fn cells_of_no_area_have_no_stone() {
    let rows = rows([5, 5], [false, false]);
    let mut cells = rows.cells(&flat);
    let there = cells[3].centre.at;
    cells[3].ring = vec![there; 4];
    cells[4].ring.clear();
    cells[4].normals.clear();
    let mesh = rows.mesh(&flat);
    let texture = TextureParams {
        size: 24.0,
        ..TextureParams::default()
    };
    let scene = build(
        StonesParams::new(texture, NO_WEATHER, &cells),
        &mesh,
        &cells,
    );
    assert_eq!(
        scene.instances.iter().filter(|i| i.id != GROUND).count(),
        23
    );
    assert!(scene.fault().is_none());
    let none = build(StonesParams::new(texture, NO_WEATHER, &[]), &mesh, &[]);
    assert!(none.fault().is_none());
}
