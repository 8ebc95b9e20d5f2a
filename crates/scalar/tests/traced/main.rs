//! The recorded expression: replay, sharing, folding and printing.

mod calculator;
mod mechanics;
mod printing;
mod random;
mod replay;
mod taylor;
