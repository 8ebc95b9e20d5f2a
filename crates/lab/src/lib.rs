//! Serves the lab to a browser on this machine: the files of `web/dist`, embedded when the program was built.
//!
//! A crate of its own rather than a module of the terminal: it knows nothing of mechanics, its build script need
//! not run for the rest, and its tests speak to the server without starting the program.
//!
//! The server is the standard library's sockets and hyper's parser. `tiny_http` was passed over: no release since
//! 2022, and no limit to what it reads. Nothing is read from the disk while it runs, so an address can name an
//! embedded file or nothing at all.

mod assets;
mod headers;
mod request;
mod response;
mod server;

pub use assets::{Asset, BUILT, Site, embedded};
pub use request::{LONGEST, Parsed, Request, parse};
pub use response::{Response, answer, refuse};
pub use server::{PORT, Server};
