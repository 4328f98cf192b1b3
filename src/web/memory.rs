//! The module's memory.

use core::arch::wasm32::memory_size;
use std::hint::black_box;

/// Bytes of a page of memory.
const PAGE: usize = 1 << 16;
/// A memory of up to this many bytes grows quickly.
const SMALL: usize = 48 << 20;
/// The part of the memory by which it grows at least.
const PART: usize = 8;

/// Lets the memory grow in large steps. The allocator takes only as much as it lacks, mostly one page. Where the memory has
/// more than 64 MB, each such step takes V8 half a millisecond and more, which was half of the time of a large building.
#[derive(Default)]
pub(super) struct Memory {
    /// Its size when room was last made.
    size: usize,
}

impl Memory {
    /// Makes room if the memory has grown. To be called before a slice of work.
    pub fn make_room(&mut self) {
        let now = memory_size::<0>() * PAGE;
        if now <= self.size.max(SMALL) {
            return;
        }
        let mut room = Vec::<u8>::new();
        // Without room, the work goes on, and may need none.
        let has_room = room.try_reserve_exact(now / PART).is_ok();
        // The freed room stays at the end of the memory, for later use. The compiler must not leave it out.
        drop(black_box((room, has_room)));
        self.size = memory_size::<0>() * PAGE;
    }
}
