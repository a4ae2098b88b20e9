//! A scene runner in its own process, served over pipes. If a scene crashes or hangs it, the next request starts a new one.

use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// How long one scene may take before it counts as hung.
const PATIENCE: Duration = Duration::from_secs(120);

/// One line of the runner's `list`.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Its name.
    pub name: String,
    /// Which tolerance applies: exact, shaded or other.
    pub class: String,
    /// Bits as in scene.h.
    pub flags: u32,
    /// What it proves.
    pub proves: String,
}

/// One of the timing scenes.
pub const TIMED: u32 = 2;
/// Its result is text.
pub const TEXT_ONLY: u32 = 8;

struct Process {
    child: Child,
    input: ChildStdin,
    lines: Receiver<String>,
}

/// A runner and what is needed to start it again.
pub struct Runner {
    /// What it is called in messages and reports.
    pub label: &'static str,
    binary: PathBuf,
    arguments: Vec<String>,
    environment: Vec<(String, String)>,
    log: PathBuf,
    process: Option<Process>,
    patience: Duration,
}

impl Runner {
    /// A runner that starts at its first request. Its standard error goes to `log`.
    pub fn new(label: &'static str, binary: &Path, environment: &[(&str, &str)], log: PathBuf) -> Runner {
        let environment = environment.iter().map(|(k, v)| ((*k).to_owned(), (*v).to_owned())).collect();
        let _ = std::fs::remove_file(&log);
        Runner { label, binary: binary.to_owned(), arguments: Vec::new(), environment, log, process: None, patience: PATIENCE }
    }

    /// The same runner with another limit for one request.
    pub fn patient(mut self, patience: Duration) -> Runner {
        self.patience = patience;
        self
    }

    /// The same runner, started with arguments.
    pub fn called_with(mut self, arguments: Vec<String>) -> Runner {
        self.arguments = arguments;
        self
    }

    /// The same runner under another name.
    pub fn labelled(mut self, label: &'static str) -> Runner {
        self.label = label;
        self
    }

    /// The same runner with more environment.
    pub fn with(mut self, environment: &[(&str, &str)]) -> Runner {
        self.environment.extend(environment.iter().map(|(k, v)| ((*k).to_owned(), (*v).to_owned())));
        self
    }

    /// The command with its arguments and its environment.
    pub fn command(&self) -> Command {
        let mut command = Command::new(&self.binary);
        command.args(&self.arguments);
        command.envs(self.environment.iter().map(|(k, v)| (k, v)));
        command
    }

    fn start(&mut self) -> Result<&mut Process, String> {
        if self.process.is_none() {
            let log = std::fs::OpenOptions::new().create(true).append(true).open(&self.log).map_err(|e| e.to_string())?;
            let mut child = self
                .command()
                .stdin(Stdio::piped())
                .stdout(Stdio::piped())
                .stderr(log)
                .spawn()
                .map_err(|e| format!("cannot start {}: {e}", self.binary.display()))?;
            let (Some(input), Some(output)) = (child.stdin.take(), child.stdout.take()) else { return Err("no pipes".into()) };
            let (sender, lines) = channel();
            std::thread::spawn(move || {
                for line in BufReader::new(output).lines().map_while(Result::ok) {
                    if sender.send(line).is_err() {
                        return;
                    }
                }
            });
            self.process = Some(Process { child, input, lines });
        }
        self.process.as_mut().ok_or_else(|| "not started".into())
    }

    /// Sends a command and returns the lines of its answer, or why there is none (the scene's error, a crash, a hang).
    pub fn request(&mut self, command: &str) -> Result<Vec<String>, String> {
        let patience = self.patience;
        let process = self.start()?;
        let sent = writeln!(process.input, "{command}").and_then(|()| process.input.flush());
        let mut answer = Vec::new();
        if sent.is_ok() {
            loop {
                match process.lines.recv_timeout(patience) {
                    Ok(line) if line == "done" => return Ok(answer),
                    Ok(line) => match line.strip_prefix("error ") {
                        Some(why) => return Err(why.to_owned()),
                        None => answer.push(line),
                    },
                    Err(RecvTimeoutError::Timeout) => {
                        self.stop();
                        return Err(format!("no answer in {} s", patience.as_secs()));
                    }
                    Err(RecvTimeoutError::Disconnected) => break,
                }
            }
        }
        let status = self.process.take().map(|mut p| p.child.wait());
        Err(match status {
            Some(Ok(status)) => format!("crashed ({status})"),
            _ => "crashed".to_owned(),
        })
    }

    /// The scenes that it knows.
    pub fn scenes(&mut self) -> Result<Vec<Scene>, String> {
        let parse = |line: &String| {
            let f: Vec<&str> = line.split('\t').collect();
            match f[..] {
                [name, class, _, _, flags, proves] => {
                    Some(Scene { name: name.into(), class: class.into(), flags: flags.parse().ok()?, proves: proves.into() })
                }
                _ => None,
            }
        };
        self.request("list")?.iter().map(|l| parse(l).ok_or_else(|| format!("cannot read {l:?}"))).collect()
    }

    /// Draws one frame of the open scene and returns its milliseconds.
    pub fn frame(&mut self) -> Result<f64, String> {
        let lines = self.request("frame")?;
        let number = lines.iter().find_map(|l| l.strip_prefix("ms ")).and_then(|n| n.parse().ok());
        number.ok_or_else(|| "no time in the answer".into())
    }

    fn stop(&mut self) {
        if let Some(mut process) = self.process.take() {
            let _ = process.child.kill();
            let _ = process.child.wait();
        }
    }
}

impl Drop for Runner {
    fn drop(&mut self) {
        self.stop();
    }
}
