//! `docs/catalogue.md` is what the cards say now.

use std::path::Path;

#[test]
fn the_page_of_the_catalogue_is_fresh() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/catalogue.md");
    let now = precess::page();
    if std::env::var_os("PRECESS_BLESS").is_some() {
        std::fs::write(&path, now).expect("the file can be written");
        return;
    }
    let file = std::fs::read_to_string(&path).expect("docs/catalogue.md is there");
    let stale = now.lines().zip(file.lines()).find(|(a, b)| a != b);
    let hint = "PRECESS_BLESS=1 cargo test -p precess --test catalogue writes it anew";
    assert!(stale.is_none() && now == file, "docs/catalogue.md is stale ({hint}): {stale:?}");
}

#[test]
fn every_system_has_an_entry_with_its_equations() {
    let page = precess::page();
    for system in precess::catalogue::systems() {
        let id = system.card().id;
        let entry = page.split(&format!("\n## {id}\n")).nth(1).expect("an entry");
        let entry = entry.split("\n## ").next().expect("its end");
        assert!(entry.contains("```text\n") && entry.contains(" = "), "{id} has no equations");
        assert!(entry.len() < 20_000, "{id}: an entry of {} letters", entry.len());
    }
}
