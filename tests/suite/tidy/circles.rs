//! The rules on who knows whom within a folder: no circle of files, no page that knows another.

use super::file::File;
use super::imports::Imports;

/// Says so when files import each other in a circle.
pub(super) fn imports_make_no_circle(files: &[File]) -> Vec<String> {
    let circles = Imports::of(files).circles();
    circles.iter().map(|circle| format!("a circle: {}", circle.join(" → "))).collect()
}

/// Says so when a page of `src/ui` knows more of it than itself and `page`, or `page` more than itself. `app` may know
/// them all.
pub(super) fn pages_know_no_other(files: &[File]) -> Vec<String> {
    let mut complaints = Vec::new();
    for (from, to) in Imports::of(files).pairs() {
        let (Some(own), Some(other)) = (page(from), page(to)) else { continue };
        if own != other && own != "mod" && own != "app" && other != "page" {
            complaints.push(format!("{}: must not know {}", from.path, to.path));
        }
    }
    complaints
}

/// The page that a file belongs to: the folder or file of `src/ui`.
fn page(file: &File) -> Option<&str> {
    let path = file.path.strip_prefix("src/ui/")?;
    Some(path.split_once('/').map_or_else(|| path.trim_end_matches(".rs"), |(folder, _)| folder))
}
