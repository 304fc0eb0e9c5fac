//! What tests of the real firmware share: where its image is.

#![allow(dead_code, reason = "each test file uses a part")]

use std::path::{Path, PathBuf};

/// The image for the ILI9341.
pub(crate) fn elf() -> PathBuf {
    image("CLUSTER_ELF", "cluster-ili9341.elf")
}

/// The image for the ST7789.
pub(crate) fn elf_st7789() -> PathBuf {
    image("CLUSTER_ELF_ST7789", "cluster-st7789.elf")
}

/// The image for the ILI9341 that is for the example vehicle only.
pub(crate) fn elf_example() -> PathBuf {
    image("CLUSTER_ELF_EXAMPLE", "cluster-ili9341-example.elf")
}

fn image(variable: &str, name: &str) -> PathBuf {
    let built = || surroundings::root().join("target/out").join(name);
    let path = std::env::var_os(variable).map_or_else(built, PathBuf::from);
    assert!(path.exists(), "{name} is not built: run `cargo xtask test`, which builds it first");
    path
}

/// Writes a 320x240 picture of RGB565 pixels as PNG.
pub(crate) fn save_565(path: &Path, pixels: &[u16]) {
    let scale = |value: u16, max: u16| (u32::from(value) * 255 / u32::from(max)) as u8;
    let rgb =
        pixels.iter().flat_map(|p| [scale(p >> 11, 31), scale(p >> 5 & 63, 63), scale(p & 31, 31)]).collect();
    let picture = bench::chips::picture::Picture { width: 320, height: 240, rgb };
    std::fs::write(path, picture.png().unwrap()).unwrap();
}
