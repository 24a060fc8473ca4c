// Begins to read pages before anything else: what the first picture looks at, most important first.

// A server is never told what stands behind a #, so one in an address is of a file's name.
const pageOfHere = location.pathname.split("/").pop(), volumeUrl = new URL(scene.volume.name.replaceAll("#", "%23"), document.baseURI);
if (volumeUrl.protocol === "file:")
  throw new Error(`browsers let no page read files beside it: have a server that answers HTTP range requests serve this folder, such as ` +
    `busybox httpd -f -p 8000, and open http://localhost:8000/${pageOfHere}`);
let likelyPage = 0;
const likely = scene.volume.first.map(step => likelyPage += step);
const reader = new Worker(URL.createObjectURL(new Blob([`${makeXxh3}\n${makeZstd}\n${readPages}\nlet want; onmessage = ({ data }) =>
  data.wanted ? want(data.wanted, data.hasRoom) : want = readPages(data, makeXxh3(), makeZstd()); postMessage({})`], { type: "text/javascript" })));
reader.postMessage({ ...scene.volume, url: volumeUrl.href, first: [] });
reader.postMessage({ wanted: likely, hasRoom: true });
// What comes next holds up this thread, and with it the beginning of the other.
await new Promise(done => reader.onmessage = reader.onerror = done);
