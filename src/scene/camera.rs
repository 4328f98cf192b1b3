//! The camera, and the projection of points onto the screen.
//!
//! The world is right-handed with y up. The camera orbits its target. Its angle counts clockwise seen from
//! above; at 0 the viewer stands at large z and looks along -z, with x to the right.

use crate::notice::{Code, Notice, quote};
use crate::order::{greater, lesser};
use glam::{DVec3, Vec3};

/// A viewer who looks at a target. It is a view of a scene and not a part of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Direction of the viewer from the target: degrees, 0..360.
    pub angle: f64,
    /// Elevation: degrees above the horizon, -90..90.
    pub height: f64,
    /// Distance from the target, in units of the scene: 0.05..20.
    pub distance: f64,
    /// The angle of view along the shorter side of the frame: degrees, 5..100.
    pub lens: f64,
    /// The point at the centre of the frame, each coordinate -2..2 units of the scene.
    pub target: [f64; 3],
}

/// The camera's numbers by name, in order, each with its least and greatest value.
pub const LIMITS: [(&str, f64, f64); 7] = [
    ("angle", 0.0, 360.0),
    ("height", -90.0, 90.0),
    ("distance", 0.05, 20.0),
    ("lens", 5.0, 100.0),
    ("x", -2.0, 2.0),
    ("y", -2.0, 2.0),
    ("z", -2.0, 2.0),
];

/// Near limit of the view, relative to the distance to the target.
const NEAR: f64 = 0.01;

impl Default for Camera {
    /// Slightly from the left, as one looks at a floor: a square with side 1 fits in the frame.
    fn default() -> Self {
        Self {
            angle: 330.0,
            height: 40.0,
            distance: 2.95,
            lens: 28.0,
            target: [0.0; 3],
        }
    }
}

impl Camera {
    /// Reads numbers separated by commas: angle, height, distance, lens, and the target's x, y and z. Missing
    /// numbers at the end, and texts that are not numbers, keep the values of `self`; numbers outside their
    /// limits are clamped. Faults give notices.
    pub fn read(self, text: &str) -> (Self, Vec<Notice>) {
        let mut numbers = self.numbers();
        let mut notices = Vec::new();
        let words: Vec<&str> = match text.trim() {
            "" => Vec::new(),
            text => text.split(',').collect(),
        };
        for (k, word) in words.iter().enumerate() {
            let Some(&(name, least, most)) = LIMITS.get(k) else {
                notices.push(Notice::new(Code::CameraNumbers).with("n", words.len()));
                break;
            };
            let number: Option<f64> = word.trim().parse().ok().filter(|n: &f64| n.is_finite());
            let kept = match number {
                Some(number) if k == 0 => turned(number),
                Some(number) => number.clamp(least, most),
                None => numbers[k],
            };
            if number.is_none_or(|number| k > 0 && number != kept) {
                let notice = Notice::new(Code::CameraNumber)
                    .with("name", name.to_owned())
                    .with("given", quote(word))
                    .with("least", least.to_string())
                    .with("most", most.to_string());
                notices.push(notice.with("kept", kept.to_string()));
            }
            numbers[k] = kept;
        }
        (Self::of_numbers(numbers), notices)
    }

    /// The numbers, in the order of [`LIMITS`].
    pub fn numbers(&self) -> [f64; 7] {
        let [x, y, z] = self.target;
        [self.angle, self.height, self.distance, self.lens, x, y, z]
    }

    fn of_numbers([angle, height, distance, lens, x, y, z]: [f64; 7]) -> Self {
        Self {
            angle,
            height,
            distance,
            lens,
            target: [x, y, z],
        }
    }

    /// The view into a frame with this many pixels, at least 1 each.
    pub fn view(&self, width: usize, height: usize) -> View {
        let (angle, rise) = (self.angle.to_radians(), self.height.to_radians());
        let flat = libm::cos(rise);
        let back = DVec3::new(
            -libm::sin(angle) * flat,
            libm::sin(rise),
            libm::cos(angle) * flat,
        );
        // Depends on the angle only, so it is defined also if the camera looks straight down.
        let right = DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
        let eye = DVec3::from(self.target) + back * self.distance;
        let half = 0.5 * width.min(height) as f64;
        let focal = half / libm::tan(0.5 * self.lens.to_radians());
        View {
            eye: eye.as_vec3(),
            right: right.as_vec3(),
            up: back.cross(right).as_vec3(),
            ahead: (-back).as_vec3(),
            focal: focal as f32,
            slope: (1.0 / focal) as f32,
            near: (NEAR * self.distance) as f32,
            middle: [0.5 * width as f32, 0.5 * height as f32],
            size: [width, height],
        }
    }
}

/// An angle reduced to 0..360 degrees.
fn turned(angle: f64) -> f64 {
    let turns = libm::floor(angle / 360.0);
    let left = angle - 360.0 * turns;
    if (0.0..360.0).contains(&left) {
        left
    } else {
        0.0
    }
}

/// A camera and a frame: a perspective projection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The position of the eye.
    pub eye: Vec3,
    /// Unit vector to the right in the frame; `up` points up in it and `ahead` into it.
    pub right: Vec3,
    /// See [`View::right`].
    pub up: Vec3,
    /// See [`View::right`].
    pub ahead: Vec3,
    /// Focal length in pixels: the width of one unit at depth 1.
    pub focal: f32,
    /// Width of a pixel at depth 1, in units: the inverse of [`View::focal`].
    pub slope: f32,
    /// Smallest visible depth.
    pub near: f32,
    /// The pixel coordinates of the frame's centre.
    pub middle: [f32; 2],
    /// Width and height in pixels.
    pub size: [usize; 2],
}

impl View {
    /// A point in view coordinates: to the right, up, and depth, in units of the scene.
    #[inline(always)]
    pub fn of(&self, p: Vec3) -> Vec3 {
        let d = p - self.eye;
        Vec3::new(d.dot(self.right), d.dot(self.up), d.dot(self.ahead))
    }

    /// The pixel coordinates (y down) of a point from [`View::of`], and the inverse of its depth, which must
    /// not be 0.
    #[inline(always)]
    pub fn on_screen(&self, seen: Vec3) -> [f32; 3] {
        let inverse = 1.0 / seen.z;
        let scale = self.focal * inverse;
        [
            self.middle[0] + seen.x * scale,
            self.middle[1] - seen.y * scale,
            inverse,
        ]
    }

    /// The direction from the eye through a point of the frame, with depth 1 (not a unit vector).
    #[inline(always)]
    pub fn ray(&self, x: f32, y: f32) -> Vec3 {
        let across = (x - self.middle[0]) * self.slope;
        let down = (y - self.middle[1]) * self.slope;
        self.ahead + self.right * across - self.up * down
    }

    /// The width of a ball in pixels; infinite if the eye may be inside it, 0 if it is wholly behind.
    pub fn diameter(&self, seen: Vec3, radius: f32) -> f32 {
        if seen.z <= -radius {
            return 0.0;
        }
        if seen.z <= radius + self.near {
            return f32::INFINITY;
        }
        2.0 * radius * self.focal / seen.z
    }

    /// Whether any part of a ball may be in the frame; `seen` is the ball's centre from [`View::of`].
    pub fn may_see(&self, seen: Vec3, radius: f32) -> bool {
        if seen.z < self.near - radius {
            return false;
        }
        // Distances from the four planes through the eye and the frame's sides.
        let [width, height] = self.size.map(|n| n as f32);
        let beyond = |along: f32, from: f32, to: f32| {
            let norm = |slope: f32| (1.0 + slope * slope).sqrt();
            let (low, high) = (from / self.focal, to / self.focal);
            greater(
                (low * seen.z - along) / norm(low),
                (along - high * seen.z) / norm(high),
            )
        };
        let across = beyond(seen.x, -self.middle[0], width - self.middle[0]);
        let down = beyond(-seen.y, -self.middle[1], height - self.middle[1]);
        lesser(greater(across, down), f32::MAX) <= radius
    }

    /// The same view from a place beside the eye, to the right and up, in units of the scene. Places at the
    /// depth `focus` stay where they are in the frame.
    pub fn beside(self, [right, up]: [f32; 2], focus: f32) -> Self {
        let shift = self.focal / focus;
        let eye = self.eye + self.right * right + self.up * up;
        Self { eye, ..self }.moved([right * shift, -up * shift])
    }

    /// The same view with the frame shifted by a fraction of a pixel.
    pub fn moved(mut self, [x, y]: [f32; 2]) -> Self {
        self.middle = [self.middle[0] + x, self.middle[1] + y];
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_view_is_right_handed_and_rays_meet_their_points() {
        for angle in [0.0, 90.0, 200.0] {
            for height in [-90.0, 0.0, 38.0, 90.0] {
                let camera = Camera {
                    angle,
                    height,
                    ..Camera::default()
                };
                let view = camera.view(640, 480);
                assert!((view.right.cross(view.up) + view.ahead).length() < 1e-6);
                let p = Vec3::new(0.2, -0.1, 0.3);
                let [x, y, inverse] = view.on_screen(view.of(p));
                let back = view.eye + view.ray(x, y) / inverse;
                assert!((back - p).length() < 1e-5, "{back}");
            }
        }
        // At an angle of 90 degrees the camera stands at the left and looks to the right.
        let left = Camera {
            angle: 90.0,
            height: 0.0,
            ..Camera::default()
        };
        assert!(left.view(10, 10).ahead.x > 0.999);
    }

    #[test]
    fn what_is_in_focus_stays_in_its_place() {
        let view = Camera::default().view(640, 480);
        let beside = view.beside([0.1, -0.2], 2.0);
        let place = |depth: f32| view.eye + view.ray(200.0, 300.0) * depth;
        let seen = |depth: f32| beside.on_screen(beside.of(place(depth)));
        let [x, y, _] = seen(2.0);
        assert!(
            (x - 200.0).abs() < 0.01 && (y - 300.0).abs() < 0.01,
            "{x} {y}"
        );
        // Places nearer than the focus move opposite to the eye.
        let [x, y, _] = seen(1.0);
        assert!(x < 180.0 && y < 260.0, "{x} {y}");
    }

    #[test]
    fn words_are_read_and_mended() {
        let base = Camera::default();
        assert_eq!(base.read(""), (base, Vec::new()));
        let (camera, notices) = base.read("-30, 20");
        assert_eq!((camera.angle, camera.height), (330.0, 20.0));
        assert_eq!((camera.distance, notices.len()), (base.distance, 0));
        let (camera, notices) = base.read("nan,95,none,0.1,1,2,3,4");
        assert_eq!((camera.angle, camera.height), (base.angle, 90.0));
        assert_eq!((camera.lens, camera.target), (5.0, [1.0, 2.0, 2.0]));
        assert_eq!(notices.len(), 6);
    }
}
