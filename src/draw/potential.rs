//! The potential around one cell for a neighbour like it: neighbours come to rest in its wells.
//!
//! Equations (3) and (4) of Miyata, Itoh, Shimada (2000), and the effective distances of Itoh, Miyata,
//! Shimada (2003), section 5.1: a square has four wells at its edges, a circle or an ellipse a ring with room
//! for six.

use super::stages::INK;
use super::{Board, Colour, DrawnPath, Layer, SHEET, blend};
use crate::field::CellKind;
use crate::packing::{CornerBubbles, Particle, force::Pair};
use glam::DVec2;

const HILL: Colour = [0.66, 0.25, 0.13, 1.0];
const WELL: Colour = [0.05, 0.33, 0.40, 1.0];
const LIGHT: Colour = [1.0, 0.98, 0.94, 1.0];
/// The filling of the cell in the middle.
const OWN: Colour = [1.0, 0.98, 0.94, 0.30];
/// The distance of contours in wells, in k0.
const STEP: f64 = 0.008;
/// The number of contours for each doubling on the hill.
const PER_DOUBLING: f64 = 3.0;
/// About the number of contours down to the deepest well and up to the hill's top.
const RANGE: (f64, f64) = (9.0, 11.0);
/// Rays that are searched for wells; a multiple of 12.
const RAYS: usize = 120;
/// The valley around a cell is a ring if its depth varies by less than this share of the greatest depth.
const EVEN: f64 = 0.02;

/// Draws the potential of a cell of this kind and aspect ratio, with a horizontal axis and these corner bubbles.
pub fn potential(
    board: &mut Board,
    kind: CellKind,
    aspect: f64,
    (corners, side): (CornerBubbles, f64),
) {
    let root = if kind.is_stretched() {
        aspect.sqrt()
    } else {
        1.0
    };
    let cell = Particle {
        id: 0,
        centre: DVec2::splat(side / 2.0),
        kind,
        size: side / (3.6 * root),
        aspect: root * root,
        axis: DVec2::X,
        fixed: false,
    };
    let pair = Pair::new(&cell, &cell).with(corners);
    let height = |r: DVec2| pair.potential(r) / (cell.size * cell.size);
    contours(board, |r| level(height(r)));
    board.draw(&figures(
        &cell,
        wells(&cell, height),
        (side / 340.0).max(1.2),
    ));
}

/// The cell, and neighbours at rest.
fn figures(cell: &Particle, wells: Vec<DVec2>, thin: f64) -> Vec<Layer> {
    let mut layers = Vec::new();
    let places = match cell.kind.has_corners() {
        true => wells,
        false => {
            layers.push(Layer::edges(vec![wells], LIGHT, 1.6 * thin));
            cell.places().collect()
        }
    };
    for &centre in &places {
        let other = Particle { centre, ..*cell };
        layers.push(Layer::edges(vec![other.ring(0.97, 64)], LIGHT, thin));
    }
    let own = Layer::fill(vec![cell.ring(1.0, 64)], OWN, 0.0);
    layers.push(own.edged(INK, 1.8 * thin, 0.0));
    let dot = |&place: &DVec2| {
        [(4.2, LIGHT), (2.6, WELL)]
            .map(|(radius, colour)| DrawnPath::dot(place, radius * thin, colour))
    };
    layers.push(Layer::shapes(places.iter().flat_map(dot).collect()));
    layers
}

/// The level of a height, in contours from 0: negative in wells, positive on the hill. Contours lie halfway between
/// whole levels, so that there is none where there is no force.
fn level(height: f64) -> f64 {
    match height < 0.0 {
        true => height / STEP,
        false => PER_DOUBLING * libm::log2(1.0 + height / 0.05),
    }
}

/// Paints the levels, which are the same in all four quarters of the picture.
fn contours(board: &mut Board, level: impl Fn(DVec2) -> f64) {
    let (side, scale) = (board.side(), board.scale() as f64);
    let half = side.div_ceil(2);
    let row = |y: usize| -> Vec<f64> {
        let at = |x: usize| DVec2::new((half - x) as f64 - 0.5, (half - y) as f64 - 0.5);
        (0..=half).map(|x| level(at(x.min(half)) / scale)).collect()
    };
    let rgba = board.rgba_mut();
    let mut here = row(0);
    for y in 0..half {
        let next = row(y + 1);
        for x in 0..half {
            let v = here[x];
            let slope = (here[x + 1] - v).abs().max((next[x] - v).abs()).max(1e-9);
            let from_line = ((v - v.floor()) - 0.5).abs();
            let band = (v + 0.5).floor();
            let colour = shade(0.6 * band + 0.4 * v);
            let dark = (0.5 * scale + 0.5 - from_line / slope).clamp(0.0, 1.0) as f32;
            let colour = blend(colour, INK, 0.38 * dark);
            let bytes = colour.map(|c| (255.0 * c + 0.5) as u8);
            for (x, y) in [
                (x, y),
                (side - 1 - x, y),
                (x, side - 1 - y),
                (side - 1 - x, side - 1 - y),
            ] {
                rgba[4 * (y * side + x)..][..4].copy_from_slice(&bytes);
            }
        }
        here = next;
    }
}

fn shade(level: f64) -> Colour {
    match level < 0.0 {
        true => blend(SHEET.bed, WELL, (-level / RANGE.0) as f32),
        false => blend(SHEET.bed, HILL, (level / RANGE.1) as f32),
    }
}

/// The minima: the rays around the cell where the valley is deepest, or all rays if it is level.
fn wells(cell: &Particle, height: impl Fn(DVec2) -> f64) -> Vec<DVec2> {
    let (e, f) = cell.half_axes();
    let floor = |k: usize| {
        let turn = std::f64::consts::TAU * k as f64 / RAYS as f64;
        let ray = 2.0 * (libm::cos(turn) * e + libm::sin(turn) * f);
        let mut least = (f64::INFINITY, DVec2::ZERO);
        for step in 60..140 {
            let r = ray * (f64::from(step) / 100.0);
            let here = height(r);
            if here < least.0 {
                least = (here, cell.centre + r);
            }
        }
        least
    };
    let floors: Vec<(f64, DVec2)> = (0..RAYS).map(floor).collect();
    let deepest = floors.iter().fold(0.0_f64, |d, f| d.min(f.0));
    let highest = floors.iter().fold(deepest, |d, f| d.max(f.0));
    let is_ring = highest - deepest < EVEN * deepest.abs();
    let is_well = |k: usize| {
        let (before, after) = (floors[(k + RAYS - 1) % RAYS].0, floors[(k + 1) % RAYS].0);
        let here = floors[k].0;
        here <= before && here < after && here < 0.5 * (deepest + highest)
    };
    let wells = (0..RAYS).filter(|&k| is_ring || is_well(k));
    wells.map(|k| floors[k].1).collect()
}
