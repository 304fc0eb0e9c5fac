"use strict";

// --- words ---------------------------------------------------------------------------------------------------------

const WORDS = {
  title: ["虚拟台架", "Virtual bench"],
  vehicle: ["车辆", "Vehicle"],
  recording: ["录制回放", "Recording"],
  time: ["时间", "Time"],
  pause: ["暂停或继续（空格）", "Pause or go on (space)"],
  step: ["单步 10 ms（.）", "One step of 10 ms (.)"],
  slower: ["变慢（−）", "Slower (−)"],
  faster: ["变快（+）", "Faster (+)"],
  engine: ["引擎可达", "engine can"],
  fastest: ["最快", "max"],
  paused: ["已暂停", "paused"],
  record: ["录制", "Record"],
  bus_log: ["总线日志", "Bus log"],
  recorded: ["已录制", "Recorded"],
  frames_in: ["帧", "frames"],
  dismiss: ["关闭", "Dismiss"],
  screenshot: ["截图", "Screenshot"],
  sound: ["声音", "Sound"],
  help: ["按键帮助", "Keys"],
  drive: ["驾驶", "Drive"],
  brake: ["制动", "Brake"],
  accelerator: ["加速", "Accelerator"],
  gear: ["档位", "Gear"],
  no_vehicle: ["正在回放录制的总线数据，没有可操作的车辆。请在上方选择一辆车。", "A recording plays on the bus; nothing here takes settings. Choose a vehicle above to drive."],
  cluster: ["仪表", "Cluster"],
  screen: ["仪表屏幕", "The cluster's screen"],
  button: ["按键", "Button"],
  buzzer: ["蜂鸣器", "Buzzer"],
  silent: ["静音", "silent"],
  backlight: ["背光", "Back-light"],
  panel_size: ["显示大小", "Size"],
  fit: ["适应", "Fit"],
  bus: ["总线", "Bus"],
  load: ["负载", "Load"],
  received: ["固件收到", "Received"],
  lost: ["丢失", "Lost"],
  controller: ["控制器", "Controller"],
  view: ["视图", "View"],
  by_id: ["标识符", "By id"],
  stream: ["逐帧", "Stream"],
  filter: ["筛选：名称、节点、标识符（/）", "Filter: name, sender, id (/)"],
  freeze: ["定格", "Freeze"],
  frames: ["总线上的帧", "Frames on the bus"],
  at: ["时间", "Time"],
  id: ["标识符", "Id"],
  name: ["名称", "Name"],
  sender: ["节点", "Sender"],
  period: ["周期", "Period"],
  data: ["数据", "Data"],
  count: ["帧数", "Count"],
  unknown_frame: ["没有车辆定义此报文。", "No vehicle has this message."],
  no_frames: ["还没有帧。", "No frames yet."],
  skipped: ["帧未逐一显示", "frames not shown one by one"],
  values: ["数值", "Values"],
  scenario: ["场景", "Scenario"],
  play: ["从上电开始播放场景", "Play the scenario from power-on"],
  judging: ["正在独立运行并判定……", "being judged by a run of its own ..."],
  all_passed: ["项期望全部满足", "expectation came true", "expectations came true"],
  passed_so_far: ["项期望已满足，共", "expectation came true so far, of", "expectations came true so far, of"],
  not_passed: ["项期望未满足，共", "expectation failed, of", "expectations failed, of"],
  truth: ["车辆实际", "Vehicle"],
  shown: ["仪表显示", "Cluster says"],
  no_telltales: ["没有点亮的指示灯", "No telltale is lit"],
  faults: ["故障注入", "Faults"],
  clear: ["全部清除", "Clear all"],
  auto: ["自动", "auto"],
  driver: ["驾驶员", "Driver"],
  body: ["车身", "Body"],
  road: ["道路", "Road"],
  charging: ["充电", "Charging"],
  battery: ["动力电池", "Battery"],
  motor: ["电机", "Motor"],
  parts: ["部件", "Parts"],
  links: ["通信链路", "Links"],
  set: ["项已设置", "set"],
  keys: ["键盘操作", "Keys"],
  shortcuts: ["启用单键快捷键", "Single-key shortcuts"],
  close: ["关闭", "Close"],
  stopped: ["台架已停止：", "The bench has stopped: "],
  connection: ["与台架的连接已断开，正在重连……", "Connection to the bench lost; trying again ..."],
  full: ["录制已满", "the recording is full"],
  starting: ["台架正在启动……", "The bench starts ..."],
  open_file: ["打开文件……", "Open a file ..."],
  open_hint: ["录制、DBC 或固件 ELF；文件不会离开本机", "A recording, a DBC or a firmware ELF; it never leaves this machine"],
  local_only: ["文件只在此浏览器内读取，不会上传。", "The file is read in this browser only; nothing is uploaded."],
  is_image: ["固件映像：台架已用它重新上电。", "An image of the firmware: the bench has started anew with it."],
  is_recording: ["录制：台架正在向固件回放。", "A recording: the bench plays it to the firmware."],
  is_dbc: ["DBC 文件。", "A DBC file."],
  is_other: ["无法识别此文件。", "The bench cannot read this file."],
  messages_in: ["条报文", "messages"],
  no_findings: ["没有问题。", "Nothing is wrong with it."],
  place: ["行", "Line"],
  finding: ["问题", "Finding"],
  message: ["报文", "Message"],
  signal: ["信号", "Signal"],
  last_value: ["最后的值", "Last value"],
  and_more: ["其余未列出：", "not listed: "],
  ended: ["台架已崩溃：", "The bench has crashed: "],
  restart: ["重新启动", "Restart"],
  raw: ["原始值", "raw"],
};

const KEYS = [
  [["↑"], ["按住加速", "hold: accelerate"]], [["↓"], ["按住制动", "hold: brake"]],
  [["←", "→"], ["在所选的一组内移动", "move within the group, the slider or the list that has the focus"]],
  [["D", "N", "R", "P"], ["档位", "gear"]], [["H"], ["驻车制动", "parking brake"]],
  [["1", "2", "3"], ["预设：行驶、停车、充电", "presets: drive, stop, charge"]],
  [["A", "B"], ["仪表按键（可按住）", "the cluster's buttons (may be held)"]],
  [["Space", "."], ["暂停、单步", "pause, one step"]], [["−", "+"], ["变慢、变快", "slower, faster"]],
  [["/"], ["筛选总线", "filter the bus"]], [["F"], ["定格总线", "freeze the bus"]],
  [["S"], ["截图", "screenshot"]], [["O"], ["录制", "record"]], [["M"], ["声音", "sound"]], [["L"], ["语言", "language"]], [["?"], ["本帮助", "this help"]],
];

const TABS = ["drive", "values", "faults", "bus"];
const DRIVE_GROUPS = ["driver", "body", "road", "charging"];
const FAULT_GROUPS = ["battery", "motor", "parts", "links"];
const FACTORS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 0];
/** Controls with a place of their own beside the lists. */
const PEDALS = { accelerator: "driver.accelerator", brake: "driver.brake" };
const GEAR = "driver.gear";
const TARGET = "driver.target";
const PARKING_BRAKE = "driver.parking_brake";
/** Milliseconds for which a setting by hand is not overwritten by an older one from the bench. */
const HOLD_MS = 600;
/** Frames that the page remembers, to look back at when the bus is frozen. */
const FRAMES_KEPT = 2000;
/** Pixels that the list of the bus keeps beside the panel; page.css says the same. */
const BUS_HEIGHT = 220;
/** Rows of the running stream: more of them nobody can read. */
const FRAMES_LIVE = 80;

// --- small things --------------------------------------------------------------------------------------------------

const $ = id => document.getElementById(id);
const stored = (key, fallback) => { try { return localStorage.getItem("bench." + key) ?? fallback; } catch { return fallback; } };
const store = (key, value) => { try { localStorage.setItem("bench." + key, value); } catch { /* a private window keeps nothing */ } };
let language = stored("language", navigator.language.toLowerCase().startsWith("zh") ? "zh" : "en");
const pick = pair => pair[language === "zh" ? 0 : 1];
const word = key => pick(WORDS[key]);
const named = thing => thing[language];
/** A number of things; the third word is English for more or less than one. */
const counted = (number, key) => `${number} ${number !== 1 && language === "en" ? WORDS[key][2] : word(key)}`;
/** The state of a kind that is written with this word; how a value is missing is a state too. */
const stateOf = (kind, text) => [...catalog.states[kind] ?? [], ...catalog.states.missing].find(state => state.word === text);

/** Makes an element: tag, properties (class, on..., data and aria as they are), children. */
function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (key in element && typeof value !== "string") element[key] = value;
    else if (value !== undefined) element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
}
function write(element, text) { if (element.textContent !== text) element.textContent = text; }
function flag(element, name, on) { if (element.getAttribute(name) !== String(on)) element.setAttribute(name, on); }

/**
 * A row of buttons of which one is chosen. Tab comes to the chosen one, left and right move the focus and nothing else,
 * Enter and Space choose: an arrow must not shift the gear or start another vehicle. Up and down are the pedals, here as
 * everywhere.
 */
function segments(container, choices, choose) {
  let chosen = 0;
  const enterAt = entry => buttons.forEach((button, index) => { button.tabIndex = index === entry ? 0 : -1; });
  const buttons = choices.map(([value, text]) => make("button", {
    type: "button", role: "radio", "data-value": String(value), onclick: () => choose(value),
    onfocus: event => enterAt(buttons.indexOf(event.target)), onblur: () => enterAt(chosen),
    onkeydown: event => {
      const move = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!move || isModified(event)) return;
      event.preventDefault();
      buttons[(buttons.indexOf(event.target) + move + buttons.length) % buttons.length].focus();
    },
  }, text));
  // Built again under a person's hands: the focus stays where it was.
  const focused = container.contains(document.activeElement) ? document.activeElement.dataset.value : undefined;
  container.replaceChildren(...buttons);
  enterAt(chosen);
  buttons.find(button => button.dataset.value === focused)?.focus();
  return value => {
    chosen = Math.max(0, choices.findIndex(([known]) => known === value));
    buttons.forEach((button, index) => flag(button, "aria-checked", choices[index][0] === value));
    if (!container.contains(document.activeElement)) enterAt(chosen);
  };
}

// --- the link ------------------------------------------------------------------------------------------------------

let catalog, state, pictures = 0;
const link = openLink({
  onOpen() { document.body.classList.remove("lost"); dismissed = null; },
  onText(text) {
    const message = JSON.parse(text);
    if (message.kind === "catalog") takeCatalog(message);
    else if (message.kind === "state") takeState(message);
    else if (message.kind === "notice") notice(message.text);
  },
  onPicture: drawPicture,
  onClose(why) {
    document.body.classList.add("lost"); quiet();
    if (!link.restart) { notice(word("connection")); return; }
    // A Worker that has ended does not come back by itself.
    $("stopped").replaceChildren(word("ended") + (why || "?") + " ", make("button", { type: "button", id: "restart", onclick: () => { $("stopped").hidden = true; link.restart(); } }, word("restart")));
    $("stopped").hidden = false;
  },
});
const send = command => link.send(JSON.stringify(command));

/** Keeps what the session has under this name as a file. */
async function keep(path, name) {
  try {
    const blob = await link.ask(path), url = URL.createObjectURL(blob);
    make("a", { href: url, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(url), 60000);
  } catch (error) { notice(String(error.message || error)); }
}

// --- files ---------------------------------------------------------------------------------------------------------

const table = (heads, rows) => make("table", { class: "values" }, make("thead", {}, make("tr", {}, ...heads.map(head => make("th", {}, word(head))))), make("tbody", {}, ...rows.map(cells => make("tr", {}, ...cells.map(cell => make("td", {}, String(cell)))))));

/** Gives a file to the bench and shows what it is. */
async function openFile(file) {
  let told;
  try { told = JSON.parse(await link.drop(file)); } catch (error) { notice(String(error.message || error)); return; }
  const body = [make("p", {}, word("is_" + told.is))];
  if (told.is === "image") body.push(make("p", { class: "fact" }, `${told.bytes} B`));
  if (told.is === "recording") body.push(make("p", { class: "fact" }, `${told.frames} ${word("frames_in")}, ${told.seconds.toFixed(1)} s. ${told.notes.join("; ")}`));
  if (told.is === "other") body.push(make("p", { class: "problem" }, told.problem));
  if (told.is === "dbc") {
    body.push(make("p", { class: "fact" }, `${told.messages} ${word("messages_in")}. ${told.findings.length ? "" : word("no_findings")}`));
    if (told.findings.length) body.push(table(["place", "finding"], told.findings.map(found => [found.column ? `${found.line}:${found.column}` : found.line, `${found.grade}: ${found.text}`])));
  }
  if (told.decoded?.length) body.push(table(["message", "signal", "count", "last_value"], told.decoded.map(row => [row.message, row.signal, row.frames, `${row.last} ${row.unit}`.trim()])));
  if (told.more) body.push(make("p", { class: "fact" }, word("and_more") + told.more));
  body.push(make("p", { class: "fact" }, word("local_only")));
  $("dropped-title").textContent = told.name;
  $("dropped-body").replaceChildren(...body);
  $("dropped").dataset.is = told.is;
  if (!$("dropped").open) $("dropped").showModal();
}

if (link.drop) {
  $("open").hidden = false;
  $("open").onclick = () => $("file").click();
  $("file").onchange = () => { if ($("file").files[0]) openFile($("file").files[0]); $("file").value = ""; };
  addEventListener("dragover", event => event.preventDefault());
  addEventListener("drop", event => { event.preventDefault(); if (event.dataTransfer.files[0]) openFile(event.dataTransfer.files[0]); });
}

/** `#play=citybus/fire` plays a scenario, `#vehicle=jiulong` starts a vehicle; once, when the bench is there. */
let linked = new URLSearchParams(location.hash.slice(1));
function followHash() {
  const [vehicle, scenario] = (linked.get("play") ?? linked.get("vehicle") ?? "").split("/");
  if (!vehicle || !catalog) return;
  if (catalog.vehicle !== vehicle) { if (catalog.vehicles.some(({ name }) => name === vehicle)) send({ do: "start", vehicle }); else linked = new URLSearchParams(); return; }
  linked = new URLSearchParams();
  if (scenario) { $("scenario").value = scenario; send({ do: "play", name: scenario }); }
}
addEventListener("hashchange", () => { linked = new URLSearchParams(location.hash.slice(1)); followHash(); });

let noticeTimer;
function notice(text) {
  $("notice").textContent = text; $("notice").hidden = false;
  clearTimeout(noticeTimer); noticeTimer = setTimeout(() => $("notice").hidden = true, 5000);
}

// --- the panel -----------------------------------------------------------------------------------------------------

let drawing = false, nextPicture = null;
async function drawPicture(blob) {
  nextPicture = blob;
  if (drawing) return;
  drawing = true;
  while (nextPicture) {
    const blob = nextPicture;
    nextPicture = null;
    const image = await createImageBitmap(blob), canvas = $("panel"), context = canvas.getContext("2d");
    // Each pixel four times as wide and high, so that any size on the screen shows even pixels.
    context.imageSmoothingEnabled = false;
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    image.close();
    document.body.dataset.pictures = ++pictures;
  }
  drawing = false;
}

function fitPanel() {
  const choice = $("size").value, canvas = $("panel");
  if (choice !== "fit") { canvas.style.width = choice; return; }
  const border = $("bezel").offsetWidth - canvas.offsetWidth, phone = innerWidth < 760;
  const wide = $("stage").clientWidth - border - (phone ? 20 : 28);
  let high = (phone ? 0.34 : 0.56) * innerHeight;
  if (getComputedStyle(document.body).display === "flex") {
    // The page does not scroll: what the bus needs at least is not the panel's, nor what stands below it.
    const below = [...$("stage").children].filter(element => element !== $("bezel") && !element.hidden);
    // Its own padding and border, and a gap above each of them.
    const others = below.reduce((sum, element) => sum + element.offsetHeight + 12, 18 + 12 + 2);
    high = Math.min(high, document.querySelector("main").clientHeight - BUS_HEIGHT - 3 * 12 - border - others);
  }
  canvas.style.width = Math.floor(Math.max(160, Math.min(wide, high * 4 / 3))) + "px";
}

// --- sound ---------------------------------------------------------------------------------------------------------

let audio, tone, volume, audible = stored("sound", "on") === "on";
/** Browsers give sound only after the person has touched the page. */
function wakeAudio() {
  if (!audible) return;
  if (!audio) {
    audio = new AudioContext();
    tone = audio.createOscillator(); volume = audio.createGain();
    tone.type = "square"; volume.gain.value = 0;
    tone.connect(volume).connect(audio.destination); tone.start();
  }
  if (audio.state === "suspended") audio.resume();
}
function quiet() { if (audio) { volume.gain.cancelScheduledValues(0); volume.gain.setTargetAtTime(0, audio.currentTime, 0.005); } }
let tones = [0, 0];
function playTones(message) {
  for (const [before, hz, duty] of message.tones) {
    tones = [hz, duty];
    document.body.dataset.tones = 1 + Number(document.body.dataset.tones || 0);
    if (!audio || !audible) continue;
    // One update behind, and stretched as time is, so that a pattern keeps its rhythm.
    const stretch = message.factor > 0 ? Math.min(1 / message.factor, 10) : 1;
    const at = audio.currentTime + Math.max(0, 0.12 - before / 1e3 * stretch);
    const level = hz > 0 && duty > 0 ? 0.07 * Math.sin(Math.PI * Math.min(duty, 1)) : 0;
    if (level > 0) tone.frequency.setValueAtTime(Math.min(hz, 12000), at);
    volume.gain.setTargetAtTime(level, at, 0.003);
  }
  const sounds = tones[0] > 0 && tones[1] > 0 && tones[1] < 1;
  if (message.paused) quiet();
  $("buzzer-lamp").classList.toggle("on", sounds);
  write($("buzzer"), sounds ? tones[0] + " Hz" : word("silent"));
}

// --- what there is: built once per bench ---------------------------------------------------------------------------

/** path -> { control, index, show(setting), initial } */
let rows = new Map(), showVehicle = () => {}, showGear = () => {}, touched = new Map();
/** Number of the recording that is not offered, because it was there when the page came or the person has done with it. */
let dismissed = null;

function takeCatalog(message) {
  const again = catalog && catalog.bench !== message.bench;
  catalog = message;
  if (again || rows.size === 0) { state = null; resetBus(); }
  tones = [0, 0];
  build();
  followHash();
}

function build() {
  if (!catalog) return;
  rows = new Map();
  const choices = catalog.vehicles.map(vehicle => [vehicle.name, named(vehicle)]);
  if (catalog.recording) choices.push([null, word("recording")]);
  showVehicle = segments($("vehicles"), choices, name => { if (name !== catalog.vehicle) send({ do: "start", vehicle: name }); });
  showVehicle(catalog.vehicle);
  $("scenes").hidden = !catalog.scenarios.length;
  const scene = $("scenario").value;
  $("scenario").replaceChildren(...catalog.scenarios.map(({ name, title }) => make("option", { value: name, title }, `${name.replaceAll("_", " ")}`)));
  if (catalog.scenarios.some(({ name }) => name === scene)) $("scenario").value = scene;
  storyOf = null;
  write($("notes"), catalog.notes.join("\n"));
  $("notes").hidden = !catalog.notes.length;
  $("no-vehicle").hidden = catalog.vehicle !== null;
  $("presets").replaceChildren(...catalog.presets.map(preset => make("button", { type: "button", "data-preset": preset.name, onclick: () => send({ do: "preset", name: preset.name }) }, named(preset))));
  const has = path => catalog.controls.some(control => control.path === path);
  $("pedals").hidden = !Object.values(PEDALS).some(has);
  buildGears();
  buildGroups($("drive-groups"), DRIVE_GROUPS, "driver");
  buildGroups($("fault-groups"), FAULT_GROUPS, "battery");
  buildTruths();
  if (state) takeState({ ...state, bus: { rows: [], frames: [], skipped: 0 }, tones: [] });
}

function buildGears() {
  const index = catalog.controls.findIndex(control => control.path === GEAR), control = catalog.controls[index];
  $("gears").replaceChildren();
  if (!control) { showGear = () => {}; return; }
  const container = make("div", { class: "segments", role: "radiogroup", "aria-label": word("gear"), "data-path": GEAR });
  $("gears").append(container);
  // As on a lever, whatever the order of the table.
  const order = "PRND", at = entry => { const place = order.indexOf(entry.word); return place < 0 ? order.length : place; };
  const choices = control.words.map((entry, value) => ({ value, entry })).sort((a, b) => at(a.entry) - at(b.entry));
  showGear = segments(container, choices.map(({ value, entry }) => [value, entry.word.length === 1 ? entry.word : named(entry)]), value => set(GEAR, value));
  rows.set(GEAR, { control, index, show: value => showGear(value) });
}

function buildGroups(container, groups, first) {
  const open = stored("open", first + " battery links").split(" ");
  container.replaceChildren(...groups.flatMap(group => {
    const controls = catalog.controls.map((control, index) => ({ control, index }))
      .filter(({ control }) => control.group === group && !Object.values(PEDALS).includes(control.path) && control.path !== GEAR);
    if (!controls.length) return [];
    const badge = make("span", { class: "badge", "data-badge": group });
    const details = make("details", { class: "group", "data-group": group, open: open.includes(group) || group === first,
      ontoggle: () => store("open", [...document.querySelectorAll("details.group[open]")].map(element => element.dataset.group).join(" ")) },
      make("summary", {}, word(group), badge),
      make("div", { class: "group-body" }, ...controls.map(({ control, index }) => buildControl(control, index))));
    return [details];
  }));
  // The pedals' settings have no row, but are set and shown.
  for (const path of Object.values(PEDALS)) {
    const index = catalog.controls.findIndex(control => control.path === path);
    if (index >= 0) rows.set(path, { control: catalog.controls[index], index, show: value => showPedal(path, value) });
  }
}

const BUILDERS = { flag: buildFlag, choice: buildChoice, number: buildNumber };
function buildControl(control, index) {
  const [element, show] = BUILDERS[control.kind](control);
  element.dataset.path = control.path;
  rows.set(control.path, { control, index, element, show });
  return element;
}

function autoButton(control, restore) {
  if (!control.free) return [null, () => {}];
  const button = make("button", { type: "button", class: "auto", "aria-pressed": "true", "aria-label": `${named(control)}: ${word("auto")}`,
    onclick: () => set(control.path, button.getAttribute("aria-pressed") === "true" ? restore() : null) }, word("auto"));
  return [button, value => flag(button, "aria-pressed", value === null)];
}

function buildFlag(control) {
  const input = make("input", { type: "checkbox", role: "switch", onchange: () => set(control.path, input.checked ? 1 : 0) });
  const element = make("label", { class: "switch" }, make("span", { class: "name" }, named(control)), input, make("i"));
  return [element, value => { input.checked = value === 1; }];
}

function buildChoice(control) {
  const [auto, showAuto] = autoButton(control, () => 0);
  const name = make("span", { class: "name" }, named(control));
  const short = control.words.length <= 4 && control.words.map(named).join("").length <= (language === "zh" ? 12 : 20);
  if (short) {
    const container = make("div", { class: "segments", role: "radiogroup", "aria-label": named(control) });
    const show = segments(container, control.words.map((entry, value) => [value, named(entry)]), value => set(control.path, value));
    return [make("div", { class: "control" }, name, make("span", { class: "slot" }, container, ...(auto ? [auto] : []))), value => { show(value); showAuto(value); }];
  }
  const select = make("select", { "aria-label": named(control), onchange: () => set(control.path, Number(select.value)) },
    ...control.words.map((entry, value) => make("option", { value: String(value) }, named(entry))));
  return [make("div", { class: "control" }, name, make("span", { class: "slot" }, select, ...(auto ? [auto] : []))),
    value => { if (value !== null && document.activeElement !== select) select.value = String(value); showAuto(value); }];
}

/** A number is a slider and a box; a code, which has no order, is a box. */
function buildNumber(control) {
  const { min, max, step, unit } = control;
  const isCode = unit === "" && step === 1 && max > 12;
  const digits = Math.max(0, Math.min(4, Math.ceil(-Math.log10(step) - 1e-9)));
  const [auto, showAuto] = autoButton(control, () => min <= 0 && max <= 300 ? Math.max(0, min) : Number(((min + max) / 2).toFixed(digits)));
  const box = make("input", { type: "number", min: String(min), max: String(max), step: "any", placeholder: control.free ? "–" : "", "aria-label": named(control),
    onchange: () => { if (box.value !== "" && box.checkValidity()) set(control.path, Number(box.value)); else notice(`${named(control)}: ${min} … ${max} ${unit}`); } });
  const slider = isCode ? null : make("input", { type: "range", min: String(min), max: String(max), step: String(step), "aria-label": named(control),
    oninput: () => { box.value = Number(slider.value).toFixed(digits); set(control.path, Number(slider.value)); } });
  const element = make("div", { class: "control" + (control.free ? " free" : "") }, make("span", { class: "name" }, named(control)),
    make("span", { class: "slot" }, ...(auto ? [auto] : []), box, make("span", { class: "unit" }, unit)), ...(slider ? [slider] : []));
  return [element, value => {
    showAuto(value);
    element.toggleAttribute("data-auto", value === null);
    if (value === null) { if (document.activeElement !== box) box.value = ""; return; }
    if (document.activeElement !== box) { const text = value.toFixed(digits); if (box.value !== text) box.value = text; }
    if (slider) slider.value = String(value);
  }];
}

// --- settings ------------------------------------------------------------------------------------------------------

function set(path, value) {
  const row = rows.get(path);
  if (!row) return;
  touched.set(path, [performance.now(), value]);
  row.show(value);
  send({ do: "set", path, value });
}
const setting = path => {
  const held = touched.get(path);
  if (held && performance.now() - held[0] < HOLD_MS) return held[1];
  const row = rows.get(path);
  return row && state ? state.settings[row.index] : null;
};

/** Only what stands still by itself can have been changed by hand: switches, choices, codes, and what was left to the vehicle. */
function isChanged(row, value) {
  const before = catalog.initial[row.index] ?? null, { control } = row;
  if (control.free) return (value === null) !== (before === null) || (value !== null && value !== before);
  return (control.kind !== "number" || before === 0) && value !== before;
}

function showSettings() {
  const counts = {};
  for (const [path, row] of rows) {
    const value = setting(path);
    row.show(value);
    const changed = FAULT_GROUPS.includes(row.control.group) && isChanged(row, value);
    if (row.element) row.element.classList.toggle("changed", changed);
    if (changed) counts[row.control.group] = (counts[row.control.group] || 0) + 1;
  }
  for (const badge of document.querySelectorAll("[data-badge]")) {
    const count = counts[badge.dataset.badge] || 0;
    write(badge, count ? `${count} ${word("set")}` : "");
  }
  $("clear").disabled = !Object.keys(counts).length;
}

function clearFaults() {
  for (const [path, row] of rows) {
    if (FAULT_GROUPS.includes(row.control.group) && isChanged(row, setting(path))) set(path, catalog.initial[row.index] ?? null);
  }
}

// --- pedals --------------------------------------------------------------------------------------------------------

const held = { accelerator: 0, brake: 0 };
let pressing = null;
function showPedal(path, value) {
  const id = Object.keys(PEDALS).find(id => PEDALS[id] === path), pedal = $(id);
  pedal.style.setProperty("--level", (value ?? 0) / 100);
  write(pedal.querySelector("b"), Math.round(value ?? 0) + " %");
}
/** A pedal goes down while it is held, and the person takes over from the driver who holds a speed. */
function press(id) {
  if (held[id] || !rows.has(PEDALS[id])) return;
  held[id] = Math.max(setting(PEDALS[id]) || 0, 8);
  if (setting(TARGET) !== null && rows.has(TARGET)) set(TARGET, null);
  set(PEDALS[id], held[id]);
  pressing ??= setInterval(() => {
    for (const id of Object.keys(held)) if (held[id] && held[id] < 100) { held[id] = Math.min(100, held[id] + 6); set(PEDALS[id], held[id]); }
  }, 60);
}
function release(id) {
  if (!held[id]) return;
  held[id] = 0;
  set(PEDALS[id], 0);
  if (!held.accelerator && !held.brake) { clearInterval(pressing); pressing = null; }
}

// --- what happens: several times a second --------------------------------------------------------------------------

function takeState(message) {
  if (!catalog || message.bench !== catalog.bench) return;
  state = message;
  const seconds = message.seconds, minutes = Math.floor(seconds / 60);
  write($("clock"), `${minutes}:${(seconds - minutes * 60).toFixed(2).padStart(5, "0")}`);
  document.body.toggleAttribute("data-paused", message.paused);
  flag($("pause"), "aria-pressed", message.paused);
  write($("factor"), message.factor === 0 ? word("fastest") : message.factor + "×");
  write($("speed"), message.paused ? word("paused") : message.speed.toFixed(2) + "×");
  write($("capability"), message.capability.toFixed(message.capability < 10 ? 1 : 0) + "×");
  write($("backlight"), Math.round(message.backlight * 100) + " %");
  // The eye does not see half the duty as half as bright.
  $("panel").style.filter = message.backlight >= 1 ? "" : `brightness(${Math.sqrt(message.backlight).toFixed(3)})`;
  $("stopped").hidden = !message.stopped;
  write($("stopped"), message.stopped ? word("stopped") + message.stopped : "");
  playTones(message);
  showSettings();
  showValues(message);
  showRecording(message);
  showBus(message);
  showStory(message.playing, message.seconds);
  document.body.dataset.ready = "";
}

function showRecording(message) {
  flag($("record"), "aria-pressed", Boolean(message.recording));
  const length = message.recording;
  write($("record-text"), length ? `${length.seconds.toFixed(0)} s` : word("record"));
  $("record").title = length ? `${length.frames} ${word("frames_in")}` : "";
  const [number, kept] = message.recorded ?? [null, null];
  dismissed ??= number ?? 0;
  const isOffered = kept !== null && number !== dismissed;
  if (isOffered) {
    write($("recorded-length"), `${kept.seconds.toFixed(1)} s · ${kept.frames} ${word("frames_in")}`);
    if (kept.full && $("recorded").hidden) notice(word("full"));
  }
  $("recorded").hidden = !isOffered;
}
function dismissRecording() {
  [dismissed] = state?.recorded ?? [dismissed];
  $("recorded").hidden = true;
}

// --- values --------------------------------------------------------------------------------------------------------

let truthCells = [], shownCells = new Map();
function buildTruths() {
  shownCells = new Map();
  truthCells = catalog.truths.map(truth => {
    const cell = make("td"), shown = make("td");
    if (truth.beside) shownCells.set(truth.beside, shown);
    return { truth, cell, shown, row: make("tr", { "data-path": truth.path, title: truth.path }, make("td", {}, named(truth)), cell, shown) };
  });
  $("truths").replaceChildren(...truthCells.map(({ row }) => row));
  $("shown").replaceChildren(make("div", { id: "telltales" }), make("div", { id: "line" }));
}

function showValues(message) {
  truthCells.forEach(({ truth, cell }, index) => {
    const value = message.truths[index];
    const state = truth.states && catalog.states[truth.states].find(state => state.number === value);
    write(cell, state ? named(state) : truth.states || value === undefined || value === null ? "–" : `${value.toFixed(truth.digits)} ${truth.unit}`.trim());
  });
  for (const [path, text] of message.shown) {
    let cell = shownCells.get(path);
    if (!cell) {
      cell = make("td");
      shownCells.set(path, cell);
      $("truths").append(make("tr", { "data-path": path }, make("td", {}, make("span", { class: "path" }, path)), make("td", { class: "only" }, "–"), cell));
    }
    const state = stateOf(catalog.values[path], text);
    write(cell, state ? named(state) : text);
  }
  const lit = message.telltales.map(([name, colour]) => `${name} ${colour}`).join();
  if ($("telltales").dataset.lit !== lit + language) {
    $("telltales").dataset.lit = lit + language;
    $("telltales").replaceChildren(...(message.telltales.length ? message.telltales.map(([name, colour]) => make("span", { class: "chip " + colour, "data-telltale": name }, named(catalog.telltales.find(it => it.key === name))))
      : [make("span", { class: "fact" }, word("no_telltales"))]));
  }
  const line = message.line, text = line ? `${named(line)}${line.code === null ? "" : " " + line.code}${line.count > 1 ? `  (${line.position}/${line.count})` : ""}` : "";
  write($("line"), text);
  $("line").className = line ? "s" + line.severity : "";
}

// --- a scenario ----------------------------------------------------------------------------------------------------

let storyOf = null;
function showStory(story, seconds) {
  $("story").hidden = !story;
  if (!story) return;
  const checks = story.checks ?? [], found = checks.filter(check => check.found), failed = found.filter(check => !check.found.passed);
  // Built again when the verdict comes in and when the story has come to one more of its checks.
  const state = `${catalog.bench} ${Boolean(story.checks)} ${found.length} ${story.problem}`;
  if (storyOf !== state) {
    storyOf = state;
    write($("story-title"), story.title);
    const lines = [...story.deeds.map(([at, text]) => ({ at, text, sign: "▸", kind: "" })),
      ...checks.map(({ at, expected, found }) => !found ? { at, text: expected, sign: "·", kind: "" }
        : found.passed ? { at, text: expected, sign: "✓", kind: "passed" } : { at, text: `${expected} ≠ ${found.got}`, sign: "✗", kind: "failed" })];
    lines.sort((a, b) => a.at - b.at);
    $("story-list").replaceChildren(...lines.map(({ at, text, sign, kind }) => make("li", { class: kind, "data-at": String(at) }, make("time", {}, at.toFixed(1)), make("i", {}, sign), make("span", {}, text))));
  }
  $("story-progress").value = Math.min(1, seconds / Math.max(story.end, 0.01));
  let last = null;
  for (const line of $("story-list").children) {
    const past = Number(line.dataset.at) <= seconds;
    line.classList.toggle("future", !past);
    if (past) last = line;
  }
  if (last && !$("story-list").contains(document.activeElement)) $("story-list").scrollTop = Math.max(0, last.offsetTop - $("story-list").offsetTop - 120);
  const isWhole = story.checks && found.length === checks.length;
  $("story-verdict").className = "fact" + (failed.length ? " failed" : isWhole ? " passed" : "");
  write($("story-verdict"), story.problem ?? (!story.checks ? word("judging") : failed.length ? `${counted(failed.length, "not_passed")} ${checks.length}`
    : isWhole ? counted(found.length, "all_passed") : `${counted(found.length, "passed_so_far")} ${checks.length}`));
}

// --- the bus -------------------------------------------------------------------------------------------------------

let busRows = new Map(), frameLog = [], messages = new Map(), view = stored("view", "by_id"), frozen = false, chosen = null, skipped = 0;
let showView = () => {};

function resetBus() {
  busRows = new Map(); frameLog = []; chosen = null; skipped = 0;
  messages = new Map(catalog.messages.map(message => [message.id, message]));
  $("decoded").hidden = true;
  buildBus();
}

function buildBus() {
  showView = segments($("view"), [["by_id", word("by_id")], ["stream", word("stream")]], value => { view = value; store("view", view); chosen = null; $("decoded").hidden = true; buildBus(); });
  showView(view);
  const columns = view === "by_id" ? [["id"], ["name"], ["sender"], ["period", "right"], ["data"], ["count", "right count"]] : [["at", "right"], ["id"], ["name"], ["sender"], ["data"]];
  $("columns").replaceChildren(...columns.map(([key, classes = ""]) => make("th", { scope: "col", class: `${classes} ${key}` }, word(key))));
  $("frames").replaceChildren();
  for (const row of busRows.values()) row.element = null;
  if (view === "by_id") placeRows(); else drawStream();
}

const wanted = text => {
  const words = $("filter").value.toLowerCase().split(/\s+/).filter(Boolean);
  return words.every(part => text.includes(part));
};
const haystack = id => { const message = messages.get(id); return `${id} ${message?.name ?? ""} ${message?.sender ?? ""}`.toLowerCase(); };

function bytes(data, hot = 0) {
  const cells = [];
  for (let at = 0; at < data.length; at += 2) cells.push(make("span", { class: hot >> (at / 2) & 1 ? "byte hot" : "byte" }, data.slice(at, at + 2)));
  return cells;
}

function placeRows() {
  const ids = [...busRows.keys()].sort((a, b) => (messages.get(a)?.sender ?? "~").localeCompare(messages.get(b)?.sender ?? "~") || (messages.get(a)?.name ?? a).localeCompare(messages.get(b)?.name ?? b, "en", { numeric: true }));
  $("frames").replaceChildren(...ids.filter(id => wanted(haystack(id))).map(id => {
    const row = busRows.get(id), message = messages.get(id);
    if (!row.element) {
      row.cells = { period: make("td", { class: "right period number" }), data: make("td"), count: make("td", { class: "right count number" }) };
      row.drawn = null;
      row.element = make("tr", { "data-id": id, "data-name": message?.name ?? "", class: row.ours ? "ours" : "", onclick: () => choose(id) },
        make("td", { class: "id" }, id), make("td", {}, message?.name ?? id), make("td", { class: "sender" }, message?.sender ?? "–"), row.cells.period, row.cells.data, row.cells.count);
      drawRow(row);
    }
    row.element.classList.toggle("chosen", id === chosen?.id);
    return row.element;
  }));
}

function drawRow(row) {
  if (!row.element) return;
  const cycle = messages.get(row.id)?.cycle_ms;
  write(row.cells.period, row.period === null ? "–" : `${row.period < 99.5 ? row.period.toFixed(1) : row.period.toFixed(0)} ms`);
  row.cells.period.title = cycle ? `${cycle} ms` : "";
  write(row.cells.count, String(row.count));
  if (row.drawn !== row.data) { row.cells.data.replaceChildren(...bytes(row.data)); row.drawn = row.data; }
  // A byte stays marked for a moment, or nobody sees it.
  const now = performance.now();
  [...row.cells.data.children].forEach((cell, index) => cell.classList.toggle("hot", now - (row.hot[index] ?? -1e9) < 700));
}

function showBus(message) {
  const now = performance.now(), { bus } = message;
  write($("received"), `${message.counts[1]} / ${message.counts[0]}`);
  write($("lost"), String(message.counts[2]));
  $("load").value = message.load; write($("load-text"), Math.round(message.load * 100) + " %");
  const [confinement, transmit, receive] = message.controller;
  write($("controller"), confinement === "error_active" && !transmit && !receive ? "" : `${word("controller")}: ${named(stateOf("confinement", confinement))} · TEC ${transmit} · REC ${receive}`);
  let grown = false;
  for (const [id, count, at, period, data, changed, ours] of bus.rows) {
    let row = busRows.get(id);
    if (!row) { row = { id, hot: [] }; busRows.set(id, row); grown = true; }
    Object.assign(row, { count, at, period, data, ours });
    for (let index = 0; index < 8; index++) if (changed >> index & 1) row.hot[index] = now;
  }
  if (!frozen) {
    skipped = bus.skipped;
    frameLog.push(...bus.frames);
    if (frameLog.length > FRAMES_KEPT) frameLog.splice(0, frameLog.length - FRAMES_KEPT);
    if (view === "by_id") {
      if (grown) placeRows();
      for (const row of busRows.values()) {
        drawRow(row);
        const silence = message.seconds * 1e3 - row.at, cycle = messages.get(row.id)?.cycle_ms || row.period || 0;
        row.element?.classList.toggle("silent", cycle > 0 && silence > Math.max(500, 5 * cycle));
        row.element?.classList.toggle("late", cycle > 0 && row.period > 1.5 * cycle);
      }
    } else if (bus.frames.length) drawStream();
    if (chosen?.live && busRows.has(chosen.id)) decode(chosen.id, busRows.get(chosen.id).data);
  }
}

function drawStream() {
  const fitting = frameLog.filter(([, id]) => wanted(haystack(id)));
  const shown = frozen ? fitting : fitting.slice(-FRAMES_LIVE);
  const list = shown.map(frame => {
    const [at, id, data, ours] = frame, message = messages.get(id);
    return make("tr", { class: (ours ? "ours" : "") + (chosen?.frame === frame ? " chosen" : ""), "data-id": id, "data-name": message?.name ?? "", onclick: () => choose(id, frame) },
      make("td", { class: "right number" }, (at / 1e3).toFixed(4)), make("td", { class: "id" }, id), make("td", {}, message?.name ?? id), make("td", { class: "sender" }, message?.sender ?? "–"), make("td", {}, ...bytes(data)));
  });
  $("frames").replaceChildren(...list.reverse());
  $("rows").dataset.skipped = skipped;
}

/** Shows the signals of an identifier, live, or of one frame. */
function choose(id, frame = null) {
  chosen = { id, frame, live: !frame };
  for (const row of $("frames").children) row.classList.toggle("chosen", frame ? false : row.dataset.id === id);
  if (frame) drawStream();
  decode(id, frame ? frame[2] : busRows.get(id)?.data ?? "");
}

let decoding = false, decodedOf = "";
async function decode(id, data) {
  if (decoding || decodedOf === id + data + language && !$("decoded").hidden) return;
  decoding = true;
  try {
    const known = messages.has(id) && data !== "R";
    const signals = known ? await link.ask(`decode/${id}/${data || "00"}`).then(blob => blob.text()).then(JSON.parse).catch(() => null) : null;
    if (chosen?.id === id) { decodedOf = id + data + language; showDecoded(id, signals); }
  } catch { /* the connection is gone; the page says so */ } finally { decoding = false; }
}

function showDecoded(id, signals) {
  const message = messages.get(id);
  const close = make("button", { type: "button", class: "small", "aria-label": word("close"), onclick: () => { chosen = null; $("decoded").hidden = true; for (const row of $("frames").children) row.classList.remove("chosen"); } }, "✕");
  const body = signals ? make("table", {}, make("tbody", {}, ...signals.map(signal => {
    const number = Number.isInteger(signal.value) ? signal.value : +signal.value.toFixed(4);
    const text = signal.word ? `${signal.word.replaceAll("_", " ")} (${signal.raw})` : `${number} ${signal.unit}`.trim();
    return make("tr", { title: `${word("raw")} ${signal.raw}`, "data-signal": signal.name }, make("td", {}, signal.name.replaceAll("_", " ")), make("td", { class: signal.valid ? "" : "invalid" }, text));
  }))) : make("p", {}, word("unknown_frame"));
  const old = $("decoded").querySelector("tbody");
  if (!$("decoded").hidden && old && signals && old.rows.length === signals.length && $("decoded").dataset.id === id) old.replaceWith(body.firstChild);
  else $("decoded").replaceChildren(make("header", {}, make("b", {}, message?.name ?? id), make("span", { class: "fact" }, message?.cycle_ms ? `${message.cycle_ms} ms` : ""), close), body);
  $("decoded").dataset.id = id;
  $("decoded").hidden = false;
}

function freeze(on) {
  frozen = on;
  flag($("freeze"), "aria-pressed", on);
  if (view === "stream") drawStream();
}

// --- language, tabs, keys ------------------------------------------------------------------------------------------

function translate() {
  $("bezel").dataset.starting = word("starting");
  document.documentElement.lang = language === "zh" ? "zh-CN" : "en";
  document.title = word("title");
  for (const element of document.querySelectorAll("[data-t]")) element.textContent = word(element.dataset.t);
  for (const element of document.querySelectorAll("[data-t-label]")) {
    element.setAttribute("aria-label", word(element.dataset.tLabel));
    if (element.matches("button")) element.title = word(element.dataset.tLabel);
    if (element.matches("input")) element.placeholder = word(element.dataset.tLabel);
  }
  $("language").textContent = language === "zh" ? "English" : "中文";
  $("language").lang = language === "zh" ? "en" : "zh";
  $("tabs").replaceChildren(...TABS.map(tab => make("button", { type: "button", role: "tab", "data-tab": tab, "aria-selected": String(document.body.dataset.tab === tab), onclick: () => showTab(tab) }, word(tab))));
  $("key-list").replaceChildren(...KEYS.flatMap(([keys, text]) => [make("dt", {}, ...keys.map(key => make("kbd", {}, key))), make("dd", {}, pick(text))]));
  build();
  if (catalog) { decodedOf = ""; buildBus(); }
}
function speak(to) { language = to; store("language", to); translate(); }
function showTab(tab) {
  document.body.dataset.tab = tab;
  for (const button of $("tabs").children) flag(button, "aria-selected", button.dataset.tab === tab);
}
function changeFactor(move) {
  if (!state) return;
  const at = FACTORS.indexOf(state.factor), next = FACTORS[Math.max(0, Math.min(FACTORS.length - 1, (at < 0 ? 3 : at) + move))];
  state.factor = next;
  send({ do: "speed", factor: next });
}
const togglePause = () => send({ do: "pause", on: !state?.paused });
const toggleRecord = () => send({ do: "record", on: !state?.recording });
function toggleSound() { audible = !audible; store("sound", audible ? "on" : "off"); flag($("sound"), "aria-pressed", audible); if (audible) wakeAudio(); else quiet(); }
function chooseGear(letter) {
  const control = rows.get(GEAR)?.control, value = control ? control.words.findIndex(entry => entry.word === letter) : -1;
  if (value >= 0) set(GEAR, value);
}
const heldButtons = [false, false];
function hold(index, down) {
  if (heldButtons[index] === down) return;
  heldButtons[index] = down;
  $("button" + index).classList.toggle("down", down);
  send({ do: "button", index, down });
}

const DOWN = {
  ArrowUp: () => press("accelerator"), ArrowDown: () => press("brake"), a: () => hold(0, true), b: () => hold(1, true),
  d: () => chooseGear("D"), n: () => chooseGear("N"), r: () => chooseGear("R"), p: () => chooseGear("P"),
  h: () => rows.has(PARKING_BRAKE) && set(PARKING_BRAKE, setting(PARKING_BRAKE) === 1 ? 0 : 1),
  " ": togglePause, ".": () => send({ do: "step", slices: 1 }), "-": () => changeFactor(-1), "+": () => changeFactor(1), "=": () => changeFactor(1),
  "/": () => { if (innerWidth < 760) showTab("bus"); $("filter").focus(); }, f: () => freeze(!frozen), s: () => $("shot").click(), o: toggleRecord, m: toggleSound,
  l: () => speak(language === "zh" ? "en" : "zh"), "?": () => $("keys").showModal(),
};
for (const digit of [1, 2, 3]) DOWN[digit] = () => $("presets").children[digit - 1]?.click();
const UP = { ArrowUp: () => release("accelerator"), ArrowDown: () => release("brake"), a: () => hold(0, false), b: () => hold(1, false) };
const keyOf = event => event.key.length === 1 ? event.key.toLowerCase() : event.key;

const isModified = event => event.ctrlKey || event.metaKey || event.altKey;
/** Whether a list of choices has dropped down; a browser that cannot tell keeps the keys of one to itself. */
const isOpen = select => CSS.supports("selector(:open)") && select.matches(":open");

/**
 * Whether the focused element needs this key itself. Up and down are the pedals whatever has the focus, but for boxes
 * that one types into and a list of choices that has dropped down; what they would do elsewhere (turn a slider, step
 * through a closed list, scroll), left and right, Page Up and Page Down do.
 */
function isTaken(event) {
  const element = event.target;
  if ($("keys").open || isModified(event)) return true;
  if (element.matches("input[type=number], input[type=search]")) return true;
  if (element.matches("select")) return !event.key.startsWith("Arrow") || isOpen(element);
  if (event.key === " ") return element.matches("button, summary, a, input, [role=group]");
  return false;
}

addEventListener("keydown", event => {
  wakeAudio();
  if (event.target === $("filter") && event.key === "Escape") { $("filter").value = ""; $("filter").dispatchEvent(new Event("input")); $("filter").blur(); return; }
  const action = DOWN[keyOf(event)];
  if (!action || isTaken(event) || (!$("shortcuts").checked && event.key.length === 1)) return;
  event.preventDefault();
  if (!event.repeat) action();
});
addEventListener("keyup", event => UP[keyOf(event)]?.());
addEventListener("blur", () => { for (const release of Object.values(UP)) release(); });
addEventListener("pointerdown", wakeAudio);
addEventListener("resize", fitPanel);
// Whatever takes room from the panel, before it is painted; none of these depends on the panel's own size.
const room = new ResizeObserver(fitPanel);
for (const element of [document.querySelector(".bar"), $("recorded"), $("tabs"), document.querySelector(".under"), $("stopped")]) room.observe(element);

for (const id of Object.keys(PEDALS)) {
  const pedal = $(id);
  pedal.onpointerdown = event => { pedal.setPointerCapture(event.pointerId); press(id); };
  pedal.onpointerup = pedal.onpointercancel = pedal.onlostpointercapture = () => release(id);
  pedal.onkeydown = event => { if ((event.key === " " || event.key === "Enter") && !event.repeat) press(id); };
  pedal.onkeyup = event => { if (event.key === " " || event.key === "Enter") release(id); };
  pedal.onblur = () => release(id);
  pedal.oncontextmenu = event => event.preventDefault();
}
for (const index of [0, 1]) {
  const button = $("button" + index);
  button.onpointerdown = event => { button.setPointerCapture(event.pointerId); hold(index, true); };
  button.onpointerup = button.onpointercancel = button.onlostpointercapture = () => hold(index, false);
  button.onkeydown = event => { if ((event.key === " " || event.key === "Enter") && !event.repeat) { event.preventDefault(); hold(index, true); } };
  button.onkeyup = event => { if (event.key === " " || event.key === "Enter") hold(index, false); };
  button.onblur = () => hold(index, false);
}
$("rows").onkeydown = event => {
  const move = { ArrowRight: 1, ArrowLeft: -1 }[event.key], list = [...$("frames").children];
  if (!move || isModified(event) || !list.length || view !== "by_id") return;
  event.preventDefault();
  const at = list.findIndex(row => row.classList.contains("chosen"));
  const next = list[Math.max(0, Math.min(list.length - 1, at < 0 ? 0 : at + move))];
  next.click(); next.scrollIntoView({ block: "nearest" });
};
$("pause").onclick = togglePause;
$("play").onclick = () => send({ do: "play", name: $("scenario").value });
$("step").onclick = () => send({ do: "step", slices: 1 });
$("slower").onclick = () => changeFactor(-1);
$("faster").onclick = () => changeFactor(1);
$("record").onclick = toggleRecord;
$("dismiss").onclick = dismissRecording;
$("sound").onclick = toggleSound;
$("language").onclick = () => speak(language === "zh" ? "en" : "zh");
$("help").onclick = () => $("keys").showModal();
$("clear").onclick = clearFaults;
$("freeze").onclick = () => freeze(!frozen);
$("filter").oninput = () => { if (view === "by_id") placeRows(); else drawStream(); };
$("size").onchange = () => { store("size", $("size").value); fitPanel(); };
$("size").value = stored("size", "fit");
$("shortcuts").checked = stored("shortcuts", "on") === "on";
$("shortcuts").onchange = () => store("shortcuts", $("shortcuts").checked ? "on" : "off");
document.addEventListener("click", event => { if (!$("shots").contains(event.target) || event.target.matches("a")) $("shots").open = false; });
document.addEventListener("click", event => {
  const kept = event.target.closest?.("a[data-kept]");
  if (!kept) return;
  event.preventDefault();
  keep(kept.getAttribute("href"), kept.download);
});
flag($("sound"), "aria-pressed", audible);
translate();
