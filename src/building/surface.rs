//! The surfaces of faces in closed form (Legakis, Dorsey, Gortler 2001, Feature-based cellular texturing for
//! architectural models, section 3.2): combinations of flat and cylindrical regions, and sectors of disks.
//!
//! Places have three coordinates: s and t along the face, and z along its outward normal (metres). Behind the face,
//! in the wall, z is negative.

use super::path::Path;
use super::piece::{CircularArc, Piece};
use glam::DVec3;
use std::f64::consts::TAU;

/// A right-handed frame of unit vectors at a place: s, t and the normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceFrame {
    /// The place (metres).
    pub origin: DVec3,
    /// The direction in which s grows.
    pub s: DVec3,
    /// The direction in which t grows.
    pub t: DVec3,
    /// The outward normal, s x t.
    pub normal: DVec3,
}

/// Rounding moves a place by less than this (metres).
const ROUNDING: f64 = 1e-6;

/// A turn counts as whole if no more than this is missing (radians).
const WHOLE: f64 = 1e-6;

/// A plane profile of lines and arcs, swept along a direction.
///
/// One line makes a flat face, one arc a cylinder; a line, an arc and a line make both jambs and the intrados of an
/// arch in one face. s is the arc length along the profile, t the distance along the direction from the profile's
/// plane. The outward normal is the profile's tangent x the direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    profile: Path,
    direction: DVec3,
    /// The profile's start and tangent, and the normal, if it is a single line: flat faces need no more.
    line: Option<[DVec3; 3]>,
}

impl Sweep {
    /// A profile, in a plane normal to the unit vector `direction`.
    pub fn new(profile: Path, direction: DVec3) -> Self {
        let line = match profile.pieces() {
            [line @ Piece::Line { from, .. }] => {
                let tangent = line.tangent(0.0);
                Some([*from, tangent, tangent.cross(direction)])
            }
            _ => None,
        };
        Self {
            profile,
            direction,
            line,
        }
    }

    /// The profile.
    pub fn profile(&self) -> &Path {
        &self.profile
    }

    /// The unit vector along which t grows.
    pub fn direction(&self) -> DVec3 {
        self.direction
    }

    /// The circumference (metres) if the face is a whole cylinder: s and s + period are the same place.
    pub fn period(&self) -> Option<f64> {
        match self.profile.pieces() {
            [Piece::Arc(arc)] if (arc.to - arc.from).abs() > TAU - WHOLE => Some(TAU * arc.radius),
            _ => None,
        }
    }

    #[inline]
    fn frame(&self, s: f64, t: f64) -> SurfaceFrame {
        let (point, tangent, normal) = match self.line {
            Some([from, tangent, normal]) => (from + tangent * s, tangent, normal),
            None => {
                let tangent = self.profile.tangent(s);
                (
                    self.profile.point(s),
                    tangent,
                    tangent.cross(self.direction),
                )
            }
        };
        SurfaceFrame {
            origin: point + self.direction * t,
            s: tangent,
            t: self.direction,
            normal,
        }
    }

    fn project(&self, p: DVec3) -> DVec3 {
        let start = match self.line {
            Some([from, ..]) => from,
            None => self.profile.point(0.0),
        };
        let t = (p - start).dot(self.direction);
        let in_plane = p - self.direction * t;
        let s = match self.line {
            // Adding 0 turns -0 into 0, as the sum in `Path::project` does.
            Some([from, tangent, _]) => 0.0 + (in_plane - from).dot(tangent),
            None => self.profile.project(in_plane),
        };
        let frame = self.frame(s, 0.0);
        DVec3::new(s, t, (in_plane - frame.origin).dot(frame.normal))
    }
}

/// A sector of a disk, or a whole one.
///
/// t is the distance from the centre. s is the angle times the reference radius, so it is the arc length at that radius
/// alone. Angles grow clockwise seen from outside: then s, t and the normal are right-handed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disk {
    /// The circle at the reference radius; its y is x cross the normal.
    rim: CircularArc,
    normal: DVec3,
}

impl Disk {
    /// The sector from one angle to a greater one (radians), measured from the unit vector `zero` in the plane.
    /// `reference` is the radius at which s is the arc length (metres).
    pub fn new(
        centre: DVec3,
        normal: DVec3,
        zero: DVec3,
        reference: f64,
        [from, to]: [f64; 2],
    ) -> Self {
        let rim = CircularArc {
            centre,
            radius: reference,
            x: zero,
            y: zero.cross(normal),
            from,
            to,
        };
        Self { rim, normal }
    }

    /// The centre (metres).
    pub fn centre(&self) -> DVec3 {
        self.rim.centre
    }

    /// The unit outward normal.
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// The circle at the reference radius, with the angles of the sector.
    pub fn rim(&self) -> &CircularArc {
        &self.rim
    }

    /// The range of s (metres) of a whole disk: s and s + period are the same place.
    pub fn period(&self) -> Option<f64> {
        let is_whole = self.rim.to - self.rim.from > TAU - WHOLE;
        is_whole.then_some(TAU * self.rim.radius)
    }

    fn frame(&self, s: f64, t: f64) -> SurfaceFrame {
        let rim = Piece::Arc(self.rim);
        let outward = (rim.point(s) - self.rim.centre) / self.rim.radius;
        SurfaceFrame {
            origin: self.rim.centre + outward * t,
            s: rim.tangent(s),
            t: outward,
            normal: self.normal,
        }
    }

    fn project(&self, p: DVec3) -> DVec3 {
        let z = (p - self.rim.centre).dot(self.normal);
        let in_plane = p - self.normal * z;
        let t = in_plane.distance(self.rim.centre);
        DVec3::new(Piece::Arc(self.rim).nearest(in_plane), t, z)
    }
}

/// The surface of a face.
#[derive(Clone, Debug, PartialEq)]
pub enum FaceSurface {
    /// A plane profile swept along a direction.
    Sweep(Sweep),
    /// A sector of a disk.
    Disk(Disk),
}

impl FaceSurface {
    /// The flat face through a point, with unit vectors s and t at right angles.
    pub fn flat(origin: DVec3, s: DVec3, t: DVec3) -> Self {
        let line = Piece::Line {
            from: origin,
            to: origin + s,
        };
        Self::Sweep(Sweep::new(Path::new(vec![line]), t))
    }

    /// The frame at s and t, on the face.
    pub fn frame(&self, s: f64, t: f64) -> SurfaceFrame {
        match self {
            Self::Sweep(sweep) => sweep.frame(s, t),
            Self::Disk(disk) => disk.frame(s, t),
        }
    }

    /// The place at s, t and z, with the frame there (section 3.2, the mapping).
    pub fn map(&self, s: f64, t: f64, z: f64) -> SurfaceFrame {
        let frame = self.frame(s, t);
        SurfaceFrame {
            origin: frame.origin + frame.normal * z,
            ..frame
        }
    }

    /// The coordinates s, t and z of a place (section 3.2, the projection): the nearest piece of the profile counts,
    /// and the first and the last one go on beyond their ends. On a whole cylinder or disk s lies in one period.
    pub fn project(&self, p: DVec3) -> DVec3 {
        match self {
            Self::Sweep(sweep) => sweep.project(p),
            Self::Disk(disk) => disk.project(p),
        }
    }

    /// True if the face is a single plane and a place is certainly farther than `by` (metres) from it along its normal,
    /// whatever the rounding. False does not mean that the place is near.
    pub fn is_off(&self, p: DVec3, by: f64) -> bool {
        match self {
            Self::Sweep(Sweep {
                line: Some([from, _, normal]),
                ..
            }) => (p - *from).dot(*normal).abs() > by + ROUNDING,
            _ => false,
        }
    }

    /// The range of s (metres) of a whole cylinder or disk: s and s + period are the same place. `None` for other
    /// surfaces.
    pub fn period(&self) -> Option<f64> {
        match self {
            Self::Sweep(sweep) => sweep.period(),
            Self::Disk(disk) => disk.period(),
        }
    }

    /// Whether all normals are the same.
    pub fn is_flat(&self) -> bool {
        match self {
            Self::Sweep(sweep) => {
                let line = |piece: &Piece| matches!(piece, Piece::Line { .. });
                sweep.profile.pieces().iter().all(line)
            }
            Self::Disk(_) => true,
        }
    }
}
