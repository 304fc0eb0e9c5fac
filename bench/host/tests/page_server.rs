//! The server of the page, asked as a browser, a tool or a foreign site would: what it answers, tells and refuses.

#[path = "../../tests/firmware/mod.rs"]
mod firmware;

use bench::rig::{Rig, RigOptions};
use bench::scenario::{Name, load};
use bench_host::{Server, Start};
use protocol_core::generated::VEHICLES;
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::{Mutex, MutexGuard, PoisonError, mpsc};
use std::time::{Duration, Instant};
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket};
use virtual_vehicle::{Kind, Options, VirtualVehicle};

/// Two cores do not carry several engines at once.
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
/// Longest wait for an answer: machines that build at the same time are slow.
const PATIENCE: Duration = Duration::from_secs(120);

fn alone() -> MutexGuard<'static, ()> {
    ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner)
}

fn bench_with(vehicle: Option<Kind>) -> anyhow::Result<Rig> {
    let kind = vehicle.unwrap();
    let bitrate = VEHICLES.iter().find(|vehicle| vehicle.name == kind.name()).unwrap().bitrate;
    let mut rig = Rig::new(&firmware::elf(), &RigOptions { bitrate, ..RigOptions::default() })?;
    rig.drive(VirtualVehicle::new(kind, Options::default()));
    Ok(rig)
}

fn serve(kind: Kind) -> Server {
    let start = Start { vehicle: Some(kind), elf: Some(firmware::elf()), ..Start::default() };
    Server::start(start, bench_with).unwrap()
}

/// A page without a browser: its end of the socket.
struct Page(WebSocket<TcpStream>);

impl Page {
    fn open(address: SocketAddr) -> Self {
        let mut request = format!("ws://{address}/live").into_client_request().unwrap();
        request.headers_mut().insert("Origin", format!("http://{address}").parse().unwrap());
        let stream = TcpStream::connect(address).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        Self(tungstenite::client(request, stream).unwrap().0)
    }

    fn send(&mut self, command: Value) {
        self.0.send(Message::text(command.to_string())).unwrap();
    }

    /// Reads what the bench tells until `wanted` finds what it looks for.
    fn wait_for<T>(&mut self, what: &str, mut wanted: impl FnMut(&Value) -> Option<T>) -> T {
        let started = Instant::now();
        while started.elapsed() < PATIENCE {
            let Message::Text(text) = self.0.read().unwrap() else { continue };
            if let Some(found) = wanted(&serde_json::from_str(&text).unwrap()) {
                return found;
            }
        }
        panic!("waited in vain for {what}");
    }

    /// Plays a scenario to its end, as fast as the machine can, and returns its story once it is judged and over.
    fn play(&mut self, name: &str) -> Value {
        self.send(json!({ "do": "speed", "factor": 0.0 }));
        self.send(json!({ "do": "play", "name": name }));
        self.wait_for(&format!("the end of {name}"), |told| {
            let story = &told["playing"];
            assert!(story["problem"].is_null(), "{}", story["problem"]);
            let checks = story["checks"].as_array().filter(|_| story["name"] == name)?;
            checks.iter().all(|check| !check["found"].is_null()).then(|| story.clone())
        })
    }
}

/// Sends a request with these headers and returns the status line, the headers and the body.
fn ask(address: SocketAddr, path: &str, headers: &str) -> (u16, String, Vec<u8>) {
    let mut stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(PATIENCE)).unwrap();
    write!(stream, "GET {path} HTTP/1.1\r\n{headers}Connection: close\r\n\r\n").unwrap();
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).unwrap();
    let end = answer.windows(4).position(|four| four == b"\r\n\r\n").unwrap();
    let body = answer.split_off(end + 4);
    let head = String::from_utf8(answer).unwrap().to_lowercase();
    (head[9..12].parse().unwrap(), head, body)
}

#[test]
fn every_scenario_that_compares_a_picture_passes_on_the_page() {
    let _alone = alone();
    let mut played = 0;
    for kind in Kind::ALL {
        let scenarios = load(kind).unwrap();
        let with_picture = scenarios
            .iter()
            .filter(|scenario| scenario.demands.iter().any(|demand| demand.name == Name::Picture));
        for scenario in with_picture {
            let server = serve(kind);
            let story = Page::open(server.address()).play(scenario.name());
            let checks = story["checks"].as_array().unwrap();
            let failed: Vec<_> = checks.iter().filter(|check| check["found"]["passed"] != true).collect();
            assert!(failed.is_empty(), "{}: {failed:#?}", scenario.file);
            assert!(checks.iter().any(|check| check["expected"].as_str().unwrap().starts_with("picture")));
            played += 1;
        }
    }
    assert!(played >= 2, "{played} scenarios have a picture");
}

#[test]
fn a_verdict_is_not_told_before_the_story_has_come_there() {
    let _alone = alone();
    let server = serve(Kind::Citybus);
    let mut page = Page::open(server.address());
    page.send(json!({ "do": "play", "name": "fire" }));
    page.send(json!({ "do": "pause", "on": true }));
    page.wait_for("the judge", |told| {
        let checks = told["playing"]["checks"].as_array()?;
        assert!(told["seconds"].as_f64().unwrap() < 2.0, "the story stands still");
        assert!(checks.iter().all(|check| check["found"].is_null()), "nothing is found yet");
        assert!(checks.len() > 3);
        Some(())
    });
    page.send(json!({ "do": "speed", "factor": 0.0 }));
    page.send(json!({ "do": "pause", "on": false }));
    page.wait_for("the end of the story", |told| {
        let checks = told["playing"]["checks"].as_array()?;
        for check in checks {
            let is_past = check["at"].as_f64().unwrap() <= told["seconds"].as_f64().unwrap();
            assert_eq!(!check["found"].is_null(), is_past, "at {}: {check}", told["seconds"]);
        }
        checks.iter().all(|check| !check["found"].is_null()).then_some(())
    });
}

/// Threads of this process that judge scenarios.
#[cfg(target_os = "linux")]
fn judges() -> usize {
    let tasks = std::fs::read_dir("/proc/self/task").unwrap();
    let names = tasks.filter_map(|task| std::fs::read_to_string(task.unwrap().path().join("comm")).ok());
    names.filter(|name| name.trim() == "judge").count()
}

#[test]
#[cfg(target_os = "linux")]
fn forty_plays_leave_one_judge_and_the_last_is_judged() {
    let _alone = alone();
    let server = serve(Kind::Citybus);
    let mut page = Page::open(server.address());
    for _ in 0..40 {
        page.send(json!({ "do": "play", "name": "heartbeat" }));
    }
    page.send(json!({ "do": "play", "name": "fire" }));
    page.wait_for("the last of them", |told| {
        assert_ne!(told["kind"], "notice", "{told}");
        (told["playing"]["name"] == "fire").then_some(())
    });
    assert_eq!(judges(), 1);
    page.wait_for("its verdict", |told| {
        assert_eq!(told["playing"]["problem"], Value::Null);
        told["playing"]["checks"].is_array().then_some(())
    });
    assert_eq!(judges(), 1);
}

#[test]
fn without_a_recording_no_bench_starts_without_a_vehicle() {
    let _alone = alone();
    let server = serve(Kind::Citybus);
    let mut page = Page::open(server.address());
    page.send(json!({ "do": "start", "vehicle": null }));
    let notice = page.wait_for("a notice", |told| {
        assert!(told["kind"] != "catalog" || told["vehicle"] == "citybus", "a bench around nothing");
        (told["kind"] == "notice").then(|| told["text"].as_str().unwrap().to_owned())
    });
    assert!(notice.contains("--log FILE"), "{notice}");
}

#[test]
fn screens_are_made_while_the_bench_itself_is_busy() {
    let _alone = alone();
    let (go_on, wait) = mpsc::channel::<()>();
    let (begun, has_begun) = mpsc::channel();
    let mut benches = 0;
    let start = Start { vehicle: Some(Kind::Citybus), ..Start::default() };
    let server = Server::start(start, move |vehicle| {
        benches += 1;
        if benches == 2 {
            // The bench's thread can do nothing else from here on.
            begun.send(()).unwrap();
            let _ = wait.recv_timeout(PATIENCE);
        }
        bench_with(vehicle)
    })
    .unwrap();
    let mut page = Page::open(server.address());
    page.send(json!({ "do": "start", "vehicle": "citybus" }));
    has_begun.recv_timeout(PATIENCE).unwrap();
    let host = server.address();
    for scale in [1, 2, 8] {
        let own = format!("Host: {host}\r\nReferer: http://{host}/\r\n");
        let (status, _, body) = ask(host, &format!("/screen/{scale}"), &own);
        assert_eq!(status, 200);
        let reader = png::Decoder::new(std::io::Cursor::new(body)).read_info().unwrap();
        assert_eq!((reader.info().width, reader.info().height), (320 * scale, 240 * scale));
    }
    go_on.send(()).unwrap();
    page.wait_for("the other bench", |told| (told["bench"] == 2).then_some(()));
}

#[test]
fn every_answer_says_that_nobody_else_may_frame_embed_or_guess_it() {
    let _alone = alone();
    let server = serve(Kind::Citybus);
    let host = server.address();
    let own = format!("Host: {host}\r\nOrigin: http://{host}\r\n");
    let foreign = format!("Host: {host}\r\nOrigin: http://example.org\r\n");
    for (path, headers, wanted) in [
        ("/", &own, 200),
        ("/screen/1", &own, 200),
        ("/decode/0CF101D0/00", &own, 0),
        ("/recording.log", &own, 404),
        ("/nothing", &own, 404),
        ("/", &foreign, 403),
    ] {
        let (status, head, _) = ask(host, path, headers);
        assert!(wanted == 0 || status == wanted, "{path}: {head}");
        for line in [
            "frame-ancestors 'none'",
            "\r\nx-frame-options: deny\r\n",
            "\r\nx-content-type-options: nosniff\r\n",
            "\r\nreferrer-policy: same-origin\r\n",
            "\r\ncross-origin-resource-policy: same-origin\r\n",
        ] {
            assert!(head.contains(line), "{path} lacks {line}: {head}");
        }
    }
}

#[test]
fn a_request_that_does_not_prove_where_it_comes_from_gets_the_page_only() {
    let _alone = alone();
    let server = serve(Kind::Citybus);
    let host = server.address();
    let status = |path: &str, headers: &str| ask(host, path, headers).0;
    let named = format!("Host: {host}\r\n");
    assert_eq!(status("/", &named), 200);
    assert_eq!(status("/screen/8", &named), 403);
    assert_eq!(status("/screen/8", &format!("{named}Sec-Fetch-Site: cross-site\r\n")), 403);
    assert_eq!(status("/screen/8", &format!("{named}Sec-Fetch-Site: same-site\r\n")), 403);
    assert_eq!(status("/screen/1", &format!("{named}Sec-Fetch-Site: same-origin\r\n")), 200);
    assert_eq!(status("/", &format!("Host: 127.0.0.1:x.example.org\r\nOrigin: http://{host}\r\n")), 403);
    let (_, _, body) = ask(host, "/screen/8", &named);
    let how = String::from_utf8(body).unwrap();
    assert!(how.contains(&format!("Referer: http://{host}/")), "says what to do: {how}");
    let stream = TcpStream::connect(host).unwrap();
    assert!(tungstenite::client(format!("ws://{host}/live"), stream).is_err(), "a socket without an origin");
}
