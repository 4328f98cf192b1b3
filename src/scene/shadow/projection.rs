//! The projections of shadow maps: parallel to a sun's light, or from a lamp through a side of a cube around it.

use super::super::fill::{Fill, Vertex};
use super::super::raster::Corner;
use super::super::{Camera, Lamp};
use crate::order::greater;
use glam::Vec3;

/// The half side of the map, in radii of the bounding ball.
const MARGIN: f32 = 1.02;
/// The least cosine between a surface and the direction to the lamp; smaller ones are clamped.
const GRAZING: f32 = 1e-3;
/// The angle of view of a side of the cube, in degrees: a little more than 90, so that the filter's samples stay on
/// it.
const SIDE_LENS: f64 = 91.0;

/// The projection of a map.
#[derive(Clone, Copy)]
pub(super) enum ShadowProjection {
    /// Parallel: the middle of the map, unit vectors across, up and to the lamp, and texels for each unit.
    Along {
        middle: Vec3,
        axes: [Vec3; 3],
        scale: f32,
        /// Rasterises into the map's pixels; nothing is clipped.
        fill: Fill,
    },
    /// Perspective, from a point.
    From(Fill),
}

impl ShadowProjection {
    /// The projections that a lamp needs to light a ball.
    pub fn of_lamp((middle, radius): (Vec3, f32), lamp: Lamp, side: usize) -> Vec<Self> {
        match lamp {
            Lamp::Sun(to) => {
                let axes = [to, to.any_orthonormal_vector()];
                vec![Self::along(middle, radius * MARGIN, axes, side)]
            }
            Lamp::Bulb { at, .. } => {
                let sides = [
                    (0.0, 0.0),
                    (90.0, 0.0),
                    (180.0, 0.0),
                    (270.0, 0.0),
                    (0.0, 90.0),
                    (0.0, -90.0),
                ];
                let views = sides.into_iter().map(|(angle, height)| {
                    let camera = Camera {
                        angle,
                        height,
                        lens: SIDE_LENS,
                        ..Camera::default()
                    };
                    let mut view = camera.view(side, side);
                    view.eye = at;
                    view.near = (2e-3 * radius).max(f32::MIN_POSITIVE);
                    view
                });
                let seen = views.filter(|view| view.may_see(view.of(middle), radius));
                seen.map(|view| Self::From(Fill::new(view))).collect()
            }
        }
    }

    /// Parallel to `to`, with rows along `across`, for all within `half` of the middle.
    pub fn along(middle: Vec3, half: f32, [to, across]: [Vec3; 2], side: usize) -> Self {
        Self::Along {
            middle,
            axes: [across, to.cross(across), to],
            scale: 0.5 * side as f32 / half.max(f32::MIN_POSITIVE),
            fill: Fill::new(Camera::default().view(side, side)),
        }
    }

    /// Rasterises into a map's texels.
    pub fn fill(&self) -> &Fill {
        let (Self::Along { fill, .. } | Self::From(fill)) = self;
        fill
    }

    /// Whether the lamp is below all that it lights.
    pub fn is_from_below(&self) -> bool {
        matches!(self, Self::Along { axes: [.., to], .. } if to.y < 0.0)
    }

    /// The size of a texel at a point, in the world.
    pub fn texel(&self, point: Vec3) -> f32 {
        match self {
            Self::Along { scale, .. } => 1.0 / scale,
            Self::From(fill) => {
                let view = &fill.view;
                greater(view.of(point).z, view.near) * view.slope
            }
        }
    }

    /// Whether a point lies on the side of the cube that this map shows.
    pub fn is_towards(&self, point: Vec3) -> bool {
        match self {
            Self::Along { .. } => true,
            Self::From(fill) => {
                let seen = fill.view.of(point);
                seen.z > fill.view.near && seen.x.abs() <= seen.z && seen.y.abs() <= seen.z
            }
        }
    }

    /// A point in texels of a map with `side` texels along a side, and how near it is to the lamp.
    #[inline(always)]
    pub fn on_map(&self, p: Vec3, side: usize) -> [f32; 3] {
        match self {
            Self::Along {
                middle,
                axes,
                scale,
                ..
            } => {
                let d = p - *middle;
                let half = 0.5 * side as f32;
                [
                    half + d.dot(axes[0]) * scale,
                    half - d.dot(axes[1]) * scale,
                    d.dot(axes[2]),
                ]
            }
            Self::From(fill) => fill.view.on_screen(fill.view.of(p)),
        }
    }

    /// A corner to be rasterised.
    #[inline(always)]
    pub fn vertex(&self, p: Vec3, side: usize) -> Vertex {
        match self {
            Self::Along { .. } => Vertex::on_screen(Corner::new(self.on_map(p, side))),
            Self::From(fill) => fill.vertex(p),
        }
    }

    /// The diameter of a ball in texels; `None` if it lies beside the map.
    pub fn diameter(&self, (middle, radius): (Vec3, f32)) -> Option<f32> {
        match self {
            Self::Along { scale, .. } => Some(2.0 * radius * scale),
            Self::From(fill) => {
                let seen = fill.view.of(middle);
                let may_see = fill.view.may_see(seen, radius);
                may_see.then(|| fill.view.diameter(seen, radius))
            }
        }
    }

    /// The distance from a point to the first surface on its way to the lamp. `near` and `first` tell how near both are
    /// to the lamp.
    pub fn distance(&self, p: Vec3, near: f32, first: f32) -> f32 {
        match self {
            Self::Along { .. } => first - near,
            Self::From(fill) => (p - fill.view.eye).length() * (1.0 - near / first),
        }
    }

    /// For the plane through a point: how much nearer to the lamp it comes for each texel to the right and down.
    pub fn slopes(&self, p: Vec3, normal: Vec3) -> [f32; 2] {
        match self {
            Self::Along { axes, scale, .. } => {
                let [x, y, facing] = axes.map(|axis| normal.dot(axis));
                let part = 1.0 / (scale * greater(facing, GRAZING));
                [-x * part, y * part]
            }
            Self::From(fill) => {
                // The inverse depth is linear over a plane, too. With a ray r of depth 1, the normal n and the vector q
                // from the lamp to any point of the plane, it is (n . r) / (n . q).
                let view = &fill.view;
                let way = p - view.eye;
                let facing = greater(-normal.dot(way), GRAZING * way.length());
                let part = 1.0 / (view.focal * greater(facing, f32::MIN_POSITIVE));
                [-normal.dot(view.right) * part, normal.dot(view.up) * part]
            }
        }
    }
}
