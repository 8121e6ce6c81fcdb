// How the frame times are spread: for each share of the frames how long the slowest of them takes.

/// As statistics.h has it: linear between the closest ranks.
function percentileOf(sorted, percent) {
  const rank = (percent / 100) * (sorted.length - 1);
  const below = Math.floor(rank);
  const above = Math.min(below + 1, sorted.length - 1);
  return sorted[below] + (rank - below) * (sorted[above] - sorted[below]);
}

// The axis is stretched toward the slow end, where each decade of rare frames has the same width.
const shareTicks = [0, 50, 75, 90, 95, 99, 99.9, 99.99];
const stretched = (percent) => -Math.log10(1 - percent / 100);
const percentAt = (x) => 100 * (1 - 10 ** -x);

/// Curves of [name, values, colour of now, visible] with the reading of one share below them.
function addDistribution(id, curvesOf) {
  const section = byId(id);
  const reading = section.querySelector(".reading");
  let curves = curvesOf();
  let sorted = curves.map((c) => c[1].filter((v) => v !== null).sort((a, b) => a - b));
  const most = Math.max(...sorted.map((s) => s.length), 2);
  const end = stretched(100 * (1 - 0.5 / most));
  const places = Array.from({ length: 401 }, (_, i) => (end * i) / 400);
  const rows = () => places.map((x) => [x, ...sorted.map((s) => (s.length ? percentileOf(s, percentAt(x)) : null))]);
  const look = () => ({ labels: ["share", ...curves.map((c) => c[0])], colors: curves.map((c) => c[2]),
    visibility: curves.map((c) => c[3]), ...chartLook() });
  const ticks = () => shareTicks.filter((t) => stretched(t) <= end).map((t) => ({ v: stretched(t), label: `${t}%` }));
  const read = (x) => {
    const percent = percentAt(x);
    reading.textContent = "";
    reading.append(element("b", `${number(percent, percent > 99 ? 2 : 1)} % of the frames take at most`));
    curves.forEach((c, i) => {
      if (c[3]) reading.append(...readingOf(c[0], percentileOf(sorted[i], percent), c[2], 2));
    });
  };
  const graph = new Dygraph(section.querySelector(".plot"), rows(), { ...look(), legend: "never", strokeWidth: 1.5,
    includeZero: true, highlightCircleSize: 3, xlabel: "share of the frames", ylabel: "ms",
    axes: { x: { ticker: ticks }, y: { axisLabelWidth: 48 } }, highlightCallback: (_event, x) => read(x) });
  const refresh = () => {
    curves = curvesOf();
    sorted = curves.map((c) => c[1].filter((v) => v !== null).sort((a, b) => a - b));
    graph.updateOptions({ file: rows(), ...look() });
    read(stretched(95));
  };
  others.push({ graph, refresh });
  read(stretched(95));
}
