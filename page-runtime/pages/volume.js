// A volume of which some pages are here: who lacks one waits, the page is read, and who waited is traced again.

const WAITS = 0x80000000, NO_PAGE = 0x7fffffff, PATIENCE_ROUNDS = 64, LATENCY_MILLISECONDS = 120;

function makeVolume() {
  const { volume: told } = scene, pageWords = told.pageBytes / 4;
  const pool = makePool(told), { figures } = pool;
  if (figures.slots < Math.min(2, figures.pages)) throw new Error(`this device has no room for pages of ${told.pageBytes} bytes`);
  let lonely = 0, brought = 0, problem = "", arrived = () => {};
  const wanted = new Set();

  reader.onmessage = ({ data }) => {
    if (data.problem) problem ||= data.problem;
    else {
      figures.bytes += data.bytes || 0;
      for (const { page, words } of data.run || []) {
        if (!pool.has(page) && (wanted.has(page) || pool.hasRoom())) pool.place(page, words);
        wanted.delete(page);
      }
    }
    arrived();
  };
  reader.onerror = event => { problem ||= event.message || "the reader of pages cannot be started"; arrived(); };
  const ask = pages => {
    wanted.clear();
    for (const page of pages) wanted.add(page);
    const hasRoom = pool.hasRoom(), others = hasRoom ? likely.filter(page => !pool.has(page) && !wanted.has(page)) : [];
    reader.postMessage({ wanted: [...wanted].sort((a, b) => a - b).concat(others), hasRoom });
  };
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
    isStreamed: true, figures, bind: pool.bind, sorted,
    textures: ["words", "page_table", "before_told"],
    constants: `const uint PAGES = ${figures.pages}u, LOG2_PAGE_WORDS = ${Math.log2(pageWords)}u;\n`,
    // Pixels or rays that go on together; fewer of them do where they would take each other's pages away: where more were read than there is
    // room for.
    beginGroup() { brought = 0; },
    areTooMany: pages => pages.size > pool.room() || brought + pages.size > figures.slots,
    // Has pages read that are lacking; `isAlone`: a single pixel or ray lacks them.
    async bring(pages, isAlone, isStale = () => false) {
      lonely = isAlone ? lonely + 1 : 0;
      brought += pages.size;
      if (lonely > PATIENCE_ROUNDS + 2 * figures.slots)
        throw new Error(`a pixel needs more pages at once than the ${figures.slots} that have room: export the page with more --device-memory`);
      check();
      ask([...pages].filter(page => !pool.has(page)));
      await some(isStale);
    },
  };
}
