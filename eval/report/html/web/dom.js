// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT

/** An element: h("td", {class: "num", onclick: f}, "text", child). Children that are null or false are left out. */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name === "style") element.style.cssText = value;
    else if (name === "value") element.value = value;
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

/**
 * Other children for an element. The focus stays on the control that had it: the new one of the same data-name, which is unique within
 * what is filled; where there is none, on the element, so that Tab goes on from there.
 */
export function fill(element, ...children) {
  const focused = element.contains(document.activeElement) && element !== document.activeElement ? document.activeElement : null;
  element.replaceChildren(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  if (focused) {
    const same = focused.dataset.name && [...element.querySelectorAll("[data-name]")].find((control) => control.dataset.name === focused.dataset.name);
    if (!same) element.tabIndex = -1;
    (same || element).focus({preventScroll: true});
  }
  return element;
}

/** A labelled drop-down. Options are [value, text] pairs. */
export function select(label, options, value, onchange) {
  const box = h("select", {"data-name": label, onchange: (event) => onchange(event.target.value)},
    options.map(([key, text]) => h("option", {value: key, selected: key === value}, text)));
  box.value = value;
  return h("label", {class: "field"}, h("span", {}, label), box);
}

/** A row of buttons of which one is pressed. */
export function choice(label, options, value, onchange) {
  return h("div", {class: "field", role: "group", "aria-label": label}, h("span", {}, label),
    h("div", {class: "segments"}, options.map(([key, text, title]) => h("button", {
      type: "button", title, "data-name": label + " " + key, "aria-pressed": String(key === value), onclick: () => onchange(key)}, text))));
}

export function checkbox(text, checked, onchange, swatch = null) {
  return h("label", {class: "check"}, h("input", {type: "checkbox", "data-name": text, checked, onchange: (event) => onchange(event.target.checked)}), swatch, h("span", {}, text));
}

export function copyButton(text, what) {
  const button = h("button", {type: "button", class: "quiet", onclick: async () => {
    const content = text();
    try {
      await navigator.clipboard.writeText(content);
    } catch {
      // Pages from disk may lack the clipboard: the old way.
      const area = h("textarea", {style: "position:fixed;opacity:0"});
      area.value = content;
      document.body.append(area);
      area.select();
      document.execCommand("copy");
      area.remove();
    }
    button.textContent = "Copied";
    setTimeout(() => { button.textContent = what; }, 1200);
  }}, what);
  return button;
}
