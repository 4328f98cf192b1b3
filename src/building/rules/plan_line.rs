//! The line of a plan along which walls stand, and lines beside it.

use glam::DVec2;

/// A line through corners in plan, y away from the viewer (metres): open, or closed from the last corner to the first.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlanLine {
    pub corners: Vec<DVec2>,
    pub is_closed: bool,
}

impl PlanLine {
    /// The number of straight parts.
    pub fn walls(&self) -> usize {
        self.corners.len() - usize::from(!self.is_closed)
    }

    fn corner(&self, k: usize) -> DVec2 {
        self.corners[k % self.corners.len()]
    }

    /// The length of a part (metres).
    pub fn length(&self, wall: usize) -> f64 {
        self.corner(wall).distance(self.corner(wall + 1))
    }

    /// The direction of a part.
    pub fn way(&self, wall: usize) -> DVec2 {
        (self.corner(wall + 1) - self.corner(wall)).normalize()
    }

    /// The directions of the parts before and after a corner; `None` at the ends of an open line.
    pub fn turn(&self, corner: usize) -> Option<[DVec2; 2]> {
        let (count, n) = (self.walls(), self.corners.len());
        let is_end = !self.is_closed && [0, n - 1].contains(&(corner % n));
        (!is_end).then(|| [(corner + count - 1) % count, corner % count].map(|k| self.way(k)))
    }

    /// Whether it is closed and turns the same way, left or right, at all corners.
    pub fn is_convex(&self) -> bool {
        let turns = (0..self.corners.len()).map(|k| self.turn(k).map(|[a, b]| a.perp_dot(b)));
        let turns: Option<Vec<f64>> = turns.collect();
        turns.is_some_and(|turns| turns.iter().all(|turn| turn * turns[0] > 0.0))
    }

    /// Where the parallel of a part at this distance to the left begins and ends (metres from the part's first corner).
    /// It ends where it meets the parallels of the neighbouring parts; at an end of an open line it is shorter by
    /// `free`.
    pub fn span(&self, wall: usize, distance: f64, free: f64) -> [f64; 2] {
        let inset = |corner| match self.turn(corner) {
            // The tangent of half of the angle by which the line turns to the left.
            Some([a, b]) => distance * a.perp_dot(b) / (1.0 + a.dot(b)),
            None => free,
        };
        [inset(wall), self.length(wall) - inset(wall + 1)]
    }

    /// The corners of the line at this distance to the left.
    pub fn beside(&self, distance: f64, free: f64) -> Vec<DVec2> {
        let at = |wall: usize, end: usize| {
            let way = self.way(wall);
            self.corners[wall] + way * self.span(wall, distance, free)[end] + way.perp() * distance
        };
        let last = (!self.is_closed).then(|| at(self.walls() - 1, 1));
        (0..self.walls())
            .map(|wall| at(wall, 0))
            .chain(last)
            .collect()
    }

    /// The border of the strip between two distances to the left: one ring, or two if the line is closed.
    pub fn border(&self, distances: [f64; 2], free: f64) -> Vec<Vec<DVec2>> {
        let [mut front, mut back] = distances.map(|distance| self.beside(distance, free));
        back.reverse();
        if self.is_closed {
            return vec![front, back];
        }
        front.append(&mut back);
        vec![front]
    }
}
