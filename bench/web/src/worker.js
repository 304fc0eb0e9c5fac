// Drives the module: turns of the session, what it tells, what it is asked. One module, one session or one judge.
"use strict";

const SLICES_MS = 8;
let wasm, timer, going = false;
const encoder = new TextEncoder(), decoder = new TextDecoder();
// A message to oneself comes at once, a timer after 4 ms.
const soon = new MessageChannel();
soon.port1.onmessage = () => work();

/** Puts the argument of the next call into the module. */
function put(...parts) {
  const bytes = parts.map(part => typeof part === "string" ? encoder.encode(part) : new Uint8Array(part));
  let at = wasm.inbox(bytes.reduce((sum, part) => sum + part.length, 0));
  for (const part of bytes) { new Uint8Array(wasm.memory.buffer, at, part.length).set(part); at += part.length; }
}

/** Copies the answer of the last call out of the module. */
const take = () => new Uint8Array(wasm.memory.buffer, wasm.outbox(), wasm.outbox_len()).slice();
const ZERO = new Uint8Array(1);

function tell() {
  for (let kind; (kind = wasm.next());) {
    const bytes = take();
    if (kind === 1) postMessage({ text: decoder.decode(bytes) });
    else if (kind === 2) postMessage({ picture: [wasm.width(), bytes.buffer] }, [bytes.buffer]);
    else {
      const number = wasm.number(), name = decoder.decode(bytes);
      wasm.flash();
      const flash = take().buffer;
      postMessage({ judge: [number, name, flash] }, [flash]);
    }
  }
}

function work() {
  if (!going) return;
  const started = performance.now();
  let nap = 0;
  while (nap === 0 && performance.now() - started < SLICES_MS) nap = wasm.turn();
  tell();
  if (nap === 0) soon.port2.postMessage(0);
  else timer = setTimeout(work, nap);
}

const OBEY = {
  async boot({ module, flash, log }) {
    let why = "";
    const host = {
      now: () => performance.now(),
      complain: (at, bytes) => { why = decoder.decode(new Uint8Array(wasm.memory.buffer, at, bytes).slice()); postMessage({ problem: why }); },
    };
    wasm = (await WebAssembly.instantiate(module, { host })).exports;
    put(flash); wasm.take_flash();
    if (log) { put(log[0], ZERO, log[1]); wasm.take_log(); }
    postMessage({ open: true });
  },
  go() {
    if (!wasm.open()) { postMessage({ problem: decoder.decode(take()) }); return; }
    going = true;
    work();
  },
  command(text) { put(text); wasm.command(); wake(); },
  ask([number, path]) { put(path); answer(number, wasm.ask()); },
  drop([number, name, bytes]) { put(name, ZERO, bytes); answer(number, wasm.drop_file()); wake(); },
  judge([number, name]) { put(name); wasm.judge(); postMessage({ judged: [number, decoder.decode(take())] }); },
  judged([number, text]) { put(text); wasm.judged(number); },
};

function answer(number, isOk) {
  const bytes = take();
  postMessage({ answer: [number, isOk === 1, bytes.buffer] }, [bytes.buffer]);
}

/** A command is not to wait for the end of a nap. */
function wake() { clearTimeout(timer); soon.port2.postMessage(0); }

onmessage = ({ data }) => {
  const [what] = Object.keys(data);
  OBEY[what](data[what]);
};
