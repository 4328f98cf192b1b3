//! Arcs as points, and roads along them.

use crate::planar::unit_vector;
use glam::DVec2;
use std::f64::consts::FRAC_PI_2;

/// Chords deviate from the curve by at most this many sides of the picture (0.09 px of 512).
const SAGITTA: f64 = 1.0 / 6000.0;

/// The number of chords for an arc.
pub fn chords(radius: f64, angle: f64) -> usize {
    let one = (8.0 * SAGITTA / radius).sqrt().min(FRAC_PI_2 / 3.0);
    ((angle.abs() / one).ceil() as usize).max(1)
}

/// Points of an arc, both ends included.
pub fn arc(centre: DVec2, radius: f64, from: f64, to: f64) -> impl Iterator<Item = DVec2> {
    let n = chords(radius, to - from);
    (0..=n).map(move |k| centre + radius * unit_vector(from + (to - from) * k as f64 / n as f64))
}

/// Points of an ellipse with its first half axis turned by an angle, as a ring.
pub fn ellipse(centre: DVec2, half: DVec2, turn: f64) -> Vec<DVec2> {
    let n = chords(half.max_element(), std::f64::consts::TAU).next_multiple_of(4);
    (0..n)
        .map(|k| unit_vector(std::f64::consts::TAU * k as f64 / n as f64) * half)
        .map(|p| centre + unit_vector(turn).rotate(p))
        .collect()
}

/// A pen that draws both sides of a road along its centre line.
pub struct Road {
    place: DVec2,
    heading: f64,
    half: f64,
    right: Vec<DVec2>,
    left: Vec<DVec2>,
}

impl Road {
    /// Starts at the origin.
    pub fn new(heading: f64, half_width: f64) -> Self {
        let mut road = Self {
            place: DVec2::ZERO,
            heading,
            half: half_width,
            right: Vec::new(),
            left: Vec::new(),
        };
        road.mark();
        road
    }

    fn mark(&mut self) {
        let across = self.half * unit_vector(self.heading + FRAC_PI_2);
        self.right.push(self.place + across);
        self.left.push(self.place - across);
    }

    /// Continues straight.
    pub fn straight(&mut self, length: f64) {
        if length > 0.0 {
            self.place += length * unit_vector(self.heading);
            self.mark();
        }
    }

    /// Follows an arc that turns by an angle, clockwise where it is positive.
    pub fn bend(&mut self, radius: f64, angle: f64) {
        let to_centre = FRAC_PI_2.copysign(angle);
        let centre = self.place + radius * unit_vector(self.heading + to_centre);
        let start = self.heading;
        let n = chords(radius + self.half, angle);
        for k in 1..=n {
            self.heading = start + angle * k as f64 / n as f64;
            self.place = centre - radius * unit_vector(self.heading + to_centre);
            self.mark();
        }
    }

    /// The ring around the road.
    pub fn outline(self) -> Vec<DVec2> {
        let mut ring = self.left;
        ring.extend(self.right.into_iter().rev());
        ring
    }
}
