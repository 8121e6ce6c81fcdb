"use strict";
// What the program's pages share: their data, and how numbers, tables and methods are shown.
const data = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

// A method has its colour in every report.
const knownMethods = ["geometry", "raycast", "culling", "ldi", "texture", "warp", "warp2"];
const methodColor = (method) => css(`--c${Math.max(knownMethods.indexOf(method), 0)}`);

function element(tag, text, attributes = {}) {
  const node = document.createElement(tag);
  if (text !== undefined) node.textContent = text;
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  return node;
}

function number(value, decimals = 2) {
  if (value === undefined || value === null) return "–";
  return value.toLocaleString("en", { minimumFractionDigits: decimals, maximumFractionDigits: decimals });
}

function fillTable(table, heads, rows) {
  const head = table.createTHead().insertRow();
  for (const text of heads) head.append(element("th", text, { scope: "col" }));
  const body = table.createTBody();
  for (const cells of rows) {
    const row = body.insertRow();
    for (const cell of cells) row.append(cell instanceof Node ? cell : element("td", cell));
  }
}

function methodDot(method) {
  const dot = element("span", undefined, { class: "dot" });
  dot.dataset.method = method;
  return dot;
}

function methodHead(method) {
  const head = element("th", undefined, { scope: "row", title: data.descriptions[method] ?? "" });
  head.append(methodDot(method), method);
  return head;
}

function paintDots() {
  for (const dot of document.querySelectorAll(".dot[data-method]")) {
    dot.style.background = methodColor(dot.dataset.method);
  }
}

/// Buttons of which one is pressed; `chosen` hears which.
function addChoice(box, names, first, chosen) {
  box.classList.add("one");
  const buttons = names.map((name) => {
    const button = element("button", name, { type: "button" });
    button.addEventListener("click", () => { mark(name); chosen(name); });
    return button;
  });
  const mark = (name) => buttons.forEach((b, i) => b.setAttribute("aria-pressed", String(names[i] === name)));
  box.append(...buttons);
  mark(first);
}
