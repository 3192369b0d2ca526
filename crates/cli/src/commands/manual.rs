//! `eigenshade completions` and `eigenshade man`: what a shell and a manual need of the program.

use super::options::Destination;
use clap::{Args, Command};
use clap_complete::Shell;
use clap_mangen::Man;
use eigenshade_cli::output;
use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::shipped;
use std::fs;
use std::path::{Path, PathBuf};

/// Write a shell's completions of this program
///
/// For bash: `eigenshade completions bash > ~/.local/share/bash-completion/completions/eigenshade`.
#[derive(Args, Debug)]
pub struct Completions {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
    #[command(flatten)]
    out: Destination,
}

impl Completions {
    pub fn run(self, mut program: Command) -> Result<()> {
        let names = |entries: Vec<Named>| entries.into_iter().map(|entry| entry.name).collect();
        let lists: [(&str, Vec<String>); 2] = [
            ("light", names(shipped::lights()?.entries)),
            ("material", names(shipped::named_materials(7)?.entries)),
        ];
        // For the script alone: the program also takes files. In zsh a colon ends a value's name.
        for (option, names) in &lists {
            program = program.mut_subcommands(|command| {
                let takes_it = command.get_arguments().any(|one| one.get_id().as_str() == *option);
                if !takes_it {
                    return command;
                }
                command
                    .mut_arg(option, |one| one.value_name("NAME|FILE").value_parser(names.clone()))
            });
        }
        let mut script = Vec::new();
        let name = program.get_name().to_owned();
        clap_complete::generate(self.shell, &mut program, name, &mut script);
        let mut script = String::from_utf8_lossy(&script).into_owned();
        // Files too: bash offers them where no name fits, zsh and fish if the script says so.
        for (_, names) in &lists {
            let (first, all) = (&names[0], names.join(" "));
            script = script
                .replace(&format!(":({all})"), &format!(":{{compadd -- {all}; _files}}"))
                .replace(&format!("-f -a \"{first}\\t"), &format!("-F -a \"{first}\\t"));
        }
        output::write_all(self.out.path.as_deref(), script)
    }
}

/// Write the man pages of the program and of each command
#[derive(Args, Debug)]
pub struct Manual {
    /// Folder for the pages, created if needed; `man -M` expects `man1` as its last part
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

impl Manual {
    pub fn run(self, mut program: Command) -> Result<()> {
        fs::create_dir_all(&self.folder).map_err(|error| Error::io(&self.folder, &error))?;
        program = program.disable_help_subcommand(true);
        program.build();
        pages(&program, &self.folder)
    }
}

/// Writes the page of a command, and those of its subcommands.
fn pages(command: &Command, folder: &Path) -> Result<()> {
    let page = Man::new(command.clone());
    let path = folder.join(page.get_filename());
    let mut text = Vec::new();
    page.render(&mut text).map_err(|error| Error::io(&path, &error))?;
    output::write_all(Some(&path), text)?;
    command.get_subcommands().try_for_each(|command| pages(command, folder))
}
