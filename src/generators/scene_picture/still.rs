//! The picture: the bodies seen by the generator's camera, drawn in slices.

use super::yaw::{seen_by, turned};
use crate::generators::lighting::LightParams;
use crate::generators::rows::shared;
use crate::generators::turntable::ViewSetup;
use crate::graph::Node;
use crate::notice::Notice;
use crate::recipe::Recipe;
use crate::scene::{Backdrop, Camera, Frame, Order, SAMPLES, Scene, Sharpness, SoftLight};
use std::rc::Rc;

/// The amount of work in one slice: drawn triangles or shaded pixels.
const SLICE: usize = 6_000;

/// Camera and light of the picture.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StillParams {
    /// The camera for a scene that is not turned.
    pub camera: Camera,
    pub light: LightParams,
    /// The degrees by which the scene is turned, clockwise seen from above.
    pub yaw: f64,
    /// Pixels along the picture's side.
    pub side: usize,
}

impl StillParams {
    /// The parameters of a recipe, whose generator has this first camera.
    pub fn new(recipe: &Recipe, camera: Camera, light: LightParams) -> Self {
        Self {
            camera,
            light,
            yaw: recipe.number(shared::keys::YAW),
            side: shared::side(recipe),
        }
    }
}

/// The node of the finished picture.
pub(crate) type StillNode = Node<StillParams, StillRender, Vec<u8>>;

/// A finished scene.
pub(crate) struct MadeScene {
    pub scene: Rc<Scene>,
    /// The digest of the scene.
    pub digest: String,
    /// The revision of the result that the scene shows, such as the packing.
    pub shows: u64,
}

impl MadeScene {
    /// A finished scene; `shows` is the revision of the result that it shows.
    pub fn new(scene: Rc<Scene>, shows: u64) -> Self {
        Self {
            digest: scene.digest(),
            scene,
            shows,
        }
    }
}

/// An unfinished picture.
pub(crate) struct StillRender {
    scene: Rc<Scene>,
    light: SoftLight,
    frame: Frame,
}

impl StillRender {
    /// Does one slice of the picture of a scene, as the work of its node.
    pub fn draw(node: &mut StillNode, scene: &Rc<Scene>) -> Option<()> {
        node.advance(|params, work| {
            work.get_or_insert_with(|| Self::new(params, scene.clone()))
                .advance()
        })
    }

    /// A picture without anything drawn yet.
    pub(super) fn new(params: &StillParams, scene: Rc<Scene>) -> Self {
        let order = Order {
            camera: turned(params.camera, params.yaw),
            size: [params.side; 2],
            samples: SAMPLES,
            aperture: 0.0,
            is_moving: false,
            backdrop: Backdrop::Floor,
            cut: None,
        };
        let light = seen_by(&params.light, params.yaw);
        let stand = ViewSetup {
            scene: &scene,
            number: 0,
            light: &light,
            ground: None,
        };
        Self {
            light: SoftLight::new(stand.lighting(Sharpness::of(&order), None)),
            frame: Frame::new(order),
            scene,
        }
    }

    /// Does one slice of the work; returns the picture when it is finished.
    pub(super) fn advance(&mut self) -> Result<Option<Vec<u8>>, Notice> {
        let light = self.light.of_sample(self.frame.sample(), &self.scene);
        let lit = light.advance(&self.scene, SLICE);
        let done = lit && self.frame.advance(&self.scene, light, SLICE);
        Ok(done.then(|| self.frame.rgba().to_vec()))
    }
}
