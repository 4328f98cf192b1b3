//! Scenes of the views of masonry.

use super::MasonryEngine;
use super::blocks::{Wall, add_mortar, flat, plain};
use super::colours::{FEATURES, type_of};
use super::parts::add_plain;
use super::site::BuildingSite;
use super::views::MasonryView;
use crate::generators::scene_picture::{ScenePicture, SceneSource, SceneStages, StillParams};
use crate::graph::Wiring;
use crate::masonry::block::BlockMesh;
use crate::masonry::laying::{CellSort, MasonryCell};
use crate::material::Material;
use crate::random::{Purpose, Random};
use crate::scene::Scene;
use std::rc::Rc;

/// Colours of whole, half, cut and raked bricks, of sills, of stones, and of tiles.
const SORTS: [[u8; 3]; 7] = [
    [188, 180, 166],
    [86, 146, 206],
    [214, 92, 64],
    [226, 152, 72],
    [150, 122, 196],
    [148, 168, 120],
    [112, 128, 144],
];
/// The colour of mortar in views.
const CALM: [u8; 3] = [168, 162, 151];
/// The rows of plain bodies and of the bare surface in the materials of views.
const SATIN: u8 = 2;
const BARE: u8 = 0;

/// The key of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct WallInputs {
    pub view: MasonryView,
    /// Whether it shows work in progress.
    pub is_live: bool,
    /// The revision of the building.
    pub site: u64,
    /// The revision of the shown results.
    pub revision: u64,
}

/// A scene.
pub(crate) enum WallSubject {
    /// The finished blocks.
    Blocks(Rc<Scene>),
    /// Blocks that are being laid, and the pass of the work.
    Laying(Box<Wall>, u64),
    /// A diagram.
    Diagram(Scene),
}

impl AsRef<Scene> for WallSubject {
    fn as_ref(&self) -> &Scene {
        match self {
            Self::Blocks(scene) => scene,
            Self::Laying(wall, _) => wall.scene(),
            Self::Diagram(scene) => scene,
        }
    }
}

impl SceneSource for MasonryEngine {
    type Key = WallInputs;
    type Subject = WallSubject;
    type Making = Option<Box<Wall>>;

    fn scene_picture(&mut self) -> &mut ScenePicture<Self> {
        &mut self.picture
    }

    fn key(&self, view: &str) -> Option<WallInputs> {
        let made = &self.made;
        let key = |view, is_live, revision| WallInputs {
            view,
            is_live,
            site: made.site.revision(),
            revision,
        };
        made.site.made()?;
        let cells = || made.cells.made().map(|_| made.cells.revision());
        Some(match MasonryView::of_words(view) {
            MasonryView::Auto => match made.begun(&made.laid) {
                Some(_) => key(MasonryView::Auto, true, made.laid.slices()),
                None if made.has_blocks() => {
                    key(MasonryView::Picture, false, made.blocks.revision())
                }
                None => key(MasonryView::Mortar, false, made.site.revision()),
            },
            MasonryView::Picture => match made.blocks.made() {
                Some(_) => key(MasonryView::Picture, false, made.blocks.revision()),
                None => return None,
            },
            view @ (MasonryView::Mortar | MasonryView::Polygons) => {
                key(view, false, made.site.revision())
            }
            other => key(other, false, cells()?),
        })
    }

    fn is_later(&self, before: WallInputs, after: WallInputs) -> bool {
        before.view == after.view && before.site == after.site && before.is_live
    }

    fn begin(
        &self,
        of: WallInputs,
        shown: &mut Option<(WallInputs, WallSubject)>,
    ) -> Option<Box<Wall>> {
        let pass = self.made.laid.passes();
        let goes_on = |(before, subject): &mut (WallInputs, WallSubject)| {
            let is_same = matches!(subject, WallSubject::Laying(_, own) if *own == pass);
            is_same && self.is_later(*before, of)
        };
        match shown.take_if(goes_on) {
            Some((_, WallSubject::Laying(wall, _))) => Some(wall),
            _ => None,
        }
    }

    fn make(&mut self, of: WallInputs, making: &mut Option<Box<Wall>>) -> Option<WallSubject> {
        let made = &self.made;
        let site = made.site.made()?;
        match of.view {
            MasonryView::Picture => {
                let blocks = made.blocks.made()?;
                Some(WallSubject::Blocks(blocks.scene.clone()))
            }
            MasonryView::Auto => {
                let work = made.begun(&made.laid)?;
                let new = || Box::new(Wall::new(site, made.laid.params()));
                let mut wall = making.take().unwrap_or_else(new);
                wall.lay(made.cells.made()?.cells(), work.shown());
                Some(WallSubject::Laying(wall, made.laid.passes()))
            }
            MasonryView::Mortar => {
                Some(WallSubject::Diagram(bare(site, made.laid.params().recess)))
            }
            MasonryView::Polygons => Some(WallSubject::Diagram(polygons(site))),
            view => {
                let cells = made.cells.made()?.cells();
                let mut scene = bare(site, made.laid.params().recess);
                let colour = |cell: &MasonryCell| match view {
                    MasonryView::Features => FEATURES[type_of(cell.feature)],
                    _ => SORTS[place_of(cell.sort)],
                };
                for (number, cell) in (1..).zip(cells) {
                    if let Some(body) = cell.body.shrunk() {
                        add_plain(
                            &mut scene,
                            plain(&body, site.fit),
                            (number, colour(cell), SATIN),
                        );
                    }
                }
                Some(WallSubject::Diagram(scene))
            }
        }
    }

    fn still(&self) -> StillParams {
        self.made.still.params().clone()
    }

    fn materials(&self, subject: &WallSubject) -> Option<&'static [Material]> {
        matches!(subject, WallSubject::Diagram(_)).then_some(&crate::surface_views::MATERIALS)
    }

    fn finished(&self, view: &str) -> Option<&[u8]> {
        let view = MasonryView::of_words(view);
        let is_picture = matches!(view, MasonryView::Auto | MasonryView::Picture);
        (is_picture && self.made.at().is_none()).then(|| self.made.picture())
    }
}

/// The place of a sort in the list of its colours.
fn place_of(sort: CellSort) -> usize {
    match sort {
        CellSort::Whole => 0,
        CellSort::Half => 1,
        CellSort::Cut => 2,
        CellSort::Raked => 3,
        CellSort::Sill => 4,
        CellSort::Stone => 5,
        CellSort::Tile => 6,
    }
}

/// The mortar alone.
fn bare(site: &BuildingSite, recess: f64) -> Scene {
    let mut scene = Scene {
        reach: (0.3 * site.fit.scale) as f32,
        ..Scene::default()
    };
    add_mortar(&mut scene, site, recess, [(CALM, BARE); 2]);
    scene
}

/// The polygons of the child mesh, each in a tone of its own.
fn polygons(site: &BuildingSite) -> Scene {
    let mut scene = Scene {
        reach: (0.3 * site.fit.scale) as f32,
        ..Scene::default()
    };
    for (id, polygon) in (1_u32..).zip(site.building.polygons()) {
        let place = |v: &crate::building::VertexId| site.building.vertex(*v).position;
        let count = polygon.vertices.len() as u32;
        let mesh = BlockMesh {
            positions: polygon.vertices.iter().map(place).collect(),
            triangles: (2..count).map(|k| [0, k - 1, k]).collect(),
        };
        let mut random = Random::new(7, Purpose::Paint, u64::from(id));
        let colour = [0; 3].map(|_| 110 + random.below(120) as u8);
        add_plain(
            &mut scene,
            flat(&mesh, |p| site.fit.place(p)),
            (id, colour, BARE),
        );
    }
    scene
}
