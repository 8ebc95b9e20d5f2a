//! `precess lab` as a user meets it: an address, a page, and how it ends.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::process::{Child, Command, Stdio};

/// A running `precess lab`, which does not outlive the test.
struct Lab(Child);

impl Lab {
    fn start(arguments: &[&str]) -> (Self, String) {
        let mut child = Command::new(env!("CARGO_BIN_EXE_precess"))
            .arg("lab")
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut line = String::new();
        let out = child.stdout.as_mut().expect("a pipe");
        // One line is all there is: the rest of the buffer is read at the end.
        BufReader::with_capacity(1, out).read_line(&mut line).expect("a line");
        (Self(child), line)
    }
}

impl Drop for Lab {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn port(line: &str) -> u16 {
    let number = line.strip_prefix("http://127.0.0.1:").and_then(|rest| rest.strip_suffix("/\n"));
    number.and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("no address: {line}"))
}

fn page(port: u16) -> String {
    let mut stream = TcpStream::connect((Ipv4Addr::LOCALHOST, port)).expect("the lab listens");
    stream.write_all(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n").expect("the lab listens");
    let mut text = String::new();
    stream.read_to_string(&mut text).expect("an answer");
    text
}

#[test]
fn the_lab_prints_its_address_and_answers() {
    let (_first, line) = Lab::start(&["--port", "0"]);
    let text = page(port(&line));
    assert!(text.starts_with("HTTP/1.1 200 OK\r\n") && text.contains("Precess"), "{text}");
    // Two at once, without a port: each finds one of its own.
    let (_second, line) = Lab::start(&[]);
    let (_third, other) = Lab::start(&[]);
    assert_ne!(port(&line), port(&other));
}

#[cfg(unix)]
#[test]
fn an_interrupt_ends_it_with_success_and_one_line() {
    for signal in ["INT", "TERM"] {
        let (mut lab, line) = Lab::start(&["--port", "0"]);
        // A connection that is open does not keep it from ending.
        let _open = TcpStream::connect((Ipv4Addr::LOCALHOST, port(&line))).expect("the lab listens");
        let kill = Command::new("sh").args(["-c", &format!("kill -{signal} {}", lab.0.id())]).status();
        assert!(kill.expect("a shell").success());
        assert_eq!(lab.0.wait().expect("it ends").code(), Some(0), "{signal}");
        let mut rest = String::new();
        lab.0.stdout.take().expect("a pipe").read_to_string(&mut rest).expect("text");
        assert!(rest.is_empty(), "{rest}");
        let mut said = String::new();
        lab.0.stderr.take().expect("a pipe").read_to_string(&mut said).expect("text");
        assert!(said.is_empty() || said.contains("`make lab`") && said.lines().count() == 1, "{said}");
    }
}

#[test]
fn what_cannot_be_served_is_said_in_one_sentence() {
    let taken = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).expect("a free port");
    let taken = taken.local_addr().map(|address| (taken, address.port().to_string())).expect("an address");
    for (arguments, status, word) in [
        (vec!["lab", "--port", &taken.1], 1, "is taken"),
        (vec!["lab", "--port", "65536"], 2, "65536"),
        (vec!["lab", "--port", "-1"], 2, "-1"),
        (vec!["lab", "--port", "http"], 2, "http"),
        (vec!["lab", "--prot", "1"], 2, "--port"),
    ] {
        let run = Command::new(env!("CARGO_BIN_EXE_precess")).args(&arguments).output().expect("it starts");
        let message = String::from_utf8_lossy(&run.stderr);
        assert_eq!(run.status.code(), Some(status), "{arguments:?}: {message}");
        assert!(message.contains(word) && !message.contains("panicked"), "{arguments:?}: {message}");
        assert!(run.stdout.is_empty(), "{arguments:?}");
        assert!(status == 2 || message.trim_end().lines().count() == 1, "{message}");
    }
}
