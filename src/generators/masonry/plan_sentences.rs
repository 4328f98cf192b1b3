//! The sentences about faults of a drawn plan.

use crate::building::DrawnFault;
use crate::building::rules::{FARTHEST_CORNER, LEAST_OVER, LEAST_PIER, OpeningFault, SHARPEST};
use crate::decimal;
use crate::notice::{Code, Notice};

/// The most faults that have a sentence each.
const TOLD: usize = 8;

/// The remarks on a plan.
pub(super) fn remarks(faults: &[DrawnFault]) -> Vec<Notice> {
    let mut told: Vec<Notice> = faults.iter().take(TOLD).map(sentence).collect();
    let more = faults.len() - told.len();
    if more > 0 {
        told.push(Notice::new(Code::DrawnMore).with("n", more));
    }
    told
}

fn sentence(fault: &DrawnFault) -> Notice {
    use DrawnFault as Fault;
    match *fault {
        Fault::Few { corners, least } => Notice::new(Code::DrawnFew)
            .with("n", corners)
            .with("least", least),
        Fault::Short { wall, length } => Notice::new(Code::DrawnShort)
            .with("wall", wall)
            .with("length", tenths(length))
            .with("least", tenths(LEAST_PIER)),
        Fault::Sharp { corner, angle } => Notice::new(Code::DrawnSharp)
            .with("corner", corner)
            .with("angle", tenths(angle))
            .with("least", tenths(SHARPEST)),
        Fault::Crossing { at } => {
            Notice::new(Code::DrawnCrossing).with("at", at.map(tenths).join(", "))
        }
        Fault::Far { corners } => Notice::new(Code::DrawnFar)
            .with("n", corners)
            .with("most", FARTHEST_CORNER.to_string()),
        Fault::Roofless => Notice::new(Code::DrawnRoofless),
        Fault::Opening { opening, ref why } => of_opening(why).with("opening", opening),
    }
}

/// The sentence on a fault of an opening, without the opening's number.
fn of_opening(fault: &OpeningFault) -> Notice {
    use OpeningFault as Fault;
    match *fault {
        Fault::Number {
            place,
            range: [least, most],
            moved: [given, kept],
        } => Notice::new(Code::DrawnNumber)
            .with("place", place)
            .with("least", least.to_string())
            .with("most", most.to_string())
            .with("given", given.to_string())
            .with("kept", kept.to_string()),
        Fault::NoWall { wall, walls } => Notice::new(Code::DrawnNoWall)
            .with("wall", wall.to_string())
            .with("walls", walls),
        Fault::Beyond {
            wall,
            ends: [from, to],
            allowed: [least, most],
        } => Notice::new(Code::DrawnBeyond)
            .with("wall", wall)
            .with("from", from.to_string())
            .with("to", to.to_string())
            .with("least", least.to_string())
            .with("most", most.to_string()),
        Fault::Full { wall } => Notice::new(Code::DrawnFull)
            .with("wall", wall)
            .with("least", tenths(LEAST_PIER)),
        Fault::Over { other } => Notice::new(Code::DrawnOver)
            .with("other", other)
            .with("beside", tenths(LEAST_PIER))
            .with("above", tenths(LEAST_OVER)),
        Fault::High { top, most } => Notice::new(Code::DrawnHigh)
            .with("top", tenths(top))
            .with("most", tenths(most)),
    }
}

fn tenths(value: f64) -> String {
    decimal::text_to(1, value)
}
