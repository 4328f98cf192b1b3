//! The limits of drawn plans, and their faults.

/// Corners are at most this far from the origin along each axis, in modules.
pub const FARTHEST_CORNER: i64 = 120;
/// Walls meet at least at this angle (degrees): in sharper corners, bricks of both walls would overlap.
pub const SHARPEST: f64 = 75.0;
/// The least length of a wall, a pier, and a part between two openings, in modules.
pub const LEAST_PIER: f64 = 2.0;
/// The fewest courses between an opening and the next one above it, or the top of the wall.
pub const LEAST_OVER: f64 = 4.0;

/// A fault of a plan. Corners, walls and openings are counted from 1. After a fault of the line other than
/// [`DrawnFault::Far`] and [`DrawnFault::Roofless`], the rule's own plan is built.
#[derive(Clone, Debug, PartialEq)]
pub enum DrawnFault {
    /// There are too few corners.
    Few {
        /// The number of corners.
        corners: usize,
        /// The least number of corners.
        least: usize,
    },
    /// One side of a wall is shorter than [`LEAST_PIER`].
    Short {
        /// The wall.
        wall: usize,
        /// The length of this side (modules).
        length: f64,
    },
    /// Two walls meet at an angle below [`SHARPEST`].
    Sharp {
        /// The corner.
        corner: usize,
        /// The angle (degrees).
        angle: f64,
    },
    /// Walls cross, touch, or are too near each other.
    Crossing {
        /// The place (modules).
        at: [f64; 2],
    },
    /// Corners were farther away than [`FARTHEST_CORNER`] and were moved to it.
    Far {
        /// The number of corners that were moved.
        corners: usize,
    },
    /// There should be a roof, but the plan is open, or its corners turn both ways.
    Roofless,
    /// An opening has a fault.
    Opening {
        /// The opening.
        opening: usize,
        /// The fault.
        why: OpeningFault,
    },
}

/// A fault of an opening. After [`OpeningFault::Number`] the opening is kept; after all other faults it is left out.
#[derive(Clone, Debug, PartialEq)]
pub enum OpeningFault {
    /// A number was moved into its range.
    Number {
        /// The number's place in the row, from 1.
        place: usize,
        /// Its least and its greatest value.
        range: [i64; 2],
        /// The given number and the kept one.
        moved: [i64; 2],
    },
    /// It names a wall that does not exist.
    NoWall {
        /// The number that it names.
        wall: i64,
        /// The number of walls.
        walls: usize,
    },
    /// It is too near to an end of its wall, or beyond it.
    Beyond {
        /// The wall.
        wall: usize,
        /// Where it begins and ends along the wall (modules).
        ends: [i64; 2],
        /// The least beginning and the greatest end that are allowed (modules).
        allowed: [i64; 2],
    },
    /// The wall has no room for it, wherever it begins.
    Full {
        /// The wall.
        wall: usize,
    },
    /// It is too near to an earlier opening, or overlaps it.
    Over {
        /// The earlier opening.
        other: usize,
    },
    /// Its top is less than [`LEAST_OVER`] below the top of its wall.
    High {
        /// The height of its top (courses).
        top: f64,
        /// The greatest height that is allowed (courses).
        most: f64,
    },
}
