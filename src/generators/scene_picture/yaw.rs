//! A model turned about its upright axis. Instead of the bodies, camera and light are turned the other way.

use crate::generators::lighting::LightParams;
use crate::light::Light;
use crate::scene::{Camera, Cut};
use glam::Vec3;

/// The place (x, z) turned clockwise by `degrees`, seen from above.
pub(super) fn clockwise([x, z]: [f64; 2], degrees: f64) -> [f64; 2] {
    let angle = degrees.to_radians();
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    [x * cos - z * sin, x * sin + z * cos]
}

/// The camera that sees the model as `camera` sees it turned by `yaw` degrees.
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

/// The plane that cuts the model as `cut` cuts it turned by `yaw` degrees.
pub(super) fn turned_cut(cut: Cut, yaw: f64) -> Cut {
    let [x, y, z] = cut.normal.to_array();
    let [x, z] = clockwise([x, z].map(f64::from), -yaw);
    Cut {
        normal: Vec3::new(x as f32, y, z as f32),
        ..cut
    }
}

/// The light that falls on the model as `light` falls on it turned by `yaw` degrees.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_model_turned_is_a_viewer_turned() {
        let camera = Camera {
            angle: 20.0,
            target: [0.3, 0.1, -0.2],
            ..Camera::default()
        };
        assert_eq!(turned(camera, 0.0), camera);
        let quarter = turned(camera, 90.0);
        assert_eq!(quarter.angle, -70.0);
        // Seen from above, x points to the right and z down, so clockwise is from x to z.
        let wanted = [-0.2, 0.1, -0.3];
        let off = quarter
            .target
            .iter()
            .zip(wanted)
            .map(|(a, b)| (a - b).abs());
        assert!(off.sum::<f64>() < 1e-9, "{:?}", quarter.target);
    }
}
