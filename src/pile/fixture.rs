//! Bodies and surfaces for tests.

use super::{
    Body, Dart, Darting, Fate, Kind, Method, OverlapWork, RefineParams, Refining, SettlingOrder,
    Shape, Turn, Wall, merge,
};
use crate::component::Sphere;
use crate::trimesh::{Search, TriMesh, testing};
use glam::DVec3;
use std::f64::consts::TAU;
use std::sync::Arc;

pub const PARAMS: RefineParams = RefineParams {
    offset: 0.1,
    removal: 0.05,
    order: SettlingOrder::Random,
    is_large_first: true,
    retries: 0,
    method: Method::Exact,
    seed: 1,
};

pub const FULL: Turn = Turn {
    ranges: DVec3::splat(TAU),
    is_global: false,
};

/// A ball of radius 1.
pub fn ball() -> Kind {
    kind(vec![shape(&[(DVec3::ZERO, 1.0)])])
}

/// A rod of five spheres along its x axis, 2.3 long and 0.6 thick, with a straight and a bent
/// variant.
pub fn rod() -> Kind {
    let along = [0.0, -0.45, 0.45, -0.9, 0.9];
    let rod = |bend: f64| {
        shape(&along.map(|x| {
            (
                DVec3::new(x, bend * x * x, 0.0),
                if x.abs() < 0.8 { 0.3 } else { 0.25 },
            )
        }))
    };
    kind(vec![rod(0.0), rod(0.2)])
}

fn kind(shapes: Vec<Shape>) -> Kind {
    Kind {
        shapes,
        scale: 1.0,
        jitter: 0.0,
        density: 1.0,
        turn: FULL,
        range: 2.0,
        inward: 0.75,
    }
}

/// A shape that is the union of spheres. The first one is the largest.
fn shape(spheres: &[(DVec3, f64)]) -> Shape {
    let around = testing::ball(1).0;
    let points = spheres
        .iter()
        .flat_map(|&(centre, radius)| around.iter().map(move |&p| centre + radius * p));
    let points: Vec<DVec3> = points.collect();
    let (lo, hi) = points.iter().fold((points[0], points[0]), |(lo, hi), &p| {
        (lo.min(p), hi.max(p))
    });
    Shape {
        spheres: spheres
            .iter()
            .map(|&(centre, radius)| Sphere { centre, radius })
            .collect(),
        radius: spheres[0].1,
        diagonal: (hi - lo).length(),
        bound: points.iter().map(|p| p.length()).fold(0.0, f64::max),
        points,
    }
}

/// A heap on the ground, with half a side of `radius`: an open surface.
pub fn heap(radius: f64) -> TriMesh {
    let squares = (radius as u32).max(8);
    let height = |x: f64, z: f64| {
        0.5 * radius * (1.0 - x * x) * (1.0 - x * x) * (1.0 - z * z) * (1.0 - z * z)
    };
    testing::mesh(testing::grid(squares, squares, |a, b| {
        let (x, z) = (2.0 * a - 1.0, 1.0 - 2.0 * b);
        DVec3::new(radius * x, height(x, z), radius * z)
    }))
}

/// A closed ball of this radius.
pub fn globe(radius: f64) -> TriMesh {
    let (positions, triangles) = testing::ball(4);
    testing::mesh((
        positions.into_iter().map(|p| radius * p).collect(),
        triangles,
    ))
}

pub fn darts(
    mesh: &TriMesh,
    kinds: &[Kind],
    seed: u64,
    in_scan_order: bool,
    amount: usize,
) -> Vec<Dart> {
    let mut all = Vec::new();
    for (number, kind) in (0u32..).zip(kinds) {
        let mut darting = Darting::new(mesh, kind.spacing(), number, seed, in_scan_order);
        while !darting.advance(mesh, amount) {}
        all.extend(darting.points().iter().map(|p| Dart {
            kind: number,
            layer: 0,
            at: p.at,
            normal: p.normal,
            triangle: p.triangle,
        }));
    }
    all
}

/// A whole pile.
pub fn pile(
    mesh: &TriMesh,
    kinds: Vec<Kind>,
    walls: &[Wall],
    params: RefineParams,
    amount: usize,
) -> Refining {
    let kinds: Arc<[Kind]> = kinds.into();
    let darts = darts(mesh, &kinds, params.seed, false, amount);
    let stays = merge(&darts, &kinds);
    let search = Search::new(mesh);
    let mut refining = Refining::new(mesh, &darts, &stays, kinds, walls.to_vec(), params);
    while !refining.advance(mesh, &search, amount) {}
    refining
}

pub fn count(refining: &Refining, fate: Fate) -> usize {
    refining.bodies().iter().filter(|b| b.fate == fate).count()
}

/// The deepest overlap of two inner spheres of different bodies, in R of the smaller body; less than 0 if none overlap.
pub fn deepest_overlap(bodies: &[Body], kinds: &[Kind]) -> f64 {
    let mut work = OverlapWork::new(bodies, kinds);
    while !work.advance(bodies, kinds) {}
    work.deepest.into_iter().fold(f64::NEG_INFINITY, f64::max)
}

/// How many bodies the line along a surface normal pierces, counted by their inner spheres. Spheres count if their
/// centres are at most `reach` above or below `at`.
pub fn pierced(bodies: &[Body], kinds: &[Kind], (at, normal): (DVec3, DVec3), reach: f64) -> usize {
    let meets = |sphere: Sphere| {
        let away = sphere.centre - at;
        let along = away.dot(normal);
        let square = away.length_squared() - along * along;
        along.abs() <= reach && square < sphere.radius * sphere.radius
    };
    let kept = bodies.iter().filter(|b| b.fate == Fate::Kept);
    kept.filter(|b| b.spheres(kinds).any(meets)).count()
}
