//! A headless Chromium, driven over its own debugging protocol.
//!
//! Owns the process, a throw-away profile and one page in it; collects what a person would find wrong in the console
//! and every request that leaves this machine. Source: Chrome DevTools Protocol, domains Page, Runtime, Input, Log,
//! Network, Emulation.

#![allow(dead_code, reason = "each test file uses a part")]

use serde_json::{Value, json};
use std::collections::VecDeque;
use std::io::{BufRead, BufReader, ErrorKind};
use std::net::{SocketAddr, TcpStream};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;
use tungstenite::{Message, WebSocket};

/// Names that Chromium has on people's machines.
const NAMES: &[&str] = &["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
/// Longest wait for anything: machines that build at the same time are slow.
const PATIENCE: Duration = Duration::from_secs(90);
/// Time between two looks.
const LOOK_EVERY: Duration = Duration::from_millis(40);

/// Keeps Chromium away from the network and from the graphics that a server does not have.
const SWITCHES: &[&str] = &[
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-dev-shm-usage",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-extensions",
    "--force-color-profile=srgb",
    "--hide-scrollbars",
    "--remote-debugging-port=0",
];

/// Finds Chromium: `CHROME`, or one of its names on the path.
pub(crate) fn find() -> Option<PathBuf> {
    let named = std::env::var_os("CHROME").map(PathBuf::from);
    let path = std::env::var_os("PATH").unwrap_or_default();
    let mut on_path = std::env::split_paths(&path)
        .flat_map(|folder| NAMES.iter().map(move |name| folder.join(name)))
        .filter(|file| file.is_file());
    named.or_else(|| on_path.next())
}

/// One page in a browser of its own.
pub(crate) struct Browser {
    process: Child,
    socket: WebSocket<TcpStream>,
    session: Option<String>,
    last_id: u64,
    events: VecDeque<Value>,
    _profile: TempDir,
}

impl Browser {
    /// Opens `url` in a window of this size, in English.
    pub(crate) fn open(chromium: &PathBuf, url: &str, width: u32, height: u32) -> Self {
        let profile = tempfile::tempdir().unwrap();
        let mut process = Command::new(chromium)
            .args(SWITCHES)
            .arg(format!("--user-data-dir={}", profile.path().display()))
            .arg("--lang=en-US")
            .arg("about:blank")
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let lines = BufReader::new(process.stderr.take().unwrap()).lines();
        let address = lines
            .map_while(Result::ok)
            .find_map(|line| line.strip_prefix("DevTools listening on ").map(str::to_owned))
            .expect("Chromium says where its debugging port is");
        let host: SocketAddr =
            address.trim_start_matches("ws://").split('/').next().unwrap().parse().unwrap();
        let stream = TcpStream::connect(host).unwrap();
        let (socket, _) = tungstenite::client(&*address, stream).unwrap();
        let mut browser =
            Self { process, socket, session: None, last_id: 0, events: VecDeque::new(), _profile: profile };
        let target = browser.call("Target.createTarget", json!({ "url": "about:blank" }));
        let attach = json!({ "targetId": target["targetId"], "flatten": true });
        let session = browser.call("Target.attachToTarget", attach);
        browser.session = Some(session["sessionId"].as_str().unwrap().to_owned());
        for domain in ["Page", "Runtime", "Log", "Network"] {
            browser.call(&format!("{domain}.enable"), json!({}));
        }
        browser.resize(width, height);
        browser.call("Page.navigate", json!({ "url": url }));
        browser
    }

    /// Gives the window another size.
    pub(crate) fn resize(&mut self, width: u32, height: u32) {
        let phone = width < 500;
        self.call(
            "Emulation.setDeviceMetricsOverride",
            json!({ "width": width, "height": height, "deviceScaleFactor": if phone { 2 } else { 1 }, "mobile": phone }),
        );
    }

    /// Calls a method of the protocol and waits for its result.
    pub(crate) fn call(&mut self, method: &str, parameters: Value) -> Value {
        self.last_id += 1;
        let id = self.last_id;
        let mut call = json!({ "id": id, "method": method, "params": parameters });
        if let Some(session) = &self.session {
            call["sessionId"] = json!(session);
        }
        self.socket.send(Message::text(call.to_string())).unwrap();
        loop {
            let message = self.read();
            if message["id"] == id {
                assert!(message["error"].is_null(), "{method}: {}", message["error"]);
                return message["result"].clone();
            }
            self.events.push_back(message);
        }
    }

    fn read(&mut self) -> Value {
        loop {
            match self.socket.read() {
                Ok(Message::Text(text)) => return serde_json::from_str(&text).unwrap(),
                Ok(_) => {}
                Err(tungstenite::Error::Io(error)) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => panic!("Chromium has gone: {error}"),
            }
        }
    }

    /// Evaluates an expression in the page; a promise is waited for.
    pub(crate) fn eval(&mut self, expression: &str) -> Value {
        let call = json!({ "expression": expression, "returnByValue": true, "awaitPromise": true });
        let result = self.call("Runtime.evaluate", call);
        assert!(result["exceptionDetails"].is_null(), "{expression}: {}", result["exceptionDetails"]);
        result["result"]["value"].clone()
    }

    /// Evaluates an expression to a number.
    pub(crate) fn number(&mut self, expression: &str) -> f64 {
        let value = self.eval(expression);
        value.as_f64().unwrap_or_else(|| panic!("`{expression}` is {value}, not a number"))
    }

    /// Evaluates an expression to a text.
    pub(crate) fn text(&mut self, expression: &str) -> String {
        let value = self.eval(expression);
        value.as_str().unwrap_or_else(|| panic!("`{expression}` is {value}, not a text")).to_owned()
    }

    /// Waits until a condition holds in the page.
    pub(crate) fn wait_for(&mut self, condition: &str) {
        let started = Instant::now();
        while self.eval(&format!("Boolean({condition})")) != true {
            if started.elapsed() > PATIENCE {
                let page = self.text("document.body.innerText.slice(0, 1500)");
                panic!("waited in vain for `{condition}`; the page says:\n{page}");
            }
            std::thread::sleep(LOOK_EVERY);
        }
    }

    /// Clicks the middle of an element with the mouse.
    pub(crate) fn click(&mut self, selector: &str) {
        self.mouse(selector, "mousePressed");
        self.mouse(selector, "mouseReleased");
    }

    /// Presses (`mousePressed`) or lets go of the mouse over the middle of an element.
    pub(crate) fn mouse(&mut self, selector: &str, what: &str) {
        let selector = Value::from(selector);
        let place = self.eval(&format!(
            "(() => {{ const e = document.querySelector({selector}); e.scrollIntoView({{ block: 'center' }}); \
             const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; }})()"
        ));
        let event = json!({ "type": what, "x": place[0], "y": place[1], "button": "left", "clickCount": 1 });
        self.call("Input.dispatchMouseEvent", event);
    }

    /// Presses a key and lets go of it.
    pub(crate) fn key(&mut self, key: &str) {
        self.key_down(key);
        self.key_up(key);
    }

    /// Presses a key: `a`, ` `, `Tab`, `ArrowUp`.
    pub(crate) fn key_down(&mut self, key: &str) {
        self.dispatch_key("keyDown", key);
    }

    /// Lets go of a key.
    pub(crate) fn key_up(&mut self, key: &str) {
        self.dispatch_key("keyUp", key);
    }

    fn dispatch_key(&mut self, what: &str, key: &str) {
        let code = match key {
            "Tab" => 9,
            "Enter" => 13,
            "Escape" => 27,
            " " => 32,
            "ArrowLeft" => 37,
            "ArrowUp" => 38,
            "ArrowRight" => 39,
            "ArrowDown" => 40,
            _ => i32::from(key.to_ascii_uppercase().as_bytes()[0]),
        };
        let mut event = json!({ "type": what, "key": key, "windowsVirtualKeyCode": code });
        let text = if key == "Enter" { Some("\r") } else { (key.len() == 1).then_some(key) };
        if let (Some(text), "keyDown") = (text, what) {
            event["text"] = json!(text);
        }
        self.call("Input.dispatchKeyEvent", event);
    }

    /// What the window shows, as PNG in Base64.
    pub(crate) fn screenshot(&mut self) -> String {
        let shot = self.call("Page.captureScreenshot", json!({ "format": "png" }));
        shot["data"].as_str().unwrap().to_owned()
    }

    /// Every answer to a request whose address contains `host`, with its status.
    pub(crate) fn statuses(&mut self, host: &str) -> Vec<(String, u64)> {
        // A call brings in every event that was sent before its answer.
        self.eval("1");
        let given = |method: &str| {
            let events = self.events.iter().filter(move |event| event["method"] == method);
            events.map(|event| &event["params"]).collect::<Vec<_>>()
        };
        let mut asked = given("Network.requestWillBeSent");
        asked.extend(given("Network.webSocketCreated"));
        let mut answered = given("Network.responseReceivedExtraInfo");
        answered.extend(given("Network.webSocketHandshakeResponseReceived"));
        let status = |id: &Value| {
            let answer = answered.iter().find(|answer| answer["requestId"] == *id)?;
            answer["statusCode"].as_u64().or_else(|| answer["response"]["status"].as_u64())
        };
        let url = |asked: &Value| {
            asked["request"]["url"].as_str().or_else(|| asked["url"].as_str()).map(str::to_owned)
        };
        let found = asked.iter().filter_map(|asked| Some((url(asked)?, status(&asked["requestId"])?)));
        found.filter(|(url, _)| url.contains(host)).collect()
    }

    /// What went wrong so far: errors in the console, exceptions, requests to other machines.
    pub(crate) fn problems(&mut self, origin: &str) -> Vec<String> {
        // A call brings in every event that was sent before its answer.
        self.eval("1");
        let websocket = origin.replace("http://", "ws://");
        self.events
            .drain(..)
            .filter_map(|event| {
                let given = &event["params"];
                match event["method"].as_str()? {
                    "Runtime.exceptionThrown" => Some(format!("exception: {given}")),
                    "Runtime.consoleAPICalled" if given["type"] == "error" => {
                        Some(format!("console: {given}"))
                    }
                    "Log.entryAdded" if given["entry"]["level"] == "error" => Some(format!("log: {given}")),
                    "Network.requestWillBeSent" => {
                        let url = given["request"]["url"].as_str()?;
                        let own = [origin, "data:", "blob:", "about:"];
                        (!own.iter().any(|start| url.starts_with(start))).then(|| format!("asked for {url}"))
                    }
                    "Network.webSocketCreated" => {
                        let url = given["url"].as_str()?;
                        (!url.starts_with(&websocket)).then(|| format!("connected to {url}"))
                    }
                    _ => None,
                }
            })
            .collect()
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
