//! The lamp's visible part in the penumbra.

/// Half the width of the penumbra, in picture units of height.
const SOFT: f32 = 0.22;

/// A height where there is no shadow. It is not the lowest number, so that sums and products stay finite.
pub(super) const NOWHERE: f32 = -1e30;

/// The visible part of the lamp at a surface of this height, 255 for all. `dark` is the shadow height of the
/// lamp's upper rim, `lit` that of the lower rim, above which the surface is fully lit.
#[inline(always)]
pub(super) fn visible(height: f32, dark: f32, lit: f32) -> u8 {
    let part = (height - dark + SOFT) / (lit - dark + 2.0 * SOFT);
    let part = part.clamp(0.0, 1.0);
    (255.0 * part * part * (3.0 - 2.0 * part) + 0.5) as i32 as u8
}
