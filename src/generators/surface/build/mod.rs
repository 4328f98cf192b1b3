//! The first stage: a surface fit for cells of the wanted sizes.

mod steps;

use super::params::{MeshSource, PackingTarget, Sizes, SurfaceParams};
use super::reduce::{Reducing, without};
use super::tracing;
use crate::generators::scene_picture::Loaded;
use crate::notice::{Code, Notice};
use crate::shapes::{Bone as ShapeBone, Ends, Shape, ShapeMaking};
use crate::surface_field::fit::check_count;
use crate::surface_field::{
    Amount, Bone, SizeParams, SurfaceFieldBuilder, SurfaceFieldParams, SurfaceFields,
};
use crate::surface_stones::Claw;
use crate::trimesh::refine::{Refining, SHARE};
use crate::trimesh::repair::{CreaseCutting, HoleFilling};
use crate::trimesh::{MeshBuilding, Search, Siding, Simplifying, TriMesh};
use glam::DVec3;
use std::sync::Arc;

/// Edges are divided further if the smallest cell size is less than this share of the mean size.
const VARIES: f64 = 0.6;
/// If a surface has more triangles for each cell than this, cells are packed on a simpler surface.
const PLENTY: f64 = 60.0;
/// A huge surface is first made coarser, to this number of triangles or to [`PLENTY`] for each cell, if that is more.
const FEW: usize = 1 << 15;
/// The number of triangles for each cell on a simpler surface, before its edges are divided.
const SIMPLE: f64 = 6.0;
/// The greatest error of a simpler surface, in sizes of cells.
const OFF: f64 = 0.2;

/// If both the slenderness of a file's triangles and their number exceed this, stones, too, stand on the simpler
/// surface.
const NEEDLES: f64 = 4000.0;

/// A model is refused at once if its largest part has less area than this, in squared cell sizes.
const SMALL: f64 = 0.25;

/// A model whose middle is farther from its origin than this, in diagonals, is moved near to it: places of bodies have
/// single precision, and a stone would lose its shape there. Nearer models stay where they are, bit for bit.
const FAR: f64 = 100.0;

/// A surface ready for its fields.
pub(super) struct Built {
    /// How far the model was moved to its origin: files get this added to each place.
    pub anchor: DVec3,
    /// The mesh on which cells are packed.
    pub mesh: Arc<TriMesh>,
    /// The mesh on which stones stand: not cut, and as fine as given.
    pub whole: Arc<TriMesh>,
    /// Finds places on `whole`, to carry cells there from a simpler `mesh`; else `None`.
    pub search: Option<Search>,
    pub bones: Vec<Bone>,
    /// Claws and tips of horn that stand on the surface.
    pub claws: Vec<Claw>,
    /// The main direction from head to tail, if there are no bones.
    pub main: DVec3,
    pub notices: Vec<Notice>,
    /// The mean size of cells, in the model's units.
    pub size: f64,
    /// Whether the surface of a file has open parts.
    pub is_open: bool,
}

/// A surface in progress.
pub(super) struct Building {
    step: BuildPhase,
    anchor: DVec3,
    /// The mean size of cells.
    size: f64,
    /// The mesh of the file, or a coarser one in place of a huge one.
    given: Option<Arc<TriMesh>>,
    /// The mesh for stones, if it differs from the mesh that is being made.
    whole: Option<Arc<TriMesh>>,
    search: Option<Search>,
    notices: Vec<Notice>,
    is_open: bool,
    /// Whether cells are packed on a simpler surface.
    is_simple: bool,
    /// Whether the surface of the file has too many needles for stones to stand on it.
    has_needles: bool,
}

enum BuildPhase {
    /// A coarse version of the shape, to find its area.
    Sketch(Box<ShapeMaking>),
    SketchMesh(Box<MeshBuilding>),
    Shape(Box<ShapeMaking>),
    ShapeMesh(Box<MeshBuilding>),
    Sides(Box<Siding>),
    Reduce(Box<Reducing>),
    Simplify(Box<Simplifying>),
    Project(Box<(TriMesh, Search)>),
    Fill(Box<HoleFilling>),
    LeaveOut(Box<MeshBuilding>),
    Refine(Box<Refining>),
    Size(TriMesh),
    Search(Box<(Arc<TriMesh>, Search)>),
    Sizes(Arc<TriMesh>, Box<SurfaceFieldBuilder>),
    Divide(Box<Refining>),
    Cut(Box<CreaseCutting>, Arc<TriMesh>),
    End(TriMesh, Arc<TriMesh>),
    None,
}

/// The number of triangles in one slice of building a search tree.
const SEARCHED: usize = 1 << 14;

impl Building {
    /// Does one slice. `loaded` is the file's surface, if the surface comes from a file.
    ///
    /// # Errors
    /// If there is no surface, or it would have too many triangles or cells.
    pub fn advance(
        params: &SurfaceParams,
        work: &mut Option<Building>,
        loaded: &Loaded,
    ) -> Result<Option<Built>, Notice> {
        check_count(params.sizes.count)?;
        let Some(building) = work else {
            *work = Some(Self::begin(params, loaded)?);
            return Ok(None);
        };
        let step = std::mem::replace(&mut building.step, BuildPhase::None);
        building.step = building.next(params, step)?;
        Ok(building.finish(params))
    }

    fn begin(params: &SurfaceParams, loaded: &Loaded) -> Result<Self, Notice> {
        let mut new = Self {
            step: BuildPhase::None,
            anchor: DVec3::ZERO,
            size: 0.0,
            given: None,
            whole: None,
            search: None,
            notices: loaded.notices.clone(),
            is_open: false,
            is_simple: false,
            has_needles: false,
        };
        new.step = match (&params.source, loaded.meshes.first()) {
            (MeshSource::Shape(shape, ends, numbers), _) => {
                let edge = shape.coarsest(numbers);
                BuildPhase::Sketch(Box::new(shape.making(numbers, edge, *ends)))
            }
            (MeshSource::Model(..), None) => return Err(Code::ModelFirst.into()),
            (MeshSource::Model(..), Some(mesh)) => {
                new.size = size_for(&params.sizes, mesh.area());
                new.anchor = anchor(mesh);
                let mesh = match new.anchor == DVec3::ZERO {
                    true => mesh.clone(),
                    false => Arc::new(mesh.as_ref().clone().moved_by(-new.anchor)),
                };
                BuildPhase::Sides(Box::new(Siding::new(mesh, params.sides)))
            }
        };
        Ok(new)
    }

    /// Goes on with a mesh whose sides are known. If it is far finer than cells need, cells are packed on a simpler
    /// one.
    fn sided(&mut self, params: &SurfaceParams, mesh: Arc<TriMesh>) -> BuildPhase {
        let count = params.sizes.count;
        let plenty = PLENTY * count;
        let is_fine = mesh.triangles().len() as f64 > plenty;
        if params.on == PackingTarget::Simple || (params.on == PackingTarget::Fit && is_fine) {
            let most = FEW.max(plenty as usize);
            if let Some(reducing) = Reducing::begin(&mesh, most, self.size) {
                return BuildPhase::Reduce(Box::new(reducing));
            }
            self.given = Some(mesh.clone());
            return self.simplifying(count, mesh);
        }
        self.given = Some(mesh.clone());
        BuildPhase::Fill(Box::new(HoleFilling::new(mesh, self.size)))
    }

    /// Goes on with a coarser surface in place of a huge one.
    fn reduced(&mut self, count: f64, (mesh, notices): (TriMesh, Vec<Notice>)) -> BuildPhase {
        self.notices.extend(notices);
        let mesh = Arc::new(mesh);
        self.given = Some(mesh.clone());
        self.simplifying(count, mesh)
    }

    /// The area of the sketch of a shape gives the mean size of cells and the wanted length of edges. If this length
    /// leads to the same triangles, the sketch becomes the surface.
    fn shaped(&mut self, params: &SurfaceParams, sketch: TriMesh) -> BuildPhase {
        self.size = size_for(&params.sizes, sketch.area());
        let MeshSource::Shape(shape, ends, numbers) = &params.source else {
            return BuildPhase::Size(sketch);
        };
        let edge = SHARE * self.size / sketch.diagonal();
        if shape.is_alike(numbers, *ends, [shape.coarsest(numbers), edge]) {
            return BuildPhase::Refine(Box::new(self.refining(sketch)));
        }
        BuildPhase::Shape(Box::new(shape.making(numbers, edge, *ends)))
    }

    /// Whether the surface is from a file, and has not been simplified yet.
    fn may_simplify(&self) -> bool {
        self.given.is_some() && !self.is_simple
    }

    /// Begins a simpler surface than this one, to pack cells on. Stones stand on the surface of the file unless it has
    /// needles.
    fn simplifying(&mut self, count: f64, mesh: impl Into<Arc<TriMesh>>) -> BuildPhase {
        self.is_simple = true;
        if self.has_needles {
            self.notices.push(Code::ModelNeedles.into());
        } else {
            self.whole = self.given.clone();
        }
        let simplifying = Simplifying::new(mesh, (SIMPLE * count) as usize, OFF * self.size);
        BuildPhase::Simplify(Box::new(simplifying))
    }

    fn refining(&self, mesh: TriMesh) -> Refining {
        Refining::evenly(mesh, SHARE * self.size)
    }

    /// If sizes differ much, edges become as short as the smallest cells need.
    fn sized(&mut self, params: &SurfaceParams, mesh: TriMesh) -> BuildPhase {
        let sizes = &params.sizes;
        if sizes.taper.is_none() && sizes.curvature.is_none() && sizes.spots.is_empty() {
            return self.cutting(params, mesh);
        }
        let mesh = Arc::new(mesh);
        if sizes.spots.is_empty() {
            let size = size_params(sizes, &mesh, None);
            return sizing(params, mesh, size);
        }
        let search = Search::begin(&mesh);
        BuildPhase::Search(Box::new((mesh, search)))
    }

    fn divided(
        &mut self,
        params: &SurfaceParams,
        mesh: Arc<TriMesh>,
        fields: &SurfaceFields,
    ) -> BuildPhase {
        let owned =
            |mesh: Arc<TriMesh>| Arc::try_unwrap(mesh).unwrap_or_else(|mesh| (*mesh).clone());
        if fields.size_range().0 > VARIES * self.size {
            return self.cutting(params, owned(mesh));
        }
        let targets = fields
            .sizes()
            .into_iter()
            .map(|size| SHARE * size.min(self.size));
        BuildPhase::Divide(Box::new(Refining::new(owned(mesh), targets.collect())))
    }

    /// Leaves the faces where a body is cut off without cells, and cuts the other faces along creases.
    fn cutting(&mut self, params: &SurfaceParams, mesh: TriMesh) -> BuildPhase {
        let whole = Arc::new(mesh);
        let covered = match &params.source {
            MeshSource::Shape(shape, Ends::Cut, numbers) => {
                let cuts = shape.cuts(numbers);
                let is_cut = |t: usize| {
                    let t = t as u32;
                    let middle = whole.corners(t).iter().sum::<DVec3>() / 3.0;
                    cuts.iter().any(|cut| cut.has(middle, whole.face_normal(t)))
                };
                let bare: Vec<bool> = (0..whole.triangles().len()).map(is_cut).collect();
                without(&whole, &bare)
            }
            _ => whole.as_ref().clone(),
        };
        match params.cut {
            Some(angle) => BuildPhase::Cut(Box::new(CreaseCutting::new(covered, angle)), whole),
            None => BuildPhase::End(covered, whole),
        }
    }

    /// The surface, when all steps are done.
    fn finish(&mut self, params: &SurfaceParams) -> Option<Built> {
        let BuildPhase::End(..) = self.step else {
            return None;
        };
        let BuildPhase::End(mesh, uncut) = std::mem::replace(&mut self.step, BuildPhase::None)
        else {
            return None;
        };
        let (bones, main) = match &params.source {
            MeshSource::Shape(shape, _, numbers) => (bones(*shape, numbers), shape.main()),
            MeshSource::Model(..) => (Vec::new(), DVec3::Y),
        };
        let claws = match &params.source {
            MeshSource::Shape(shape, Ends::Cut, numbers) => shape.claws(numbers),
            _ => Vec::new(),
        };
        let claw = |bone: ShapeBone| Claw {
            points: bone.points,
            radii: bone.radii,
        };
        let is_uncut = mesh.triangles().len() == uncut.triangles().len() && params.cut.is_none();
        let mesh = match is_uncut {
            true => uncut.clone(),
            false => Arc::new(mesh),
        };
        Some(Built {
            anchor: self.anchor,
            mesh,
            whole: self.whole.take().unwrap_or(uncut),
            search: self.search.take(),
            bones,
            claws: claws.into_iter().map(claw).collect(),
            main,
            notices: std::mem::take(&mut self.notices),
            size: self.size,
            is_open: self.is_open,
        })
    }
}

fn meshing(making: ShapeMaking) -> MeshBuilding {
    let made = making.finish();
    MeshBuilding::new(made.positions, made.triangles)
}

/// How far a model is moved: along each axis by its middle, if that is far away.
fn anchor(mesh: &TriMesh) -> DVec3 {
    let (low, high) = mesh.bounds();
    let far = FAR * (high - low).length();
    let middle = low.midpoint(high).to_array();
    DVec3::from(middle.map(|at| if at.abs() > far { at } else { 0.0 }))
}

fn size_for(sizes: &Sizes, area: f64) -> f64 {
    SurfaceFields::size_for(sizes.kind, sizes.count, area)
}

fn sizing(params: &SurfaceParams, mesh: Arc<TriMesh>, size: SizeParams) -> BuildPhase {
    let bones = match &params.source {
        MeshSource::Shape(shape, _, numbers) => bones(*shape, numbers),
        MeshSource::Model(..) => Vec::new(),
    };
    let params = SurfaceFieldParams {
        kind: params.sizes.kind,
        size,
        bones,
        ..SurfaceFieldParams::default()
    };
    let builder = SurfaceFieldBuilder::new(mesh.clone(), params);
    BuildPhase::Sizes(mesh, Box::new(builder))
}

/// The parameters of sizes on a mesh; spots need a search.
pub(super) fn size_params(sizes: &Sizes, mesh: &TriMesh, search: Option<&Search>) -> SizeParams {
    SizeParams {
        amount: Amount::Count(sizes.count),
        taper: sizes.taper,
        curvature: sizes.curvature,
        spots: search.map_or(Vec::new(), |search| {
            tracing::spots(mesh, search, &sizes.spots)
        }),
        ..SizeParams::default()
    }
}

/// The bones of a shape, as fields need them: a closed bone returns to its first point.
fn bones(shape: Shape, numbers: &[f64]) -> Vec<Bone> {
    let open = |bone: ShapeBone| {
        let (mut points, mut radii) = (bone.points, bone.radii);
        if bone.closed
            && let (Some(&first), Some(&radius)) = (points.first(), radii.first())
        {
            points.push(first);
            radii.push(radius);
        }
        Bone { points, radii }
    };
    shape.bones(numbers).into_iter().map(open).collect()
}

/// The mesh that was built, or the notice that it has no area.
fn built<E>(mesh: Result<TriMesh, E>) -> Result<TriMesh, Notice> {
    mesh.map_err(|_| Code::ModelNoArea.into())
}
