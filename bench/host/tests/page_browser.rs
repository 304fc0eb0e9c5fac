//! The page of `cargo xtask run` in a real browser, with the real firmware behind it.
//!
//! A headless Chromium presses, clicks and reads pixels as a person would. `BLESS=1` takes the picture of the page that
//! the README shows (docs/images/page.png).

mod browser;
#[path = "../../tests/firmware/mod.rs"]
mod firmware;

use bench::log::Log;
use bench::rig::{Rig, RigOptions};
use bench_host::{Server, Start};
use browser::Browser;
use protocol_core::generated::VEHICLES;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::{Mutex, MutexGuard, PoisonError};
use surroundings::{need, root};
use virtual_vehicle::{Kind, Options, VirtualVehicle};

/// Two cores do not carry several engines and browsers at once.
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

/// A page with a person in front of it.
struct Visit {
    browser: Browser,
    address: SocketAddr,
    _server: Server,
    _turn: MutexGuard<'static, ()>,
}

fn bench_with(vehicle: Option<Kind>) -> anyhow::Result<Rig> {
    let Some(kind) = vehicle else {
        let mut rig = Rig::new(&firmware::elf(), &RigOptions::default())?;
        rig.replay(&Log::read_file(&root().join("vehicles/citybus/captures/city.log"))?, true);
        return Ok(rig);
    };
    let bitrate = VEHICLES.iter().find(|vehicle| vehicle.name == kind.name()).unwrap().bitrate;
    let mut rig = Rig::new(&firmware::elf(), &RigOptions { bitrate, ..RigOptions::default() })?;
    rig.drive(VirtualVehicle::new(kind, Options::default()));
    Ok(rig)
}

/// Opens the page of a bench that has a recording; `None` where there is no Chromium, which is an error in CI.
fn visit(width: u32, height: u32) -> Option<Visit> {
    visit_bench(width, height, Some("city.log"))
}

fn visit_bench(width: u32, height: u32, recording: Option<&str>) -> Option<Visit> {
    let turn = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    let Some(chromium) = browser::find() else {
        need::CHROMIUM.skip(std::thread::current().name().unwrap_or("the page"));
        return None;
    };
    let start = Start {
        vehicle: Some(Kind::Citybus),
        recording: recording.map(str::to_owned),
        elf: Some(firmware::elf()),
        ..Start::default()
    };
    let server = Server::start(start, bench_with).unwrap();
    let address = server.address();
    let mut browser = Browser::open(&chromium, &format!("http://{address}/"), width, height);
    browser.wait_for("document.body?.dataset.pictures > 3 && 'ready' in document.body.dataset");
    Some(Visit { browser, address, _server: server, _turn: turn })
}

impl Visit {
    /// What the vehicle is and does, by the page's own table.
    fn truth(&mut self, path: &str) -> f64 {
        self.browser.number(&format!("state.truths[catalog.truths.findIndex(t => t.path === '{path}')]"))
    }

    fn wait_ready(&mut self) {
        self.browser.wait_for("document.querySelector('[data-telltale=ready]')");
    }

    fn wait_speed(&mut self, condition: &str) {
        let speed = "state.truths[catalog.truths.findIndex(t => t.path === 'vehicle.speed')]";
        self.browser.wait_for(&format!("{speed} {condition}"));
    }

    /// A number for all pixels of the panel.
    fn pixels(&mut self) -> f64 {
        self.browser.number(
            "(() => { const c = $('panel'); const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; \
             let h = 0; for (let i = 0; i < d.length; i += 64) h = (h * 31 + d[i] + 7 * d[i + 1] + 13 * d[i + 2]) >>> 0; return h; })()",
        )
    }

    /// How many pixels of the panel are not black.
    fn lit(&mut self) -> f64 {
        self.browser.number(
            "(() => { const c = $('panel'); const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; \
             let n = 0; for (let i = 0; i < d.length; i += 64) n += d[i] + d[i + 1] + d[i + 2] > 40; return n; })()",
        )
    }

    /// Fetches a file of the server without the browser.
    fn fetch(&self, path: &str) -> (u16, Vec<u8>) {
        let mut stream = TcpStream::connect(self.address).unwrap();
        let host = self.address;
        let headers = format!("Host: {host}\r\nReferer: http://{host}/\r\nConnection: close");
        write!(stream, "GET {path} HTTP/1.1\r\n{headers}\r\n\r\n").unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let head = answer.windows(4).position(|four| four == b"\r\n\r\n").unwrap();
        let status = String::from_utf8_lossy(&answer[9..12]).parse().unwrap();
        (status, answer.split_off(head + 4))
    }

    /// Leaves; nothing may have gone wrong, nothing may have been asked of another machine.
    fn leave(mut self) {
        let problems = self.browser.problems(&format!("http://{}", self.address));
        assert!(problems.is_empty(), "{}", problems.join("\n"));
    }
}

#[test]
fn one_click_drives_and_the_panel_shows_it() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    assert!(visit.lit() > 1_000.0, "the panel is lit");
    let before = visit.pixels();
    visit.browser.click("[data-preset=drive]");
    visit.wait_speed("> 20");
    let after = visit.pixels();
    assert_ne!(before, after, "another picture at another speed");
    visit.wait_speed("> 49");
    visit.browser.eval("$('size').value = '640px'; $('size').onchange()");
    assert_eq!(visit.browser.number("$('panel').getBoundingClientRect().width"), 640.0);
    visit.browser.click("#pause");
    visit.browser.wait_for("state.paused");
    let shown = visit.browser.text("shownCells.get('vehicle.speed').textContent");
    let shown: f64 = shown.split(' ').next().unwrap().parse().unwrap();
    let truth = visit.truth("vehicle.speed");
    assert!((shown - truth).abs() < 3.0, "the cluster says {shown}, the vehicle does {truth}");
    visit.leave();
}

#[test]
fn the_keyboard_alone_drives_stops_and_pauses() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    visit.browser.key("d");
    visit.browser.wait_for("$('gears').querySelector('[aria-checked=true]').textContent === 'D'");
    visit.browser.key_down("ArrowUp");
    visit.browser.wait_for("state.settings[rows.get('driver.accelerator').index] > 90");
    visit.wait_speed("> 15");
    visit.browser.key_up("ArrowUp");
    visit.browser.wait_for("state.settings[rows.get('driver.accelerator').index] === 0");
    visit.browser.key_down("ArrowDown");
    visit.wait_speed("< 1");
    visit.browser.key_up("ArrowDown");
    visit.browser.wait_for("state.settings[rows.get('driver.brake').index] === 0");
    visit.browser.key(" ");
    visit.browser.wait_for("state.paused && $('pause').getAttribute('aria-pressed') === 'true'");
    visit.browser.key("?");
    visit.browser.wait_for("$('keys').open");
    visit.browser.key("Escape");
    visit.browser.wait_for("!$('keys').open");
    visit.leave();
}

#[test]
fn tab_reaches_everything_and_everything_has_a_name() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    let mut reached = Vec::new();
    for _ in 0..400 {
        visit.browser.key("Tab");
        let name = visit.browser.text(
            "(() => { const e = document.activeElement; if (e === document.body) return ''; \
             const name = e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.[0]?.textContent.trim(); \
             return (e.dataset.preset || e.id || e.dataset.path || e.tagName) + ': ' + (name || 'NAMELESS'); })()",
        );
        if name.is_empty() && reached.len() > 20 {
            break;
        }
        reached.push(name);
    }
    assert!(!reached.iter().any(|name| name.contains("NAMELESS")), "{reached:#?}");
    for wanted in ["pause:", "drive:", "accelerator:", "button0:", "filter:", "record:", "rows:"] {
        assert!(
            reached.iter().any(|name| name.starts_with(wanted)),
            "Tab never reaches {wanted} {reached:#?}"
        );
    }
    visit.leave();
}

#[test]
fn an_injected_fault_turns_a_line_on_and_clearing_takes_it_away() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    visit.browser.wait_for("$('line').textContent === ''");
    let before = visit.pixels();
    visit.browser.eval("set('battery.hottest', 70)");
    visit
        .browser
        .wait_for("$('line').textContent !== '' && document.querySelector('[data-telltale=battery_fault]')");
    assert_ne!(visit.pixels(), before, "the panel shows it");
    visit.browser.wait_for("document.body.dataset.tones > 0");
    visit.browser.click("#clear");
    visit
        .browser
        .wait_for("state.settings[rows.get('battery.hottest').index] === null && $('clear').disabled");
    visit.leave();
}

#[test]
fn cut_bus_wires_are_named_by_the_cluster_and_mended() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    visit.browser.wait_for("!document.querySelector('[data-telltale=no_communication]')");
    visit.browser.eval("document.querySelector('[data-group=links]').open = true");
    visit.browser.click("[data-path='bus.unplug'] i");
    visit.browser.wait_for("state.settings[rows.get('bus.unplug').index] === 1");
    visit.browser.wait_for("document.querySelector('[data-telltale=no_communication]')");
    visit.browser.click("[data-path='bus.unplug'] i");
    visit.browser.wait_for("!document.querySelector('[data-telltale=no_communication]')");
    visit.leave();
}

#[test]
fn time_stands_still_steps_and_runs_faster() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    visit.browser.click("#pause");
    visit.browser.wait_for("state.paused");
    visit.browser.eval("new Promise(done => setTimeout(done, 300))");
    let stood = visit.browser.number("state.seconds");
    visit.browser.eval("new Promise(done => setTimeout(done, 400))");
    assert_eq!(visit.browser.number("state.seconds"), stood);
    visit.browser.click("#step");
    visit.browser.wait_for(&format!("state.seconds > {stood}"));
    assert!((visit.browser.number("state.seconds") - stood - 0.010).abs() < 0.001);
    visit.browser.click("#faster");
    visit.browser.wait_for("state.factor === 2 && $('factor').textContent === '2×'");
    visit.browser.eval("for (let i = 0; i < 3; i++) changeFactor(1)");
    visit.browser.wait_for("state.factor === 0");
    visit.browser.click("#pause");
    visit.browser.wait_for(&format!("state.seconds > {}", stood + 5.0));
    assert!(visit.browser.number("state.capability") > 1.0, "faster than real time");
    visit.leave();
}

#[test]
fn both_languages_are_whole() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    let untranslated = "[...document.querySelectorAll('[data-t]')].filter(e => !e.textContent.trim()).length \
                        + Object.values(WORDS).filter(w => !w[0] || !w[1]).length";
    for (to, title, preset) in [("zh", "虚拟台架", "行驶 50 km/h"), ("en", "Virtual bench", "Drive 50 km/h")]
    {
        visit.browser.eval(&format!("speak('{to}')"));
        assert_eq!(visit.browser.text("document.querySelector('h1').textContent"), title);
        assert_eq!(visit.browser.text("document.querySelector('[data-preset=drive]').textContent"), preset);
        assert_eq!(visit.browser.number(untranslated), 0.0);
    }
    visit.browser.key("l");
    visit.browser.wait_for("document.documentElement.lang === 'zh-CN'");
    visit.leave();
}

#[test]
fn the_bus_is_listed_filtered_and_decoded() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    visit.browser.wait_for("document.querySelector('#frames [data-name=VCU1]')");
    let all = visit.browser.number("$('frames').children.length");
    assert!(all > 10.0, "{all} identifiers");
    visit.browser.key("/");
    for letter in ["v", "c", "u", "1"] {
        visit.browser.key(letter);
    }
    visit.browser.wait_for("[...$('frames').children].every(row => row.dataset.name.includes('VCU1'))");
    visit.browser.click("#frames [data-name=VCU1]");
    visit
        .browser
        .wait_for("$('decoded').querySelector('[data-signal=vehicle_speed]')?.textContent.includes('km/h')");
    visit.browser.click("[data-value=stream]");
    visit.browser.wait_for("$('frames').children.length > 3");
    visit.browser.click("#freeze");
    let frozen = visit.browser.text("$('frames').innerText");
    visit.browser.eval("new Promise(done => setTimeout(done, 400))");
    assert_eq!(visit.browser.text("$('frames').innerText"), frozen);
    visit.leave();
}

#[test]
fn pictures_recordings_and_logs_are_kept() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    assert_eq!(visit.fetch("/recording.gif").0, 404, "nothing is recorded yet");
    visit.browser.click("#record");
    visit.browser.click("[data-preset=drive]");
    visit.browser.wait_for("state.recording?.seconds > 2");
    visit.browser.click("#record");
    visit.browser.wait_for("!$('recorded').hidden");
    let (status, log) = visit.fetch("/recording.log");
    assert_eq!(status, 200);
    let log = Log::parse("recording.log", std::str::from_utf8(&log).unwrap()).unwrap();
    assert!(log.entries.len() > 200 && log.duration().as_secs_f64() > 1.9, "{} frames", log.entries.len());
    let (_, gif) = visit.fetch("/recording.gif");
    let mut reader = gif::DecodeOptions::new().read_info(&gif[..]).unwrap();
    assert_eq!((reader.width(), reader.height()), (320, 240));
    let mut hundredths = 0;
    while let Some(frame) = reader.read_next_frame().unwrap() {
        hundredths += u32::from(frame.delay);
    }
    assert!(hundredths > 190, "the GIF lasts {hundredths} hundredths of a second");
    for scale in [1, 3] {
        let (_, file) = visit.fetch(&format!("/screen/{scale}"));
        let reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
        assert_eq!((reader.info().width, reader.info().height), (320 * scale, 240 * scale));
    }
    visit.leave();
}

#[test]
fn every_vehicle_starts_and_drives_and_the_recording_plays() {
    let Some(mut visit) = visit(1440, 900) else { return };
    for name in ["jiulong", "c5ev", "citybus"] {
        visit.browser.click(&format!("#vehicles [data-value={name}]"));
        visit.browser.wait_for(&format!("catalog.vehicle === '{name}' && state"));
        visit.wait_ready();
        visit.browser.click("[data-preset=drive]");
        visit.wait_speed("> 10");
    }
    visit.browser.click("#vehicles [data-value=null]");
    visit.browser.wait_for("catalog.vehicle === null && state?.shown.length > 5 && !$('no-vehicle').hidden");
    visit.leave();
}

#[test]
fn a_scenario_plays_and_its_verdict_comes_in() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.browser.eval("$('scenario').value = 'city_drive'");
    visit.browser.click("#play");
    visit.browser.wait_for("state?.playing?.name === 'city_drive' && !$('story').hidden");
    visit.browser.eval("send({ do: 'speed', factor: 0 })");
    visit.browser.wait_for("state.playing.checks?.length > 5 && $('story-list').querySelector('.passed')");
    // At full speed the story may be over before anybody looks: the distance stays.
    visit
        .browser
        .wait_for("state.truths[catalog.truths.findIndex(t => t.path === 'vehicle.distance')] > 0.1");
    visit.browser.wait_for("state.playing.checks.every(check => check.found)");
    assert_eq!(visit.browser.number("state.playing.checks.filter(check => !check.found.passed).length"), 0.0);
    visit.leave();
}

#[test]
fn every_width_from_a_phone_up_fits_without_scrolling_sideways() {
    let Some(mut visit) = visit(390, 844) else { return };
    visit.wait_ready();
    for (width, height) in
        [(360, 740), (390, 844), (760, 900), (900, 700), (1280, 800), (1440, 900), (2560, 1440)]
    {
        visit.browser.resize(width, height);
        visit.browser.eval("new Promise(done => setTimeout(done, 150))");
        for tab in ["drive", "values", "faults", "bus"] {
            visit.browser.eval(&format!("showTab('{tab}')"));
            let over = visit.browser.number("document.documentElement.scrollWidth - innerWidth");
            assert!(over <= 0.0, "{over} pixels too wide at {width} in {tab}");
            let below = visit.browser.number("document.documentElement.scrollHeight - innerHeight");
            assert!(width < 760 || below <= 0.0, "{below} pixels below the window's end at {width} in {tab}");
            let panel = visit.browser.number("$('panel').getBoundingClientRect().width");
            assert!((160.0..=f64::from(width)).contains(&panel), "the panel is {panel} wide at {width}");
        }
    }
    visit.leave();
}

#[test]
fn gear_d_by_the_mouse_and_the_up_arrow_drive() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    visit
        .browser
        .eval("[...$('gears').querySelectorAll('button')].find(b => b.textContent === 'D').id = 'lever-d'");
    visit.browser.click("#lever-d");
    assert_eq!(visit.browser.text("document.activeElement.id"), "lever-d", "the lever has the focus");
    visit.browser.key_down("ArrowUp");
    visit.wait_speed("> 15");
    visit.browser.key_up("ArrowUp");
    visit.browser.wait_for("state.settings[rows.get('driver.accelerator').index] === 0");
    assert_eq!(visit.browser.text("$('gears').querySelector('[aria-checked=true]').textContent"), "D");
    visit.leave();
}

#[test]
fn up_and_down_are_the_pedals_whatever_has_the_focus_and_change_nothing_else() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    // Nothing moves by itself, a row not either while it is clicked, and everything that can have the focus is to be seen.
    visit.browser.click("#pause");
    visit.browser.wait_for("state.paused");
    visit.browser.click("#frames [data-name=VCU1]");
    visit.browser.wait_for("!$('decoded').hidden");
    visit.browser.eval("for (const details of document.querySelectorAll('details')) details.open = true");
    visit.browser.eval(
        "{ window.sent = []; window.own = null; const through = link.send.bind(link); \
           link.send = text => { sent.push(JSON.parse(text)); through(text); }; \
           window.focusable = [...document.querySelectorAll('a[href], button, input, select, summary, [tabindex]')] \
             .filter(e => !e.disabled && e.checkVisibility()); \
           window.isTyped = e => e.matches('input[type=number], input[type=search]'); \
           window.look = () => JSON.stringify([catalog.bench, catalog.vehicle, view, language, document.body.dataset.tab, \
             ...[...document.querySelectorAll('input, select')].map(e => [e.value, e.checked]), \
             ...[...document.querySelectorAll('[aria-checked], [aria-pressed]')].map(e => \
               [e.getAttribute('aria-checked'), e.getAttribute('aria-pressed')])]); }",
    );
    let count = visit.browser.number("focusable.length") as usize;
    assert!(count > 80, "{count} elements");
    for kind in [
        "[role=radio]",
        "select",
        "[type=range]",
        "[type=number]",
        "[type=search]",
        "[type=checkbox]",
        "summary",
        "a",
        ".scroll",
        ".pedal",
    ] {
        let found = visit.browser.number(&format!("focusable.filter(e => e.matches('{kind}')).length"));
        assert!(found > 0.0, "no {kind} among them");
    }
    for index in 0..count {
        let element = format!("focusable[{index}]");
        let name = visit.browser.text(&format!("{element}.outerHTML.slice(0, 160)"));
        let before = visit.browser.text(&format!(
            "{element}.focus(); own = setting({element}.closest('[data-path]')?.dataset.path); \
             sent.length = 0; look()"
        ));
        assert_eq!(visit.browser.eval(&format!("document.activeElement === {element}")), true, "{name}");
        let is_typed = visit.browser.eval(&format!("isTyped({element})")) == true;
        for (key, pedal) in [("ArrowUp", "accelerator"), ("ArrowDown", "brake")] {
            visit.browser.key_down(key);
            let is_held = visit.browser.number(&format!("held.{pedal}")) > 0.0;
            assert_ne!(is_held, is_typed, "{key} on {name}");
            visit.browser.key_up(key);
            assert_eq!(visit.browser.number(&format!("held.{pedal}")), 0.0, "{key} let go of on {name}");
        }
        if is_typed {
            // The arrows are the box's own: they step its number and nothing else.
            let path = format!("{element}.closest('[data-path]')?.dataset.path");
            let others = format!("sent.filter(c => c.do !== 'set' || c.path !== {path}).length");
            assert_eq!(visit.browser.number(&others), 0.0, "{name} changes something else");
            visit.browser.eval(&format!("{element}.blur(); {path} && set({path}, own)"));
        } else {
            let others =
                "JSON.stringify(sent.filter(c => c.do !== 'set' || !Object.values(PEDALS).includes(c.path)))";
            assert_eq!(visit.browser.text(others), "[]", "{name} changes something");
            assert_eq!(visit.browser.text("look()"), before, "{name} changes something on the page");
        }
    }
    visit.leave();
}

#[test]
fn a_list_that_has_dropped_down_keeps_the_arrows() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    visit.browser.click("#scenario");
    visit.browser.wait_for("$('scenario').matches(':open')");
    visit.browser.key_down("ArrowDown");
    assert_eq!(visit.browser.number("held.brake"), 0.0);
    visit.browser.key_up("ArrowDown");
    visit.browser.key("Escape");
    visit.leave();
}

#[test]
fn left_and_right_move_within_a_group_and_enter_chooses() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    let gear = "$('gears').querySelector('[aria-checked=true]').textContent";
    let focus = "document.activeElement.textContent";
    visit.browser.eval("$('gears').querySelector('[tabindex=\"0\"]').focus()");
    assert_eq!((visit.browser.text(gear), visit.browser.text(focus)), ("N".into(), "N".into()));
    visit.browser.key("ArrowRight");
    assert_eq!((visit.browser.text(gear), visit.browser.text(focus)), ("N".into(), "D".into()));
    visit.browser.key("Enter");
    assert_eq!(visit.browser.text(gear), "D");
    visit.browser.key("ArrowLeft");
    visit.browser.key("ArrowLeft");
    assert_eq!((visit.browser.text(gear), visit.browser.text(focus)), ("D".into(), "R".into()));
    visit.browser.key("Tab");
    assert_eq!(
        visit.browser.text("$('gears').querySelector('[tabindex=\"0\"]').textContent"),
        "D",
        "Tab comes back to it"
    );
    // Another vehicle: not by an arrow, but by Enter, and the focus stays.
    visit.browser.eval("$('vehicles').querySelector('[tabindex=\"0\"]').focus()");
    let bench = visit.browser.number("catalog.bench");
    visit.browser.key("ArrowRight");
    assert_eq!(visit.browser.text("document.activeElement.dataset.value"), "jiulong");
    visit.browser.key("Enter");
    visit.browser.wait_for(&format!("catalog.bench > {bench} && catalog.vehicle === 'jiulong' && state"));
    assert_eq!(visit.browser.number("catalog.bench"), bench + 1.0, "started once");
    assert_eq!(visit.browser.text("document.activeElement.dataset.value"), "jiulong");
    // The list of the bus, row by row.
    visit.browser.wait_for("$('frames').children.length > 2");
    visit.browser.click("#pause");
    visit.browser.wait_for("state.paused");
    visit.browser.eval("$('rows').focus()");
    visit.browser.key("ArrowRight");
    visit.browser.wait_for("chosen?.id === $('frames').children[0].dataset.id");
    visit.browser.key("ArrowRight");
    visit.browser.wait_for("chosen?.id === $('frames').children[1].dataset.id");
    visit.leave();
}

#[test]
fn a_failed_expectation_is_told_when_the_story_has_come_to_it_in_good_english() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    let found = |passed: bool| format!("{{ got: 'off', passed: {passed} }}");
    let mut verdict = |first: &str, second: &str| {
        visit.browser.text(&format!(
            "(() => {{ showStory({{ name: 'x', title: 'x', rules: [], end: 9, deeds: [], problem: null, checks: [ \
             {{ at: 1, expected: 'telltale.ready on', found: {first} }}, {{ at: 8, expected: 'speed 0', found: {second} }}] }}, 2); \
             return $('story-verdict').textContent + '; ' + $('story-list').textContent; }})()"
        ))
    };
    let (wrong, right) = (found(false), found(true));
    assert!(verdict(&wrong, "null").starts_with("1 expectation failed, of 2; "));
    assert!(verdict(&wrong, &wrong).starts_with("2 expectations failed, of 2; "));
    assert!(verdict(&right, &right).starts_with("2 expectations came true; "));
    let ahead = verdict(&right, "null");
    assert!(ahead.starts_with("1 expectation came true so far, of 2; "), "{ahead}");
    assert!(ahead.contains("✓telltale.ready on") && ahead.ends_with("·speed 0"), "not judged ahead: {ahead}");
    visit.leave();
}

/// Overlaps and what sticks out, of header, strip, tabs, panes, bezel and what is below it; empty = none.
const CLUTTER: &str = "(() => { const found = []; \
    const box = e => ({ name: e.id || e.className || e.tagName, r: e.getBoundingClientRect() }); \
    const seen = list => [...list].filter(e => e.checkVisibility()).map(box); \
    const apart = boxes => boxes.forEach((a, i) => boxes.slice(i + 1).forEach(b => { \
      if (a.r.left < b.r.right - 1 && b.r.left < a.r.right - 1 && a.r.top < b.r.bottom - 1 && b.r.top < a.r.bottom - 1) \
        found.push(`${a.name} overlaps ${b.name}`); })); \
    const inside = (boxes, e) => { const o = box(e); boxes.forEach(({ name, r }) => { \
      if (r.left < o.r.left - 1 || r.right > o.r.right + 1 || r.top < o.r.top - 1 || r.bottom > o.r.bottom + 1) \
        found.push(`${name} sticks out of ${o.name}`); }); }; \
    const header = document.querySelector('.bar'), tabs = innerWidth < 760 ? [] : [$('tabs')]; \
    apart(seen([header, $('recorded'), ...tabs, ...document.querySelectorAll('main > section')])); \
    for (const parent of [header, $('stage'), $('recorded')]) if (parent.checkVisibility()) { \
      apart(seen(parent.children)); inside(seen(parent.children), parent); } \
    apart([box($('bezel')), box(header), ...seen([$('bus'), $('drive'), $('values'), $('faults'), $('recorded')])]); \
    if (innerWidth >= 760 && document.querySelector('main').getBoundingClientRect().bottom > innerHeight + 1) found.push('main sticks out'); \
    return found.join('; '); })()";

#[test]
fn a_recording_leaves_the_layout_in_order_and_its_links_go_when_dismissed_or_reloaded() {
    // One vehicle less to choose from: the whole header fits in one row of 1440 pixels.
    let Some(mut visit) = visit_bench(1440, 900, None) else { return };
    visit.wait_ready();
    let header = |visit: &mut Visit, width: u32, condition: &str| {
        visit.browser.wait_for(&format!("innerWidth === {width} && {condition}"));
        let painted = "new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))";
        visit.browser.eval(painted);
        assert_eq!(visit.browser.text(CLUTTER), "", "at {width} once {condition}");
        visit.browser.number("document.querySelector('.bar').offsetHeight")
    };
    for (width, tall) in [(1440, 900), (1280, 800), (1024, 768), (390, 844)] {
        visit.browser.resize(width, tall);
        let before = header(&mut visit, width, "$('recorded').hidden");
        visit.browser.eval("toggleRecord()");
        assert_eq!(header(&mut visit, width, "state.recording?.seconds > 1"), before, "recording at {width}");
        visit.browser.eval("toggleRecord()");
        assert_eq!(header(&mut visit, width, "!$('recorded').hidden"), before, "recorded at {width}");
        visit.browser.click("#dismiss");
        let after = header(&mut visit, width, "$('recorded').hidden && state.recorded");
        assert_eq!(after, before, "dismissed at {width}");
    }
    visit.browser.eval("toggleRecord()");
    visit.browser.wait_for("state.recording");
    visit.browser.eval("toggleRecord()");
    visit.browser.wait_for("!$('recorded').hidden");
    visit.browser.eval("window.isOld = true; setTimeout(() => location.reload())");
    visit.browser.wait_for("!window.isOld && document.body && 'ready' in document.body.dataset");
    visit.browser.wait_for("state.recorded && $('recorded').hidden");
    visit.leave();
}

#[test]
fn no_name_of_a_control_is_broken_within_a_word() {
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    visit.browser.eval("for (const details of document.querySelectorAll('details')) details.open = true");
    let broken = "[...document.querySelectorAll('.control > .name')].filter(e => e.checkVisibility()).flatMap(e => \
        [...e.textContent.matchAll(/[^\\s/-]+/g)].filter(word => { const range = document.createRange(); \
          range.setStart(e.firstChild, word.index); range.setEnd(e.firstChild, word.index + word[0].length); \
          return new Set([...range.getClientRects()].map(r => Math.round(r.top))).size > 1; }).map(word => word[0])).join()";
    for vehicle in ["citybus", "jiulong", "c5ev"] {
        visit.browser.eval(&format!("send({{ do: 'start', vehicle: '{vehicle}' }})"));
        visit.browser.wait_for(&format!("catalog.vehicle === '{vehicle}' && state"));
        visit.browser.eval("for (const details of document.querySelectorAll('details')) details.open = true");
        for (width, height) in [(1280, 800), (1366, 768), (1440, 900), (1024, 768), (360, 740)] {
            visit.browser.resize(width, height);
            for tab in ["drive", "faults"] {
                visit.browser.eval(&format!("showTab('{tab}')"));
                assert_eq!(visit.browser.text(broken), "", "{vehicle} at {width} in {tab}");
                let wide = visit.browser.number("document.documentElement.scrollWidth - innerWidth");
                assert!(wide <= 0.0, "{vehicle}: {wide} pixels too wide at {width} in {tab}");
            }
        }
    }
    visit.leave();
}

/// Serves one HTML page for as long as the process runs and returns its port.
fn foreign_site(html: String) -> u16 {
    let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port();
    std::thread::spawn(move || {
        for stream in listener.incoming() {
            let Ok(mut stream) = stream else { continue };
            let _ = stream.read(&mut [0; 4_096]);
            let head =
                format!("Content-Type: text/html\r\nContent-Length: {}\r\nConnection: close", html.len());
            let _ = write!(stream, "HTTP/1.1 200 OK\r\n{head}\r\n\r\n{html}");
        }
    });
    port
}

#[test]
fn a_foreign_site_in_the_same_browser_is_refused_whatever_it_tries() {
    let Some(visit) = visit(1440, 900) else { return };
    let bench = visit.address;
    let html = format!(
        "<!doctype html><title>foreign</title><body><script> \
         const got = window.got = {{}}; \
         const told = (what, how) => {{ got[what] = how; }}; \
         const element = (what, tag, rest) => {{ const e = document.createElement(tag); \
           e.onload = () => told(what, 'answered'); e.onerror = () => told(what, 'refused'); Object.assign(e, rest); document.body.append(e); }}; \
         element('img', 'img', {{ src: 'http://{bench}/screen/8' }}); \
         element('bare img', 'img', {{ src: 'http://{bench}/screen/7', referrerPolicy: 'no-referrer' }}); \
         element('script', 'script', {{ src: 'http://{bench}/' }}); \
         fetch('http://{bench}/screen/6').then(() => told('fetch', 'answered'), () => told('fetch', 'refused')); \
         fetch('http://{bench}/screen/5', {{ mode: 'no-cors' }}).then(() => told('no-cors', 'answered'), () => told('no-cors', 'refused')); \
         const socket = new WebSocket('ws://{bench}/live'); \
         socket.onopen = () => {{ told('socket', 'answered'); socket.send('{{\"do\":\"pause\",\"on\":true}}'); }}; \
         socket.onerror = () => told('socket', 'refused'); \
         const frame = document.createElement('iframe'); frame.src = 'http://{bench}/'; \
         frame.onload = () => told('iframe', 'loaded'); document.body.append(frame); \
         </script>"
    );
    let port = foreign_site(html);
    let chromium = browser::find().unwrap();
    // The same site on another port, and another site: a browser tells them apart.
    for origin in [format!("http://127.0.0.1:{port}/"), format!("http://localhost:{port}/")] {
        let mut foreign = Browser::open(&chromium, &origin, 800, 600);
        foreign.wait_for("window.got && Object.keys(got).length === 7");
        for what in ["img", "bare img", "script", "fetch", "no-cors", "socket"] {
            assert_eq!(foreign.text(&format!("got['{what}']")), "refused", "{what} from {origin}");
        }
        let statuses = foreign.statuses(&bench.to_string());
        assert_eq!(statuses.len(), 6, "all but the socket: {statuses:?}");
        for (url, status) in &statuses {
            assert_eq!(*status, 403, "{url} from {origin}");
        }
        assert!(statuses.iter().any(|(url, _)| *url == format!("http://{bench}/")), "{statuses:?}");
    }
    visit.leave();
}

#[test]
fn the_readmes_picture_of_the_page() {
    if std::env::var_os("BLESS").is_none() {
        return;
    }
    let Some(mut visit) = visit(1440, 900) else { return };
    visit.wait_ready();
    visit.browser.click("[data-preset=drive]");
    visit.wait_speed("> 49");
    visit.browser.click("#frames [data-name=VCU1]");
    visit.browser.wait_for("!$('decoded').hidden");
    let data = visit.browser.screenshot();
    std::fs::write(root().join("docs/images/page.png"), base64(&data)).unwrap();
}

/// Reads Base64 with padding.
fn base64(text: &str) -> Vec<u8> {
    let digit = |byte: u8| match byte {
        b'A'..=b'Z' => u32::from(byte - b'A'),
        b'a'..=b'z' => u32::from(byte - b'a') + 26,
        b'0'..=b'9' => u32::from(byte - b'0') + 52,
        b'+' => 62,
        _ => 63,
    };
    let padding = text.bytes().rev().take_while(|byte| *byte == b'=').count();
    let mut bytes: Vec<u8> = text
        .as_bytes()
        .chunks_exact(4)
        .flat_map(|four| {
            let group = four.iter().fold(0, |group, byte| group << 6 | digit(*byte));
            [(group >> 16) as u8, (group >> 8) as u8, group as u8]
        })
        .collect();
    bytes.truncate(bytes.len() - padding);
    bytes
}
