//! A map of floats as an OpenEXR file: one part of scan lines, one channel Y, uncompressed (OpenEXR File Layout,
//! Academy Software Foundation).
//!
//! Only native programs use it. The page has its own writer in `www/take/files/exr.ts`, which keeps the module small.

use super::Map;
use super::bytes::put;

/// The head without its two windows: attributes with their types and lengths. Then the windows without their last
/// corners.
const HEAD: &[u8] = b"\x76\x2f\x31\x01\x02\0\0\0\
    channels\0chlist\0\x13\0\0\0Y\0\x02\0\0\0\0\0\0\0\x01\0\0\0\x01\0\0\0\0\
    compression\0compression\0\x01\0\0\0\0\
    lineOrder\0lineOrder\0\x01\0\0\0\0\
    pixelAspectRatio\0float\0\x04\0\0\0\0\0\x80\x3f\
    screenWindowCenter\0v2f\0\x08\0\0\0\0\0\0\0\0\0\0\0\
    screenWindowWidth\0float\0\x04\0\0\0\0\0\x80\x3f";
const WINDOWS: [&[u8]; 2] = [
    b"dataWindow\0box2i\0\x10\0\0\0\0\0\0\0\0\0\0\0",
    b"displayWindow\0box2i\0\x10\0\0\0\0\0\0\0\0\0\0\0",
];

/// The file of a map of one channel of 32 bits.
pub fn exr(map: &Map) -> Vec<u8> {
    let side = map.side as u32;
    let last = side.saturating_sub(1);
    let mut out = HEAD.to_vec();
    for window in WINDOWS {
        out.extend_from_slice(window);
        put(&mut out, &[last, last]);
    }
    // The head ends with an empty name. A table of the lines' offsets follows, each in 64 bits.
    out.push(0);
    let (begin, row) = (out.len() as u32 + 8 * side, 4 * side);
    for y in 0..side {
        put(&mut out, &[begin + y * (8 + row), 0]);
    }
    for y in 0..side {
        put(&mut out, &[y, row]);
        let bytes = &map.bytes[(y * row) as usize..][..row as usize];
        // Maps have the high byte first.
        let words = bytes
            .chunks_exact(4)
            .map(|b| u32::from_be_bytes([b[0], b[1], b[2], b[3]]));
        words.for_each(|word| put(&mut out, &[word]));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_where_the_table_says() {
        let values = [1.0f32, 2.0, -0.5, 1e-3];
        let map = Map {
            side: 2,
            channels: 1,
            bits: 32,
            bytes: values.iter().flat_map(|v| v.to_be_bytes()).collect(),
        };
        let file = exr(&map);
        let word = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap());
        let table = file.len() - 2 * 8 - 2 * 16;
        for y in 0..2 {
            let at = word(table + 8 * y) as usize;
            assert_eq!((word(at), word(at + 4)), (y as u32, 8));
            let read = [0, 4].map(|k| f32::from_bits(word(at + 8 + k)));
            assert_eq!(read, values[2 * y..][..2]);
        }
    }
}
