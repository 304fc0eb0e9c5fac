//! What is received: values, time-outs, counters, arrays.

mod filler;
mod frames;
mod liveness;
mod streams;
