//! What tells files apart, whatever they are called: device and number, of a device its own number; where a system has no
//! such numbers, the canonical path.

use std::fs::{self, Metadata};
use std::io;
use std::path::Path;

/// Something that is there.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Identity {
    /// Whether it is a regular file: what is read from it can be lost by writing.
    pub(crate) is_file: bool,
    #[cfg(unix)]
    number: (u64, u64),
    #[cfg(not(unix))]
    path: std::path::PathBuf,
}

impl Identity {
    /// What a name stands for, if anything is there.
    pub(crate) fn of(name: &Path) -> Option<Identity> {
        identity(name, &fs::metadata(name).ok()?)
    }

    /// What is read under an input's name: `-` is standard input.
    pub(crate) fn of_input(name: &Path) -> Option<Identity> {
        if name.as_os_str() == "-" { open(&io::stdin()) } else { Identity::of(name) }
    }

    /// What standard output is.
    pub(crate) fn of_standard_output() -> Option<Identity> {
        open(&io::stdout())
    }
}

#[cfg(unix)]
fn identity(_: &Path, found: &Metadata) -> Option<Identity> {
    use std::os::unix::fs::{FileTypeExt, MetadataExt};
    let (is_file, kind) = (found.is_file(), found.file_type());
    // A device has many names, which need not be links.
    let is_device = kind.is_char_device() || kind.is_block_device();
    let number = if is_device { (u64::MAX, found.rdev()) } else { (found.dev(), found.ino()) };
    Some(Identity { is_file, number })
}

#[cfg(not(unix))]
fn identity(name: &Path, found: &Metadata) -> Option<Identity> {
    Some(Identity { is_file: found.is_file(), path: fs::canonicalize(name).ok()? })
}

/// What an open stream is.
#[cfg(unix)]
fn open(stream: &impl std::os::fd::AsFd) -> Option<Identity> {
    let own = stream.as_fd().try_clone_to_owned().ok()?;
    identity(Path::new("-"), &fs::File::from(own).metadata().ok()?)
}

#[cfg(not(unix))]
fn open<T>(_: &T) -> Option<Identity> {
    None
}
