//! Keeps the value of one task.

use crate::notice::Notice;

/// The revisions of a value's inputs, in the order of its task; unused ones are 0.
pub type Inputs = [u64; 3];

/// Whether a node has work to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// The value was made with the present parameters from these inputs.
    Fresh,
    /// The value has not been made yet.
    Stale,
    /// The value cannot be made with these parameters from these inputs.
    Failed,
}

/// Keeps the parameters `P` of a task, the work `W` in progress, and the last value `T`. The last value stays visible
/// until the next one is made.
#[derive(Debug)]
pub struct Node<P, W, T> {
    /// The present parameters.
    params: P,
    /// The latest recipe's parameters, if they differ.
    asked: Option<P>,
    work: Option<W>,
    /// The last value, and the parameters that it was made with.
    made: Option<(P, T)>,
    status: Status,
}

/// The part of a node that does not depend on its types.
#[derive(Debug, Default)]
pub struct Status {
    /// The inputs of the value; `None` before there is one.
    made_of: Option<Inputs>,
    /// Whether the value was made with the present parameters.
    is_wanted: bool,
    /// The inputs of the work in progress, or of the failed work.
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

    /// Whether the value was made from inputs of these revisions, with any parameters.
    pub fn was_made_of(&self, inputs: Inputs) -> bool {
        self.made_of == Some(inputs)
    }

    /// Why the value cannot be made.
    pub fn failure(&self) -> Option<&Notice> {
        self.failure.as_ref()
    }

    /// The number of values made so far.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Increases with every slice of work, and whenever work is dropped.
    pub fn slices(&self) -> u64 {
        self.slices
    }
}

/// A node, whatever its types are.
pub trait AnyNode {
    /// Its status.
    fn status(&self) -> &Status;

    /// Whether the latest recipe has other parameters than the present ones.
    fn is_stale(&self) -> bool;

    /// Makes the latest recipe's parameters the present ones. Drops work with other parameters.
    fn take_up(&mut self);

    /// Begins or continues the work on these inputs. Drops work on other inputs.
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

    /// Notes the latest recipe's parameters. The work continues with the present ones until `take_up`.
    pub fn ask(&mut self, params: P) {
        self.asked = (params != self.params).then_some(params);
    }

    /// Makes the value stale, whatever its parameters and inputs are.
    pub fn forget(&mut self) {
        self.status.is_wanted = false;
        self.drop_work();
    }

    /// Continues with this work instead of the work in progress, on the same inputs.
    pub fn go_on(&mut self, work: W) {
        self.work = Some(work);
    }

    fn drop_work(&mut self) {
        (self.work, self.status.failure) = (None, None);
        self.status.slices += 1;
    }

    /// The present parameters.
    pub fn params(&self) -> &P {
        &self.params
    }

    /// The latest recipe's parameters.
    pub fn latest(&self) -> &P {
        self.asked.as_ref().unwrap_or(&self.params)
    }

    /// Does one slice of the work: `slice` begins the work, continues it, or ends it with a value. Always returns
    /// `Some`, like a task whose inputs all exist.
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

    /// The last value, stale or not.
    pub fn made(&self) -> Option<&T> {
        self.made.as_ref().map(|(_, value)| value)
    }

    /// Whether the value was made with the present parameters from these inputs.
    #[cfg(house)]
    pub fn is_fresh(&self, inputs: Inputs) -> bool {
        self.status.state(inputs) == State::Fresh
    }

    /// The value if it was made from these inputs, with any parameters.
    pub(super) fn made_of(&self, inputs: Inputs) -> Option<&T> {
        self.made().filter(|_| self.status.was_made_of(inputs))
    }

    /// The work in progress, on any inputs. It stays visible until new work begins.
    pub fn work(&self) -> Option<&W> {
        self.work.as_ref()
    }

    /// The work in progress on these inputs.
    pub(super) fn work_of(&self, inputs: Inputs) -> Option<&W> {
        self.work().filter(|_| self.status.begun_of == inputs)
    }

    /// The work in progress and the last value.
    pub fn both_mut(&mut self) -> (Option<&mut W>, Option<&mut T>) {
        let made = self.made.as_mut().map(|(_, value)| value);
        (self.work.as_mut(), made)
    }

    /// The number of values made so far. A reader compares it to find out if there is a new one.
    pub fn revision(&self) -> u64 {
        self.status.revision
    }

    /// How often work was begun.
    pub fn passes(&self) -> u64 {
        self.status.passes
    }

    /// Increases with every slice of work, and whenever work is dropped.
    #[cfg(house)]
    pub fn slices(&self) -> u64 {
        self.status.slices
    }
}
