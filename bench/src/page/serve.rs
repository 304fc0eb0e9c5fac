//! The page's web server: one page, one socket, a few files. Loopback only.
//!
//! Carries, and understands nothing. A page of another site that runs in the same browser must not drive the bench:
//! requests that another origin makes, or that come under another host's name, are refused.

use super::session::{Command, File, Latest, Request, Update};
use super::trace;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::extract::{Path, Request as WebRequest, State};
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_SECURITY_POLICY, CONTENT_TYPE, HOST, ORIGIN};
use axum::http::{HeaderMap, StatusCode};
use axum::middleware::{self, Next};
use axum::response::{Html, IntoResponse, Response};
use axum::routing::get;
use std::sync::{LazyLock, mpsc};
use tokio::sync::broadcast::error::RecvError;
use tokio::sync::{broadcast, oneshot, watch};

/// The page: markup, style and script are three files in the source and one on the wire.
static PAGE: LazyLock<String> = LazyLock::new(|| {
    include_str!("page.html")
        .replace("/* page.css */", include_str!("page.css"))
        .replace("/* page.js */", include_str!("page.js"))
});

/// Everything the page needs is in it.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob: 'self'; \
                      connect-src 'self'";

/// Largest command that a page may send, in bytes.
const COMMAND_MAX: usize = 4_096;

/// What a handler can reach.
#[derive(Clone)]
pub(super) struct Shared {
    pub(super) requests: mpsc::Sender<Request>,
    pub(super) latest: watch::Receiver<Latest>,
    pub(super) updates: broadcast::Sender<Update>,
}

/// Returns everything that is served.
pub(super) fn routes(shared: Shared) -> axum::Router {
    axum::Router::new()
        .route("/", get(page))
        .route("/live", get(join))
        .route("/decode/{id}/{data}", get(decode))
        .route("/screen/{scale}", get(screen))
        .route("/recording.gif", get(|shared| recording(shared, File::Gif)))
        .route("/recording.log", get(|shared| recording(shared, File::Log)))
        .with_state(shared)
        .layer(middleware::from_fn(only_own_pages))
}

async fn page() -> impl IntoResponse {
    ([(CONTENT_SECURITY_POLICY, POLICY)], Html(PAGE.as_str()))
}

async fn only_own_pages(request: WebRequest, next: Next) -> Response {
    if is_own(request.headers()) {
        next.run(request).await
    } else {
        (StatusCode::FORBIDDEN, "this bench answers its own page on this machine only").into_response()
    }
}

/// Whether a request comes from the bench's own page, or from no page at all.
fn is_own(headers: &HeaderMap) -> bool {
    let text = |name| headers.get(name).and_then(|value| value.to_str().ok());
    let Some(host) = text(HOST) else { return false };
    let name = host.rsplit_once(':').map_or(host, |(name, _)| name);
    let local = matches!(name, "127.0.0.1" | "localhost" | "[::1]");
    local && text(ORIGIN).is_none_or(|origin| origin.strip_prefix("http://") == Some(host))
}

async fn join(upgrade: WebSocketUpgrade, State(shared): State<Shared>) -> Response {
    upgrade.max_message_size(COMMAND_MAX).on_upgrade(|socket| talk(socket, shared))
}

/// Tells one page what happens and takes its commands until it leaves.
async fn talk(mut socket: WebSocket, shared: Shared) {
    let mut updates = shared.updates.subscribe();
    let latest = shared.latest.borrow().clone();
    let greeted = socket.send(Message::Text(latest.catalog)).await.is_ok()
        && (latest.picture.is_empty() || socket.send(Message::Binary(latest.picture)).await.is_ok());
    if !greeted || shared.requests.send(Request::Do(Command::Look)).is_err() {
        return;
    }
    loop {
        tokio::select! {
            update = updates.recv() => {
                let message = match update {
                    Ok(Update::Picture(png)) => Message::Binary(png),
                    Ok(Update::Text(text)) => Message::Text(text),
                    // A page that is too slow goes on with what is new, and is told all rows again.
                    Err(RecvError::Lagged(_)) => {
                        let _ = shared.requests.send(Request::Do(Command::Look));
                        continue;
                    }
                    Err(RecvError::Closed) => return,
                };
                if socket.send(message).await.is_err() {
                    return;
                }
            }
            message = socket.recv() => match message {
                Some(Ok(Message::Text(text))) => {
                    let request = serde_json::from_str(&text).map(Request::Do);
                    if request.is_ok_and(|request| shared.requests.send(request).is_err()) {
                        return;
                    }
                }
                Some(Ok(Message::Close(_)) | Err(_)) | None => return,
                Some(Ok(_)) => {}
            }
        }
    }
}

async fn decode(Path((id, data)): Path<(String, String)>) -> Response {
    match trace::decode(&id, &data) {
        Ok(signals) => {
            let text = serde_json::to_string(&signals).unwrap_or_default();
            ([(CONTENT_TYPE, "application/json")], text).into_response()
        }
        Err(problem) => (StatusCode::NOT_FOUND, problem).into_response(),
    }
}

async fn screen(State(shared): State<Shared>, Path(scale): Path<u32>) -> Response {
    file(&shared, File::Picture(scale)).await
}

async fn recording(State(shared): State<Shared>, wanted: File) -> Response {
    file(&shared, wanted).await
}

async fn file(shared: &Shared, file: File) -> Response {
    let (reply, answer) = oneshot::channel();
    if shared.requests.send(Request::Make(file, reply)).is_err() {
        return (StatusCode::GONE, "the bench has ended").into_response();
    }
    let (kind, name) = match file {
        File::Picture(_) => ("image/png", "cluster.png"),
        File::Gif => ("image/gif", "cluster.gif"),
        File::Log => ("text/plain; charset=utf-8", "cluster.log"),
    };
    match answer.await {
        Ok(Ok(bytes)) => {
            let name = format!("attachment; filename=\"{name}\"");
            ([(CONTENT_TYPE, kind.to_owned()), (CONTENT_DISPOSITION, name)], bytes).into_response()
        }
        Ok(Err(problem)) => (StatusCode::NOT_FOUND, problem).into_response(),
        Err(_) => (StatusCode::GONE, "the bench has ended").into_response(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::http::{HeaderName, HeaderValue};

    fn asked(headers: &[(HeaderName, &'static str)]) -> bool {
        is_own(&headers.iter().map(|(name, value)| (name.clone(), HeaderValue::from_static(value))).collect())
    }

    #[test]
    fn only_the_own_page_on_this_machine_is_answered() {
        assert!(asked(&[(HOST, "127.0.0.1:8015")]));
        assert!(asked(&[(HOST, "localhost:8015"), (ORIGIN, "http://localhost:8015")]));
        assert!(!asked(&[(HOST, "127.0.0.1:8015"), (ORIGIN, "http://example.org")]), "another site");
        assert!(!asked(&[(HOST, "127.0.0.1:8015"), (ORIGIN, "http://127.0.0.1:9000")]), "another port");
        assert!(!asked(&[(HOST, "bench.example.org:8015")]), "a name that was bent to this machine");
        assert!(!asked(&[]));
    }

    #[test]
    fn the_page_is_whole_and_names_no_other_host() {
        assert!(!PAGE.contains("/* page."), "style and script are in it");
        for (at, _) in PAGE.match_indices("://") {
            let around = &PAGE[at.saturating_sub(5)..at + 3];
            assert!(around.ends_with("ws://") || PAGE[at..].starts_with("://www.w3.org/"), "{around}");
        }
    }
}
