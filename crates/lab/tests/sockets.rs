//! The server as a browser meets it, and as those meet it who are no browser.

use precess_lab::{Asset, LONGEST, PORT, Server, embedded};
use std::io::{ErrorKind, Read, Write};
use std::net::{Ipv4Addr, Shutdown, TcpStream};
use std::thread;

static SITE: [Asset; 2] = [
    Asset { name: "index.html", bytes: b"<p>page</p>", gzip: false, tag: "page" },
    Asset { name: "large.bin", bytes: &[7; 3_000_000], gzip: false, tag: "large" },
];

/// A server of the test's own, which ends with the test.
fn serve() -> u16 {
    let server = Server::bind(Some(0)).expect("a free port");
    let port = server.port();
    thread::spawn(move || server.serve(&SITE));
    port
}

fn connect(port: u16) -> TcpStream {
    TcpStream::connect((Ipv4Addr::LOCALHOST, port)).expect("the server listens")
}

/// What comes back before the server hangs up. Where it resets the connection, nothing does.
fn read(mut stream: &TcpStream) -> Vec<u8> {
    let mut bytes = Vec::new();
    let _ = stream.read_to_end(&mut bytes);
    bytes
}

fn send(port: u16, request: &[u8]) -> String {
    let mut stream = connect(port);
    let _ = stream.write_all(request);
    String::from_utf8_lossy(&read(&stream)).into_owned()
}

#[test]
fn the_page_is_served() {
    let port = serve();
    let text = send(port, format!("GET / HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n").as_bytes());
    assert!(text.starts_with("HTTP/1.1 200 OK\r\n") && text.ends_with("\r\n\r\n<p>page</p>"), "{text}");
    let text = send(port, b"HEAD / HTTP/1.0\r\nHost: localhost\r\n\r\n");
    assert!(
        text.starts_with("HTTP/1.1 200 OK\r\n") && text.ends_with("Content-Length: 11\r\n\r\n"),
        "{text}"
    );
}

#[test]
fn the_embedded_lab_is_served_packed_and_unpacked() {
    let server = Server::bind(Some(0)).expect("a free port");
    let port = server.port();
    assert_eq!(server.address(), format!("http://127.0.0.1:{port}/"));
    thread::spawn(move || server.serve(embedded()));
    let text = send(port, b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
    assert!(text.to_lowercase().contains("\r\n\r\n<!doctype html>"), "{text}");
    let text = send(port, b"GET / HTTP/1.1\r\nHost: localhost\r\nAccept-Encoding: gzip\r\n\r\n");
    assert!(text.starts_with("HTTP/1.1 200 OK\r\n"), "{text}");
}

#[test]
fn a_request_may_arrive_in_pieces() {
    let mut stream = connect(serve());
    stream.set_nodelay(true).expect("a socket");
    for byte in b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n" {
        stream.write_all(&[*byte]).expect("the server listens");
    }
    assert!(read(&stream).starts_with(b"HTTP/1.1 200 OK\r\n"));
}

#[test]
fn a_large_file_arrives_whole() {
    let mut stream = connect(serve());
    stream.write_all(b"GET /large.bin HTTP/1.1\r\nHost: localhost\r\n\r\n").expect("the server listens");
    let bytes = read(&stream);
    assert!(bytes.ends_with(SITE[1].bytes));
}

#[test]
fn connections_that_say_nothing_keep_nobody_waiting() {
    let port = serve();
    let silent: Vec<_> = (0..20).map(|_| connect(port)).collect();
    let (first, second) = (connect(port), connect(port));
    for mut stream in [&second, &first] {
        stream.write_all(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n").expect("the server listens");
        assert!(read(stream).starts_with(b"HTTP/1.1 200 OK\r\n"));
    }
    drop(silent);
}

#[test]
fn a_crowd_is_turned_away_and_the_server_goes_on() {
    let port = serve();
    let crowd: Vec<_> = (0..100).map(|_| connect(port)).collect();
    let last = crowd.last().expect("a crowd");
    assert!(read(last).starts_with(b"HTTP/1.1 503 "));
    drop(crowd);
    // The threads notice one after the other that their connections are gone.
    let answered = (0..100_000).any(|_| {
        thread::yield_now();
        send(port, b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n").starts_with("HTTP/1.1 200 OK\r\n")
    });
    assert!(answered);
}

#[test]
fn what_is_no_proper_request_is_refused_and_the_server_goes_on() {
    let port = serve();
    let long = "a".repeat(LONGEST);
    let cases = [
        ("GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n".to_string(), "403"),
        ("GET / HTTP/1.1\r\n\r\n".into(), "400"),
        ("POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 3\r\n\r\nabc".into(), "405"),
        ("GET /../Cargo.toml HTTP/1.1\r\nHost: localhost\r\n\r\n".into(), "404"),
        ("GET /%2e%2e/Cargo.toml HTTP/1.1\r\nHost: localhost\r\n\r\n".into(), "404"),
        ("GET http://localhost/ HTTP/1.1\r\nHost: localhost\r\n\r\n".into(), "400"),
        ("GET /\0 HTTP/1.1\r\nHost: localhost\r\n\r\n".into(), "400"),
        ("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n".into(), "400"),
        ("\x16\x03\x01\x02\0\x01".into(), "400"),
        (format!("GET /{long} HTTP/1.1\r\nHost: localhost\r\n\r\n"), "414"),
        (format!("GET / HTTP/1.1\r\nHost: localhost\r\nCookie: {long}\r\n\r\n"), "431"),
    ];
    for (request, status) in cases {
        let text = send(port, request.as_bytes());
        assert!(
            text.starts_with(&format!("HTTP/1.1 {status} ")),
            "{:.60}: {text}",
            request.escape_debug().to_string()
        );
    }
    // Sent without end, it is cut off.
    let mut stream = connect(port);
    let piece = vec![b'a'; 1 << 16];
    let ended = (0..10_000).find_map(|_| stream.write_all(&piece).err());
    let kinds = [ErrorKind::BrokenPipe, ErrorKind::ConnectionReset, ErrorKind::ConnectionAborted];
    assert!(kinds.contains(&ended.expect("the server hangs up").kind()));
    // Left in the middle, it is refused, too.
    let mut stream = connect(port);
    stream.write_all(b"GET / HT").expect("the server listens");
    stream.shutdown(Shutdown::Write).expect("a socket");
    assert!(read(&stream).starts_with(b"HTTP/1.1 400 "));
    assert!(send(port, b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n").starts_with("HTTP/1.1 200 OK\r\n"));
}

#[test]
fn a_taken_port_is_refused_and_the_usual_one_gives_way() {
    let first = Server::bind(None).expect("a free port");
    let second = Server::bind(None).expect("another free port");
    assert!(first.port() >= PORT && second.port() != first.port());
    let taken = Server::bind(Some(first.port())).map(|server| server.port());
    assert_eq!(taken.map_err(|error| error.kind()), Err(ErrorKind::AddrInUse));
}
