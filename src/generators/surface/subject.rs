//! Scenes of the views of a surface, made in slices.

use super::Surface;
use super::views::View;
use crate::draw::Tones;
use crate::generators::scene_picture::{ScenePicture, SceneSource, StillParams};
use crate::graph::Wiring;
use crate::material::Material;
use crate::notice::{Code, Notice};
use crate::scene::Scene;
use crate::surface_stones::Fit;
use crate::surface_views::{
    CellsView, FieldView, Ground, MATERIALS, MapView, MeshView, Particles, Quantity, Tally,
};
use std::rc::Rc;

/// The key of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Of {
    pub view: View,
    /// The revision of its surface.
    pub surface: u64,
    /// The revision of the shown results on it.
    pub revision: u64,
}

/// A scene.
pub(crate) enum Subject {
    Stones(Rc<Scene>),
    Particles(Box<Particles>),
    Field(Scene, Tally),
    Map(Scene, [f64; 2]),
    Other(Scene),
}

impl AsRef<Scene> for Subject {
    fn as_ref(&self) -> &Scene {
        match self {
            Self::Stones(scene) => scene,
            Self::Particles(particles) => particles.scene(),
            Self::Field(scene, _) | Self::Map(scene, _) | Self::Other(scene) => scene,
        }
    }
}

/// A scene in progress.
pub(crate) enum Making {
    Begin(Option<Box<Particles>>),
    Field(Box<FieldView>),
    Mesh(Box<MeshView>),
    Cells(Box<CellsView>),
    Map(Box<MapView>),
}

impl SceneSource for Surface {
    type Key = Of;
    type Subject = Subject;
    type Making = Making;

    fn scene_picture(&mut self) -> &mut ScenePicture<Self> {
        &mut self.picture
    }

    fn key(&self, view: &str) -> Option<Of> {
        let view = View::of_words(view);
        let made = &self.made;
        let (surface, revision) = made.revisions();
        let is_packed = made.live_packing().is_some();
        let view = match view {
            View::Auto if made.has_stones() => View::Picture,
            View::Auto => View::Packed,
            other => other,
        };
        let revision = match view {
            View::Picture => made.scene().map(|(_, revision)| revision),
            // The bare surface is seen until there is a packing.
            View::Packed | View::Auto if made.packing().is_none() => made.last_built().map(|_| 0),
            View::Packed | View::Auto => is_packed.then(|| made.changes()),
            View::Cells => made.paved().map(|_| revision.cells),
            View::Mesh => made.mesh().map(|_| revision.mesh),
            View::Direction | View::Size | View::Curvature => {
                made.fresh_fields().map(|_| revision.fields)
            }
        };
        Some(Of {
            view,
            surface,
            revision: revision?,
        })
    }

    fn is_later(&self, before: Of, after: Of) -> bool {
        before.view == after.view && before.surface == after.surface
    }

    fn begin(&self, of: Of, shown: &mut Option<(Of, Subject)>) -> Making {
        let goes_on = |(before, subject): &mut (Of, Subject)| {
            matches!(subject, Subject::Particles(_)) && self.is_later(*before, of)
        };
        match shown.take_if(goes_on) {
            Some((_, Subject::Particles(last))) => Making::Begin(Some(last)),
            _ => Making::Begin(None),
        }
    }

    fn make(&mut self, of: Of, making: &mut Making) -> Option<Subject> {
        let made = &self.made;
        if of.view == View::Picture {
            return made
                .scene()
                .map(|(scene, _)| Subject::Stones(scene.clone()));
        }
        let built = made.last_built()?;
        let is_old = self
            .ground
            .as_ref()
            .is_none_or(|(surface, _)| *surface != of.surface);
        if is_old {
            self.ground = Some((of.surface, Ground::new(&built.mesh, Fit::new(&built.whole))));
        }
        let (_, ground) = self.ground.as_mut()?;
        if !ground.advance(&built.mesh) {
            return None;
        }
        let tones = || Tones::new(&self.made.stones.params().texture);
        if let Making::Begin(last) = making {
            let last = last.take();
            *making = match of.view {
                View::Packed | View::Auto | View::Picture => {
                    let (Some(packing), Some(site)) = (made.live_packing(), made.site()) else {
                        return Some(Subject::Other(ground.scene()));
                    };
                    let mut view = last.unwrap_or_else(|| Box::new(Particles::new(ground)));
                    view.update(site, &packing.particles(), &tones());
                    return Some(Subject::Particles(view));
                }
                View::Cells => Making::Cells(Box::new(CellsView::new(Some(&tones())))),
                View::Mesh => Making::Mesh(Box::default()),
                View::Direction => {
                    let fielded = made.fresh_fields()?;
                    Making::Field(Box::new(FieldView::new(&fielded.fields, &fielded.strokes)))
                }
                View::Size => Making::Map(Box::new(MapView::new(Quantity::Size, false))),
                View::Curvature => Making::Map(Box::new(MapView::new(Quantity::Mean, true))),
            };
            return None;
        }
        let fields = || made.fresh_fields().map(|fielded| &fielded.fields);
        let done = match making {
            Making::Begin(_) => false,
            Making::Field(view) => view.advance(ground, fields()?),
            Making::Mesh(view) => view.advance(ground, made.mesh()?),
            Making::Cells(view) => view.advance(ground, &made.paved()?.cells),
            Making::Map(view) => view.advance(ground, fields()?),
        };
        if !done {
            return None;
        }
        Some(match std::mem::replace(making, Making::Begin(None)) {
            Making::Begin(_) => return None,
            Making::Field(view) => {
                let tally = view.tally();
                Subject::Field(view.finish(), tally)
            }
            Making::Mesh(view) => Subject::Other(view.finish()),
            Making::Cells(view) => Subject::Other(view.finish()),
            Making::Map(view) => {
                let ends = view.legend().ends;
                Subject::Map(view.finish(), ends)
            }
        })
    }

    fn still(&self) -> StillParams {
        self.made.still.params().clone()
    }

    fn materials(&self, subject: &Subject) -> Option<&'static [Material]> {
        (!matches!(subject, Subject::Stones(_))).then_some(&MATERIALS)
    }

    fn finished(&self, view: &str) -> Option<&[u8]> {
        let is_picture = matches!(View::of_words(view), View::Auto | View::Picture);
        (is_picture && self.made.at().is_none()).then(|| self.made.picture())
    }
}

impl Surface {
    /// The caption of a view that is shown.
    pub(super) fn caption_of(&self, words: &str) -> Option<Notice> {
        let view = View::of_words(words);
        let (of, subject) = self.picture.shown()?;
        match (subject, view) {
            _ if of.view != view => None,
            (Subject::Field(_, tally), _) => {
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
            (Subject::Map(_, ends), View::Size) => {
                let mean = self.made.fresh_fields()?.fields.mean_size();
                Some(between(Code::SizesShown, ends.map(|size| size / mean)))
            }
            (Subject::Map(_, ends), _) => {
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
