//! `clients`: programs that nobody here wrote the libraries of (PyOpenGL with GLU, GLFW) run unmodified, once on
//! Mesa's OSMesa and once with Tepui's library first on the loader path, and their images are compared.

use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Args;
use image::RgbImage;

use crate::Error;
use crate::build::{build_library, library_dir, root};

/// Options of `clients`.
#[derive(Args)]
pub struct Options {
    /// Where the images go.
    #[arg(long, default_value = "report/clients")]
    output: PathBuf,
}

/// A client: its name, what it needs beyond the base system, and how far its image may be from OSMesa's.
struct Client {
    name: &'static str,
    needs: &'static str,
    command: fn(&Path) -> Result<Command, Error>,
    suffix: &'static str,
    /// Most pixels (of 1000) that may differ by more than 1/255.
    per_mille: f64,
}

const CLIENTS: [Client; 2] = [
    Client {
        name: "pyopengl-glu",
        needs: "pip install PyOpenGL; apt-get install libglu1-mesa",
        command: pyopengl,
        suffix: "png",
        per_mille: 1.0,
    },
    Client { name: "glfw-osmesa", needs: "apt-get install libglfw3-dev xvfb xauth", command: glfw, suffix: "ppm", per_mille: 0.0 },
];

fn pyopengl(image: &Path) -> Result<Command, Error> {
    let mut python = Command::new("python3");
    python.arg(root().join("conformance/clients/glu_quadrics.py")).arg(image).env("PYOPENGL_PLATFORM", "osmesa");
    Ok(python)
}

fn glfw(image: &Path) -> Result<Command, Error> {
    let binary = image.with_file_name("glfw_osmesa");
    let status = Command::new("gcc").arg(root().join("conformance/clients/glfw_osmesa.c")).arg("-o").arg(&binary).arg("-lglfw").status()?;
    if !status.success() {
        return Err("glfw_osmesa.c does not compile".into());
    }
    let mut command = Command::new("xvfb-run");
    command.arg("-a").arg(binary).arg(image);
    Ok(command)
}

fn draw(client: &Client, image: &Path, tepui: bool) -> Result<(String, RgbImage), Error> {
    let _ = std::fs::remove_file(image);
    let mut command = (client.command)(image)?;
    command.env("MESA_GL_VERSION_OVERRIDE", "2.1").env("MESA_GLSL_VERSION_OVERRIDE", "120");
    if tepui {
        command.env("LD_LIBRARY_PATH", library_dir());
    }
    let output = command.output()?;
    let said = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    if !output.status.success() {
        return Err(format!("{said}{} (needs: {})", String::from_utf8_lossy(&output.stderr), client.needs).into());
    }
    if tepui && !said.contains("Tepui") {
        return Err(format!("the program ran on another library: {said}").into());
    }
    Ok((said, image::open(image)?.to_rgb8()))
}

fn run(client: &Client, output: &Path) -> Result<bool, Error> {
    let path = |who: &str| output.join(format!("{}-{who}.{}", client.name, client.suffix));
    let (_, reference) = draw(client, &path("osmesa"), false)?;
    let (said, test) = draw(client, &path("tepui"), true)?;
    if reference.dimensions() != test.dimensions() {
        return Err("the images differ in size".into());
    }
    let distance = |a: &image::Rgb<u8>, b: &image::Rgb<u8>| a.0.iter().zip(b.0).map(|(x, y)| x.abs_diff(y)).max().unwrap_or(0);
    let distances: Vec<u8> = reference.pixels().zip(test.pixels()).map(|(a, b)| distance(a, b)).collect();
    let beyond = distances.iter().filter(|d| **d > 1).count();
    let drawn = test.pixels().filter(|p| *p != test.get_pixel(0, 0)).count();
    let good = beyond as f64 * 1000.0 <= client.per_mille * distances.len() as f64 && drawn * 50 > distances.len();
    println!(
        "{} {}: {} pixels differ, {beyond} by more than 1/255, at most {}; {drawn} of {} drawn; {said}",
        if good { "ok    " } else { "FAILED" },
        client.name,
        distances.iter().filter(|d| **d > 0).count(),
        distances.iter().max().unwrap_or(&0),
        distances.len(),
    );
    Ok(good)
}

/// Runs all clients; true when every image is near enough.
pub fn main(options: &Options) -> Result<bool, Error> {
    build_library()?;
    std::fs::create_dir_all(&options.output)?;
    let output = options.output.canonicalize()?;
    let mut good = true;
    for client in &CLIENTS {
        good &= run(client, &output).unwrap_or_else(|why| {
            println!("FAILED {}: {why}", client.name);
            false
        });
    }
    println!("images: {}", output.display());
    Ok(good)
}
