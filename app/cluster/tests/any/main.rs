//! Any value of the model, from any node: what a rule makes of it, without a vehicle's codecs.

mod history;
mod parts;
mod sources;
mod telltales;
mod timing;
mod trips;
mod worlds;

/// A vehicle that can say everything.
mod probe;
