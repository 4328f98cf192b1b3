//! Colours of drawings.

/// A colour as red, green, blue (sRGB) and opacity, each 0..=1.
pub type Colour = [f32; 4];

/// The background of a drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paper {
    /// The picture around the outline.
    pub surround: Colour,
    /// The area to be filled with cells.
    pub bed: Colour,
    /// The boundary.
    pub line: Colour,
}

/// Linear interpolation of colours: `a` at `t` = 0, `b` at 1.
pub fn blend(a: Colour, b: Colour, t: f32) -> Colour {
    let t = t.clamp(0.0, 1.0);
    std::array::from_fn(|k| a[k] + (b[k] - a[k]) * t)
}

/// A colour with its lightness multiplied by `factor` and the same opacity.
pub fn lit(colour: Colour, factor: f32) -> Colour {
    let [r, g, b, a] = colour;
    [r * factor, g * factor, b * factor, a]
}
