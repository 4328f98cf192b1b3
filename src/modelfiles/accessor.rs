//! Views of the numbers in a GLB file.

use super::glb_notices::{broken, needs};
use super::json::Json;
use crate::notice::{Code, Notice};

/// A view of numbers: `count` groups, one every `stride` bytes.
#[derive(Clone, Copy)]
pub(super) struct BufferView {
    pub start: usize,
    pub stride: usize,
    pub count: usize,
    pub kind: ComponentType,
    pub is_normalized: bool,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum ComponentType {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl ComponentType {
    fn of(number: usize) -> Option<Self> {
        Some(match number {
            5120 => ComponentType::I8,
            5121 => ComponentType::U8,
            5122 => ComponentType::I16,
            5123 => ComponentType::U16,
            5125 => ComponentType::U32,
            5126 => ComponentType::F32,
            _ => return None,
        })
    }

    pub fn bytes(self) -> usize {
        match self {
            ComponentType::I8 | ComponentType::U8 => 1,
            ComponentType::I16 | ComponentType::U16 => 2,
            ComponentType::U32 | ComponentType::F32 => 4,
        }
    }
}

impl BufferView {
    /// The view of accessor `number`, whose groups must have `group` components: 3 or 1. `bytes` is the length of the
    /// file's binary chunk.
    ///
    /// # Errors
    /// If the accessor is invalid, or needs a feature that cannot be read.
    pub fn of_accessor(
        (json, bytes): (&Json, usize),
        number: usize,
        group: usize,
    ) -> Result<Self, Notice> {
        let bad = || broken("accessor", number);
        let accessor = json.list_of("accessors").get(number).ok_or_else(bad)?;
        if accessor.get("sparse").is_some() {
            return Err(needs(Code::FileNeeds, "sparse"));
        }
        let at = accessor.index_of("bufferView").ok_or_else(bad)?;
        let view = json.list_of("bufferViews").get(at).ok_or_else(bad)?;
        let buffer = view.index_of("buffer").ok_or_else(bad)?;
        let buffers = json.list_of("buffers");
        let uri = buffers.get(buffer).ok_or_else(bad)?.get("uri");
        if uri.is_some() {
            return Err(Code::FileInParts.into());
        }
        let own = Self::within(view, accessor, group).filter(|_| buffer == 0);
        let (own, end) = own.ok_or_else(bad)?;
        if end > bytes as u64 {
            return Err(bad());
        }
        Ok(own)
    }

    /// The view of an accessor, and the byte of the chunk at which the file's buffer view ends. `None` if a number is
    /// missing or wrong, or the accessor reaches beyond that buffer view.
    fn within(view: &Json, accessor: &Json, group: usize) -> Option<(Self, u64)> {
        let wanted = if group == 3 { "VEC3" } else { "SCALAR" };
        if accessor.get("type").and_then(Json::text) != Some(wanted) {
            return None;
        }
        let kind = ComponentType::of(accessor.index_of("componentType")?)?;
        let count = accessor.index_of("count")?;
        let offset = |json: &Json| match json.get("byteOffset") {
            None => Some(0),
            Some(offset) => offset.index(),
        };
        let (start, inner) = (offset(view)?, offset(accessor)?);
        let length = view.index_of("byteLength")?;
        let size = group * kind.bytes();
        let stride = match view.get("byteStride") {
            None => size,
            Some(stride) => stride.index().filter(|&stride| stride >= size)?,
        };
        // All numbers are below 2^32, so the product of two fits into 64 bits.
        let all = |numbers: [usize; 3]| numbers.map(|n| n as u64);
        let [first, last, each] = all([inner, count.saturating_sub(1), stride]);
        let end = first + last * each + if count == 0 { 0 } else { size as u64 };
        let own = Self {
            start: start + inner,
            stride,
            count,
            kind,
            is_normalized: accessor.get("normalized") == Some(&Json::Yes),
        };
        (end <= length as u64).then_some((own, start as u64 + length as u64))
    }
}
