//! The surface of a file: read, checked, mended.

use super::models::{Model, Models};
use crate::modelfiles::Reading;
use crate::notice::{Code, Notice, quote};
use crate::trimesh::TriMesh;
use crate::trimesh::repair::Mending;
use glam::DVec3;
use std::sync::Arc;

/// A file's surface, mended, and what was said of it.
#[derive(Default)]
pub(super) struct Loaded {
    pub mesh: Option<Arc<TriMesh>>,
    pub notices: Vec<Notice>,
}

/// A file's surface in the making.
pub(super) enum Loading {
    Reading(Box<Reading>),
    Mending(Box<Mending>),
}

impl Loading {
    /// One slice. `model` is the file asked for, and whether z is up in it; nothing for surfaces by rule.
    ///
    /// # Errors
    /// Where it is not there, or cannot be read.
    pub fn advance(
        model: &Option<(Option<Model>, bool)>,
        work: &mut Option<Loading>,
        models: &Models,
    ) -> Result<Option<Loaded>, Notice> {
        let Some((model, is_z_up)) = model else {
            return Ok(Some(Loaded::default()));
        };
        let model = model.as_ref().ok_or(Code::ModelFirst)?;
        match work {
            None => {
                let missing = || Notice::new(Code::ModelMissing).with("name", quote(&model.name));
                let reading = models.reading(model).ok_or_else(missing)??;
                *work = Some(Loading::Reading(Box::new(reading)));
            }
            Some(Loading::Reading(reading)) => {
                if let Some(soup) = reading.advance() {
                    let mut soup = soup?;
                    if *is_z_up {
                        for p in &mut soup.positions {
                            *p = DVec3::new(p.x, p.z, -p.y);
                        }
                    }
                    *work = Some(Loading::Mending(Box::new(Mending::new(soup))));
                }
            }
            Some(Loading::Mending(mending)) => {
                if let Some(mended) = mending.advance() {
                    let mended = mended?;
                    return Ok(Some(Loaded {
                        mesh: Some(Arc::new(mended.mesh)),
                        notices: mended.notices,
                    }));
                }
            }
        }
        Ok(None)
    }
}
