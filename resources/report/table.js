// SPDX-License-Identifier: LGPL-2.1-or-later
"use strict";
// Without this the table is in the order of the files and shows every part.
(function () {
  const table = document.getElementById("parts");
  if (!table) return;
  const body = table.tBodies[0];
  const rows = Array.from(body.rows);
  const headings = Array.from(table.tHead.rows[0].cells);

  function valueOf(row, column, isNumber) {
    const cell = row.cells[column];
    const text = cell.dataset.value !== undefined ? cell.dataset.value : cell.textContent.trim();
    return isNumber ? (text === "" ? Infinity : Number(text)) : text.toLowerCase();
  }

  function sortBy(column) {
    const heading = headings[column];
    const isDown = heading.getAttribute("aria-sort") === "ascending";
    const isNumber = heading.dataset.sort === "number";
    const keyed = rows.map((row, place) => [valueOf(row, column, isNumber), place, row]);
    const order = (a, b) => (a < b ? -1 : a > b ? 1 : 0);
    keyed.sort((a, b) => (isDown ? order(b[0], a[0]) : order(a[0], b[0])) || a[1] - b[1]);
    headings.forEach((each) => each.removeAttribute("aria-sort"));
    heading.setAttribute("aria-sort", isDown ? "descending" : "ascending");
    body.append(...keyed.map((each) => each[2]));
  }

  headings.forEach(function (heading, column) {
    if (!heading.dataset.sort) return;
    // No <button>: browsers leave those out where they print a heading again on the next page.
    const button = document.createElement("span");
    button.setAttribute("role", "button");
    button.tabIndex = 0;
    button.append(...heading.childNodes);
    heading.append(button);
    button.addEventListener("click", () => sortBy(column));
    button.addEventListener("keydown", function (event) {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      sortBy(column);
    });
  });

  const counts = Array.from(document.querySelectorAll("#counts [data-category]"));
  const buttons = counts.map(function (count) {
    const button = document.createElement("button");
    button.type = "button";
    button.dataset.category = count.dataset.category;
    button.setAttribute("aria-pressed", "false");
    button.append(...count.childNodes);
    count.replaceWith(button);
    return button;
  });
  buttons.forEach(function (button) {
    button.addEventListener("click", function () {
      button.setAttribute("aria-pressed", String(button.getAttribute("aria-pressed") !== "true"));
      const wanted = buttons.filter((each) => each.getAttribute("aria-pressed") === "true")
        .map((each) => each.dataset.category);
      rows.forEach((row) => { row.hidden = wanted.length > 0 && !wanted.includes(row.dataset.category); });
    });
  });
})();
