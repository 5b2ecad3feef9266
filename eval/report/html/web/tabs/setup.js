// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {json} from "../data.js";
import {copyButton, fill, h} from "../dom.js";

/** What made the numbers. */
export function setupTab(page) {
  const setup = json("setup");
  const list = (title, lines) => lines.length > 0 && h("section", {class: "block"}, h("h2", {}, title), h("ul", {class: "notes"}, lines.map((line) => h("li", {}, line))));
  fill(page,
    list("Remarks on this report", setup.remarks),
    setup.failures && h("section", {class: "block"}, h("h2", {}, "What failed"), h("pre", {}, setup.failures)),
    h("section", {class: "block"}, h("h2", {}, "Provenance"),
      h("table", {class: "data pairs"}, h("tbody", {}, Object.entries(setup.provenance ?? {}).map(([key, value]) => h("tr", {}, h("th", {scope: "row"}, key), h("td", {}, String(value)))),
        h("tr", {}, h("th", {scope: "row"}, "this report"), h("td", {}, setup.report_by))))),
    list("Notes of the methods", setup.notes),
    setup.config && h("section", {class: "block"}, h("div", {class: "controls"}, h("h2", {}, "Resolved configuration"), h("div", {class: "spring"}), copyButton(() => setup.config, "Copy YAML")),
      h("pre", {class: "config", tabindex: "0"}, setup.config)),
    h("section", {class: "block"}, h("details", {}, h("summary", {}, "Licences of the libraries in this page"), h("pre", {}, setup.licenses))));
  return {};
}
