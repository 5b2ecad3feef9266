// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {fill, h} from "./dom.js";

/**
 * A table that sorts by any column. Columns: {key, title, value(row), show(row), numeric, hint, width}. Undefined values stand last
 * either way. Rows beyond `limit` wait for a button.
 */
export function sortableTable({columns, rows, sort, descending = false, caption, limit = 400, onrow, rowClass, className = ""}) {
  let key = sort;
  let down = descending;
  let shown = limit;
  const head = h("tr");
  const body = h("tbody");
  const foot = h("div", {class: "more"});
  const table = h("div", {class: "scroll"},
    h("table", {class: "data " + className}, caption && h("caption", {}, caption), h("thead", {}, head), body), foot);

  function sorted() {
    const column = columns.find((candidate) => candidate.key === key);
    if (!column) return rows;
    const empty = (value) => value === null || value === undefined || value === "";
    return rows.map((row, i) => [column.value(row), i, row]).sort(([a, i], [b, j]) => {
      if (empty(a) || empty(b)) return empty(a) - empty(b) || i - j;
      const order = typeof a === "number" && typeof b === "number" ? a - b : String(a).localeCompare(String(b), "en", {numeric: true});
      return (down ? -order : order) || i - j;
    }).map(([, , row]) => row);
  }

  function draw() {
    fill(head, columns.map((column) => h("th", {
      scope: "col", class: column.numeric ? "num" : "", title: column.hint, style: column.width ? "width:" + column.width : null,
      "aria-sort": column.key === key ? (down ? "descending" : "ascending") : "none",
    }, h("button", {type: "button", "data-name": "sort " + column.key, onclick: () => {
      down = column.key === key ? !down : Boolean(column.descendingFirst);
      key = column.key;
      draw();
    }}, column.title))));
    const ordered = sorted();
    fill(body, ordered.slice(0, shown).map((row) => h("tr", {
      class: rowClass?.(row), onclick: onrow && ((event) => event.target.closest("a") || onrow(row)),
    }, columns.map((column, i) => h(i === 0 ? "th" : "td", {scope: i === 0 ? "row" : null, class: (column.numeric ? "num " : "") + (column.cellClass?.(row) ?? "")},
      column.show ? column.show(row) : String(column.value(row) ?? ""))))));
    fill(foot, ordered.length > shown && h("button", {type: "button", onclick: () => { shown = Infinity; draw(); body.rows[limit].querySelector("a")?.focus(); }},
      "Show all " + ordered.length + " rows"));
  }

  draw();
  return table;
}
