//! How well piles are made: how deep the meshes of bodies overlap, and how much of a shape is bare.

use super::PILE;
use super::PileEngine;
use super::tests::{probes, recipe, settled};
use crate::pile::{Body, Fate, Kind};
use crate::trimesh::{Search, TriMesh};
use glam::DVec3;

/// The most triangles of a mesh on whose surface depths are measured, and the most vertices that are looked at.
const MEASURED: usize = 1_300;
const LOOKED_AT: usize = 90;

/// A variant's mesh with its search, and points of its surface.
struct Solid {
    mesh: TriMesh,
    search: Search,
    points: Vec<DVec3>,
}

/// The solids of all variants of all types.
fn solids(engine: &PileEngine) -> Vec<Vec<Solid>> {
    let components = engine.made.components.made().expect("components");
    let solid = |component: &std::sync::Arc<crate::component::Component>| {
        let levels = &component.levels;
        let fits = |level: &&crate::component::Level| level.mesh.triangles().len() <= MEASURED;
        let mesh = levels
            .iter()
            .find(fits)
            .unwrap_or(&levels[levels.len() - 1])
            .mesh
            .clone();
        let step = mesh.positions().len().div_ceil(LOOKED_AT);
        Solid {
            points: mesh.positions().iter().step_by(step).copied().collect(),
            search: Search::new(&mesh),
            mesh,
        }
    };
    components
        .iter()
        .map(|one| one.all.iter().map(solid).collect())
        .collect()
}

/// For each kept body the greatest depth of its surface in another body, in R of the smaller one.
fn depths(engine: &PileEngine) -> Vec<f64> {
    let solids = solids(engine);
    let kinds: &[Kind] = &engine.made.placed.made().expect("darts").kinds;
    let pile = engine.made.settled.made().expect("bodies");
    let mut kept: Vec<&Body> = pile
        .bodies()
        .iter()
        .filter(|b| b.fate == Fate::Kept)
        .collect();
    kept.sort_by(|a, b| a.place().x.total_cmp(&b.place().x));
    let reach = 2.0 * kinds.iter().map(Kind::bound).fold(0.0, f64::max);
    let bound = |body: &Body| body.shape(kinds).bound * body.scale;
    let deepest = |body: &&Body| {
        let own = &solids[body.kind as usize][body.shape as usize];
        let first = kept.partition_point(|other| other.place().x < body.place().x - reach);
        let near = kept[first..]
            .iter()
            .take_while(|other| other.place().x <= body.place().x + reach);
        let mut most = 0.0_f64;
        for other in near.filter(|other| other.dart != body.dart) {
            let away = other.place().distance(body.place());
            if away < bound(body) + bound(other) {
                let solid = &solids[other.kind as usize][other.shape as usize];
                let least = body.radius(kinds).min(other.radius(kinds));
                most = most.max(depth(body, own, other, solid) / least);
            }
        }
        most
    };
    kept.iter().map(deepest).collect()
}

/// The greatest depth of a body's points in another body.
fn depth(body: &Body, own: &Solid, other: &Body, solid: &Solid) -> f64 {
    let back = other.turn.transpose();
    let mut most = 0.0_f64;
    for &point in &own.points {
        let at = body.place() + body.turn * (body.scale * point);
        let local = back * (at - other.place()) / other.scale;
        if local.length() > other.scale * 10.0 {
            continue;
        }
        let nearest = solid.search.closest(&solid.mesh, local);
        let inside = nearest.normal.dot(local - nearest.at) < 0.0;
        if inside {
            most = most.max(nearest.at.distance(local) * other.scale);
        }
    }
    most
}

/// The share of the shape's normals that meet no body within a diagonal, and of places from above that have none below.
fn bare(engine: &PileEngine) -> [f64; 2] {
    let kinds: &[Kind] = &engine.made.placed.made().expect("darts").kinds;
    let pile = engine.made.settled.made().expect("bodies");
    let mesh = &engine.made.site.made().expect("a shape").mesh;
    let diagonal = kinds
        .iter()
        .map(Kind::diagonal)
        .fold(f64::INFINITY, f64::min);
    let kept = pile.bodies().iter().filter(|b| b.fate == Fate::Kept);
    let spheres: Vec<_> = kept.flat_map(|body| body.spheres(kinds)).collect();
    let probes: Vec<_> = probes(mesh).into_iter().step_by(4).collect();
    let is_met = |at: DVec3, along: DVec3, reach: f64| {
        spheres.iter().any(|sphere| {
            let away = sphere.centre - at;
            let t = away.dot(along);
            t.abs() <= reach && away.length_squared() - t * t < sphere.radius * sphere.radius
        })
    };
    let missed = probes
        .iter()
        .filter(|p| !is_met(p.at, p.normal, diagonal))
        .count();
    let above = probes.iter().filter(|p| p.normal.y > 0.2);
    let count = above.clone().count().max(1);
    let open = above
        .filter(|p| !is_met(p.at, DVec3::Y, f64::INFINITY))
        .count();
    [
        missed as f64 / probes.len() as f64,
        open as f64 / count as f64,
    ]
}

/// The greatest depth beyond what is allowed that 99 of 100 bodies have, and that of all bodies, in R: of round bodies,
/// and of showpieces with sharp or thin ones.
const ROUND: [f64; 2] = [0.10, 0.22];
const SHARP: [f64; 2] = [0.25, 0.70];
const SHARP_ONES: [&str; 2] = ["nuts-bolts", "autumn-leaves"];
/// The greatest mean of all bodies' depths.
const MEAN: f64 = 0.32;
/// The greatest share of normals without a body, and of places from above.
const BARE: [f64; 2] = [0.20, 0.17];

#[test]
fn bodies_of_showpieces_overlap_little_and_leave_few_holes() {
    let all = PILE.presets.iter().filter(|p| p.group == "Showpieces");
    for preset in all {
        let engine = settled(&recipe(preset.link)).expect(preset.name);
        let mut depths = depths(&engine);
        depths.sort_by(f64::total_cmp);
        let params = engine.made.settled.params();
        let allowed = params.offset + params.removal;
        let mean = depths.iter().sum::<f64>() / depths.len() as f64;
        let beyond = [0.99, 1.0].map(|q| {
            let place = (q * (depths.len() - 1) as f64) as usize;
            depths[place] - allowed
        });
        let bare = bare(&engine);
        println!(
            "{}: {} bodies, mean {mean:.3}, beyond {beyond:.3?}, bare {bare:.3?}",
            preset.name,
            depths.len()
        );
        let limits = match SHARP_ONES.contains(&preset.name) {
            true => SHARP,
            false => ROUND,
        };
        assert!(mean <= MEAN, "{}", preset.name);
        for k in 0..2 {
            assert!(beyond[k] <= limits[k], "{}: {beyond:?}", preset.name);
            assert!(bare[k] <= BARE[k], "{}: {bare:?}", preset.name);
        }
    }
}
