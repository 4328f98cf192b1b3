//! Readers for model files: OBJ, GLB, PLY and STL.
//!
//! The readers are our own. The libraries at hand (`tobj`, `gltf` with `serde_json`, `ply-rs`, `stl_io`) read a file in
//! one go, which blocks a page for a second if a model has half a million triangles. They keep data that no surface
//! needs. Some trust the counts in a file's head, or panic on a broken file. `gltf` alone is larger than this whole
//! module. Only shapes are read: no colours, no skeletons.
//!
//! A fault of a file becomes a notice. [`crate::trimesh::repair`] mends or reports faults of the model in it.

mod accessor;
mod affine;
mod glb;
mod glb_notices;
mod json;
mod obj;
mod ply;
#[cfg(test)]
mod samples;
mod scene;
mod stl;
mod text;

#[cfg(test)]
mod glb_tests;
#[cfg(test)]
mod tests;

pub use obj::PolygonModel;

use crate::notice::{Code, Notice};
use crate::trimesh::{MOST_TRIANGLES, Soup};
use glam::DVec3;
use std::sync::Arc;

/// A place of a file whose z axis points up, with y up.
pub fn upright(place: DVec3) -> DVec3 {
    DVec3::new(place.x, place.z, -place.y)
}

/// Size of a slice: bytes of a text file. Readers of binary STL and GLB read a fixed fraction of this many items.
const SLICE: usize = 1 << 18;

/// A reader of one kind of file.
trait Reader {
    /// Reads the next slice; true at the end of the file.
    fn advance(&mut self, bytes: &[u8], soup: &mut Soup) -> Result<bool, Notice>;
    /// The share that has been read, 0 to 1.
    fn progress(&self, bytes: &[u8]) -> f64;
}

/// A file that is being read.
pub struct Reading {
    bytes: Arc<Vec<u8>>,
    /// Where the file begins, behind a byte order mark.
    start: usize,
    soup: Soup,
    reader: Box<dyn Reader>,
}

impl Reading {
    /// Starts to read a file. Its content decides the kind; the name's ending counts only where the content is
    /// ambiguous.
    ///
    /// # Errors
    /// If the kind is not one of those that can be read.
    pub fn new(name: &str, bytes: impl Into<Arc<Vec<u8>>>) -> Result<Self, Notice> {
        let bytes = bytes.into();
        let ending = name.rsplit('.').next().unwrap_or("").to_ascii_lowercase();
        let (reader, start) = reader(&ending, &bytes)?;
        Ok(Self {
            bytes,
            start,
            reader,
            soup: Soup::default(),
        })
    }

    /// Reads the next slice. Returns the triangles at the end of the file, or a notice of its fault.
    pub fn advance(&mut self) -> Option<Result<Soup, Notice>> {
        let done = match self
            .reader
            .advance(&self.bytes[self.start..], &mut self.soup)
        {
            Ok(done) => done,
            Err(why) => return Some(Err(why)),
        };
        let count = self.soup.triangles.len();
        if count > MOST_TRIANGLES {
            return Some(Err(too_large(count)));
        }
        done.then(|| Ok(std::mem::take(&mut self.soup)))
    }

    /// The share of the file that has been read, 0 to 1.
    pub fn progress(&self) -> f64 {
        self.reader.progress(&self.bytes[self.start..])
    }

    /// Reads a whole file.
    ///
    /// # Errors
    /// A notice of its fault.
    pub fn read(name: &str, bytes: Vec<u8>) -> Result<Soup, Notice> {
        let mut reading = Self::new(name, bytes)?;
        loop {
            if let Some(done) = reading.advance() {
                return done;
            }
        }
    }
}

/// The reader for a file, and where the file begins.
fn reader(ending: &str, bytes: &[u8]) -> Result<(Box<dyn Reader>, usize), Notice> {
    let start = text::mark(bytes);
    let file = &bytes[start..];
    let text = file.trim_ascii_start();
    let reader: Box<dyn Reader> = if file.starts_with(b"glTF") {
        Box::<glb::Glb>::default()
    } else if ply::is_one(file) {
        Box::<ply::Ply>::default()
    } else if text.starts_with(b"{") {
        return Err(match ending {
            "gltf" | "glb" => Code::FileInParts.into(),
            _ => Code::FileUnknown.into(),
        });
    } else if stl::has_numbers(bytes) {
        // The head may begin with any bytes, even those of a byte order mark.
        return Ok((Box::<stl::Numbers>::default(), 0));
    } else if stl::is_text(text) {
        Box::<stl::Text>::default()
    } else if ending == "stl" && stl::has_head(bytes) {
        return Ok((Box::<stl::Numbers>::default(), 0));
    } else if ending == "obj" || obj::is_one(text) {
        Box::<obj::Obj>::default()
    } else {
        return Err(Code::FileUnknown.into());
    };
    Ok((reader, start))
}

fn too_large(triangles: impl ToString) -> Notice {
    let too_large = Notice::new(Code::ModelTooLarge);
    too_large
        .with("n", triangles.to_string())
        .with("most", MOST_TRIANGLES)
}

/// The notice that a file ends too early.
fn ends(kind: &str) -> Notice {
    Notice::new(Code::FileEnds).with("kind", kind.to_owned())
}

/// The notice that a line cannot be read.
fn bad_line(kind: &str, number: usize, line: &[u8]) -> Notice {
    let line = String::from_utf8_lossy(&line[..line.len().min(200)]);
    Notice::new(Code::FileLine)
        .with("kind", kind.to_owned())
        .with("n", number)
        .with("line", crate::notice::quote(line.trim()))
}

/// Adds the triangles of a strip: each triangle begins one corner later, and every second one is reversed.
fn add_strip(corners: &[u32], triangles: &mut Vec<[u32; 3]>) {
    for (k, t) in corners.windows(3).enumerate() {
        triangles.push(match k % 2 {
            0 => [t[0], t[1], t[2]],
            _ => [t[1], t[0], t[2]],
        });
    }
}
