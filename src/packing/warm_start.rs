//! Starts a packing from the cells of another one, in another outline or other fields. It is used while a point is
//! dragged, so that the cells flow after it, and never for finished pictures.

use super::body::MovingParticle;
use super::placement::{on_boundary, walls};
use super::shape::CellShape;
use super::surroundings::PlaneDomain;
use super::wall::CLOSEST;
use super::{BoundaryCondition, Packing, PackingParams, Particle, Population, TUNING};
use crate::domain::Domain;
use crate::field::Fields;
use crate::order;
use glam::DVec2;

/// Cells farther outside than this many sizes are dropped; nearer ones are moved in.
const FAR: f64 = 1.0;

impl Packing {
    /// Continues with the same cells in another outline, with other fields or parameters. Cells just outside
    /// are moved in, those far outside dropped, cells on the boundary placed anew, and all take size,
    /// direction and aspect ratio from the fields. The next step controls the population, so that new room
    /// fills and crowds thin out. The number of remaining steps is reset.
    pub fn warm_start(&mut self, domain: &Domain, fields: &Fields, mut params: PackingParams) {
        if params.population == Population::Off {
            params.population = Population::Slots;
        }
        self.walls = walls(domain, fields, &params);
        let boundary = params.boundary;
        let run = &mut self.run;
        run.params = params;
        let (mut held, mut free): (Vec<MovingParticle<DVec2>>, Vec<MovingParticle<DVec2>>) =
            run.bodies.iter().partition(|body| body.particle.fixed);
        order::sort(&mut held, |body| (body.particle.id.into(), 0));
        free.retain_mut(|body| move_in(body, domain, fields));
        run.bodies = free;
        if boundary == BoundaryCondition::On {
            // Earlier cells keep their ids, and so their colours.
            let mut names = held.iter().map(|body| body.particle.id);
            let around = PlaneDomain {
                domain,
                fields,
                walls: &self.walls,
                boundary,
            };
            for centre in on_boundary(around) {
                let name = names.next();
                run.add(fields, centre, true);
                if let (Some(id), Some(body)) = (name, run.bodies.last_mut()) {
                    body.particle.id = id;
                    run.next_id -= 1;
                }
            }
        }
        if domain.islands().len() > 1 {
            let centres: Vec<DVec2> = run.bodies.iter().map(|b| b.particle.centre).collect();
            for centre in domain.empty_middles(&centres) {
                run.add(fields, centre, false);
            }
        }
        run.assign_sizes(fields);
        run.motion.forget();
        run.controlled = 0;
        run.report.step = TUNING.population_every;
        run.report.cells = run.bodies.len();
        run.report.done = run.bodies.is_empty();
        run.report.converged = false;
    }
}

/// Moves a free cell inside; false if it is too far away.
fn move_in(body: &mut MovingParticle<DVec2>, domain: &Domain, fields: &Fields) -> bool {
    let mut centre = domain.space().wrap(body.particle.centre);
    let near = domain.nearest(centre);
    if near.distance < -FAR * body.particle.size {
        return false;
    }
    if near.distance <= 0.0 {
        let least = CLOSEST * CellShape::metric_at(fields, centre).extent(near.inward);
        let depth = domain.medial_depth(near.point, near.inward, least);
        centre = near.point + near.inward * depth;
    }
    body.particle = Particle::new(body.particle.id, centre, false, fields);
    body.velocity = DVec2::ZERO;
    body.factor = 1.0;
    body.has_moved = true;
    domain.contains(centre)
}
