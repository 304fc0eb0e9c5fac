//! The server of the bench's page: one bench on a thread of its own, one page for any number of browsers of this machine.
//!
//! [`Server`] runs the session of the page ([`bench_page`]) on a thread and serves it ([`serve`]; [`gate`] says whom);
//! [`judge`] judges scenarios on another thread, [`screens`] makes pictures for whoever asks.

#![forbid(unsafe_code)]

mod gate;
mod judge;
mod screens;
mod serve;
mod told;

use anyhow::{Context, Result, anyhow};
use bench::rig::Rig;
use bench::scenario;
use bench_page::{Beginning, Command, Judge, Library, Session, Update};
use judge::JudgeThread;
use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, TryRecvError};
use std::thread::JoinHandle;
use std::time::Instant;
use tokio::sync::{broadcast, oneshot, watch};
use told::{Latest, Told};
use virtual_vehicle::Kind;

/// Commands that are obeyed between two slices.
const COMMANDS_PER_SLICE: usize = 64;
/// Updates that wait for a page that is slow.
const UPDATES_KEPT: usize = 64;

/// With what a page begins.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// Port on the loopback address; 0 takes any free one.
    pub port: u16,
    /// The vehicle around the cluster; `None` = the recording.
    pub vehicle: Option<Kind>,
    /// Name of the recording that can be played in place of a vehicle.
    pub recording: Option<String>,
    /// What else is on the bus, as lines for a person.
    pub notes: Vec<String>,
    /// Image of the firmware, for the second run that judges a scenario; without it scenarios play unjudged.
    pub elf: Option<PathBuf>,
}

/// A page that is being served; dropped, it ends together with its bench.
pub struct Server {
    address: SocketAddr,
    end: Option<oneshot::Sender<()>>,
    thread: Option<JoinHandle<Result<()>>>,
    bench: Option<JoinHandle<()>>,
}

impl Server {
    /// Builds the bench and serves its page; `make` builds a bench around a vehicle, or around the recording if there
    /// is none, and is called again when a page asks for another one.
    ///
    /// # Errors
    /// If the address cannot be bound (another program uses the port) or the bench cannot be built.
    pub fn start(
        start: Start,
        make: impl FnMut(Option<Kind>) -> Result<Rig> + Send + 'static,
    ) -> Result<Self> {
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, start.port));
        let listener = std::net::TcpListener::bind(address)
            .with_context(|| format!("cannot serve on {address}; is another bench running? try --port"))?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;

        let (latest, to_newcomers) = watch::channel(Latest::default());
        let (updates, _) = broadcast::channel(UPDATES_KEPT);
        let (commands, given) = mpsc::channel();
        let (ready, is_ready) = mpsc::channel();
        let judge = start.elf.map(JudgeThread::of_firmware).transpose()?;
        let clock = Instant::now();
        let tell_pages = updates.clone();
        let beginning = Beginning {
            make: Box::new(make),
            vehicle: start.vehicle,
            recording: start.recording,
            notes: start.notes,
            library: library(),
            judge: judge.map(|judge| Box::new(judge) as Box<dyn Judge>),
            clock: Box::new(move || clock.elapsed()),
            tell: Box::new(move |update| tell(update, &latest, &tell_pages)),
        };
        let bench = std::thread::Builder::new().name("bench".into()).spawn(move || {
            match Session::new(beginning) {
                Ok(mut session) => {
                    let _ = ready.send(Ok(()));
                    run(&mut session, &given);
                }
                Err(error) => {
                    let _ = ready.send(Err(error));
                }
            }
        })?;
        is_ready.recv().context("the bench ended while it was built")??;

        let screens = screens::Screens::new(bench_page::png);
        let shared = serve::Shared { commands, latest: to_newcomers, updates, screens };
        let routes = serve::routes(shared, address.port());
        let (end, ended) = oneshot::channel();
        let thread = std::thread::Builder::new().name("page".into()).spawn(move || -> Result<()> {
            let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
            runtime.block_on(async {
                let listener = tokio::net::TcpListener::from_std(listener)?;
                tokio::select! {
                    served = async { axum::serve(listener, routes).await } => served.map_err(Into::into),
                    _ = ended => Ok(()),
                }
            })
        })?;
        Ok(Self { address, end: Some(end), thread: Some(thread), bench: Some(bench) })
    }

    /// Where the page is.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Waits until the server ends, which it does with the process or with an error.
    ///
    /// # Errors
    /// What ended it.
    pub fn wait(mut self) -> Result<()> {
        let thread = self.thread.take().ok_or_else(|| anyhow!("the page's server has ended"))?;
        thread.join().map_err(|_| anyhow!("the page's server panicked"))?
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // With the runtime go the sockets, with them the last who could ask the bench for anything, and so its thread.
        if let (Some(end), Some(thread)) = (self.end.take(), self.thread.take()) {
            let _ = end.send(());
            let _ = thread.join();
        }
        if let Some(bench) = self.bench.take() {
            let _ = bench.join();
        }
    }
}

/// Runs until nobody can ask any more.
fn run(session: &mut Session, commands: &Receiver<Command>) {
    loop {
        for _ in 0..COMMANDS_PER_SLICE {
            match commands.try_recv() {
                Ok(command) => session.take(command),
                Err(TryRecvError::Empty) => break,
                Err(TryRecvError::Disconnected) => return,
            }
        }
        let nap = session.turn();
        if nap.is_zero() {
            continue;
        }
        match commands.recv_timeout(nap) {
            Ok(command) => session.take(command),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return,
        }
    }
}

/// Keeps what a page must know that comes later, and tells those that are there.
fn tell(update: Update, latest: &watch::Sender<Latest>, pages: &broadcast::Sender<Told>) {
    let told = match update {
        Update::Catalog(text) => {
            latest.send_modify(|latest| latest.catalog = text.clone());
            Told::Text(text)
        }
        Update::Text(text) => Told::Text(text),
        Update::Picture(shown) => {
            let Ok(png) = bench_page::png(&shown, 1) else { return };
            let png = axum::body::Bytes::from(png);
            latest.send_modify(|latest| (latest.picture, latest.shown) = (png.clone(), Some(shown)));
            Told::Picture(png)
        }
        Update::Recorded(recording) => {
            latest.send_modify(|latest| latest.recorded = recording);
            return;
        }
    };
    // Without a page nobody listens.
    let _ = pages.send(told);
}

/// The scenarios of the source tree.
fn library() -> Library {
    Library::new(|kind| {
        let files = scenario::files(kind).unwrap_or_default();
        let named = files.iter().filter_map(|path| {
            let name = format!("{}/{}", kind.name(), path.file_name()?.to_str()?);
            Some((name, std::fs::read_to_string(path).ok()?))
        });
        named.collect()
    })
}
