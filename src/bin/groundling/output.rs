//! Where results go: standard output, or what a name stands for. A regular file is written whole or not at all, beside
//! it first and then in its place, with its mode kept and links followed; what is no regular file is written through.
//! A place is tried before work begins.

use super::failure::Failure;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The most links that a name may lead through, and the most names that are tried beside a file.
const PATIENCE: usize = 40;

/// A place for a result, which was found writable.
pub(crate) struct Output {
    /// As the person names it.
    name: PathBuf,
    place: Place,
}

enum Place {
    Standard,
    /// A device, a pipe, or a file in a folder that lets no other be made.
    Through,
    /// The file that the name stands for, there already or not.
    Whole(PathBuf),
}

impl Output {
    /// The place of this name, if it can be written and is none of `inputs`.
    pub(crate) fn at<'a>(
        name: &Path,
        inputs: impl IntoIterator<Item = &'a PathBuf>,
    ) -> Result<Output, Failure> {
        let place = place(name).map_err(|error| cannot(name, &error))?;
        let whole = |path: &Path| fs::canonicalize(path).ok();
        if let Place::Whole(path) = &place
            && let Some(path) = whole(path)
            && inputs.into_iter().any(|input| whole(input).as_ref() == Some(&path))
        {
            let name = name.display();
            return Err(Failure::Usage(format!(
                "{name} is read as well, and would be replaced: give the result another name"
            )));
        }
        Ok(Output { name: name.to_owned(), place })
    }

    /// Whether it is standard output: what is said besides goes elsewhere then.
    pub(crate) fn is_standard(&self) -> bool {
        matches!(self.place, Place::Standard)
    }

    /// Whether this is the very file that the other is.
    pub(crate) fn is(&self, other: &Output) -> bool {
        matches!((&self.place, &other.place), (Place::Whole(one), Place::Whole(two)) if one == two)
    }

    /// As the person names it.
    pub(crate) fn name(&self) -> String {
        self.name.display().to_string()
    }

    /// Writes a text there.
    pub(crate) fn write(&self, text: &str) -> Result<(), Failure> {
        let text = text.as_bytes();
        match &self.place {
            Place::Standard => io::stdout().write_all(text).map_err(Failure::Output),
            Place::Through => OpenOptions::new()
                .write(true)
                .truncate(true)
                .open(&self.name)
                .and_then(|mut file| file.write_all(text))
                .map_err(|error| cannot(&self.name, &error)),
            Place::Whole(target) => {
                replace(target, text).map_err(|error| cannot(&self.name, &error))
            }
        }
    }

    /// Says a report: on standard output, unless the result itself goes there.
    pub(crate) fn report(&self, report: &str) -> Result<(), Failure> {
        if self.is_standard() {
            // Standard error may be gone; the result is written.
            let _ = writeln!(io::stderr(), "{report}");
            return Ok(());
        }
        writeln!(io::stdout(), "{report}").map_err(Failure::Output)
    }
}

fn cannot(name: &Path, error: &io::Error) -> Failure {
    Failure::Usage(format!("cannot write {}: {error}", name.display()))
}

fn place(name: &Path) -> io::Result<Place> {
    if name.as_os_str() == "-" {
        return Ok(Place::Standard);
    }
    // Standard output may be a file that others write to as well, by this very name.
    let is_device = name.starts_with("/dev") || name.starts_with("/proc");
    let target = match fs::metadata(name) {
        Ok(found) if found.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
        Ok(found) if is_device || !found.is_file() => return Ok(Place::Through),
        Ok(_) => {
            OpenOptions::new().append(true).open(name)?;
            fs::canonicalize(name)?
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => linked(name)?,
        Err(error) => return Err(error),
    };
    match beside(&target) {
        Ok((_, tried)) => fs::remove_file(tried)?,
        Err(_) if target.exists() => return Ok(Place::Through),
        Err(error) => return Err(error),
    }
    Ok(Place::Whole(target))
}

/// Where a link leads to that leads nowhere yet; another name itself.
fn linked(name: &Path) -> io::Result<PathBuf> {
    let mut target = name.to_owned();
    for _ in 0..PATIENCE {
        match fs::read_link(&target) {
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => return Ok(target),
        }
    }
    Err(io::Error::other("its links lead in a circle"))
}

/// A new file beside another, of a name that no other run has.
fn beside(target: &Path) -> io::Result<(File, PathBuf)> {
    let name = target.file_name().unwrap_or_default().to_string_lossy();
    let mut last = None;
    for n in 0..PATIENCE {
        let path = target.with_file_name(format!(".{name}.{}-{n}.part", std::process::id()));
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => return Ok((file, path)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => last = Some(error),
            Err(error) => return Err(error),
        }
    }
    Err(last.unwrap_or_else(|| io::ErrorKind::AlreadyExists.into()))
}

fn replace(target: &Path, text: &[u8]) -> io::Result<()> {
    let (mut file, path) = beside(target)?;
    let done = file
        .write_all(text)
        .and_then(|()| match fs::metadata(target) {
            Ok(old) => file.set_permissions(old.permissions()),
            Err(_) => Ok(()),
        })
        .and_then(|()| fs::rename(&path, target));
    if done.is_err() {
        // What could not be put in its place is of no use; the first error is the one to tell.
        let _ = fs::remove_file(&path);
    }
    done
}
