//! The nodes of palettes that objects need.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Mark, Output, Plain, disjoint};
use crate::constants::NODES;
use crate::memory::{Memory, assert_fits, write, written};
use crate::object::{NormalMap, normal_map};
use crate::packed_object::{self, PackedObject};
use crate::status::Status;
use eigenshade::screen;

/// The nodes of a palette that an object needs, once they were found.
#[repr(C)]
pub struct Nodes {
    /// Private to the library.
    pub words: [u64; NODES],
}

// SAFETY: consists of numbers.
unsafe impl Plain for Nodes {}

impl Memory for Nodes {
    type Value = screen::Nodes;
    const MARK: Mark = Mark::NODES;
    const MISSING: Status = Status::Nodes;
}

const _: () = assert_fits::<Nodes>();

/// These nodes, or all of them for NULL.
pub(crate) fn or_all(nodes: &Input<Nodes>) -> Result<&screen::Nodes, Status> {
    if nodes.0.is_null() { Ok(&screen::Nodes::ALL) } else { written(nodes) }
}

pub(crate) fn of_normal_map(map: &Input<NormalMap>, nodes: &Output<Nodes>) -> Result<(), Status> {
    let map = normal_map(map)?;
    disjoint(&[nodes.place()], &map.places)?;
    // SAFETY: it overlaps no other.
    unsafe { write(nodes, |nodes| *nodes = map.map.nodes()) }
}

pub(crate) fn of_region(
    object: &Input<PackedObject>,
    region: usize,
    nodes: &Output<Nodes>,
) -> Result<(), Status> {
    let object = packed_object::open(object, packed_object::ALL_ROWS)?;
    object.region(region)?;
    disjoint(&[nodes.place()], &object.places)?;
    // SAFETY: it overlaps no other.
    unsafe { write(nodes, |nodes| *nodes = object.object.nodes(region)) }
}
