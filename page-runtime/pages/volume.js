// A volume of which some pages are here: who lacks one waits, the page is read, and who waited is traced again.

const WAITS = 0x80000000, NO_PAGE = 0x7fffffff, PATIENCE_ROUNDS = 64, LATENCY_MILLISECONDS = 120;

const volume = (() => {
  const told = scene.volume, url = new URL(told.name, document.baseURI), pageWords = told.pageBytes / 4;
  if (url.protocol === "file:")
    throw new Error(`browsers let no page read files beside it: have a server that answers HTTP range requests serve this folder, ` +
      `such as busybox httpd -f -p 8000, and open http://localhost:8000/${location.pathname.split("/").pop()}`);
  const pool = makePool(told), { figures } = pool;
  if (figures.slots < 2) throw new Error(`this device has no room for pages of ${told.pageBytes} bytes`);
  let page = 0, lonely = 0, problem = "", arrived = () => {};
  const likely = told.first.map(step => page += step); // What the first picture looks at, most important first.
  const wanted = new Set();

  const code = `${makeXxh3}\n${makeZstd}\n${readPages}\nlet want; onmessage = ({ data }) =>
    data.wanted ? want(data.wanted) : want = readPages(data, makeXxh3(), makeZstd());`;
  const reader = new Worker(URL.createObjectURL(new Blob([code], { type: "text/javascript" })));
  reader.onmessage = ({ data }) => {
    if (data.problem) problem ||= data.problem;
    else {
      figures.bytes += data.bytes;
      if (!pool.has(data.page) && (wanted.has(data.page) || pool.hasRoom())) pool.place(data.page, data.words);
      wanted.delete(data.page);
    }
    arrived();
  };
  reader.onerror = event => { problem ||= event.message || "the reader of pages cannot be started"; arrived(); };
  const ask = pages => {
    wanted.clear();
    for (const page of pages) wanted.add(page);
    const others = likely.filter(page => !pool.has(page) && !wanted.has(page));
    reader.postMessage({ wanted: [...wanted].sort((a, b) => a - b).concat(pool.hasRoom() ? others : []) });
  };
  reader.postMessage({ ...told, url: url.href, first: [] });
  ask([]);

  const check = () => { if (problem) throw new Error(problem); };
  // Until all that is wanted has come, or some of it and a while has gone by.
  async function some(isStale) {
    const before = figures.read, begin = performance.now();
    while (wanted.size && !isStale() && !(figures.read > before && performance.now() - begin > LATENCY_MILLISECONDS)) {
      await Promise.race([new Promise(done => arrived = done), sleep(20)]);
      check();
    }
  }

  // What words of feedback say: the pages that are lacking, and those that were used.
  function sorted(feedback, stride = 1, from = 0) {
    const asked = new Set(), used = new Set();
    for (let i = from; i < feedback.length; i += stride)
      if (feedback[i] !== NO_PAGE) feedback[i] >= WAITS ? asked.add(feedback[i] - WAITS) : used.add(feedback[i]);
    pool.note(used);
    return asked;
  }

  return {
    isStreamed: true, figures, bind: pool.bind, sorted, room: pool.room,
    prelude: shaders["pages.glsl"].replace("PAGES_HERE", `const uint PAGES = ${figures.pages}u, LOG2_PAGE_WORDS = ${Math.log2(pageWords)}u;`),
    // Has pages read that are lacking; `isAlone`: a single pixel or ray lacks them.
    async bring(pages, isAlone, isStale = () => false) {
      lonely = isAlone ? lonely + 1 : 0;
      if (lonely > PATIENCE_ROUNDS + 2 * figures.slots)
        throw new Error(`a pixel needs more pages at once than the ${figures.slots} that have room: export the page with more --device-memory`);
      check();
      ask([...pages].filter(page => !pool.has(page)));
      await some(isStale);
    },
  };
})();
