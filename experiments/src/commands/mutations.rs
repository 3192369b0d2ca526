//! `experiments mutations`: whether the tests notice defects.

use clap::Args;
use eigenshade_cli::messages::print_message;
use eigenshade_model::error::{Error, Result};
use experiments::mutations::{Mutation, SWITCH, VARIABLE, read, switched};
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Whether the runtime's tests notice the mutations of its mathematics in tests/mutations.csv
///
/// Copies the files that git tracks, puts all mutations into the copy, each behind a switch, builds
/// the tests once, and runs them once for each mutation until one fails. Writes CSV to standard
/// output: the test that failed, or nothing. Fails if the tests fail without a mutation, or if none
/// fails with one. A full run takes some twenty minutes on two cores.
#[derive(Args, Debug)]
pub struct Mutations {
    /// Numbers of the mutations to test, from 1 on [default: all]
    numbers: Vec<usize>,
    /// The list of mutations
    #[arg(long, value_name = "FILE", default_value = "tests/mutations.csv")]
    list: PathBuf,
    /// The repository to test
    #[arg(long, value_name = "DIR", default_value = ".")]
    tree: PathBuf,
    /// Folder of the copy and of its build
    #[arg(long, value_name = "DIR", default_value = "target/mutations")]
    work: PathBuf,
    /// Package whose tests are run; may be repeated
    #[arg(long, value_name = "NAME", default_value = "eigenshade")]
    package: Vec<String>,
}

/// Tests that take this much longer than without a mutation have failed.
const SLOWER: u32 = 4;

impl Mutations {
    pub fn run(self) -> Result<()> {
        let mutations = read(&self.list)?;
        let copy = self.work.join("tree");
        self.copy(&mutations, &copy)?;
        let mut tests = Vec::new();
        for binary in self.build(&copy)? {
            let start = Instant::now();
            if let Some(test) = failure(&binary, &copy, 0, Duration::MAX)? {
                let fault = format!("{test} fails without a mutation");
                return Err(Error::new(fault, "make the tests pass first"));
            }
            tests.push((start.elapsed(), binary));
        }
        // The fastest first.
        tests.sort();
        let all = tests.iter().map(|(time, _)| time).sum::<Duration>();
        print_message(format_args!("all tests pass in {} s without a mutation", all.as_secs()));
        let (mut tested, mut missed) = (0, 0);
        println!("number,file,original,mutated,seconds,noticed by");
        for (number, mutation) in (1..).zip(&mutations) {
            if !self.numbers.is_empty() && !self.numbers.contains(&number) {
                continue;
            }
            let (start, mut found) = (Instant::now(), None);
            for (time, binary) in &tests {
                let limit = *time * SLOWER + Duration::from_secs(60);
                found = failure(binary, &copy, number, limit)?;
                if found.is_some() {
                    break;
                }
            }
            (tested, missed) = (tested + 1, missed + usize::from(found.is_none()));
            let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
            let [original, mutated] = [&mutation.original, &mutation.mutated].map(|t| quoted(t));
            let (file, seconds) = (&mutation.file, start.elapsed().as_secs());
            let by = found.unwrap_or_default();
            println!("{number},{file},{original},{mutated},{seconds},{by}");
        }
        print_message(format_args!("{tested} mutations, {missed} of them not noticed"));
        match missed {
            0 => Ok(()),
            _ => Err(Error::new("no test fails with some mutations", "add or sharpen a test")),
        }
    }

    /// Copies the files that git tracks, and puts the mutations into the copy.
    fn copy(&self, mutations: &[Mutation], copy: &Path) -> Result<()> {
        if copy.exists() {
            fs::remove_dir_all(copy).map_err(|error| Error::io(copy, &error))?;
        }
        let git = Command::new("git").arg("-C").arg(&self.tree).args(["ls-files", "-z"]).output();
        let files = git.map_err(|error| Error::io("git", &error))?.stdout;
        for file in files.split(|&byte| byte == 0).filter(|file| !file.is_empty()) {
            let file = String::from_utf8_lossy(file).into_owned();
            let (from, to) = (self.tree.join(&file), copy.join(&file));
            let made = to.parent().map_or(Ok(()), fs::create_dir_all);
            made.and_then(|()| fs::copy(&from, &to)).map_err(|error| Error::io(&from, &error))?;
        }
        let text = |file: &str| {
            let path = copy.join(file);
            fs::read_to_string(&path).map_err(|error| Error::io(&path, &error))
        };
        let mut files = switched(mutations, text)?;
        let library = "src/lib.rs";
        files.insert(library, text(library)? + SWITCH);
        for (file, text) in files {
            let path = copy.join(file);
            fs::write(&path, text).map_err(|error| Error::io(&path, &error))?;
        }
        Ok(())
    }

    /// Builds the tests and returns their programs.
    fn build(&self, copy: &Path) -> Result<Vec<PathBuf>> {
        let folder = std::path::absolute(self.work.join("build"))
            .map_err(|error| Error::io(&self.work, &error))?;
        let mut cargo = Command::new("cargo");
        cargo.args(["test", "--tests", "--no-run", "--color", "never"]).current_dir(copy);
        cargo.args(self.package.iter().flat_map(|package| ["--package", package]));
        let output = cargo.env("CARGO_TARGET_DIR", folder).output();
        let output = output.map_err(|error| Error::io("cargo", &error))?;
        let messages = String::from_utf8_lossy(&output.stderr);
        if !output.status.success() {
            eprint!("{messages}");
            return Err(Error::new("the copy does not compile", "correct the mutation"));
        }
        // As in `Executable tests/main.rs (/folder/all-0123)`.
        let programs = messages.lines().filter_map(|line| {
            let (_, program) = line.trim().strip_prefix("Executable")?.rsplit_once('(')?;
            Some(program.trim_end_matches(')').into())
        });
        Ok(programs.collect())
    }
}

/// Runs a test program with a mutation until a test fails, and returns the name of that test.
fn failure(binary: &Path, tree: &Path, number: usize, limit: Duration) -> Result<Option<String>> {
    let io = |error| Error::io(binary, &error);
    let mut child = Command::new(binary)
        .current_dir(tree)
        .env(VARIABLE, number.to_string())
        // A failure suffices; the simplest one is not sought.
        .env("PROPTEST_MAX_SHRINK_ITERS", "0")
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .map_err(io)?;
    let (sender, receiver) = channel();
    let lines = child.stdout.take().map(|out| BufReader::new(out).lines());
    std::thread::spawn(move || {
        for line in lines.into_iter().flatten().map_while(std::io::Result::ok) {
            let test = line.strip_prefix("test ").and_then(|line| line.strip_suffix(" ... FAILED"));
            if let Some(test) = test {
                let _ = sender.send(test.to_owned());
            }
        }
    });
    let found = match receiver.recv_timeout(limit) {
        Ok(test) => Some(test),
        Err(RecvTimeoutError::Timeout) => Some("none within the time limit".to_owned()),
        Err(RecvTimeoutError::Disconnected) => {
            let passed = child.wait().map_err(io)?.success();
            return Ok((!passed).then(|| "a test that aborted".to_owned()));
        }
    };
    child.kill().and_then(|()| child.wait()).map_err(io)?;
    Ok(found)
}
