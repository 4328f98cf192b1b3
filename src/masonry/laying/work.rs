//! Work on a site in small parts, so that a page can answer between them.

use super::site::Site;

/// Work that is done part by part. Its results do not depend on how many parts are done at a time.
pub(super) trait SiteWork {
    /// Does a part of about a row of bricks. Whether nothing is left.
    fn advance(&mut self, site: &mut Site) -> bool;
}

/// Makes the occupancy maps of all faces, one after the other.
pub(super) struct MapWork;

impl SiteWork for MapWork {
    fn advance(&mut self, site: &mut Site) -> bool {
        site.add_map();
        site.has_all_maps()
    }
}
