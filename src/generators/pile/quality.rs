//! How well piles are made: how deep the surfaces of bodies overlap, and how much of a shape is bare.

use super::PileEngine;
use super::tests::points_of;
use crate::generators::Preset;
use crate::pile::{Body, Fate, Kind};
use crate::trimesh::{Search, TriMesh};
use glam::{DMat3, DVec3};

/// The most triangles of a mesh whose surface is measured.
const MEASURED: usize = 1_300;
/// Points of the surface of each variant, uniform by area, whose depth in other bodies is measured.
const LOOKED_AT: usize = 120;
/// Points of the shape, uniform by area, whose normals are followed.
const NORMALS: usize = 500;
/// Upright lines along each side of a grid over the shape's footprint.
const LINES: usize = 40;

/// A variant's mesh with its search, and points of its surface.
struct Solid {
    mesh: TriMesh,
    search: Search,
    /// The mesh's box.
    bounds: (DVec3, DVec3),
    points: Vec<DVec3>,
}

/// A kept body with its mesh.
struct Placed<'a> {
    solid: &'a Solid,
    place: DVec3,
    turn: DMat3,
    scale: f64,
    /// R, the radius of the largest inner sphere.
    radius: f64,
    /// The greatest distance of its surface from its place.
    bound: f64,
}

/// The solids of all variants of all types.
fn solids(engine: &PileEngine) -> Vec<Vec<Solid>> {
    let components = engine.made.components.made().expect("components");
    let solid = |component: &std::sync::Arc<crate::component::Component>| {
        let levels = &component.levels;
        let fits = |level: &&crate::component::Level| level.mesh.triangles().len() <= MEASURED;
        let level = levels.iter().find(fits);
        let mesh = level.unwrap_or(&levels[levels.len() - 1]).mesh.clone();
        let points = points_of(&mesh, LOOKED_AT);
        Solid {
            points: points.iter().map(|point| point.at).collect(),
            search: Search::new(&mesh),
            bounds: mesh.bounds(),
            mesh,
        }
    };
    components
        .iter()
        .map(|one| one.all.iter().map(solid).collect())
        .collect()
}

/// All kept bodies, by place along x.
fn kept<'a>(engine: &PileEngine, solids: &'a [Vec<Solid>]) -> Vec<Placed<'a>> {
    let kinds: &[Kind] = &engine.made.placed.made().expect("darts").kinds;
    let bodies = engine.made.settled.made().expect("bodies").bodies();
    let placed = |body: &Body| {
        let solid = &solids[body.kind as usize][body.shape as usize];
        let far = solid.mesh.positions().iter().map(|p| p.length());
        Placed {
            solid,
            place: body.place(),
            turn: body.turn,
            scale: body.scale,
            radius: body.radius(kinds),
            bound: body.scale * far.fold(0.0, f64::max),
        }
    };
    let kept = bodies.iter().filter(|body| body.fate == Fate::Kept);
    let mut kept: Vec<_> = kept.map(placed).collect();
    kept.sort_by(|a, b| a.place.x.total_cmp(&b.place.x));
    kept
}

impl Placed<'_> {
    fn local(&self, at: DVec3) -> DVec3 {
        self.turn.transpose() * (at - self.place) / self.scale
    }

    /// The greatest depth of another body's points in this one.
    fn depth_of(&self, other: &Self) -> f64 {
        let mut most = 0.0_f64;
        for &point in &other.solid.points {
            let at = other.place + other.turn * (other.scale * point);
            if at.distance(self.place) >= self.bound {
                continue;
            }
            let local = self.local(at);
            // No point is deeper in the mesh than in its box.
            let (low, high) = self.solid.bounds;
            if (local - low).min(high - local).min_element() * self.scale <= most {
                continue;
            }
            let nearest = self.solid.search.closest(&self.solid.mesh, local);
            if nearest.normal.dot(local - nearest.at) < 0.0 {
                most = most.max(nearest.at.distance(local) * self.scale);
            }
        }
        most
    }

    /// Whether a line meets this body within `reach` of a place, both ways. The direction has length 1.
    fn is_met(&self, at: DVec3, along: DVec3, reach: f64) -> bool {
        let away = self.place - at;
        let t = away.dot(along);
        if t.abs() > reach + self.bound || away.length_squared() - t * t > self.bound * self.bound {
            return false;
        }
        let start = (t - 2.0 * self.bound).max(-reach);
        let end = (t + 2.0 * self.bound).min(reach);
        let from = self.local(at + start * along);
        let along = self.turn.transpose() * along / self.scale;
        let (mesh, search) = (&self.solid.mesh, &self.solid.search);
        search
            .ray_within(mesh, (from, along), end - start, |_| true)
            .is_some()
    }
}

/// For each body the greatest depth of another surface in it, or of its surface in another body, in R of the smaller
/// body.
fn depths(kept: &[Placed]) -> Vec<f64> {
    let widest = kept.iter().map(|body| body.bound).fold(0.0, f64::max);
    let mut depths = vec![0.0_f64; kept.len()];
    for (k, body) in kept.iter().enumerate() {
        let near = kept[k + 1..].iter().enumerate();
        let near =
            near.take_while(|(_, other)| other.place.x <= body.place.x + body.bound + widest);
        for (j, other) in near {
            if other.place.distance(body.place) < body.bound + other.bound {
                let deepest = body.depth_of(other).max(other.depth_of(body));
                let deepest = deepest / body.radius.min(other.radius);
                for one in [k, k + 1 + j] {
                    depths[one] = depths[one].max(deepest);
                }
            }
        }
    }
    depths
}

/// The share of the shape's normals that meet no body within a diagonal of the largest type. And the share of upright
/// lines through its highest points that meet no body.
fn bare(engine: &PileEngine, kept: &[Placed]) -> [f64; 2] {
    let kinds: &[Kind] = &engine.made.placed.made().expect("darts").kinds;
    let mesh = &engine.made.site.made().expect("a shape").mesh;
    let diagonal = kinds.iter().map(Kind::diagonal).fold(0.0, f64::max);
    let is_bare = |at: DVec3, along: DVec3, reach: f64| {
        !kept.iter().any(|body| body.is_met(at, along, reach))
    };
    let normals = points_of(mesh, NORMALS);
    let missed = normals.iter().filter(|p| is_bare(p.at, p.normal, diagonal));
    let footprint = footprint(mesh);
    let height = mesh.diagonal() + diagonal;
    let open = footprint
        .iter()
        .filter(|&&at| is_bare(at, DVec3::NEG_Y, height));
    [
        missed.count() as f64 / normals.len() as f64,
        open.count() as f64 / footprint.len() as f64,
    ]
}

/// The highest points of a mesh on vertical lines of a square grid.
fn footprint(mesh: &TriMesh) -> Vec<DVec3> {
    let search = Search::new(mesh);
    let (low, high) = mesh.bounds();
    let place = |k: usize, axis: usize| {
        low[axis] + (k as f64 + 0.5) / LINES as f64 * (high[axis] - low[axis])
    };
    let from = |k: usize| DVec3::new(place(k % LINES, 0), high.y + 1.0, place(k / LINES, 2));
    let hit = |from: DVec3| {
        search
            .ray(mesh, from, DVec3::NEG_Y, |_| true)
            .map(|hit| hit.point.at)
    };
    (0..LINES * LINES).filter_map(|k| hit(from(k))).collect()
}

/// The greatest depth of round bodies beyond T + D, in R: of 99 in 100 bodies, and of all.
const ROUND: [f64; 2] = [0.08, 0.20];
/// The limits in place of `ROUND` for showpieces with thin bodies or sharp edges.
const SHARP: [f64; 2] = [0.25, 0.45];
const SHARP_ONES: [&str; 3] = ["nuts-bolts", "toys", "autumn-leaves"];
/// The greatest depth, and the greatest mean of all bodies' depths, in R, of every preset.
const DEEPEST: f64 = 0.75;
const MEAN: f64 = 0.32;
/// The greatest allowed values of [`bare`]. The first one is for closed shapes only.
const BARE: [f64; 2] = [0.03, 0.015];

/// Bodies of a preset overlap little. Those of a showpiece overlap less, and leave few holes.
pub(super) fn assert_good(engine: &PileEngine, preset: &Preset) {
    let name = preset.name;
    let solids = solids(engine);
    let kept = kept(engine, &solids);
    let mut depths = depths(&kept);
    depths.sort_by(f64::total_cmp);
    let share = |share: f64| depths[(share * (depths.len() - 1) as f64) as usize];
    let mean = depths.iter().sum::<f64>() / depths.len() as f64;
    let params = engine.made.settled.params();
    let beyond = [0.99, 1.0].map(|part| share(part) - params.offset - params.removal);
    println!(
        "{name}: {} bodies, mean {mean:.3}, deepest {:.3}, beyond {beyond:.3?}",
        depths.len(),
        share(1.0)
    );
    assert!(
        mean <= MEAN && share(1.0) <= DEEPEST,
        "{name}: {mean} {}",
        share(1.0)
    );
    if preset.group != "Showpieces" {
        return;
    }
    let limits = if SHARP_ONES.contains(&name) {
        SHARP
    } else {
        ROUND
    };
    let [normals, above] = bare(engine, &kept);
    println!("{name}: bare normals {normals:.3}, from above {above:.3}");
    assert!(
        beyond[0] <= limits[0] && beyond[1] <= limits[1],
        "{name}: {beyond:?}"
    );
    let is_closed = engine
        .made
        .site
        .made()
        .is_some_and(|site| site.mesh.closed().is_some());
    assert!(!is_closed || normals <= BARE[0], "{name}: {normals}");
    assert!(above <= BARE[1], "{name}: {above}");
}
