//! Files that are handed over in parts while they are made.

/// A file that is being made.
pub trait PartFile {
    /// The next parts, as far as they are complete.
    fn take(&mut self) -> Vec<Vec<u8>>;

    /// The rest of the file, in parts.
    fn finish(self) -> Vec<Vec<u8>>;
}
