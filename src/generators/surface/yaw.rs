//! A model that is turned about its upright axis: viewer and light go round it the other way, so bodies stay as they are.

use crate::generators::height_field::LightParams;
use crate::light::Light;
use crate::scene::Camera;

/// Clockwise seen from above, by degrees.
pub(super) fn clockwise([x, z]: [f64; 2], degrees: f64) -> [f64; 2] {
    let angle = degrees.to_radians();
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    [x * cos - z * sin, x * sin + z * cos]
}

/// The camera that sees the model as `camera` does where it is turned by `yaw`.
pub(super) fn turned(camera: Camera, yaw: f64) -> Camera {
    if yaw == 0.0 {
        return camera;
    }
    let [x, y, z] = camera.target;
    let [x, z] = clockwise([x, z], -yaw);
    Camera {
        angle: camera.angle - yaw,
        target: [x, y, z],
        ..camera
    }
}

/// The light that falls on the model as `light` does where it is turned by `yaw`.
pub(super) fn seen_by(light: &LightParams, yaw: f64) -> LightParams {
    let mut light = light.clone();
    light.shade.light = match light.shade.light {
        _ if yaw == 0.0 => return light,
        Light::Parallel { azimuth, elevation } => Light::Parallel {
            azimuth: azimuth - yaw.to_radians(),
            elevation,
        },
        Light::Point { x, y, z } => {
            let [x, y] = clockwise([x - 0.5, y - 0.5], -yaw);
            Light::Point {
                x: x + 0.5,
                y: y + 0.5,
                z,
            }
        }
    };
    light
}
