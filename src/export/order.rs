//! What a mesh file is to hold, and how large it comes out.

/// Degrees of detail with their words: triangles of a stone.
pub const DETAILS: [(&str, usize); 3] = [("low", 100), ("middle", 400), ("high", 1600)];

/// All stones of a file together have no more triangles: where there are many, each has fewer.
const MOST: usize = 4_000_000;
/// The ground has this part of the triangles of all stones.
const GROUND: f64 = 0.2;
/// The least squares along a side of the ground.
const LEAST_SQUARES: usize = 16;
/// Bytes of text for a stone, and for a vertex and a triangle: of OBJ, and of GLB plain and with images.
const BYTES: [[f64; 3]; 3] = [[16.0, 87.0, 59.0], [890.0, 40.0, 6.0], [560.0, 20.0, 6.0]];

/// A kind of mesh file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// Text; an object `cell_K` for the K-th cell, colours in sRGB after the positions.
    Obj,
    /// Binary glTF 2.0; a node `stone_ID` for each stone, colours in linear light or images.
    Glb,
}

impl MeshFormat {
    /// All kinds with the endings of their files' names.
    pub const ALL: [(MeshFormat, &'static str); 2] =
        [(MeshFormat::Obj, "obj"), (MeshFormat::Glb, "glb")];
}

/// A file of the stones' surfaces and the ground, each by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshOrder {
    /// The kind of file.
    pub format: MeshFormat,
    /// Triangles of each stone, about: see [`DETAILS`].
    pub detail: usize,
    /// Of a GLB file, the bytes of its images, all PNG: colour, normals (OpenGL), and occlusion, roughness and
    /// metal. Whoever asks puts them behind the file's last part, each filled up to a multiple of four bytes.
    pub images: Option<[u32; 3]>,
}

/// How large a file is, about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshSize {
    /// Its triangles.
    pub triangles: usize,
    /// Its bytes.
    pub bytes: f64,
}

impl MeshOrder {
    /// Triangles of each of so many stones: an even number, as a closed surface has.
    pub(super) fn of_each(&self, stones: usize) -> usize {
        self.detail.min(MOST / stones.max(1)).max(4) / 2 * 2
    }

    /// Squares along a side of the ground, in a picture of so many pixels along a side.
    pub(super) fn ground_squares(&self, stones: usize, side: usize) -> usize {
        let wanted = GROUND * (stones * self.of_each(stones)) as f64;
        let squares = (0.5 * wanted).sqrt() as usize;
        squares.max(LEAST_SQUARES).min(side)
    }

    /// How large the file of a model is, of so many stones and a ground of so many triangles.
    #[cfg(house)]
    pub fn model_size(&self, stones: usize, ground: usize) -> MeshSize {
        let each = self.of_each(stones);
        let triangles = stones * each + ground;
        let vertices = stones * (each / 2 + 2) + ground / 2;
        let [stone, vertex, triangle] = match self.format {
            MeshFormat::Obj => [16.0, 74.0, 48.0],
            MeshFormat::Glb => [760.0, 32.0, 6.0],
        };
        let text = stone * stones as f64 + vertex * vertices as f64;
        MeshSize {
            triangles,
            bytes: text + triangle * triangles as f64,
        }
    }

    /// How large its file is of so many stones in a picture of so many pixels along a side.
    pub fn size(&self, stones: usize, side: usize) -> MeshSize {
        // A closed surface has half as many vertices as triangles and two more.
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
        // Those of the file with images all have the ground's normals and tangents.
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
        };
        assert_eq!((order.of_each(0), order.of_each(452)), (1600, 1600));
        assert_eq!(order.of_each(9000), 444);
        assert!(order.ground_squares(0, 512) == 16 && order.ground_squares(9000, 512) == 512);
    }
}
