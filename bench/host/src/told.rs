//! What the bench's thread leaves for the pages: told to those that are there, kept for those that come.

use axum::body::Bytes;
use bench::chips::picture::Picture;
use bench_page::Recording;
use std::sync::Arc;

/// What is told to every page.
#[derive(Clone, Debug)]
pub(crate) enum Told {
    /// A picture as PNG.
    Picture(Bytes),
    /// Catalog, state or notice as JSON.
    Text(Arc<str>),
}

/// What a page must know that has just come, and what files are made of.
#[derive(Clone, Default)]
pub(crate) struct Latest {
    pub(crate) catalog: Arc<str>,
    /// What the panel shows, as PNG; empty = nothing was told yet.
    pub(crate) picture: Bytes,
    /// The same as pixels.
    pub(crate) shown: Option<Arc<Picture>>,
    /// The last recording that has ended.
    pub(crate) recorded: Option<Recording>,
}
