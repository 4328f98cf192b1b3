//! The sentences about buildings and modules: why a building or a module is refused, and what may look wrong.

use crate::building::{
    ArcFault, Building, BuildingFault, BuildingWarning, EdgeId, FaceId, MOST_FACES, MOST_SIDES,
    Misfit, PolygonFault, SurfaceFault,
};
use crate::decimal;
use crate::masonry::laying::{Laying, LayingWarning};
use crate::masonry::module::ModuleFault;
use crate::masonry::plan::{CourseWarning, PlanFault, PlanWarning};
use crate::notice::{Code, Notice, quote, quote_long};
use glam::DVec3;

/// The most open edges whose places a sentence lists.
const MOST_PLACES: usize = 3;

/// Why a building's file or its shape is refused.
pub(super) fn unread(fault: &BuildingFault) -> Notice {
    use BuildingFault as Fault;
    match fault {
        Fault::NotJson { line, column, .. } => Notice::new(Code::BuildingJson)
            .with("line", *line)
            .with("column", *column),
        Fault::NotObj(notice) => notice.clone(),
        Fault::Version { found } => Notice::new(Code::BuildingVersion).with("found", quote(found)),
        Fault::Unit { found } => Notice::new(Code::BuildingUnit).with("found", quote(found)),
        Fault::Field { path, allowed } => Notice::new(Code::BuildingField)
            .with("path", quote_long(path))
            .with("allowed", (*allowed).to_owned()),
        Fault::Number { path, found } => Notice::new(Code::BuildingNumber)
            .with("path", quote_long(path))
            .with("found", quote(found)),
        Fault::Far { vertex, found, .. } => Notice::new(Code::BuildingFar)
            .with("vertex", *vertex)
            .with("found", quote(found)),
        Fault::Empty => Code::BuildingEmpty.into(),
        Fault::TooManyFaces { faces } => counted(Code::BuildingFaces, *faces, MOST_FACES),
        Fault::TooManySides { sides } => counted(Code::BuildingSides, *sides, MOST_SIDES),
        Fault::NoVertex { path, vertex } => Notice::new(Code::BuildingVertex)
            .with("path", quote_long(path))
            .with("vertex", *vertex as usize),
        Fault::BadArc { arc, why } => Notice::new(arc_code(*why)).with("arc", *arc),
        Fault::NonManifold { vertices, faces } => {
            between(Code::BuildingManifold, *vertices).with("n", faces.len())
        }
        Fault::TurnedOver { vertices, faces } => between(Code::BuildingTurned, *vertices)
            .with("one", faces[0].index())
            .with("other", faces[1].index()),
        Fault::Polygons {
            vertices,
            polygons,
            why,
        } => of_polygons(*vertices, *polygons, *why),
        fault => of_face(fault),
    }
}

/// A building was moved by whole metres to its origin.
pub(super) fn moved(by: DVec3) -> Notice {
    Notice::new(Code::BuildingMoved)
        .with("x", decimal::text(by.x))
        .with("y", decimal::text(by.y))
        .with("z", decimal::text(by.z))
}

/// The sentence of two polygons that run the same way. OBJ files number vertices from 1.
fn of_polygons(vertices: [usize; 2], polygons: [usize; 2], why: PolygonFault) -> Notice {
    let ([a, b], [one, other]) = (vertices, polygons);
    let side = |code: Code| Notice::new(code).with("a", a + 1).with("b", b + 1);
    let one = |notice: Notice| notice.with("one", one + 1);
    let both = |notice: Notice| one(notice).with("other", other + 1);
    match why {
        PolygonFault::Turned => both(side(Code::BuildingPolygonTurned)),
        PolygonFault::Many(n) => side(Code::BuildingPolygonsMeet).with("n", n),
        PolygonFault::Twice => both(Notice::new(Code::BuildingPolygonTwice)),
        PolygonFault::Itself => one(side(Code::BuildingPolygonItself)),
    }
}

/// The sentence of a fault of one face.
fn of_face(fault: &BuildingFault) -> Notice {
    use BuildingFault as Fault;
    let face = |code: Code, face: &FaceId| Notice::new(code).with("face", face.index());
    match fault {
        Fault::ShortLoop { face: id, ring } => face(Code::BuildingLoop, id).with("ring", *ring),
        Fault::NoSurface { face: id } => face(Code::BuildingNoSurface, id),
        Fault::BadSurface { face: id, why } => face(surface_code(*why), id),
        Fault::OffSurface { face: id, at, by } => face(Code::BuildingOff, id)
            .with("at", place(*at))
            .with("by", decimal::text_to(1, 1e3 * by)),
        Fault::Crossing { face: id, at } => face(Code::BuildingCrossing, id).with("at", place(*at)),
        Fault::NotOnCircle { face: id, at } => {
            face(Code::BuildingCircle, id).with("at", place(*at))
        }
        Fault::InsideOut { face: id } => face(Code::BuildingInsideOut, id),
        _ => Code::ModelNoArea.into(),
    }
}

fn arc_code(why: ArcFault) -> Code {
    match why {
        ArcFault::NoAxis => Code::BuildingArcAxis,
        ArcFault::Radius => Code::BuildingArcRadius,
        ArcFault::Plane => Code::BuildingArcPlane,
        ArcFault::Twice => Code::BuildingArcTwice,
    }
}

fn surface_code(why: SurfaceFault) -> Code {
    match why {
        SurfaceFault::NoLength => Code::BuildingNoLength,
        SurfaceFault::Gap => Code::BuildingGap,
        SurfaceFault::Kink => Code::BuildingKink,
        SurfaceFault::Direction => Code::BuildingDirection,
        SurfaceFault::Turns => Code::BuildingTurns,
        SurfaceFault::Unbounded => Code::BuildingUnbounded,
    }
}

/// Why half a brick of this width does not suit the building.
pub(super) fn refusal(fault: &PlanFault, module: f64) -> Notice {
    let told = |code: Code, width: f64| {
        Notice::new(code)
            .with("module", millimetres(module))
            .with("width", millimetres(width))
    };
    match fault {
        PlanFault::Module(ModuleFault::Uneven) => Code::MasonryUneven.into(),
        PlanFault::Module(_) => Code::MasonryJoint.into(),
        PlanFault::Misfit(Misfit::ModuleTooLarge { width, .. }) => told(Code::MasonryLarge, *width),
        PlanFault::Misfit(Misfit::TooNarrow { width, .. }) => told(Code::MasonryNarrow, *width),
        PlanFault::Misfit(Misfit::TooThin { thickness, .. }) => {
            told(Code::MasonryTooThin, *thickness)
        }
    }
}

/// Remarks on what may look wrong. Buildings by rule suit their module, so they only have remarks on conflicts and
/// narrow panels. `is_given` marks a building of a file or of a visitor's plan. `gone` is the number of flips whose
/// corner or edge does not exist.
pub(super) fn remarks(laying: &Laying, (gone, is_given): (usize, bool)) -> Vec<Notice> {
    let (building, plan) = (laying.building(), laying.plan());
    let of_building = building.warnings().iter().filter(|_| is_given);
    let of_building = of_building.map(|warning| odd(building, warning));
    let conflicts = plan
        .conflicts
        .iter()
        .map(|&edge| Notice::new(Code::MasonryConflict).with("at", place(middle(building, edge))));
    let others = plan.warnings.iter().filter(|_| is_given);
    let others = others.filter_map(uneven);
    let is_panel = |told: &&LayingWarning| matches!(told, LayingWarning::NoRoom { .. });
    let panels = laying.warnings().iter().filter(is_panel).count();
    let left_out = [(Code::MasonryFlips, gone), (Code::MasonryPanel, panels)]
        .into_iter()
        .filter(|(_, n)| *n > 0)
        .map(|(code, n)| Notice::new(code).with("n", n));
    let all = of_building.chain(conflicts).chain(others).chain(left_out);
    all.collect()
}

fn odd(building: &Building, warning: &BuildingWarning) -> Notice {
    match warning {
        BuildingWarning::OpenEdges(edges) => {
            let places = edges.iter().take(MOST_PLACES);
            let places = places.map(|&edge| format!("({})", place(middle(building, edge))));
            Notice::new(Code::BuildingOpen)
                .with("n", edges.len())
                .with("places", places.collect::<Vec<_>>().join(" "))
        }
        BuildingWarning::Pinched(corner) => {
            Notice::new(Code::BuildingPinched).with("at", place(building.place(*corner)))
        }
        BuildingWarning::NoSuchEdge { vertices } => between(Code::BuildingNoEdge, *vertices),
        BuildingWarning::NoSuchCorner { vertex } => {
            Notice::new(Code::BuildingNoCorner).with("vertex", *vertex as usize)
        }
        BuildingWarning::UnusedArc { arc } => {
            Notice::new(Code::BuildingUnusedArc).with("arc", *arc)
        }
    }
}

/// The sentence on courses, columns or walls that differ much from the module. `None` for conflicts, which are listed
/// elsewhere.
fn uneven(warning: &PlanWarning) -> Option<Notice> {
    let ends = |code: Code, low: f64, high: f64| {
        Notice::new(code)
            .with("from", decimal::text_to(3, low))
            .with("to", decimal::text_to(3, high))
    };
    let share = |ratio: f64| decimal::text_to(2, ratio);
    Some(match warning {
        PlanWarning::Conflict(_) => return None,
        PlanWarning::Courses { what, .. } => match *what {
            CourseWarning::Near { low, high } => ends(Code::MasonryNear, low, high),
            CourseWarning::Stretched { low, high, ratio } => {
                ends(Code::MasonryCourses, low, high).with("ratio", share(ratio))
            }
        },
        PlanWarning::Columns {
            ends: [low, high],
            ratio,
            ..
        } => ends(Code::MasonryColumns, *low, *high).with("ratio", share(*ratio)),
        PlanWarning::Thin(wall) => {
            Notice::new(Code::MasonryThin).with("width", millimetres(wall.thickness))
        }
    })
}

fn counted(code: Code, n: usize, most: usize) -> Notice {
    Notice::new(code).with("n", n).with("most", most)
}

fn between(code: Code, [a, b]: [u32; 2]) -> Notice {
    Notice::new(code)
        .with("a", a as usize)
        .with("b", b as usize)
}

fn middle(building: &Building, edge: EdgeId) -> DVec3 {
    let edge = building.edge(edge);
    edge.path.point(0.5 * edge.length())
}

/// A sentence with a size in metres, to the decimetre.
pub(super) fn sized(code: Code, size: [f64; 3]) -> Notice {
    let [x, y, z] = size.map(|v| decimal::text_to(1, v));
    Notice::new(code).with("x", x).with("y", y).with("z", z)
}

/// A place in metres, to the millimetre.
fn place(p: DVec3) -> String {
    p.to_array().map(|v| decimal::text_to(3, v)).join(", ")
}

fn millimetres(metres: f64) -> usize {
    (1e3 * metres).round() as usize
}
