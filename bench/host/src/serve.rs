//! The page's web server: one page, one socket, a few files. Loopback only.
//!
//! Carries, and understands nothing; [`gate`] says who is answered. The bench's thread is asked for nothing but what a
//! page's commands do: files are made here, of what it told last, so that no number of requests slows virtual time.

use crate::gate;
use crate::screens::Screens;
use crate::told::{Latest, Told};
use axum::body::Bytes;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::extract::{Path, Request, State};
use axum::http::StatusCode;
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_TYPE};
use axum::middleware::{self, Next};
use axum::response::{Html, IntoResponse, Response};
use axum::routing::get;
use bench_page::{Command, Link};
use std::sync::{LazyLock, mpsc};
use tokio::sync::broadcast::error::RecvError;
use tokio::sync::{broadcast, watch};

/// The page.
static PAGE: LazyLock<String> = LazyLock::new(|| bench_page::html(Link::Socket));

/// Largest command that a page may send, in bytes.
const COMMAND_MAX: usize = 4_096;

/// What a handler can reach.
#[derive(Clone)]
pub(crate) struct Shared {
    pub(crate) commands: mpsc::Sender<Command>,
    pub(crate) latest: watch::Receiver<Latest>,
    pub(crate) updates: broadcast::Sender<Told>,
    pub(crate) screens: Screens,
}

/// Returns everything that is served on `port`.
pub(crate) fn routes(shared: Shared, port: u16) -> axum::Router {
    axum::Router::new()
        .route("/", get(async || Html(PAGE.as_str())))
        .route("/live", get(join))
        .route("/decode/{id}/{data}", get(decode))
        .route("/screen/{scale}", get(screen))
        .route("/recording.gif", get(gif))
        .route("/recording.log", get(log))
        .with_state(shared)
        .layer(middleware::from_fn_with_state(port, guard))
}

/// Refuses who is not to be answered, and says on every answer what a browser may do with it.
async fn guard(State(port): State<u16>, request: Request, next: Next) -> Response {
    let mut answer = if gate::is_answered(request.headers(), request.uri().path(), port) {
        next.run(request).await
    } else {
        let own = format!("http://127.0.0.1:{port}/");
        let how = format!(
            "this bench answers its own page on this machine only: type {own} into the address bar; a tool sends \
             the header `Referer: {own}`\n"
        );
        (StatusCode::FORBIDDEN, how).into_response()
    };
    answer.headers_mut().extend(gate::HEADERS);
    answer
}

async fn join(upgrade: WebSocketUpgrade, State(shared): State<Shared>) -> Response {
    upgrade.max_message_size(COMMAND_MAX).on_upgrade(|socket| talk(socket, shared))
}

/// Tells one page what happens and takes its commands until it leaves.
async fn talk(mut socket: WebSocket, shared: Shared) {
    let mut updates = shared.updates.subscribe();
    let latest = shared.latest.borrow().clone();
    let greeted = socket.send(Message::Text(latest.catalog.as_ref().into())).await.is_ok()
        && (latest.picture.is_empty() || socket.send(Message::Binary(latest.picture)).await.is_ok());
    if !greeted || shared.commands.send(Command::Look).is_err() {
        return;
    }
    loop {
        tokio::select! {
            update = updates.recv() => {
                let message = match update {
                    Ok(Told::Picture(png)) => Message::Binary(png),
                    Ok(Told::Text(text)) => Message::Text(text.as_ref().into()),
                    // A page that is too slow goes on with what is new, and is told all rows again.
                    Err(RecvError::Lagged(_)) => {
                        let _ = shared.commands.send(Command::Look);
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
                    let command = serde_json::from_str(&text);
                    if command.is_ok_and(|command| shared.commands.send(command).is_err()) {
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
    match bench_page::decode_to_json(&id, &data) {
        Ok(text) => ([(CONTENT_TYPE, "application/json")], text).into_response(),
        Err(problem) => (StatusCode::NOT_FOUND, problem).into_response(),
    }
}

async fn screen(State(shared): State<Shared>, Path(scale): Path<u32>) -> Response {
    match shared.screens.png(&shared.latest, scale).await {
        Ok(png) => file("image/png", "cluster.png", png),
        Err(problem) => (StatusCode::NOT_FOUND, problem).into_response(),
    }
}

async fn gif(State(shared): State<Shared>) -> Response {
    let recorded = shared.latest.borrow().recorded.clone();
    recorded.map_or_else(nothing_recorded, |recording| {
        file("image/gif", "cluster.gif", Bytes::from_owner(recording.gif))
    })
}

async fn log(State(shared): State<Shared>) -> Response {
    let recorded = shared.latest.borrow().recorded.clone();
    let kind = "text/plain; charset=utf-8";
    recorded.map_or_else(nothing_recorded, |recording| {
        file(kind, "cluster.log", Bytes::from_owner(recording.log))
    })
}

fn nothing_recorded() -> Response {
    (StatusCode::NOT_FOUND, "nothing has been recorded yet").into_response()
}

fn file(kind: &'static str, name: &str, bytes: Bytes) -> Response {
    let name = format!("attachment; filename=\"{name}\"");
    ([(CONTENT_TYPE, kind.to_owned()), (CONTENT_DISPOSITION, name)], bytes).into_response()
}
