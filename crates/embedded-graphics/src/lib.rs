//! Objects in real materials under real light as [`Drawable`]s of embedded-graphics.
//!
//! A [`Frame`] of [`Layer`]s draws objects under a light that turns, from a [`Palette`] of each
//! material: the fast way. A [`Paint`] shades every pixel instead: the scene of a table, its exposure,
//! and the display's tone curve. [`Sphere`], [`Relief`] and [`Dial`] are objects. The objects draw themselves row by
//! row on any [`DrawTarget`], without a frame buffer, and shade only pixels inside the target: to
//! draw a part again, draw on `target.clipped(&area)`.
//!
//! ```
//! use eigenshade::presets::{light::LOBBY, material::GOLD_METALLIC_PAINT};
//! use eigenshade::screen::{Display, Tone};
//! use eigenshade::sphere;
//! use eigenshade_embedded_graphics::{Paint, Sphere};
//! use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
//! # use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
//! # use embedded_graphics::image::GetPixel;
//! # use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU16};
//!
//! static DISPLAY: Display = Display::new(Tone::Filmic);
//!
//! # const BYTES: usize = buffer_size::<Rgb565>(240, 240);
//! # let mut display = Framebuffer::<Rgb565, RawU16, LittleEndian, 240, 240, BYTES>::new();
//! let scene = sphere::color::scene(LOBBY, GOLD_METALLIC_PAINT)?;
//! let gold = Paint::new(|normal| scene.shade(normal), scene.exposure_by_factor(1.5)?, &DISPLAY);
//! Sphere::new(Point::new(70, 70), 100, &gold)?.draw(&mut display).unwrap();
//! # assert_ne!(display.pixel(Point::new(120, 120)), Some(Rgb565::BLACK));
//! # Ok::<(), eigenshade::Error>(())
//! ```
//!
//! In integers, with the same pixels on every machine:
//!
//! ```
//! use eigenshade::presets::{light::q15::LOBBY, material::q15::GOLD_METALLIC_PAINT};
//! # use eigenshade::screen::{Display, Tone};
//! # use eigenshade::sphere::q15;
//! # use eigenshade_embedded_graphics::Paint;
//! # static DISPLAY: Display = Display::new(Tone::Filmic);
//!
//! let scene = q15::color::scene(LOBBY, GOLD_METALLIC_PAINT)?;
//! let gold = Paint::q15(|normal| scene.shade(normal), scene.exposure_by_factor(1.5)?, &DISPLAY);
//! # Ok::<(), eigenshade::Error>(())
//! ```
//!
//! [`Palette`]: eigenshade::screen::Palette
//! [`Drawable`]: embedded_graphics_core::Drawable
//! [`DrawTarget`]: embedded_graphics_core::draw_target::DrawTarget
#![no_std]
#![deny(clippy::indexing_slicing, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod dial;
mod frame;
mod paint;
mod relief;
mod rows;
mod sphere;

pub use dial::{Dial, DialPixel};
pub use frame::{Colors, Frame, Layer};
pub use paint::{DisplayColor, Paint, Place, Shader};
pub use relief::Relief;
pub use sphere::Sphere;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
