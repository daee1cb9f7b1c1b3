//! Where results go: standard output, or what a name stands for. A regular file is written whole or not at all, beside
//! it first and then in its place, with its mode kept and links followed; what is no regular file is written through.
//! All places are tried before work begins; none is read as well, and no two are one.

use super::failure::Failure;
use super::identity::Identity;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The most links that a name may lead through, and the most names that are tried beside a file.
const PATIENCE: usize = 40;

/// A place for a result, which was found writable.
pub(crate) struct Output {
    /// As the person names it.
    name: PathBuf,
    place: Place,
    /// What is there already, if it keeps what is written.
    found: Option<Identity>,
}

enum Place {
    Standard,
    /// A device, a pipe, or a stream that has a name: what is written follows what was.
    Stream,
    /// A file in a folder that lets no other be made beside it.
    Within,
    /// The file that the name stands for, there already or not, and the mode that a new one has.
    Whole(PathBuf, Permissions),
}

/// The places that a command's options name, each with its option.
///
/// # Errors
/// In words: which cannot be written, is one of `inputs`, or is another's, too.
pub(crate) fn outputs<'a, const N: usize>(
    named: [(&str, Option<&Path>); N],
    inputs: impl IntoIterator<Item = &'a PathBuf>,
) -> Result<[Option<Output>; N], Failure> {
    let inputs = inputs.into_iter().filter_map(|input| Identity::of_input(input));
    let inputs: Vec<Identity> = inputs.filter(|input| input.is_file).collect();
    let mut outputs = [const { None }; N];
    for (at, (option, name)) in named.into_iter().enumerate() {
        let Some(name) = name else { continue };
        let output = Output::at(name)?;
        if output.found.as_ref().is_some_and(|found| inputs.contains(found)) {
            return Err(Failure::Usage(format!(
                "{} is read as well, and would be replaced: give the result of {option} another name",
                output.name()
            )));
        }
        let is_it = |other: &Option<Output>| other.as_ref().is_some_and(|other| other.is(&output));
        if let Some(other) = outputs.iter().position(is_it) {
            let what = if output.is_standard() { "standard output" } else { "one file" };
            return Err(Failure::Usage(format!(
                "{} and {option} name {what}: give one of them another name",
                named[other].0
            )));
        }
        outputs[at] = Some(output);
    }
    Ok(outputs)
}

/// Says a report: on standard output, unless a result goes there.
pub(crate) fn report<'a>(
    outputs: impl IntoIterator<Item = &'a Output>,
    report: &str,
) -> Result<(), Failure> {
    if outputs.into_iter().any(Output::is_standard) {
        // Standard error may be gone; the result is written.
        let _ = writeln!(io::stderr(), "{report}");
        return Ok(());
    }
    writeln!(io::stdout(), "{report}").map_err(Failure::Output)
}

impl Output {
    fn at(name: &Path) -> Result<Output, Failure> {
        let standard = Identity::of_standard_output();
        let (place, found) = if name.as_os_str() == "-" {
            (Place::Standard, standard)
        } else {
            // What is thrown away may be thrown away twice.
            let null = Identity::of(Path::new("/dev/null"));
            let found = Identity::of(name).filter(|found| null.as_ref() != Some(found));
            let place = match &found {
                Some(_) if found == standard => Place::Standard,
                _ => place(name).map_err(|error| cannot(name, &error))?,
            };
            (place, found)
        };
        Ok(Output { name: name.to_owned(), place, found })
    }

    /// Whether it is standard output: what is said besides goes elsewhere then.
    fn is_standard(&self) -> bool {
        matches!(self.place, Place::Standard)
    }

    /// Whether what is written here and there comes together.
    fn is(&self, other: &Output) -> bool {
        match (&self.place, &other.place) {
            (Place::Standard, Place::Standard) => true,
            (Place::Whole(one, _), Place::Whole(two, _)) if one == two => true,
            _ => self.found.is_some() && self.found == other.found,
        }
    }

    /// As the person names it.
    pub(crate) fn name(&self) -> String {
        self.name.display().to_string()
    }

    /// Writes a text there.
    pub(crate) fn write(&self, text: &str) -> Result<(), Failure> {
        let text = text.as_bytes();
        let through =
            |how: &mut OpenOptions| how.open(&self.name).and_then(|mut file| file.write_all(text));
        let written = match &self.place {
            Place::Standard => return io::stdout().write_all(text).map_err(Failure::Output),
            Place::Stream => through(OpenOptions::new().append(true)),
            Place::Within => through(OpenOptions::new().write(true).truncate(true)),
            Place::Whole(target, ordinary) => replace(target, ordinary, text),
        };
        written.map_err(|error| cannot(&self.name, &error))
    }
}

fn cannot(name: &Path, error: &io::Error) -> Failure {
    let name = name.display();
    Failure::Usage(match error.kind() {
        io::ErrorKind::NotFound => format!("cannot write {name}: make its folder first"),
        io::ErrorKind::IsADirectory => format!("cannot write {name}: it is a folder, name a file"),
        _ => format!("cannot write {name}: {error}"),
    })
}

fn place(name: &Path) -> io::Result<Place> {
    let target = match fs::metadata(name) {
        Ok(found) if found.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
        Ok(found) if !found.is_file() || names_a_stream(name) => return Ok(Place::Stream),
        Ok(_) => {
            OpenOptions::new().append(true).open(name)?;
            fs::canonicalize(name)?
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => linked(name)?,
        Err(error) => return Err(error),
    };
    let (file, tried) = match beside(&target, OpenOptions::new()) {
        Ok(made) => made,
        Err(_) if target.exists() => return Ok(Place::Within),
        Err(error) => return Err(error),
    };
    let ordinary = file.metadata().map(|made| made.permissions());
    fs::remove_file(tried)?;
    Ok(Place::Whole(target, ordinary?))
}

/// Whether it is the name of something that is open: it may be a file that others write to as well.
fn names_a_stream(name: &Path) -> bool {
    let standard = ["/dev/stdin", "/dev/stdout", "/dev/stderr"];
    ["/dev/fd", "/proc"].iter().chain(&standard).any(|stream| name.starts_with(stream))
}

/// The file, not there yet, that a name stands for: where links lead, in a folder that is there.
fn linked(name: &Path) -> io::Result<PathBuf> {
    let mut target = name.to_owned();
    for _ in 0..PATIENCE {
        match fs::read_link(&target) {
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => {
                let file = target.file_name().ok_or(io::ErrorKind::InvalidInput)?;
                let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty());
                return Ok(fs::canonicalize(folder.unwrap_or(Path::new(".")))?.join(file));
            }
        }
    }
    Err(io::Error::other("its links lead in a circle"))
}

/// A new file beside another, of a name that no other run has.
fn beside(target: &Path, mut how: OpenOptions) -> io::Result<(File, PathBuf)> {
    how.write(true).create_new(true);
    let name = target.file_name().unwrap_or_default().to_string_lossy();
    let mut last = None;
    for n in 0..PATIENCE {
        let path = target.with_file_name(format!(".{name}.{}-{n}.part", std::process::id()));
        match how.open(&path) {
            Ok(file) => return Ok((file, path)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => last = Some(error),
            Err(error) => return Err(error),
        }
    }
    Err(last.unwrap_or_else(|| io::ErrorKind::AlreadyExists.into()))
}

/// How a file is made that only its owner can read: what will be in it may be for no other.
#[cfg(unix)]
fn private() -> OpenOptions {
    use std::os::unix::fs::OpenOptionsExt;
    let mut how = OpenOptions::new();
    how.mode(0o600);
    how
}

#[cfg(not(unix))]
fn private() -> OpenOptions {
    OpenOptions::new()
}

fn replace(target: &Path, ordinary: &Permissions, text: &[u8]) -> io::Result<()> {
    let (mut file, path) = beside(target, private())?;
    let mode = fs::metadata(target).map_or_else(|_| ordinary.clone(), |old| old.permissions());
    let done = file
        .write_all(text)
        .and_then(|()| file.set_permissions(mode))
        .and_then(|()| fs::rename(&path, target));
    if done.is_err() {
        // What could not be put in its place is of no use; the first error is the one to tell.
        let _ = fs::remove_file(&path);
    }
    done
}
