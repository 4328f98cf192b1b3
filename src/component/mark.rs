//! Marks of vertices: which part of a component they belong to.

/// A part of a component that may have a colour of its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// The surface that belongs to no other part.
    #[default]
    Body,
    /// The pale base of a chestnut, the band of a ball.
    Cap,
    /// An end: the germ of a rice grain, the tips of a cashew, the tuft of a chestnut.
    Tip,
    /// The midrib and the side veins of a leaf, a vein of quartz in a pebble, the scar of a bean.
    Vein,
    /// The thread of a bolt or of a nut.
    Thread,
    /// Rounded or chamfered edges, and the rim of a scar.
    Edge,
    /// The stalk of a fruit or of a leaf.
    Stalk,
}

impl Part {
    /// All parts.
    pub const ALL: [Self; 7] = [
        Self::Body,
        Self::Cap,
        Self::Tip,
        Self::Vein,
        Self::Thread,
        Self::Edge,
        Self::Stalk,
    ];
}

/// The mark of a vertex. It belongs to the component, so colours that depend on it move with the body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mark {
    /// The part.
    pub part: Part,
    /// The share of the part's colour, 0 to 1; the body's colour has the rest.
    pub share: f32,
    /// How much lighter or darker the surface is here, -1 to 1: bands, streaks, and hollows.
    pub shade: f32,
}

impl Mark {
    /// The body, without bands.
    pub const BODY: Self = Self::of(Part::Body);

    /// Nothing but this part.
    pub const fn of(part: Part) -> Self {
        Self {
            part,
            share: 1.0,
            shade: 0.0,
        }
    }

    /// The mark with another share of the part, clamped to 0..1.
    pub(super) fn shared(self, share: f64) -> Self {
        let share = share.clamp(0.0, 1.0) as f32;
        Self { share, ..self }
    }

    /// The mark with another shade, clamped to -1..1.
    pub(super) fn shaded(self, shade: f64) -> Self {
        let shade = shade.clamp(-1.0, 1.0) as f32;
        Self { shade, ..self }
    }

    /// The weighted mean of marks. Its part is the one with the greatest share; the body does not count.
    pub(super) fn mean<'a>(marks: impl Iterator<Item = (&'a Self, f64)>) -> Self {
        let (mut total, mut shade) = (0.0, 0.0);
        let mut shares = [0.0; Part::ALL.len()];
        for (mark, weight) in marks {
            total += weight;
            shade += weight * f64::from(mark.shade);
            shares[mark.part as usize] += weight * f64::from(mark.share);
        }
        let most = |best: Part, part: Part| match shares[part as usize] > shares[best as usize] {
            true => part,
            false => best,
        };
        let part = Part::ALL[1..].iter().copied().fold(Part::Cap, most);
        let share = shares[part as usize] / total;
        let mark = match share > 0.0 {
            true => Self::of(part).shared(share),
            false => Self::BODY,
        };
        mark.shaded(shade / total)
    }
}
