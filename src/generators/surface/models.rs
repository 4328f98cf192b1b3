//! Models of files that were given: a recipe names one by its digest.

use crate::hash::Hash;
use crate::recipe::{MAX_NAME, Recipe};
use crate::surface::files::Reading;
use std::sync::Arc;

use super::schema::keys;

/// Which file a recipe asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// The digest of its bytes.
    pub digest: u64,
    /// What it was called.
    pub name: String,
}

/// Bits of the digest in a number of a row.
const BITS: u32 = 16;

impl Model {
    /// Of a file's bytes.
    pub fn of(name: &str, bytes: &[u8]) -> Self {
        let mut hash = Hash::new();
        hash.add(bytes.len() as u64);
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            hash.add(u64::from_le_bytes(word));
        }
        Self {
            digest: hash.number(),
            name: name.chars().take(MAX_NAME).collect(),
        }
    }

    /// The one that a recipe asks for.
    pub(super) fn asked(recipe: &Recipe) -> Option<Self> {
        let (digest, name) = recipe.rows(keys::MODEL).first()?.split_at_checked(4)?;
        let character = |&n: &i64| u32::try_from(n).ok().and_then(char::from_u32);
        Some(Self {
            digest: digest.iter().fold(0, |sum, &n| sum << BITS | n as u64),
            name: name.iter().filter_map(character).collect(),
        })
    }

    /// The row of it: see [`crate::recipe::Item::Model`].
    pub fn row(&self) -> Vec<i64> {
        let part = |k: u32| (self.digest >> (BITS * k) & ((1 << BITS) - 1)) as i64;
        let digest = [3, 2, 1, 0].map(part).into_iter();
        digest
            .chain(self.name.chars().map(|c| u32::from(c).into()))
            .collect()
    }

    /// The digest as text.
    pub fn digest_text(&self) -> String {
        format!("{:016x}", self.digest)
    }
}

/// The files that were given.
#[derive(Default)]
pub(super) struct Models {
    files: Vec<(u64, Arc<Vec<u8>>)>,
}

/// So many files are kept; the one given first goes first.
const KEPT: usize = 4;

impl Models {
    /// Takes a file.
    pub fn give(&mut self, digest: u64, bytes: Vec<u8>) {
        if self.find(digest).is_none() {
            if self.files.len() == KEPT {
                self.files.remove(0);
            }
            self.files.push((digest, Arc::new(bytes)));
        }
    }

    /// The bytes of a file.
    pub fn find(&self, digest: u64) -> Option<&Arc<Vec<u8>>> {
        let found = self.files.iter().find(|(of, _)| *of == digest);
        found.map(|(_, bytes)| bytes)
    }

    /// The reading of a file.
    pub fn reading(&self, model: &Model) -> Option<Result<Reading, crate::notice::Notice>> {
        let bytes = self.find(model.digest)?;
        Some(Reading::new(&model.name, bytes.clone()))
    }
}
