//! The map from a model to its scene.

use crate::order::{greater, lesser};
use crate::scene::Camera;
use crate::trimesh::TriMesh;
use glam::{DVec3, Vec3};

/// The factor on the bounding box' diagonal when it is compared with the sides: a box that is wide, deep and high
/// fits into the picture, too.
const DEEP: f64 = 0.78;
/// Bands of heights into which a model is divided.
const BANDS: usize = 32;
/// Halvings of the interval in which the height of the middle is searched. The interval is about as long as the model is
/// high and wide.
const HALVINGS: usize = 40;

/// The map from the model to the scene: the scene's origin is at the middle of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// The place of the scene's origin in the model.
    pub middle: DVec3,
    /// Scene units in a unit of the model.
    pub scale: f64,
}

/// A level circle around the upright axis of a model, on which a part of the model moves while the model turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rim {
    /// Distance from the axis, in units of the model, at least 0.
    pub radius: f64,
    /// The y of the circle.
    pub height: f64,
    /// The part of the half picture, from its middle to its side, that the circle may take: 0..1.
    pub share: f64,
}

impl Default for Fit {
    /// The scene is the model itself.
    fn default() -> Self {
        Self {
            middle: DVec3::ZERO,
            scale: 1.0,
        }
    }
}

impl Rim {
    /// The circles of places around the axis through (x, z): of each of some bands of heights the widest, at both ends
    /// of the band. So they enclose all places, and there are few of them.
    pub fn around([x, z]: [f64; 2], places: &[DVec3], share: f64) -> Vec<Self> {
        let heights = places.iter().map(|p| p.y);
        let start = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = heights.fold(start, |(low, high), y| (lesser(low, y), greater(high, y)));
        let step = greater(high - low, f64::MIN_POSITIVE) / BANDS as f64;
        let mut radii = [None; BANDS];
        for p in places {
            let band = (((p.y - low) / step) as usize).min(BANDS - 1);
            let radius = libm::hypot(p.x - x, p.z - z);
            radii[band] = Some(greater(radius, radii[band].unwrap_or(0.0)));
        }
        let bands = radii.into_iter().enumerate();
        let bands = bands.filter_map(|(band, radius)| Some((band as f64, radius?)));
        bands
            .flat_map(|(band, radius)| {
                [band, band + 1.0].map(|at| Self {
                    radius,
                    height: low + step * at,
                    share,
                })
            })
            .collect()
    }
}

impl Fit {
    /// The map for a mesh, by its bounding box.
    pub fn new(mesh: &TriMesh) -> Self {
        let (low, high) = mesh.bounds();
        Self::of_box(low, high)
    }

    /// The map for a box, by its least and its greatest corner. The middle is that of the box. The longest side becomes
    /// 1, or less if the diagonal is long.
    pub fn of_box(low: DVec3, high: DVec3) -> Self {
        let sides = high - low;
        let side = greater(sides.max_element(), DEEP * sides.length());
        Self {
            middle: (low + high) * 0.5,
            scale: if side > 0.0 { 1.0 / side } else { 1.0 },
        }
    }

    /// The map for a model that turns about an upright axis through (x, z): it is as large as its rims allow, so the
    /// model stays within the picture while it turns. The rims' highest and lowest places are as far from the picture's
    /// middle. The camera looks at the origin.
    pub fn turning([x, z]: [f64; 2], rims: &[Rim], camera: &Camera) -> Self {
        let start = (f64::INFINITY, f64::NEG_INFINITY);
        let ends = rims.iter().fold(start, |(low, high), rim| {
            let Rim { height, radius, .. } = *rim;
            (lesser(low, height - radius), greater(high, height + radius))
        });
        let (mut low, mut high) = if rims.is_empty() { (0.0, 0.0) } else { ends };
        for _ in 0..HALVINGS {
            let y = 0.5 * (low + high);
            let [above, below] = heights_seen(rims, y, scale(rims, y, camera), camera);
            (low, high) = if above > below { (y, high) } else { (low, y) };
        }
        let y = 0.5 * (low + high);
        Self {
            middle: DVec3::new(x, y, z),
            scale: scale(rims, y, camera),
        }
    }

    /// Maps a point of the model to the scene.
    pub fn place(&self, p: DVec3) -> Vec3 {
        ((p - self.middle) * self.scale).as_vec3()
    }

    /// Maps a point of the scene to the model.
    pub fn back(&self, p: Vec3) -> DVec3 {
        p.as_dvec3() / self.scale + self.middle
    }
}

/// The largest scale at which circles lie within their shares of the picture, if the origin is at the height `middle`.
///
/// A place of a circle at the angle a, scaled by s, is s r cos(a) to the right of the middle, s (y c - r k sin(a)) above
/// it, and s (y k + r c sin(a)) nearer to the eye than the origin is, with c and k the cosine and the sine of the
/// camera's elevation. It is in sight as long as the first two are at most t times its distance along the line of
/// sight. That is linear in s, and the largest value over a is that of a sum of a cosine and a sine.
fn scale(rims: &[Rim], middle: f64, camera: &Camera) -> f64 {
    let half = libm::tan(0.5 * camera.lens.to_radians());
    let (k, c) = libm::sincos(camera.height.to_radians());
    let reach = |rim: &Rim| {
        let (r, y, t) = (rim.radius, rim.height - middle, rim.share * half);
        let nearer = t * y * k;
        let ways = [
            r * libm::sqrt(1.0 + t * t * c * c) + nearer,
            y * c + nearer + r * (t * c - k).abs(),
            -y * c + nearer + r * (t * c + k).abs(),
        ];
        ways.into_iter().fold(0.0, greater) / (t * camera.distance)
    };
    let reach = rims.iter().map(reach).fold(0.0, greater);
    if reach > 0.0 { 1.0 / reach } else { 1.0 }
}

/// How high above and how low below the middle of the picture circles are seen, in parts of their shares. The highest
/// and the lowest place of a circle are its farthest and its nearest one.
fn heights_seen(rims: &[Rim], middle: f64, scale: f64, camera: &Camera) -> [f64; 2] {
    let (k, c) = libm::sincos(camera.height.to_radians());
    let seen = |rim: &Rim| {
        let (r, y) = (scale * rim.radius, scale * (rim.height - middle));
        let [far, near] =
            [-r, r].map(|r| (y * c - r * k) / (camera.distance - y * k - r * c) / rim.share);
        [greater(far, near), -lesser(far, near)]
    };
    let start = [f64::NEG_INFINITY; 2];
    rims.iter().map(seen).fold(start, |most, seen| {
        std::array::from_fn(|i| greater(most[i], seen[i]))
    })
}

#[cfg(test)]
mod tests {
    use super::{Fit, Rim};
    use crate::scene::Camera;
    use glam::DVec3;

    fn camera(height: f64) -> Camera {
        Camera {
            height,
            distance: 2.6,
            ..Camera::default()
        }
    }

    /// The largest distances of a turning model from the middle of the picture: to the right, above, below, each as a
    /// part of the share that its rim may take.
    fn seen(rims: &[Rim], fit: Fit, camera: &Camera) -> [f32; 3] {
        let view = camera.view(512, 512);
        let mut most = [0.0_f32; 3];
        for rim in rims {
            for angle in 0..720 {
                let (sin, cos) = libm::sincos(f64::from(angle).to_radians() * 0.5);
                let away = DVec3::new(rim.radius * cos, rim.height, rim.radius * sin);
                let p = fit.place(away + DVec3::new(fit.middle.x, 0.0, fit.middle.z));
                let [x, y, _] = view.on_screen(view.of(p));
                let [x, y] = [x, y].map(|at| (at - 256.0) / 256.0 / rim.share as f32);
                most = [most[0].max(x), most[1].max(-y), most[2].max(y)];
            }
        }
        most
    }

    #[test]
    fn a_turning_model_fills_its_share_and_stays_in_it() {
        let rim = |radius, height, share| Rim {
            radius,
            height,
            share,
        };
        let models = [
            vec![rim(1.0, 0.0, 0.9), rim(0.2, 0.7, 0.9)],
            vec![
                rim(1.0, -3.0, 0.98),
                rim(0.8, 4.0, 0.85),
                rim(0.9, 1.0, 0.85),
            ],
            vec![rim(30.0, 5.0, 0.8)],
        ];
        for rims in &models {
            for height in [10.0, 24.0, 50.0] {
                let camera = camera(height);
                let fit = Fit::turning([3.0, -1.0], rims, &camera);
                let [beside, above, below] = seen(rims, fit, &camera);
                let most = beside.max(above).max(below);
                assert!((0.99..1.001).contains(&most), "{height}: {most}");
                assert!(
                    (above - below).abs() < 0.01,
                    "{height}: {above} and {below}"
                );
            }
        }
    }

    #[test]
    fn rims_enclose_their_places() {
        let places: Vec<DVec3> = (0..200)
            .map(|k| f64::from(k) * 0.07)
            .map(|a| DVec3::new(1.0 + a * libm::cos(a), a * a, a * libm::sin(a) - 2.0))
            .collect();
        let rims = Rim::around([1.0, -2.0], &places, 0.5);
        assert!(rims.len() <= 64 && rims.iter().all(|rim| rim.share == 0.5));
        for p in &places {
            let away = libm::hypot(p.x - 1.0, p.z + 2.0);
            let beyond = |rim: &&Rim| rim.radius >= away - 1e-9;
            assert!(
                rims.iter()
                    .filter(beyond)
                    .any(|rim| rim.height <= p.y + 1e-9)
            );
            assert!(
                rims.iter()
                    .filter(beyond)
                    .any(|rim| rim.height >= p.y - 1e-9)
            );
        }
        assert!(Rim::around([0.0; 2], &[], 1.0).is_empty());
    }

    #[test]
    fn a_model_without_an_extent_has_the_scale_1() {
        let point = Rim {
            radius: 0.0,
            height: 2.0,
            share: 0.9,
        };
        for rims in [vec![], vec![point]] {
            assert_eq!(Fit::turning([0.0; 2], &rims, &camera(20.0)).scale, 1.0);
        }
    }
}
