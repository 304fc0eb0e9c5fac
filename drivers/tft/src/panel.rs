//! The panels as rows: which model starts them, how their memory lies.
//!
//! Source: ILI9341 datasheet V1.11 section 8.2.29, ST7789VW datasheet V1.0 section 9.1.28 (MADCTL in both); which bits
//! make landscape depends on how the module's maker mounted the glass.

use crate::script::{Overflow, Script};
use mipidsi::models::{ILI9341Rgb565, Model, ST7789};
use mipidsi::options::{ColorInversion, ColorOrder, ModelOptions, Orientation, Rotation};

/// A supported panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Panel {
    /// Ilitek ILI9341.
    Ili9341,
    /// Sitronix ST7789 (V, VW).
    St7789,
}

/// How a panel is mounted.
struct Mounting {
    orientation: Orientation,
    colours: ColorOrder,
    inversion: ColorInversion,
}

impl Panel {
    const fn mounting(self) -> Mounting {
        let quarter_turn = Orientation::new().rotate(Rotation::Deg90);
        match self {
            // MV and BGR: the glass of ILI9341 modules is mounted mirrored.
            Self::Ili9341 => Mounting {
                orientation: Orientation { mirrored: true, ..quarter_turn },
                colours: ColorOrder::Bgr,
                inversion: ColorInversion::Normal,
            },
            // MX and MV; IPS glass is normally black, so the controller has to invert.
            Self::St7789 => Mounting {
                orientation: quarter_turn,
                colours: ColorOrder::Rgb,
                inversion: ColorInversion::Inverted,
            },
        }
    }

    /// Records what the `mipidsi` model of the panel sends.
    ///
    /// # Errors
    /// When the model sends more than a [`Script`] holds.
    pub fn script(self) -> Result<Script, Overflow> {
        match self {
            Self::Ili9341 => Script::record(ILI9341Rgb565, &self.options::<ILI9341Rgb565>()),
            Self::St7789 => Script::record(ST7789, &self.options::<ST7789>()),
        }
    }

    fn options<M: Model>(self) -> ModelOptions {
        let Mounting { orientation, colours, inversion } = self.mounting();
        let mut options = ModelOptions::full_size::<M>();
        options.orientation = orientation;
        options.color_order = colours;
        options.invert_colors = inversion;
        options
    }
}
