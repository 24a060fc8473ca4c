// The pages that are here, each in a slot of one texture, and the table that tells which slot.

const ABSENT = 0xffffffff, FOR_EVER = Infinity;

function makePool({ bytes, pageBytes, budget }) {
  const pages = Math.ceil(bytes / pageBytes), pageWords = pageBytes / 4, { most, PLACES_A_ROW } = device;
  const room = Math.min(budget - 4 * pages, PLACES_A_ROW * most * 4), slots = Math.min(Math.floor(room / pageBytes), pages);
  const tableRows = Math.ceil(pages / PLACES_A_ROW), rows = Math.ceil(slots * pageWords / PLACES_A_ROW);
  const words = device.integers(PLACES_A_ROW, rows, 1);
  const entries = new Uint32Array(PLACES_A_ROW * tableRows).fill(ABSENT), changed = new Set(); // Rows that the device does not have yet.
  const table = device.integers(PLACES_A_ROW, tableRows, 1, entries);
  const slotOf = new Map(), pageOf = new Int32Array(slots).fill(-1), lastUse = new Float64Array(slots);
  const figures = { pages, slots, slotBytes: slots * pageBytes, tableBytes: 4 * PLACES_A_ROW * tableRows, read: 0, bytes: 0, gone: 0, rounds: 0 };

  const enter = (page, slot) => {
    entries[page] = slot;
    changed.add(Math.floor(page / PLACES_A_ROW));
  };

  // The slot that was used least recently goes.
  function leastUsed() {
    let least = 0;
    for (let slot = 1; slot < slots; slot++) if (lastUse[slot] < lastUse[least]) least = slot;
    return least;
  }

  return {
    figures,
    has: page => slotOf.has(page),
    hasRoom: () => slotOf.size < slots,
    // How many pages can come without any going that this round has used.
    room: () => lastUse.reduce((count, use) => count + (use < figures.rounds), 0),
    // Tells of a round which pages it has used.
    note(used) {
      figures.rounds++;
      for (const page of used) {
        const slot = slotOf.get(page);
        if (slot !== undefined) lastUse[slot] = Math.max(lastUse[slot], figures.rounds);
      }
    },
    place(page, contents) {
      const slot = slotOf.size < slots ? slotOf.size : leastUsed();
      if (pageOf[slot] >= 0) {
        slotOf.delete(pageOf[slot]);
        enter(pageOf[slot], ABSENT);
        figures.gone++;
      }
      const first = slot * pageWords, width = Math.min(pageWords, PLACES_A_ROW);
      let whole = contents;
      if (contents.length < pageWords) (whole = new Uint32Array(pageWords)).set(contents);
      device.write(words, first % PLACES_A_ROW, Math.floor(first / PLACES_A_ROW), width, pageWords / width, 1, whole);
      slotOf.set(page, slot);
      pageOf[slot] = page;
      lastUse[slot] = page ? figures.rounds : FOR_EVER; // Every ray begins in page 0.
      enter(page, slot);
      figures.read++;
    },
    bind(program) {
      for (const row of changed) device.write(table, 0, row, PLACES_A_ROW, 1, 1, entries.subarray(PLACES_A_ROW * row, PLACES_A_ROW * (row + 1)));
      changed.clear();
      return program.take({ words, page_table: table });
    },
  };
}
