//! Reads, checks and mends the surfaces of the files that a recipe names, one after the other.

use super::given_files::{AskedFile, GivenFiles};
use crate::generators::MissingFile;
use crate::graph::{Inputs, Node, inputs};
use crate::modelfiles::{Reading, upright};
use crate::notice::{Code, Notice, quote};
use crate::recipe::NamedFile;
use crate::trimesh::TriMesh;
use crate::trimesh::repair::MeshRepair;
use std::sync::Arc;

/// The surfaces of files.
#[derive(Default)]
pub(crate) struct Loaded {
    /// The mended surface of each needed file.
    pub meshes: Vec<Arc<TriMesh>>,
    /// Notices about mended faults.
    pub notices: Vec<Notice>,
}

/// The files that a recipe names: those that have been given, and the surfaces in them.
pub(crate) struct ModelFiles {
    given: GivenFiles,
    /// The node of the surfaces; its inputs are [`ModelFiles::inputs`], its work is [`ModelFiles::load`].
    pub loaded: Node<Vec<AskedFile>, Loading, Loaded>,
}

impl ModelFiles {
    /// Starts with no file.
    pub fn new(asked: Vec<AskedFile>) -> Self {
        Self {
            given: GivenFiles::default(),
            loaded: Node::new(asked),
        }
    }

    /// Takes a file.
    pub fn give(&mut self, digest: u64, bytes: Vec<u8>) {
        self.given.give(digest, bytes, self.loaded.params());
    }

    /// The needed files that have not been given, even if loading has not begun yet.
    pub fn missing(&self) -> Vec<MissingFile> {
        let asked = match self.loaded.is_fresh(self.inputs()) {
            true => &[],
            false => &self.loaded.params()[..],
        };
        self.given.missing(asked).collect()
    }

    /// Waits for all files and reads none of them, for generators whose files contain other things than surfaces. Such
    /// generators call this instead of [`ModelFiles::load`], and then take the files from [`ModelFiles::bytes`].
    pub fn wait(&mut self) -> Option<()> {
        let given = &self.given;
        self.loaded.advance(|asked, _| {
            for one in asked {
                needed(one, given)?;
            }
            Ok(Some(Loaded::default()))
        })
    }

    /// The bytes of a file by its index among the needed files.
    ///
    /// # Errors
    /// If the recipe names no such file, or if the file has not been given.
    pub fn bytes(&self, number: usize) -> Result<Arc<Vec<u8>>, Notice> {
        let asked = self.loaded.params().get(number).ok_or(Code::ModelFirst)?;
        Ok(needed(asked, &self.given)?.1)
    }

    /// The number of files that are there, as the input of loading.
    pub fn inputs(&self) -> Inputs {
        inputs([self.given.count(self.loaded.params())])
    }

    /// Does one slice of loading.
    pub fn load(&mut self) -> Option<()> {
        let given = &self.given;
        self.loaded
            .advance(|asked, work| Loading::advance(asked, work, given))
    }
}

/// Surfaces that are being loaded.
#[derive(Default)]
pub(crate) struct Loading {
    loaded: Loaded,
    file: Option<LoadingFile>,
}

/// The phases of loading one file: reading it, then mending its surface.
enum LoadingFile {
    Reading(Box<Reading>),
    Mending(Box<MeshRepair>),
}

impl Loading {
    /// Does one slice of the work; returns the surfaces when all are done.
    ///
    /// # Errors
    /// If a file is missing or cannot be read.
    pub(super) fn advance(
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
                            *p = upright(*p);
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

/// A file that a recipe needs, and its bytes.
fn needed<'a>(
    asked: &'a AskedFile,
    given: &GivenFiles,
) -> Result<(&'a NamedFile, Arc<Vec<u8>>), Notice> {
    let file = asked.file.as_ref().ok_or(Code::ModelFirst)?;
    let missing = || Notice::new(Code::ModelMissing).with("name", quote(&file.name));
    Ok((file, given.bytes(file).ok_or_else(missing)?))
}

impl LoadingFile {
    fn new(asked: &AskedFile, given: &GivenFiles) -> Result<Self, Notice> {
        let (file, bytes) = needed(asked, given)?;
        let reading = Reading::new(&file.name, bytes)?;
        Ok(Self::Reading(Box::new(reading)))
    }
}
