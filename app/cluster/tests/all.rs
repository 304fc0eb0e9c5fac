//! What the cluster does, room by room as in `src`; `vehicles` sends the documents' bytes.

mod chime;
mod cluster;
mod driver;
mod faults;
mod instrument;
mod kept;
mod monitors;
mod reception;
mod support;
mod telltales;
mod transmit;
mod trips;
mod vehicles;
mod view;
