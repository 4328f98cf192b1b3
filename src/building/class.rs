//! How faces meet along edges, and classes of corners (Legakis, Dorsey, Gortler 2001, section 5.5): the valence, the
//! number of convex and concave edges, and the direction of a single convex or concave one.

use glam::DVec3;

/// How two faces meet along an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Bend {
    /// The solid fills less than half a turn.
    Convex,
    /// The solid fills more than half a turn.
    Concave,
    /// The faces are tangent to each other, within a degree.
    Smooth,
    /// There is one face only.
    Open,
}

/// The direction in which an edge leaves a corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Heading {
    /// Its largest component is upwards.
    Up,
    /// Its largest component is downwards.
    Down,
    /// Its largest component is level.
    Level,
}

impl Heading {
    /// The direction of a vector. Equal components count as level.
    pub fn of(way: DVec3) -> Self {
        let level = way.x.abs().max(way.z.abs());
        if way.y > level {
            Self::Up
        } else if way.y < -level {
            Self::Down
        } else {
            Self::Level
        }
    }
}

/// The class of a corner.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct CornerClass {
    /// The number of edges.
    pub valence: usize,
    /// The number of convex edges.
    pub convex: usize,
    /// The number of concave edges.
    pub concave: usize,
    /// The direction in which the convex edge leaves, if there is exactly one.
    pub single_convex: Option<Heading>,
    /// The direction in which the concave edge leaves, if there is exactly one.
    pub single_concave: Option<Heading>,
}

impl CornerClass {
    /// The class of a corner whose edges bend like this and leave in these directions.
    pub fn new(edges: &[(Bend, DVec3)]) -> Self {
        let of = |bend: Bend| edges.iter().filter(move |edge| edge.0 == bend);
        let single = |bend: Bend| {
            let mut all = of(bend);
            let first = all.next()?;
            all.next().is_none().then(|| Heading::of(first.1))
        };
        Self {
            valence: edges.len(),
            convex: of(Bend::Convex).count(),
            concave: of(Bend::Concave).count(),
            single_convex: single(Bend::Convex),
            single_concave: single(Bend::Concave),
        }
    }
}
