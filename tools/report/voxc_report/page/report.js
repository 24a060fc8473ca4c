// What the page can do beyond being read: figures of a point beside it, one format in all charts, a table that can be sorted
// and searched.
"use strict";

(() => {
  const tip = document.getElementById("tip");

  // Points: a link each. Of a chart that is drawn for several widths one drawing has the points' figures, as lines of their titles.
  const points = [...document.querySelectorAll(".point")];
  const notes = new Map();

  function takeNotes(figure) {
    const titles = new Map([...figure.querySelectorAll(".point title")].map(title => [title.parentNode.getAttribute("href"), title]));
    for (const point of figure.querySelectorAll(".point")) {
      const text = titles.get(point.getAttribute("href")).textContent;
      notes.set(point, text.split("\n"));
      point.setAttribute("aria-label", text.replaceAll("\n", "; "));
    }
    for (const title of titles.values())
      title.remove(); // The browser would show it too.
  }

  function fillTip(lines) {
    tip.replaceChildren(...lines.map((line, i) => {
      const element = document.createElement(i === 0 ? "b" : "span");
      element.textContent = line;
      return element;
    }));
  }

  const boxOf = point => point.querySelector("use").getBoundingClientRect();

  function middleOf(point) {
    const box = boxOf(point);
    return {x: box.left + box.width / 2, y: box.top + box.height / 2};
  }

  // Above the point if there is room, else below; never beyond the window.
  function placeTip(point) {
    const mark = boxOf(point), gap = 12, edge = 8;
    const above = mark.top - tip.offsetHeight - gap;
    const left = mark.left + mark.width / 2 - tip.offsetWidth / 2;
    tip.style.top = `${above > edge ? above : mark.bottom + gap}px`;
    tip.style.left = `${Math.max(edge, Math.min(left, innerWidth - tip.offsetWidth - edge))}px`;
  }

  let shown = null;

  function show(point) {
    if (point === shown)
      return;
    shown = point;
    for (const other of points)
      other.classList.toggle("same", other.dataset.variant === point.dataset.variant);
    document.body.classList.add("pointing");
    fillTip(notes.get(point));
    tip.hidden = false;
    placeTip(point);
  }

  function hide() {
    shown = null;
    tip.hidden = true;
    document.body.classList.remove("pointing");
    for (const point of points)
      point.classList.remove("same");
  }

  // The point of a chart that is nearest to a place of the window, if any is near.
  function nearest(points, x, y) {
    const reach = 60;
    let best = null, least = reach * reach;
    for (const point of points) {
      const middle = middleOf(point), distance = (middle.x - x) ** 2 + (middle.y - y) ** 2;
      if (distance < least)
        [best, least] = [point, distance];
    }
    return best;
  }

  // A chart is one stop of the tab key; the arrows go through its points from left to right. A tap shows a point's
  // figures, and another one on the same point follows it.
  function makeChart(chart) {
    const own = [...chart.querySelectorAll(".point")];
    const place = axis => point => point.querySelector("use")[axis].baseVal.valueInSpecifiedUnits;
    const order = [...own].sort((a, b) => place("x")(a) - place("x")(b) || place("y")(b) - place("y")(a));
    const start = order.find(point => point.classList.contains("on")) ?? order[0];
    for (const point of own)
      point.tabIndex = point === start ? 0 : -1;

    const pointAt = event => {
      const point = nearest(own, event.clientX, event.clientY);
      point ? show(point) : hide();
    };
    let before = null;
    chart.addEventListener("pointerdown", event => {
      before = event.pointerType === "mouse" ? nearest(own, event.clientX, event.clientY) : shown;
      pointAt(event);
    });
    chart.addEventListener("pointermove", pointAt);
    chart.addEventListener("pointerleave", event => event.pointerType === "mouse" && hide());
    chart.addEventListener("click", event => {
      if (event.detail === 0)
        return; // The return key, on the point that has the focus.
      event.preventDefault();
      if (shown && shown === before)
        location.hash = shown.getAttribute("href");
    });
    chart.addEventListener("keydown", event => {
      const step = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1}[event.key];
      const next = step && order[order.indexOf(document.activeElement) + step];
      if (step)
        event.preventDefault();
      if (next)
        next.focus();
    });
  }

  document.querySelectorAll("figure.stage").forEach(takeNotes);
  for (const point of points) {
    point.addEventListener("focus", () => point.matches(":focus-visible") && show(point));
    point.addEventListener("blur", hide);
  }
  document.querySelectorAll(".chart").forEach(makeChart);
  addEventListener("keydown", event => event.key === "Escape" && hide());
  // The tab key may scroll to a point after it is shown.
  addEventListener("scroll", () => shown && placeTip(shown), {passive: true});

  // Tables: headings become buttons; what has no figure stays last in either direction.
  function compare(a, b, isNumber, sign) {
    if (a === "" || b === "")
      return (a === "") - (b === "");
    return sign * (isNumber ? parseFloat(a.replaceAll(",", "")) - parseFloat(b.replaceAll(",", "")) : a.localeCompare(b, "en", {numeric: true}));
  }

  function sort(table, heading) {
    const column = heading.cellIndex;
    const order = heading.getAttribute("aria-sort") === "ascending" ? "descending" : "ascending";
    for (const other of table.tHead.rows[0].cells)
      other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", order);
    const isNumber = heading.classList.contains("n"), sign = order === "ascending" ? 1 : -1;
    const keys = new Map([...table.tBodies[0].rows].map(row => [row, row.cells[column].textContent]));
    table.tBodies[0].append(...[...keys.keys()].sort((a, b) => compare(keys.get(a), keys.get(b), isNumber, sign)));
  }

  function makeSortable(table) {
    for (const heading of table.tHead.rows[0].cells) {
      const button = document.createElement("button");
      button.type = "button";
      button.append(...heading.childNodes);
      heading.append(button);
      button.addEventListener("click", () => sort(table, heading));
    }
  }

  // Rows that hold all words that are looked for.
  function makeFinder(table) {
    const finder = document.createElement("label"), input = document.createElement("input"), count = document.createElement("span");
    finder.className = "finder";
    input.type = "search";
    input.placeholder = "Find: a model, a format, a device…";
    input.setAttribute("aria-label", "Find rows");
    count.setAttribute("aria-live", "polite");
    finder.append(input, count);
    table.closest(".scroll").before(finder);
    const rows = [...table.tBodies[0].rows];
    const find = () => {
      const words = input.value.toLowerCase().split(/\s+/);
      for (const row of rows)
        row.hidden = !words.every(word => row.textContent.toLowerCase().includes(word));
      count.textContent = `${rows.filter(row => !row.hidden).length} of ${rows.length} rows`;
    };
    input.addEventListener("input", find);
    find();
    // A point may lead to a row that is not shown.
    addEventListener("hashchange", () => {
      if (document.querySelector("tr:target")?.hidden) {
        input.value = "";
        find();
        document.querySelector("tr:target").scrollIntoView();
      }
    });
  }

  for (const table of document.querySelectorAll("table.sortable")) {
    makeSortable(table);
    makeFinder(table);
  }
})();
