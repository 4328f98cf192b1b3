//! Straightest paths over a surface.

use super::frame::rotated;
use super::{SurfacePoint, Transport, TriMesh};
use glam::{DVec2, DVec3};

/// The result of a walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walked {
    /// Its end.
    pub to: SurfacePoint,
    /// Carries vectors of the frame at the start into the frame at the end, along the path.
    pub turn: Transport,
    /// Whether it met the border and went on along it.
    pub slid: bool,
}

/// The most edges that a walk crosses.
const MOST_EDGES: usize = 10_000;
/// A step has come to its end when less than this share of it is left.
const END: f64 = 1e-12;
/// The most times that the border may turn a walk aside at a corner.
const MOST_SLIDES: usize = 3;

impl TriMesh {
    /// Goes from a point along a vector of its frame, triangle by triangle. Over each edge the rest of the path is
    /// turned about the edge into the next triangle's plane (the straightest path: Polthier, Schmies 1998,
    /// Straightest Geodesics on Polyhedral Surfaces). At the border the walk goes on along it, by the part of the
    /// vector along the border. A vector that is not finite leads nowhere.
    pub fn walk(&self, from: &SurfacePoint, by: DVec2) -> Walked {
        let length = by.length_squared();
        if !(length > 0.0 && length.is_finite()) {
            return Walked {
                to: *from,
                turn: Transport::NONE,
                slid: false,
            };
        }
        let mut walker = Walker::new(self, from, by);
        let slid = walker.go(length);
        let weights = walker.weights();
        let to = SurfacePoint::new(self, walker.triangle, weights);
        // The turn takes the path's direction at its start to that at its end.
        let end = to
            .frame()
            .within(rotated(walker.heading, walker.normal, to.normal));
        let ahead = walker.ahead;
        let turn = DVec2::new(ahead.dot(end), ahead.perp_dot(end));
        Walked {
            to,
            turn: Transport(turn.normalize_or(DVec2::X)),
            slid,
        }
    }
}

/// The state of a walk. The place is kept as barycentric weights: they are exactly 0 on an edge and never lead out of
/// a triangle. Lengths are parts of the whole step, so crossing an edge needs no square root.
struct Walker<'a> {
    mesh: &'a TriMesh,
    triangle: u32,
    /// The normal of the triangle's plane.
    normal: DVec3,
    weights: [f64; 3],
    /// The whole step, in the triangle's plane.
    heading: DVec3,
    /// The whole step in the frame at the start, as turned and shortened by borders so far.
    ahead: DVec2,
    /// The corner opposite the edge just crossed, which is not crossed back at once; 3 if there is none.
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

    /// Goes the whole step; `length` is the square of its length. True if the walk met the border.
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

    /// How fast the weights change along the path, per whole step; and the corner whose weight first becomes 0, with
    /// the share of the step until then.
    fn rates(&self) -> ([f64; 3], Option<(usize, f64)>) {
        let [a, b, c] = self.mesh.corners(self.triangle);
        let (e, f) = (b - a, c - a);
        let cross = e.cross(f);
        let across = self.heading.cross(cross) / cross.length_squared();
        let (at_b, at_c) = (-f.dot(across), e.dot(across));
        let rates = [-at_b - at_c, at_b, at_c];
        // A weight that falls more slowly than this counts as constant: the path runs along the edge.
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

    /// The vector from one end of an edge to the other.
    fn along(&self, edge: usize) -> DVec3 {
        let corners = &self.mesh.triangles()[self.triangle as usize];
        let positions = self.mesh.positions();
        positions[corners[(edge + 1) % 3] as usize] - positions[corners[edge] as usize]
    }

    /// Goes over an edge into the next triangle and turns the heading about the edge.
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

    /// Goes on along the border, by the part of the rest that leads along it; false if no part does.
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
