// The tables of a run: what frames take, how like geometry they are, and the worst of them.
const stages = [["cull_ms", "cull"], ["capture_ms", "capture"], ["load_ms", "load"], ["warp_ms", "warp"], 
  ["composite_ms", "composite"], ["draw_ms", "draw"]];

function showTimes(summary, methods) {
  const first = summary.methods[methods[0]].frame_ms.p50;
  fillTable(byId("times"),
    ["method", "median", "p95", "p99", "max", "speed-up", "triangles", "uncovered %"],
    methods.map((method) => {
      const m = summary.methods[method];
      return [methodHead(method), number(m.frame_ms.p50), number(m.frame_ms.p95), number(m.frame_ms.p99),
        number(m.frame_ms.max), `${number(first / m.frame_ms.p50)}×`, number(m.triangles?.mean, 0),
        number(m.uncovered_percent?.mean, 3)];
    }));
}

function showStages(summary, methods) {
  const timed = stages.filter(([column]) => methods.some((method) => summary.methods[method][column]));
  fillTable(byId("stage-table"), ["median ms", ...timed.map((s) => s[1]), "frame"],
    methods.map((method) => [methodHead(method),
      ...timed.map(([column]) => number(summary.methods[method][column]?.p50, 3)),
      number(summary.methods[method].frame_ms.p50, 3)]));
}

function showLikeness(summary, methods) {
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

/// The contact sheet, a cell a picture: a window onto it, so that a caption can stand below each.
function showSheet(sheet) {
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
