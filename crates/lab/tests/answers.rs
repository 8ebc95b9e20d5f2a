//! A request and the files give an answer; nothing that can be sent gives another file or a panic.

use flate2::{Compression, write::GzEncoder};
use precess_lab::{Asset, Parsed, Request, Response, Site, answer, parse};
use proptest::prelude::*;
use std::io::Write;
use std::sync::OnceLock;

const PAGE: &[u8] = b"<!doctype html><p>page</p>";
const SCRIPT: &str = "export const lab = 1;";

fn site() -> Site {
    static SITE: OnceLock<Vec<Asset>> = OnceLock::new();
    SITE.get_or_init(|| {
        let mut packer = GzEncoder::new(Vec::new(), Compression::best());
        packer.write_all(SCRIPT.as_bytes()).expect("it packs");
        let packed = Vec::leak(packer.finish().expect("it packs"));
        vec![
            Asset { name: "index.html", bytes: PAGE, gzip: false, tag: "page" },
            Asset { name: "assets/index-BxK3_f9a.js", bytes: packed, gzip: true, tag: "script" },
            Asset { name: "assets/precess-01234567.wasm", bytes: b"\0asm", gzip: false, tag: "core" },
        ]
    })
}

fn get(target: &str) -> Request<'_> {
    Request { method: "GET", target, hosts: vec!["localhost:7654"], gzip: true, known: None }
}

fn wire(response: &Response) -> String {
    let mut bytes = Vec::new();
    response.write(&mut bytes).expect("a vector takes everything");
    String::from_utf8_lossy(&bytes).into_owned()
}

#[test]
fn a_page_comes_with_all_that_the_browser_must_know() {
    for target in ["/", "/index.html", "/?lang=fr", "/#run", "/?a=/../b"] {
        let response = answer(&get(target), site());
        assert_eq!((response.status, &*response.body), (200, PAGE), "{target}");
        assert_eq!(response.header("Content-Type"), Some("text/html; charset=utf-8"));
        assert_eq!(response.header("Cache-Control"), Some("no-cache"));
        assert_eq!(response.header("Content-Encoding"), None);
        let text = wire(&response);
        assert!(text.starts_with("HTTP/1.1 200 OK\r\n"), "{text}");
        assert!(
            text.ends_with(&format!("Content-Length: {}\r\n\r\n<!doctype html><p>page</p>", PAGE.len())),
            "{text}"
        );
    }
}

#[test]
fn every_answer_isolates_the_page_and_lets_it_be_framed() {
    let wrong_host = Request { hosts: vec!["evil.example"], ..get("/") };
    for request in [get("/"), get("/nothing"), wrong_host, Request { known: Some("*"), ..get("/") }] {
        let text = wire(&answer(&request, site()));
        for header in [
            "Content-Security-Policy: default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' \
             'unsafe-inline'; img-src 'self' data: blob:; worker-src 'self' blob:; connect-src 'self'; font-src \
             'self'; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors *",
            "Cross-Origin-Opener-Policy: same-origin",
            "Cross-Origin-Embedder-Policy: require-corp",
            "Cross-Origin-Resource-Policy: cross-origin",
            "X-Content-Type-Options: nosniff",
            "Referrer-Policy: no-referrer",
        ] {
            assert!(text.contains(&format!("\r\n{header}\r\n")), "{header} in {text}");
        }
    }
}

#[test]
fn scripts_and_the_core_come_under_their_right_names_and_stay() {
    let script = answer(&get("/assets/index-BxK3_f9a.js"), site());
    assert_eq!(script.header("Content-Type"), Some("text/javascript; charset=utf-8"));
    assert_eq!(script.header("Content-Encoding"), Some("gzip"));
    assert_eq!(script.header("Vary"), Some("Accept-Encoding"));
    assert_eq!(script.header("Cache-Control"), Some("public, max-age=31536000, immutable"));
    let plain = answer(&Request { gzip: false, ..get("/assets/index-BxK3_f9a.js") }, site());
    assert_eq!((&*plain.body, plain.header("Content-Encoding")), (SCRIPT.as_bytes(), None));
    assert_eq!(plain.header("Vary"), Some("Accept-Encoding"));
    let core = answer(&get("/assets/precess-01234567.wasm"), site());
    assert_eq!(core.header("Content-Type"), Some("application/wasm"));
}

#[test]
fn head_tells_the_length_and_keeps_the_content() {
    let text = wire(&answer(&Request { method: "HEAD", ..get("/") }, site()));
    assert!(text.ends_with(&format!("Content-Length: {}\r\n\r\n", PAGE.len())), "{text}");
    let text = wire(&answer(&Request { method: "HEAD", ..get("/nothing") }, site()));
    assert!(text.starts_with("HTTP/1.1 404 Not Found\r\n") && text.ends_with("\r\n\r\n"), "{text}");
}

#[test]
fn a_version_that_is_known_is_not_sent_again() {
    for known in ["W/\"page\"", "\"page\"", "\"old\", W/\"page\"", "*"] {
        let response = answer(&Request { known: Some(known), ..get("/") }, site());
        assert_eq!((response.status, response.body.len()), (304, 0), "{known}");
        assert_eq!(response.header("ETag"), Some("W/\"page\""));
        assert!(!wire(&response).contains("Content-Length"));
    }
    for unknown in ["\"old\"", "page", "", "W/\"pag\"", "\"pages\""] {
        assert_eq!(answer(&Request { known: Some(unknown), ..get("/") }, site()).status, 200, "{unknown}");
    }
}

#[test]
fn the_rest_is_refused() {
    for method in ["POST", "PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "get", ""] {
        let response = answer(&Request { method, ..get("/") }, site());
        assert_eq!((response.status, response.header("Allow")), (405, Some("GET, HEAD")), "{method}");
    }
    for target in
        ["http://127.0.0.1:7654/", "http://evil.example/", "*", "", "index.html", "evil.example:443"]
    {
        assert_eq!(answer(&get(target), site()).status, 400, "{target}");
    }
    for target in [
        "/../Cargo.toml",
        "/assets/../index.html",
        "/./index.html",
        "//index.html",
        "//evil.example/",
        "/%2e%2e/Cargo.toml",
        "/%252e%252e/Cargo.toml",
        "/%69ndex.html",
        "/..\\Cargo.toml",
        "/index.html%00",
        "/index.html/",
        "/INDEX.HTML",
        "/assets",
        "/assets/",
        "/etc/passwd",
        "/C:/Windows/win.ini",
    ] {
        assert_eq!(answer(&get(target), site()).status, 404, "{target}");
    }
    for hosts in [vec![], vec!["localhost", "localhost"], vec!["localhost", "evil.example"]] {
        assert_eq!(answer(&Request { hosts, ..get("/") }, site()).status, 400);
    }
    for host in ["evil.example", "evil.example:7654", "localhost.evil.example", ""] {
        assert_eq!(answer(&Request { hosts: vec![host], ..get("/") }, site()).status, 403, "{host}");
    }
}

/// The targets that are files of this site; all others are not.
fn names_a_file(target: &str) -> bool {
    let path = target.split(['?', '#']).next().unwrap_or_default();
    path == "/" || site().iter().any(|asset| path == format!("/{}", asset.name))
}

proptest! {
    #[test]
    fn a_path_gives_its_own_file_or_none(target in r"/?((\.\.|\.|%2e|%252e|%00|%5c|\\|index|assets|html|[a-z?#:%~ ])[/.]?){0,8}") {
        let response = answer(&get(&target), site());
        prop_assert_eq!(response.status == 200, names_a_file(&target), "{}", target);
        prop_assert!([200, 400, 404].contains(&response.status));
    }

    #[test]
    fn any_text_is_answered(target in any::<String>(), host in any::<String>(), method in any::<String>(), known in any::<String>()) {
        let request = Request { method: &method, target: &target, hosts: vec![&host], gzip: true, known: Some(&known) };
        let status = answer(&request, site()).status;
        prop_assert!([200, 304, 400, 403, 404, 405].contains(&status));
        let status = answer(&get(&target), site()).status;
        prop_assert_eq!(status == 200, names_a_file(&target));
    }

    #[test]
    fn any_bytes_are_parsed_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        if let Parsed::Whole(request) = parse(&bytes) {
            answer(&request, site());
        }
    }

    /// A proper request with one byte changed: what comes through is still a file of the lab or a refusal, and
    /// nothing of what was sent is in the head of the answer.
    #[test]
    fn a_damaged_request_is_answered(place in 0_usize..200, byte: u8, cut in 0_usize..200) {
        let mut bytes = b"GET /assets/index-BxK3_f9a.js HTTP/1.1\r\nHost: 127.0.0.1:7654\r\nAccept-Encoding: gzip\r\nIf-None-Match: \"x\"\r\n\r\n".to_vec();
        let length = bytes.len();
        bytes[place % length] = byte;
        match parse(&bytes[..length - cut % length]) {
            Parsed::Whole(request) => {
                let response = answer(&request, site());
                prop_assert!([200, 400, 403, 404, 405].contains(&response.status));
                prop_assert!(response.headers.iter().all(|(_, value)| !value.contains(['\r', '\n'])));
            }
            Parsed::Broken(status) => prop_assert!((400..600).contains(&status)),
            Parsed::Partial => {}
        }
    }
}
