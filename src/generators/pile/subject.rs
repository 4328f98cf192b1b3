//! Scenes of the views of a pile.

use super::PileEngine;
use super::diagrams::{self, Diagram};
use super::heap::Heap;
use super::views::PileView;
use crate::generators::scene_picture::{ScenePicture, SceneSource, SceneStages, StillParams};
use crate::graph::Wiring;
use crate::material::Material;
use crate::scene::Scene;
use std::rc::Rc;

/// The key of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SceneInputs {
    pub view: PileView,
    /// Whether it shows work in progress.
    pub is_live: bool,
    /// The revision of the shape.
    pub site: u64,
    /// The revision of the shown results.
    pub revision: u64,
}

/// A scene.
pub(crate) enum ViewScene {
    /// The finished bodies.
    Bodies(Rc<Scene>),
    /// Bodies that settle, and the pass of the work that lets them.
    Settling(Box<Heap>, u64),
    /// A diagram.
    Diagram(Diagram),
}

impl AsRef<Scene> for ViewScene {
    fn as_ref(&self) -> &Scene {
        match self {
            Self::Bodies(scene) => scene,
            Self::Settling(heap, _) => heap.scene(),
            Self::Diagram(diagram) => &diagram.scene,
        }
    }
}

impl SceneSource for PileEngine {
    type Key = SceneInputs;
    type Subject = ViewScene;
    type Making = Option<Box<Heap>>;

    fn scene_picture(&mut self) -> &mut ScenePicture<Self> {
        &mut self.picture
    }

    fn key(&self, view: &str) -> Option<SceneInputs> {
        let made = &self.made;
        let key = |view, is_live, revision| SceneInputs {
            view,
            is_live,
            site: made.ground.revision(),
            revision,
        };
        made.ground.made()?;
        let settled = || made.settled.made().map(|_| made.settled.revision());
        Some(match PileView::of_words(view) {
            PileView::Auto => match made.begun(&made.settled) {
                Some(_) => key(PileView::Auto, true, made.settled.slices()),
                None if made.has_scene_of(&made.settled) => {
                    key(PileView::Picture, false, made.shared.bodies.revision())
                }
                None if made.is_fresh(&made.settled) => {
                    key(PileView::Auto, true, made.settled.slices())
                }
                None => key(PileView::Darts, true, made.placed.slices()),
            },
            PileView::Picture => match made.shared.bodies.made() {
                Some(_) => key(PileView::Picture, false, made.shared.bodies.revision()),
                None => return None,
            },
            PileView::Darts => key(PileView::Darts, true, made.placed.slices()),
            other => key(other, false, settled()?),
        })
    }

    fn is_later(&self, before: SceneInputs, after: SceneInputs) -> bool {
        before.view == after.view && before.site == after.site && before.is_live
    }

    fn begin(
        &self,
        of: SceneInputs,
        shown: &mut Option<(SceneInputs, ViewScene)>,
    ) -> Option<Box<Heap>> {
        let pass = self.made.settled.passes();
        let goes_on = |(before, subject): &mut (SceneInputs, ViewScene)| {
            let is_same = matches!(subject, ViewScene::Settling(_, own) if *own == pass);
            is_same && self.is_later(*before, of)
        };
        match shown.take_if(goes_on) {
            Some((_, ViewScene::Settling(heap, _))) => Some(heap),
            _ => None,
        }
    }

    fn make(&mut self, of: SceneInputs, making: &mut Option<Box<Heap>>) -> Option<ViewScene> {
        let made = &self.made;
        if of.view == PileView::Picture {
            return made.shared.scene().cloned().map(ViewScene::Bodies);
        }
        if of.view == PileView::Auto {
            let (parts, refining) = (made.parts()?, made.refining()?);
            let mut heap = making.take().unwrap_or_else(|| Box::new(Heap::new(parts)));
            heap.update_seen(parts, refining.bodies(), refining.history());
            return Some(ViewScene::Settling(heap, made.settled.passes()));
        }
        let ground = made.ground.made()?;
        if of.view == PileView::Darts {
            let darts = made.darts();
            return Some(ViewScene::Diagram(diagrams::darts(ground, &darts)));
        }
        let piled = diagrams::Piled {
            kinds: &made.placed.made()?.kinds,
            bodies: made.settled.made()?.bodies(),
            offset: made.settled.params().offset,
            removal: made.settled.params().removal,
            components: made.components.made()?,
            fit: ground.fit(),
        };
        Some(ViewScene::Diagram(diagrams::of_bodies(
            of.view, &piled, ground,
        )))
    }

    fn still(&self) -> StillParams {
        self.made.shared.still.params().clone()
    }

    fn materials(&self, subject: &ViewScene) -> Option<&'static [Material]> {
        matches!(subject, ViewScene::Diagram(_)).then_some(&crate::surface_views::MATERIALS)
    }

    fn finished(&self, view: &str) -> Option<&[u8]> {
        let is_picture = matches!(PileView::of_words(view), PileView::Auto | PileView::Picture);
        (is_picture && self.made.at().is_none()).then(|| self.made.shared.picture())
    }
}
