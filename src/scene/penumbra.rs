//! Soft edges of shadows on the floor (Fernando 2005, Percentage-Closer Soft Shadows). The samples of a frame place the
//! lamp at a few points of its disc, so the edge of a shadow far from its body would show one step for each sample. Each
//! sample therefore lights the floor by the part of the disc around its place.

use super::Lighting;
use glam::Vec3;

/// Offsets on the unit circle: at these places around a point, bodies that hide the lamp are looked for.
const AROUND: [[f32; 2]; 6] = [
    [1.0, 0.0],
    [0.5, 0.866_025],
    [-0.5, 0.866_025],
    [-1.0, 0.0],
    [-0.5, -0.866_025],
    [0.5, -0.866_025],
];

/// Places on the unit disc that stand for a sample's part of the lamp. Number k of 8 has the radius sqrt((k + 1/2) / 8)
/// and the angle of k golden sections of a turn.
const PART: [[f32; 2]; 8] = [
    [0.25, 0.0],
    [-0.319_290, 0.292_496],
    [0.048_872, -0.556_877],
    [0.402_444, 0.524_918],
    [-0.738_535, -0.130_636],
    [0.699_605, -0.445_031],
    [-0.234_004, 0.870_484],
    [-0.446_271, -0.859_268],
];

/// The visible share of a part of the lamp at a point of the floor, 0..1. `wide` is the radius of that part over its
/// distance; no body is farther from the point than `reach`.
pub(super) fn visible(light: &Lighting, point: Vec3, wide: f32, reach: f32) -> f32 {
    let (to, _) = light.lamp().from(point);
    let across = to.any_orthonormal_vector();
    let axes = [across, to.cross(across)];
    let beside = |[x, y]: [f32; 2], radius: f32| point + (axes[0] * x + axes[1] * y) * radius;
    let (mut blockers, mut sum) = (0, 0.0);
    let places = AROUND.map(|place| beside(place, wide * reach));
    for place in places.into_iter().chain([point]) {
        if let Some(away) = light.blocker(place) {
            (blockers, sum) = (blockers + 1, sum + away);
        }
    }
    if blockers == 0 {
        return 1.0;
    }
    let radius = wide * sum / blockers as f32;
    let seen = PART.map(|place| light.visible_along(beside(place, radius), to));
    seen.into_iter().sum::<f32>() * (1.0 / PART.len() as f32)
}
