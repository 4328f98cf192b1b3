//! Thick walls along a line that turns corners, with openings that go through: free-standing walls, gates, and walls
//! around a yard.

use super::Module;
use super::drafting::Drafting;
use super::hipped::slopes;
use super::openings::{Opening, Reveal};
use super::plain::{over, turned};
use super::plan_line::PlanLine;
use super::wall_plane::WallPlane;
use crate::building::labels::ROOF;
use crate::domain::signed_area;
use crate::trimesh::polygon;
use glam::{DVec2, DVec3};

/// Walls that stand to the left of a line. Their fronts look to its right, and stand half a joint to its left.
pub(super) struct WallLine<'a> {
    module: &'a Module,
    line: PlanLine,
    /// The distances of fronts and backs from the line (metres).
    distances: [f64; 2],
    top: f64,
    /// The tangent of the pitch of their roof, if there is one.
    pitch: Option<f64>,
}

/// A place on the front of walls, and the place behind it on their back.
type Across = [DVec3; 2];

impl<'a> WallLine<'a> {
    /// Walls of a height in courses and a thickness in modules. The line is moved so that the middle of their bounding
    /// box is the origin.
    pub fn new(module: &'a Module, mut line: PlanLine, [height, thickness]: [f64; 2]) -> Self {
        let half = 0.5 * module.joint;
        let distances = [half, thickness * module.half - half];
        let border = line.border(distances, half).concat();
        let start = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (low, high) = border
            .iter()
            .fold(start, |(lo, hi), &p| (lo.min(p), hi.max(p)));
        let middle = low.midpoint(high);
        line.corners.iter_mut().for_each(|corner| *corner -= middle);
        Self {
            module,
            line,
            distances,
            top: module.top(height),
            pitch: None,
        }
    }

    /// Puts the walls under a hipped roof of a pitch in degrees. Returns false, and makes no roof, if their line is not
    /// convex.
    pub fn set_roof(&mut self, pitch: f64) -> bool {
        let (sin, cos) = libm::sincos(pitch.to_radians());
        self.pitch = self.line.is_convex().then_some(sin / cos);
        self.pitch.is_some()
    }

    /// One straight wall of a length in modules.
    pub fn straight(module: &'a Module, length: f64, size: [f64; 2]) -> Self {
        let line = PlanLine {
            corners: vec![DVec2::ZERO, DVec2::X * length * module.half],
            is_closed: false,
        };
        Self::new(module, line, size)
    }

    fn thickness(&self) -> f64 {
        self.distances[1] - self.distances[0]
    }

    fn plane(&self, wall: usize) -> WallPlane {
        let way = self.line.way(wall);
        let front = self.line.corners[wall] + way.perp() * self.distances[0];
        WallPlane::new(over(front, 0.0), over(front + way, 0.0), 0.0)
    }

    /// Where the front and the back of a wall begin and end along its line (metres).
    fn spans(&self, wall: usize) -> [[f64; 2]; 2] {
        let free = 0.5 * self.module.joint;
        self.distances
            .map(|distance| self.line.span(wall, distance, free))
    }

    /// The part of a wall along which it has both a front and a back (metres along its line).
    pub fn free(&self, wall: usize) -> [f64; 2] {
        let [front, back] = self.spans(wall);
        [front[0].max(back[0]), front[1].min(back[1])]
    }

    /// Adds the walls with openings, each given with the number of its wall. Openings that begin on the ground have no
    /// sill. All others are closed with panes if `has_panes`.
    pub fn build(&self, to: &mut Drafting, openings: &[(usize, Opening)], has_panes: bool) {
        let of = |wall: usize| {
            let own = openings.iter().filter(move |of| of.0 == wall);
            let mut own: Vec<Opening> = own.map(|of| of.1).collect();
            own.sort_by(|a, b| a.left.total_cmp(&b.left));
            own
        };
        let openings: Vec<Vec<Opening>> = (0..self.line.walls()).map(of).collect();
        let mut gates = Vec::new();
        for (wall, own) in openings.iter().enumerate() {
            let (open, windows): (Vec<Opening>, Vec<Opening>) =
                own.iter().partition(|opening| opening.bottom <= 0.0);
            let [open, windows] = [open, windows].map(|own| -> Vec<Reveal> {
                own.iter()
                    .map(|opening| opening.reveal(self.module))
                    .collect()
            });
            self.wall(to, wall, (&open, &windows), has_panes);
            gates.push(open.iter().map(Reveal::sides).collect());
        }
        self.ends(to);
        let none = vec![Vec::new(); gates.len()];
        match self.pitch {
            Some(pitch) => self.roof(to, pitch),
            None => {
                for (strip, is_ring) in self.strips(&none) {
                    to.flat(&[], &loops(&strip, is_ring, self.top));
                }
            }
        }
        for (strip, is_ring) in self.strips(&gates) {
            let mut below = loops(&strip, is_ring, 0.0);
            below.iter_mut().for_each(|ring| ring.reverse());
            to.flat(&[], &below);
        }
    }

    /// Adds the front and the back of a wall, and the faces of its openings.
    fn wall(
        &self,
        to: &mut Drafting,
        wall: usize,
        (gates, windows): (&[Reveal], &[Reveal]),
        has_panes: bool,
    ) {
        let (plane, thickness) = (self.plane(wall), self.thickness());
        let loops = |[from, end]: [f64; 2], behind: f64| -> Vec<Vec<DVec3>> {
            let low = gates.iter().flat_map(Reveal::corners);
            let ends = [(end, 0.0), (end, self.top), (from, self.top)].map(DVec2::from);
            let outline = [DVec2::new(from, 0.0)].into_iter().chain(low).chain(ends);
            let outline = outline.map(|p| plane.at(p, behind)).collect();
            let holes = windows.iter().map(|window| window.hole(&plane, behind));
            [outline].into_iter().chain(holes).collect()
        };
        let [front, back] = self.spans(wall);
        to.flat(&[], &loops(front, 0.0));
        let mut back = loops(back, thickness);
        back.iter_mut().for_each(|ring| ring.reverse());
        to.flat(&[], &back);
        for gate in gates {
            gate.faces(to, &plane, thickness, false);
        }
        for window in windows {
            window.faces(to, &plane, thickness, true);
            if has_panes {
                window.pane(to, &plane, 0.5 * thickness);
            }
        }
    }

    /// Adds the narrow faces at both ends of an open line.
    fn ends(&self, to: &mut Drafting) {
        let last = self.line.walls() - 1;
        for (wall, end) in [(0, 0), (last, 1)] {
            if self.line.turn(wall + end).is_none() {
                let plane = self.plane(wall);
                let u = self.spans(wall)[0][end];
                let corners = [(0.0, 0.0), (self.top, 0.0), (self.top, 1.0), (0.0, 1.0)];
                let corners =
                    corners.map(|(y, back)| plane.at(DVec2::new(u, y), back * self.thickness()));
                to.panel(&[], &corners, plane.along * (2.0 * end as f64 - 1.0));
            }
        }
    }

    /// Adds a hipped roof from the outer faces of walls around a yard, and the ceiling between the inner ones.
    fn roof(&self, to: &mut Drafting, pitch: f64) {
        let rings = self
            .distances
            .map(|distance| self.line.beside(distance, 0.0));
        let turns_left = signed_area(&rings[0]) > 0.0;
        let [mut outer, mut inner] = rings;
        if !turns_left {
            (outer, inner) = (inner, outer);
            outer.reverse();
            inner.reverse();
        }
        for slope in slopes(&outer) {
            let corners = slope.iter();
            let corners = corners.map(|(p, off)| over(*p, self.top + off * pitch));
            to.flat(&[ROOF], &[corners.collect()]);
        }
        to.flat(&[ROOF], &[turned(&inner, self.top)]);
    }

    /// The strips of ground under the walls between gates, as places along the walls; true if a strip goes all around.
    fn strips(&self, gates: &[Vec<[f64; 2]>]) -> Vec<(Vec<Across>, bool)> {
        let mut strips: Vec<Vec<Across>> = vec![Vec::new()];
        for (wall, gates) in gates.iter().enumerate() {
            let plane = self.plane(wall);
            let across = |[front, back]: [f64; 2]| {
                [(front, 0.0), (back, self.thickness())]
                    .map(|(u, behind)| plane.at(DVec2::X * u, behind))
            };
            let mut add = |place: [f64; 2], is_first: bool| match strips.last_mut() {
                Some(strip) if !is_first => strip.push(across(place)),
                _ => strips.push(vec![across(place)]),
            };
            let [front, back] = self.spans(wall);
            add([front[0], back[0]], false);
            for &[left, right] in gates {
                add([left; 2], false);
                add([right; 2], true);
            }
            if self.line.turn(wall + 1).is_none() {
                add([front[1], back[1]], false);
            }
        }
        let is_ring = self.line.is_closed && strips.len() == 1;
        if self.line.is_closed && !is_ring {
            let first = strips.remove(0);
            strips
                .last_mut()
                .into_iter()
                .for_each(|last| last.extend(&first));
        }
        strips.into_iter().map(|strip| (strip, is_ring)).collect()
    }
}

/// The loops of a level face over a strip, counter-clockwise seen from above, the outer one first.
fn loops(strip: &[Across], is_ring: bool, y: f64) -> Vec<Vec<DVec3>> {
    let [front, back] = [0, 1].map(|k| strip.iter().map(move |across| across[k] + DVec3::Y * y));
    if !is_ring {
        return vec![front.chain(back.rev()).collect()];
    }
    let mut rings: Vec<Vec<DVec3>> = vec![front.collect(), back.rev().collect()];
    if polygon::across(&rings[0]).y < 0.0 {
        rings.swap(0, 1);
    }
    rings
}
