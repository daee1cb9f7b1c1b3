//! The address of a rosbridge as a person types it: what is none is told before a browser is asked, and so is what a
//! browser will not do: a page that came over https opens plain sockets to nobody but its own machine.

/// Where a rosbridge listens unless it was told otherwise.
pub const USUAL: &str = "ws://localhost:9090";

/// Why an address cannot be linked to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// It does not begin with `ws://` or `wss://`, or names no machine.
    NoSocket,
    /// The page is secure and the address is not, on another machine.
    Mixed,
}

/// The address to link to.
///
/// # Errors
/// Why there is none.
pub fn address(typed: &str, is_secure: bool) -> Result<String, Fault> {
    let typed = typed.trim();
    let (scheme, rest) = typed.split_once("://").ok_or(Fault::NoSocket)?;
    let is_plain = scheme.eq_ignore_ascii_case("ws");
    if !is_plain && !scheme.eq_ignore_ascii_case("wss") {
        return Err(Fault::NoSocket);
    }
    let place = rest.split(['/', '?', '#']).next().unwrap_or_default();
    let place = place.rsplit('@').next().unwrap_or_default();
    let host = match place.strip_prefix('[') {
        Some(inside) => inside.split(']').next().unwrap_or_default(),
        None => place.split(':').next().unwrap_or_default(),
    };
    if host.is_empty() || typed.contains(char::is_whitespace) {
        return Err(Fault::NoSocket);
    }
    let host = host.to_ascii_lowercase();
    let is_own = host == "localhost"
        || host == "::1"
        || host.starts_with("127.")
        || host.ends_with(".localhost");
    if is_secure && is_plain && !is_own { Err(Fault::Mixed) } else { Ok(typed.to_owned()) }
}
