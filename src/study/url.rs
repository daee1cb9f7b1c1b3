//! As much of web addresses (RFC 3986) as a study needs: whose host one names, and whether what goes there is sealed on
//! its way. Invariant: two addresses are of one origin only if their scheme, host and port are the same letters.

/// Where something goes: scheme, host and port of an address.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    scheme: String,
    host: String,
    port: Option<u16>,
}

impl Origin {
    /// The origin of an address; nothing when it is none of the web, or says more than a host (a name and a password
    /// before it are a way to look like another).
    pub fn of(address: &str) -> Option<Origin> {
        let strange = |c: char| c.is_control() || c.is_whitespace() || c == '\\';
        let (scheme, rest) = address.split_once("://").filter(|_| !address.contains(strange))?;
        let scheme = scheme.to_ascii_lowercase();
        let usual = match scheme.as_str() {
            "https" => 443,
            "http" => 80,
            _ => return None,
        };
        let authority = rest.split(['/', '?', '#']).next().unwrap_or_default();
        let (host, port) = match authority.rsplit_once(':') {
            Some((host, port)) if !port.contains(']') => (host, Some(port.parse::<u16>().ok()?)),
            _ => (authority, None),
        };
        let is_host = |c: char| c.is_ascii_alphanumeric() || "-._[]:".contains(c);
        if host.is_empty() || !host.chars().all(is_host) {
            return None;
        }
        let port = port.filter(|&port| port != usual);
        Some(Origin { scheme, host: host.to_ascii_lowercase(), port })
    }

    /// Whether it is this machine.
    pub fn is_loopback(&self) -> bool {
        matches!(self.host.as_str(), "localhost" | "127.0.0.1" | "[::1]")
    }

    /// Whether nobody on the way can read what goes there: https, or this machine.
    pub fn is_safe(&self) -> bool {
        self.scheme == "https" || self.is_loopback()
    }

    /// The host, with its port if that is not the usual one.
    pub fn host(&self) -> String {
        self.port.map_or_else(|| self.host.clone(), |port| format!("{}:{port}", self.host))
    }
}

/// A text of an address in plain letters: `%20` is a blank, and so is `+`. What is no such code stays as it is.
pub fn decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        rest = after;
        let code = |at: usize| after.get(at).and_then(|&byte| char::from(byte).to_digit(16));
        match (first, code(0), code(1)) {
            (b'%', Some(high), Some(low)) => {
                bytes.push((high * 16 + low) as u8);
                rest = &after[2..];
            }
            (b'+', ..) => bytes.push(b' '),
            _ => bytes.push(*first),
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// A text as part of an address.
pub fn encoded(text: &str) -> String {
    let letter = |byte: u8| match byte {
        b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'_' | b'.' | b'~' => {
            char::from(byte).to_string()
        }
        _ => format!("%{byte:02X}"),
    };
    text.bytes().map(letter).collect()
}
