//! What a page keeps: the picture as PNG, the panel as GIF, the bus as a candump log.
//!
//! A recording is encoded while it runs, in virtual time, so that it costs little memory, and it ends by itself at a
//! stated size. The GIF holds only what has changed from one picture to the next.

use anyhow::{Context, Result};
use bench::chips::picture::Picture;
use bench::log::candump_line;
use bench::rig::Heard;
use bench::time::Nanos;
use gif::{DisposalMethod, Encoder, Frame, Repeat};
use serde::Serialize;
use std::sync::Arc;

/// Virtual time between two looks at the panel.
const PICTURE_EVERY: Nanos = Nanos::from_millis(100);
/// A recording ends at this size of either file: some ten minutes of a busy bus.
const BYTES_MAX: usize = 24 << 20;
/// Longest virtual time of a recording.
const SPAN_MAX: Nanos = Nanos::from_secs(600);
/// NeuQuant's speed, 1 to 30; used only where a change has more than 256 colours.
const QUANTISE_SPEED: i32 = 10;
/// Largest factor of a picture that is kept.
const SCALE_MAX: u32 = 8;
/// Name of the bus in the log.
const INTERFACE: &str = "can0";
/// Shortest delay that every player keeps, in 0.01 s.
const DELAY_MIN: u16 = 2;

/// How long a recording is, for the page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Length {
    /// Virtual seconds.
    seconds: f64,
    /// Frames of the bus.
    frames: usize,
    /// Size of the GIF so far, in bytes.
    gif_bytes: usize,
    /// It has come to its largest size.
    full: bool,
}

/// A picture that is shown until the next one comes.
struct Pending {
    since: Nanos,
    corner: (u32, u32),
    part: Picture,
}

/// A recording that runs.
pub(crate) struct Recorder {
    since: Nanos,
    now: Nanos,
    due: Nanos,
    gif: Encoder<Vec<u8>>,
    last: Option<Picture>,
    pending: Option<Pending>,
    log: String,
    frames: usize,
}

/// A recording that has ended; its copies share its bytes.
#[derive(Clone, Debug)]
pub struct Recording {
    /// The panel as GIF.
    pub gif: Arc<[u8]>,
    /// The bus as candump log.
    pub log: Arc<[u8]>,
    /// How long it is.
    pub length: Length,
}

impl Recorder {
    /// Starts a recording of a panel of this size.
    ///
    /// # Errors
    /// If the panel has no size that a GIF can have.
    pub(crate) fn new(now: Nanos, picture: &Picture) -> Result<Self> {
        let size = |pixels: u32| u16::try_from(pixels).context("the panel is larger than a GIF can be");
        let mut gif = Encoder::new(Vec::new(), size(picture.width)?, size(picture.height)?, &[])?;
        gif.set_repeat(Repeat::Infinite)?;
        Ok(Self { since: now, now, due: now, gif, last: None, pending: None, log: String::new(), frames: 0 })
    }

    /// Whether the panel is to be looked at now.
    pub(crate) fn wants_picture(&self, now: Nanos) -> bool {
        now >= self.due
    }

    /// Takes what the panel shows.
    ///
    /// # Errors
    /// If it cannot be encoded.
    pub(crate) fn see(&mut self, now: Nanos, picture: &Picture) -> Result<()> {
        (self.now, self.due) = (now, now + PICTURE_EVERY);
        let whole = (0, 0, picture.width, picture.height);
        let changed = self.last.as_ref().map_or(Some(whole), |last| difference(last, picture));
        let Some((x, y, width, height)) = changed else { return Ok(()) };
        self.write_pending(now)?;
        let part = cut(picture, x, y, width, height);
        self.pending = Some(Pending { since: now, corner: (x, y), part });
        self.last = Some(picture.clone());
        Ok(())
    }

    /// Takes a frame of the bus.
    pub(crate) fn hear(&mut self, heard: &Heard) {
        self.now = self.now.max(heard.at);
        self.log.push_str(&candump_line(heard.at, INTERFACE, &heard.frame));
        self.log.push('\n');
        self.frames += 1;
    }

    /// Whether it has come to its largest size.
    pub(crate) fn is_full(&self) -> bool {
        let bytes = self.log.len().max(self.gif.get_ref().len());
        bytes > BYTES_MAX || self.now.since(self.since) >= SPAN_MAX
    }

    pub(crate) fn length(&self) -> Length {
        Length {
            seconds: self.now.since(self.since).as_secs_f64(),
            frames: self.frames,
            gif_bytes: self.gif.get_ref().len(),
            full: self.is_full(),
        }
    }

    /// Ends the recording.
    ///
    /// # Errors
    /// If the last picture cannot be encoded.
    pub(crate) fn finish(mut self) -> Result<Recording> {
        self.write_pending(self.now)?;
        let length = self.length();
        Ok(Recording { gif: self.gif.into_inner()?.into(), log: self.log.into_bytes().into(), length })
    }

    fn write_pending(&mut self, now: Nanos) -> Result<()> {
        let Some(Pending { since, corner, part }) = self.pending.take() else { return Ok(()) };
        // Whole hundredths of both ends: rounding does not add up over a long recording.
        let hundredths = |at: Nanos| at.0 / 10_000_000;
        let delay = hundredths(now).saturating_sub(hundredths(since));
        let mut frame =
            Frame::from_rgb_speed(part.width as u16, part.height as u16, &part.rgb, QUANTISE_SPEED);
        (frame.left, frame.top) = (corner.0 as u16, corner.1 as u16);
        frame.delay = u16::try_from(delay).unwrap_or(u16::MAX).max(DELAY_MIN);
        frame.dispose = DisposalMethod::Keep;
        self.gif.write_frame(&frame).context("the picture cannot be written as GIF")
    }
}

/// Returns the picture as PNG, each pixel `scale` times as wide and high.
///
/// # Errors
/// If it cannot be encoded.
pub fn png(picture: &Picture, scale: u32) -> Result<Vec<u8>> {
    let scale = scale.clamp(1, SCALE_MAX);
    if scale == 1 {
        return Ok(picture.png()?);
    }
    let (width, height) = (picture.width * scale, picture.height * scale);
    let mut rgb = Vec::with_capacity((width * height * 3) as usize);
    for y in 0..height {
        for x in 0..width {
            rgb.extend(picture.pixel(x / scale, y / scale).unwrap_or_default());
        }
    }
    Ok(Picture { width, height, rgb }.png()?)
}

/// Returns the smallest rectangle (x, y, width, height) that holds every changed pixel.
fn difference(old: &Picture, new: &Picture) -> Option<(u32, u32, u32, u32)> {
    let width = new.width.max(1) as usize;
    let (mut left, mut right, mut top, mut bottom) = (u32::MAX, 0, u32::MAX, 0);
    for (index, (old, new)) in old.rgb.chunks_exact(3).zip(new.rgb.chunks_exact(3)).enumerate() {
        if old != new {
            let (x, y) = ((index % width) as u32, (index / width) as u32);
            (left, right) = (left.min(x), right.max(x));
            (top, bottom) = (top.min(y), bottom.max(y));
        }
    }
    (left <= right && top <= bottom).then(|| (left, top, right - left + 1, bottom - top + 1))
}

fn cut(picture: &Picture, x: u32, y: u32, width: u32, height: u32) -> Picture {
    let pixels = (y..y + height).flat_map(|y| (x..x + width).map(move |x| (x, y)));
    let rgb = pixels.flat_map(|(x, y)| picture.pixel(x, y).unwrap_or_default()).collect();
    Picture { width, height, rgb }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bench::can::{Frame as BusFrame, Id};
    use bench::log::Log;

    fn plain(colour: [u8; 3]) -> Picture {
        Picture { width: 8, height: 6, rgb: colour.repeat(48) }
    }

    fn with_dot(mut picture: Picture, x: usize, y: usize) -> Picture {
        picture.rgb[(y * 8 + x) * 3..][..3].copy_from_slice(&[255, 0, 0]);
        picture
    }

    #[test]
    fn a_recorded_gif_shows_the_pictures_for_as_long_as_they_stood() {
        let ms = Nanos::from_millis;
        let mut recorder = Recorder::new(ms(1_000), &plain([0; 3])).unwrap();
        for (at, picture) in [
            (1_000, plain([0; 3])),
            (1_100, plain([0; 3])),
            (1_300, with_dot(plain([0; 3]), 3, 2)),
            (1_500, with_dot(plain([0; 3]), 3, 2)),
        ] {
            recorder.see(ms(at), &picture).unwrap();
        }
        let gif = recorder.finish().unwrap().gif;
        let mut reader = gif::DecodeOptions::new().read_info(&gif[..]).unwrap();
        assert_eq!((reader.width(), reader.height()), (8, 6));
        let first = reader.read_next_frame().unwrap().unwrap();
        assert_eq!((first.width, first.height, first.delay), (8, 6, 30));
        let second = reader.read_next_frame().unwrap().unwrap();
        assert_eq!((second.left, second.top, second.width, second.height), (3, 2, 1, 1));
        assert_eq!(second.delay, 20);
        assert!(reader.read_next_frame().unwrap().is_none());
    }

    #[test]
    fn a_recorded_log_reads_back_frame_by_frame() {
        let mut recorder = Recorder::new(Nanos::ZERO, &plain([0; 3])).unwrap();
        let frame = BusFrame::new(Id::extended(0x18FE_F100).unwrap(), &[1, 2, 3]).unwrap();
        for at in [5, 10, 15] {
            recorder.hear(&Heard { at: Nanos::from_millis(at), frame, by_cluster: at == 10 });
        }
        let recording = recorder.finish().unwrap();
        assert_eq!(recording.length.frames, 3);
        let log = Log::parse("recording.log", std::str::from_utf8(&recording.log).unwrap()).unwrap();
        assert_eq!(log.entries.iter().map(|entry| entry.at.0 / 1_000_000).collect::<Vec<_>>(), [0, 5, 10]);
        assert!(log.entries.iter().all(|entry| entry.frame == frame));
    }

    #[test]
    fn a_recording_ends_by_itself() {
        let mut recorder = Recorder::new(Nanos::ZERO, &plain([0; 3])).unwrap();
        recorder.see(Nanos::from_secs(599), &plain([0; 3])).unwrap();
        assert!(!recorder.is_full());
        recorder.see(Nanos::from_secs(600), &plain([0; 3])).unwrap();
        assert!(recorder.is_full());
    }

    #[test]
    fn a_scaled_picture_repeats_its_pixels() {
        let file = png(&with_dot(plain([9; 3]), 1, 0), 2).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((info.width, info.height), (16, 12));
        let at = |x: usize, y: usize| &pixels[(y * 16 + x) * 3..][..3];
        assert_eq!([at(2, 0), at(3, 1)], [&[255, 0, 0], &[255, 0, 0]]);
        assert_eq!([at(1, 0), at(4, 1), at(2, 2)], [&[9; 3], &[9; 3], &[9; 3]]);
    }
}
