//! What cells are packed on: the domain and the fields over it.

use super::stage::Stage;
use crate::domain::{Domain, Outline};
use crate::field::{FieldBuilder, FieldParams, Fields};
use crate::graph::{Node, State};
use glam::DVec2;

/// What the domain is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum DomainParams {
    /// Rings, checked, and lines.
    Plane(Outline),
    /// The whole picture, whose edges fit each other, with lines.
    Torus { side: f64, lines: Vec<Vec<DVec2>> },
}

/// What is asked of both.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TerrainParams {
    pub domain: DomainParams,
    pub fields: FieldParams,
}

/// The domain and its fields.
pub(super) struct Terrain {
    pub domain: Node<DomainParams, (), Domain>,
    pub fields: Node<FieldParams, FieldBuilder, Fields>,
}

impl Terrain {
    /// Nothing made yet.
    pub fn new(params: TerrainParams) -> Self {
        Self {
            domain: Node::new(params.domain),
            fields: Node::new(params.fields),
        }
    }

    /// What both are to be made by from now on.
    pub fn want(&mut self, params: TerrainParams) {
        self.domain.want(params.domain);
        self.fields.want(params.fields);
    }

    /// The first of both that is not fresh.
    pub fn due(&self) -> Option<(Stage, State)> {
        let states = [
            (Stage::Domain, self.domain.state(0)),
            (Stage::Fields, self.fields.state(self.domain.revision())),
        ];
        let mut states = states.into_iter();
        states.find(|&(_, state)| state != State::Fresh)
    }

    /// One slice of a stage.
    pub fn advance(&mut self, stage: Stage) {
        match (stage, self.domain.made()) {
            (Stage::Fields, Some(domain)) => {
                let inputs = self.domain.revision();
                self.fields.advance(inputs, |params, work| {
                    let new = || FieldBuilder::new(domain, params.clone());
                    work.get_or_insert_with(new);
                    let over = work.take_if(|builder| builder.advance(domain));
                    Ok(over.map(FieldBuilder::finish))
                });
            }
            _ => self.domain.advance(0, |params, _| {
                Ok(Some(match params {
                    DomainParams::Plane(outline) => Domain::from_checked(outline),
                    DomainParams::Torus { side, lines } => Domain::torus(*side, lines),
                }))
            }),
        }
    }

    /// Makes what is not fresh.
    pub fn finish(&mut self) {
        while let Some((stage, State::Stale)) = self.due() {
            self.advance(stage);
        }
    }

    /// Both, once they are there, stale or not.
    pub fn made(&self) -> Option<(&Domain, &Fields)> {
        self.domain.made().zip(self.fields.made())
    }

    /// Grows with every slice of work.
    pub fn slices(&self) -> u64 {
        self.domain.slices() + self.fields.slices()
    }

    /// Of both.
    pub fn revision(&self) -> u64 {
        self.domain.revision() + self.fields.revision()
    }
}
