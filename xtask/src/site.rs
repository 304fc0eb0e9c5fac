//! Builds the bench as a page that needs no server: a static folder, and one file that holds all of it.
//!
//! The firmware, the bench as a WebAssembly module, a recording and the page; every part under its own name, found beside
//! the page, so that the folder works below any path of any host. The service worker keeps the parts for a visit without
//! a network. Each part has a budget in bytes as it is sent.

use crate::firmware;
use crate::out::{note, say};
use crate::workspace;
use anyhow::{Context, Result, bail};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use bench::rp2040::image;
use bench_page::{Link, html};
use clap::Args;
use flate2::Compression;
use flate2::write::GzEncoder;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;
use surroundings::need;

const TARGET: &str = "wasm32-unknown-unknown";

/// What a browser may do with the page: run what is in it and beside it, and reach nothing else.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline' 'self' blob: 'wasm-unsafe-eval'; \
                      worker-src 'self' blob:; style-src 'unsafe-inline'; img-src data: blob: 'self'; \
                      connect-src 'self'; base-uri 'none'; form-action 'none'";

/// The recording that can be played.
const RECORDING: &str = "vehicles/citybus/captures/city.log";

/// The most that a part may weigh, packed by gzip, in bytes.
const BUDGETS: &[(&str, usize)] =
    &[("bench.wasm", 1_100_000), ("cluster.bin", 260_000), ("index.html", 40_000)];

/// Where the site goes.
#[derive(Args, Clone, Debug, Default)]
pub struct Options {
    /// Folder of the site; its parts are replaced.
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// Writes one HTML file that holds everything, and no folder.
    #[arg(long)]
    single: bool,
    /// Compares runs of the module in Node with runs on this machine, number by number.
    #[arg(long)]
    check: bool,
}

/// What was built.
pub struct Site {
    /// The folder, with `index.html`.
    folder: PathBuf,
    /// The one file.
    pub single: PathBuf,
    /// Image of the firmware's flash.
    flash: Vec<u8>,
}

/// One part of the site.
struct Part {
    name: &'static str,
    bytes: Vec<u8>,
}

/// Builds the site and prints what it weighs.
///
/// # Errors
/// If a part cannot be built or written, or weighs more than its budget.
pub fn run(options: &Options) -> Result<()> {
    let site = build(options.out.as_deref())?;
    if options.check {
        compare(&site)?;
    }
    say!("{}", if options.single { &site.single } else { &site.folder }.display())?;
    Ok(())
}

/// Builds the site for the tests, and compares its module with this machine.
///
/// # Errors
/// Like [`run`], and if a number differs.
pub fn build_and_compare() -> Result<()> {
    compare(&build(None)?)
}

/// Builds both forms.
///
/// # Errors
/// Like [`run`].
pub fn build(folder: Option<&Path>) -> Result<Site> {
    let out = crate::output_folder()?;
    let (folder, single) = (folder.map_or_else(|| out.join("site"), Path::to_owned), out.join("bench.html"));
    let elf = firmware::build(&firmware::Options::default())?.elf;
    let flash = image::load_elf(&elf)?;
    let recording = workspace::root().join(RECORDING);
    let parts = [
        Part { name: "worker.js", bytes: include_bytes!("../../bench/web/src/worker.js").to_vec() },
        Part { name: "bench.wasm", bytes: module()? },
        Part { name: "cluster.bin", bytes: flash.clone() },
        Part {
            name: "city.log",
            bytes: std::fs::read(&recording).with_context(|| recording.display().to_string())?,
        },
    ];
    let page = with_policy(&html(Link::Worker))?;
    std::fs::create_dir_all(&folder).with_context(|| format!("cannot create {}", folder.display()))?;
    let write = |name: &str, bytes: &[u8]| {
        let path = folder.join(name);
        std::fs::write(&path, bytes).with_context(|| format!("cannot write {}", path.display()))
    };
    // Equal parts have an equal name of the cache.
    let bytes = parts.iter().flat_map(|part| part.bytes.iter()).chain(page.as_bytes());
    let build = bench_web::fingerprint(bytes.copied());
    write("sw.js", include_str!("../../bench/web/src/sw.js").replace("BUILD", &build).as_bytes())?;
    write("index.html", page.as_bytes())?;
    let (mut inside, mut wrong) = (String::new(), Vec::new());
    let mut weigh = |name: &str, bytes: usize, packed: usize| -> Result<()> {
        say!("{name:12} {bytes:9} bytes, {packed:9} packed")?;
        let budget = BUDGETS.iter().find(|(part, _)| *part == name).map(|(_, most)| *most);
        if let Some(most) = budget.filter(|most| packed > *most) {
            wrong.push(format!("{name} weighs {packed} bytes packed, its budget is {most}"));
        }
        Ok(())
    };
    weigh("index.html", page.len(), pack(page.as_bytes())?.len())?;
    for part in &parts {
        write(part.name, &part.bytes)?;
        let packed = pack(&part.bytes)?;
        weigh(part.name, part.bytes.len(), packed.len())?;
        inside.push_str(&format!(
            "<script type=\"text/plain\" id=\"part:{}\">{}</script>\n",
            part.name,
            STANDARD.encode(&packed)
        ));
    }
    let whole = page.replacen("<!-- parts -->", &inside, 1);
    std::fs::write(&single, &whole).with_context(|| format!("cannot write {}", single.display()))?;
    weigh("bench.html", whole.len(), pack(whole.as_bytes())?.len())?;
    if !wrong.is_empty() {
        bail!("{}", wrong.join("\n"));
    }
    Ok(Site { folder, single, flash })
}

/// Puts the policy where a browser reads it first.
fn with_policy(page: &str) -> Result<String> {
    let first = "<meta charset=\"utf-8\">\n";
    if !page.contains(first) {
        bail!("the page has no charset to put the policy behind");
    }
    let policy = format!("{first}<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n");
    Ok(page.replacen(first, &policy, 1))
}

fn pack(bytes: &[u8]) -> Result<Vec<u8>> {
    let mut packer = GzEncoder::new(Vec::new(), Compression::best());
    packer.write_all(bytes)?;
    Ok(packer.finish()?)
}

/// Builds the module; installs the browser's target by rustup if that is all that is missing.
fn module() -> Result<Vec<u8>> {
    let libraries = crate::toolchain::host_libraries()?;
    if !libraries.with_file_name(TARGET).join("lib").is_dir() {
        if !workspace::has("rustup") {
            bail!(
                "no compiler for {TARGET}: with rustup `rustup target add {TARGET}`, on Debian `apt-get install libstd-rust-dev-wasm32`"
            );
        }
        note!("installing the browser's target: rustup target add {TARGET}");
        workspace::run(Command::new("rustup").args(["target", "add", TARGET]))?;
    }
    note!("building the bench for the browser");
    workspace::run(workspace::cargo().args([
        "build",
        "--quiet",
        "--package",
        "bench-web",
        "--target",
        TARGET,
        "--profile",
        "web",
        "--config",
        &firmware::short_paths(TARGET),
    ]))?;
    let built = workspace::target().join(TARGET).join("web/bench_web.wasm");
    std::fs::read(&built).with_context(|| format!("the build left no {}", built.display()))
}

/// Virtual seconds that are compared.
const SECONDS: u64 = 10;

/// Drives every vehicle in Node and here; all numbers must be equal.
fn compare(site: &Site) -> Result<()> {
    if !workspace::has("node") {
        need::NODE.skip("the module in Node");
        return Ok(());
    }
    let script = workspace::root().join("bench/web/measure.mjs");
    for kind in virtual_vehicle::Kind::ALL {
        let mut node = Command::new("node");
        node.arg(&script).arg(&site.folder).arg(kind.name()).arg(SECONDS.to_string());
        let answer = workspace::capture(&mut node)?;
        let (there, took) = answer.trim().split_once('\n').context("Node's answer has two lines")?;
        let took = took.parse::<f64>().context("Node tells how long it took")? / 1e3;
        let started = Instant::now();
        let here = bench_web::drive(&site.flash, kind.name(), SECONDS).map_err(anyhow::Error::msg)?;
        let own = started.elapsed().as_secs_f64();
        if there != here {
            bail!("{}: the module in Node and this machine differ:\n  {there}\n  {here}", kind.name());
        }
        let (speed, part) = (SECONDS as f64 / took, own / took);
        say!("equal in Node and here: {here}")?;
        say!(
            "  {speed:.1} virtual seconds per second in Node, {:.0} % of this program's speed",
            part * 100.0
        )?;
    }
    Ok(())
}
