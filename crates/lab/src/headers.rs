//! What every answer says about itself to the browser.

/// What the lab's pages may do.
///
/// Everything comes from this server; `wasm-unsafe-eval` lets the core be compiled, `unsafe-inline` is for styles
/// that the graphs and formulas set on their elements. `blob:` is for workers and for pictures that are saved.
/// `frame-ancestors *`: a course page may show the lab in a frame. There is nothing to lose by it: no account, no
/// cookie, no command that a click could be lured into.
const POLICY: &str = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; \
     img-src 'self' data: blob:; worker-src 'self' blob:; connect-src 'self'; font-src 'self'; object-src 'none'; \
     base-uri 'none'; form-action 'none'; frame-ancestors *";

/// The headers of every answer, refusals too.
pub const ALWAYS: [(&str, &str); 7] = [
    ("Content-Security-Policy", POLICY),
    // Both together isolate the page, so that its workers may share memory. In a frame they do so only where the
    // course page is isolated as well; the lab has to work without.
    ("Cross-Origin-Opener-Policy", "same-origin"),
    ("Cross-Origin-Embedder-Policy", "require-corp"),
    // An isolated course page shows only frames that say this. The lab's own files come from its own origin and
    // would load under any value; they are the same for everybody, and no page of another origin can read them.
    ("Cross-Origin-Resource-Policy", "cross-origin"),
    ("X-Content-Type-Options", "nosniff"),
    ("Referrer-Policy", "no-referrer"),
    // One request a connection: on loopback a new one costs nothing, and none is left waiting.
    ("Connection", "close"),
];
