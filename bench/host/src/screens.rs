//! Enlarged pictures of the panel, made beside the bench's thread, one at a time.
//!
//! Eight times as wide and high a picture is 15 MB of pixels and costs as much as many slices of virtual time. However
//! many are asked for, one is made at a time, and one of the same picture and size is made once.

use crate::told::Latest;
use anyhow::Result;
use axum::body::Bytes;
use bench::chips::picture::Picture;
use std::sync::Arc;
use tokio::sync::{Mutex, watch};

/// What was made last: of which picture, how many times as wide and high.
struct Made {
    of: Arc<Picture>,
    scale: u32,
    png: Bytes,
}

/// Makes a picture so many times as wide and high as PNG.
type Make = dyn Fn(&Picture, u32) -> Result<Vec<u8>> + Send + Sync;

/// Makes pictures for whoever asks.
#[derive(Clone)]
pub(crate) struct Screens {
    make: Arc<Make>,
    last: Arc<Mutex<Option<Made>>>,
}

impl Screens {
    /// Makes pictures with `make`.
    pub(crate) fn new(make: impl Fn(&Picture, u32) -> Result<Vec<u8>> + Send + Sync + 'static) -> Self {
        Self { make: Arc::new(make), last: Arc::default() }
    }

    /// Returns what the panel shows as PNG, each pixel `scale` times as wide and high.
    ///
    /// # Errors
    /// If there is no picture yet or it cannot be encoded, in words for a person.
    pub(crate) async fn png(&self, latest: &watch::Receiver<Latest>, scale: u32) -> Result<Bytes, String> {
        let mut last = Arc::clone(&self.last).lock_owned().await;
        // Whoever has waited gets what is shown now.
        let shown = latest.borrow().shown.clone();
        let of = shown.ok_or("the panel has shown nothing yet")?;
        if let Some(made) = &*last
            && Arc::ptr_eq(&made.of, &of)
            && made.scale == scale
        {
            return Ok(made.png.clone());
        }
        let make = Arc::clone(&self.make);
        // The work holds the lock itself: who has asked may go, and the next one still waits until it is done.
        let work = move || {
            let png = Bytes::from(make(&of, scale).map_err(|error| format!("{error:#}"))?);
            *last = Some(Made { of, scale, png: png.clone() });
            Ok(png)
        };
        tokio::task::spawn_blocking(work)
            .await
            .map_err(|error| format!("the picture was not made: {error}"))?
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// Counts what is made: in all, at this moment, at most at one moment.
    #[derive(Default)]
    struct Count {
        all: AtomicUsize,
        now: AtomicUsize,
        most: AtomicUsize,
    }

    fn counted() -> (Screens, Arc<Count>) {
        let count = Arc::new(Count::default());
        let counting = Arc::clone(&count);
        let screens = Screens::new(move |picture, scale| {
            counting.all.fetch_add(1, Ordering::SeqCst);
            counting.most.fetch_max(counting.now.fetch_add(1, Ordering::SeqCst) + 1, Ordering::SeqCst);
            std::thread::yield_now();
            counting.now.fetch_sub(1, Ordering::SeqCst);
            Ok(vec![picture.rgb[0], u8::try_from(scale)?])
        });
        (screens, count)
    }

    fn shows(level: u8) -> Latest {
        let picture = Picture { width: 8, height: 6, rgb: vec![level; 144] };
        Latest { shown: Some(Arc::new(picture)), ..Latest::default() }
    }

    fn runtime() -> tokio::runtime::Runtime {
        tokio::runtime::Builder::new_current_thread().build().unwrap()
    }

    #[test]
    fn a_picture_is_made_once_however_many_ask_for_it() {
        let (tell, latest) = watch::channel(shows(1));
        let (screens, count) = counted();
        runtime().block_on(async {
            let ask = || {
                let (screens, latest) = (screens.clone(), latest.clone());
                tokio::spawn(async move { screens.png(&latest, 8).await })
            };
            let asked: Vec<_> = (0..200).map(|_| ask()).collect();
            for answer in asked {
                assert_eq!(answer.await.unwrap().unwrap()[..], [1, 8]);
            }
            assert_eq!(count.all.load(Ordering::SeqCst), 1);
            tell.send_replace(shows(2));
            assert_eq!(screens.png(&latest, 8).await.unwrap()[..], [2, 8], "another picture");
            assert_eq!(screens.png(&latest, 2).await.unwrap()[..], [2, 2], "another size");
        });
        assert_eq!(count.all.load(Ordering::SeqCst), 3);
    }

    #[test]
    fn one_picture_is_made_at_a_time_even_if_those_who_asked_go() {
        let (tell, latest) = watch::channel(shows(0));
        let (screens, count) = counted();
        runtime().block_on(async {
            let mut asked = Vec::new();
            for level in 0..100 {
                tell.send_replace(shows(level));
                let (screens, latest) = (screens.clone(), latest.clone());
                let ask = tokio::spawn(async move { screens.png(&latest, 8).await });
                tokio::task::yield_now().await;
                if level % 2 == 0 {
                    ask.abort();
                }
                asked.push(ask);
            }
            for answer in asked {
                let _ = answer.await;
            }
            let last = screens.png(&latest, 8).await.unwrap();
            assert_eq!(last[..], [99, 8], "whoever has waited gets the picture of now");
        });
        assert_eq!(count.most.load(Ordering::SeqCst), 1);
    }

    #[test]
    fn before_the_first_picture_there_is_none() {
        let (_tell, latest) = watch::channel(Latest::default());
        assert!(runtime().block_on(counted().0.png(&latest, 1)).is_err());
    }
}
