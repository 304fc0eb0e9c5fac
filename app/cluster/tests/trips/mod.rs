//! Distance, energy, range, charging.

mod journeys;
mod odometer;
