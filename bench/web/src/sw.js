// Keeps the parts of this site, so that it opens without a network. A new build has another name and replaces them.
"use strict";
const KEPT = "bench-BUILD";
const PARTS = ["./", "worker.js", "bench.wasm", "cluster.bin", "city.log"];
addEventListener("install", event => event.waitUntil(caches.open(KEPT).then(cache => cache.addAll(PARTS)).then(() => skipWaiting())));
addEventListener("activate", event => event.waitUntil(caches.keys().then(names => Promise.all(names.filter(name => name !== KEPT && name.startsWith("bench-")).map(name => caches.delete(name))))));
addEventListener("fetch", event => event.respondWith(caches.match(event.request, { ignoreSearch: true }).then(kept => kept ?? fetch(event.request))));
