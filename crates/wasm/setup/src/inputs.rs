//! The light of the next scene, and how it is turned.

use crate::shared::{LIGHT_COUNT, Shared};

/// The light of the next `relight`, channel by channel.
#[unsafe(export_name = "light")]
pub static LIGHT: Shared<[[f32; LIGHT_COUNT]; 3]> = Shared::new([[0.0; LIGHT_COUNT]; 3]);
/// The quaternion (x, y, z, w) by which the light is turned.
#[unsafe(export_name = "turn")]
pub static TURN: Shared<[f32; 4]> = Shared::new(UNTURNED);
/// The quaternion of no rotation.
pub const UNTURNED: [f32; 4] = [0.0, 0.0, 0.0, 1.0];
