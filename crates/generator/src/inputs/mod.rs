//! What comes in from the world, and goes out to it as text.
