//! The page of a running bench: the panel, the vehicle around it, the bus, in a browser.
//!
//! [`Server`] puts one bench on a thread of its own ([`session`]) and serves one self-contained page to any number of
//! browsers of this machine ([`serve`]; [`gate`] says whom). [`catalog`] is what there is to change and to read, [`live`]
//! what is told while it runs, [`pace`] how virtual time follows the wall clock, [`trace`] the bus, [`recording`] what is
//! kept, [`screens`] pictures of the panel, [`scenes`] stories that play. The page itself is three files without a build
//! step: `page.html`, `page.css`, `page.js`.

mod beside;
mod catalog;
mod gate;
mod live;
mod pace;
mod recording;
mod scenes;
mod screens;
mod serve;
mod session;
mod trace;
mod wires;

use crate::rig::Rig;
use anyhow::{Context, Result, anyhow};
use session::{Beginning, Latest, Session};
use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::sync::mpsc;
use std::thread::JoinHandle;
use tokio::sync::{broadcast, oneshot, watch};
use virtual_vehicle::Kind;

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
        let beginning = Beginning {
            make: Box::new(make),
            vehicle: start.vehicle,
            recording: start.recording,
            notes: start.notes,
            elf: start.elf,
            latest,
            updates: updates.clone(),
        };
        let bench = std::thread::Builder::new().name("bench".into()).spawn(move || {
            match Session::new(beginning) {
                Ok(session) => {
                    let _ = ready.send(Ok(()));
                    session.run(&given);
                }
                Err(error) => {
                    let _ = ready.send(Err(error));
                }
            }
        })?;
        is_ready.recv().context("the bench ended while it was built")??;

        let screens = screens::Screens::new(recording::png);
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
