//! The contract of Precess: what a mechanical system is, and nothing about how it is integrated.
//!
//! A system is a [`Card`] (names, units, defaults, texts, source) and its [`System`] equations, generic over
//! the number. [`Field`] is the one seam where the system's type is forgotten and the number's is kept.

mod any_system;
mod bound;
mod card;
mod columns;
mod coordinate;
mod coordinates;
mod expression;
mod field;
mod hamilton;
mod layout;
mod quantity;
mod shape;
mod state;
mod structure;
mod system;
mod text;
mod trajectory;
mod units;
mod values;

pub use any_system::{AnySystem, LawNumbers, TangentNumbers};
pub use card::{Card, Defaults, Direction, Event, Held, Observable, ObservableKind, View, card};
pub use columns::{Column, ColumnKind, Columns};
pub use coordinate::{Coordinate, Order, coordinate};
pub use coordinates::{Coordinates, Swarm};
pub use expression::expression;
#[cfg(feature = "tangents")]
pub use field::Observes;
pub use field::{Bind, Field, Rates};
pub use hamilton::{beside_the_lagrangian, momenta};
pub use layout::Layout;
pub use quantity::{Default, Parameter, Quantity, Range, choice, list, number, quantity, rows};
pub use shape::{Second, Shape};
pub use state::State;
pub use structure::{Structure, structure};
pub use system::{Given, Satellites, System};
pub use text::Text;
pub use trajectory::{Occurrence, Trajectory};
pub use units::{UnitError, parse_unit};
pub use values::{List, Values};
