//! Scenes of the views of masonry.

use super::diagrams::{self, Diagram, DiagramWork};
use super::kept::marks;
use super::setting::WallScene;
use super::stages::MasonryStages;
use super::views::MasonryView;
use crate::generators::scene_picture::{SceneKey, SceneSource, SceneStages};
use crate::graph::Wiring;
use crate::masonry::laying::Laying;
use crate::material::Material;
use crate::scene::Scene;
use std::rc::Rc;

/// A scene in the making.
pub(crate) struct WallMaking {
    /// The last scene of blocks that are being laid, to which new blocks are added.
    live: Option<Box<WallScene>>,
    diagram: Option<DiagramWork>,
}

/// The scene of a view.
pub(crate) enum WallSubject {
    /// The finished blocks.
    Blocks(Rc<Scene>),
    /// Blocks that are being laid. The two counts tell how often the work on the blocks and on the ground has begun.
    Laying(Box<WallScene>, [u64; 2]),
    /// A diagram.
    Diagram(Diagram),
}

impl AsRef<Scene> for WallSubject {
    fn as_ref(&self) -> &Scene {
        match self {
            Self::Blocks(scene) => scene,
            Self::Laying(wall, _) => wall.scene(),
            Self::Diagram(diagram) => &diagram.scene,
        }
    }
}

impl SceneSource for MasonryStages {
    type View = MasonryView;
    type Subject = WallSubject;
    type Making = WallMaking;

    fn key(&self, view: &str) -> Option<SceneKey<MasonryView>> {
        let key = |view, is_live, revision| SceneKey {
            view,
            is_live,
            site: self.site.revision(),
            revision,
        };
        self.site.made()?;
        let cells = || self.laying().map(|_| self.cells.revision());
        Some(match MasonryView::of_words(view) {
            MasonryView::Auto => match self.begun(&self.laid) {
                Some(_) => key(MasonryView::Auto, true, self.laid.slices()),
                None if self.wall().is_some() && !self.has_scene_of(&self.laid) => {
                    key(MasonryView::Auto, true, self.laid.slices())
                }
                None if self.has_scene_of(&self.laid) || self.has_last() => {
                    key(MasonryView::Picture, false, self.shared.bodies.revision())
                }
                None => key(MasonryView::Mortar, false, self.site.revision()),
            },
            MasonryView::Picture => match self.shared.bodies.made() {
                Some(_) => key(MasonryView::Picture, false, self.shared.bodies.revision()),
                None => return None,
            },
            view @ (MasonryView::Mortar | MasonryView::Polygons) => {
                key(view, false, self.site.revision())
            }
            other => key(other, false, cells()?),
        })
    }

    fn goes_on(&self, shown: &WallSubject) -> bool {
        matches!(shown, WallSubject::Laying(_, pass) if *pass == self.pass())
    }

    fn begin(&self, shown: Option<WallSubject>) -> WallMaking {
        WallMaking {
            live: match shown {
                Some(WallSubject::Laying(wall, _)) => Some(wall),
                _ => None,
            },
            diagram: None,
        }
    }

    fn make(&mut self, of: SceneKey<MasonryView>, making: &mut WallMaking) -> Option<WallSubject> {
        let site = self.site.made()?;
        match of.view {
            MasonryView::Picture => self.shared.scene().cloned().map(WallSubject::Blocks),
            MasonryView::Auto => {
                let (wall, ground) = (self.wall()?, self.ground.made()?);
                let marks = || marks(self.laying().map_or(&[], Laying::cells));
                let look = self.shared.bodies.params();
                let new = || Box::new(WallScene::new(site, ground, look, (marks(), &self.kept)));
                let mut scene = making.live.take().unwrap_or_else(new);
                scene.follow(wall, self.kept.after(self.finished()));
                Some(WallSubject::Laying(scene, self.pass()))
            }
            MasonryView::Mortar => {
                let scene = diagrams::bare(site, self.laid.params(), &[]);
                Some(WallSubject::Diagram(scene.into()))
            }
            MasonryView::Polygons => Some(WallSubject::Diagram(diagrams::polygons(site).into())),
            view => {
                let laying = self.laying()?;
                let blocks = self.laid.params();
                let new = || DiagramWork::new(site, blocks, laying.cells());
                let work = making.diagram.get_or_insert_with(new);
                let done = work.advance(view, laying, (site, blocks));
                done.map(WallSubject::Diagram)
            }
        }
    }

    fn making_key(&self, view: &str) -> Option<SceneKey<MasonryView>> {
        match MasonryView::of_words(view) {
            MasonryView::Occupancy => self.key("occupancy"),
            _ => self.key("picture").filter(|_| self.is_laid()),
        }
    }

    fn step_scene(&self, view: &str, (id, at): (u32, usize)) -> Option<Scene> {
        match MasonryView::of_words(view) {
            MasonryView::Occupancy => {
                let face = self.face_of(id);
                let face = face.filter(|_| at < diagrams::STATES.len())?;
                Some(diagrams::map_scene(self.laying()?, face, at))
            }
            _ => self.block_scene(id, at),
        }
    }

    fn materials(&self, subject: &WallSubject) -> Option<&'static [Material]> {
        matches!(subject, WallSubject::Diagram(_)).then_some(&crate::surface_views::MATERIALS)
    }
}
