//! Builds the firmware and reports what it costs.

use crate::out::{note, say};
use crate::toolchain::{TARGET, Toolchain};
use crate::vehicles::Tables;
use crate::{uf2, workspace};
use anyhow::{Context, Result, bail};
use cargo_metadata::MetadataCommand;
use clap::{Args, ValueEnum};
use object::{Object, ObjectSection, SectionFlags};
use serde::Deserialize;
use std::path::{Path, PathBuf};

/// Where flash begins in the RP2040's address space.
const FLASH_START: u32 = 0x1000_0000;
const RAM_START: u64 = 0x2000_0000;
/// The vector table in the image, behind the second stage; its first word is where the stack begins.
const VECTOR_TABLE: usize = 0x100;

/// What to build.
#[derive(Args, Clone, Debug, Default)]
#[group(skip)]
pub struct Options {
    /// Panel controller on the TFT module.
    #[arg(long, value_enum, default_value_t)]
    pub panel: Panel,
    /// Crystal on the MCP2515 module.
    #[arg(long, value_enum, default_value_t, value_name = "MHZ")]
    pub crystal: Crystal,
    /// Builds for this vehicle only; without it the firmware finds out by listening.
    #[arg(long, value_name = "NAME")]
    pub vehicle: Option<String>,
    /// Builds a cluster that only listens: it sends no frame and acknowledges none.
    #[arg(long)]
    pub listen_only: bool,
    /// Builds a cluster that says when a running air conditioning has lost its link (BUS-R133).
    #[arg(long)]
    pub hvac_alarm: bool,
    /// Consent to remote upgrades at a known standstill; without it they are forbidden.
    #[arg(long)]
    pub remote_upgrade: bool,
}

impl Options {
    /// Returns the name of the image, another one for other options: two commands in a row must not take each other's.
    fn name(&self) -> String {
        let mut name = format!("cluster-{}", self.panel.feature());
        if self.crystal == Crystal::Mhz16 {
            name.push_str("-16mhz");
        }
        if let Some(vehicle) = &self.vehicle {
            name.push('-');
            name.push_str(vehicle);
        }
        if self.listen_only {
            name.push_str("-listen-only");
        }
        if self.hvac_alarm {
            name.push_str("-hvac-alarm");
        }
        if self.remote_upgrade {
            name.push_str("-remote-upgrade");
        }
        name
    }
}

/// A crystal that MCP2515 modules carry.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Crystal {
    /// 8 MHz, the usual blue module.
    #[default]
    #[value(name = "8")]
    Mhz8,
    /// 16 MHz.
    #[value(name = "16")]
    Mhz16,
}

/// A panel controller that the board crate knows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Panel {
    /// ILI9341, the usual 2.4 to 3.2 inch module.
    #[default]
    Ili9341,
    /// ST7789, the usual 2.0 inch IPS module.
    St7789,
}

impl Panel {
    /// Returns the name of the panel's Cargo feature.
    pub fn feature(self) -> &'static str {
        match self {
            Self::Ili9341 => "ili9341",
            Self::St7789 => "st7789",
        }
    }
}

/// What was built.
pub struct Image {
    /// The ELF for probes and for the bench.
    pub elf: PathBuf,
    /// The UF2 for the BOOTSEL drive.
    pub uf2: PathBuf,
}

/// Builds the firmware and writes the UF2 beside the ELF.
///
/// # Errors
/// If there is no compiler for the chip or the build fails.
pub fn build(options: &Options) -> Result<Image> {
    let toolchain = Toolchain::find_or_install()?;
    let mut command = toolchain.cargo();
    command.args(["build", "--package", "firmware", "--profile", "firmware", "--target", TARGET]);
    command.args(["--no-default-features", "--features", options.panel.feature()]);
    if options.crystal == Crystal::Mhz16 {
        command.args(["--features", "crystal-16mhz"]);
    }
    if options.listen_only {
        command.args(["--features", "listen-only"]);
    }
    if options.hvac_alarm {
        command.args(["--features", "hvac-alarm"]);
    }
    if options.remote_upgrade {
        command.args(["--features", "remote-upgrade"]);
    }
    command.env_remove("CLUSTER_VEHICLE");
    if let Some(name) = &options.vehicle {
        command.env("CLUSTER_VEHICLE", Tables::named(name)?.vehicle.name);
    }
    command.args(["--config", &short_paths(TARGET)]).args(toolchain.arguments());
    let built = workspace::target().join(TARGET).join("firmware").join("firmware");
    let name = options.name();
    let patience = if built.exists() { "" } else { "; the first time this takes some minutes" };
    note!("building the firmware: {name}{patience}");
    workspace::run(&mut command)?;
    let elf = crate::output_folder()?.join(format!("{name}.elf"));
    std::fs::copy(&built, &elf).with_context(|| format!("the build left no {}", built.display()))?;
    let uf2 = elf.with_extension("uf2");
    let image = bench::rp2040::image::load_elf(&elf)?;
    std::fs::write(&uf2, uf2::encode(&image, FLASH_START))?;
    Ok(Image { elf, uf2 })
}

/// Returns the setting that keeps this machine's folders out of the image: two machines build the same bytes.
pub fn short_paths(target: &str) -> String {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| std::env::home_dir().map(|home| home.join(".cargo"))).unwrap_or_default();
    let flags = [(home, "cargo"), (workspace::root(), "cluster")]
        .map(|(folder, name)| format!("{:?}", format!("--remap-path-prefix={}={name}", folder.display())));
    format!("target.{target}.rustflags=[{}]", flags.join(","))
}

/// Builds the firmware, prints where it is and what it costs.
///
/// # Errors
/// If the build fails or a budget is exceeded.
pub fn build_and_report(options: &Options) -> Result<Image> {
    let image = build(options)?;
    say!("{}", image.elf.display())?;
    say!("{}", image.uf2.display())?;
    report(&image.elf, false)?;
    Ok(image)
}

/// Prints the firmware's sections and checks the budgets.
///
/// # Errors
/// If the build fails or a budget is exceeded.
pub fn size(options: &Options) -> Result<()> {
    report(&build(options)?.elf, true)
}

/// What the board crate grants, in bytes.
#[derive(Deserialize)]
pub struct Budget {
    flash: u64,
    ram: u64,
    /// Room for the stack; `cargo xtask tasks` holds a quarter of it free.
    pub stack: u64,
}

/// Returns what the board crate grants.
///
/// # Errors
/// If its manifest does not say.
pub fn budget() -> Result<Budget> {
    let metadata =
        MetadataCommand::new().manifest_path(workspace::root().join("Cargo.toml")).no_deps().exec()?;
    let board = metadata.packages.iter().find(|package| package.name.as_str() == "pico");
    let board = board.context("boards/pico is not in the workspace")?;
    serde_json::from_value(board.metadata["budget"].clone())
        .context("boards/pico/Cargo.toml needs [package.metadata.budget] with flash, ram and stack, in bytes")
}

/// Returns the bytes that the firmware takes in flash and, before it runs, in RAM.
///
/// # Errors
/// If the ELF cannot be read.
pub fn footprint(elf: &Path) -> Result<(u64, u64)> {
    let sections = sections(elf)?;
    let flash = sections.iter().filter(|section| section.in_flash).map(|section| section.size).sum();
    let ram =
        sections.iter().filter(|section| section.address >= RAM_START).map(|section| section.size).sum();
    Ok((flash, ram))
}

/// Returns the address from which the image's stack grows down.
///
/// # Errors
/// If the ELF is not an image for the RP2040.
pub fn stack_top(elf: &Path) -> Result<u64> {
    let image = bench::rp2040::image::load_elf(elf)?;
    let word = image.get(VECTOR_TABLE..).and_then(<[u8]>::first_chunk).context("no vector table")?;
    Ok(u32::from_le_bytes(*word).into())
}

struct Section {
    name: String,
    address: u64,
    size: u64,
    /// Its content is in the image.
    in_flash: bool,
}

fn sections(elf: &Path) -> Result<Vec<Section>> {
    let bytes = std::fs::read(elf)?;
    let file = object::File::parse(&*bytes)?;
    let is_loaded = |flags| match flags {
        SectionFlags::Elf { sh_flags, .. } => sh_flags.contains(object::elf::SHF_ALLOC),
        _ => false,
    };
    let loaded = file.sections().filter(|section| is_loaded(section.flags()) && section.size() > 0);
    Ok(loaded
        .map(|section| Section {
            name: section.name().unwrap_or("?").to_owned(),
            address: section.address(),
            size: section.size(),
            in_flash: section.file_range().is_some(),
        })
        .collect())
}

fn report(elf: &Path, list: bool) -> Result<()> {
    let budget = budget()?;
    if list {
        for Section { name, address, size, .. } in sections(elf)? {
            say!("{name:16} {size:>7} B at {address:#010x}")?;
        }
    }
    let (flash, ram) = footprint(elf)?;
    let stack = stack_top(elf)?.saturating_sub(RAM_START + ram);
    say!("flash    {flash:>7} B of {} B", budget.flash)?;
    say!("RAM      {ram:>7} B of {} B", budget.ram)?;
    say!("stack    {stack:>7} B are left, {} B are asked for", budget.stack)?;
    if flash > budget.flash || ram > budget.ram || stack < budget.stack {
        bail!(
            "over budget: save some, or raise [package.metadata.budget] in boards/pico/Cargo.toml and say why"
        );
    }
    Ok(())
}
