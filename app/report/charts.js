// Charts along the path: one pointer, one zoom and one choice of methods for all of them.
const charts = [];
const others = [];      // charts along something else: no common pointer or zoom
const repainters = [];  // redraw what is coloured by hand
const followers = [];  // hear the frame that is pointed at
const zoomers = [];    // hear the frames shown, [first, last], or null: all
const shown = new Set();
let pointed = 0;

function pointAt(frame) {
  pointed = frame;
  for (const chart of charts) chart.read(frame);
  for (const follow of followers) follow(frame);
}

function zoomAll(source, range) {
  for (const chart of charts) if (chart.graph !== source) chart.graph.updateOptions({ dateWindow: range });
  for (const zoom of zoomers) zoom(range);
}

const refreshAll = () => [...charts, ...others].forEach((chart) => chart.refresh());

/// How charts look in the page's colours of now.
const chartLook = () => ({ gridLineColor: css("--grid"), axisLineColor: css("--line") });

/// One chart along `frames` (their numbers).  Its lines are [label, values, colour of now, visible].
function addChart(id, frames, unit, decimals, options, linesOf) {
  const section = byId(id);
  const reading = section.querySelector(".reading");
  let lines = linesOf();
  const rowOf = (frame) => (frames[frame] === frame ? frame : frames.indexOf(frame));
  const rows = () => frames.map((frame, i) => [frame, ...lines.map((l) => l[1][i] ?? null)]);
  const look = () => ({ labels: ["frame", ...lines.map((l) => l[0])], colors: lines.map((l) => l[2]),
    visibility: lines.map((l) => l[3]), ...chartLook() });
  const graph = new Dygraph(section.querySelector(".plot"), rows(), {
    ...look(), legend: "never", strokeWidth: 1.5, includeZero: true, animatedZooms: false,
    highlightCircleSize: 3, xlabel: "frame", ylabel: unit, axes: { y: { axisLabelWidth: 48 } }, ...options,
    highlightCallback: (_event, x) => pointAt(x),
    zoomCallback: () => zoomAll(graph, graph.isZoomed("x") ? graph.xAxisRange() : null) });
  charts.push({ graph,
    read(frame) {
      const row = rowOf(frame);
      reading.textContent = "";
      reading.append(element("b", `frame ${frame}`));
      for (const [label, values, color, visible] of lines) {
        if (visible) reading.append(...readingOf(label, values[row], color, decimals));
      }
      if (row >= 0 && graph.getSelection() !== row) graph.setSelection(row);
    },
    refresh() { lines = linesOf(); graph.updateOptions({ file: rows(), ...look() }); this.read(pointed); } });
}

function readingOf(label, value, color, decimals) {
  const dot = element("span", undefined, { class: "dot" });
  dot.style.background = color;
  return [dot, `${label} `, element("b", number(value, decimals))];
}

/// Buttons that show and hide methods in every chart.
function addMethodSwitches(box, methods) {
  for (const method of methods) {
    const button = element("button", undefined,
      { type: "button", "aria-pressed": "true", title: data.descriptions[method] ?? "" });
    button.append(methodDot(method), method);
    button.addEventListener("click", () => {
      if (!shown.delete(method)) shown.add(method);
      button.setAttribute("aria-pressed", String(shown.has(method)));
      refreshAll();
      pointAt(pointed);
    });
    box.append(button);
  }
}
