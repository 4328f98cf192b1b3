//! Whether a building is large enough for a module of masonry.

use super::class::Bend;
use super::ids::{EdgeId, FaceId};
use super::parent::Stance;
use super::rules::Module;
use super::whole::Building;
use crate::order::{self, rank};

/// The least interval between corners, in modules.
const LEAST_INTERVAL: f64 = 0.5;
/// The least width of a wall, in modules.
const LEAST_WIDTH: f64 = 2.0;
/// The least depth of a wall, in modules. Walls between this and one module are listed as thin.
const LEAST_DEPTH: f64 = 0.5;

/// Why a module cannot be laid on a building.
#[derive(Clone, Debug, PartialEq)]
pub enum Misfit {
    /// In a group of upright faces that meet, all intervals between corners are shorter than half a module.
    ModuleTooLarge {
        /// The face of the group with the widest interval.
        face: FaceId,
        /// Its width (metres).
        width: f64,
        /// The module (metres).
        module: f64,
    },
    /// Two parallel edges of an upright face are closer than two modules, and both are convex.
    TooNarrow {
        /// The face.
        face: FaceId,
        /// The distance of the two edges (metres).
        width: f64,
        /// Two modules less a joint (metres).
        least: f64,
    },
    /// A wall is thinner than half a module.
    TooThin {
        /// The face.
        face: FaceId,
        /// Its thickness (metres).
        thickness: f64,
        /// Half a module (metres).
        least: f64,
    },
}

/// A wall that is thinner than a module: cells are laid to half of its thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThinWall {
    /// The face.
    pub face: FaceId,
    /// Its thickness (metres).
    pub thickness: f64,
}

impl Building {
    /// Tests whether a module can be laid on the building, and lists thin walls. `thickness` gives the thickness of the
    /// wall behind each face (metres), infinite where there is no back.
    ///
    /// # Errors
    /// The first misfit.
    pub fn fits(
        &self,
        module: &Module,
        thickness: impl Fn(FaceId) -> f64,
    ) -> Result<Vec<ThinWall>, Misfit> {
        self.group_fits(module)?;
        let upright = || {
            self.face_ids()
                .filter(|&id| self.face(id).stance() == Stance::Upright)
        };
        let narrow = |face: FaceId| {
            let width = self.narrowest(face)?;
            let least = LEAST_WIDTH * module.half - module.joint;
            (width < least - 1e-6).then_some(Misfit::TooNarrow { face, width, least })
        };
        if let Some(misfit) = upright().find_map(narrow) {
            return Err(misfit);
        }
        thin_walls(module, upright(), thickness)
    }

    /// Tests each group of upright faces that have edges in common.
    fn group_fits(&self, module: &Module) -> Result<(), Misfit> {
        let mut seen = vec![false; self.faces().len()];
        for first in self.face_ids() {
            let (mut open, mut best): (Vec<FaceId>, Option<(f64, FaceId, f64)>) =
                (vec![first], None);
            while let Some(id) = open.pop() {
                let is_upright = self.face(id).stance() == Stance::Upright;
                if !is_upright || std::mem::replace(&mut seen[id.index()], true) {
                    continue;
                }
                let [low, high] = self.face(id).bounds();
                let widest = self.widest_interval(id);
                if best.is_none_or(|best| widest > best.0) {
                    best = Some((widest, id, high.x - low.x));
                }
                let uses = self.face(id).loops.iter().flatten();
                open.extend(uses.filter_map(|step| self.edge(step.edge).across(id)));
            }
            if let Some((widest, face, width)) = best
                && widest < LEAST_INTERVAL * module.half
            {
                let module = module.half;
                return Err(Misfit::ModuleTooLarge {
                    face,
                    width,
                    module,
                });
            }
        }
        Ok(())
    }

    /// The widest interval of s between neighbouring corners of a face (metres); on a whole cylinder, its whole width.
    fn widest_interval(&self, face: FaceId) -> f64 {
        let own = self.face(face);
        let uses = own.loops.iter().flatten();
        let ends = uses.flat_map(|step| self.edge(step.edge).corners);
        let s = |corner| own.surface.project(self.place(corner)).x;
        let mut all: Vec<f64> = ends.flatten().map(s).collect();
        order::sort(&mut all, |&s| (rank(s), 0));
        let [low, high] = own.bounds();
        let gaps = all.windows(2).map(|pair| pair[1] - pair[0]);
        let widest = gaps.fold(0.0, f64::max);
        if own.surface.period().is_some() {
            high.x - low.x
        } else {
            widest
        }
    }

    /// The least distance (metres) of two convex vertical edges of an upright face that overlap in height and have the
    /// face between them; `None` if there are no such edges.
    fn narrowest(&self, face: FaceId) -> Option<f64> {
        let own = self.face(face);
        let side = |id: EdgeId, forward: bool| {
            let edge = self.edge(id);
            if edge.bend != Bend::Convex || !edge.is_vertical() {
                return None;
            }
            let ends = [0.0, edge.length()].map(|s| own.surface.project(edge.path.point(s)));
            let rises = (ends[1].y > ends[0].y) == forward;
            Some((
                ends[0].x,
                ends[0].y.min(ends[1].y),
                ends[0].y.max(ends[1].y),
                rises,
            ))
        };
        let uses = own.loops.iter().flatten();
        let all: Vec<_> = uses
            .filter_map(|step| side(step.edge, step.forward))
            .collect();
        // Loops have the face on their left, so its right side rises and its left side falls.
        let period = own.surface.period();
        let right = all.iter().filter(|side| side.3);
        let pairs = right.flat_map(|right| {
            all.iter()
                .filter(|side| !side.3)
                .map(move |left| (left, right))
        });
        let overlap = pairs.filter(|(a, b)| a.1.max(b.1) < a.2.min(b.2) - 1e-6);
        let widths = overlap.filter_map(|(left, right)| {
            let width = right.0 - left.0;
            let width = period.map_or(width, |period| width - period * (width / period).floor());
            (width > 0.0).then_some(width)
        });
        widths.reduce(f64::min)
    }
}

fn thin_walls(
    module: &Module,
    faces: impl Iterator<Item = FaceId>,
    thickness: impl Fn(FaceId) -> f64,
) -> Result<Vec<ThinWall>, Misfit> {
    let mut thin = Vec::new();
    for face in faces {
        let thickness = thickness(face);
        let least = LEAST_DEPTH * module.half;
        if thickness < least {
            return Err(Misfit::TooThin {
                face,
                thickness,
                least,
            });
        }
        if thickness < module.half - module.joint - 1e-6 {
            thin.push(ThinWall { face, thickness });
        }
    }
    Ok(thin)
}

#[cfg(test)]
mod tests {
    use super::super::rules::{Module, Rule};
    use super::super::tests::built;
    use super::super::thickness::WallThickness;
    use super::*;
    use std::sync::Arc;

    /// The thickness behind the middle of a face.
    fn behind(building: &Building) -> impl Fn(FaceId) -> f64 + '_ {
        let depths = WallThickness::new(Arc::new(building.clone())).expect("a mesh");
        move |id| {
            let [low, high] = building.face(id).bounds();
            let middle = low.midpoint(high);
            depths
                .behind(id, middle.x, middle.y, f64::INFINITY)
                .unwrap_or(f64::INFINITY)
        }
    }

    fn block(module: &Module, numbers: &[f64]) -> Building {
        built("block", &Rule::Block.draft(module, numbers))
    }

    #[test]
    fn buildings_by_rule_fit_their_module() {
        for rule in Rule::ALL {
            let draft = rule.draft(&Module::NORMAL, &[]);
            let building = built(rule.word(), &draft);
            let fits = building.fits(&Module::NORMAL, behind(&building));
            assert_eq!(fits, Ok(Vec::new()), "{}", rule.word());
        }
    }

    #[test]
    fn stones_larger_than_the_building_are_refused() {
        let inch = Module {
            half: 0.0127,
            course: 0.0127,
            joint: 0.0,
        };
        let foot = Module {
            half: 0.6,
            ..Module::NORMAL
        };
        let misfit = block(&inch, &[2.0, 2.0, 2.0])
            .fits(&foot, |_| f64::INFINITY)
            .unwrap_err();
        let Misfit::ModuleTooLarge { width, module, .. } = misfit else {
            panic!("{misfit:?}");
        };
        assert!((width - 0.0254).abs() < 1e-9 && module == 0.6);
        let small = Module {
            half: 0.056,
            ..Module::NORMAL
        };
        let misfit = block(&small, &[2.0, 2.0, 4.0])
            .fits(&Module::NORMAL, |_| f64::INFINITY)
            .unwrap_err();
        assert!(matches!(misfit, Misfit::TooNarrow { .. }), "{misfit:?}");
    }

    #[test]
    fn thin_walls_are_told_or_refused() {
        let sheet = |thickness: f64| {
            let mut draft = Rule::Sheet.draft(&Module::NORMAL, &[]);
            draft.faces[0].thickness = Some(thickness);
            let building = built("sheet", &draft);
            building.fits(&Module::NORMAL, behind(&building))
        };
        assert!(matches!(sheet(0.05), Err(Misfit::TooThin { .. })));
        assert_eq!(
            sheet(0.1).unwrap(),
            [ThinWall {
                face: FaceId(0),
                thickness: 0.1
            }]
        );
        assert_eq!(sheet(0.2), Ok(Vec::new()));
    }

    #[test]
    fn thickness_is_the_way_to_the_other_side() {
        let draft = Rule::Wall.draft(&Module::NORMAL, &[]);
        let building = built("wall", &draft);
        let depths = WallThickness::new(Arc::new(building.clone())).unwrap();
        let wanted = 3.0 * 0.125 - 0.01;
        for face in [FaceId(0), FaceId(1)] {
            let [low, high] = building.face(face).bounds();
            let depth = depths
                .behind(face, low.x + 0.1, high.y - 0.1, f64::INFINITY)
                .unwrap();
            assert!((depth - wanted).abs() < 1e-9, "{depth}");
        }
    }
}
