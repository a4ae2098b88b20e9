//! `raster`: the rasterizer measured. Its scenes, sweeps of one quantity each, the same scenes on other implementations of OpenGL, and
//! the study of ways to rasterize on the CPU; tables, plots, one page and JSON.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::Error;
use crate::build::root;

mod against;
mod batch;
mod bench;
mod capture;
pub mod client;
mod draws;
mod frames;
mod gl;
mod named;
mod page;
mod plot;
mod scenes;
mod section;
#[cfg(feature = "study")]
mod study;
mod sweeps;
mod t_scenes;
mod target;

use against::Implementation;
use bench::Bench;
use scenes::SIZES;
use section::Section;

/// What can be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Case {
    /// Scenes S1 to S6.
    Frames,
    /// The size of triangles.
    Areas,
    /// What is done with a fragment, by samples.
    Modes,
    /// The same triangles in more and more draws.
    Draws,
    /// The size of batches.
    Batches,
    /// Memory against run time.
    Budgets,
    /// A frame of very many triangles.
    Huge,
    /// The same scenes, and T1 to T6, on other implementations of OpenGL.
    Against,
    /// Ways to rasterize on the CPU (feature `study`).
    Study,
}

/// Options of `raster`.
#[derive(Args)]
pub struct Options {
    /// What to measure.
    #[arg(long, value_enum, value_delimiter = ',', default_value = "frames,areas,modes,draws,batches,budgets,huge,against,study")]
    cases: Vec<Case>,
    /// Which of the scenes S1 to S6.
    #[arg(long, value_delimiter = ',', default_value = "1,2,3,4,5,6")]
    scenes: Vec<u32>,
    /// At which heights: 768, 1080, 2160.
    #[arg(long, value_delimiter = ',', default_value = "768,1080,2160")]
    heights: Vec<u32>,
    /// Samples a pixel of the scenes.
    #[arg(long, value_delimiter = ',', default_value = "1")]
    samples: Vec<u32>,
    /// Frames of each; the median is shown.
    #[arg(long, default_value_t = 31)]
    frames: usize,
    /// Millions of triangles of the frame of very many.
    #[arg(long, default_value_t = 50)]
    millions: u32,
    /// Measures the CPU executor too where there is a GPU.
    #[arg(long)]
    with_cpu: bool,
    /// Compares pictures with the CPU executor's too.
    #[arg(long)]
    check: bool,
    /// Fails where a limit is broken.
    #[arg(long)]
    strict: bool,
    /// Leaves Mesa's OSMesa out.
    #[arg(long)]
    without_reference: bool,
    /// Takes OpenGL through EGL even where it is a software renderer.
    #[arg(long)]
    software_egl: bool,
    /// Where raster.html, raster.json and the plots go.
    #[arg(long)]
    output: Option<PathBuf>,
}

fn sizes(options: &Options) -> Vec<[u32; 2]> {
    SIZES.into_iter().filter(|s| options.heights.contains(&s[1])).collect()
}

fn run(case: Case, options: &Options, benches: &[Bench], implementations: &mut [Implementation]) -> Result<Section, String> {
    match case {
        Case::Frames => frames::run(options, benches),
        Case::Areas => sweeps::areas(options, benches),
        Case::Modes => sweeps::modes(options, benches),
        Case::Draws => draws::run(options, benches, implementations),
        Case::Against => against::run(options, benches, implementations),
        #[cfg(feature = "study")]
        Case::Study => study::run(options),
        #[cfg(not(feature = "study"))]
        Case::Study => {
            let mut section = Section::new("study", "Ways to rasterize on the CPU", "");
            section.leave_out("this program was built without the feature `study`".into());
            Ok(section)
        }
        Case::Batches => sweeps::batches(options, benches),
        Case::Budgets => sweeps::budgets(options, benches),
        Case::Huge => sweeps::huge(options, benches),
    }
}

/// Measures; false where a picture is wrong or, with `--strict`, a limit is broken.
pub fn main(options: &Options) -> Result<bool, Error> {
    // Variables of the environment decide as much as arguments do.
    let mut variables: Vec<String> =
        std::env::vars().filter(|(k, _)| k.starts_with("TEPUI_") || k == "VK_DRIVER_FILES").map(|(k, v)| format!("{k}={v} ")).collect();
    variables.sort();
    let command = std::env::args().skip(1).fold(variables.concat() + "tepui-conformance", |c, a| c + " " + &a);
    let output = options.output.clone().unwrap_or_else(|| root().join("report"));
    let benches = Bench::all(options.with_cpu);
    let mut about: Vec<(String, String)> = benches.iter().map(|b| (b.short().to_owned(), b.name())).collect();
    let seeds = "splitmix64 from 0x5EED0000 + scene (S1 to S6), 0x5EED1000 + case (sweeps), 0x5EED2000 + scene (T1 to T6)";
    about.push(("Seeds".into(), seeds.into()));
    about.push(("Frames".into(), format!("{} of each, the median is shown", options.frames)));
    let mut implementations = against::implementations(options, &output, &options.cases)?;
    about.extend(implementations.iter().map(|i| (i.runner.label.to_owned(), i.about.clone())));
    about.iter().for_each(|(name, value)| println!("{name}: {value}"));
    let mut sections = Vec::new();
    for &case in &options.cases {
        sections.push(run(case, options, &benches, &mut implementations)?);
        // After every case, so that a run that is cut short leaves what it has.
        page::write(&output, &command, &about, &sections)?;
    }
    let broken = sections.iter().flat_map(|s| &s.limits).filter(|l| !l.held()).count();
    let limits = sections.iter().map(|s| s.limits.len()).sum::<usize>();
    let wrong = sections.iter().map(|s| s.wrong.len()).sum::<usize>();
    let left_out = sections.iter().map(|s| s.left_out.len()).sum::<usize>();
    println!(
        "\nraster: {} of {limits} limits held, {wrong} wrong, {left_out} left out; {}",
        limits - broken,
        output.join("raster.html").display()
    );
    Ok(wrong == 0 && (broken == 0 || !options.strict))
}
