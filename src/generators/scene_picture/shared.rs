//! The nodes that all generators of bodies in space have: files at the beginning, bodies and the picture at the end.

use super::given_files::AskedFile;
use super::loading::ModelFiles;
use super::still::{MadeScene, StillNode, StillParams, StillRender};
use crate::graph::Node;
use crate::scene::Scene;
use std::rc::Rc;

/// The nodes at the beginning and the end. `P` are the parameters of the bodies, `W` is the work on the bodies.
pub(crate) struct SharedNodes<P, W> {
    /// The files that the recipe names.
    pub files: ModelFiles,
    /// The finished bodies.
    pub bodies: Node<P, W, MadeScene>,
    /// The finished picture.
    pub still: StillNode,
}

impl<P: Clone + PartialEq, W> SharedNodes<P, W> {
    /// Starts with nothing made.
    pub fn new(files: Vec<AskedFile>, bodies: P, still: StillParams) -> Self {
        Self {
            files: ModelFiles::new(files),
            bodies: Node::new(bodies),
            still: Node::new(still),
        }
    }

    /// Notes the parameters of the latest recipe.
    pub fn ask(&mut self, files: Vec<AskedFile>, bodies: P, still: StillParams) {
        self.files.loaded.ask(files);
        self.bodies.ask(bodies);
        self.still.ask(still);
    }

    /// The last scene of finished bodies.
    pub fn scene(&self) -> Option<&Rc<Scene>> {
        self.bodies.made().map(|bodies| &bodies.scene)
    }

    /// The digest of the last scene of finished bodies; empty before there is one.
    pub fn digest(&self) -> String {
        let bodies = self.bodies.made();
        bodies.map_or(String::new(), |bodies| bodies.digest.clone())
    }

    /// Does one slice of the picture.
    pub fn draw(&mut self) -> Option<()> {
        let scene = &self.bodies.made()?.scene;
        StillRender::draw(&mut self.still, scene)
    }

    /// The last finished picture; empty before there is one.
    pub fn picture(&self) -> &[u8] {
        self.still.made().map_or(&[], Vec::as_slice)
    }
}
