//! The shimmy of aircraft landing gears.
