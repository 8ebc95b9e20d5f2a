//! The files that are served.

/// A file of the lab.
#[derive(Debug)]
pub struct Asset {
    /// Its path in the address, without the slash at the front.
    pub name: &'static str,
    /// Its content, compressed where that pays.
    pub bytes: &'static [u8],
    /// Whether it is compressed.
    pub gzip: bool,
    /// Tells one version from the next.
    pub tag: &'static str,
}

/// All files of a lab.
pub type Site = &'static [Asset];

include!(concat!(env!("OUT_DIR"), "/embedded.rs"));

/// The lab as it was when this program was built.
pub fn embedded() -> Site {
    EMBEDDED
}

impl Asset {
    /// The file that a path names, letter by letter. Nothing is decoded and nothing is joined: `..`, `%2e` and `\`
    /// are letters like any other, of a name that no file has.
    pub fn find(site: Site, path: &str) -> Option<&'static Self> {
        let name = if path == "/" { "index.html" } else { path.strip_prefix('/')? };
        site.iter().find(|asset| asset.name == name)
    }

    /// What it is, for the browser, which takes a script or a WebAssembly module only under its right name.
    pub fn kind(&self) -> &'static str {
        match self.name.rsplit_once('.').map_or("", |(_, suffix)| suffix) {
            "html" => "text/html; charset=utf-8",
            "js" | "mjs" => "text/javascript; charset=utf-8",
            "css" => "text/css; charset=utf-8",
            "json" | "map" => "application/json",
            "webmanifest" => "application/manifest+json",
            "wasm" => "application/wasm",
            "svg" => "image/svg+xml",
            "png" => "image/png",
            "jpg" | "jpeg" => "image/jpeg",
            "webp" => "image/webp",
            "ico" => "image/x-icon",
            "woff2" => "font/woff2",
            "woff" => "font/woff",
            "ttf" => "font/ttf",
            "txt" | "md" | "toml" => "text/plain; charset=utf-8",
            "csv" => "text/csv; charset=utf-8",
            _ => "application/octet-stream",
        }
    }

    /// Whether the name holds a hash of the content (`assets/index-BxK3_f9a.js`), so that it never changes.
    pub fn is_immutable(&self) -> bool {
        let file = self.name.strip_prefix("assets/").and_then(|path| path.rsplit('/').next());
        let Some((stem, _)) = file.and_then(|file| file.split_once('.')) else { return false };
        // A name, a dash, eight letters of the hash, any of which may be a dash again.
        let Some((name, hash)) = stem.len().checked_sub(8).and_then(|cut| stem.split_at_checked(cut)) else {
            return false;
        };
        name.len() > 1
            && name.ends_with('-')
            && hash.bytes().all(|b| b.is_ascii_alphanumeric() || b"-_".contains(&b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asset(name: &'static str) -> Asset {
        Asset { name, bytes: b"", gzip: false, tag: "" }
    }

    #[test]
    fn the_embedded_lab_has_a_page() {
        let page = Asset::find(embedded(), "/").expect("a page");
        assert_eq!(page.kind(), "text/html; charset=utf-8");
    }

    #[test]
    fn only_hashed_names_never_change() {
        for name in
            ["assets/index-BxK3_f9a.js", "assets/a-b-0123-567.css", "assets/deep/precess-DAbc12_-.wasm"]
        {
            assert!(asset(name).is_immutable(), "{name}");
        }
        for name in
            ["index.html", "index-BxK3_f9a.js", "assets/index.js", "assets/-BxK3_f9a.js", "assets/a-b.js"]
        {
            assert!(!asset(name).is_immutable(), "{name}");
        }
    }
}
