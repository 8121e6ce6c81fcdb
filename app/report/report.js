"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const { summary, series, descriptions } = data;
  const methods = Object.keys(series);
  const stages = [["cull_ms", "cull"], ["warp_ms", "warp"], ["composite_ms", "composite"], ["draw_ms", "draw"]];
  const byId = (id) => document.getElementById(id);
  const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  // A method has its colour in every report.
  const known = ["geometry", "raycast", "culling", "ldi", "texture", "warp", "warp2"];
  const methodColor = (method) => css(`--c${Math.max(known.indexOf(method), 0)}`);
  const stageColor = (index) => css(`--c${[0, 3, 4, 2][index]}`);

  const element = (tag, text, attributes = {}) => {
    const node = document.createElement(tag);
    if (text !== undefined) node.textContent = text;
    for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
    return node;
  };
  const number = (value, decimals = 2) =>
    value === undefined || value === null ? "–"
      : value.toLocaleString("en", { minimumFractionDigits: decimals, maximumFractionDigits: decimals });

  // Tables ---------------------------------------------------------------------------------------
  function fillTable(table, heads, rows) {
    const head = table.createTHead().insertRow();
    for (const text of heads) head.append(element("th", text, { scope: "col" }));
    const body = table.createTBody();
    for (const cells of rows) {
      const row = body.insertRow();
      cells.forEach((cell) => (cell instanceof Node ? row.append(cell) : row.append(element("td", cell))));
    }
  }
  function methodHead(method) {
    const head = element("th", undefined, { scope: "row", title: descriptions[method] });
    const dot = element("span", undefined, { class: "dot" });
    dot.dataset.method = method;
    head.append(dot, method);
    return head;
  }
  function showTimes() {
    const first = summary.methods[methods[0]].frame_ms.p50;
    fillTable(byId("times"),
      ["method", "median", "p95", "p99", "max", "speed-up", "triangles", "uncovered %"],
      methods.map((method) => {
        const m = summary.methods[method];
        return [methodHead(method), number(m.frame_ms.p50), number(m.frame_ms.p95), number(m.frame_ms.p99),
          number(m.frame_ms.max), `${number(first / m.frame_ms.p50)}×`, number(m.triangles?.mean, 0),
          number(m.uncovered_percent?.mean, 3)];
      }));
    fillTable(byId("stage-table"), ["median ms", ...stages.map((s) => s[1]), "frame"],
      methods.map((method) => [methodHead(method),
        ...stages.map(([column]) => number(summary.methods[method][column]?.p50, 3)),
        number(summary.methods[method].frame_ms.p50, 3)]));
  }
  function showLikeness() {
    if (!methods.some((method) => summary.methods[method].psnr_db)) return;
    byId("quality").hidden = false;
    fillTable(byId("likeness"),
      ["method", "PSNR dB", "in portals", "SSIM", "in portals", "differing %", "flicker", "switches", "median jump",
        "greatest"],
      methods.map((method) => {
        const m = summary.methods[method];
        const jump = m.switch_jump;
        return [methodHead(method), number(m.psnr_db?.mean), number(m.psnr_portals_db?.mean), number(m.ssim?.mean, 4),
          number(m.ssim_portals?.mean, 4), number(m.differing_percent?.mean), number(m.flicker?.mean, 3),
          number(jump?.count, 0), number(jump?.levels?.p50), number(jump?.levels?.max)];
      }));
  }
  // One cell a picture: a window onto the sheet, so that a caption can stand below each.
  function showSheet() {
    const { sheet } = data;
    if (!sheet) return;
    byId("sheet").hidden = false;
    const last = sheet.columns[sheet.columns.length - 1];
    byId("sheet-method").textContent = last;
    byId("sheet-link").href = sheet.file;
    const heads = [...sheet.columns, `|${last} − geometry| × ${sheet.amplification}`];
    const box = byId("sheet-cells");
    box.style.setProperty("--columns", heads.length);
    const place = (index, axis) =>
      `${(100 * index * (sheet.cell[axis] + sheet.gap)) / Math.max(sheet.size[axis] - sheet.cell[axis], 1)}%`;
    sheet.rows.forEach((row, down) => heads.forEach((head, across) => {
      const likeness = across > 0 && across < row.psnr_db.length ? `: ${number(row.psnr_db[across])} dB` : "";
      const caption = `${across === 0 ? `frame ${row.frame}: ` : ""}${head}${likeness}`;
      const picture = element("a", undefined, { class: "cell", href: sheet.file, role: "img",
        "aria-label": `frame ${row.frame}, ${head}${likeness}` });
      picture.style.aspectRatio = `${sheet.cell[0]} / ${sheet.cell[1]}`;
      picture.style.backgroundImage = `url("${sheet.file}")`;
      picture.style.backgroundSize = sheet.size.map((s, axis) => `${(100 * s) / sheet.cell[axis]}%`).join(" ");
      picture.style.backgroundPosition = `${place(across, 0)} ${place(down, 1)}`;
      const figure = element("figure");
      figure.append(picture, element("figcaption", caption));
      box.append(figure);
    }));
  }
  function showFacts() {
    const house = summary.house;
    byId("title").textContent = `A walk through ${house.folder}`;
    document.title = `Enfilade: ${house.folder}`;
    byId("facts").textContent = `${number(summary.frames, 0)} frames of ${summary.size.join(" × ")} pixels · ` +
      `${house.cells} cells, ${house.portals} portals, ${number(house.triangles, 0)} triangles, ` +
      `${house.images} portal images · model ${house.model}`;
    const machine = summary.machine;
    const lines = [["CPU", machine.cpu],
      ["Cores", `${machine.cores}, threads used: ${summary.threads}`],
      ["Memory", `${number(machine.memory_bytes / 2 ** 30, 1)} GiB`], ["System", machine.system],
      ["OpenGL", machine.gl_renderer], ["Enfilade", summary.tool_version], ["Tour", summary.tour]];
    for (const [term, text] of lines) byId("machine").append(element("dt", term), element("dd", text || "–"));
    byId("command").textContent = summary.command;
  }

  // Charts ---------------------------------------------------------------------------------------
  const charts = [];
  const shown = new Set(methods);

  let pointed = 0;

  function pointAt(frame) {
    pointed = frame;
    for (const chart of charts) chart.read(frame);
    showPictures(frame);
  }
  function zoomAll(source, range) {
    for (const chart of charts) if (chart.graph !== source) chart.graph.updateOptions({ dateWindow: range });
  }
  // One chart: `lines` are [label, values, colour of now], which `visible` may hide.
  function addChart(id, unit, decimals, options, linesOf) {
    const section = byId(id);
    const reading = section.querySelector(".reading");
    let lines = linesOf();
    const rows = () => Array.from({ length: summary.frames }, (_, f) => [f, ...lines.map((l) => l[1][f] ?? null)]);
    const look = () => ({ labels: ["frame", ...lines.map((l) => l[0])], colors: lines.map((l) => l[2]),
      visibility: lines.map((l) => l[3]), gridLineColor: css("--grid"), axisLineColor: css("--line") });
    const graph = new Dygraph(section.querySelector(".plot"), rows(), {
      ...look(), legend: "never", strokeWidth: 1.5, includeZero: true, animatedZooms: false, labelsKMB: decimals === 0,
      highlightCircleSize: 3, xlabel: "frame", ylabel: unit, axes: { y: { axisLabelWidth: 48 } }, ...options,
      highlightCallback: (_event, x) => pointAt(x),
      zoomCallback: () => zoomAll(graph, graph.isZoomed("x") ? graph.xAxisRange() : null) });
    charts.push({ graph,
      read(frame) {
        reading.textContent = "";
        reading.append(element("b", `frame ${frame}`));
        for (const [label, values, color, visible] of lines) {
          if (!visible) continue;
          const dot = element("span", undefined, { class: "dot" });
          dot.style.background = color;
          reading.append(dot, `${label} `, element("b", `${number(values[frame], decimals)}`));
        }
        if (graph.getSelection() !== frame) graph.setSelection(frame);
      },
      refresh() { lines = linesOf(); graph.updateOptions({ file: rows(), ...look() }); this.read(pointed); } });
  }
  const byMethod = (column) => () => methods.filter((m) => series[m][column])
    .map((m) => [m, series[m][column], methodColor(m), shown.has(m)]);
  function addMethodChart(id, column, unit, decimals, options = {}) {
    if (byMethod(column)().length > 0) addChart(id, unit, decimals, options, byMethod(column));
    else byId(id).hidden = true;
  }

  const refreshAll = () => charts.forEach((chart) => chart.refresh());
  function addSwitches() {
    const box = byId("frametime").querySelector(".switches");
    for (const method of methods) {
      const button = element("button", undefined, { "aria-pressed": "true", title: descriptions[method] });
      const dot = element("span", undefined, { class: "dot" });
      dot.dataset.method = method;
      button.append(dot, method);
      button.addEventListener("click", () => {
        if (!shown.delete(method)) shown.add(method);
        button.setAttribute("aria-pressed", String(shown.has(method)));
        refreshAll();
      });
      box.append(button);
    }
  }
  function addStageChart() {
    let chosen = methods[methods.length - 1];
    const box = byId("stages").querySelector(".switches");
    box.classList.add("one");
    const buttons = methods.map((method) => {
      const button = element("button", method);
      button.addEventListener("click", () => { chosen = method; mark(); refreshAll(); });
      return button;
    });
    const mark = () => buttons.forEach((b) => b.setAttribute("aria-pressed", String(b.textContent === chosen)));
    box.append(...buttons);
    mark();
    addChart("stages", "ms", 3, { stackedGraph: true, fillAlpha: 0.5 }, () =>
      stages.map(([column, label], i) =>
        [label, series[chosen][column] ?? new Array(summary.frames).fill(0), stageColor(i),
          Boolean(series[chosen][column])]));
  }
  function paintDots() {
    for (const dot of document.querySelectorAll(".dot[data-method]")) {
      dot.style.background = methodColor(dot.dataset.method);
    }
  }

  // Kept frames ------------------------------------------------------------------------------------
  const pictures = new Map();
  function showPictures(frame) {
    for (const [method, image] of pictures) {
      image.src = `${data.frames_dir}/${method}/frame-${String(frame).padStart(5, "0")}.png`;
    }
    byId("picture-number").textContent = frame;
  }
  function addPictures() {
    if (!data.frames_dir) return;
    byId("pictures").hidden = false;
    for (const method of methods) {
      const figure = element("figure");
      const image = element("img", undefined, { alt: `the frame by ${method}` });
      pictures.set(method, image);
      figure.append(image, element("figcaption", method));
      byId("picture-row").append(figure);
    }
    showPictures(0);
  }

  showFacts();
  showTimes();
  showLikeness();
  showSheet();
  addPictures();
  if (typeof Dygraph === "undefined") {
    for (const section of document.querySelectorAll(".chart")) section.hidden = true;
    byId("stages").hidden = false;
    for (const part of byId("stages").querySelectorAll(".plot, .reading")) part.hidden = true;
    byId("facts").append(" · without charts: the program was built without libjs-dygraphs");
  } else {
    addSwitches();
    addMethodChart("frametime", "frametime_ms", "ms", 2);
    addStageChart();
    addMethodChart("triangles", "triangles", "", 0);
    addMethodChart("psnr", "psnr_db", "dB", 2, { includeZero: false });
    addMethodChart("psnr-portals", "psnr_portals_db", "dB", 2, { includeZero: false });
    addMethodChart("flicker", "flicker", "levels", 3);
    addMethodChart("uncovered", "uncovered_percent", "%", 3);
  }
  if (charts.length > 0) pointAt(pointed);
  paintDots();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { refreshAll(); paintDots(); });
})();
