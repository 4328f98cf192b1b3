//! The files that recipes name, found by the digests of their bytes.

use crate::generators::MissingFile;
use crate::recipe::{Key, NamedFile, Recipe};
use std::sync::Arc;

/// A file that a recipe needs.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct AskedFile {
    /// The key of the parameter that names the file.
    pub role: &'static str,
    /// The file; `None` while the recipe names none.
    pub file: Option<NamedFile>,
    /// Whether the file's z axis points up.
    pub is_z_up: bool,
}

impl AskedFile {
    /// The file that a recipe names under a key.
    pub fn new(recipe: &Recipe, role: Key, is_z_up: bool) -> Self {
        Self {
            role: role.0,
            file: recipe.files(role).pop(),
            is_z_up,
        }
    }

    fn has_digest(&self, digest: u64) -> bool {
        self.file.as_ref().is_some_and(|file| file.digest == digest)
    }
}

/// The received files, the oldest first.
#[derive(Default)]
pub(crate) struct GivenFiles {
    files: Vec<(u64, Arc<Vec<u8>>)>,
}

/// Bytes of the newest files that are kept. An older file is dropped unless a recipe needs it.
const KEPT: usize = 1 << 26;

impl GivenFiles {
    /// Adds a file. Older files are dropped beyond [`KEPT`] bytes, but not those in `asked`.
    pub fn give(&mut self, digest: u64, bytes: Vec<u8>, asked: &[AskedFile]) {
        if self.find(digest).is_some() {
            return;
        }
        self.files.push((digest, Arc::new(bytes)));
        let mut newer = 0;
        let mut is_kept = |(digest, bytes): &(u64, Arc<Vec<u8>>)| {
            let stays = newer < KEPT || asked.iter().any(|one| one.has_digest(*digest));
            newer += bytes.len();
            stays
        };
        let kept: Vec<bool> = self.files.iter().rev().map(&mut is_kept).collect();
        let mut kept = kept.into_iter().rev();
        self.files.retain(|_| kept.next().unwrap_or(true));
    }

    fn find(&self, digest: u64) -> Option<&Arc<Vec<u8>>> {
        let found = self.files.iter().find(|(other, _)| *other == digest);
        found.map(|(_, bytes)| bytes)
    }

    /// Whether a needed file is there.
    pub fn has(&self, asked: &AskedFile) -> bool {
        let file = asked.file.as_ref();
        file.is_some_and(|file| self.find(file.digest).is_some())
    }

    /// The needed files that are not there.
    pub fn missing(&self, asked: &[AskedFile]) -> impl Iterator<Item = MissingFile> {
        let missing = asked.iter().filter(|one| !self.has(one));
        missing.map(|AskedFile { role, file, .. }| MissingFile {
            role,
            digest: file.as_ref().map_or(String::new(), NamedFile::digest_text),
            name: file
                .as_ref()
                .map_or(String::new(), |file| file.name.clone()),
        })
    }

    /// The number of needed files that are there.
    pub fn count(&self, asked: &[AskedFile]) -> u64 {
        asked.iter().filter(|one| self.has(one)).count() as u64
    }

    /// The bytes of a file; `None` if the file is not there.
    pub fn bytes(&self, file: &NamedFile) -> Option<Arc<Vec<u8>>> {
        self.find(file.digest).cloned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_files_go_but_not_those_that_are_asked_for() {
        let asked = [1, 2].map(|digest| AskedFile {
            role: "model",
            file: Some(NamedFile::new(digest, "")),
            is_z_up: false,
        });
        let mut files = GivenFiles::default();
        let large = KEPT / 2 + 1;
        for digest in 1..=5 {
            files.give(digest, vec![0; large], &asked);
        }
        let kept = [1, 2, 3, 4, 5].map(|digest| files.find(digest).is_some());
        assert_eq!(kept, [true, true, false, true, true]);
        files.give(6, vec![0; 2 * KEPT], &asked[1..]);
        let kept = [1, 2, 5, 6].map(|digest| files.find(digest).is_some());
        assert_eq!(kept, [false, true, false, true]);
        assert_eq!(files.count(&asked), 1);
    }
}
