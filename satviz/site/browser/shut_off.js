// What a worker that runs a reader's code must not have: the network, what the site keeps, other workers, and what a
// loop could fill, the browser's console and the way to the page.  The answers go by a way that is kept before.
// The function stands alone, since its text is put before the reader's JavaScript.

export function shutOff() {
  const names = ["fetch", "XMLHttpRequest", "WebSocket", "WebSocketStream", "WebTransport", "EventSource", "importScripts", "caches", "indexedDB", "Worker", "SharedWorker", "BroadcastChannel", "RTCPeerConnection", "Notification", "FileReaderSync", "cookieStore", "FontFace", "fonts", "webkitRequestFileSystem", "webkitRequestFileSystemSync", "webkitResolveLocalFileSystemURL", "webkitResolveLocalFileSystemSyncURL", "postMessage", "close"];
  for (const name of names) {
    for (let owner = self; owner; owner = Object.getPrototypeOf(owner)) Reflect.deleteProperty(owner, name);
  }
  for (let owner = Object.getPrototypeOf(self.navigator); owner && owner !== Object.prototype; owner = Object.getPrototypeOf(owner)) {
    for (const name of ["sendBeacon", "storage", "serviceWorker", "locks", "storageBuckets", "usb", "serial", "hid", "gpu"]) Reflect.deleteProperty(owner, name);
  }
  for (const name of Object.keys(console)) Object.assign(console, { [name]() {} });
  Object.assign(self, {
    close() {
      throw new Error("the function ends the program by itself");
    },
  });
}
