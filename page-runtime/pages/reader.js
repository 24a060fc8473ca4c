// Reads a volume by ranges of bytes, and hands its pages on: in a worker, which is told what is wanted.
function readPages(volume, digest, unzstd) {
  const { url, name, headBytes, fileBytes, checksum, pageBytes, bytes } = volume;
  const REQUESTS = 6, MOST_BYTES = 1 << 18, GAP_BYTES = 1 << 14, TRIES = 3, SILENCE_MILLISECONDS = 30000;
  const sleep = milliseconds => new Promise(done => setTimeout(done, milliseconds));
  const pages = Math.ceil(bytes / pageBytes), ends = new Float64Array(pages + 1), sums = new BigUint64Array(pages);
  const onTheirWay = new Set();
  let queue = [], requests = 0, mostGap = GAP_BYTES, isOpen = false;

  // The bytes of an answer; `heard` is called whenever some have come.
  async function bytesOf(told, heard) {
    const pieces = [], stream = told.body.getReader();
    for (let piece; !(piece = await stream.read()).done; heard()) pieces.push(piece.value);
    return new Uint8Array(await new Blob(pieces).arrayBuffer());
  }

  // The head of an answer and, of a part, its bytes, on whose way a line can break too. A server that says nothing for a while has ended.
  async function answer(from, to) {
    for (let left = TRIES; ; left--) {
      const ending = new AbortController();
      let clock;
      const heard = () => {
        clearTimeout(clock);
        clock = setTimeout(() => ending.abort(), SILENCE_MILLISECONDS);
      };
      try {
        heard();
        const told = await fetch(url, { headers: { Range: `bytes=${from}-${to - 1}` }, cache: "no-store", signal: ending.signal });
        return [told, told.status === 206 ? await bytesOf(told, heard) : []];
      } catch (problem) {
        if (left <= 1) throw new Error(`${name} cannot be read at ${url}: there is no such server, it is down, or it does not let this page read from it`);
        await sleep(500);
      } finally {
        clearTimeout(clock);
      }
    }
  }

  async function range(from, to) {
    const [told, read] = await answer(from, to), total = Number((told.headers.get("Content-Range") || "").split("/")[1]);
    if (told.status === 200) {
      told.body?.cancel();
      throw new Error(`the server sends the whole of ${name} where a part of it was asked for: put it on a server that answers HTTP range requests`);
    }
    if (told.status !== 206 && told.status !== 416) throw new Error(`${name} cannot be read: the server answers ${told.status} ${told.statusText}`);
    if (total && total !== fileBytes)
      throw new Error(`${name} has ${total} bytes, and the volume of this page has ${fileBytes}: it was cut short, or is another`);
    if (read.length !== to - from) throw new Error(`${name} is cut short: of its bytes ${from} to ${to - 1} there are ${read.length}`);
    return read;
  }

  // The head, which tells where each page ends, and the checksum of each.
  async function open() {
    const head = await range(0, headBytes), view = new DataView(head.buffer), others = new Uint8Array(headBytes - 8);
    others.set(head.subarray(0, 16));
    others.set(head.subarray(24), 16);
    if (view.getBigUint64(16, true) !== BigInt(checksum))
      throw new Error(`${name} is not the volume that this page was made of, or has changed since: export the page again`);
    if (digest(others) !== BigInt(checksum)) throw new Error(`${name} is damaged: its checksum does not match its head`);
    const HEADER = 168, ROW = 56, OFFSET = 48;
    ends[0] = Number(view.getBigUint64(HEADER + OFFSET, true));
    const tables = HEADER + ROW * view.getUint32(68, true) + view.getUint32(60, true) + view.getUint32(64, true);
    for (let page = 0; page < pages; page++) {
      ends[page + 1] = Number(view.getBigUint64(tables + 16 * page, true));
      sums[page] = view.getBigUint64(tables + 16 * page + 8, true);
    }
    isOpen = true;
  }

  function wordsOf(stored, page) {
    const size = Math.min(pageBytes, bytes - page * pageBytes), words = new Uint32Array(size / 4);
    if (digest(stored) !== sums[page])
      throw new Error(`page ${page} of ${name} is not what was stored: it is damaged, or has changed while it was read`);
    if (stored.length === size) {
      new Uint8Array(words.buffer).set(stored);
    } else {
      const planes = unzstd(stored, size), count = words.length; // All lowest bytes, then all second ones, and so on.
      for (let i = 0; i < count; i++)
        words[i] = planes[i] | planes[count + i] << 8 | planes[2 * count + i] << 16 | planes[3 * count + i] << 24;
    }
    return words;
  }

  // Takes pages that follow each other out of the queue, with those in small gaps between them.
  function nextRun() {
    const wanted = new Set(queue), first = queue[0];
    let last = first;
    for (let page = first + 1; page < pages && !onTheirWay.has(page) && ends[page + 1] - ends[first] <= MOST_BYTES; page++)
      if (wanted.has(page)) last = page;
      else if (ends[page + 1] - ends[last + 1] > mostGap) break;
    queue = queue.filter(page => page < first || page > last);
    return [first, last];
  }

  async function readRun([first, last]) {
    for (let page = first; page <= last; page++) onTheirWay.add(page);
    const stored = await range(ends[first], ends[last + 1]);
    const run = [];
    for (let page = first; page <= last; page++) {
      run.push({ page, words: wordsOf(stored.slice(ends[page] - ends[first], ends[page + 1] - ends[first]), page) });
      onTheirWay.delete(page);
    }
    postMessage({ run, bytes: stored.length }, run.map(({ words }) => words.buffer));
  }

  const fail = problem => postMessage({ problem: problem.message || String(problem) });
  function goOn() {
    for (; isOpen && requests < REQUESTS && queue.length; requests++)
      readRun(nextRun()).then(() => { requests--; goOn(); }, fail);
  }

  open().then(goOn, fail);
  // From now on these pages are wanted, the first ones most; there is room for others, or not.
  return (wanted, hasRoom) => {
    mostGap = hasRoom ? GAP_BYTES : 0;
    queue = wanted.filter(page => !onTheirWay.has(page));
    goOn();
  };
}
