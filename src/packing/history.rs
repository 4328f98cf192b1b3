//! A packing that can be shown at any of its steps, forward and back.
//!
//! A kept state is the whole run with its list of neighbours: forces are summed in the order of that list, so the
//! places alone would not give the same bits. States are kept every ten steps at first. Any step is made again from the
//! nearest kept state before it.

use super::Packing;
use super::run::Run;

/// Steps between two kept states.
const EVERY: u32 = 10;

/// The most bodies in all kept states together. Above this, every second state is dropped, so that going back takes
/// more steps.
const MOST_BODIES: usize = 200_000;

/// A packing whose states can be kept.
pub trait Kept: Clone {
    /// Steps made so far.
    fn steps(&self) -> u32;

    /// Whether the run has ended.
    fn is_over(&self) -> bool;

    /// Whether a step has begun and is not complete.
    fn is_in_a_step(&self) -> bool;

    /// The number of its cells.
    fn cell_count(&self) -> usize;

    /// A copy without the records and without data that the next step makes anew. Only to be called between steps.
    #[must_use]
    fn compact(&self) -> Self;

    /// Copies the records up to this state's own step from a later state of the same run.
    fn take_records(&mut self, later: &Self);
}

/// A packing with the kept states of its run.
#[derive(Clone, Debug)]
pub struct History<M> {
    /// The states after 0, `every`, 2 `every` ... steps. Kept states have no records: `latest` has them all.
    kept: Vec<M>,
    every: u32,
    /// The state that is shown.
    now: M,
    /// The state after the most steps so far.
    latest: M,
    /// The step asked for.
    asked: u32,
}

impl<M: Kept> History<M> {
    /// Begins with a packing of which no step has been made.
    pub fn new(first: M) -> Self {
        Self {
            kept: vec![first.compact()],
            every: EVERY,
            now: first.clone(),
            latest: first,
            asked: 0,
        }
    }

    /// The packing at the step that is shown.
    pub fn packing(&self) -> &M {
        &self.now
    }

    /// The shown packing, mutable because it caches measures such as its energy.
    pub fn packing_mut(&mut self) -> &mut M {
        &mut self.now
    }

    /// Asks for a step. A run that ends earlier stays at its end.
    pub fn ask(&mut self, step: u32) {
        self.asked = step;
        let at = (step / self.every) as usize;
        let from = &self.kept[at.min(self.kept.len() - 1)];
        let from = match self.latest.steps() <= step {
            true => &self.latest,
            false => from,
        };
        let now = self.now.steps();
        if now > step || now < from.steps() {
            self.now = from.clone();
            self.now.take_records(&self.latest);
        }
    }

    /// Goes towards the step that is asked for. `advance` makes a step of the packing or a slice of one. True when the
    /// step is reached or the run has ended.
    pub fn advance(&mut self, advance: impl FnOnce(&mut M)) -> bool {
        if self.is_there() {
            return true;
        }
        advance(&mut self.now);
        if self.now.is_in_a_step() {
            return false;
        }
        let step = self.now.steps();
        if step == self.every * self.kept.len() as u32 {
            self.kept.push(self.now.compact());
            self.thin_out();
        }
        if step > self.latest.steps() {
            self.latest = self.now.clone();
        }
        self.is_there()
    }

    fn is_there(&self) -> bool {
        let now = &self.now;
        !now.is_in_a_step() && (now.is_over() || now.steps() >= self.asked)
    }

    fn thin_out(&mut self) {
        let bodies = self.kept.iter().map(Kept::cell_count);
        if bodies.sum::<usize>() > MOST_BODIES && self.kept.len() > 2 {
            let mut index = 0;
            self.kept.retain(|_| {
                index += 1;
                index % 2 == 1
            });
            self.every *= 2;
        }
    }
}

impl<P: Copy> Run<P> {
    /// A copy without the records and without data that the next step makes anew. Only to be called between steps.
    pub fn compact(&self) -> Self {
        let mut kept = self.clone();
        (kept.samples, kept.changes) = (Vec::new(), Vec::new());
        kept.motion.compact();
        kept
    }

    /// Copies the records up to this state's own step from a later state of the same run.
    pub fn take_records(&mut self, later: &Self) {
        let step = self.report.step;
        let samples = later.samples.iter();
        self.samples = samples.copied().filter(|row| row.step <= step).collect();
        let changes = later.changes.iter();
        self.changes = changes.copied().filter(|row| row.step <= step).collect();
    }
}

impl Kept for Packing {
    fn steps(&self) -> u32 {
        self.run.report.step
    }

    fn is_over(&self) -> bool {
        self.done()
    }

    fn is_in_a_step(&self) -> bool {
        false
    }

    fn cell_count(&self) -> usize {
        self.run.bodies.len()
    }

    fn compact(&self) -> Self {
        Self {
            run: self.run.compact(),
            walls: self.walls.clone(),
            left_out: self.left_out,
        }
    }

    fn take_records(&mut self, later: &Self) {
        self.run.take_records(&later.run);
    }
}
