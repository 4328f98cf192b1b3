//! Files as recipes name them: by the digest of their bytes, and what they are called.

use super::{Item, Key, MAX_NAME, Parameter, Recipe, rows};

/// Characters at the end of a long name that are kept.
const ENDING: usize = 8;
/// Bits of the digest in a number of a row.
const BITS: u32 = 16;

/// A file that a recipe names.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedFile {
    /// The digest of its bytes.
    pub digest: u64,
    /// Its name.
    pub name: String,
}

impl NamedFile {
    /// A file with this digest. A name longer than [`MAX_NAME`] loses characters before its ending, which tells how it
    /// is read.
    pub fn new(digest: u64, name: &str) -> Self {
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

    /// The file of a row; see [`super::Item::File`].
    fn of_row(row: &[i64]) -> Option<Self> {
        let (digest, name) = row.split_at_checked(4)?;
        let character = |&n: &i64| u32::try_from(n).ok().and_then(char::from_u32);
        Some(Self {
            digest: digest.iter().fold(0, |sum, &n| sum << BITS | n as u64),
            name: name.iter().filter_map(character).collect(),
        })
    }

    /// The row that names this file; see [`super::Item::File`].
    pub fn row(&self) -> Vec<i64> {
        let part = |k: u32| (self.digest >> (BITS * k) & ((1 << BITS) - 1)) as i64;
        let digest = [3, 2, 1, 0].map(part).into_iter();
        digest
            .chain(self.name.chars().map(|c| u32::from(c).into()))
            .collect()
    }

    /// The row that names this file, as the text of a parameter.
    pub fn text(&self) -> String {
        rows::encode(&[self.row()], Item::File.form())
    }

    /// The digest as 16 hexadecimal digits.
    pub fn digest_text(&self) -> String {
        format!("{:016x}", self.digest)
    }
}

impl Recipe {
    /// The files that a parameter names.
    pub fn files(&self, key: Key) -> Vec<NamedFile> {
        let rows = self.rows(key).iter();
        rows.filter_map(|row| NamedFile::of_row(row)).collect()
    }

    /// All files that the recipe names in parameters that are in force, each with the parameter that names it.
    pub fn named_files(&self) -> Vec<(Key, NamedFile)> {
        let counts = |row: &&Parameter| {
            let chosen = row.drawn_for;
            row.item == Some(Item::File)
                && chosen.is_none_or(|(key, word)| self.choice(key) == word)
        };
        let rows = self.schema.rows.iter().filter(counts);
        let named = rows.map(|row| (row.key, self.files(row.key)));
        named
            .flat_map(|(key, files)| files.into_iter().map(move |file| (key, file)))
            .collect()
    }
}
