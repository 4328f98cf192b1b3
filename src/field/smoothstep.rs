//! Smooth steps from 0 to 1.

/// A smooth step: 0 up to t = 0, 1 from t = 1 on, between them 3 t^2 - 2 t^3, with zero slope at
/// both ends.
pub(crate) fn smoothstep(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// `smoothstep` in single precision.
pub(crate) fn smoothstep_f32(t: f32) -> f32 {
    smoothstep(f64::from(t)) as f32
}
