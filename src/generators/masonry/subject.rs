//! Scenes of the views of masonry.

use super::diagrams::DiagramWork;
use super::kept::marks;
use super::setting::WallScene;
use super::views::MasonryView;
use super::{MasonryEngine, diagrams};
use crate::generators::scene_picture::{ScenePicture, SceneSource, SceneStages, StillParams};
use crate::graph::Wiring;
use crate::masonry::laying::Laying;
use crate::material::Material;
use crate::scene::Scene;
use std::rc::Rc;

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

/// A scene in the making.
pub(crate) struct WallMaking {
    /// The scene of blocks that are being laid, which goes on.
    live: Option<Box<WallScene>>,
    diagram: Option<DiagramWork>,
}

/// A scene.
pub(crate) enum WallSubject {
    /// The finished blocks.
    Blocks(Rc<Scene>),
    /// Blocks that are being laid, and the pass of the work on them and on the ground.
    Laying(Box<WallScene>, [u64; 2]),
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
    type Making = WallMaking;

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
                None if made.wall().is_some() && !made.has_scene_of(&made.laid) => {
                    key(MasonryView::Auto, true, made.laid.slices())
                }
                None if made.has_scene_of(&made.laid) || made.has_last() => {
                    key(MasonryView::Picture, false, made.shared.bodies.revision())
                }
                None => key(MasonryView::Mortar, false, made.site.revision()),
            },
            MasonryView::Picture => match made.shared.bodies.made() {
                Some(_) => key(MasonryView::Picture, false, made.shared.bodies.revision()),
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

    fn begin(&self, of: WallInputs, shown: &mut Option<(WallInputs, WallSubject)>) -> WallMaking {
        let pass = self.made.pass();
        let goes_on = |(before, subject): &mut (WallInputs, WallSubject)| {
            let is_same = matches!(subject, WallSubject::Laying(_, own) if *own == pass);
            is_same && self.is_later(*before, of)
        };
        let live = match shown.take_if(goes_on) {
            Some((_, WallSubject::Laying(wall, _))) => Some(wall),
            _ => None,
        };
        WallMaking {
            live,
            diagram: None,
        }
    }

    fn make(&mut self, of: WallInputs, making: &mut WallMaking) -> Option<WallSubject> {
        let made = &self.made;
        let site = made.site.made()?;
        match of.view {
            MasonryView::Picture => made.shared.scene().cloned().map(WallSubject::Blocks),
            MasonryView::Auto => {
                let (wall, ground) = (made.wall()?, made.ground.made()?);
                let marks = || marks(made.cells.made().map_or(&[], Laying::cells));
                let look = made.shared.bodies.params();
                let new = || Box::new(WallScene::new(site, ground, look, (marks(), &made.kept)));
                let mut scene = making.live.take().unwrap_or_else(new);
                scene.follow(wall, made.kept.after(made.finished()));
                Some(WallSubject::Laying(scene, made.pass()))
            }
            MasonryView::Mortar => {
                let scene = diagrams::bare(site, made.laid.params());
                Some(WallSubject::Diagram(scene))
            }
            MasonryView::Polygons => Some(WallSubject::Diagram(diagrams::polygons(site))),
            view => {
                let laying = made.cells.made()?;
                let blocks = made.laid.params();
                let new = || DiagramWork::new(site, blocks);
                let work = making.diagram.get_or_insert_with(new);
                let done = work.advance(view, laying, (site, blocks));
                done.map(WallSubject::Diagram)
            }
        }
    }

    fn making_key(&self) -> Option<WallInputs> {
        self.key("occupancy")
    }

    fn step_scene(&self, (id, state): (u32, usize)) -> Option<Scene> {
        let face = self
            .face_of(id)
            .filter(|_| state < diagrams::STATES.len())?;
        Some(diagrams::map_scene(self.made.cells.made()?, face, state))
    }

    fn still(&self) -> StillParams {
        self.made.shared.still.params().clone()
    }

    fn materials(&self, subject: &WallSubject) -> Option<&'static [Material]> {
        matches!(subject, WallSubject::Diagram(_)).then_some(&crate::surface_views::MATERIALS)
    }

    fn finished(&self, view: &str) -> Option<&[u8]> {
        let view = MasonryView::of_words(view);
        let is_picture = matches!(view, MasonryView::Auto | MasonryView::Picture);
        (is_picture && self.made.at().is_none()).then(|| self.made.shared.picture())
    }
}
