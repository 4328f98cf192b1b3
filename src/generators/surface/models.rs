//! Models of files that were given: a recipe names one by its digest.

use crate::generators::GivenFile;
use crate::modelfiles::Reading;
use crate::recipe::{MAX_NAME, Recipe};
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

/// Characters at the end of a long name that are kept.
const ENDING: usize = 8;
/// Bits of the digest in a number of a row.
const BITS: u32 = 16;

impl Model {
    /// Of a file.
    pub fn of(file: &GivenFile) -> Self {
        Self::named(file.digest(), &file.name)
    }

    /// Of a file of this digest, with as much of its name as a row may have: its ending tells how it is read.
    pub fn named(digest: u64, name: &str) -> Self {
        let count = name.chars().count();
        let is_kept = |&(k, _): &(usize, char)| k < MAX_NAME - ENDING || k + ENDING >= count;
        let fits = count <= MAX_NAME;
        let all = name.chars().enumerate();
        let kept = all.filter(|one| fits || is_kept(one));
        Self {
            digest,
            name: kept.map(|(_, c)| c).collect(),
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

/// So many bytes of files are kept at least, and the last file; the one given first goes first.
const KEPT: usize = 1 << 26;

impl Models {
    /// Takes a file. The one that is asked for stays.
    pub fn give(&mut self, digest: u64, bytes: Vec<u8>, asked: Option<u64>) {
        if self.find(digest).is_some() {
            return;
        }
        self.files.push((digest, Arc::new(bytes)));
        let mut newer = 0;
        let mut is_kept = |(of, bytes): &(u64, Arc<Vec<u8>>)| {
            let stays = newer < KEPT || Some(*of) == asked;
            newer += bytes.len();
            stays
        };
        let kept: Vec<bool> = self.files.iter().rev().map(&mut is_kept).collect();
        let mut kept = kept.into_iter().rev();
        self.files.retain(|_| kept.next().unwrap_or(true));
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

#[cfg(test)]
mod tests {
    use super::super::SCHEMA;
    use super::*;

    fn asked(model: &Model) -> Option<Model> {
        let mut recipe = Recipe::new(&SCHEMA);
        let rows = Some(vec![model.row()]);
        SCHEMA.rules.draw(&mut recipe, keys::MODEL, rows).unwrap();
        let (again, notices) = Recipe::from_link(&[&SCHEMA], &recipe.link());
        assert_eq!(notices, []);
        Model::asked(&again)
    }

    #[test]
    fn a_row_names_the_file_again() {
        let names = ["a.obj", "", "wal fisch.glb", "鯨🐋.ply", "..,;&=%.stl"];
        for (k, name) in names.into_iter().enumerate() {
            let model = Model::named(0xFEDC_BA98_7654_3210 >> (7 * k), name);
            assert_eq!(asked(&model), Some(model));
        }
        let last = Model::named(u64::MAX, "x");
        assert_eq!(asked(&last).unwrap().digest_text(), "ffffffffffffffff");
    }

    #[test]
    fn a_long_name_keeps_its_ending() {
        let model = Model::named(1, &format!("{}.obj", "é".repeat(500)));
        assert_eq!(model.name.chars().count(), MAX_NAME);
        assert!(model.name.ends_with("é.obj"));
        assert_eq!(asked(&model), Some(model));
    }

    #[test]
    fn the_first_files_go_but_not_the_one_that_is_asked_for() {
        let mut models = Models::default();
        let large = KEPT / 2 + 1;
        for digest in 1..=4 {
            models.give(digest, vec![0; large], Some(1));
        }
        let kept = [1, 2, 3, 4].map(|digest| models.find(digest).is_some());
        assert_eq!(kept, [true, false, true, true]);
        models.give(5, vec![0; 2 * KEPT], None);
        let kept = [1, 2, 3, 4, 5].map(|digest| models.find(digest).is_some());
        assert_eq!(kept, [false, false, false, false, true]);
    }
}
