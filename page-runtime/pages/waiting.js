// Pixels that wait for pages.

// What the pixels of a film tell of pages, four words for a square of them.
async function feedbackOf(programs, film) {
  const { width, height } = film, [wide, high] = [Math.ceil(width / 4), Math.ceil(height / 4)];
  film.squares ??= device.integers(wide, high, 4);
  film.feedback ??= device.targetOf(film.squares);
  programs.collect.take({ told: film.told() }).give({ turn: film.turn, number: volume.figures.rounds }).draw(film.feedback);
  return device.contentsOf(film.feedback);
}

// Whether pixels of a film have to be traced once more. Pages that they lack are read; of more than there is room for, only those for which
// half of the pixels ask, and the other half waits for its turn.
async function hasToGoOn(programs, film, isStale) {
  const asked = volume.sorted(await feedbackOf(programs, film)), { turn } = film, count = turn[1] - turn[0], all = film.width * film.height;
  film.isAgain = true;
  if (asked.size && (count === 1 || !volume.areTooMany(asked))) {
    await volume.bring(asked, count === 1, isStale);
    return true;
  }
  volume.beginGroup();
  if (asked.size) film.turn = [turn[0], turn[0] + Math.ceil(count / 2)];
  else if (turn[1] < all) film.turn = [turn[1], Math.min(turn[1] + 2 * count, all)];
  else film.turn = [0, all];
  return film.isAgain = asked.size > 0 || turn[1] < all;
}
