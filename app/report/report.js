// A run's page: puts the parts together.
const { summary, series } = data;
const methods = Object.keys(series);
const everyFrame = Array.from({ length: summary.frames }, (_, frame) => frame);

function addMethodChart(id, column, unit, decimals, options = {}) {
  const linesOf = () => methods.filter((m) => series[m][column])
    .map((m) => [m, series[m][column], methodColor(m), shown.has(m)]);
  if (linesOf().length > 0) addChart(id, everyFrame, unit, decimals, options, linesOf);
  else byId(id).hidden = true;
}

function addStageChart() {
  let chosen = methods[methods.length - 1];
  addChoice(byId("stages").querySelector(".switches"), methods, chosen, (method) => {
    chosen = method;
    refreshAll();
  });
  const color = (index) => css(`--c${[0, 5, 3, 4, 2][index]}`);
  const none = new Array(summary.frames).fill(0);
  addChart("stages", everyFrame, "ms", 3, { stackedGraph: true, fillAlpha: 0.5 }, () =>
    stages.map(([column, label], i) =>
      [label, series[chosen][column] ?? none, color(i), Boolean(series[chosen][column])]));
}

function addCharts() {
  addMethodSwitches(byId("frametime").querySelector(".switches"), methods);
  addMethodChart("frametime", "frametime_ms", "ms", 2);
  addStageChart();
  addDistribution("distribution", () =>
    methods.map((m) => [m, series[m].frametime_ms, methodColor(m), shown.has(m)]));
  addMethodChart("triangles", "triangles", "", 0, { labelsKMB: true });
  addMethodChart("portals", "portals", "", 0);
  addMethodChart("portals-as-images", "portals_as_images", "", 0);
  addMethodChart("psnr", "psnr_db", "dB", 2, { includeZero: false });
  addMethodChart("psnr-portals", "psnr_portals_db", "dB", 2, { includeZero: false });
  addMethodChart("flicker", "flicker", "levels", 3);
  addMethodChart("uncovered", "uncovered_percent", "%", 3);
}

/// Without the chart library the tables are left.
function hideCharts() {
  for (const section of document.querySelectorAll(".chart")) section.hidden = true;
  byId("stages").hidden = false;
  for (const part of byId("stages").querySelectorAll(".plot, .reading, .switches")) part.hidden = true;
  byId("facts").append(" · without charts: the program was built without libjs-dygraphs");
}

/// For fingers and keys: moves the pointer without a mouse.
function addSlider() {
  const slider = byId("frame");
  slider.max = summary.frames - 1;
  slider.addEventListener("input", () => pointAt(Number(slider.value)));
  followers.push((frame) => {
    slider.value = frame;
    byId("frame-number").textContent = frame;
  });
}

for (const method of methods) shown.add(method);
showFacts();
showTimes(summary, methods);
showStages(summary, methods);
showLikeness(summary, methods);
showSheet(data.sheet);
showAbout();
addSlider();
addPictures();
addPlan();
if (typeof Dygraph === "undefined") hideCharts();
else addCharts();
pointAt(pointed);
paintDots();
watchLook();
