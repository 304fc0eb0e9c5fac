//! Who is answered: the bench's own page, and tools of this machine that say whom they ask.
//!
//! The server listens on the loopback address, but so does the browser of the person who runs it: any site that is open
//! there can send requests here, without being able to read the answers. Such a request must not be answered, because
//! the work alone would slow the bench. Pure: headers in, yes or no out. Sources: Fetch standard (Origin), Fetch
//! Metadata (Sec-Fetch-Site), CSP 3 (frame-ancestors), HTML (X-Frame-Options, Referrer-Policy).

use axum::http::header::{
    CONTENT_SECURITY_POLICY, HOST, HeaderName, ORIGIN, REFERER, REFERRER_POLICY, X_CONTENT_TYPE_OPTIONS,
    X_FRAME_OPTIONS,
};
use axum::http::{HeaderMap, HeaderValue};

/// Where the request comes from, in a word of the browser's.
const SEC_FETCH_SITE: HeaderName = HeaderName::from_static("sec-fetch-site");

/// Names under which this machine reaches itself over IPv4, where the server listens.
const NAMES: [&str; 2] = ["127.0.0.1", "localhost"];

/// The port that stands in no URL.
const HTTP_PORT: u16 = 80;

/// What stands on every answer: the page needs nothing that is not in it, nobody frames it, embeds what it serves or
/// keeps a handle on its window. `Referer` stays, for browsers that tell the page's own requests by nothing else.
pub(crate) const HEADERS: [(HeaderName, HeaderValue); 6] = [
    (
        CONTENT_SECURITY_POLICY,
        HeaderValue::from_static(
            "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
             img-src data: blob: 'self'; connect-src 'self'; base-uri 'none'; form-action 'none'; \
             frame-ancestors 'none'",
        ),
    ),
    (X_FRAME_OPTIONS, HeaderValue::from_static("DENY")),
    (X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff")),
    (REFERRER_POLICY, HeaderValue::from_static("same-origin")),
    (HeaderName::from_static("cross-origin-resource-policy"), HeaderValue::from_static("same-origin")),
    (HeaderName::from_static("cross-origin-opener-policy"), HeaderValue::from_static("same-origin")),
];

/// Whether a request for `path` on the server at `port` is answered.
///
/// No site can forge `Host`, `Origin`, `Sec-Fetch-Site`, nor a `Referer` of another origin. A browser of today always
/// sends `Sec-Fetch-Site` to the loopback address; an older one, and one that takes plain HTTP for untrustworthy even
/// here, sends neither that nor an `Origin` with an `<img>` of any site. So what names no origin at all gets `/`, which
/// costs nothing and is what one types; anything else needs proof: `Origin` (which every web socket has), `Referer`
/// (which the page's own links and fetches have), or a browser's word that it is the page or the address bar. There is no
/// token in the URL: it would stand in histories and logs, and tools would have to read the page to learn it.
pub(crate) fn is_answered(headers: &HeaderMap, path: &str, port: u16) -> bool {
    let Some(host) = only(headers, &HOST).filter(|host| is_own_host(host, port)) else { return false };
    let own = format!("http://{host}");
    let origin = only(headers, &ORIGIN).map(|origin| origin == own);
    let site = only(headers, &SEC_FETCH_SITE).map(|site| matches!(site, "same-origin" | "none"));
    let referer = only(headers, &REFERER).and_then(|referer| referer.strip_prefix(&own));
    match (origin, site) {
        (Some(false), _) | (_, Some(false)) => false,
        (Some(true), _) | (_, Some(true)) => true,
        (None, None) => path == "/" || referer.is_some_and(|rest| rest.starts_with('/')),
    }
}

/// Whether `host` is a name of this machine with the server's own port, to the letter.
fn is_own_host(host: &str, port: u16) -> bool {
    NAMES.iter().any(|name| {
        let rest = host.strip_prefix(name);
        rest.is_some_and(|rest| match rest.strip_prefix(':') {
            Some(digits) => digits == port.to_string(),
            None => rest.is_empty() && port == HTTP_PORT,
        })
    })
}

/// Returns a header; one that stands there twice or is no text is none that anybody may send.
fn only<'h>(headers: &'h HeaderMap, name: &HeaderName) -> Option<&'h str> {
    let mut values = headers.get_all(name).iter();
    let first = values.next()?;
    Some(if values.next().is_none() { first.to_str().unwrap_or_default() } else { "" })
}

#[cfg(test)]
mod tests {
    use super::*;

    const PORT: u16 = 8015;
    const OWN: (HeaderName, &str) = (HOST, "127.0.0.1:8015");

    fn answered(path: &str, headers: &[(HeaderName, &'static str)]) -> bool {
        let mut map = HeaderMap::new();
        for (name, value) in headers {
            map.append(name.clone(), HeaderValue::from_static(value));
        }
        is_answered(&map, path, PORT)
    }

    #[test]
    fn the_own_page_is_answered_whatever_the_browser_says_of_it() {
        for proof in [
            (ORIGIN, "http://127.0.0.1:8015"),
            (SEC_FETCH_SITE, "same-origin"),
            (SEC_FETCH_SITE, "none"),
            (REFERER, "http://127.0.0.1:8015/"),
        ] {
            assert!(answered("/screen/8", &[OWN, proof.clone()]), "{proof:?}");
        }
        assert!(answered("/live", &[(HOST, "localhost:8015"), (ORIGIN, "http://localhost:8015")]));
    }

    #[test]
    fn what_names_no_origin_gets_the_page_and_nothing_that_costs_work() {
        assert!(answered("/", &[OWN]));
        for path in ["/screen/8", "/live", "/recording.gif", "/recording.log", "/decode/18F13DF3/00"] {
            assert!(!answered(path, &[OWN]), "{path}");
        }
    }

    #[test]
    fn another_origin_is_refused_even_the_page() {
        for origin in [
            "http://example.org",
            "http://127.0.0.1:9000",
            "https://127.0.0.1:8015",
            "http://localhost:8015",
            "http://127.0.0.1:8015.example.org",
            "null",
            "file://",
            "",
        ] {
            assert!(!answered("/", &[OWN, (ORIGIN, origin)]), "{origin}");
            assert!(!answered("/", &[OWN, (ORIGIN, origin), (SEC_FETCH_SITE, "same-origin")]), "{origin}");
        }
        for site in ["cross-site", "same-site", "", "unheard-of"] {
            assert!(!answered("/", &[OWN, (SEC_FETCH_SITE, site)]), "{site}");
            assert!(!answered(
                "/screen/8",
                &[OWN, (SEC_FETCH_SITE, site), (REFERER, "http://127.0.0.1:8015/")]
            ));
        }
        for referer in
            ["http://example.org/", "http://127.0.0.1:80155/", "http://127.0.0.1:8015.example.org/"]
        {
            assert!(!answered("/screen/8", &[OWN, (REFERER, referer)]), "{referer}");
        }
    }

    #[test]
    fn only_a_loopback_name_with_the_own_port_is_a_host() {
        for host in [
            "127.0.0.1",
            "127.0.0.1:80",
            "127.0.0.1:9000",
            "127.0.0.1:08015",
            "127.0.0.1:8015.example.org",
            "127.0.0.1:x.example.org",
            "127.0.0.1.example.org:8015",
            "bench.example.org:8015",
            "localhost.example.org:8015",
            "user@127.0.0.1:8015",
            "[::1]:8015",
            "",
        ] {
            assert!(!answered("/", &[(HOST, host)]), "{host}");
        }
        assert!(!answered("/", &[]), "no host");
        assert!(!answered("/", &[OWN, OWN]), "two hosts");
        assert!(is_own_host("localhost", HTTP_PORT), "a browser leaves port 80 out");
    }
}
