//! Reads, checks and mends the surfaces of files, one after the other.

use super::given_files::{AskedFile, GivenFiles};
use crate::modelfiles::Reading;
use crate::notice::{Code, Notice, quote};
use crate::trimesh::TriMesh;
use crate::trimesh::repair::MeshRepair;
use glam::DVec3;
use std::sync::Arc;

/// The surfaces of files.
#[derive(Default)]
pub(crate) struct Loaded {
    /// The mended surface of each needed file.
    pub meshes: Vec<Arc<TriMesh>>,
    /// Notices about mended faults.
    pub notices: Vec<Notice>,
}

/// Surfaces that are being loaded.
#[derive(Default)]
pub(crate) struct Loading {
    loaded: Loaded,
    file: Option<LoadingFile>,
}

/// The surface that is being loaded.
enum LoadingFile {
    Reading(Box<Reading>),
    Mending(Box<MeshRepair>),
}

impl Loading {
    /// Does one slice of the work; returns the surfaces when all are done.
    ///
    /// # Errors
    /// If a file is missing or cannot be read.
    pub fn advance(
        asked: &[AskedFile],
        work: &mut Option<Loading>,
        files: &GivenFiles,
    ) -> Result<Option<Loaded>, Notice> {
        let mut loading = work.take().unwrap_or_default();
        let Some(next) = asked.get(loading.loaded.meshes.len()) else {
            return Ok(Some(loading.loaded));
        };
        loading.next(next, files)?;
        if loading.loaded.meshes.len() == asked.len() {
            return Ok(Some(loading.loaded));
        }
        *work = Some(loading);
        Ok(None)
    }

    fn next(&mut self, asked: &AskedFile, files: &GivenFiles) -> Result<(), Notice> {
        match &mut self.file {
            None => self.file = Some(LoadingFile::new(asked, files)?),
            Some(LoadingFile::Reading(reading)) => {
                if let Some(soup) = reading.advance() {
                    let mut soup = soup?;
                    if asked.is_z_up {
                        for p in &mut soup.positions {
                            *p = DVec3::new(p.x, p.z, -p.y);
                        }
                    }
                    self.file = Some(LoadingFile::Mending(Box::new(MeshRepair::new(soup))));
                }
            }
            Some(LoadingFile::Mending(mending)) => {
                if let Some(mended) = mending.advance() {
                    let mended = mended?;
                    self.loaded.meshes.push(Arc::new(mended.mesh));
                    self.loaded.notices.extend(mended.notices);
                    self.file = None;
                }
            }
        }
        Ok(())
    }
}

impl LoadingFile {
    fn new(asked: &AskedFile, files: &GivenFiles) -> Result<Self, Notice> {
        let file = asked.file.as_ref().ok_or(Code::ModelFirst)?;
        let missing = || Notice::new(Code::ModelMissing).with("name", quote(&file.name));
        let reading = files.reading(file).ok_or_else(missing)??;
        Ok(Self::Reading(Box::new(reading)))
    }
}
