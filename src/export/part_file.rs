//! Files that are handed on in parts while they are made.

/// A file in the making.
pub trait PartFile {
    /// The next parts, as far as they are known before all is added.
    fn take(&mut self) -> Vec<Vec<u8>>;

    /// The rest in parts, one after the other.
    fn finish(self) -> Vec<Vec<u8>>;
}
