//! Small defects of the runtime's mathematics that its tests must notice: a copy of the sources
//! that contains all of them, each behind a switch, and the command that runs the tests for each.

use clap::Args;
use eigenshade_cli::messages::{print_message, progress_bar};
use eigenshade_model::error::{Error, Result};
use rayon::prelude::*;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
#[cfg(unix)]
use std::os::unix::fs::symlink;
#[cfg(windows)]
use std::os::windows::fs::symlink_dir as symlink;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// The environment variable that selects a mutation by its number, from 1 on. Without it, or with
/// 0, the copy computes what the sources compute.
const VARIABLE: &str = "EIGENSHADE_MUTATION";
/// What the sources of the copy have in addition. The variable is read once.
const SWITCH: &str = r#"
extern crate std;

#[inline(always)]
pub(crate) fn mutated(number: usize) -> bool {
    static SELECTED: std::sync::LazyLock<usize> = std::sync::LazyLock::new(|| {
        std::env::var("EIGENSHADE_MUTATION").map_or(0, |number| number.parse().unwrap_or(0))
    });
    *SELECTED == number
}
"#;

/// One mutation: an expression in a file, and the one that replaces it.
#[derive(Clone, Debug, Deserialize)]
struct Mutation {
    /// The file, from the root of the repository.
    file: String,
    /// Which occurrence of `original` is meant, as "1 of 2". Empty if there is only one.
    place: String,
    /// The expression, not in a `const fn`.
    original: String,
    /// An expression of the same type.
    mutated: String,
}

impl Mutation {
    /// The range of the expression in the text of its file.
    fn range(&self, text: &str) -> Result<Range<usize>> {
        let places: Vec<usize> = text.match_indices(&self.original).map(|(at, _)| at).collect();
        let place = if self.place.is_empty() { "1 of 1" } else { &self.place };
        let numbers = place.split_once(" of ").and_then(|(number, count)| {
            Some((number.parse::<usize>().ok()?.checked_sub(1)?, count.parse::<usize>().ok()?))
        });
        let fault = |what: String, remedy| Error::new(what, remedy).in_file(&self.file);
        let index = numbers.filter(|&(index, count)| count == places.len() && index < count);
        let Some((index, _)) = index else {
            let what = format!("`{}` occurs {} times, not {place}", self.original, places.len());
            return Err(fault(what, "adapt the list of mutations to the source"));
        };
        let (start, before) = (places[index], &text[..places[index]]);
        let function = before.rfind("fn ").map(|place| &before[..place]);
        if function.is_some_and(|before| before.ends_with("const ")) {
            let what = format!("`{}` is in a constant function", self.original);
            return Err(fault(what, "take an expression of one of its callers"));
        }
        Ok(start..start + self.original.len())
    }
}

fn read(list: &Path) -> Result<Vec<Mutation>> {
    let fault = |error: csv::Error| {
        Error::new(error.to_string(), "the columns are file,place,original,mutated").in_file(list)
    };
    let mut reader = csv::Reader::from_path(list).map_err(fault)?;
    reader.deserialize().collect::<std::result::Result<_, _>>().map_err(fault)
}

/// The files that have mutations, each with all of them behind switches.
fn switched(
    mutations: &[Mutation],
    read: impl Fn(&str) -> Result<String>,
) -> Result<BTreeMap<&str, String>> {
    let mut files: BTreeMap<&str, Vec<(usize, &Mutation)>> = BTreeMap::new();
    for (number, mutation) in (1..).zip(mutations) {
        files.entry(&mutation.file).or_default().push((number, mutation));
    }
    let files = files.into_iter().map(|(file, mutations)| {
        let mut text = read(file)?;
        let ranges = mutations.iter().map(|one| Ok((one.1.range(&text)?, one)));
        let mut ranges = ranges.collect::<Result<Vec<_>>>()?;
        // From the end of the file on, so that the ranges before stay valid.
        ranges.sort_by_key(|(range, _)| range.start);
        if ranges.windows(2).any(|two| two[0].0.end > two[1].0.start) {
            let fault = Error::new("two mutations overlap", "choose separate expressions");
            return Err(fault.in_file(file));
        }
        for (range, (number, Mutation { original, mutated, .. })) in ranges.into_iter().rev() {
            let switch =
                format!("(if crate::mutated({number}) {{ {mutated} }} else {{ {original} }})");
            text.replace_range(range, &switch);
        }
        Ok((file, text))
    });
    files.collect()
}

/// Whether the runtime's tests notice the mutations of its mathematics in tests/mutations.csv
///
/// Copies the files that git tracks, puts all mutations into the copy, each behind a switch, and
/// builds the tests once. Then runs them for each mutation until one fails, the fastest first.
/// Writes CSV to standard output: each mutation with the test that failed, or without. Fails if a
/// test fails without a mutation, or if none fails with one. Takes some ten minutes on two cores.
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
}

/// The file that gets the switch.
const LIBRARY: &str = "src/lib.rs";
/// A test that takes this much longer than without a mutation has failed.
const SLOWER: u32 = 4;

struct Test {
    program: PathBuf,
    name: String,
    /// How long it takes without a mutation.
    time: Duration,
}

impl Mutations {
    pub fn run(self) -> Result<()> {
        let mutations = read(&self.list)?;
        let copy = self.work.join("tree");
        self.copy(&mutations, &copy)?;
        let mut tests = tests(&self.build(&copy)?, &copy)?;
        tests.par_iter_mut().try_for_each(|test| {
            let (start, remedy) = (Instant::now(), "make the tests pass without a mutation first");
            if !test.passes(&copy, 0, Duration::MAX)? {
                return Err(Error::new(format!("{} fails", test.name), remedy));
            }
            test.time = start.elapsed();
            Ok(())
        })?;
        tests.sort_by_key(|test| test.time);
        let mut chosen: Vec<(usize, &Mutation)> = (1..).zip(&mutations).collect();
        chosen.retain(|(number, _)| self.numbers.is_empty() || self.numbers.contains(number));
        let progress = progress_bar("mutations", chosen.len());
        let find = |&(number, _): &(usize, &Mutation)| {
            let mut found = None;
            for test in &tests {
                let limit = Duration::from_secs(60) + SLOWER * test.time;
                if !test.passes(&copy, number, limit)? {
                    found = Some(&test.name);
                    break;
                }
            }
            progress.inc(1);
            Ok(found)
        };
        let found = chosen.par_iter().map(find).collect::<Result<Vec<_>>>()?;
        progress.finish_and_clear();
        println!("number,file,original,mutated,noticed by");
        let mut missed = 0;
        for (&(number, mutation), test) in chosen.iter().zip(found) {
            let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
            let Mutation { file, original, mutated, .. } = mutation;
            let (original, mutated) = (quoted(original), quoted(mutated));
            missed += usize::from(test.is_none());
            println!("{number},{file},{original},{mutated},{}", test.map_or("", |name| name));
        }
        print_message(format_args!("{missed} of {} mutations were not noticed", chosen.len()));
        match missed {
            0 => Ok(()),
            _ => Err(Error::new("no test fails with some mutations", "add or sharpen a test")),
        }
    }

    /// Copies the files that git tracks, with the mutations. Files that the copy has already are
    /// not written, so that cargo builds only what changed.
    fn copy(&self, mutations: &[Mutation], copy: &Path) -> Result<()> {
        let read = |file: &str| {
            let path = self.tree.join(file);
            fs::read(&path).map_err(|error| Error::io(&path, &error))
        };
        let text = |file: &str| Ok(String::from_utf8_lossy(&read(file)?).into_owned());
        let mut files = switched(mutations, text)?;
        files.insert(LIBRARY, text(LIBRARY)? + SWITCH);
        let git = Command::new("git").arg("-C").arg(&self.tree).args(["ls-files", "-z"]).output();
        let names = git.map_err(|error| Error::io("git", &error))?.stdout;
        for name in String::from_utf8_lossy(&names).split_terminator('\0') {
            let (from, path) = (self.tree.join(name), copy.join(name));
            let made = path.parent().map_or(Ok(()), fs::create_dir_all);
            // Git lists a folder only if it is a link.
            let written = if from.is_dir() {
                if path.is_dir() {
                    continue;
                }
                made.and_then(|()| symlink(fs::read_link(from)?, &path))
            } else {
                let bytes = files.remove(name).map_or_else(|| read(name), |one| Ok(one.into()))?;
                if fs::read(&path).is_ok_and(|there| there == bytes) {
                    continue;
                }
                made.and_then(|()| fs::write(&path, bytes))
            };
            written.map_err(|error| Error::io(&path, &error))?;
        }
        Ok(())
    }

    fn build(&self, copy: &Path) -> Result<Vec<PathBuf>> {
        let folder = std::path::absolute(self.work.join("build"));
        let folder = folder.map_err(|error| Error::io(&self.work, &error))?;
        let mut cargo = Command::new("cargo");
        cargo.args(["test", "--package", "eigenshade", "--tests", "--no-run", "--color", "never"]);
        let output = cargo.current_dir(copy).env("CARGO_TARGET_DIR", folder).output();
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

fn tests(programs: &[PathBuf], copy: &Path) -> Result<Vec<Test>> {
    let mut tests = Vec::new();
    for program in programs {
        let listed = Command::new(program).current_dir(copy).arg("--list").output();
        let listed = listed.map_err(|error| Error::io(program, &error))?.stdout;
        for line in String::from_utf8_lossy(&listed).lines() {
            if let Some(name) = line.strip_suffix(": test") {
                let (program, name) = (program.clone(), name.to_owned());
                tests.push(Test { program, name, time: Duration::ZERO });
            }
        }
    }
    Ok(tests)
}

impl Test {
    /// Whether the test passes with a mutation, within a time limit.
    fn passes(&self, copy: &Path, number: usize, limit: Duration) -> Result<bool> {
        let io = |error| Error::io(&self.program, &error);
        let mut program = Command::new(&self.program);
        program.args(["--exact", &self.name]).current_dir(copy).env(VARIABLE, number.to_string());
        // A failure suffices: do not look for the simplest one, nor for its place.
        program.env("PROPTEST_MAX_SHRINK_ITERS", "0").env("RUST_BACKTRACE", "0");
        let mut child = program.stdout(Stdio::null()).stderr(Stdio::null()).spawn().map_err(io)?;
        let start = Instant::now();
        loop {
            if let Some(status) = child.try_wait().map_err(io)? {
                return Ok(status.success());
            }
            if start.elapsed() > limit {
                child.kill().and_then(|()| child.wait()).map_err(io)?;
                return Ok(false);
            }
            std::thread::sleep(Duration::from_millis(2));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Error, read, switched};

    /// The list of mutations belongs to the sources as they are.
    #[test]
    fn each_mutation_has_its_place_in_the_sources() {
        let root = eigenshade_testing::repository();
        let mutations = read(&root.join("tests/mutations.csv")).expect("a list");
        let text = |file: &str| {
            let path = root.join(file);
            std::fs::read_to_string(&path).map_err(|error| Error::io(&path, &error))
        };
        let files = switched(&mutations, text).expect("the expressions of the list");
        let switches = files.values().map(|text| text.matches("(if crate::mutated(").count());
        assert_eq!(switches.sum::<usize>(), mutations.len());
        assert!(mutations.iter().all(|mutation| mutation.original != mutation.mutated));
        let stated = format!("lists {} small defects", mutations.len());
        assert!(include_str!("../../CONTRIBUTING.md").contains(&stated), "{stated}");
    }
}
