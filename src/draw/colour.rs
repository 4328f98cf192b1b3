//! Colours of drawings.

/// A colour as red, green, blue (sRGB) and opacity, each 0..=1.
pub type Tint = [f32; 4];

/// What a drawing lies on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paper {
    /// The picture around the outline.
    pub surround: Tint,
    /// The area to be paved.
    pub bed: Tint,
    /// The boundary.
    pub line: Tint,
}

/// The colour a share `t` (0..=1) of the way from `a` to `b`.
#[inline(never)]
pub fn blend(a: Tint, b: Tint, t: f32) -> Tint {
    let t = t.clamp(0.0, 1.0);
    std::array::from_fn(|k| a[k] + (b[k] - a[k]) * t)
}

/// A colour `factor` times as light, of the same opacity.
pub fn lit(tint: Tint, factor: f32) -> Tint {
    let [r, g, b, a] = tint;
    [r * factor, g * factor, b * factor, a]
}
