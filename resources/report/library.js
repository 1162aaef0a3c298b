// SPDX-License-Identifier: LGPL-2.1-or-later
"use strict";
// Without this the page has its counts, groups, families and the drawn map, but no table. Names of parts and files are only ever
// put on the page as texts.
(function () {
  const source = document.getElementById("rows");
  if (!source) return;
  const fields = source.dataset.fields.split(" ");
  const rows = source.textContent.split("\n").map(function (line, number) {
    const values = line.split("\t");
    const row = { number: number };
    fields.forEach((name, place) => { row[name] = values[place]; });
    row.words = (row.label + " " + row.file).toLowerCase();
    return row;
  });
  const table = document.getElementById("parts-table");
  const area = document.getElementById("map-area");
  const numeric = ["thinnest", "median", "fill", "box", "risk"];
  const pageSize = Number(table.dataset.rows);
  let shown = rows;
  let start = 0;
  let found = null;

  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (all, name) => (name in values ? values[name] : all));
  }

  function make(tag, text, attributes) {
    const made = document.createElement(tag);
    if (text) made.textContent = text;
    Object.entries(attributes || {}).forEach(([name, value]) => made.setAttribute(name, value));
    return made;
  }

  function addressOf(row) {
    if (row.address === "-") return null;
    return row.address || source.dataset.base + row.file.split("/").map(encodeURIComponent).join("/");
  }

  function pictureOf(row, template, width, height) {
    if (!row.picture) return null;
    return make("img", "", {
      src: "pictures/" + row.picture.slice(0, 2) + "/" + row.picture + ".png", alt: filled(template, { part: row.label }),
      loading: "lazy", width: width, height: height });
  }

  // The categories, as buttons that choose what the map and the table show.

  const counts = Array.from(document.querySelectorAll("#counts [data-category]"));
  const categories = counts.map((count) => ({ name: count.dataset.category, word: count.dataset.word }));
  const buttons = counts.map(function (count) {
    const button = make("button", "", { type: "button", "aria-pressed": "false" });
    button.append(...count.childNodes);
    count.replaceWith(button);
    button.addEventListener("click", function () {
      button.setAttribute("aria-pressed", String(button.getAttribute("aria-pressed") !== "true"));
      choose();
    });
    return button;
  });

  // The table: a page of it at a time.

  function cellsOf(row) {
    const picture = make("td", "", { class: "picture" });
    const image = pictureOf(row, table.dataset.picture, 120, 90);
    if (image) picture.append(image);
    const label = make("th", row.label, { scope: "row" });
    if (row.instances !== "1") label.append(" ", make("span", "\u00d7" + row.instances, { class: "faint" }));
    const file = make("span", "", { class: "small path" });
    const address = addressOf(row);
    file.append(address ? make("a", row.file, { href: address }) : row.file);
    label.append(make("br"), file);
    const category = categories[Number(row.category)];
    const verdict = make("td");
    verdict.append(make("span", row.verdict || category.word, { class: "badge " + category.name }));
    const figures = numeric.map((name) => make("td", row[name], { class: "n" }));
    if (row.place) figures[0].append(make("br"), make("span", row.place, { class: "small faint" }));
    const belongs = make("td", "", { class: "small" });
    [["groups", "group"], ["families", "family"]].forEach(function ([field, name]) {
      row[field].split(" ").filter(Boolean).forEach(function (number) {
        const link = make("a", filled(table.dataset[name], { number: number }), { href: "#" + name + "-" + number });
        link.addEventListener("click", () => unfold(name + "-" + number));
        belongs.append(link, make("br"));
      });
    });
    return [picture, label, verdict, ...figures, belongs];
  }

  function unfold(name) {
    for (let place = document.getElementById(name); place; place = place.parentElement) {
      if (place.tagName === "DETAILS") place.open = true;
    }
  }

  function showPage(first) {
    start = first;
    const some = shown.slice(start, start + pageSize);
    table.tBodies[0].replaceChildren(...some.map(function (row) {
      const made = make("tr", "", row === found ? { class: "found", tabindex: "-1" } : {});
      made.append(...cellsOf(row));
      return made;
    }));
    const said = { first: start + 1, last: start + some.length, count: shown.length };
    document.getElementById("matches").textContent = some.length
      ? filled(table.dataset.matches, said) : table.dataset.none;
    document.getElementById("previous").disabled = start === 0;
    document.getElementById("next").disabled = start + pageSize >= shown.length;
  }

  function showRow(row) {
    found = row;
    const place = shown.indexOf(row);
    showPage(place - place % pageSize);
    const made = table.querySelector("tr.found");
    made.focus({ preventScroll: true });
    made.scrollIntoView({ block: "center" });
  }

  const search = document.getElementById("search");
  let order = null;
  let waiting = 0;

  function choose() {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const wanted = buttons.map((button) => button.getAttribute("aria-pressed") === "true");
    const all = !wanted.includes(true);
    shown = rows.filter((row) => (all || wanted[Number(row.category)]) && words.every((word) => row.words.includes(word)));
    if (order) sortShown();
    showPage(0);
    drawMap();
  }

  function sortShown() {
    const isNumber = numeric.includes(order.name);
    const valueOf = isNumber
      ? (row) => parseFloat(row[order.name].replace(",", "."))
      : order.name === "category" ? (row) => Number(row.category) : (row) => row[order.name].toLowerCase();
    const sign = order.isDown ? -1 : 1;
    const keyed = shown.map((row) => [valueOf(row), row]);
    keyed.sort(function ([a, one], [b, other]) {
      if (isNumber && Number.isNaN(a) !== Number.isNaN(b)) return Number.isNaN(a) ? 1 : -1;  // what is unknown comes last
      return (a < b ? -sign : a > b ? sign : 0) || one.number - other.number;
    });
    shown = keyed.map((each) => each[1]);
  }

  search.addEventListener("input", function () {
    clearTimeout(waiting);
    waiting = setTimeout(choose, 120);
  });
  document.getElementById("previous").addEventListener("click", () => showPage(Math.max(0, start - pageSize)));
  document.getElementById("next").addEventListener("click", () => showPage(start + pageSize));
  const headings = Array.from(table.tHead.rows[0].cells);
  headings.forEach(function (heading) {
    if (!heading.dataset.sort) return;
    const button = make("span", "", { role: "button", tabindex: "0" });
    button.append(...heading.childNodes);
    heading.append(button);
    function sort() {
      order = { name: heading.dataset.sort, isDown: heading.getAttribute("aria-sort") === "ascending" };
      headings.forEach((each) => each.removeAttribute("aria-sort"));
      heading.setAttribute("aria-sort", order.isDown ? "descending" : "ascending");
      sortShown();
      showPage(0);
    }
    button.addEventListener("click", sort);
    button.addEventListener("keydown", function (event) {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      sort();
    });
  });

  // The map: all points of a category are one path, so the nearest one is looked for here.

  const svg = area.querySelector("svg");
  const paths = Array.from(svg.querySelectorAll("path[data-category]"));
  const ring = document.getElementById("ring");  // not in the drawing: ten thousand points would be drawn again with it
  const tip = document.getElementById("tip");
  const across = document.getElementById("across");
  const near = 16;
  let points = [];
  let current = null;

  function drawMap() {
    points = shown.filter((row) => row[across.value] && row.height)
      .map((row) => ({ row: row, x: Number(row[across.value]), y: Number(row.height) }));
    paths.forEach(function (path) {
      const own = points.filter((point) => categories[Number(point.row.category)].name === path.dataset.category);
      path.setAttribute("d", own.map((point) => "M" + point.x + " " + point.y + path.dataset.mark).join(""));
    });
    svg.querySelectorAll("[data-axis]").forEach((axis) => {
      axis.setAttribute("visibility", axis.dataset.axis === across.value ? "visible" : "hidden");
    });
    point(null);
  }

  function point(at) {
    current = at;
    ring.hidden = tip.hidden = !at;
    if (!at) return;
    const row = at.row;
    const unit = "\u00a0" + area.dataset.unit;
    const said = filled(area.dataset.said, {
      category: categories[Number(row.category)].word, thinnest: row.thinnest + unit, median: row.median + unit,
      fill: row.fill || "\u2013" });
    const image = pictureOf(row, area.dataset.picture, 160, 120);
    if (image) image.removeAttribute("loading");
    tip.replaceChildren(...(image ? [image] : []), make("b", row.label), make("span", row.file, { class: "faint" }),
      make("span", said));
    const box = svg.getBoundingClientRect();
    const scale = box.width / svg.viewBox.baseVal.width;
    const x = at.x * scale;
    ring.style.transform = "translate(" + x + "px, " + at.y * scale + "px)";
    const view = area.parentElement;  // scrolls where the window is narrow
    if (x < view.scrollLeft || x > view.scrollLeft + view.clientWidth) view.scrollLeft = x - view.clientWidth / 2;
    const end = view.scrollLeft + view.clientWidth;
    const left = x + 16 + tip.offsetWidth <= end ? x + 16 : x - 16 - tip.offsetWidth;
    tip.style.left = Math.max(view.scrollLeft, left) + "px";
    tip.style.top = Math.max(0, Math.min(at.y * scale - 40, box.height - tip.offsetHeight)) + "px";
  }

  function nearest(event) {
    const box = svg.getBoundingClientRect();
    const scale = svg.viewBox.baseVal.width / box.width;
    const x = (event.clientX - box.left) * scale;
    const y = (event.clientY - box.top) * scale;
    let best = null;
    let least = near * near;
    points.forEach(function (each) {
      const distance = (each.x - x) ** 2 + (each.y - y) ** 2;
      if (distance <= least) [best, least] = [each, distance];
    });
    return best;
  }

  function step(key) {
    const isAcross = key === "ArrowLeft" || key === "ArrowRight";
    const sorted = points.slice().sort((a, b) => (isAcross ? a.x - b.x || b.y - a.y : b.y - a.y || a.x - b.x)
      || a.row.number - b.row.number);
    if (key === "Home" || key === "End" || !current) return sorted[key === "End" ? sorted.length - 1 : 0];
    const place = sorted.findIndex((each) => each.row === current.row) + (key === "ArrowRight" || key === "ArrowUp" ? 1 : -1);
    return sorted[Math.max(0, Math.min(sorted.length - 1, place))];
  }

  svg.addEventListener("pointermove", function (event) {
    const at = nearest(event);
    if ((at && at.row) !== (current && current.row)) point(at);
  });
  svg.addEventListener("pointerleave", () => point(null));
  svg.addEventListener("click", function (event) {
    const at = nearest(event);
    if (at) showRow(at.row);
  });
  area.addEventListener("keydown", function (event) {
    if (event.key === "Enter" && current) showRow(current.row);
    else if (event.key === "Escape") point(null);
    else if (/^(Arrow(Left|Right|Up|Down)|Home|End)$/.test(event.key) && points.length) point(step(event.key));
    else return;
    event.preventDefault();
  });
  area.addEventListener("blur", () => point(null));
  across.addEventListener("change", drawMap);
  area.tabIndex = 0;
  area.setAttribute("role", "application");
  area.setAttribute("aria-label", area.dataset.name);
  area.setAttribute("aria-describedby", "map-keys");
  area.classList.add("ready");
  [across.parentElement, document.getElementById("map-keys"), document.querySelector(".search")]
    .forEach((each) => { each.hidden = false; });
  window.addEventListener("hashchange", () => unfold(location.hash.slice(1)));
  choose();
})();
