//! Writes the programs' decoders: one function per message, in the manner of each generator.

#[path = "build/mix.rs"]
mod mix;
#[path = "build/text.rs"]
mod text;

use dbc_codegen::{Config, FeatureConfig};
use protocol_core::generated::{citybus, c5ev, jiulong};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

const VEHICLE: &str = "../../vehicles/citybus";

fn main() {
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    let dbc = format!("{VEHICLE}/citybus.dbc");
    let toml = format!("{VEHICLE}/vehicle.toml");
    for input in [&dbc, &toml, "link.x", "build.rs", "build"] {
        println!("cargo:rerun-if-changed={input}");
    }
    let mix = mix::read(&fs::read_to_string(toml).expect("vehicle.toml can be read"));
    let write =
        |name: &str, text: String| fs::write(out.join(name), text).expect("the build folder can be written");
    for manner in text::MANNERS {
        write(&format!("{}.rs", manner.name), text::rust(&mix, manner));
    }
    let vehicles = [("citybus", citybus::MESSAGES), ("c5ev", c5ev::MESSAGES), ("jiulong", jiulong::MESSAGES)];
    write(
        "every.rs",
        vehicles.iter().map(|(vehicle, messages)| text::every_message(vehicle, messages)).collect(),
    );
    write("mix.rs", text::summary(&mix));
    write("theirs.rs", dbc_codegen(&fs::read_to_string(dbc).expect("the DBC can be read")));
    // The repository's cargo configuration passes -Tlink.x for the chip.
    fs::copy("link.x", out.join("link.x")).expect("the build folder can be written");
    println!("cargo:rustc-link-search={}", out.display());
    println!("cargo:rerun-if-env-changed=CANTOOLS_C");
    if env::var_os("CARGO_FEATURE_CANTOOLS").is_some() {
        write("glue.c", text::c(&mix));
        cantools(&out);
    }
}

fn dbc_codegen(dbc: &str) -> String {
    let config = Config::builder().dbc_name("citybus").dbc_content(dbc).impl_debug(FeatureConfig::Never).build();
    config.generate().expect("dbc-codegen accepts the DBC")
}

/// Compiles cantools' C and the glue, each by itself as in a C project, at the optimisation of this build.
fn cantools(out: &Path) {
    let folder = PathBuf::from(env::var_os("CANTOOLS_C").expect("CANTOOLS_C names the folder of bus.c"));
    println!("cargo:rerun-if-changed={}", folder.join("bus.c").display());
    let level = env::var("OPT_LEVEL").expect("cargo sets it");
    for source in [folder.join("bus.c"), out.join("glue.c")] {
        let object = out.join(source.file_name().expect("a file")).with_extension("o");
        let mut gcc = Command::new("arm-none-eabi-gcc");
        gcc.args(["-mcpu=cortex-m0plus", "-mthumb", "-std=c99", "-ffreestanding", "-ffunction-sections"]);
        gcc.args(["-fdata-sections", "-c", "-I"]).arg(&folder).arg(format!("-O{level}"));
        let status = gcc.arg(source).arg("-o").arg(&object).status().expect("arm-none-eabi-gcc starts");
        assert!(status.success(), "arm-none-eabi-gcc failed");
        println!("cargo:rustc-link-arg-bin=cantools={}", object.display());
    }
}
