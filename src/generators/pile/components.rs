//! The first stage: the components of all types, with their variants.

use super::params::{ComponentParams, ComponentSource};
use crate::component::{Component, ComponentFault, Original, OriginalMaking, VariantMaking};
use crate::generators::scene_picture::Loaded;
use crate::notice::Notice;
use crate::trimesh::{Soup, TriMesh};
use glam::DVec3;
use std::rc::Rc;
use std::sync::Arc;

/// Triangles, samples or balls in a slice.
const SLICE: usize = 150;

/// A component's variants.
#[derive(Clone)]
pub(super) struct Variants {
    pub source: ComponentSource,
    /// The variants; the first one is the component itself.
    pub all: Vec<Arc<Component>>,
    /// Notices about faults of its file.
    pub notices: Vec<Notice>,
    key: (u64, u64),
}

/// The components of all types.
pub(super) type Components = Vec<Rc<Variants>>;

/// Components in progress.
#[derive(Default)]
pub(super) struct ComponentsMaking {
    made: Components,
    part: Part,
}

#[derive(Default)]
enum Part {
    #[default]
    Next,
    /// A component, and how a file's mesh was placed for it.
    Original(Box<OriginalMaking>, UnitFrame),
    Variants {
        original: Arc<Original>,
        made: Vec<Arc<Component>>,
        making: Box<VariantMaking>,
    },
}

impl ComponentsMaking {
    /// Does one slice. Components that were made before are taken from `kept`, and new ones are added to it.
    ///
    /// # Errors If a file of the recipe gives no component.
    pub fn advance(
        params: &ComponentParams,
        work: &mut Option<ComponentsMaking>,
        loaded: &Loaded,
        kept: &mut Components,
    ) -> Result<Option<Components>, Notice> {
        let making = work.get_or_insert_default();
        let Some(&source) = params.sources.get(making.made.len()) else {
            *kept = making.made.clone();
            return Ok(Some(std::mem::take(&mut making.made)));
        };
        let key = (params.seed, params.variants);
        if let Some(variants) = making.next((source, key), loaded, kept)? {
            making.made.push(variants);
            making.part = Part::Next;
        }
        Ok(None)
    }

    fn next(
        &mut self,
        (source, key): (ComponentSource, (u64, u64)),
        loaded: &Loaded,
        kept: &Components,
    ) -> Result<Option<Rc<Variants>>, Notice> {
        let (seed, count) = key;
        match &mut self.part {
            Part::Next => {
                let before = kept.iter().chain(&self.made);
                let mut same = before.filter(|one| one.source == source && one.key == key);
                if let Some(same) = same.next() {
                    return Ok(Some(same.clone()));
                }
                let (making, frame) = begin(source, loaded);
                self.part = Part::Original(Box::new(making), frame);
            }
            Part::Original(making, frame) => {
                if let Some(original) = making.advance(SLICE) {
                    let in_file = |fault: ComponentFault| fault.mapped(|at| frame.in_file(at));
                    let original = Arc::new(original.map_err(|fault| in_file(fault).notice())?);
                    self.part = Part::Variants {
                        making: Box::new(VariantMaking::new(original.clone(), seed, 0)),
                        made: Vec::new(),
                        original,
                    };
                }
            }
            Part::Variants {
                original,
                made,
                making,
            } => {
                if let Some(variant) = making.advance(SLICE) {
                    made.push(Arc::new(variant));
                    let number = made.len() as u64;
                    if number == count {
                        return Ok(Some(Rc::new(Variants {
                            source,
                            all: std::mem::take(made),
                            notices: original.notices.clone(),
                            key,
                        })));
                    }
                    **making = VariantMaking::new(original.clone(), seed, number);
                }
            }
        }
        Ok(None)
    }
}

fn begin(source: ComponentSource, loaded: &Loaded) -> (OriginalMaking, UnitFrame) {
    match source {
        ComponentSource::Kind(kind) => (OriginalMaking::of_kind(kind), UnitFrame::HOME),
        ComponentSource::File {
            number, is_z_up, ..
        } => {
            let mesh = &loaded.meshes[number];
            let frame = UnitFrame::of(mesh, is_z_up);
            let positions = mesh.positions().iter();
            let soup = Soup {
                positions: positions.map(|p| frame.in_unit(*p)).collect(),
                triangles: mesh.triangles().to_vec(),
            };
            (OriginalMaking::of_file(soup), frame)
        }
    }
}

/// How a file's mesh is moved and scaled: half of its longest side is 1 then, as components by rule have it.
#[derive(Clone, Copy)]
struct UnitFrame {
    middle: DVec3,
    half: f64,
    /// Whether z is up in the file; y is up in the mesh.
    is_z_up: bool,
}

impl UnitFrame {
    /// Leaves everything where it is.
    const HOME: Self = Self {
        middle: DVec3::ZERO,
        half: 1.0,
        is_z_up: false,
    };

    fn of(mesh: &TriMesh, is_z_up: bool) -> Self {
        let (low, high) = mesh.bounds();
        Self {
            middle: 0.5 * (low + high),
            half: 0.5 * (high - low).max_element(),
            is_z_up,
        }
    }

    fn in_unit(&self, p: DVec3) -> DVec3 {
        (p - self.middle) / self.half
    }

    /// A place of the component in the file's coordinates.
    fn in_file(&self, p: DVec3) -> DVec3 {
        let at = self.middle + self.half * p;
        match self.is_z_up {
            true => DVec3::new(at.x, -at.z, at.y),
            false => at,
        }
    }
}
