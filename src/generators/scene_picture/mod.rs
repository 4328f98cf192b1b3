//! The finisher of scenes: the picture, frames of a moving camera, pictures of views, files of bodies, and files that
//! recipes name. The stages of a generator implement [`SceneSource`] and [`SceneStages`]; a [`SceneEngine`] has these
//! stages, their pictures, and the interfaces of an engine.

mod engine;
mod files;
mod given_files;
mod loading;
mod near;
mod picture;
mod shared;
mod still;
// The tests read files with a library that only native builds have.
#[cfg(all(test, not(target_arch = "wasm32")))]
mod file_tests;
#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests;
mod view;
mod yaw;

pub(crate) use engine::{SceneEngine, SceneFacts, SceneStages};
pub(crate) use files::Saving;
pub(crate) use given_files::AskedFile;
pub(crate) use loading::Loaded;
pub(crate) use near::seen_near;
pub(crate) use picture::{SceneKey, SceneSource};
pub(crate) use shared::SharedNodes;
pub(crate) use still::{MadeScene, StillParams};
pub(crate) use view::view_of;
