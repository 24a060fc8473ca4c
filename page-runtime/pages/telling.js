// What the page says of its pages, and when which picture was there.

const moments = {};
const noteMoment = name => moments[name] ??= Math.round(performance.now());
const megabytes = bytes => (bytes / 1e6).toFixed(1) + " MB";

function tellPages(film) {
  const { figures } = volume, { pages, read, bytes, gone, slots } = figures;
  element("pages").textContent = `${english(read)} of ${english(pages)} read, ${megabytes(bytes)}; ` +
    `${english(read - gone)} here, room for ${english(slots)}`;
  const isAll = film.width === canvas.width && film.height === canvas.height;
  if (read) noteMoment("first");
  if (film.passes) noteMoment("coarse");
  if (film.passes && isAll) noteMoment("fine");
  if (film.samples && isAll) noteMoment("lit");
  if (!film.isWhole && element("status").textContent === scene.wait) element("status").textContent = "Reading pages …";
  document.documentElement.dataset.pages = JSON.stringify({ ...figures, moments, waits: !film.isWhole });
}
