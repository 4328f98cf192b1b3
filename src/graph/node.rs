//! The memo of one task.

use crate::notice::Notice;

/// The revisions of the inputs of a value, in the order of its task; 0 where there are fewer.
pub type Inputs = [u64; 3];

/// Whether a node has work to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Its value is made by the parameters at work, of these inputs.
    Fresh,
    /// Its value has still to be made.
    Stale,
    /// Its value cannot be made by these parameters, of these inputs.
    Failed,
}

/// A memo: parameters `P`, work in progress `W`, and the value `T` that was made last. The value stays, to be
/// shown, until the next one is there.
#[derive(Debug)]
pub struct Node<P, W, T> {
    /// The parameters at work.
    params: P,
    /// Those of the latest recipe, where they differ.
    asked: Option<P>,
    work: Option<W>,
    /// The last value, and the parameters that it was made by.
    made: Option<(P, T)>,
    status: Status,
}

/// The part of a node that does not depend on its types.
#[derive(Debug, Default)]
pub struct Status {
    /// The inputs of the value; none before there is one.
    made_of: Option<Inputs>,
    /// Was the value made by the parameters at work?
    is_wanted: bool,
    /// The inputs of the work, or of its failure.
    begun_of: Inputs,
    failure: Option<Notice>,
    revision: u64,
    passes: u64,
    slices: u64,
}

impl Status {
    /// The state for inputs of these revisions.
    pub fn state(&self, inputs: Inputs) -> State {
        if self.is_wanted && self.made_of == Some(inputs) {
            State::Fresh
        } else if self.failure.is_some() && self.begun_of == inputs {
            State::Failed
        } else {
            State::Stale
        }
    }

    /// Why the value cannot be made.
    pub fn failure(&self) -> Option<&Notice> {
        self.failure.as_ref()
    }

    /// The number of values made so far.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Grows with every slice of work, and whenever work is dropped.
    pub fn slices(&self) -> u64 {
        self.slices
    }
}

/// A node of any types.
pub trait AnyNode {
    /// Its status.
    fn status(&self) -> &Status;

    /// Does the latest recipe ask for other parameters than those at work?
    fn is_stale(&self) -> bool;

    /// Takes up the parameters of the latest recipe. Work by others is dropped.
    fn take_up(&mut self);

    /// Begins or continues the work on these inputs. Work on other inputs is dropped.
    fn begin(&mut self, inputs: Inputs);

    /// Ends the work without a value.
    fn fail(&mut self, why: Notice);
}

impl<P: Clone + PartialEq, W, T> AnyNode for Node<P, W, T> {
    fn status(&self) -> &Status {
        &self.status
    }

    fn is_stale(&self) -> bool {
        self.asked.is_some()
    }

    fn take_up(&mut self) {
        if let Some(params) = self.asked.take() {
            let made = self.made.as_ref();
            self.status.is_wanted = made.is_some_and(|(by, _)| *by == params);
            self.params = params;
            self.drop_work();
        }
    }

    fn begin(&mut self, inputs: Inputs) {
        if self.status.begun_of != inputs {
            (self.work, self.status.begun_of) = (None, inputs);
        }
        self.status.failure = None;
        self.status.passes += u64::from(self.work.is_none());
        self.status.slices += 1;
    }

    fn fail(&mut self, why: Notice) {
        (self.work, self.status.failure) = (None, Some(why));
    }
}

impl<P: Clone + PartialEq, W, T> Node<P, W, T> {
    /// A node that has made nothing yet.
    pub fn new(params: P) -> Self {
        Self {
            params,
            asked: None,
            work: None,
            made: None,
            status: Status::default(),
        }
    }

    /// Notes the parameters of the latest recipe; the work goes on by those at work until they are taken up.
    pub fn ask(&mut self, params: P) {
        self.asked = (params != self.params).then_some(params);
    }

    /// Makes the value stale, whatever it was made of.
    pub fn forget(&mut self) {
        self.status.is_wanted = false;
        self.drop_work();
    }

    fn drop_work(&mut self) {
        (self.work, self.status.failure) = (None, None);
        self.status.slices += 1;
    }

    /// The parameters at work.
    pub fn params(&self) -> &P {
        &self.params
    }

    /// The parameters of the latest recipe.
    pub fn latest(&self) -> &P {
        self.asked.as_ref().unwrap_or(&self.params)
    }

    /// One slice of the work: `slice` begins it, continues it, or ends it with a value. It answers with
    /// `Some`, as a task does whose inputs are all there.
    pub fn advance(
        &mut self,
        slice: impl FnOnce(&P, &mut Option<W>) -> Result<Option<T>, Notice>,
    ) -> Option<()> {
        match slice(&self.params, &mut self.work) {
            Ok(None) => {}
            Ok(Some(value)) => {
                self.work = None;
                self.made = Some((self.params.clone(), value));
                self.status.revision += 1;
                self.status.is_wanted = true;
                self.status.made_of = Some(self.status.begun_of);
            }
            Err(why) => self.fail(why),
        }
        Some(())
    }

    /// The value that was made last, stale or not.
    pub fn made(&self) -> Option<&T> {
        self.made.as_ref().map(|(_, value)| value)
    }

    /// The value if it was made of these inputs, by whatever parameters.
    pub(super) fn made_of(&self, inputs: Inputs) -> Option<&T> {
        self.made().filter(|_| self.status.made_of == Some(inputs))
    }

    /// The work in progress, of whatever inputs: it stays, to be shown, until it is begun anew.
    pub fn work(&self) -> Option<&W> {
        self.work.as_ref()
    }

    /// The same, for work that keeps the answers to some questions.
    pub fn work_mut(&mut self) -> Option<&mut W> {
        self.work.as_mut()
    }

    /// The work in progress on these inputs.
    pub(super) fn work_of(&self, inputs: Inputs) -> Option<&W> {
        self.work().filter(|_| self.status.begun_of == inputs)
    }

    /// The work in progress and the value that was made last.
    pub fn both_mut(&mut self) -> (Option<&mut W>, Option<&mut T>) {
        let made = self.made.as_mut().map(|(_, value)| value);
        (self.work.as_mut(), made)
    }

    /// The number of values made so far; readers compare it to see whether there is a new one.
    pub fn revision(&self) -> u64 {
        self.status.revision
    }

    /// How often the work was begun, from the start or anew.
    pub fn passes(&self) -> u64 {
        self.status.passes
    }

    /// Grows with every slice of work, and whenever work is dropped.
    pub fn slices(&self) -> u64 {
        self.status.slices
    }
}
