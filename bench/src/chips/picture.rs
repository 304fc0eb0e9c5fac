//! Pictures as a person would see them, and as PNG files.

use std::fs::File;
use std::io::{self, BufReader};
use std::path::Path;

/// An RGB picture, eight bits per colour, rows from the top.
#[derive(Clone, PartialEq, Eq)]
pub struct Picture {
    /// Pixels per row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green, blue of each pixel: `width * height * 3` bytes.
    pub rgb: Vec<u8>,
}

impl std::fmt::Debug for Picture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Picture {} x {}", self.width, self.height)
    }
}

impl Picture {
    /// Red, green, blue at `x`, `y`; `None` outside.
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 3]> {
        if x >= self.width || y >= self.height {
            return None;
        }
        let start = (y as usize * self.width as usize + x as usize) * 3;
        self.rgb.get(start..start + 3)?.try_into().ok()
    }

    /// Reads a PNG file of eight bits per colour without transparency, as [`Picture::png`] makes it.
    ///
    /// # Errors
    ///
    /// When the file cannot be read or is another kind of picture.
    pub fn read_png(path: &Path) -> io::Result<Self> {
        Self::from_png(BufReader::new(File::open(path)?))
    }

    /// The same from the bytes of such a file.
    ///
    /// # Errors
    ///
    /// When it is another kind of picture.
    pub fn from_png(file: impl io::BufRead + io::Seek) -> io::Result<Self> {
        let mut reader = png::Decoder::new(file).read_info()?;
        let other = || io::Error::new(io::ErrorKind::InvalidData, "not RGB with eight bits per colour");
        let mut rgb = vec![0; reader.output_buffer_size().ok_or_else(other)?];
        let info = reader.next_frame(&mut rgb)?;
        if (info.color_type, info.bit_depth) != (png::ColorType::Rgb, png::BitDepth::Eight) {
            return Err(other());
        }
        Ok(Self { width: info.width, height: info.height, rgb })
    }

    /// The picture as a PNG file.
    ///
    /// # Errors
    ///
    /// When the picture is empty or `rgb` does not have `width * height * 3` bytes.
    pub fn png(&self) -> io::Result<Vec<u8>> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.rgb)?;
        writer.finish()?;
        Ok(file)
    }
}
