//! What a fuzzer does with the parsers. `fuzz/` runs it without end, `parsers.rs` a bounded number of times.

use precess::{Plan, Scenario, scenario_toml, value};

/// Nothing panics; what is understood can be written back and is then understood the same way.
pub fn parsers(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    if let Ok(value) = value::parse(&text)
        && let value::Value::Number { x, .. } = value
    {
        assert!(x.is_finite());
        assert_eq!(value::parse(&value::shortest(x)), Ok(value::Value::number(x)));
    }
    let Ok(scenario) = Scenario::parse(&text) else { return };
    let Ok(plan) = Plan::new(&scenario) else { return };
    let written = scenario_toml(&plan);
    let again = Scenario::parse(&written).and_then(|s| Plan::new(&s));
    match again {
        Ok(again) => assert_eq!(scenario_toml(&again), written),
        Err(error) => panic!("{error} in\n{written}"),
    }
}
