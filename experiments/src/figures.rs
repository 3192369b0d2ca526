//! The files that a command makes in a folder: texts, charts and pictures, written or compared with
//! those that are there.

use crate::compare::{pictures, texts};
use crate::sheet;
use eigenshade_cli::output;
use eigenshade_cli::picture::{self, Canvas};
use eigenshade_generator::png_samples;
use eigenshade_model::error::{Error, Result};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// The command that makes the files.
pub struct Figures {
    /// The command's name, which the first line of each text states.
    pub command: &'static str,
    /// The folder of its figures: empty, or with `/` at its end.
    pub folder: &'static str,
    /// Whether texts are made from recorded CSV files, so that they must be the same. Otherwise
    /// their numbers must be near, see [`texts`].
    pub is_exact: bool,
}

/// One output file.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputFile {
    /// Its path relative to the requested folder, with `/` as the separator.
    pub name: String,
    /// The content of the file.
    pub content: Content,
}

/// The content of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// CSV, Markdown or SVG.
    Text(String),
    /// PNG.
    Picture(Canvas),
}

impl OutputFile {
    /// A text.
    pub fn text(name: impl Into<String>, text: String) -> Self {
        Self { name: name.into(), content: Content::Text(text) }
    }

    /// Writes the file below `folder`, either completely or not at all.
    pub fn write(&self, folder: &Path) -> Result<()> {
        let path = folder.join(&self.name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(|error| Error::io(parent, &error))?;
        }
        match &self.content {
            Content::Text(text) => output::write_all(Some(&path), text),
            Content::Picture(canvas) => {
                picture::write_png(&path, canvas.width, canvas.height, &canvas.bytes)
            }
        }
    }
}

impl Figures {
    /// A CSV; `columns` are separated by commas.
    pub fn csv<R: IntoIterator<Item: AsRef<[u8]>>>(
        &self,
        name: &str,
        columns: &str,
        rows: impl IntoIterator<Item = R>,
    ) -> Result<OutputFile> {
        let text = sheet::csv(&format!("experiments {}", self.command), columns, rows)?;
        Ok(OutputFile::text(format!("{}{name}", self.folder), text))
    }

    /// An SVG chart.
    pub fn chart(&self, name: &str, svg: &str) -> OutputFile {
        let text = format!("<!-- experiments {} -->\n{svg}", self.command);
        OutputFile::text(format!("{}{name}", self.folder), text)
    }

    /// A PNG.
    pub fn picture(&self, name: &str, canvas: Canvas) -> OutputFile {
        let name = format!("{}{name}", self.folder);
        OutputFile { name, content: Content::Picture(canvas) }
    }

    /// The remedy for a file in `folder` that differs, with options for the command.
    pub fn again(&self, folder: &Path, options: &str) -> String {
        let (command, folder) = (self.command, folder.display());
        format!(
            "make it again with `cargo run --release -p experiments -- {command} --out \
             {folder}{options}`"
        )
    }

    /// Writes the files below `folder`, unless two of them lead to the same place.
    pub fn write(&self, files: &[OutputFile], folder: &Path) -> Result<()> {
        let paths = files.iter().map(|file| folder.join(&file.name));
        output::refuse_collisions(paths, std::iter::empty::<&Path>())?;
        files.iter().try_for_each(|file| file.write(folder))
    }

    /// Compares every file with the one in `folder`. Returns how many numbers of texts (coordinates
    /// and colors of charts included) and how many pixels were compared. The error is the first
    /// file that is missing, differs, or does not belong.
    pub fn compare(&self, files: &[OutputFile], folder: &Path) -> Result<[usize; 2]> {
        let [mut numbers, mut pixels] = [0, 0];
        let again = self.again(folder, if self.is_exact { " --from-csv" } else { "" });
        for file in files {
            let path = folder.join(&file.name);
            let fault = |what: String| Error::new(what, &*again).in_file(&path);
            let unreadable = |error: std::io::Error| match error.kind() {
                ErrorKind::NotFound => fault("this figure is missing".into()),
                _ => Error::io(&path, &error),
            };
            match &file.content {
                Content::Text(text) => {
                    let found = fs::read_to_string(&path).map_err(unreadable)?;
                    if self.is_exact && found != *text {
                        return Err(fault("it is not what the CSV files give".into()));
                    }
                    let is_chart = file.name.ends_with(".svg");
                    numbers += texts(&found, text, is_chart).map_err(fault)?;
                }
                Content::Picture(canvas) => {
                    fs::metadata(&path).map_err(unreadable)?;
                    let found =
                        png_samples::read(&path).map_err(|error| error.with_remedy(&*again))?;
                    pixels += pictures(&found, canvas).map_err(fault)?;
                }
            }
        }
        // Another file among the figures would be mistaken for a figure.
        let figures = folder.join(self.folder);
        let fault = |error: std::io::Error| Error::io(&figures, &error);
        for entry in fs::read_dir(&figures).map_err(fault)? {
            let path = entry.map_err(fault)?.path();
            if files.iter().all(|file| folder.join(&file.name) != path) {
                let remedy = "remove it, or keep it elsewhere";
                return Err(Error::new("the program makes no such figure", remedy).in_file(path));
            }
        }
        Ok([numbers, pixels])
    }
}
