// Runs the module of a site in Node: node measure.mjs FOLDER VEHICLE SECONDS prints the numbers of a drive, then how
// many milliseconds it took.
import { readFileSync } from "node:fs";
import { join } from "node:path";

const [folder, vehicle, seconds] = process.argv.slice(2);
let wasm;
const text = (at, bytes) => new TextDecoder().decode(new Uint8Array(wasm.memory.buffer, at, bytes).slice());
const host = { now: () => performance.now(), complain: (at, bytes) => console.error(text(at, bytes)) };
wasm = (await WebAssembly.instantiate(readFileSync(join(folder, "bench.wasm")), { host })).instance.exports;
const put = bytes => {
  // Room first: it may make the memory another one.
  const at = wasm.inbox(bytes.length);
  new Uint8Array(wasm.memory.buffer, at, bytes.length).set(bytes);
};
put(readFileSync(join(folder, "cluster.bin"))); wasm.take_flash();
put(new TextEncoder().encode(vehicle));
const started = performance.now();
const isOk = wasm.measure(Number(seconds));
const took = performance.now() - started;
console.log(text(wasm.outbox(), wasm.outbox_len()));
console.log(took);
process.exit(isOk ? 0 : 1);
