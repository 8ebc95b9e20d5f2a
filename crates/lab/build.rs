//! Embeds `web/dist`, compressed, or a placeholder where the lab is not built: cargo never needs Node.

use flate2::{Compression, write::GzEncoder};
use std::fmt::Write as _;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

fn main() -> io::Result<()> {
    let here = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets it"));
    let dist = here.join("../../web/dist");
    // Cargo runs this script again when anything in the folder changes; a folder that is not there it takes for
    // changed every time, and would link the program anew with every build. So there is always a folder.
    // Made during this run it counts as changed once more, which is right: another profile may not know it is new.
    if !dist.exists() {
        let _ = fs::create_dir(&dist);
    }
    println!("cargo::rerun-if-changed={}", dist.display());
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=src/placeholder.html");

    let mut files = Vec::new();
    if dist.join("index.html").is_file() {
        collect(&dist, "", &mut files)?;
    }
    let built = !files.is_empty();
    if !built {
        files.push(("index.html".into(), here.join("src/placeholder.html")));
    }
    files.sort_unstable();

    let mut list =
        format!("/// Whether the lab was built when this program was.\npub const BUILT: bool = {built};\n");
    list += "static EMBEDDED: &[Asset] = &[\n";
    for (number, (name, path)) in files.iter().enumerate() {
        let content = fs::read(path)?;
        let packed = gzip(&content)?;
        // What is compressed already (fonts, pictures) stays as it is.
        let gzip = packed.len() < content.len() / 10 * 9;
        fs::write(out.join(format!("{number}.bin")), if gzip { &packed } else { &content })?;
        let tag = fnv(&content);
        writeln!(
            list,
            "    Asset {{ name: {name:?}, gzip: {gzip}, tag: \"{tag:016x}\", \
             bytes: include_bytes!(concat!(env!(\"OUT_DIR\"), \"/{number}.bin\")) }},"
        )
        .expect("a text grows");
    }
    list += "];\n";
    fs::write(out.join("embedded.rs"), list)
}

/// The files under a folder, each with its path in the address.
fn collect(folder: &Path, prefix: &str, files: &mut Vec<(String, PathBuf)>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        // The server compares addresses letter by letter and decodes nothing.
        let plain = name.bytes().all(|b| b.is_ascii_alphanumeric() || b"-_.~@+".contains(&b));
        if name.starts_with('.') || !plain {
            println!("cargo::warning=the lab's file '{prefix}{name}' has no plain name and is left out");
        } else if path.is_dir() {
            collect(&path, &format!("{prefix}{name}/"), files)?;
        } else {
            files.push((format!("{prefix}{name}"), path));
        }
    }
    Ok(())
}

/// Without a time in it, so that the same lab gives the same program.
fn gzip(content: &[u8]) -> io::Result<Vec<u8>> {
    let mut packer = GzEncoder::new(Vec::new(), Compression::best());
    packer.write_all(content)?;
    packer.finish()
}

/// FNV-1a: tells one version of a file from the next.
fn fnv(content: &[u8]) -> u64 {
    content
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3))
}
