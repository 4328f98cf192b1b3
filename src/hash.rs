//! Digests of results.

/// FNV-1a on words of 64 bits, finished as SplitMix64.
#[derive(Clone)]
pub(crate) struct Hash(u64);

impl Hash {
    pub fn new() -> Self {
        Self(0xCBF2_9CE4_8422_2325)
    }

    pub fn add(&mut self, word: u64) {
        let mixed = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01B3);
        // Plain FNV on whole words would never carry high bits down, so they are mixed in here.
        self.0 = mixed ^ (mixed >> 29);
    }

    /// A number that changes with any bit of any word.
    pub fn number(&self) -> u64 {
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z ^ (z >> 27)
    }

    /// The number as 16 hex digits.
    pub fn text(&self) -> String {
        format!("{:016x}", self.number())
    }
}
