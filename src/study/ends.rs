//! Where answers may go. Nothing is posted anywhere that the study does not list; a study that came inside a link posts
//! nowhere, since whoever made the link wrote the list; answers that were simulated never leave this machine.

use super::file::{End, Study};
use super::link::Link;
use super::url::{Origin, encoded};

/// Where a study came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// From a file beside the page.
    Hosted,
    /// From the link itself.
    Linked,
}

/// Where a frame's platform takes its form, behind `turkSubmitTo`.
const SUBMIT: &str = "/mturk/externalSubmit";

/// Why something is not sent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The study came inside a link.
    Linked,
    /// The address is none, or what goes there could be read on its way.
    Unsafe(String),
    /// The study does not list its host.
    Unlisted(String),
    /// The answers are simulated, and would leave this machine.
    Simulated,
    /// The link says of no platform where its form goes.
    Nowhere,
}

/// The address that an end posts to, if it may.
///
/// # Errors
/// Why it may not.
pub fn target(
    study: &Study,
    source: Source,
    end: &End,
    link: &Link,
) -> Result<Option<String>, Refusal> {
    let url = match end {
        End::Form { url: Some(url) } | End::Endpoint { url, .. } => url.clone(),
        End::Form { url: None } => {
            let platform = link.submit_to.as_ref().ok_or(Refusal::Nowhere)?;
            format!("{}{SUBMIT}", platform.trim_end_matches('/'))
        }
        End::Code | End::File | End::Return { .. } => return Ok(None),
    };
    if source == Source::Linked {
        return Err(Refusal::Linked);
    }
    let origin = Origin::of(&url).filter(Origin::is_safe);
    let origin = origin.ok_or_else(|| Refusal::Unsafe(url.clone()))?;
    if !study.hosts.iter().any(|host| Origin::of(host).as_ref() == Some(&origin)) {
        return Err(Refusal::Unlisted(origin.host()));
    }
    if link.simulate.is_some() && !origin.is_loopback() {
        return Err(Refusal::Simulated);
    }
    Ok(Some(url))
}

/// The hosts that answers go to, to be named before anybody agrees.
pub fn hosts(study: &Study, source: Source, link: &Link) -> Vec<String> {
    let targets = study.ends.iter().filter_map(|end| target(study, source, end, link).ok()?);
    let mut hosts: Vec<String> =
        targets.filter_map(|url| Origin::of(&url)).map(|origin| origin.host()).collect();
    hosts.dedup();
    hosts
}

/// The link back with a code and a name in it.
pub fn back(url: &str, code: &str, worker: &str) -> String {
    url.replace("{code}", &encoded(code)).replace("{worker}", &encoded(worker))
}
