//! Colours of drawings.

/// A colour as red, green, blue (sRGB) and opacity, each 0..=1.
pub type Colour = [f32; 4];

/// What a drawing lies on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paper {
    /// The picture around the outline.
    pub surround: Colour,
    /// The area to be paved.
    pub bed: Colour,
    /// The boundary.
    pub line: Colour,
}

/// The colour a share `t` (0..=1) of the way from `a` to `b`.
pub fn blend(a: Colour, b: Colour, t: f32) -> Colour {
    let t = t.clamp(0.0, 1.0);
    std::array::from_fn(|k| a[k] + (b[k] - a[k]) * t)
}

/// A colour `factor` times as light, of the same opacity.
pub fn lit(colour: Colour, factor: f32) -> Colour {
    let [r, g, b, a] = colour;
    [r * factor, g * factor, b * factor, a]
}
