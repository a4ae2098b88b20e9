//! The comparison: C scene programs run on Mesa's OSMesa and on Tepui, in processes of their own, and what comes out
//! is compared pixel by pixel, with the times of both.
#![warn(missing_docs)]

mod bench;
mod build;
mod clients;
mod compare;
mod expectations;
mod flip;
mod frame;
mod machine;
mod oracle;
mod order;
mod precision;
mod raster;
mod recording;
mod report;
mod runner;
mod start;
mod stiff;
mod timing;

use std::process::ExitCode;

use clap::{Parser, Subcommand, ValueEnum};

/// Any error that ends the program.
pub type Error = Box<dyn std::error::Error>;

/// Compares Tepui with Mesa's OSMesa.
#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

/// Which of Tepui's executors to look at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Devices {
    /// The embedded CPU executor.
    Cpu,
    /// The kernels, on any Vulkan device that is there.
    Gpu,
    /// Both.
    Both,
}

impl Devices {
    fn cpu(self) -> bool {
        self != Devices::Gpu
    }

    fn gpu(self) -> bool {
        self != Devices::Cpu
    }
}

#[derive(Subcommand)]
enum Command {
    /// Every scene on every implementation; writes report/index.html and report/report.json.
    Compare(compare::Options),
    /// The timing scenes, interleaved; prints tables of ratios.
    Bench(bench::Options),
    /// 10,000 blended triangles, many runs, thread counts and SIMD levels: the same bits.
    Order(order::Options),
    /// Programs built on other people's libraries (PyOpenGL, GLU, GLFW), unmodified.
    Clients(clients::Options),
    /// The rasterizer measured: scenes, sweeps, other implementations, ways to rasterize on the CPU; writes report/raster.html and raster.json.
    Raster(raster::Options),
    /// A process of `raster` that draws with one implementation.
    #[command(hide = true)]
    RasterClient(raster::client::Options),
    /// Time from process start to the first frame.
    Start(start::Options),
    /// Stiff and extreme cases against an exact oracle; writes report/stiff.html and report/stiff.json.
    Stiff(stiff::Options),
    /// Error against run time; writes report/precision.html and report/precision.json.
    Precision(precision::Options),
}

fn main() -> ExitCode {
    let outcome = match Arguments::parse().command {
        Command::Compare(options) => compare::main(&options),
        Command::Bench(options) => bench::main(&options),
        Command::Order(options) => order::main(&options),
        Command::Clients(options) => clients::main(&options),
        Command::Raster(options) => raster::main(&options),
        Command::RasterClient(options) => raster::client::main(&options),
        Command::Start(options) => start::main(&options),
        Command::Stiff(options) => stiff::main(&options),
        Command::Precision(options) => precision::main(&options),
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(why) => {
            eprintln!("tepui-conformance: {why}");
            ExitCode::FAILURE
        }
    }
}
