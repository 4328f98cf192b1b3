//! The second stage: the shape on which bodies are heaped, with its walls.

use super::PILE;
use super::params::{SiteParams, SiteSource};
use crate::generators::scene_picture::Loaded;
use crate::notice::{Code, Notice};
use crate::pile::Wall;
use crate::pile_shape::{PileShapeBuilding, PiledShape, Vessel};
use crate::shapes::{Ends, Shape, ShapeMaking};
use crate::surface_stones::{Fit, Rim};
use crate::trimesh::{MeshBuilding, Search, TriMesh};
use glam::DVec3;
use std::sync::Arc;

/// The length of edges, as a share of the longest side.
const EDGE: f64 = 0.02;
/// The depth of the floor below the lowest place of ground, in longest sides.
const SKIRT: f64 = 0.03;
/// How far from the cut sides of ground bodies end, in longest sides: they may pass a wall by a hair, which would show.
const INSET: f64 = 0.002;
/// The parts of the half picture that a pile, a container and a block of ground may take. Shadows need room, too; those
/// of containers and blocks are short beside them.
const SHARE: f64 = 0.81;
const VESSEL_SHARE: f64 = 0.87;
const GROUND_SHARE: f64 = 0.94;
/// Triangles in a slice of the search tree.
const SEARCHED: usize = 1 << 14;

/// A shape that is ready for darts.
pub(super) struct Site {
    pub mesh: Arc<TriMesh>,
    pub search: Search,
    pub walls: Vec<Wall>,
    /// The container that is seen.
    pub vessel: Option<Vessel>,
    /// Whether the shape is ground, which is seen.
    pub is_ground: bool,
}

/// A shape in progress.
pub(super) enum SiteMaking {
    Shape(Box<ShapeMaking>),
    Pile(Box<PileShapeBuilding>),
    Mesh(Box<MeshBuilding>, Surroundings),
    Tree(Box<Site>),
}

/// Everything around the mesh.
#[derive(Default)]
pub(super) struct Surroundings {
    walls: Vec<Wall>,
    vessel: Option<Vessel>,
    is_ground: bool,
}

impl SiteMaking {
    /// Does one slice.
    ///
    /// # Errors
    /// If the file has no surface.
    pub fn advance(
        params: &SiteParams,
        work: &mut Option<SiteMaking>,
        loaded: &Loaded,
    ) -> Result<Option<Site>, Notice> {
        let next = match work.take() {
            None => Self::begin(params, loaded)?,
            Some(Self::Shape(mut making)) => match making.advance() {
                false => Self::Shape(making),
                true => {
                    let made = making.finish();
                    let is_ground = is_ground(&params.source);
                    let positions = scaled(made.positions, 2.0 * params.half);
                    let around = Surroundings {
                        walls: match is_ground {
                            true => sides(&positions),
                            false => Vec::new(),
                        },
                        is_ground,
                        ..Surroundings::default()
                    };
                    Self::Mesh(
                        Box::new(MeshBuilding::new(positions, made.triangles)),
                        around,
                    )
                }
            },
            Some(Self::Pile(mut building)) => match building.advance() {
                None => Self::Pile(building),
                Some(made) => Self::piled(made.scaled(2.0 * params.half)),
            },
            Some(Self::Mesh(mut building, around)) => match building.advance() {
                None => Self::Mesh(building, around),
                Some(mesh) => {
                    let mesh = Arc::new(mesh.map_err(|_| Notice::from(Code::ModelNoArea))?);
                    Self::tree(mesh, around)
                }
            },
            Some(Self::Tree(mut site)) => {
                if site.search.advance(&site.mesh, SEARCHED) {
                    return Ok(Some(*site));
                }
                Self::Tree(site)
            }
        };
        *work = Some(next);
        Ok(None)
    }

    fn begin(params: &SiteParams, loaded: &Loaded) -> Result<Self, Notice> {
        let by = 2.0 * params.half;
        Ok(match &params.source {
            SiteSource::Pile(shape, numbers) => Self::Pile(Box::new(shape.building(numbers, EDGE))),
            SiteSource::Shape(shape, numbers) => {
                Self::Shape(Box::new(shape.making(numbers, EDGE, Ends::Round)))
            }
            SiteSource::File(number) => {
                let mesh = &loaded.meshes[*number];
                let (low, high) = mesh.bounds();
                let side = (high - low).max_element();
                let middle = DVec3::new(0.5 * (low.x + high.x), low.y, 0.5 * (low.z + high.z));
                let place = |p: &DVec3| (*p - middle) * (by / side);
                let positions = mesh.positions().iter().map(place).collect();
                let building = MeshBuilding::new(positions, mesh.triangles().to_vec());
                Self::Mesh(Box::new(building), Surroundings::default())
            }
        })
    }

    fn piled(made: PiledShape) -> Self {
        let building = MeshBuilding::new(made.surface.positions, made.surface.triangles);
        let around = Surroundings {
            walls: made.walls,
            vessel: made.vessel,
            is_ground: false,
        };
        Self::Mesh(Box::new(building), around)
    }

    fn tree(mesh: Arc<TriMesh>, around: Surroundings) -> Self {
        let site = Site {
            search: Search::begin(&mesh),
            mesh,
            walls: around.walls,
            vessel: around.vessel,
            is_ground: around.is_ground,
        };
        Self::Tree(Box::new(site))
    }
}

/// Whether a shape is ground.
fn is_ground(source: &SiteSource) -> bool {
    matches!(
        source,
        SiteSource::Shape(Shape::Terrain | Shape::Slope | Shape::Stairs, _)
    )
}

/// The four upright sides of a block of ground, and its floor. Ground is cut out of a landscape, so bodies end at the
/// cut.
fn sides(positions: &[DVec3]) -> Vec<Wall> {
    let low = positions.iter().copied().reduce(DVec3::min);
    let high = positions.iter().copied().reduce(DVec3::max);
    let (mut low, high) = (low.unwrap_or_default(), high.unwrap_or_default());
    let inset = INSET * (high - low).max_element();
    low.y -= skirt(low, high);
    let wall = |(normal, at): (DVec3, DVec3)| Wall::Plane {
        normal,
        offset: normal.dot(at) - inset,
    };
    let sides = [
        (DVec3::X, high),
        (DVec3::NEG_X, low),
        (DVec3::Z, high),
        (DVec3::NEG_Z, low),
        (DVec3::NEG_Y, low),
    ];
    sides.map(wall).to_vec()
}

/// The depth of the floor of a block of ground below the lowest place of its surface, which has this box.
fn skirt(low: DVec3, high: DVec3) -> f64 {
    SKIRT * (high - low).max_element()
}

fn scaled(positions: Vec<DVec3>, by: f64) -> Vec<DVec3> {
    positions.into_iter().map(|p| p * by).collect()
}

impl Site {
    /// The height of the floor on which ground stands.
    pub fn floor(&self) -> f64 {
        let (low, high) = self.mesh.bounds();
        low.y - skirt(low, high)
    }

    /// The map from the shape's units to the scene: the shape with its container, and `room` around it for bodies, is
    /// in sight while it turns.
    pub fn fit(&self, room: f64) -> Fit {
        let (low, high) = self.mesh.bounds();
        let axis = low.midpoint(high);
        let [x, z] = [axis.x, axis.z];
        // A container keeps bodies in, except at its top, and ground ends at its cut sides.
        let is_bounded = self.vessel.is_some() || self.is_ground;
        let share = match (&self.vessel, self.is_ground) {
            (Some(_), _) => VESSEL_SHARE,
            (None, true) => GROUND_SHARE,
            (None, false) => SHARE,
        };
        let mut rims = Rim::around([x, z], self.mesh.positions(), share);
        for rim in &mut rims {
            rim.radius += if is_bounded { 0.0 } else { room };
            rim.height += if rim.height > axis.y { room } else { 0.0 };
        }
        let around = self.vessel.iter().flat_map(|v| &v.surface.positions);
        let around: Vec<DVec3> = around.map(|p| p.as_dvec3()).collect();
        rims.extend(Rim::around([x, z], &around, share));
        if self.is_ground {
            let foot = low.with_y(self.floor());
            rims.extend(Rim::around([x, z], &[foot], share));
        }
        Fit::turning([x, z], &rims, &PILE.camera())
    }
}
