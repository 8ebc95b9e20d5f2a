//! Everything there is, as JSON: what the command line lists, and the scenarios with their text.

use precess::{json, scenarios};
use serde_json::{Value, json};

/// Systems with their equations, methods, scenarios.
pub fn catalogue() -> Value {
    let scenario = |(file, text): (&str, &str)| {
        let mut entry = json::scenario(file, text);
        entry["text"] = text.into();
        entry
    };
    json!({
        "systems": json::systems(),
        "methods": json::methods(),
        "scenarios": scenarios::all().into_iter().map(scenario).collect::<Vec<_>>(),
    })
}
