// The page that sets runs side by side.
const { runs } = data;
const methodNames = Object.keys(data.methods);
let chosenMethod = methodNames[methodNames.length - 1];
const allFrames = [...new Set(runs.flatMap((run) => Object.values(run.series).flatMap((s) => s.frame)))]
  .sort((a, b) => a - b);
const rowOfFrame = new Map(allFrames.map((frame, row) => [frame, row]));

/// A run keeps its colour in every chart.
const runColor = (index) => css(`--c${[0, 3, 2, 4, 1, 5, 6][index % 7]}`);
const runLabel = (index) => `${runs[index].run} ${runs[index].name}`;

function runHead(index) {
  const head = element("th", undefined, { scope: "row", title: runs[index].folder });
  head.append(runDot(index), runs[index].run);
  return head;
}

function runDot(index) {
  const dot = element("span", undefined, { class: "dot" });
  dot.dataset.run = index;
  return dot;
}

function paintRunDots() {
  for (const dot of document.querySelectorAll(".dot[data-run]")) dot.style.background = runColor(Number(dot.dataset.run));
}

function showRuns() {
  document.title = `Enfilade: ${runs.map((run) => run.name).join(", ")}`;
  runs.forEach((run, index) => {
    const term = element("dt");
    term.append(runDot(index), run.run);
    byId("runs").append(term, element("dd", `${run.name}: ${run.facts.size} pixels, ${run.facts.frames} frames, ` +
      `${run.facts.threads} threads, Enfilade ${run.facts.version}`));
  });
}

function showNotes(id, notes) {
  byId(id).hidden = notes.length === 0;
  for (const note of notes) byId(id).querySelector("ul").append(element("li", note));
}

const range = (low, high) => `${number(low, 3)} – ${number(high, 3)}`;

function changeCells(change) {
  if (!change) return ["–", "–", "–", "–"];
  if (!change.ratio) return [number(change.ratio_of_medians, 3), "–", "–", "of medians"];
  const { median, p5, p95, median_interval_95: interval } = change.ratio;
  const verdict = element("td", change.verdict, { class: `verdict ${change.verdict.replace(" ", "-")}` });
  return [number(median, 3), range(p5, p95), range(...interval), verdict];
}

/// Rows of every method and run: the method's name stands in the first of its rows.
function rowsOf(cells) {
  return methodNames.flatMap((method) => runs.map((_, index) => {
    const head = index === 0 ? methodHead(method) : element("th", "");
    return [head, runHead(index), ...cells(data.methods[method], index)];
  }));
}

function showTables() {
  fillTable(byId("changes"), ["method", "run", "median ms", "p95 ms", "p99 ms", "ratio to A", "5th – 95th",
    "95 % of median", "in these runs"], rowsOf((method, index) => {
    const times = method.runs[index]?.frame_ms;
    return [number(times?.p50), number(times?.p95), number(times?.p99),
      ...(index === 0 ? ["", "", "", ""] : changeCells(method.changes[index - 1]))];
  }));
  fillTable(byId("figures"), ["method", "run", "triangles", "PSNR dB", "in portals", "uncovered %"],
    rowsOf((method, index) => {
      const f = method.runs[index];
      return [number(f?.triangles?.mean, 0), number(f?.psnr_db?.mean), number(f?.psnr_portals_db?.mean),
        number(f?.uncovered_percent?.mean, 3)];
    }));
  const terms = [...new Set(runs.flatMap((run) => Object.keys(run.facts)))]
    .filter((term) => runs.some((run) => run.facts[term]));
  fillTable(byId("facts-table"), ["", ...runs.map((run) => run.run)],
    terms.map((term) => [element("th", term, { scope: "row" }), ...runs.map((run) => run.facts[term] ?? "–")]));
}

/// A run's column of the chosen method, a value a row of all frames.
function along(run, column) {
  const series = run.series[chosenMethod];
  const values = new Array(allFrames.length).fill(null);
  series?.[column]?.forEach((value, i) => { values[rowOfFrame.get(series.frame[i])] = value; });
  return values;
}

const linesOf = (column) => () => runs.map((run, i) => [runLabel(i), along(run, column), runColor(i), true]);

function ratioLines() {
  const first = along(runs[0], "frametime_ms");
  return runs.slice(1).map((run, i) => {
    const values = along(run, "frametime_ms").map((value, row) =>
      (value === null || first[row] === null ? null : value / first[row]));
    return [`${run.run}/A`, values, runColor(i + 1), true];
  });
}

/// A line at 1, where a run is as fast as the first.
function drawOne(context, area, graph) {
  const y = graph.toDomYCoord(1);
  context.strokeStyle = css("--faint");
  context.beginPath();
  context.moveTo(area.x, y);
  context.lineTo(area.x + area.w, y);
  context.stroke();
}

function addCharts() {
  const has = (column) => runs.some((run) => Object.values(run.series).some((series) => series[column]));
  const add = (id, column, ...look) => {
    if (has(column)) addChart(id, allFrames, ...look, linesOf(column));
    else byId(id).hidden = true;
  };
  add("frametime", "frametime_ms", "ms", 2, {});
  addChart("ratio", allFrames, "", 3, { logscale: true, includeZero: false, underlayCallback: drawOne }, ratioLines);
  addDistribution("distribution", () =>
    runs.map((run, i) => [runLabel(i), run.series[chosenMethod]?.frametime_ms ?? [], runColor(i), true]));
  add("triangles", "triangles", "", 0, { labelsKMB: true });
  add("psnr", "psnr_db", "dB", 2, { includeZero: false });
  add("uncovered", "uncovered_percent", "%", 3, {});
}

showRuns();
showNotes("incomparable", data.incomparable);
showNotes("differences", data.differences);
showTables();
if (typeof Dygraph === "undefined") {
  for (const section of document.querySelectorAll(".chart, .controls")) section.hidden = true;
} else {
  addCharts();
  addChoice(byId("method"), methodNames, chosenMethod, (method) => { chosenMethod = method; refreshAll(); });
  pointAt(allFrames[0]);
}
repainters.push(paintRunDots);
paintDots();
paintRunDots();
watchLook();
