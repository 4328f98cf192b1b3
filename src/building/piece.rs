//! A line or an arc of a circle in space, by arc length.

use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// An arc of a circle, from one angle to another.
///
/// The point at angle a is centre + radius (cos a x + sin a y), so a positive turn goes from x to y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircularArc {
    /// The centre (metres).
    pub centre: DVec3,
    /// The radius (metres), above 0.
    pub radius: f64,
    /// The unit vector towards angle 0.
    pub x: DVec3,
    /// The unit vector towards angle pi / 2, normal to `x`.
    pub y: DVec3,
    /// The angle of the start (radians).
    pub from: f64,
    /// The angle of the end (radians); below `from` if the arc runs the other way.
    pub to: f64,
}

impl CircularArc {
    /// The arc from a point, by an angle about an axis: counter-clockwise if the axis points at the viewer.
    pub fn about(centre: DVec3, axis: DVec3, start: DVec3, angle: f64) -> Self {
        let x = start - centre;
        let radius = x.length();
        let x = x / radius;
        Self {
            centre,
            radius,
            x,
            y: axis.cross(x),
            from: 0.0,
            to: angle,
        }
    }

    /// +1 if the angle grows from start to end, else -1.
    pub fn sense(&self) -> f64 {
        (self.to - self.from).signum()
    }

    /// The length (metres).
    pub fn length(&self) -> f64 {
        self.radius * (self.to - self.from).abs()
    }

    /// The unit vector from the centre at an angle.
    fn outward(&self, angle: f64) -> DVec3 {
        let (sin, cos) = libm::sincos(angle);
        self.x * cos + self.y * sin
    }

    /// The angle of a point (radians), within half a turn of the arc's middle.
    pub fn angle(&self, p: DVec3) -> f64 {
        let d = p - self.centre;
        let raw = libm::atan2(d.dot(self.y), d.dot(self.x));
        let middle = 0.5 * (self.from + self.to);
        let turns = ((raw - middle + PI) / TAU).floor();
        raw - TAU * turns
    }
}

/// A line or an arc of a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// A straight line between two points (metres).
    Line {
        /// The start.
        from: DVec3,
        /// The end.
        to: DVec3,
    },
    /// An arc.
    Arc(CircularArc),
}

impl Piece {
    /// The length (metres).
    pub fn length(&self) -> f64 {
        match self {
            Self::Line { from, to } => from.distance(*to),
            Self::Arc(arc) => arc.length(),
        }
    }

    /// The point at an arc length from the start (metres). Lengths outside of the piece go on along it.
    pub fn point(&self, s: f64) -> DVec3 {
        match self {
            Self::Line { from, .. } => *from + self.tangent(s) * s,
            Self::Arc(arc) => {
                let angle = arc.from + arc.sense() * s / arc.radius;
                arc.centre + arc.outward(angle) * arc.radius
            }
        }
    }

    /// The unit tangent at an arc length from the start.
    pub fn tangent(&self, s: f64) -> DVec3 {
        match self {
            Self::Line { from, to } => (*to - *from).normalize_or_zero(),
            Self::Arc(arc) => {
                let angle = arc.from + arc.sense() * s / arc.radius;
                let (sin, cos) = libm::sincos(angle);
                (arc.y * cos - arc.x * sin) * arc.sense()
            }
        }
    }

    /// The arc length of the nearest point of the line or circle that the piece is part of; it may lie outside of the
    /// piece. On a circle, places a whole turn apart are the same; the one nearest to the piece's middle is taken.
    pub fn nearest(&self, p: DVec3) -> f64 {
        match self {
            Self::Line { from, .. } => (p - *from).dot(self.tangent(0.0)),
            Self::Arc(arc) => (arc.angle(p) - arc.from) * arc.sense() * arc.radius,
        }
    }

    /// The piece walked the other way.
    pub fn reversed(&self) -> Self {
        match *self {
            Self::Line { from, to } => Self::Line { from: to, to: from },
            Self::Arc(arc) => Self::Arc(CircularArc {
                from: arc.to,
                to: arc.from,
                ..arc
            }),
        }
    }
}
