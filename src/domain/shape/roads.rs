//! Outlines that are roads.

use super::curve::{Road, arc, chords};
use crate::domain::Outline;
use crate::planar::unit_vector;
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn without_holes(outer: Vec<DVec2>) -> Outline {
    Outline {
        rings: vec![outer],
        ..Outline::default()
    }
}

/// A straight road, three times as long as it is wide.
pub fn straight(width: f64) -> Outline {
    let mut road = Road::new(0.0, width / 6.0);
    road.straight(1.0);
    without_holes(road.outline())
}

/// A road with one quarter bend, with two (an S), or with more: a serpentine that fills a square.
pub fn bends(width: f64, count: u32) -> Outline {
    /// Half the road's width and the straight ends, in bend radii.
    const HALF: f64 = 0.42;
    const ENDS: f64 = 0.6;
    let bends = f64::from(count);
    let long = 2.0 * (bends - 1.0) + 2.0 * ENDS;
    let radius = 0.9 / long.max(2.0);
    let half = HALF * width;
    // The legs are long enough to make the whole as wide as it is long.
    let leg = (long - 2.0 - 2.0 * half).max(0.0);

    let mut road = Road::new(FRAC_PI_2, half * radius);
    road.straight(ENDS * radius);
    let mut side = -1.0;
    for bend in 1..=count {
        let outermost = bend == 1 || bend == count;
        road.bend(radius, side * if outermost { FRAC_PI_2 } else { PI });
        if bend < count {
            road.straight(leg * radius);
        }
        side = -side;
    }
    road.straight(ENDS * radius);
    without_holes(road.outline())
}

/// A road along an Archimedean spiral.
pub fn spiral(width: f64, turns: f64) -> Outline {
    /// Radius at the start, in distances between turns.
    const START: f64 = 0.6;
    // Half the width, in distances between turns; the turns keep a gap at any width.
    let half = 0.3 + 0.2 * (width - 1.0);
    let pitch = 0.47 / (START + turns + half);
    let n = chords((START + turns) * pitch, TAU * turns);
    let mut sides = [Vec::new(), Vec::new()];
    for k in 0..=n {
        // Equal swept areas give chords of nearly equal length.
        let t = k as f64 / n as f64;
        let radius = (START * START + t * turns * (turns + 2.0 * START)).sqrt();
        let angle = TAU * (radius - START);
        let (out, along) = (unit_vector(angle), unit_vector(angle + FRAC_PI_2));
        let tangent = (out / TAU + along * radius).normalize();
        for (side, sign) in sides.iter_mut().zip([1.0, -1.0]) {
            side.push(pitch * (radius * out - sign * half * tangent.perp()));
        }
    }
    let [mut outer, inner] = sides;
    outer.extend(inner.into_iter().rev());
    without_holes(outer)
}

/// Roads that meet in the centre, with rounded corners between them. `first` is the angle of the first arm, in radians.
pub fn junction(width: f64, arms: u32, first: f64) -> Outline {
    const LENGTH: f64 = 0.45;
    let wedge = PI / f64::from(arms);
    let half = width * LENGTH * (0.45 * libm::sin(wedge)).min(0.25);
    // The distance along an arm at which the sides of neighbours would meet, and the largest rounding that
    // leaves a part of the arm straight.
    let corner = half / libm::tan(wedge);
    let rounding = (0.9 * half).min(0.7 * (LENGTH - corner) * libm::tan(wedge));
    let mut ring = Vec::new();
    for arm in 0..arms {
        let angle = first + TAU * f64::from(arm) / f64::from(arms);
        let (along, across) = (unit_vector(angle), unit_vector(angle + FRAC_PI_2));
        ring.push(LENGTH * along - half * across);
        ring.push(LENGTH * along + half * across);
        if arms > 2 {
            let centre = unit_vector(angle + wedge) * (half + rounding) / libm::sin(wedge);
            let from = angle - FRAC_PI_2;
            ring.extend(arc(centre, rounding, from, from - (PI - 2.0 * wedge)));
        }
    }
    without_holes(ring)
}

/// A straight road with notches cut alternately from its sides, starting below.
pub fn notched(width: f64, count: u32) -> Outline {
    let road = 0.44 * width;
    let depth = 0.53 * road;
    let n = f64::from(count);
    let half_notch = 0.07_f64.min(0.2 / n);
    let middle = |k: u32| match count {
        1 => 0.58,
        _ => (f64::from(k) + 0.5) / n,
    };
    let notch = |k: u32, edge: f64, bottom: f64| {
        let (from, to) = (middle(k) - half_notch, middle(k) + half_notch);
        [(from, edge), (from, bottom), (to, bottom), (to, edge)]
    };
    let mut above = vec![(0.0, 0.0)];
    above.extend(
        (0..count)
            .filter(|k| k % 2 == 1)
            .flat_map(|k| notch(k, 0.0, depth)),
    );
    above.push((1.0, 0.0));
    let mut below = vec![(0.0, road)];
    below.extend(
        (0..count)
            .filter(|k| k % 2 == 0)
            .flat_map(|k| notch(k, road, road - depth)),
    );
    below.push((1.0, road));
    above.extend(below.into_iter().rev());
    without_holes(above.into_iter().map(DVec2::from).collect())
}
