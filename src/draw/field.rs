//! Drawings of the direction field with its sources, and of its singular points.

use super::shapes::{closed, round};
use super::stages::{INK, lines};
use super::{Colour, DrawnPath, Layer, SHEET};
use crate::domain::Domain;
use crate::field::{Fields, Singularity, SoftSpot};
use glam::DVec2;

pub(crate) const CROSS: Colour = [0.54, 0.29, 0.16, 1.0];
const NO_DIRECTION: Colour = [0.20, 0.42, 0.54, 1.0];
/// Colours of singular points with positive and with negative index.
pub(crate) const WITH: Colour = [0.78, 0.25, 0.12, 1.0];
pub(crate) const AGAINST: Colour = [0.13, 0.37, 0.58, 1.0];
const CROSS_OVER: Colour = [1.0, 0.98, 0.94, 0.95];
const STROKE_OVER: Colour = [0.55, 0.95, 0.65, 1.0];
const SPOT_OVER: Colour = [1.0, 0.86, 0.50, 0.95];
pub(crate) const STROKE: Colour = [0.16, 0.46, 0.33, 1.0];
const SIZE_SPOT: Colour = [0.62, 0.40, 0.08, 0.9];
const ASPECT_SPOT: Colour = [0.45, 0.25, 0.55, 0.9];

/// The field as crosses on a grid. A cross is as large as the cells at its place if the grid has room; a dot stands
/// where there is no direction. Also strokes, constraint lines, spots and singular points.
pub fn direction(domain: &Domain, fields: &Fields, side: f64) -> Vec<Layer> {
    let thin = (side / 360.0).clamp(1.0, 3.0);
    let params = fields.params();
    let mut layers = Vec::new();
    spots(&mut layers, &params.size_spots, SIZE_SPOT, thin);
    spots(&mut layers, &params.aspect_spots, ASPECT_SPOT, thin);
    let (arms, dots) = crosses(domain, fields, side, (side / 30.0).max(9.0));
    layers.extend([
        dots,
        Layer::lines(arms, CROSS, thin),
        lines(domain, side),
        Layer::lines(params.strokes.clone(), STROKE, 2.5 * thin),
    ]);
    layers.extend(singularities(domain, fields, side));
    layers
}

/// The field over a picture: the crosses, strokes, constraint lines and spots.
pub fn direction_over(domain: &Domain, fields: &Fields, side: f64) -> Vec<Layer> {
    let thin = (side / 400.0).clamp(1.0, 3.0);
    let params = fields.params();
    let mut layers = Vec::new();
    for spot in params.size_spots.iter().chain(&params.aspect_spots) {
        let rim = [0.54, 1.0].map(|share| closed(&round(spot.centre, share * spot.radius)));
        layers.extend(Layer::rimmed(rim.into(), SPOT_OVER, thin));
    }
    let (arms, dots) = crosses(domain, fields, side, (side / 23.0).max(12.0));
    layers.push(dots);
    for (lines, colour, width) in [
        (arms, CROSS_OVER, thin),
        (domain.lines().to_vec(), CROSS_OVER, 1.3 * thin),
        (params.strokes.clone(), STROKE_OVER, 2.0 * thin),
    ] {
        layers.extend(Layer::rimmed(lines, colour, width));
    }
    layers
}

/// The singular points of the direction with their index.
pub fn singularities(domain: &Domain, fields: &Fields, side: f64) -> Vec<Layer> {
    let mut layers = Vec::new();
    let unit = (side / 170.0).clamp(2.0, 6.0);
    let points = fields.singularities(domain);
    let middle = points.iter().map(|s| s.point.x).sum::<f64>() / points.len().max(1) as f64;
    for point in &points {
        // The label stands on the side away from the other labels, if the picture has room.
        let room = LABEL * unit;
        let x = point.point.x;
        let left = (x < middle - unit && x > room) || x + room > side;
        layers.extend(index(point, unit, left));
    }
    let marks = points.iter().flat_map(|point| mark(point, unit));
    layers.push(Layer::shapes(marks.collect()));
    layers
}

fn spots(layers: &mut Vec<Layer>, spots: &[SoftSpot], colour: Colour, width: f64) {
    for spot in spots {
        // Circles at full weight, at half, and at zero.
        for share in [0.05, 0.54, 1.0] {
            let circle = round(spot.centre, share * spot.radius);
            layers.push(Layer::edges(vec![circle], colour, width));
        }
    }
}

/// The arms of the crosses, and dots where there is no direction.
fn crosses(domain: &Domain, fields: &Fields, side: f64, step: f64) -> (Vec<Vec<DVec2>>, Layer) {
    let count = (side / step) as usize;
    let margin = (side - step * count as f64) / 2.0;
    let (mut arms, mut dots) = (Vec::new(), Vec::new());
    for k in 0..count * count {
        let square = DVec2::new((k % count) as f64 + 0.5, (k / count) as f64 + 0.5);
        let p = DVec2::splat(margin) + step * square;
        let room = domain.nearest(p).distance;
        if room < 0.1 * step {
            continue;
        }
        let axis = fields.direction(p);
        if axis == DVec2::ZERO {
            dots.push(DrawnPath::dot(p, step / 8.0, NO_DIRECTION));
            continue;
        }
        // The whole cross stays inside the outline.
        let arm = (0.46 * fields.size(p)).min(0.42 * step).min(room);
        // If half a turn leaves a cell unchanged but a quarter turn does not, one arm is shorter.
        let short = match fields.kind(p).symmetry() {
            4 => 1.0,
            _ => (1.0 / fields.aspect(p)).min(0.4),
        };
        for along in [axis * arm, axis.perp() * (arm * short)] {
            arms.push(vec![p - along, p + along]);
        }
    }
    (arms, Layer::shapes(dots))
}

/// The width of the label that tells a singular point's index, and its distance from the point, in units.
const LABEL: f64 = 14.0;

/// A disc for a positive index, a square on its tip for a negative one.
fn mark(point: &Singularity, unit: f64) -> [DrawnPath; 2] {
    let (p, turns_with) = (point.point, point.index > 0.0);
    let colour = if turns_with { WITH } else { AGAINST };
    [(2.1 * unit, SHEET.bed), (1.6 * unit, colour)].map(|(radius, colour)| {
        if turns_with {
            return DrawnPath::dot(p, radius, colour);
        }
        let tip = |c: DVec2| p + 1.2 * radius * c;
        let tips = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y].map(tip);
        DrawnPath::fill(vec![tips.to_vec()], colour, 0.0)
    })
}

/// The index of a singular point, written beside it: dark lines on broad light ones.
fn index(point: &Singularity, unit: f64, left: bool) -> [Layer; 2] {
    let word = signs(point.index);
    let start = match left {
        true => -2.8 - 2.4 * word.len() as f64,
        false => 3.4,
    };
    let mut bars = Vec::new();
    for (k, &sign) in word.iter().enumerate() {
        let corner = point.point + unit * DVec2::new(start + 2.4 * k as f64, -1.8);
        let at = |place: u8| {
            corner + 0.9 * unit * DVec2::new(f64::from(place % 3), f64::from(place / 3))
        };
        bars.extend(sign.iter().map(|&[a, b]| vec![at(a), at(b)]));
    }
    [
        Layer::lines(bars.clone(), SHEET.bed, 1.6 * unit),
        Layer::lines(bars, INK, 0.5 * unit),
    ]
}

/// Bars between places of a grid of 3 columns and 5 rows, numbered from the upper left.
type Sign = &'static [[u8; 2]];

const PLUS: Sign = &[[6, 8], [4, 10]];
const MINUS: Sign = &[[6, 8]];
const OVER: Sign = &[[12, 2]];
const DIGITS: [Sign; 4] = [
    &[[3, 1], [1, 13]],
    &[[0, 2], [2, 8], [8, 6], [6, 12], [12, 14]],
    &[[0, 2], [2, 14], [6, 8], [12, 14]],
    &[[0, 6], [6, 8], [2, 14]],
];

/// The signs of an index, a multiple of 1/4 up to 4.
fn signs(index: f64) -> Vec<Sign> {
    let quarters = (4.0 * index).abs().round() as usize;
    let below = match quarters % 4 {
        0 => 1,
        2 => 2,
        _ => 4,
    };
    let above = (quarters * below / 4).clamp(1, 4);
    let mut word = vec![if index > 0.0 { PLUS } else { MINUS }, DIGITS[above - 1]];
    if below > 1 {
        word.extend([OVER, DIGITS[below - 1]]);
    }
    word
}
