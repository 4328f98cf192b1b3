//! Scenes of the views of a surface, made in slices.

use super::SurfaceEngine;
use super::stages::Stages;
use super::views::SurfaceView;
use crate::decimal;
use crate::draw::Tones;
use crate::generators::scene_picture::{SceneKey, SceneSource, SceneStages};
use crate::material::Material;
use crate::notice::{Code, Notice};
use crate::scene::Scene;
use crate::surface_stones::Fit;
use crate::surface_views::{
    BareSurface, CellsView, FieldView, MATERIALS, MapView, MeshView, Particles, Quantity, Tally,
};
use std::rc::Rc;

/// The scene of a view.
pub(crate) enum ViewScene {
    Stones(Rc<Scene>),
    Particles(Box<Particles>),
    Field(Scene, Tally),
    Map(Scene, [f64; 2]),
    Other(Scene),
}

impl AsRef<Scene> for ViewScene {
    fn as_ref(&self) -> &Scene {
        match self {
            Self::Stones(scene) => scene,
            Self::Particles(particles) => particles.scene(),
            Self::Field(scene, _) | Self::Map(scene, _) | Self::Other(scene) => scene,
        }
    }
}

/// The scene of a view, while it is made.
pub(crate) enum ViewSceneMaking {
    Begin(Option<Box<Particles>>),
    Field(Box<FieldView>),
    Mesh(Box<MeshView>),
    Cells(Box<CellsView>),
    Map(Box<MapView>),
}

impl SceneSource for Stages {
    type View = SurfaceView;
    type Subject = ViewScene;
    type Making = ViewSceneMaking;

    fn key(&self, view: &str) -> Option<SceneKey<SurfaceView>> {
        let view = SurfaceView::of_words(view);
        let (surface, revision) = self.revisions();
        let is_packed = self.live_packing().is_some();
        let view = match view {
            SurfaceView::Auto if self.has_scene_of(&self.packing) => SurfaceView::Picture,
            SurfaceView::Auto => SurfaceView::Packed,
            other => other,
        };
        let revision = match view {
            SurfaceView::Picture => self.scene().map(|(_, revision)| revision),
            // The bare surface is seen until there is a packing.
            SurfaceView::Packed | SurfaceView::Auto if self.packing().is_none() => {
                self.last_built().map(|_| 0)
            }
            SurfaceView::Packed | SurfaceView::Auto => is_packed.then(|| self.changes()),
            SurfaceView::Cells => self.paved().map(|_| revision.cells),
            SurfaceView::Mesh => self.mesh().map(|_| revision.mesh),
            SurfaceView::Direction | SurfaceView::Size | SurfaceView::Curvature => {
                self.fresh_fields().map(|_| revision.fields)
            }
        };
        Some(SceneKey {
            view,
            is_live: true,
            site: surface,
            revision: revision?,
        })
    }

    fn goes_on(&self, shown: &ViewScene) -> bool {
        matches!(shown, ViewScene::Particles(_))
    }

    fn begin(&self, shown: Option<ViewScene>) -> ViewSceneMaking {
        ViewSceneMaking::Begin(match shown {
            Some(ViewScene::Particles(last)) => Some(last),
            _ => None,
        })
    }

    fn make(
        &mut self,
        of: SceneKey<SurfaceView>,
        making: &mut ViewSceneMaking,
    ) -> Option<ViewScene> {
        if of.view == SurfaceView::Picture {
            return self.shared.scene().cloned().map(ViewScene::Stones);
        }
        let is_alone = self.is_bare(of.view);
        self.make_bare(of.site, is_alone)?;
        let (_, ground) = self.bare.as_ref()?;
        if is_alone {
            return Some(ViewScene::Other(ground.first_scene()));
        }
        if let ViewSceneMaking::Begin(last) = making {
            if matches!(of.view, SurfaceView::Packed | SurfaceView::Auto) {
                return self.packed_scene(last.take());
            }
            *making = self.begun_view(of.view)?;
            return None;
        }
        let fields = || self.fresh_fields().map(|fielded| &fielded.fields);
        let done = match making {
            ViewSceneMaking::Begin(_) => false,
            ViewSceneMaking::Field(view) => view.advance(ground, fields()?),
            ViewSceneMaking::Mesh(view) => view.advance(ground, self.mesh()?),
            ViewSceneMaking::Cells(view) => view.advance(ground, &self.paved()?.cells),
            ViewSceneMaking::Map(view) => view.advance(ground, fields()?),
        };
        if !done {
            return None;
        }
        finished(std::mem::replace(making, ViewSceneMaking::Begin(None)))
    }

    fn making_key(&self, _view: &str) -> Option<SceneKey<SurfaceView>> {
        let bodies = self.standing()?;
        let (surface, _) = self.revisions();
        Some(SceneKey {
            view: SurfaceView::Picture,
            is_live: true,
            site: surface,
            revision: bodies.revision,
        })
    }

    fn step_scene(&self, _view: &str, step: (u32, usize)) -> Option<Scene> {
        self.scene_of_step(step)
    }

    fn materials(&self, subject: &ViewScene) -> Option<&'static [Material]> {
        (!matches!(subject, ViewScene::Stones(_))).then_some(&MATERIALS)
    }
}

impl Stages {
    /// Whether a view shows the bare surface alone, as there are no cells yet.
    fn is_bare(&self, view: SurfaceView) -> bool {
        matches!(view, SurfaceView::Packed | SurfaceView::Auto)
            && (self.live_packing().is_none() || self.site().is_none())
    }

    /// Works on the bare surface of this revision. `None` until it is finished; with `cut_is_enough`, until it is cut
    /// into parts.
    fn make_bare(&mut self, surface: u64, cut_is_enough: bool) -> Option<()> {
        let built = self.built.made()?;
        let new = || BareSurface::new(&built.mesh, Fit::new(&built.whole));
        let known = self.bare.take().filter(|(own, _)| *own == surface);
        let (_, bare) = self.bare.insert(known.unwrap_or_else(|| (surface, new())));
        let is_there = bare.advance(&built.mesh) || cut_is_enough && bare.is_cut();
        is_there.then_some(())
    }

    fn tones(&self) -> Tones {
        Tones::new(&self.shared.bodies.params().texture)
    }

    /// The scene of the present packing on the bare surface. `last`, an earlier scene of the packing, is updated.
    fn packed_scene(&self, last: Option<Box<Particles>>) -> Option<ViewScene> {
        let (_, ground) = self.bare.as_ref()?;
        let (packing, site) = (self.live_packing()?, self.site()?);
        let mut view = last.unwrap_or_else(|| Box::new(Particles::new(ground)));
        view.update(site, &packing.particles(), &self.tones());
        Some(ViewScene::Particles(view))
    }

    /// Begins a view that takes several slices; `None` for other views, and while there is nothing to show.
    fn begun_view(&self, view: SurfaceView) -> Option<ViewSceneMaking> {
        Some(match view {
            SurfaceView::Auto | SurfaceView::Picture | SurfaceView::Packed => return None,
            SurfaceView::Cells => {
                ViewSceneMaking::Cells(Box::new(CellsView::new(Some(&self.tones()))))
            }
            SurfaceView::Mesh => ViewSceneMaking::Mesh(Box::default()),
            SurfaceView::Direction => {
                let fielded = self.fresh_fields()?;
                let view = FieldView::new(&fielded.fields, &fielded.strokes);
                ViewSceneMaking::Field(Box::new(view))
            }
            SurfaceView::Size => {
                ViewSceneMaking::Map(Box::new(MapView::new(Quantity::Size, false)))
            }
            SurfaceView::Curvature => {
                ViewSceneMaking::Map(Box::new(MapView::new(Quantity::Mean, true)))
            }
        })
    }
}

impl SurfaceEngine {
    /// The caption of a view that is shown.
    pub(super) fn meaning(&self, words: &str) -> Option<Notice> {
        let view = SurfaceView::of_words(words);
        let (of, subject) = self.picture.shown()?;
        match (subject, view) {
            _ if of.view != view => None,
            (ViewScene::Field(_, tally), _) => {
                let code = match tally.border_index {
                    0.0 => Code::SingularPoints,
                    _ => Code::SingularBorder,
                };
                let [plus, minus] = tally.points;
                let notice = Notice::new(code).with("plus", plus).with("minus", minus);
                let notice = notice.with("sum", decimal::text_to(2, tally.index_sum));
                let notice = notice.with("border", decimal::text_to(2, tally.border_index));
                Some(notice.with("euler", tally.euler.to_string()))
            }
            (ViewScene::Map(_, ends), SurfaceView::Size) => {
                let mean = self.made.fresh_fields()?.fields.mean_size();
                Some(between(Code::SizesShown, ends.map(|size| size / mean)))
            }
            (ViewScene::Map(_, ends), _) => {
                let built = self.made.last_built()?;
                let (low, high) = built.mesh.bounds();
                let side = (high - low).max_element();
                Some(between(Code::CurvatureShown, ends.map(|bend| bend * side)))
            }
            _ => None,
        }
    }
}

fn between(code: Code, [low, high]: [f64; 2]) -> Notice {
    Notice::new(code)
        .with("low", decimal::text_to(2, low))
        .with("high", decimal::text_to(2, high))
}

/// The scene of a view whose parts are made.
fn finished(making: ViewSceneMaking) -> Option<ViewScene> {
    Some(match making {
        ViewSceneMaking::Begin(_) => return None,
        ViewSceneMaking::Field(view) => {
            let tally = view.tally();
            ViewScene::Field(view.finish(), tally)
        }
        ViewSceneMaking::Mesh(view) => ViewScene::Other(view.finish()),
        ViewSceneMaking::Cells(view) => ViewScene::Other(view.finish()),
        ViewSceneMaking::Map(view) => {
            let ends = view.legend().ends;
            ViewScene::Map(view.finish(), ends)
        }
    })
}
