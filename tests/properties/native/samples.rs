//! Sample cells and planes for other tests.

use bubblestone::cells::Cell;
use bubblestone::domain::{Domain, signed_area};
use bubblestone::field::CellKind;
use bubblestone::heightfield::{Painter, Planes, TextureParams, Weathering};
use bubblestone::material::WeatherParams;
use bubblestone::random::{Purpose, Random};
use bubblestone::solid::Solids;
use glam::DVec2;
use std::f64::consts::TAU;

/// Side of the pictures, in pixels.
pub const SIDE: usize = 96;

/// A cell with this ring.
pub fn cell(id: u32, ring: Vec<DVec2>) -> Cell {
    let centre = ring.iter().sum::<DVec2>() / ring.len() as f64;
    Cell {
        id,
        centre,
        kind: CellKind::Square,
        size: signed_area(&ring).abs().sqrt(),
        aspect: 1.0,
        axis: DVec2::X,
        ring,
    }
}

/// A ring of `n` points whose radii vary by the fraction `rough` (0..1).
pub fn star(n: usize, radius: f64, rough: f64, id: u32) -> Cell {
    let mut random = Random::new(5, Purpose::Placement, u64::from(id));
    let at = |i: usize, r: f64| {
        let angle = i as f64 / n as f64 * TAU;
        DVec2::new(libm::cos(angle), libm::sin(angle)) * r + 48.0
    };
    let ring = (0..n)
        .map(|i| at(i, radius * (1.0 - rough * random.unit())))
        .collect();
    cell(id, ring)
}

/// Squares with slightly moved corners, which fill the picture up to a margin.
pub fn pavement(size: f64) -> Vec<Cell> {
    let n = ((SIDE as f64 - 12.0) / size) as usize;
    let mut random = Random::new(8, Purpose::Placement, 0);
    let points: Vec<DVec2> = (0..(n + 1) * (n + 1))
        .map(|k| {
            let p = DVec2::new((k % (n + 1)) as f64, (k / (n + 1)) as f64);
            (p + DVec2::new(random.signed(), random.signed()) * 0.1) * size + 6.0
        })
        .collect();
    let at = |i: usize, j: usize| points[j * (n + 1) + i];
    (0..n * n)
        .map(|k| {
            let (i, j) = (k % n, k / n);
            let ring = vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            cell(k as u32, ring)
        })
        .collect()
}

/// The finished planes of a pavement.
pub fn painted(params: TextureParams, cells: &[Cell]) -> Planes {
    let mut solids = Solids::new();
    let mut painter = Painter::new(params);
    for (index, cell) in cells.iter().enumerate() {
        painter.paint(&mut solids, cell, index);
    }
    in_fair_weather(painter)
}

/// The planes of a painter without weather.
pub fn in_fair_weather(painter: Painter) -> Planes {
    let mut weather = Weathering::new(WeatherParams::default(), painter.finish());
    let domain = Domain::torus(1.0, &[]);
    while !weather.advance(&domain, 17) {}
    weather.finish()
}

/// Small pictures of small stones.
pub fn small() -> TextureParams {
    TextureParams {
        side: SIDE,
        size: 16.0,
        ..TextureParams::default()
    }
}
