//! Surfaces as an OBJ file: text, one object for each cell and one for the ground.

use super::fixed::{push, push_whole};
use super::frame::ExportSpace;
use crate::solid::Surface;
#[cfg(house)]
use crate::surface_stones::Fit;
use glam::Vec3;

/// A part ends as soon as it has more bytes than this.
const PART: usize = 1 << 20;

/// The decimals of places, if bodies are not small.
const DECIMALS: u32 = 7;

const HEAD: &[u8] = b"# Made by Bubblestone.\n\
    # Right-handed, y up: x to the right of the picture, z down it. One unit is the picture's side.\n\
    # Colours are sRGB; places in maps begin at the lower left.\n";
#[cfg(house)]
const MODEL_HEAD: &[u8] = b"# Made by Bubblestone.\n\
    # Right-handed, y up, in the units of the surface. Colours are sRGB.\n\
    # Texture coordinates have the same units: each body is projected to its tangent plane.\n";
#[cfg(house)]
const SCENE_HEAD: &str = "# Made by Bubblestone.\n# Right-handed, y up, in ";

/// An OBJ file that is being made.
pub(super) struct Obj {
    parts: Vec<Vec<u8>>,
    part: Vec<u8>,
    /// Vertices written so far; indices in the file count from 1.
    vertices: u64,
    /// The decimals of places.
    decimals: u32,
    /// The map from the file to the coordinates of its surfaces.
    #[cfg(house)]
    fit: Fit,
}

impl Obj {
    pub fn new(frame: &ExportSpace) -> Self {
        let head = match frame {
            ExportSpace::Picture { .. } => HEAD,
            #[cfg(house)]
            ExportSpace::Model(_) => MODEL_HEAD,
        };
        Self {
            parts: Vec::new(),
            part: head.to_vec(),
            vertices: 0,
            decimals: DECIMALS,
            #[cfg(house)]
            fit: Fit::default(),
        }
    }

    /// A file of stones of about this size on a model, which `fit` has mapped from the file's coordinates. If stones are
    /// smaller than a hundredth, places get more decimals.
    #[cfg(house)]
    pub fn of_model(fit: Fit, size: f64) -> Self {
        let smaller = (-2.0 - libm::log10(size).floor()).clamp(0.0, 30.0);
        Self {
            fit,
            decimals: DECIMALS + smaller as u32,
            ..Self::new(&ExportSpace::Model(None))
        }
    }

    /// A file of bodies of a scene, which `fit` has mapped from the file's coordinates. `lengths` says what these are.
    #[cfg(house)]
    pub fn of_scene(fit: Fit, lengths: &str) -> Self {
        Self {
            part: format!("{SCENE_HEAD}{lengths}. Colours are sRGB.\n").into_bytes(),
            fit,
            ..Self::new(&ExportSpace::Model(None))
        }
    }

    /// The place of a vertex in the file.
    fn place(&self, frame: &ExportSpace, p: Vec3) -> [f64; 3] {
        match frame {
            ExportSpace::Picture { .. } => frame.place(p).map(f64::from),
            #[cfg(house)]
            ExportSpace::Model(_) => self.fit.back(p).to_array(),
        }
    }

    /// Adds the surface of the stone with this id, or of the ground for 0.
    pub fn add(&mut self, frame: &ExportSpace, surface: &Surface, id: u32) {
        let name = match id.checked_sub(1) {
            None => "ground".to_owned(),
            Some(index) => format!("cell_{index}"),
        };
        self.add_named(frame, surface, &name);
    }

    /// Adds an object with this name, which must be one word.
    pub(super) fn add_named(&mut self, frame: &ExportSpace, surface: &Surface, name: &str) {
        let mut part = std::mem::take(&mut self.part);
        let out = &mut part;
        out.extend_from_slice(b"o ");
        out.extend_from_slice(name.as_bytes());
        out.push(b'\n');
        for (k, &p) in surface.positions.iter().enumerate() {
            let in_maps = frame.place_in_maps(p);
            let in_maps = in_maps.map(|[x, y]| [x, 1.0 - y].map(f64::from));
            let colour = surface.colours[k].map(|c| f64::from(c) / 255.0);
            let normal = frame.direction(surface.normals[k]).map(f64::from);
            for (word, numbers, decimals) in [
                ("v", &self.place(frame, p)[..], self.decimals),
                ("", &colour, 3),
                (
                    "\nvt",
                    in_maps.as_ref().map_or(&[], |at| at),
                    self.decimals - 1,
                ),
                ("\nvn", &normal, 4),
            ] {
                if numbers.is_empty() {
                    continue;
                }
                out.extend_from_slice(word.as_bytes());
                for &x in numbers {
                    out.push(b' ');
                    push(out, x, decimals);
                }
            }
            out.push(b'\n');
        }
        for &triangle in &surface.triangles {
            out.push(b'f');
            for k in frame.turned(triangle) {
                let number = self.vertices + u64::from(k) + 1;
                out.push(b' ');
                push_whole(out, number);
                out.push(b'/');
                if frame.has_maps() {
                    push_whole(out, number);
                }
                out.push(b'/');
                push_whole(out, number);
            }
            out.push(b'\n');
        }
        self.vertices += surface.positions.len() as u64;
        if part.len() > PART {
            self.parts.push(part);
        } else {
            self.part = part;
        }
    }

    /// The parts finished since the last call.
    pub fn take(&mut self) -> Vec<Vec<u8>> {
        std::mem::take(&mut self.parts)
    }

    /// The rest of the file, in parts.
    pub fn finish(mut self) -> Vec<Vec<u8>> {
        self.parts.push(self.part);
        self.parts
    }
}
