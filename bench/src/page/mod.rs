//! The local page that shows the panel of a running bench.
//!
//! Owns the pace (virtual time follows the wall clock, or runs as fast as it can) and the socket between page and
//! bench; refuses to know what the picture means. One self-contained page, served from the binary. Listens on the
//! loopback address only.

use crate::rig::Rig;
use crate::time::Nanos;
use anyhow::{Context, Result};
use axum::extract::State;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::response::{Html, IntoResponse};
use axum::routing::get;
use serde::{Deserialize, Serialize};
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::mpsc;
use std::time::{Duration, Instant};
use tokio::sync::watch;

/// Virtual time that passes between two looks at the page's commands.
const SLICE: Nanos = Nanos::from_millis(10);
/// Pictures are sent at most this often.
const PICTURE_EVERY: Duration = Duration::from_millis(33);

/// What the page may ask for.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case")]
enum Command {
    /// Holds or lets go of a button of the cluster.
    Button {
        /// 0 or 1.
        index: usize,
        /// Held down.
        down: bool,
    },
    /// Stops or continues virtual time.
    Pause {
        /// Virtual time stands still.
        on: bool,
    },
    /// While paused: lets one slice of virtual time pass.
    Step,
    /// Sets how fast virtual time runs; 1 = real time, 0 = as fast as the machine can.
    Speed {
        /// Virtual seconds per second.
        factor: f64,
    },
}

/// What the page shows beside the picture.
#[derive(Clone, Debug, Default, Serialize)]
struct Status {
    /// Virtual seconds since power-on.
    seconds: f64,
    /// Virtual seconds that the engine makes of one second of its thread.
    ratio: f64,
    paused: bool,
    /// Frames that have been on the bus.
    bus_frames: u64,
    /// Frames that the firmware says it has received.
    received: u64,
    /// Frames lost in the controller or in the firmware.
    lost: u64,
    /// What the firmware says is shown, as text.
    shown: Vec<(String, String)>,
    /// Why the bench stopped, if it did.
    stopped: Option<String>,
}

/// What is sent to every page.
#[derive(Clone, Default)]
struct Live {
    png: Vec<u8>,
    status: String,
}

#[derive(Clone)]
struct Shared {
    live: watch::Receiver<Live>,
    commands: mpsc::Sender<Command>,
}

/// Serves the page until the process ends; `make` builds the bench on its own thread.
///
/// # Errors
/// If the address cannot be bound (another program uses the port) or the bench cannot be built.
pub fn serve(port: u16, make: impl FnOnce() -> Result<Rig> + Send + 'static) -> Result<()> {
    let (to_pages, live) = watch::channel(Live::default());
    let (commands, from_pages) = mpsc::channel();
    let (ready, is_ready) = mpsc::channel();
    std::thread::Builder::new().name("bench".into()).spawn(move || match make() {
        Ok(rig) => {
            let _ = ready.send(Ok(()));
            drive(rig, &from_pages, &to_pages);
        }
        Err(error) => {
            let _ = ready.send(Err(error));
        }
    })?;
    is_ready.recv().context("the bench ended while it was built")??;
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
    runtime.block_on(async {
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, port));
        let listener = tokio::net::TcpListener::bind(address)
            .await
            .with_context(|| format!("cannot serve on {address}; is another bench running? try --port"))?;
        println!("the cluster drives at http://{}/  (Ctrl-C ends it)", listener.local_addr()?);
        let routes = axum::Router::new()
            .route("/", get(|| async { Html(include_str!("page.html")) }))
            .route("/live", get(join))
            .with_state(Shared { live, commands });
        axum::serve(listener, routes).await.map_err(Into::into)
    })
}

async fn join(upgrade: WebSocketUpgrade, State(shared): State<Shared>) -> impl IntoResponse {
    upgrade.on_upgrade(|socket| talk(socket, shared))
}

/// Sends pictures and status to one page and takes its commands until it leaves.
async fn talk(mut socket: WebSocket, mut shared: Shared) {
    loop {
        tokio::select! {
            changed = shared.live.changed() => {
                if changed.is_err() {
                    return;
                }
                let live = shared.live.borrow_and_update().clone();
                let sent = socket.send(Message::Binary(live.png.into())).await.is_ok()
                    && socket.send(Message::Text(live.status.into())).await.is_ok();
                if !sent {
                    return;
                }
            }
            message = socket.recv() => match message {
                Some(Ok(Message::Text(text))) => {
                    if let Ok(command) = serde_json::from_str(&text) {
                        let _ = shared.commands.send(command);
                    }
                }
                Some(Ok(Message::Close(_)) | Err(_)) | None => return,
                Some(Ok(_)) => {}
            }
        }
    }
}

/// How virtual time follows the wall clock.
struct Pace {
    paused: bool,
    step: bool,
    factor: f64,
    /// Where virtual and real time were when the pace last changed.
    since: (Nanos, Instant),
    /// Virtual time and thread time spent in the engine, for the ratio.
    spent: (f64, f64),
}

fn drive(mut rig: Rig, commands: &mpsc::Receiver<Command>, pages: &watch::Sender<Live>) {
    let mut pace = Pace {
        paused: false,
        step: false,
        factor: 1.0,
        since: (rig.now(), Instant::now()),
        spent: (0.0, 0.0),
    };
    let mut pictured = Instant::now();
    let mut stopped = None;
    loop {
        while let Ok(command) = commands.try_recv() {
            match command {
                Command::Button { index, down } => rig.hold_button(index, down),
                Command::Pause { on } => pace.paused = on,
                Command::Step => pace.step = true,
                Command::Speed { factor } => pace.factor = factor.clamp(0.0, 100.0),
            }
            pace.since = (rig.now(), Instant::now());
        }
        let due = if pace.paused { pace.step } else { is_due(&pace, rig.now()) };
        if due && stopped.is_none() {
            pace.step = false;
            let started = Instant::now();
            stopped = rig.run_for(SLICE).err().map(|stop| stop.to_string());
            pace.spent.0 += SLICE.as_secs_f64();
            pace.spent.1 += started.elapsed().as_secs_f64();
        } else {
            std::thread::sleep(Duration::from_millis(2));
        }
        if pictured.elapsed() >= PICTURE_EVERY {
            pictured = Instant::now();
            let status = status(&rig, &mut pace, stopped.clone());
            let status = serde_json::to_string(&status).unwrap_or_default();
            if pages.send(Live { png: rig.picture_png(), status }).is_err() {
                return;
            }
        }
    }
}

fn is_due(pace: &Pace, now: Nanos) -> bool {
    let behind = pace.since.1.elapsed().as_secs_f64() * pace.factor - now.since(pace.since.0).as_secs_f64();
    pace.factor == 0.0 || behind > 0.0
}

fn status(rig: &Rig, pace: &mut Pace, stopped: Option<String>) -> Status {
    let ratio = pace.spent.0 / pace.spent.1.max(1e-9);
    // The ratio follows the last seconds: old work fades out.
    if pace.spent.1 > 2.0 {
        pace.spent = (pace.spent.0 / 2.0, pace.spent.1 / 2.0);
    }
    let counts = rig.counts();
    Status {
        seconds: rig.now().as_secs_f64(),
        ratio,
        paused: pace.paused,
        bus_frames: counts.on_bus,
        received: counts.received,
        lost: counts.lost,
        shown: rig.shown_lines(),
        stopped,
    }
}
