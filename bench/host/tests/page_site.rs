//! The bench without a server, in a real browser: the one file from a disk, the site below a path of any host.
//!
//! The session runs in a Worker of the browser. Nothing may be asked of any machine but the parts of the page.

mod browser;

use browser::Browser;
use serde_json::Value;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpListener};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use surroundings::{need, root};

/// Two cores do not carry several engines and browsers at once.
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

/// A page with a person in front of it.
struct Visit {
    browser: Browser,
    own: String,
    _turn: MutexGuard<'static, ()>,
}

/// A part of what `cargo xtask site` builds.
fn built(name: &str) -> PathBuf {
    let path = root().join("target/out").join(name);
    assert!(path.exists(), "{name} is not built: run `cargo xtask test`, which builds it first");
    path
}

/// Opens a page; `None` where there is no Chromium, which is an error in CI.
fn open(url: &str, width: u32, height: u32) -> Option<Visit> {
    let turn = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    let Some(chromium) = browser::find() else {
        need::CHROMIUM.skip(std::thread::current().name().unwrap_or("the page"));
        return None;
    };
    let mut browser = Browser::open(&chromium, url, width, height);
    wait_drawn(&mut browser);
    let own = url.split('#').next().unwrap_or(url).trim_end_matches("index.html").to_owned();
    Some(Visit { browser, own, _turn: turn })
}

fn wait_drawn(browser: &mut Browser) {
    browser.wait_for("document.body?.dataset.pictures > 3 && 'ready' in document.body.dataset");
}

fn open_single(hash: &str, width: u32, height: u32) -> Option<Visit> {
    open(&format!("file://{}{hash}", built("bench.html").display()), width, height)
}

impl Visit {
    fn wait_speed(&mut self, condition: &str) {
        let speed = "state.truths[catalog.truths.findIndex(t => t.path === 'vehicle.speed')]";
        self.browser.wait_for(&format!("{speed} {condition}"));
    }

    /// Drops a file on the page and returns what its dialog says it is.
    fn drop_file(&mut self, name: &str, bytes: &[u8]) -> String {
        self.browser.eval("$('dropped').close(); delete $('dropped').dataset.is");
        let bytes: Vec<Value> = bytes.iter().map(|byte| Value::from(*byte)).collect();
        self.browser.eval(&format!(
            "(() => {{ const data = new DataTransfer(); \
             data.items.add(new File([new Uint8Array({})], {})); \
             dispatchEvent(new DragEvent('drop', {{ dataTransfer: data, cancelable: true }})); }})()",
            Value::from(bytes),
            Value::from(name),
        ));
        self.browser.wait_for("$('dropped').open && $('dropped').dataset.is");
        self.browser.text("$('dropped').dataset.is + ': ' + $('dropped-body').innerText")
    }

    /// Leaves; nothing may have gone wrong, nothing may have been asked of another machine.
    fn leave(mut self) {
        let problems = self.browser.problems(&self.own);
        assert!(problems.is_empty(), "{}", problems.join("\n"));
    }
}

#[test]
fn the_one_file_drives_from_a_disk_and_asks_nobody() {
    for (width, height) in [(1440, 900), (1024, 768), (390, 844)] {
        let Some(mut visit) = open_single("", width, height) else { return };
        visit.browser.wait_for("document.querySelector('[data-telltale=ready]')");
        visit.browser.eval("document.querySelector('[data-preset=drive]').click()");
        visit.wait_speed("> 20");
        let wide = visit.browser.number("document.documentElement.scrollWidth");
        assert!(wide <= f64::from(width), "{wide} pixels wide in a window of {width}");
        visit.leave();
    }
}

#[test]
fn keys_alone_drive_it_in_both_languages() {
    let Some(mut visit) = open_single("", 1440, 900) else { return };
    for (language, title) in [("zh", "虚拟台架"), ("en", "Virtual bench")] {
        if visit.browser.text("language") != language {
            visit.browser.key("l");
        }
        visit.browser.wait_for(&format!("document.querySelector('h1').innerText === '{title}'"));
    }
    visit.browser.key("1");
    visit.wait_speed("> 20");
    visit.browser.key("a");
    visit.browser.key(" ");
    visit.browser.wait_for("state.paused");
    visit.leave();
}

#[test]
fn a_link_plays_a_scenario_that_a_second_worker_judges() {
    let Some(mut visit) = open_single("#play=jiulong/gears", 1440, 900) else { return };
    visit.browser.wait_for("catalog.vehicle === 'jiulong' && state?.playing?.name === 'gears'");
    visit.browser.eval("send({ do: 'speed', factor: 0 })");
    visit
        .browser
        .wait_for("state?.playing?.checks?.length && state.playing.checks.every(check => check.found)");
    assert_eq!(visit.browser.number("state.playing.checks.filter(check => !check.found.passed).length"), 0.0);
    visit.leave();
}

#[test]
fn a_scenario_with_golden_pictures_is_judged_without_a_folder() {
    let Some(mut visit) = open_single("#play=citybus/fire", 1440, 900) else { return };
    visit.browser.wait_for("state?.playing?.name === 'fire'");
    visit.browser.eval("send({ do: 'speed', factor: 0 })");
    visit
        .browser
        .wait_for("state?.playing?.checks?.length && state.playing.checks.every(check => check.found)");
    let failed = visit.browser.text(
        "state.playing.checks.filter(check => !check.found.passed).map(check => check.expected + ': ' + check.found.got).join('; ')",
    );
    assert_eq!(failed, "");
    visit.leave();
}

#[test]
fn a_dropped_file_is_read_played_or_refused_with_its_line() {
    let Some(mut visit) = open_single("", 1440, 900) else { return };
    let dbc = std::fs::read(root().join("vehicles/citybus/citybus.dbc")).unwrap();
    let told = visit.drop_file("citybus.dbc", &dbc);
    assert!(told.starts_with("dbc: ") && told.contains("Nothing is wrong with it."), "{told}");

    let broken = "VERSION \"\"\n\nBU_: A\n\nBO_ 256 M: 8 A\n SG_ one : 0|8@1+ (1,0) [0|255] \"\" A\n SG_ two : 4|8@1+ (1,0) [0|255] \"\" A\n";
    let told = visit.drop_file("broken.dbc", broken.as_bytes());
    assert!(told.contains("7") && told.contains("overlaps"), "{told}");

    let log = std::fs::read(root().join("vehicles/citybus/captures/city.log")).unwrap();
    visit.drop_file("citybus.dbc", &dbc);
    let told = visit.drop_file("mine.log", &log);
    assert!(told.starts_with("recording: ") && told.contains("vehicle_speed"), "{told}");
    visit.browser.wait_for("catalog.recording === 'mine.log' && catalog.vehicle === null");
    visit.browser.wait_for("state?.counts[0] > 100");

    let told = visit.drop_file("noise.bin", &[0, 1, 2, 3, 0xFF]);
    assert!(told.starts_with("other: "), "{told}");
    let told = visit.drop_file("program.elf", b"\x7fELF\x02\x01\x01 not for the chip");
    assert!(told.starts_with("other: "), "{told}");
    let elf = std::fs::read(built("cluster-st7789.elf")).unwrap();
    // Its panel is another one: the bench must start it all the same.
    let told = visit.drop_file("cluster-st7789.elf", &elf);
    assert!(told.starts_with("image: "), "{told}");
    visit.leave();
}

#[test]
fn what_the_page_keeps_comes_out_of_the_worker() {
    let Some(mut visit) = open_single("", 1440, 900) else { return };
    let head =
        "async path => [...new Uint8Array(await (await link.ask(path)).arrayBuffer()).slice(0, 6)].join()";
    assert_eq!(visit.browser.text(&format!("({head})('screen/2')")), "137,80,78,71,13,10");
    visit.browser.eval("send({ do: 'record', on: true })");
    visit.browser.wait_for("state.recording?.frames > 50");
    visit.browser.eval("send({ do: 'record', on: false })");
    visit.browser.wait_for("state.recorded");
    assert_eq!(visit.browser.text(&format!("({head})('recording.gif')")), "71,73,70,56,57,97");
    let log = visit.browser.text("(async () => (await link.ask('recording.log')).text())()");
    assert!(log.lines().count() > 50 && log.contains("can0"), "{}", &log[..200]);
    let signals = visit.browser.text(
        "(async () => (await link.ask('decode/18FF21F0/0000000000000000')).text())().catch(e => e.message)",
    );
    assert!(!signals.is_empty());
    let why = visit.browser.text("link.ask('nothing').catch(error => error.message)");
    assert!(why.contains("nothing"), "{why}");
    visit.leave();
}

#[test]
fn a_worker_that_has_ended_says_so_and_starts_again() {
    let Some(mut visit) = open_single("", 1440, 900) else { return };
    // What a panic of the module comes to: its words, then silence.
    visit.browser.eval("link.fail('a reason')");
    visit.browser.wait_for("!$('stopped').hidden && $('stopped').innerText.includes('a reason')");
    visit.browser.eval("document.body.dataset.pictures = pictures = 0");
    visit.browser.click("#restart");
    wait_drawn(&mut visit.browser);
    visit.leave();
}

/// A web server that knows one folder, below a path; dropped, it has gone.
struct Host {
    address: SocketAddr,
    ends: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Host {
    fn start(folder: PathBuf) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let (address, ends) = (listener.local_addr().unwrap(), Arc::new(AtomicBool::new(false)));
        let ended = Arc::clone(&ends);
        let thread = std::thread::spawn(move || {
            for stream in listener.incoming() {
                if ended.load(Ordering::Relaxed) {
                    return;
                }
                let Ok(mut stream) = stream else { continue };
                let mut request = [0; 4096];
                let Ok(read) = stream.read(&mut request) else { continue };
                let line = String::from_utf8_lossy(&request[..read]);
                let path = line.split(' ').nth(1).unwrap_or_default();
                let name = path
                    .strip_prefix("/somewhere/below/")
                    .map(|name| if name.is_empty() { "index.html" } else { name });
                let file = name.filter(|name| !name.contains('/')).and_then(|name| {
                    let kind = match name.rsplit('.').next() {
                        Some("html") => "text/html",
                        Some("js") => "text/javascript",
                        _ => "application/octet-stream",
                    };
                    Some((kind, std::fs::read(folder.join(name)).ok()?))
                });
                let _ = match file {
                    Some((kind, bytes)) => {
                        let head = format!(
                            "HTTP/1.1 200 OK\r\nContent-Type: {kind}\r\nContent-Length: {}\r\nConnection: close\r\n\r\n",
                            bytes.len()
                        );
                        stream.write_all(head.as_bytes()).and_then(|()| stream.write_all(&bytes))
                    }
                    None => stream.write_all(
                        b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\nConnection: close\r\n\r\n",
                    ),
                };
            }
        });
        Self { address, ends, thread: Some(thread) }
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        self.ends.store(true, Ordering::Relaxed);
        // Wakes it.
        let _ = std::net::TcpStream::connect(self.address);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

#[test]
fn the_site_drives_below_any_path_and_once_seen_without_its_host() {
    let host = Host::start(built("site/index.html").parent().unwrap().to_owned());
    let url = format!("http://{}/somewhere/below/", host.address);
    let Some(mut visit) = open(&url, 1440, 900) else { return };
    visit.browser.wait_for("document.querySelector('[data-telltale=ready]')");
    visit.browser.eval("navigator.serviceWorker.ready.then(() => 1)");
    drop(host);
    visit.browser.eval("void (document.body.dataset.old = 1, location.reload())");
    visit.browser.wait_for("document.body && !document.body.dataset.old");
    wait_drawn(&mut visit.browser);
    visit.browser.click("[data-preset=drive]");
    visit.wait_speed("> 20");
    visit.leave();
}
