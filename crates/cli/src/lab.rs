//! `precess lab`: the lab in a browser on this machine.

use crate::failure::{Failure, reason};
use precess_lab::{BUILT, Server, embedded};
use std::io::{self, Write};
use std::sync::mpsc;
use std::thread;

/// Serves the lab until Ctrl-C.
pub fn lab(port: Option<u16>) -> Result<(), Failure> {
    let server = Server::bind(port).map_err(|error| refusal(port, &error))?;
    // Before the address is out: whoever reads it may end the program at once.
    let (stop, stopped) = mpsc::channel();
    let ask = stop.clone();
    // Without a handler Ctrl-C ends the program all the same, with another exit status.
    let _ = ctrlc::set_handler(move || {
        let _ = ask.send(());
    });
    if !BUILT {
        let _ =
            writeln!(io::stderr(), "precess: this program was built without the lab: `make lab` builds it");
    }
    let mut out = io::stdout().lock();
    writeln!(out, "{}", server.address())
        .and_then(|()| out.flush())
        .map_err(|error| Failure::of_writing("standard output", &error))?;
    drop(out);
    thread::spawn(move || server.serve(embedded()));
    // `stop` is held here, so this waits for Ctrl-C and nothing else.
    let _ = stopped.recv();
    drop(stop);
    Ok(())
}

fn refusal(port: Option<u16>, error: &io::Error) -> Failure {
    Failure::Failed(match port {
        Some(port) if error.kind() == io::ErrorKind::AddrInUse => {
            format!("port {port} is taken; without --port the next free one is found")
        }
        Some(port) => format!("cannot listen on port {port}: {}", reason(error)),
        None => format!("cannot listen on loopback: {}", reason(error)),
    })
}
