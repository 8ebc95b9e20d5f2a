//! From a request to an answer: a pure function of the request and the files.

use crate::assets::{Asset, Site};
use crate::headers::ALWAYS;
use crate::request::{Request, is_loopback};
use flate2::read::GzDecoder;
use std::borrow::Cow;
use std::io::{self, Read, Write};

/// An answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Response {
    /// 200 and its like.
    pub status: u16,
    /// What is said beside what is always said.
    pub headers: Vec<(&'static str, Cow<'static, str>)>,
    /// The content; a HEAD tells its length and keeps it back.
    pub body: Cow<'static, [u8]>,
    /// Whether the content is kept back.
    pub head: bool,
}

/// Answers a request with a file of the lab, or says why not.
pub fn answer(request: &Request<'_>, site: Site) -> Response {
    let response = match request.hosts[..] {
        [host] if is_loopback(host) => choose(request, site),
        [_] => refuse(403),
        _ => refuse(400),
    };
    Response { head: request.method == "HEAD", ..response }
}

fn choose(request: &Request<'_>, site: Site) -> Response {
    if !["GET", "HEAD"].contains(&request.method) {
        let mut refusal = refuse(405);
        refusal.headers.push(("Allow", "GET, HEAD".into()));
        return refusal;
    }
    // Neither `http://elsewhere/` nor `*`: this is no proxy.
    if !request.target.starts_with('/') {
        return refuse(400);
    }
    let path = request.target.split(['?', '#']).next().unwrap_or_default();
    Asset::find(site, path).map_or_else(|| refuse(404), |asset| send(request, asset))
}

fn send(request: &Request<'_>, asset: &'static Asset) -> Response {
    // Weak, since both forms of a file, compressed and not, have the same one.
    let tag = format!("W/\"{}\"", asset.tag);
    let caching = if asset.is_immutable() { "public, max-age=31536000, immutable" } else { "no-cache" };
    let mut headers = vec![("ETag", tag.into()), ("Cache-Control", caching.into())];
    if asset.gzip {
        headers.push(("Vary", "Accept-Encoding".into()));
    }
    if request.known.is_some_and(|known| knows(known, asset.tag)) {
        return Response { status: 304, headers, body: Cow::Borrowed(b""), head: false };
    }
    headers.push(("Content-Type", asset.kind().into()));
    let body = match (asset.gzip, request.gzip) {
        (false, _) => Cow::Borrowed(asset.bytes),
        (true, true) => {
            headers.push(("Content-Encoding", "gzip".into()));
            Cow::Borrowed(asset.bytes)
        }
        (true, false) => {
            let mut content = Vec::new();
            // What the build packed can be unpacked.
            if GzDecoder::new(asset.bytes).read_to_end(&mut content).is_err() {
                return refuse(500);
            }
            Cow::Owned(content)
        }
    };
    Response { status: 200, headers, body, head: false }
}

/// Whether an `If-None-Match` names this version.
fn knows(known: &str, tag: &str) -> bool {
    known.split(',').map(str::trim).any(|one| {
        let quoted = one.strip_prefix("W/").unwrap_or(one);
        one == "*" || quoted.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) == Some(tag)
    })
}

/// An answer that says only why there is no other.
pub fn refuse(status: u16) -> Response {
    let sentence = match status {
        403 => "The lab answers to localhost and 127.0.0.1 only.",
        404 => "There is no such file in the lab.",
        405 => "The lab can only be read.",
        _ => reason(status),
    };
    Response {
        status,
        headers: vec![
            ("Content-Type", "text/plain; charset=utf-8".into()),
            ("Cache-Control", "no-store".into()),
        ],
        body: Cow::Owned(format!("{sentence}\n").into_bytes()),
        head: false,
    }
}

/// The words that go with a status.
fn reason(status: u16) -> &'static str {
    match status {
        200 => "OK",
        304 => "Not Modified",
        400 => "Bad Request",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        408 => "Request Timeout",
        414 => "URI Too Long",
        431 => "Request Header Fields Too Large",
        503 => "Service Unavailable",
        _ => "Internal Server Error",
    }
}

impl Response {
    /// The value of a header that is not always there.
    pub fn header(&self, name: &str) -> Option<&str> {
        self.headers.iter().find(|(known, _)| *known == name).map(|(_, value)| value.as_ref())
    }

    /// Writes it as it goes over the wire.
    ///
    /// # Errors
    ///
    /// Where the writer has one.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let mut head = format!("HTTP/1.1 {} {}\r\n", self.status, reason(self.status));
        let said = self.headers.iter().map(|(name, value)| (*name, value.as_ref()));
        for (name, value) in ALWAYS.into_iter().chain(said) {
            head.extend([name, ": ", value, "\r\n"]);
        }
        // A 304 has no content to measure.
        if self.status != 304 {
            head.extend(["Content-Length: ", &self.body.len().to_string(), "\r\n"]);
        }
        head += "\r\n";
        out.write_all(head.as_bytes())?;
        if !self.head {
            out.write_all(&self.body)?;
        }
        out.flush()
    }
}
