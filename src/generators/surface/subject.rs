//! Scenes of the views of a surface, made in slices.

use super::SurfaceEngine;
use super::views::SurfaceView;
use crate::draw::Tones;
use crate::generators::scene_picture::{ScenePicture, SceneSource, SceneStages, StillParams};
use crate::graph::Wiring;
use crate::material::Material;
use crate::notice::{Code, Notice};
use crate::scene::Scene;
use crate::surface_stones::Fit;
use crate::surface_views::{
    BareSurface, CellsView, FieldView, MATERIALS, MapView, MeshView, Particles, Quantity, Tally,
};
use std::rc::Rc;

/// The key of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SceneInputs {
    pub view: SurfaceView,
    /// The revision of its surface.
    pub surface: u64,
    /// The revision of the shown results on it.
    pub revision: u64,
}

/// A scene.
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

/// A scene in progress.
pub(crate) enum ViewSceneMaking {
    Begin(Option<Box<Particles>>),
    Field(Box<FieldView>),
    Mesh(Box<MeshView>),
    Cells(Box<CellsView>),
    Map(Box<MapView>),
}

impl SceneSource for SurfaceEngine {
    type Key = SceneInputs;
    type Subject = ViewScene;
    type Making = ViewSceneMaking;

    fn scene_picture(&mut self) -> &mut ScenePicture<Self> {
        &mut self.picture
    }

    fn key(&self, view: &str) -> Option<SceneInputs> {
        let view = SurfaceView::of_words(view);
        let made = &self.made;
        let (surface, revision) = made.revisions();
        let is_packed = made.live_packing().is_some();
        let view = match view {
            SurfaceView::Auto if made.has_scene_of(&made.packing) => SurfaceView::Picture,
            SurfaceView::Auto => SurfaceView::Packed,
            other => other,
        };
        let revision = match view {
            SurfaceView::Picture => made.scene().map(|(_, revision)| revision),
            // The bare surface is seen until there is a packing.
            SurfaceView::Packed | SurfaceView::Auto if made.packing().is_none() => {
                made.last_built().map(|_| 0)
            }
            SurfaceView::Packed | SurfaceView::Auto => is_packed.then(|| made.changes()),
            SurfaceView::Cells => made.paved().map(|_| revision.cells),
            SurfaceView::Mesh => made.mesh().map(|_| revision.mesh),
            SurfaceView::Direction | SurfaceView::Size | SurfaceView::Curvature => {
                made.fresh_fields().map(|_| revision.fields)
            }
        };
        Some(SceneInputs {
            view,
            surface,
            revision: revision?,
        })
    }

    fn is_later(&self, before: SceneInputs, after: SceneInputs) -> bool {
        before.view == after.view && before.surface == after.surface
    }

    fn begin(
        &self,
        of: SceneInputs,
        shown: &mut Option<(SceneInputs, ViewScene)>,
    ) -> ViewSceneMaking {
        let goes_on = |(before, subject): &mut (SceneInputs, ViewScene)| {
            matches!(subject, ViewScene::Particles(_)) && self.is_later(*before, of)
        };
        match shown.take_if(goes_on) {
            Some((_, ViewScene::Particles(last))) => ViewSceneMaking::Begin(Some(last)),
            _ => ViewSceneMaking::Begin(None),
        }
    }

    fn make(&mut self, of: SceneInputs, making: &mut ViewSceneMaking) -> Option<ViewScene> {
        let made = &self.made;
        if of.view == SurfaceView::Picture {
            return made.shared.scene().cloned().map(ViewScene::Stones);
        }
        let built = made.last_built()?;
        let is_old = self
            .ground
            .as_ref()
            .is_none_or(|(surface, _)| *surface != of.surface);
        if is_old {
            self.ground = Some((
                of.surface,
                BareSurface::new(&built.mesh, Fit::new(&built.whole)),
            ));
        }
        let (_, ground) = self.ground.as_mut()?;
        if !ground.advance(&built.mesh) {
            return None;
        }
        let tones = || Tones::new(&self.made.shared.bodies.params().texture);
        if let ViewSceneMaking::Begin(last) = making {
            let last = last.take();
            *making = match of.view {
                SurfaceView::Packed | SurfaceView::Auto | SurfaceView::Picture => {
                    let (Some(packing), Some(site)) = (made.live_packing(), made.site()) else {
                        return Some(ViewScene::Other(ground.scene()));
                    };
                    let mut view = last.unwrap_or_else(|| Box::new(Particles::new(ground)));
                    view.update(site, &packing.particles(), &tones());
                    return Some(ViewScene::Particles(view));
                }
                SurfaceView::Cells => {
                    ViewSceneMaking::Cells(Box::new(CellsView::new(Some(&tones()))))
                }
                SurfaceView::Mesh => ViewSceneMaking::Mesh(Box::default()),
                SurfaceView::Direction => {
                    let fielded = made.fresh_fields()?;
                    ViewSceneMaking::Field(Box::new(FieldView::new(
                        &fielded.fields,
                        &fielded.strokes,
                    )))
                }
                SurfaceView::Size => {
                    ViewSceneMaking::Map(Box::new(MapView::new(Quantity::Size, false)))
                }
                SurfaceView::Curvature => {
                    ViewSceneMaking::Map(Box::new(MapView::new(Quantity::Mean, true)))
                }
            };
            return None;
        }
        let fields = || made.fresh_fields().map(|fielded| &fielded.fields);
        let done = match making {
            ViewSceneMaking::Begin(_) => false,
            ViewSceneMaking::Field(view) => view.advance(ground, fields()?),
            ViewSceneMaking::Mesh(view) => view.advance(ground, made.mesh()?),
            ViewSceneMaking::Cells(view) => view.advance(ground, &made.paved()?.cells),
            ViewSceneMaking::Map(view) => view.advance(ground, fields()?),
        };
        if !done {
            return None;
        }
        finished(std::mem::replace(making, ViewSceneMaking::Begin(None)))
    }

    fn making_key(&self) -> Option<SceneInputs> {
        let bodies = self.made.standing()?;
        let (surface, _) = self.made.revisions();
        Some(SceneInputs {
            view: SurfaceView::Picture,
            surface,
            revision: bodies.revision,
        })
    }

    fn step_scene(&self, step: (u32, usize)) -> Option<Scene> {
        self.scene_of_step(step)
    }

    fn still(&self) -> StillParams {
        self.made.shared.still.params().clone()
    }

    fn materials(&self, subject: &ViewScene) -> Option<&'static [Material]> {
        (!matches!(subject, ViewScene::Stones(_))).then_some(&MATERIALS)
    }

    fn finished(&self, view: &str) -> Option<&[u8]> {
        let is_picture = matches!(
            SurfaceView::of_words(view),
            SurfaceView::Auto | SurfaceView::Picture
        );
        (is_picture && self.made.at().is_none()).then(|| self.made.shared.picture())
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
                let notice = notice.with("sum", text(tally.index_sum));
                let notice = notice.with("border", text(tally.border_index));
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
        .with("low", text(low))
        .with("high", text(high))
}

/// A number with at most two decimals.
fn text(number: f64) -> String {
    crate::decimal::text((number * 100.0).round() / 100.0)
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
