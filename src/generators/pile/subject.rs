//! Scenes of the views of a pile.

use super::diagrams::{self, Diagram};
use super::heap::Heap;
use super::stages::PileStages;
use super::views::PileView;
use crate::generators::scene_picture::{SceneKey, SceneSource, SceneStages};
use crate::graph::Wiring;
use crate::material::Material;
use crate::pile::OverlapWork;
use crate::scene::{Cut, CutHow, Scene};
use std::rc::Rc;

/// The scene of a view.
pub(crate) enum ViewScene {
    /// The finished bodies.
    Bodies(Rc<Scene>),
    /// Bodies that settle, and how often the work of settling was begun.
    Settling(Box<Heap>, u64),
    /// A diagram.
    Diagram(Diagram),
}

/// The scene of a view in the making.
pub(crate) enum ViewMaking {
    /// Nothing is made yet.
    Begun,
    /// The settling bodies that were shown before.
    Heap(Box<Heap>),
    /// How deep bodies overlap.
    Overlap(Box<OverlapWork>),
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

impl SceneSource for PileStages {
    type View = PileView;
    type Subject = ViewScene;
    type Making = ViewMaking;

    fn key(&self, view: &str) -> Option<SceneKey<PileView>> {
        let key = |view, is_live, revision| SceneKey {
            view,
            is_live,
            site: self.ground.revision(),
            revision,
        };
        self.ground.made()?;
        let settled = || self.current(&self.settled).map(|_| self.settled.revision());
        Some(match PileView::of_words(view) {
            PileView::Auto => match self.begun(&self.settled) {
                Some(_) => key(PileView::Auto, true, self.settled.slices()),
                None if self.has_scene_of(&self.settled) => {
                    key(PileView::Picture, false, self.shared.bodies.revision())
                }
                None if self.is_settled() => key(PileView::Auto, true, self.settled.slices()),
                None => key(PileView::Darts, true, self.placed.slices()),
            },
            PileView::Picture => match self.shared.bodies.made() {
                Some(_) => key(PileView::Picture, false, self.shared.bodies.revision()),
                None => return None,
            },
            PileView::Darts => key(PileView::Darts, true, self.placed.slices()),
            other => key(other, false, settled()?),
        })
    }

    fn goes_on(&self, shown: &ViewScene) -> bool {
        matches!(shown, ViewScene::Settling(_, pass) if *pass == self.settled.passes())
    }

    fn begin(&self, shown: Option<ViewScene>) -> ViewMaking {
        match shown {
            Some(ViewScene::Settling(heap, _)) => ViewMaking::Heap(heap),
            _ => ViewMaking::Begun,
        }
    }

    fn make(&mut self, of: SceneKey<PileView>, making: &mut ViewMaking) -> Option<ViewScene> {
        if of.view == PileView::Picture {
            return self.shared.scene().cloned().map(ViewScene::Bodies);
        }
        if of.view == PileView::Auto {
            let (parts, refining) = (self.parts()?, self.refining()?);
            let mut heap = match std::mem::replace(making, ViewMaking::Begun) {
                ViewMaking::Heap(heap) => heap,
                _ => Box::new(Heap::new(parts)),
            };
            heap.update_seen(parts, refining.bodies(), refining.history());
            return Some(ViewScene::Settling(heap, self.settled.passes()));
        }
        let ground = self.ground.made()?;
        if of.view == PileView::Darts {
            let darts = self.darts();
            return Some(ViewScene::Diagram(diagrams::darts(ground, &darts)));
        }
        let piled = diagrams::Piled {
            kinds: &self.placed.made()?.kinds,
            bodies: self.current(&self.settled)?.bodies(),
            offset: self.settled.params().offset,
            removal: self.settled.params().removal,
            components: self.components.made()?,
            fit: ground.fit(),
        };
        if of.view != PileView::Overlap {
            let diagram = diagrams::of_bodies(of.view, &piled, ground);
            return Some(ViewScene::Diagram(diagram));
        }
        if let ViewMaking::Overlap(work) = making {
            let is_done = work.advance(piled.bodies, piled.kinds);
            return is_done.then(|| ViewScene::Diagram(diagrams::overlap(&piled, &work.deepest)));
        }
        let work = OverlapWork::new(piled.bodies, piled.kinds);
        *making = ViewMaking::Overlap(Box::new(work));
        None
    }

    /// A body's depth is inside, so a plane cuts through all bodies, in the middle if no other is asked for.
    fn cut(&self, subject: &ViewScene, asked: Option<Cut>) -> Option<Cut> {
        match subject {
            ViewScene::Diagram(diagram) if diagram.is_inside => Some(Cut {
                how: CutHow::Through,
                ..asked.unwrap_or(diagrams::MIDDLE)
            }),
            _ => asked,
        }
    }

    fn materials(&self, subject: &ViewScene) -> Option<&'static [Material]> {
        matches!(subject, ViewScene::Diagram(_)).then_some(&crate::surface_views::MATERIALS)
    }
}
