// The session runs in a Worker of this browser: nothing is asked of a server but the parts of this page, nothing is sent.

/** One part of the page, out of this file if it is in it, else from beside it. */
async function part(name) {
  const inside = document.getElementById("part:" + name);
  if (!inside) {
    const answer = await fetch(name);
    if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
    return answer.arrayBuffer();
  }
  const packed = Uint8Array.from(atob(inside.textContent), letter => letter.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

function openLink({ onOpen, onText, onPicture, onClose }) {
  const asked = new Map();
  let worker, judge, parts, number = 0;

  /** A Worker with the module and an image of the firmware. */
  const start = async (flash, log) => {
    const worker = new Worker(parts.script);
    worker.onerror = event => { event.preventDefault(); fail(event.message); };
    worker.postMessage({ boot: { module: parts.module, flash, log } });
    return worker;
  };
  const load = async () => {
    const [script, module, flash, log] = await Promise.all(["worker.js", "bench.wasm", "cluster.bin", "city.log"].map(part));
    const url = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    parts = { script: url, module: await WebAssembly.compile(module), flash, log: ["city.log", log] };
  };
  const open = async () => {
    try {
      if (!parts) await load();
      worker = await start(parts.flash, parts.log);
    } catch (error) { onClose(String(error.message || error)); return; }
    worker.onmessage = async ({ data }) => {
      if (data.open) { worker.postMessage({ go: true }); onOpen(); }
      else if (data.text) onText(data.text);
      else if (data.picture) onPicture(new ImageData(new Uint8ClampedArray(data.picture[1]), data.picture[0]));
      else if (data.answer) {
        const [number, isOk, bytes] = data.answer, { done, failed } = asked.get(number);
        asked.delete(number);
        if (isOk) done(new Blob([bytes])); else failed(new Error(new TextDecoder().decode(bytes)));
      } else if (data.judge) {
        // Nobody waits for the scenario before.
        judge?.terminate();
        const [number, name, flash] = data.judge, own = judge = await start(flash);
        own.onmessage = ({ data }) => {
          if (data.open) own.postMessage({ judge: [number, name] });
          else if (data.judged) { worker.postMessage({ judged: data.judged }); own.terminate(); }
        };
      } else if (data.problem) fail(data.problem);
    };
  };
  /** Ends the Worker, which cannot go on. */
  const fail = why => { worker?.terminate(); onClose(why); };
  const request = message => new Promise((done, failed) => {
    asked.set(++number, { done, failed });
    worker.postMessage(message(number));
  });
  if (navigator.serviceWorker && location.protocol.startsWith("http")) navigator.serviceWorker.register("sw.js").catch(() => {});
  // Whoever is called is defined by then.
  setTimeout(open);
  return {
    send(text) { worker?.postMessage({ command: text }); },
    ask: path => request(number => ({ ask: [number, path] })),
    fail,
    /** Begins again, after the Worker has ended. */
    restart() { worker?.terminate(); judge?.terminate(); open(); },
    /** Says what a file is, as JSON; the bench goes on with it. */
    async drop(file) {
      const bytes = await file.arrayBuffer();
      return (await request(number => ({ drop: [number, file.name, bytes] }))).text();
    },
  };
}
