//! Tells whether cells fit a surface: its curvature, its thickness, and the number that a machine can pack.

use crate::notice::{Code, Notice};
use crate::order;
use crate::surface_field::SurfaceFields;
use crate::trimesh::search::nearest_in;
use crate::trimesh::{Search, SurfacePoint, TriMesh};
use glam::DVec3;

/// The most cells on a surface.
pub const MOST_CELLS: usize = 250_000;
/// Above this ratio of a cell's side to the radius of curvature, cells become uneven.
const TIGHT: f64 = 0.8;
/// Above these ratios cells cannot follow the surface: where it is curved both ways, and where it is curved one way.
const TOO_TIGHT: [f64; 2] = [1.0, 1.2];
/// A surface is curved both ways if the lesser curvature is at least this part of the greater.
const BOTH: f64 = 0.5;
/// A sheet is thin below this part of the side of a cell.
const THIN: f64 = 0.5;
/// A notice is given above these shares of the area: for cells that are too large, and for sheets that are too thin.
/// Cells that fold over the edges of fins and rims do no harm, so the first share is not small.
const TOLD: [f64; 2] = [0.25, 0.1];
/// If cells are too large to follow the surface on more than this share of its area, they are refused.
const MOST: f64 = 0.5;
/// One triangle in this many is measured; fewer if a cell covers very many triangles.
const SAMPLED: usize = 8;
/// The number of triangles that a slice looks at.
const SLICE: f64 = 1e5;
/// About the most triangles that all slices look at.
const ALL: f64 = 5e7;
/// Two triangles face away from each other if the dot product of their normals is less than this.
const BACK: f64 = -0.2;
/// A triangle lies below a point if it is within 60 degrees of straight down (cosine).
const BELOW: f64 = 0.5;

/// Checks the number of cells on a surface.
///
/// # Errors
/// If there are more than [`MOST_CELLS`].
pub fn check_count(cells: f64) -> Result<(), Notice> {
    if cells <= MOST_CELLS as f64 {
        return Ok(());
    }
    // A count that is not a number is too many as well.
    let about = cells.clamp(0.0, 1e15).round() as u64;
    let too_many = Notice::new(Code::SurfaceCells).with("n", about.to_string());
    Err(too_many.with("most", MOST_CELLS))
}

/// The properties of a surface on which the fit of cells depends.
pub trait Local {
    /// The mean side of cells.
    fn mean_size(&self) -> f64;
    /// The side of cells at a point.
    fn size(&self, point: &SurfacePoint) -> f64;
    /// The two principal curvatures at a point, one over a length.
    fn curvatures(&self, point: &SurfacePoint) -> [f64; 2];
}

impl Local for SurfaceFields {
    fn mean_size(&self) -> f64 {
        SurfaceFields::mean_size(self)
    }

    fn size(&self, point: &SurfacePoint) -> f64 {
        SurfaceFields::size(self, point)
    }

    fn curvatures(&self, point: &SurfacePoint) -> [f64; 2] {
        let curvature = self.curvature(point);
        let bend = curvature.bend.length();
        [curvature.mean + bend, curvature.mean - bend]
    }
}

/// Shares of the area where cells do not fit well, 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fit {
    /// Where cells are large beside the radius of curvature.
    pub tight: f64,
    /// Where cells are too large to follow the surface.
    pub too_tight: f64,
    /// Where the other side is closer than half the side of a cell.
    pub thin: f64,
    /// The factor on the side of cells with which they are too large on just half of the area.
    pub largest: f64,
}

/// Measures how cells fit.
#[derive(Clone, Debug, Default)]
pub struct Fitting {
    at: usize,
    area: f64,
    sums: Fit,
    /// For each measured triangle: the side of its cell over the largest that can follow the surface, and its area.
    sides: Vec<[f64; 2]>,
}

impl Fitting {
    /// Starts with nothing measured.
    pub fn new() -> Self {
        Self::default()
    }

    /// Measures one more slice of a surface; returns the shares when it is done.
    pub fn advance(&mut self, mesh: &TriMesh, search: &Search, local: &impl Local) -> Option<Fit> {
        let count = mesh.triangles().len();
        // About how many triangles lie nearer to a point than the side of a cell.
        let size = local.mean_size();
        let near = 1.0 + count as f64 * std::f64::consts::PI * size * size / mesh.area();
        // If there are few triangles, all are measured.
        let step = match count > 64 * SAMPLED {
            true => SAMPLED.max((count as f64 * near / ALL) as usize),
            false => 1,
        };
        let end = count.min(self.at + step * (SLICE / near).max(1.0) as usize);
        for t in (self.at..end).step_by(step) {
            self.measure(mesh, search, local, t as u32);
        }
        self.at = end;
        (end == count).then(|| self.fit())
    }

    fn fit(&mut self) -> Fit {
        let share = |sum: f64| sum / self.area;
        let [tight, too_tight, thin] =
            [self.sums.tight, self.sums.too_tight, self.sums.thin].map(share);
        Fit {
            tight,
            too_tight,
            thin,
            largest: self.largest(),
        }
    }

    /// The factor on the side of cells with which a share of [`MOST`] of the area is too round for them.
    fn largest(&mut self) -> f64 {
        order::sort(&mut self.sides, |[side, _]| (!order::rank(*side), 0));
        let mut round = 0.0;
        let last = self.sides.iter().find(|[_, area]| {
            round += area;
            round > MOST * self.area
        });
        last.map_or(f64::INFINITY, |[side, _]| 1.0 / side)
    }

    fn measure(&mut self, mesh: &TriMesh, search: &Search, local: &impl Local, t: u32) {
        let point = SurfacePoint::new(mesh, t, DVec3::splat(1.0 / 3.0));
        let area = mesh.area_of(t);
        let size = local.size(&point);
        let curvatures = local.curvatures(&point).map(f64::abs);
        let most = curvatures[0].max(curvatures[1]);
        let is_both = curvatures[0].min(curvatures[1]) >= BOTH * most;
        let limit = if is_both { TOO_TIGHT[0] } else { TOO_TIGHT[1] };
        self.area += area;
        self.sides.push([most * size / limit, area]);
        if most * size > TIGHT {
            self.sums.tight += area;
        }
        if most * size > limit {
            self.sums.too_tight += area;
        }
        if search.any_within(point.at, THIN * size, |other| {
            is_below(mesh, &point, other, THIN * size)
        }) {
            self.sums.thin += area;
        }
    }
}

/// Whether a triangle is the other side of a sheet that is thinner than `size`.
fn is_below(mesh: &TriMesh, point: &SurfacePoint, other: u32, size: f64) -> bool {
    if mesh.face_normal(other).dot(point.normal) >= BACK {
        return false;
    }
    let near = nearest_in(mesh.corners(other), point.at);
    let to = near - point.at;
    let far = to.length();
    far < size && -to.dot(point.normal) > BELOW * far
}

impl Fit {
    /// The notices for these shares.
    ///
    /// # Errors
    /// If cells are too large for most of the surface.
    pub fn notices(&self) -> Result<Vec<Notice>, Notice> {
        let told = |code, share: f64| {
            // At least 1, so that no notice says 0 percent.
            let percent = (100.0 * share).round().max(1.0) as usize;
            Notice::new(code).with("share", percent)
        };
        if self.too_tight > MOST {
            return Err(told(Code::SurfaceTooTight, self.too_tight));
        }
        let shares = [
            (Code::SurfaceTight, self.tight, TOLD[0]),
            (Code::SurfaceThin, self.thin, TOLD[1]),
        ];
        let large = shares.into_iter().filter(|(_, share, least)| share > least);
        Ok(large.map(|(code, share, _)| told(code, share)).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trimesh::testing::{self, mesh};

    struct Even {
        size: f64,
        curvatures: [f64; 2],
    }

    impl Local for Even {
        fn mean_size(&self) -> f64 {
            self.size
        }

        fn size(&self, _: &SurfacePoint) -> f64 {
            self.size
        }

        fn curvatures(&self, _: &SurfacePoint) -> [f64; 2] {
            self.curvatures
        }
    }

    fn fit(mesh: &TriMesh, size: f64, curvatures: [f64; 2]) -> Fit {
        let search = Search::new(mesh);
        let mut fitting = Fitting::new();
        let local = Even { size, curvatures };
        std::iter::from_fn(|| Some(fitting.advance(mesh, &search, &local)))
            .find_map(|fit| fit)
            .unwrap()
    }

    fn codes(fit: Fit) -> Vec<Code> {
        fit.notices().unwrap().iter().map(|n| n.code).collect()
    }

    #[test]
    fn sheets_much_thinner_than_a_cell_are_told() {
        let (positions, triangles) = testing::cube(30);
        for (thickness, thin) in [(0.03, 1.0), (0.045, 1.0), (0.055, 0.0), (1.0, 0.0)] {
            let flat = positions
                .iter()
                .map(|p| DVec3::new(p.x, thickness * p.y, p.z));
            let plate = mesh((flat.collect(), triangles.clone()));
            let found = fit(&plate, 0.1, [0.0; 2]);
            // The narrow faces of the rim are not thin, and the other side is not below them.
            let share = 2.0 / (2.0 + 4.0 * thickness) * thin;
            assert!((found.thin - share).abs() < 0.02, "{thickness} {found:?}");
            let told = if thin > 0.0 {
                vec![Code::SurfaceThin]
            } else {
                vec![]
            };
            assert_eq!(codes(found), told);
        }
        // A single sheet has no other side.
        let open = mesh(testing::flat(20));
        assert_eq!(fit(&open, 0.5, [0.0; 2]).thin, 0.0);
    }

    #[test]
    fn cells_large_beside_the_roundness_are_told_and_larger_ones_refused() {
        let ball = mesh(testing::ball(3));
        for (size, curvatures, told) in [
            (0.4, [1.0, 1.0], Some(vec![])),
            (0.7, [1.0, 1.0], Some(vec![])),
            (0.9, [1.0, 1.0], Some(vec![Code::SurfaceTight])),
            (1.1, [1.0, 1.0], None),
            (1.1, [-1.0, 0.1], Some(vec![Code::SurfaceTight])),
            (1.3, [0.0, 1.0], None),
        ] {
            let fit = fit(&ball, size, curvatures);
            match told {
                Some(told) => assert_eq!(codes(fit), told, "{size}"),
                None => assert_eq!(fit.notices().unwrap_err().code, Code::SurfaceTooTight),
            }
        }
    }

    #[test]
    fn too_many_cells_are_a_sentence() {
        assert!(check_count(250_000.0).is_ok());
        for cells in [250_001.0, 1e300, f64::NAN] {
            assert_eq!(check_count(cells).unwrap_err().code, Code::SurfaceCells);
        }
    }
}
