//! Smooth steps from 0 to 1.

/// 0 up to 0, 1 from 1 on, with zero slope at both: 3 t^2 - 2 t^3.
pub(super) fn smoothstep(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// The same in single precision.
pub(crate) fn smoothstep_f32(t: f32) -> f32 {
    smoothstep(f64::from(t)) as f32
}
