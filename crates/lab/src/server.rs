//! Sockets and threads: a connection each, one request a connection.

use crate::assets::Site;
use crate::request::{LONGEST, Parsed, parse};
use crate::response::{Response, answer, refuse};
use std::io::{self, Read};
use std::net::{Ipv4Addr, Shutdown, TcpListener, TcpStream};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

/// The port where none is asked for, if it is free.
pub const PORT: u16 = 7654;

/// How many ports after it are tried.
const NEIGHBOURS: u16 = 100;

/// A browser opens six connections and a few more in advance.
const CONNECTIONS: usize = 64;

/// How long a request may take to arrive.
const PATIENCE: Duration = Duration::from_secs(10);

/// How long a browser may take to hang up after the answer.
const FAREWELL: Duration = Duration::from_secs(1);

/// A server on loopback that does not answer yet.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    port: u16,
}

impl Server {
    /// Takes a port of this machine, which no other machine can reach. Zero is any free one; `None` is the usual
    /// one, or the next that is free.
    ///
    /// # Errors
    ///
    /// Where the port is taken or not to be had.
    pub fn bind(port: Option<u16>) -> io::Result<Self> {
        let at = |port| TcpListener::bind((Ipv4Addr::LOCALHOST, port));
        let listener = match port {
            Some(port) => at(port)?,
            None => (PORT..=PORT + NEIGHBOURS).find_map(|port| at(port).ok()).map_or_else(|| at(0), Ok)?,
        };
        let port = listener.local_addr()?.port();
        Ok(Self { listener, port })
    }

    /// Where it is found.
    pub fn address(&self) -> String {
        format!("http://{}:{}/", Ipv4Addr::LOCALHOST, self.port)
    }

    /// The port it has.
    pub fn port(&self) -> u16 {
        self.port
    }

    /// Answers for ever.
    pub fn serve(&self, site: Site) -> ! {
        // Every thread holds one of these; they are counted.
        let place = Arc::new(());
        loop {
            let Ok((stream, _)) = self.listener.accept() else {
                // The browser left again, or this process has too many files open, which passes.
                thread::sleep(Duration::from_millis(5));
                continue;
            };
            if Arc::strong_count(&place) > CONNECTIONS {
                let _ = refuse(503).write(&mut &stream);
                continue;
            }
            let place = Arc::clone(&place);
            // Where no thread is to be had, the connection is closed.
            let _ = thread::Builder::new().name("lab".into()).spawn(move || {
                // A browser that leaves in the middle is no failure.
                let _ = converse(&stream, site);
                drop(place);
            });
        }
    }
}

fn converse(mut stream: &TcpStream, site: Site) -> io::Result<()> {
    let Some(response) = listen(stream, site, Instant::now() + PATIENCE)? else { return Ok(()) };
    stream.set_write_timeout(Some(PATIENCE))?;
    response.write(&mut stream)?;
    stream.shutdown(Shutdown::Write)?;
    // Closed with bytes unread, the connection would be reset and the answer might be lost.
    let deadline = Instant::now() + FAREWELL;
    let mut rest = [0; 4096];
    for _ in 0..64 {
        if !wait(stream, deadline) || stream.read(&mut rest)? == 0 {
            break;
        }
    }
    Ok(())
}

/// The answer to what arrives, if anything does.
fn listen(mut stream: &TcpStream, site: Site, deadline: Instant) -> io::Result<Option<Response>> {
    let mut bytes = Vec::with_capacity(1024);
    let mut piece = [0; 4096];
    loop {
        let arrived = if wait(stream, deadline) { stream.read(&mut piece) } else { Ok(0) };
        let length = match arrived {
            Ok(length) => length,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            // Time is over: two names for it, by platform.
            Err(error) if [io::ErrorKind::WouldBlock, io::ErrorKind::TimedOut].contains(&error.kind()) => 0,
            Err(error) => return Err(error),
        };
        if length == 0 {
            // A connection that was made in advance and never used.
            let unused = bytes.is_empty();
            let status = if Instant::now() < deadline { 400 } else { 408 };
            return Ok((!unused).then(|| refuse(status)));
        }
        bytes.extend_from_slice(&piece[..length]);
        debug_assert!(bytes.len() <= LONGEST + piece.len());
        match parse(&bytes) {
            Parsed::Whole(request) => return Ok(Some(answer(&request, site))),
            Parsed::Partial => {}
            Parsed::Broken(status) => return Ok(Some(refuse(status))),
        }
    }
}

/// Lets the next read wait until the deadline and no longer.
fn wait(stream: &TcpStream, deadline: Instant) -> bool {
    let left = deadline.saturating_duration_since(Instant::now());
    !left.is_zero() && stream.set_read_timeout(Some(left)).is_ok()
}
