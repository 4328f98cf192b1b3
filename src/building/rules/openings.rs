//! Walls with openings, and the reveals of the openings.

use super::Module;
use super::drafting::Drafting;
use super::panes;
use super::wall_plane::WallPlane;
use crate::building::facets;
use crate::building::labels::{ARCH, DOOR, GLASS, SILL, WINDOW};
use crate::building::path::Path;
use crate::building::piece::{CircularArc, Piece};
use crate::building::surface::{FaceSurface, Sweep};
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// The head of an opening.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpeningHead {
    /// A level lintel.
    Straight,
    /// An arc of less than half a circle.
    Segmental,
    /// Half a circle.
    Round,
}

impl OpeningHead {
    /// The head with this number: 0 straight, 1 segmental, 2 round.
    pub(super) fn of(number: f64) -> Self {
        match number as u32 {
            0 => Self::Straight,
            1 => Self::Segmental,
            _ => Self::Round,
        }
    }
}

/// The rise of a segmental head as a share of its span.
const RISE: f64 = 1.0 / 6.0;
/// How far a pane stands in front of the back of its opening (metres).
const BEFORE: f64 = 0.002;

/// An opening in a wall, counted in modules from the wall's left end and in courses from the ground.
#[derive(Clone, Copy, Debug)]
pub(super) struct Opening {
    pub left: f64,
    pub width: f64,
    pub bottom: f64,
    /// The course at which the head begins.
    pub springing: f64,
    pub head: OpeningHead,
    pub is_door: bool,
}

/// The outline of an opening: lower left, upper left, upper right, lower right; clockwise seen from outside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reveal {
    corners: [DVec2; 4],
    /// The centre of the head's circle; `None` if the head is straight.
    centre: Option<DVec2>,
    head: OpeningHead,
    /// The labels of its faces; curved faces have [`ARCH`] as well, and the sill has [`SILL`].
    labels: &'static [&'static str],
}

impl Opening {
    /// The height of its top (courses).
    pub fn top(&self, module: &Module) -> f64 {
        let rise = match self.head {
            OpeningHead::Straight => 0.0,
            OpeningHead::Segmental => RISE,
            OpeningHead::Round => 0.5,
        };
        self.springing + rise * (self.width * module.half + module.joint) / module.course
    }

    /// Its outline in a wall's plane: an opening of n modules is a joint wider than that.
    pub fn reveal(&self, module: &Module) -> Reveal {
        let half = 0.5 * module.joint;
        let left = self.left * module.half - half;
        let right = (self.left + self.width) * module.half + half;
        let bottom = (self.bottom * module.course - module.joint).max(0.0);
        let top = self.springing * module.course;
        let corners = [(left, bottom), (left, top), (right, top), (right, bottom)];
        let (span, middle) = (right - left, 0.5 * (left + right));
        let drop = match self.head {
            OpeningHead::Straight => None,
            OpeningHead::Segmental => Some(span * (0.125 / RISE - 0.5 * RISE)),
            OpeningHead::Round => Some(0.0),
        };
        Reveal {
            corners: corners.map(DVec2::from),
            centre: drop.map(|drop| DVec2::new(middle, top - drop)),
            head: self.head,
            labels: match self.is_door {
                true => &[DOOR],
                false => &[WINDOW],
            },
        }
    }
}

impl Reveal {
    /// Its corners, clockwise from the lower left one.
    pub fn corners(&self) -> [DVec2; 4] {
        self.corners
    }

    /// u of its left and its right side (metres).
    pub fn sides(&self) -> [f64; 2] {
        [self.corners[0].x, self.corners[3].x]
    }

    /// The loop of the hole, `behind` metres behind the wall's face.
    pub fn hole(&self, plane: &WallPlane, behind: f64) -> Vec<DVec3> {
        self.corners.map(|p| plane.at(p, behind)).to_vec()
    }

    /// Declares the arc of the head, if it has one, `behind` metres behind the wall's face.
    pub fn declare(&self, to: &mut Drafting, plane: &WallPlane, behind: f64) {
        if let Some(centre) = self.centre {
            let [_, from, end, _] = self.corners.map(|p| plane.at(p, behind));
            to.arc(from, end, plane.at(centre, behind), -plane.normal);
        }
    }

    /// Adds the faces of the reveal from the wall's face inwards. If `sill` is false, the opening reaches the ground
    /// and has no sill.
    pub fn faces(&self, to: &mut Drafting, plane: &WallPlane, depth: f64, sill: bool) {
        let [bl, tl, tr, br] = self.corners.map(|p| plane.at(p, 0.0));
        let [bl2, tl2, tr2, br2] = self.corners.map(|p| plane.at(p, depth));
        self.declare(to, plane, 0.0);
        self.declare(to, plane, depth);
        let labels = self.labels;
        let curved = [&[ARCH], labels].concat();
        if sill {
            let labels = [labels, &[SILL]].concat();
            to.flat(&labels, &[vec![bl, br, br2, bl2]]);
        }
        let bow = self.bow(plane);
        let through = |pieces: Vec<Piece>| {
            let sweep = Sweep::new(Path::new(pieces), -plane.normal);
            FaceSurface::Sweep(sweep)
        };
        let line = |from, to| Piece::Line { from, to };
        if let (OpeningHead::Round, Some(bow)) = (self.head, bow) {
            let profile = vec![line(br, tr), bow, line(tl, bl)];
            let ring = vec![br, tr, tl, bl, bl2, tl2, tr2, br2];
            to.face(&curved, through(profile), &[ring]);
            return;
        }
        to.flat(labels, &[vec![tl, bl, bl2, tl2]]);
        to.flat(labels, &[vec![br, tr, tr2, br2]]);
        let ring = vec![tr, tl, tl2, tr2];
        match bow {
            Some(bow) => to.face(&curved, through(vec![bow]), &[ring]),
            None => to.flat(labels, &[ring]),
        }
    }

    /// The arc of the head at the wall's face, from right to left.
    fn bow(&self, plane: &WallPlane) -> Option<Piece> {
        let centre = self.centre?;
        let span = self.corners[2] - self.corners[1];
        let d = self.corners[2] - centre;
        let angle = match self.head {
            OpeningHead::Round => PI,
            _ => 2.0 * libm::atan2(0.5 * span.x, d.y),
        };
        let start = plane.at(self.corners[2], 0.0);
        let arc = CircularArc::about(plane.at(centre, 0.0), plane.normal, start, angle);
        Some(Piece::Arc(arc))
    }

    /// Closes the opening at a depth with a face of glass, and puts a pane or a door in front of it.
    pub fn close(&self, to: &mut Drafting, plane: &WallPlane, depth: f64) {
        let mut back = self.hole(plane, depth);
        back.reverse();
        to.flat(&[GLASS], &[back]);
        self.pane(to, plane, depth - BEFORE);
    }

    /// Adds a pane or a door at a depth.
    pub fn pane(&self, to: &mut Drafting, plane: &WallPlane, depth: f64) {
        let [bl, tl, tr, br] = self.corners;
        let mut outline = vec![bl, tl];
        if let Some(Piece::Arc(arc)) = self.bow(plane) {
            let flat = |p: DVec3| DVec2::new((p - plane.origin).dot(plane.along), p.y);
            let head = facets::cuts(&arc).into_iter().rev();
            outline.extend(head.map(|s| flat(Piece::Arc(arc).point(s))));
        }
        outline.extend([tr, br]);
        match self.labels {
            [DOOR] => panes::door(to, (plane, depth), &outline),
            _ => panes::window(to, (plane, depth), &outline),
        }
    }
}

/// Adds a wall's face with openings, their reveals, and what closes them. `outline` is counter-clockwise in the wall's
/// plane.
pub(super) fn wall_face(
    to: &mut Drafting,
    plane: &WallPlane,
    outline: &[DVec2],
    openings: &[Opening],
    (module, depth): (&Module, f64),
) {
    let mut loops = vec![outline.iter().map(|&p| plane.at(p, 0.0)).collect()];
    for opening in openings {
        let reveal = opening.reveal(module);
        loops.push(reveal.hole(plane, 0.0));
        reveal.faces(to, plane, depth, true);
        reveal.close(to, plane, depth);
    }
    to.flat(&[], &loops);
}

/// As many windows as fit, up to `most`, evenly spread over a wall of `length` modules. There are at least three modules
/// between openings and at both ends.
pub(super) fn spread(length: f64, most: f64, window: &Opening) -> Vec<Opening> {
    let fit = ((length - 3.0) / (window.width + 3.0)).floor();
    let count = most.min(fit).max(0.0);
    let gap = (length - count * window.width) / (count + 1.0);
    let opening = |k: u32| Opening {
        left: (gap + f64::from(k) * (gap + window.width)).round(),
        ..*window
    };
    (0..count as u32).map(opening).collect()
}
