//! Orders for mesh files, and estimates of the files' sizes.

#[cfg(house)]
use crate::scene::{Body, Scene};
#[cfg(house)]
use crate::solid::Surface;

/// Words for levels of detail, each with the number of triangles of a stone.
pub const DETAILS: [(&str, usize); 3] = [("low", 100), ("middle", 400), ("high", 1600)];

/// The most triangles of all stones of a file together; with many stones each gets fewer.
const MOST: usize = 4_000_000;
/// The triangles of the ground, as a part of those of all stones.
const GROUND: f64 = 0.2;
/// The fewest squares along a side of the ground.
const LEAST_SQUARES: usize = 16;
/// Bytes for a stone, for a vertex and for a triangle: in OBJ, in plain GLB, and in GLB with images.
const BYTES: [[f64; 3]; 3] = [[16.0, 87.0, 59.0], [890.0, 40.0, 6.0], [560.0, 20.0, 6.0]];

/// A kind of mesh file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// Text: an object `cell_K` for the K-th cell, with sRGB colours after the positions.
    Obj,
    /// Binary glTF 2.0: a node `stone_ID` for each stone, with colours in linear light or with images.
    Glb,
}

impl MeshFormat {
    /// All kinds, with the endings of their files' names.
    pub const ALL: [(MeshFormat, &'static str); 2] =
        [(MeshFormat::Obj, "obj"), (MeshFormat::Glb, "glb")];
}

/// An order for a file of the surfaces of all stones and of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshOrder {
    /// The kind of file.
    pub format: MeshFormat,
    /// About how many triangles a stone has: see [`DETAILS`].
    pub detail: usize,
    /// For a GLB file, the sizes of its images in bytes, all PNG: colour, normals (OpenGL), and occlusion, roughness
    /// and metal. The caller appends them to the file's last part, each padded to a multiple of four bytes.
    pub images: Option<[u32; 3]>,
    /// Whether a GLB file has one mesh of all bodies, with a primitive for each material. Sizes ignore this.
    #[cfg(house)]
    pub joined: bool,
}

/// The approximate size of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshSize {
    /// The number of triangles.
    pub triangles: usize,
    /// The number of bytes.
    pub bytes: f64,
}

impl MeshOrder {
    /// The triangles of each stone: an even number, as in any closed surface.
    pub(super) fn of_each(&self, stones: usize) -> usize {
        self.detail.min(MOST / stones.max(1)).max(4) / 2 * 2
    }

    /// Squares along a side of the ground, in a picture with `side` pixels along a side.
    pub(super) fn ground_squares(&self, stones: usize, side: usize) -> usize {
        let wanted = GROUND * (stones * self.of_each(stones)) as f64;
        let squares = (0.5 * wanted).sqrt() as usize;
        squares.max(LEAST_SQUARES).min(side)
    }

    /// The size of a model's file with this many stones and triangles of the ground.
    #[cfg(house)]
    pub fn model_size(&self, stones: usize, ground: usize) -> MeshSize {
        let each = self.of_each(stones);
        let triangles = stones * each + ground;
        let vertices = stones * (each / 2 + 2) + ground / 2;
        let [stone, vertex, triangle] = match self.format {
            MeshFormat::Obj => [16.0, 96.0, 59.0],
            MeshFormat::Glb => [850.0, 40.0, 6.0],
        };
        let text = stone * stones as f64 + vertex * vertices as f64;
        MeshSize {
            triangles,
            bytes: text + triangle * triangles as f64,
        }
    }

    /// The size of the file of a scene. In GLB bodies of one kind share a mesh.
    #[cfg(house)]
    pub fn scene_size(&self, scene: &Scene) -> MeshSize {
        let each = self.of_each(scene.instances.len());
        let fits = |surface: &&Surface| surface.triangles.len() <= each;
        let of = |body: &Body| {
            let levels = body.levels.iter();
            let fitting = levels.clone().find(fits).or(levels.last());
            fitting.map_or([0; 2], |s| [s.positions.len(), s.triangles.len()])
        };
        let bodies: Vec<[usize; 2]> = scene.bodies.iter().map(of).collect();
        let placed = scene.instances.iter().map(|i| bodies[i.body as usize]);
        let sum = |all: &mut dyn Iterator<Item = [usize; 2]>| {
            all.fold([0; 2], |sum, own| [sum[0] + own[0], sum[1] + own[1]])
        };
        let shown = sum(&mut placed.clone());
        let stored = match self.format {
            MeshFormat::Glb if !self.joined => sum(&mut bodies.iter().copied()),
            _ => shown,
        };
        let [text, vertex, triangle] = match self.format {
            MeshFormat::Obj => [16.0, 96.0, 59.0],
            MeshFormat::Glb => [220.0, 28.0, 6.0],
        };
        let [vertices, triangles] = stored.map(|n| n as f64);
        let text = text * scene.instances.len() as f64;
        MeshSize {
            triangles: shown[1],
            bytes: text + vertex * vertices + triangle * triangles,
        }
    }

    /// The size of a file with this many stones in a picture with `side` pixels along a side.
    pub fn size(&self, stones: usize, side: usize) -> MeshSize {
        // A closed surface has half as many vertices as triangles, plus two.
        let (each, squares) = (self.of_each(stones), self.ground_squares(stones, side));
        let triangles = stones * each + 2 * squares * squares;
        let on_ground = (squares + 1) * (squares + 1);
        let vertices = stones * (each / 2 + 2) + on_ground;
        let kind = match (self.format, self.images) {
            (MeshFormat::Obj, _) => 0,
            (_, None) => 1,
            _ => 2,
        };
        let [stone, vertex, triangle] = BYTES[kind];
        let images = self.images.unwrap_or_default().map(f64::from);
        // In a file with images, all vertices share one list of normals and tangents, as long as the ground's.
        let shared = if kind == 2 { 28 * on_ground } else { 0 };
        let text = stone * stones as f64 + vertex * vertices as f64;
        let bytes = text + triangle * triangles as f64 + shared as f64;
        MeshSize {
            triangles,
            bytes: bytes + images.iter().sum::<f64>(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn very_many_stones_have_fewer_triangles_each() {
        let order = MeshOrder {
            format: MeshFormat::Glb,
            detail: 1600,
            images: None,
            #[cfg(house)]
            joined: false,
        };
        assert_eq!((order.of_each(0), order.of_each(452)), (1600, 1600));
        assert_eq!(order.of_each(9000), 444);
        assert!(order.ground_squares(0, 512) == 16 && order.ground_squares(9000, 512) == 512);
    }
}
