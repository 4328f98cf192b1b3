//! Files that recipes name. Files arrive in pieces, so that no call takes long for the digest.

use crate::hash::Hash;
use crate::notice::{Code, Notice};
use crate::recipe::{Key, NamedFile, Recipe, Rows, Rules};

/// Bytes of a word of the digest.
const WORD: usize = 8;

/// The most bytes that are reserved for a file, whatever size is announced.
const BELIEVED: usize = 1 << 29;

/// The digest of a file, while its bytes arrive.
#[derive(Clone)]
pub struct FileDigest {
    hash: Hash,
    /// The last bytes, `filled` in number, which do not fill a word yet; zeros follow.
    rest: [u8; WORD],
    filled: usize,
}

impl FileDigest {
    /// Starts the digest of a file with `size` bytes.
    pub fn new(size: usize) -> Self {
        let mut hash = Hash::new();
        hash.add(size as u64);
        Self {
            hash,
            rest: [0; WORD],
            filled: 0,
        }
    }

    /// Adds some more bytes.
    pub fn add(&mut self, mut piece: &[u8]) {
        if self.filled > 0 {
            let some = piece.len().min(WORD - self.filled);
            let (head, tail) = piece.split_at(some);
            self.rest[self.filled..self.filled + some].copy_from_slice(head);
            (self.filled, piece) = (self.filled + some, tail);
            if self.filled < WORD {
                return;
            }
            self.hash.add(u64::from_le_bytes(self.rest));
        }
        let words = piece.chunks_exact(WORD);
        let rest = words.remainder();
        for bytes in words {
            let mut word = [0; WORD];
            word.copy_from_slice(bytes);
            self.hash.add(u64::from_le_bytes(word));
        }
        self.rest = [0; WORD];
        self.rest[..rest.len()].copy_from_slice(rest);
        self.filled = rest.len();
    }

    /// A number that changes with any bit of the bytes so far.
    pub fn number(&self) -> u64 {
        let mut hash = self.hash.clone();
        if self.filled > 0 {
            hash.add(u64::from_le_bytes(self.rest));
        }
        hash.number()
    }
}

/// A rule beyond single rows: naming a file sets a choice to the word `file`. The function maps the key of the file to
/// the key of that choice.
pub(super) struct FileRules(pub fn(Key) -> Key);

impl Rules for FileRules {
    /// # Errors
    /// If there is not exactly one file; the recipe is unchanged.
    fn draw(
        &self,
        recipe: &mut Recipe,
        key: Key,
        rows: Option<Rows>,
    ) -> Result<Vec<Notice>, Notice> {
        let rows = rows
            .filter(|rows| rows.len() == 1)
            .ok_or(Code::ModelFirst)?;
        recipe.set_rows(key, rows)?;
        recipe.choose((self.0)(key), "file");
        Ok(Vec::new())
    }
}

/// A file that the work waits for.
#[derive(Clone, Debug, PartialEq)]
pub struct MissingFile {
    /// The key of the recipe's parameter that names it.
    pub role: &'static str,
    /// Its digest as 16 hexadecimal digits; empty while the recipe names no file.
    pub digest: String,
    /// Its name; empty while the recipe names no file.
    pub name: String,
}

/// A file with its name.
pub struct GivenFile {
    /// The file's name.
    pub name: String,
    bytes: Vec<u8>,
    size: usize,
    digest: FileDigest,
}

impl GivenFile {
    /// A file of `size` bytes, none of which has arrived.
    pub fn begin(name: &str, size: usize) -> Self {
        Self {
            name: name.to_owned(),
            bytes: Vec::new(),
            size,
            digest: FileDigest::new(size),
        }
    }

    /// A complete file.
    pub fn whole(name: &str, bytes: Vec<u8>) -> Self {
        let mut file = Self::begin(name, bytes.len());
        file.digest.add(&bytes);
        file.bytes = bytes;
        file
    }

    /// Adds some more bytes.
    pub fn add(&mut self, piece: &[u8]) {
        if self.bytes.is_empty() {
            self.bytes.reserve_exact(self.size.min(BELIEVED));
        }
        self.bytes.extend_from_slice(piece);
        self.digest.add(piece);
    }

    /// The digest of the bytes that have arrived.
    pub fn digest(&self) -> u64 {
        self.digest.number()
    }

    /// The file as recipes name it.
    pub fn named(&self) -> NamedFile {
        NamedFile::new(self.digest(), &self.name)
    }

    /// Its bytes.
    pub fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_digest_is_the_same_whatever_the_pieces() {
        let bytes: Vec<u8> = (0..1000u32).map(|k| (k * k % 251) as u8).collect();
        let whole = GivenFile::whole("a.obj", bytes.clone()).digest();
        for size in [1, 3, 7, 8, 9, 333, 1000] {
            let mut file = GivenFile::begin("b.obj", bytes.len());
            for piece in bytes.chunks(size) {
                file.add(piece);
            }
            assert_eq!(file.digest(), whole, "{size}");
            assert_eq!(file.into_bytes(), bytes);
        }
    }

    #[test]
    fn the_digest_tells_any_byte_and_the_length() {
        let digest = |bytes: &[u8]| GivenFile::whole("", bytes.to_vec()).digest();
        let bytes = [7; 21];
        for k in 0..bytes.len() {
            let mut other = bytes;
            other[k] ^= 1;
            assert_ne!(digest(&other), digest(&bytes), "{k}");
        }
        assert_ne!(digest(&[0; 8]), digest(&[0; 9]));
        assert_ne!(digest(&[]), digest(&[0]));
    }
}
