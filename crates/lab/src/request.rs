//! From the bytes of a connection to a request.

use httparse::{Error, Status};

/// The most bytes that the head of a request may have.
pub const LONGEST: usize = 16 * 1024;

/// The most headers that a request may have; browsers send about twenty.
const HEADERS: usize = 64;

/// What matters of a request.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Request<'a> {
    /// The verb, as sent.
    pub method: &'a str,
    /// The target, as sent: a path, with a query or not.
    pub target: &'a str,
    /// Every `Host` header; a proper request has one.
    pub hosts: Vec<&'a str>,
    /// Whether a compressed answer is welcome.
    pub gzip: bool,
    /// The versions of the file that the browser has already.
    pub known: Option<&'a str>,
}

/// What the bytes so far amount to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Parsed<'a> {
    /// The head of a request is complete.
    Whole(Request<'a>),
    /// It is not, and may become so.
    Partial,
    /// It will never be one: the status that says why.
    Broken(u16),
}

/// Reads the head of a request. What follows it (a body) is nobody's concern: no method here has one.
pub fn parse(bytes: &[u8]) -> Parsed<'_> {
    let mut headers = [httparse::EMPTY_HEADER; HEADERS];
    let mut head = httparse::Request::new(&mut headers);
    match head.parse(bytes) {
        Ok(Status::Complete(length)) if length <= LONGEST => {}
        Ok(Status::Partial) if bytes.len() < LONGEST => return Parsed::Partial,
        // A line that never ends is an address that is too long; the rest are headers that are.
        Ok(_) => return Parsed::Broken(if bytes.contains(&b'\n') { 431 } else { 414 }),
        Err(Error::TooManyHeaders) => return Parsed::Broken(431),
        Err(_) => return Parsed::Broken(400),
    }
    let mut request = Request {
        method: head.method.unwrap_or_default(),
        target: head.path.unwrap_or_default(),
        ..Request::default()
    };
    for header in head.headers.iter() {
        let Ok(value) = std::str::from_utf8(header.value) else {
            // Other headers may say what they like, in whatever letters.
            if header.name.eq_ignore_ascii_case("host") {
                return Parsed::Broken(400);
            }
            continue;
        };
        match header.name.to_ascii_lowercase().as_str() {
            "host" => request.hosts.push(value.trim()),
            "accept-encoding" => request.gzip |= accepts_gzip(value),
            "if-none-match" => request.known = Some(value),
            _ => {}
        }
    }
    Parsed::Whole(request)
}

/// Whether an `Accept-Encoding` lets gzip through.
fn accepts_gzip(value: &str) -> bool {
    let allows = |coding: &str| {
        value.split(',').find_map(|item| {
            let mut parts = item.split(';').map(str::trim);
            let named = parts.next()?.eq_ignore_ascii_case(coding);
            named.then(|| parts.all(|part| !is_zero(part)))
        })
    };
    allows("gzip").or_else(|| allows("*")).unwrap_or(false)
}

/// `q=0`, `q=0.000`: rather anything else.
fn is_zero(weight: &str) -> bool {
    let Some((name, value)) = weight.split_once('=') else { return false };
    name.trim().eq_ignore_ascii_case("q") && value.trim().parse() == Ok(0.0)
}

/// Whether a `Host` header names this machine. A name of somebody else's that resolves to loopback would let
/// their page read what only this machine's pages may (DNS rebinding).
pub fn is_loopback(host: &str) -> bool {
    let (name, port) = match host.find(']') {
        Some(end) if host.starts_with('[') => host.split_at(end + 1),
        _ => host.split_at(host.find(':').unwrap_or(host.len())),
    };
    let port = port.strip_prefix(':').unwrap_or(port);
    let named = ["localhost", "127.0.0.1", "[::1]"].iter().any(|known| name.eq_ignore_ascii_case(known));
    named && port.len() <= 5 && port.bytes().all(|b| b.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_request_is_read() {
        let bytes = b"GET /a?b HTTP/1.1\r\nhOST: localhost:1\r\nAccept-Encoding: br, gzip\r\nIf-None-Match: \"x\"\r\n\r\n";
        let request = Request {
            method: "GET",
            target: "/a?b",
            hosts: vec!["localhost:1"],
            gzip: true,
            known: Some("\"x\""),
        };
        assert_eq!(parse(bytes), Parsed::Whole(request));
        for length in 0..bytes.len() {
            assert_eq!(parse(&bytes[..length]), Parsed::Partial, "{length}");
        }
    }

    #[test]
    fn broken_requests_are_told_apart() {
        let long = "a".repeat(LONGEST);
        let many = "a: b\r\n".repeat(HEADERS + 1);
        let cases = [
            ("\x16\x03\x01\x02".to_string(), 400),
            ("GET\r\n\r\n".into(), 400),
            ("GET / a HTTP/1.1\r\n\r\n".into(), 400),
            ("GET /\0 HTTP/1.1\r\n\r\n".into(), 400),
            ("GET / HTTP/1.1\r\nHost\r\n\r\n".into(), 400),
            ("GET / HTTP/1.1\r\n folded: a\r\n\r\n".into(), 400),
            ("GET / HTTP/3.0\r\n\r\n".into(), 400),
            (format!("GET /{long}"), 414),
            (format!("GET / HTTP/1.1\r\na: {long}"), 431),
            (format!("GET / HTTP/1.1\r\na: {long}\r\n\r\n"), 431),
            (format!("GET / HTTP/1.1\r\n{many}\r\n"), 431),
        ];
        for (text, status) in cases {
            assert_eq!(
                parse(text.as_bytes()),
                Parsed::Broken(status),
                "{:.40}",
                text.escape_debug().to_string()
            );
        }
        assert_eq!(parse(b"GET / HTTP/1.1\r\nHost: \xff\r\n\r\n"), Parsed::Broken(400));
    }

    #[test]
    fn gzip_is_sent_to_those_who_take_it() {
        for yes in ["gzip", "GZIP", "deflate, gzip;q=0.5", "*", "br;q=0, gzip", "gzip ; q=1", "*;q=0, gzip"] {
            assert!(accepts_gzip(yes), "{yes}");
        }
        for no in ["", "br", "gzip;q=0", "gzip; q=0.0, *", "*;q=0", "xgzip", "identity"] {
            assert!(!accepts_gzip(no), "{no}");
        }
    }

    #[test]
    fn only_names_of_this_machine_are_loopback() {
        for yes in
            ["localhost", "LocalHost:7654", "127.0.0.1", "127.0.0.1:1", "[::1]", "[::1]:80", "localhost:"]
        {
            assert!(is_loopback(yes), "{yes}");
        }
        let others = [
            "",
            ":80",
            "evil.example",
            "evil.example:7654",
            "localhost.evil.example",
            "127.0.0.1.evil.example",
            "localhost:80:80",
            "localhost:80@evil.example",
            "evil@localhost",
            "[::1",
            "::1",
            "[::1]x",
            "[::2]",
            "localhost:123456",
            "localhost ",
            "0.0.0.0",
            "127.0.0.1,evil.example",
        ];
        for no in others {
            assert!(!is_loopback(no), "{no}");
        }
    }
}
