//! Numbers of the elements of both meshes.

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(pub u32);

        impl $name {
            /// The place in the building's list.
            pub fn index(self) -> usize {
                self.0 as usize
            }
        }
    )*};
}

ids! {
    /// A vertex of the child mesh.
    VertexId;
    /// A polygon edge of the child mesh.
    PolygonEdgeId;
    /// A polygon of the child mesh.
    PolygonId;
    /// A corner of the parent mesh.
    CornerId;
    /// An edge of the parent mesh.
    EdgeId;
    /// A face of the parent mesh. Faces are numbered in the order of the draft.
    FaceId;
}
