//! A round tower: a hollow cylinder with windows, whose sills and heads are sectors of disks.

use super::Module;
use super::drafting::Drafting;
use super::panes;
use super::wall_plane::WallPlane;
use crate::building::draft::Draft;
use crate::building::labels::{SILL, WINDOW};
use crate::building::path::Path;
use crate::building::piece::{CircularArc, Piece};
use crate::building::surface::{Disk, FaceSurface, Sweep};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// The bottom and the springing of windows, and how much higher every other window is at most (courses).
const HEIGHTS: [f64; 3] = [8.0, 18.0, 6.0];
/// The number of arcs of which a loop around a whole circle consists.
const QUARTERS: u32 = 4;

/// A window by its angles and heights.
#[derive(Clone, Copy)]
struct Slot {
    /// The angles of both sides, counter-clockwise seen from above (radians).
    angles: [f64; 2],
    heights: [f64; 2],
}

/// The outer and the inner radius, the height (metres), and the windows.
struct Tower {
    radii: [f64; 2],
    top: f64,
    slots: Vec<Slot>,
}

pub(super) fn tower(module: &Module, n: &[f64]) -> Draft {
    let radius = n[0] * module.half / TAU;
    let tower = Tower {
        radii: [radius, radius - module.pier(n[2])],
        top: module.top(n[1]),
        slots: slots(module, n),
    };
    let mut to = Drafting::default();
    tower.shell(&mut to, true);
    tower.shell(&mut to, false);
    tower.cap(&mut to, tower.top, DVec3::Y);
    tower.cap(&mut to, 0.0, DVec3::NEG_Y);
    for slot in &tower.slots {
        tower.reveal(&mut to, slot);
    }
    to.on_ground()
}

/// The windows: as many as there is room for, each beginning at a whole module.
fn slots(module: &Module, n: &[f64]) -> Vec<Slot> {
    let (around, width) = (n[0], n[4]);
    let count = n[3].min((around / (width + 4.0)).floor());
    let radius = around * module.half / TAU;
    let half = 0.5 * module.joint;
    let slot = |k: u32| {
        let left = (around * f64::from(k) / count).round() * module.half;
        let lift = f64::from(k % 2) * HEIGHTS[2].min((n[1] - HEIGHTS[1] - 4.0).max(0.0));
        let [low, high] = [HEIGHTS[0], HEIGHTS[1]].map(|course| (course + lift) * module.course);
        Slot {
            angles: [left - half, left + width * module.half + half].map(|s| s / radius),
            heights: [low - module.joint, high],
        }
    };
    (0..count as u32).map(slot).collect()
}

/// The place at a radius, an angle from x towards -z, and a height.
fn at(radius: f64, angle: f64, y: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(angle);
    DVec3::new(radius * cos, y, -radius * sin)
}

impl Tower {
    /// The ends of the four quarters of a circle around the axis, counter-clockwise seen from above.
    fn circle(&self, radius: f64, y: f64) -> Vec<DVec3> {
        let quarter = |k| TAU * f64::from(k) / f64::from(QUARTERS);
        (0..QUARTERS).map(|k| at(radius, quarter(k), y)).collect()
    }

    /// Declares the arcs of a circle.
    fn declare(to: &mut Drafting, circle: &[DVec3], y: f64) {
        for k in 0..circle.len() {
            let next = circle[(k + 1) % circle.len()];
            to.arc(circle[k], next, DVec3::Y * y, DVec3::Y);
        }
    }

    /// The outer or the inner wall.
    fn shell(&self, to: &mut Drafting, is_outer: bool) {
        let radius = self.radii[usize::from(!is_outer)];
        let mut loops = vec![self.circle(radius, 0.0), self.circle(radius, self.top)];
        Self::declare(to, &loops[0], 0.0);
        Self::declare(to, &loops[1], self.top);
        loops[1].reverse();
        for slot in &self.slots {
            let ([left, right], [low, high]) = (slot.angles, slot.heights);
            let corners = [(left, low), (left, high), (right, high), (right, low)];
            loops.push(corners.map(|(angle, y)| at(radius, angle, y)).to_vec());
        }
        let turn = if is_outer { TAU } else { -TAU };
        if !is_outer {
            loops.iter_mut().for_each(|ring| ring.reverse());
        }
        let start = at(radius, 0.0, 0.0);
        let arc = CircularArc::about(DVec3::ZERO, DVec3::Y, start, turn);
        let sweep = Sweep::new(Path::new(vec![Piece::Arc(arc)]), DVec3::Y);
        to.face(&[], FaceSurface::Sweep(sweep), &loops);
    }

    /// The ring at the top or at the bottom.
    fn cap(&self, to: &mut Drafting, y: f64, normal: DVec3) {
        let mut loops = self.radii.map(|radius| self.circle(radius, y));
        loops[1].reverse();
        if normal.y < 0.0 {
            loops.iter_mut().for_each(|ring| ring.reverse());
        }
        let disk = Disk::new(DVec3::Y * y, normal, DVec3::X, self.radii[0], [0.0, TAU]);
        to.face(&[], FaceSurface::Disk(disk), &loops);
    }

    /// The four faces of a window, and its flat pane with a frame.
    fn reveal(&self, to: &mut Drafting, slot: &Slot) {
        let ([left, right], [low, high]) = (slot.angles, slot.heights);
        let [outer, inner] = self.radii;
        for (y, normal, labels) in [
            (low, DVec3::Y, &[WINDOW, SILL][..]),
            (high, DVec3::NEG_Y, &[WINDOW]),
        ] {
            for radius in self.radii {
                to.arc(
                    at(radius, left, y),
                    at(radius, right, y),
                    DVec3::Y * y,
                    DVec3::Y,
                );
            }
            let mut ring = vec![
                at(outer, left, y),
                at(outer, right, y),
                at(inner, right, y),
                at(inner, left, y),
            ];
            // Angles of a disk grow clockwise seen from outside.
            let (zero, turn) = match normal.y > 0.0 {
                true => (right, right - left),
                false => (left, right - left),
            };
            if normal.y < 0.0 {
                ring.reverse();
            }
            let zero = at(1.0, zero, 0.0);
            let disk = Disk::new(DVec3::Y * y, normal, zero, outer, [0.0, turn]);
            to.face(labels, FaceSurface::Disk(disk), &[ring]);
        }
        for (angle, sign) in [(left, 1.0), (right, -1.0)] {
            let corners = [(outer, low), (inner, low), (inner, high), (outer, high)];
            let corners = corners.map(|(radius, y)| at(radius, angle, y));
            let around = at(1.0, angle + 0.25 * TAU, 0.0);
            to.panel(&[WINDOW], &corners, around * sign);
        }
        let middle = 0.5 * (outer + inner);
        let [from, end] = [left, right].map(|angle| at(middle, angle, 0.0));
        let width = from.distance(end);
        let outline = [(0.0, low), (0.0, high), (width, high), (width, low)];
        let plane = WallPlane::new(from, end, 0.0);
        panes::window(to, (&plane, 0.0), &outline.map(DVec2::from));
    }
}
