//! What is received: values, time-outs, counters, arrays.

mod frames;
mod streams;
