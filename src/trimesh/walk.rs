//! Walking over a surface, straight on.

use super::frame::rotated;
use super::{SurfacePoint, TriMesh, Turn};
use glam::{DVec2, DVec3};

/// Where a walk has led.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walked {
    /// Its end.
    pub to: SurfacePoint,
    /// Carries vectors of the frame at its start into that at its end, along the way.
    pub turn: Turn,
    /// It met the border, and went on along it.
    pub slid: bool,
}

/// The most edges that a walk crosses.
const MOST_EDGES: usize = 10_000;
/// What is left of a step that has come to its end, as a share of it.
const END: f64 = 1e-12;
/// At a corner the border turns a walk aside at most so many times.
const MOST_SLIDES: usize = 3;

impl TriMesh {
    /// Goes from a point by a vector of its frame, triangle by triangle: over each edge the rest of the way is turned
    /// about it into the next triangle's plane (the straightest path: Polthier, Schmies 1998, Straightest Geodesics on
    /// Polyhedral Surfaces). At the border it goes on along it, as far as it leads that way. A vector that is not
    /// finite leads nowhere.
    pub fn walk(&self, from: &SurfacePoint, by: DVec2) -> Walked {
        let length = by.length_squared();
        if !(length > 0.0 && length.is_finite()) {
            return Walked {
                to: *from,
                turn: Turn::NONE,
                slid: false,
            };
        }
        let mut walker = Walker::new(self, from, by);
        let slid = walker.go(length);
        let weights = walker.weights();
        let to = SurfacePoint::new(self, walker.triangle, weights);
        // What the way's direction was at its start, and has become at its end, tells the turn.
        let end = to
            .frame()
            .within(rotated(walker.heading, walker.normal, to.normal));
        let ahead = walker.ahead;
        let turn = DVec2::new(ahead.dot(end), ahead.perp_dot(end));
        Walked {
            to,
            turn: Turn(turn.normalize_or(DVec2::X)),
            slid,
        }
    }
}

/// On its way it keeps to barycentric weights: they are 0 on an edge, to the bit, and never lead out of a triangle.
/// Lengths are parts of the whole step, so no root is taken from edge to edge.
struct Walker<'a> {
    mesh: &'a TriMesh,
    triangle: u32,
    /// Of the triangle's plane.
    normal: DVec3,
    weights: [f64; 3],
    /// The whole step, in the triangle's plane.
    heading: DVec3,
    /// The same in the frame at the start, carried along.
    ahead: DVec2,
    /// The corner across the edge just come over, which is not crossed again at once.
    behind: usize,
}

impl<'a> Walker<'a> {
    fn new(mesh: &'a TriMesh, from: &SurfacePoint, by: DVec2) -> Self {
        let normal = mesh.face_normal(from.triangle);
        Self {
            mesh,
            triangle: from.triangle,
            normal,
            weights: from.weights(mesh).max(DVec3::ZERO).to_array(),
            heading: rotated(from.frame().out(by), from.normal, normal),
            ahead: by,
            behind: 3,
        }
    }

    fn weights(&self) -> DVec3 {
        let weights = DVec3::from(self.weights).max(DVec3::ZERO);
        weights / (weights.x + weights.y + weights.z)
    }

    /// Goes a step whose length has this square; true where it met the border.
    fn go(&mut self, length: f64) -> bool {
        let (mut left, mut slid, mut slides) = (1.0, false, 0);
        for _ in 0..MOST_EDGES {
            let (rates, exit) = self.rates();
            let Some((corner, far)) = exit else {
                return slid;
            };
            let part = if far < left { far } else { left };
            for (weight, rate) in self.weights.iter_mut().zip(rates) {
                *weight += rate * part;
            }
            left -= far;
            if left <= END {
                return slid;
            }
            self.weights[corner] = 0.0;
            if far > END {
                slides = 0;
            }
            let edge = (corner + 1) % 3;
            match self.mesh.across(self.triangle, edge) {
                Some((next, entered)) => self.cross(edge, next, entered),
                None => {
                    (slid, slides) = (true, slides + 1);
                    if slides > MOST_SLIDES || !self.slide(edge, length) {
                        return slid;
                    }
                }
            }
        }
        slid
    }

    /// How fast the weights change on the way, and the corner whose weight is the first to be 0, and when.
    fn rates(&self) -> ([f64; 3], Option<(usize, f64)>) {
        let [a, b, c] = self.mesh.corners(self.triangle);
        let (e, f) = (b - a, c - a);
        let cross = e.cross(f);
        let across = self.heading.cross(cross) / cross.length_squared();
        let (at_b, at_c) = (-f.dot(across), e.dot(across));
        let rates = [-at_b - at_c, at_b, at_c];
        // Slower is along the edge.
        let least = -1e-14 * (at_b.abs() + at_c.abs());
        let mut exit: Option<(usize, f64)> = None;
        for (k, &rate) in rates.iter().enumerate() {
            if rate < least && k != self.behind {
                let far = (self.weights[k] / -rate).max(0.0);
                if exit.is_none_or(|(_, first)| far < first) {
                    exit = Some((k, far));
                }
            }
        }
        (rates, exit)
    }

    /// From one end of an edge to the other.
    fn along(&self, edge: usize) -> DVec3 {
        let corners = &self.mesh.triangles()[self.triangle as usize];
        let positions = self.mesh.positions();
        positions[corners[(edge + 1) % 3] as usize] - positions[corners[edge] as usize]
    }

    /// Into the next triangle, with the heading turned about the edge.
    fn cross(&mut self, edge: usize, next: u32, entered: usize) {
        let along = self.along(edge);
        let normal = self.mesh.face_normal(next);
        let scale = 1.0 / along.length_squared();
        let on = self.heading.dot(along) * scale;
        let aside = self.heading.dot(self.normal.cross(along)) * scale;
        self.heading = along * on + normal.cross(along) * aside;
        let mut weights = [0.0; 3];
        weights[entered] = self.weights[(edge + 1) % 3];
        weights[(entered + 1) % 3] = self.weights[edge];
        self.weights = weights;
        (self.triangle, self.normal) = (next, normal);
        self.behind = (entered + 2) % 3;
    }

    /// On along the border, as much of the way as leads along it; false where none does.
    fn slide(&mut self, edge: usize, length: f64) -> bool {
        let along = self.along(edge);
        let whole = self.heading.length_squared();
        let share = self.heading.dot(along) / along.length_squared();
        let heading = along * share;
        let left = heading.length_squared();
        if left <= END * END * length {
            return false;
        }
        let aside = self.normal.cross(self.heading).dot(heading);
        self.ahead = (self.ahead * left + self.ahead.perp() * aside) / whole;
        self.heading = heading;
        self.behind = (edge + 2) % 3;
        true
    }
}

#[cfg(test)]
mod tests;
