//! Makes components in slices: the first of each kind or file, and its variants.

use super::fault::{Checking, ComponentFault, thick};
use super::inner::{Effort, Gaps, Inner, InnerMaking};
use super::pool::Sphere;
use super::variant::{Variant, Vary};
use super::{ComponentKind, Level, Mark};
use crate::notice::Notice;
use crate::trimesh::{MeshBuilding, Simplifying, TriMesh};
use glam::DVec3;
use std::sync::Arc;

/// The wanted numbers of triangles of the coarser levels. Only large files have the first of these levels.
const COARSER: [usize; 3] = [3_000, 360, 130];
/// A level by rule may have this many times the wanted triangles.
const ENOUGH: f64 = 1.3;
/// The number of samples of the first component, and of each variant.
const SAMPLES: [usize; 2] = [1_500, 600];
/// One in this many samples of the first component gets a medial ball. Each variant uses at most `SHARED` of these
/// balls.
const EVERY: usize = 1;
const SHARED: usize = 400;
/// Variants are made from the first level with at most this many triangles.
const VARIED: usize = 20_000;
/// The number of inner spheres of a component from a file.
const FILE_SPHERES: usize = 48;
/// The cosine of the angle of a sharp edge in a file.
const FILE_CREASE: f64 = 0.642_787_609_686_539_3;
/// A sphere is widened by this share of its greatest gap, but by no more than `WIDEST`, in R.
const WIDENED: f64 = 0.5;
const WIDEST: f64 = 1.0;

/// The measured number of darts on an area of one least distance squared, on a surface with no room for another dart.
pub const FULL_COVER: f64 = 0.69;

/// A thing to heap. The origin is the centre of its largest inner sphere.
#[derive(Clone, Debug)]
pub struct Component {
    /// Its closed meshes, the finest first.
    pub levels: Vec<Level>,
    /// Its inner spheres in the order of choice; the first has the radius [`Component::radius`] and the centre 0.
    pub spheres: Vec<Sphere>,
    /// For each sphere the greatest gap between it and a place of the surface to which it is the nearest one.
    pub beyond: Vec<f64>,
    /// R: the radius of its largest inner sphere, which is the distance from the origin to the finest mesh.
    pub radius: f64,
    /// d: the diagonal of its bounding box.
    pub diagonal: f64,
    /// B: the distance from the origin to its farthest vertex.
    pub reach: f64,
    /// The area of its surface.
    pub area: f64,
    /// Its volume.
    pub volume: f64,
    /// How far its surface lies outside its spheres.
    pub gaps: Gaps,
    /// The cosine below which an edge is sharp ([`Level::surface`]).
    pub crease: f64,
}

impl Component {
    fn new(levels: Vec<Level>, inner: &Inner, crease: f64) -> Self {
        let centre = inner.spheres[0].centre;
        let home = |level: Level| Level {
            mesh: level.mesh.moved_by(-centre),
            marks: level.marks,
        };
        let levels: Vec<Level> = levels.into_iter().map(home).collect();
        let mesh = &levels[0].mesh;
        let far = mesh.positions().iter().map(|p| p.length_squared());
        Self {
            radius: inner.spheres[0].radius,
            diagonal: mesh.diagonal(),
            reach: far.fold(0.0, f64::max).sqrt(),
            area: mesh.area(),
            volume: mesh.closed().map_or(0.0, |body| body.volume()),
            gaps: inner.gaps,
            spheres: moved(&inner.spheres, -centre),
            beyond: inner.beyond.clone(),
            crease,
            levels,
        }
    }

    /// The spheres by which bodies are pushed apart. Each is wider than its inner sphere by half of the greatest gap to
    /// the surface that is nearest to it, at most by R: so bodies overlap as much in some places as they are
    /// apart in others.
    pub fn widened(&self) -> impl Iterator<Item = Sphere> {
        let pairs = self.spheres.iter().zip(&self.beyond);
        pairs.map(|(sphere, beyond)| Sphere {
            radius: sphere.radius + (WIDENED * beyond).min(WIDEST * self.radius),
            ..*sphere
        })
    }

    /// M1: the mean number of bodies above a point of the surface if darts are R apart (density 1).
    pub fn layers(&self) -> f64 {
        FULL_COVER * 0.25 * self.area / (self.radius * self.radius)
    }

    /// The density sigma that suits the component: the root of a quarter of [`Component::layers`].
    pub fn density(&self) -> f64 {
        (0.25 * self.layers()).sqrt()
    }

    /// The finest level with at most `most` vertices; the coarsest if there is none.
    pub fn coarse(&self, most: usize) -> &Level {
        let fits = |level: &&Level| level.mesh.positions().len() <= most;
        let last = &self.levels[self.levels.len() - 1];
        self.levels.iter().find(fits).unwrap_or(last)
    }
}

fn moved(spheres: &[Sphere], by: DVec3) -> Vec<Sphere> {
    let each = spheres.iter().map(|s| Sphere {
        centre: s.centre + by,
        ..*s
    });
    each.collect()
}

/// The first component of a kind or a file, with all that its variants need.
#[derive(Clone, Debug)]
pub struct Original {
    /// The component.
    pub component: Component,
    /// The faults that were mended in the file.
    pub notices: Vec<Notice>,
    /// Its medial balls, the largest first.
    pool: Vec<Sphere>,
    vary: Vary,
    most: usize,
}

impl Original {
    /// Makes the component of a kind at once.
    pub fn of_kind(kind: ComponentKind) -> Self {
        let mut making = OriginalMaking::of_kind(kind);
        loop {
            if let Some(made) = making.advance(usize::MAX) {
                return made.expect("a component by rule has no fault");
            }
        }
    }

    /// Makes a variant at once; number 0 is the component itself.
    pub fn variant(self: &Arc<Self>, seed: u64, number: u64) -> Component {
        let mut making = VariantMaking::new(self.clone(), seed, number);
        loop {
            if let Some(made) = making.advance(usize::MAX) {
                return made;
            }
        }
    }
}

enum OriginalPhase {
    Check(Box<Checking>),
    /// The number of the next coarser level.
    Levels(usize, Option<Box<Simplifying>>),
    Inner(Box<InnerMaking>),
    Done,
}

/// Makes an [`Original`], in slices.
pub struct OriginalMaking {
    phase: OriginalPhase,
    kind: Option<ComponentKind>,
    levels: Vec<Level>,
    notices: Vec<Notice>,
    effort: Effort,
    vary: Vary,
    crease: f64,
}

impl OriginalMaking {
    /// Starts with a component by rule.
    pub fn of_kind(kind: ComponentKind) -> Self {
        let traits = kind.traits();
        let (mesh, marks) = kind.shell(0).into_mesh();
        let mut making = Self::new(
            OriginalPhase::Levels(0, None),
            traits.spheres,
            traits.vary,
            traits.crease,
        );
        making.kind = Some(kind);
        making.begin(mesh, marks);
        making
    }

    /// Starts with the triangles of a file. A file's component has variants like others; whoever wants it unchanged
    /// uses number 0 alone.
    pub fn of_file(soup: crate::trimesh::Soup) -> Self {
        let check = OriginalPhase::Check(Box::new(Checking::new(soup)));
        Self::new(check, FILE_SPHERES, Vary::FILE, FILE_CREASE)
    }

    fn new(phase: OriginalPhase, most: usize, vary: Vary, crease: f64) -> Self {
        let effort = Effort {
            samples: SAMPLES[0],
            every: EVERY,
            most,
        };
        Self {
            phase,
            kind: None,
            levels: Vec::new(),
            notices: Vec::new(),
            effort,
            vary,
            crease,
        }
    }

    fn begin(&mut self, mesh: TriMesh, marks: Vec<Mark>) {
        self.levels = vec![Level { mesh, marks }];
        self.phase = OriginalPhase::Levels(0, None);
    }

    /// Does work on about `amount` triangles, samples or balls. Returns the component in the end, or the fault of its
    /// file.
    pub fn advance(&mut self, amount: usize) -> Option<Result<Original, ComponentFault>> {
        match &mut self.phase {
            OriginalPhase::Check(checking) => match checking.advance(amount)? {
                Ok((mesh, notices)) => {
                    self.notices = notices;
                    let marks = vec![Mark::BODY; mesh.positions().len()];
                    self.begin(Arc::unwrap_or_clone(mesh), marks);
                }
                Err(fault) => return Some(Err(fault)),
            },
            OriginalPhase::Levels(..) => self.simplify(),
            OriginalPhase::Inner(inner) => {
                let made = inner.advance(amount)?;
                self.phase = OriginalPhase::Done;
                return Some(self.finish(made));
            }
            OriginalPhase::Done => {}
        }
        None
    }

    /// Does a slice of the coarser levels.
    fn simplify(&mut self) {
        let OriginalPhase::Levels(number, simplifying) = &mut self.phase else {
            return;
        };
        if let Some(current) = simplifying {
            let Some(mesh) = current.advance() else {
                return;
            };
            let level = self.levels[0].marked(mesh);
            self.levels.push(level);
            self.phase = OriginalPhase::Levels(*number + 1, None);
            return;
        }
        let Some(wanted) = wanted(self.kind, &self.levels[0], *number) else {
            let mesh = Arc::new(self.levels[0].mesh.clone());
            let inner = InnerMaking::new(mesh, self.effort, None);
            self.phase = OriginalPhase::Inner(Box::new(inner));
            return;
        };
        let (mesh, marks) = match self.kind {
            Some(kind) => kind.shell(*number + 1).into_mesh(),
            None => (self.levels[0].mesh.clone(), Vec::new()),
        };
        let is_ruled = self.kind.is_some();
        if is_ruled && mesh.triangles().len() as f64 <= ENOUGH * wanted as f64 {
            self.levels.push(Level { mesh, marks });
            self.phase = OriginalPhase::Levels(*number + 1, None);
        } else {
            let next = Simplifying::new(mesh, wanted, f64::INFINITY);
            *simplifying = Some(Box::new(next));
        }
    }

    fn finish(&mut self, inner: Option<Inner>) -> Result<Original, ComponentFault> {
        let inner = inner.ok_or(ComponentFault::Flat)?;
        let levels = std::mem::take(&mut self.levels);
        let component = Component::new(levels, &inner, self.crease);
        thick(component.radius, component.diagonal)?;
        let mut pool = moved(&inner.pool, -inner.spheres[0].centre);
        crate::order::sort(&mut pool, |ball| (!crate::order::rank(ball.radius), 0));
        Ok(Original {
            component,
            notices: std::mem::take(&mut self.notices),
            pool,
            vary: self.vary,
            most: self.effort.most,
        })
    }
}

/// The wanted number of triangles of a coarser level, by the level's number; `None` after the last one.
fn wanted(kind: Option<ComponentKind>, finest: &Level, number: usize) -> Option<usize> {
    if kind.is_some() {
        return COARSER[1..].get(number).copied();
    }
    let most = finest.mesh.triangles().len() / 2;
    let mut useful = COARSER.into_iter().filter(|&count| count < most);
    useful.nth(number)
}

/// Makes a variant, in slices. The medial balls of the original go through the variant's map, so few steps are left.
pub struct VariantMaking {
    original: Arc<Original>,
    map: Option<Variant>,
    /// The first level that is varied.
    first: usize,
    levels: Vec<Level>,
    building: Option<MeshBuilding>,
    inner: Option<InnerMaking>,
}

impl VariantMaking {
    /// Starts variant `number` under a seed; number 0 is the component itself.
    pub fn new(original: Arc<Original>, seed: u64, number: u64) -> Self {
        let component = &original.component;
        let finest = &component.levels[0].mesh;
        let map = Variant::new(finest.bounds(), &original.vary, (seed, number));
        let few = |level: &Level| level.mesh.triangles().len() <= VARIED;
        Self {
            map: (number > 0).then_some(map),
            first: component.levels.iter().position(few).unwrap_or(0),
            levels: Vec::new(),
            building: None,
            inner: None,
            original,
        }
    }

    /// Does work on about `amount` triangles, samples or balls; returns the variant when it is done.
    pub fn advance(&mut self, amount: usize) -> Option<Component> {
        let Some(map) = self.map else {
            return Some(self.original.component.clone());
        };
        if let Some(inner) = &mut self.inner {
            // If the map leaves no room for a sphere, the variant is the original.
            let made = inner.advance(amount)?;
            let levels = std::mem::take(&mut self.levels);
            let crease = self.original.component.crease;
            let made = made.map(|inner| Component::new(levels, &inner, crease));
            return Some(made.unwrap_or_else(|| self.original.component.clone()));
        }
        let all = &self.original.component.levels[self.first..];
        let Some(level) = all.get(self.levels.len()) else {
            self.begin_inner(&map);
            return None;
        };
        let building = self.building.get_or_insert_with(|| {
            let places = level.mesh.positions().iter().map(|&p| map.of(p));
            MeshBuilding::new(places.collect(), level.mesh.triangles().to_vec())
        });
        if let Some(mesh) = building.advance() {
            self.building = None;
            self.levels.push(Level {
                mesh: mesh.expect("the triangles of a mesh"),
                marks: level.marks.clone(),
            });
        }
        None
    }

    fn begin_inner(&mut self, map: &Variant) {
        let pool = &self.original.pool;
        // Small balls matter as much as large ones: they fill tips and corners.
        let every = pool.len().div_ceil(SHARED).max(1);
        let known = pool.iter().step_by(every).map(|ball| map.of(ball.centre));
        let effort = Effort {
            samples: SAMPLES[1],
            every: 1,
            most: self.original.most,
        };
        let mesh = Arc::new(self.levels[0].mesh.clone());
        self.inner = Some(InnerMaking::new(mesh, effort, Some(known.collect())));
    }
}
