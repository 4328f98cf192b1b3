//! Outlines that are not roads.

use super::curve::ellipse;
use crate::domain::Outline;
use crate::planar::unit_vector;
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn polygon(points: &[(f64, f64)]) -> Vec<DVec2> {
    points.iter().map(|&p| p.into()).collect()
}

fn box_around(centre: DVec2, half: DVec2) -> Vec<DVec2> {
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        .map(|corner| centre + half * DVec2::from(corner))
        .to_vec()
}

/// The area between two concentric circles.
pub fn ring(width: f64) -> Outline {
    const RADIUS: f64 = 0.45;
    let inner = RADIUS * (1.0 - 0.55 * width);
    Outline {
        rings: [RADIUS, inner]
            .map(|radius| ellipse(DVec2::ZERO, DVec2::splat(radius), 0.0))
            .to_vec(),
        ..Outline::default()
    }
}

/// A square; a wide rectangle if the width is below 1, a tall one above.
pub fn rectangle(width: f64) -> Outline {
    let half = DVec2::new(1.0 / width.max(1.0), width.min(1.0)) / 2.0;
    Outline {
        rings: vec![box_around(DVec2::ZERO, half)],
        ..Outline::default()
    }
}

/// Two arms that meet at the lower left.
pub fn l_shape(width: f64) -> Outline {
    let arm = 0.464 * width;
    let rest = 1.0 - arm;
    Outline {
        rings: vec![polygon(&[
            (0.0, 0.0),
            (arm, 0.0),
            (arm, rest),
            (1.0, rest),
            (1.0, 1.0),
            (0.0, 1.0),
        ])],
        ..Outline::default()
    }
}

/// A star with a tip at the top.
pub fn star(width: f64, points: u32) -> Outline {
    let inner = 0.42 * width;
    let corner = |k: u32| {
        let radius = if k.is_multiple_of(2) { 1.0 } else { inner };
        radius * unit_vector(PI * f64::from(k) / f64::from(points) - FRAC_PI_2) / 2.0
    };
    Outline {
        rings: vec![(0..2 * points).map(corner).collect()],
        ..Outline::default()
    }
}

/// A square with round, rectangular and elliptic holes on a circle; a single hole is in the centre.
pub fn plaza(width: f64, count: u32) -> Outline {
    /// Direction of the first hole: the upper left.
    const FIRST: f64 = -0.75 * PI;
    let step = TAU / f64::from(count);
    let away = match count {
        1 => 0.0,
        2..=6 => 0.27,
        _ => 0.33,
    };
    // Half the gap between two holes, or between a hole and the square's side.
    let room = match count {
        1 => 0.4,
        _ => (away * libm::sin(step / 2.0)).min(0.5 - away),
    };
    // Narrower passages leave room for larger holes.
    let size = 0.62 * room * (1.6 - 0.6 * width);
    let square = box_around(DVec2::ZERO, DVec2::splat(0.5));
    let hole = |k: u32| {
        let centre = away * unit_vector(FIRST + step * f64::from(k));
        match k % 3 {
            0 => ellipse(centre, DVec2::splat(size), 0.0),
            1 => box_around(centre, size * DVec2::new(0.9, 0.62)),
            _ => ellipse(centre, size * DVec2::new(1.08, 0.62), -0.3),
        }
    };
    Outline {
        rings: std::iter::once(square)
            .chain((0..count).map(hole))
            .collect(),
        ..Outline::default()
    }
}
