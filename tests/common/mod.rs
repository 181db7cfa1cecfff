//! What the integration tests share.
#![allow(dead_code, reason = "every test program uses its own part of this")]

pub mod exact;
pub mod gear;
pub mod hostile;
pub mod linear;
pub mod planes;
pub mod random;
pub mod reference;
