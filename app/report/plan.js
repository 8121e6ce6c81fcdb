// The house's plan: the path on it, coloured by what a frame takes, and where the pointer is.
const viridis = ["#440154", "#482878", "#3e4a89", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b",
  "#fde725"].map((hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16)));
const isDark = () => matchMedia("screen and (prefers-color-scheme: dark)").matches &&
  !document.documentElement.classList.contains("printing");

/// The colour of a share 0…1 of the scale: slow frames stand out from the page, be it light or dark.
function scaleColor(share) {
  const place = Math.min(Math.max(isDark() ? share : 1 - share, 0), 1) * (viridis.length - 1);
  const low = Math.min(Math.floor(place), viridis.length - 2);
  const mixed = viridis[low].map((v, i) => Math.round(v + (place - low) * (viridis[low + 1][i] - v)));
  return `rgb(${mixed.join(",")})`;
}

function svgElement(tag, attributes, parent) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  parent.append(node);
  return node;
}

/// One storey's drawing with room for the path and the marker.
function addStorey(plan, index) {
  const storey = plan.storeys[index];
  const figure = element("figure");
  const [width, height] = plan.size;
  const svg = svgElement("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "fill-rule": "evenodd",
    "aria-label": `plan of ${storey.name}` }, figure);
  svgElement("g", { class: "drawing" }, svg).innerHTML = storey.drawing;
  const path = svgElement("g", { class: "path" }, svg);
  const marker = svgElement("path", { class: "marker", d: "M14 0L-7 8L-3 0L-7 -8Z" }, svg);
  figure.append(element("figcaption", `${storey.name}, floor at ${number(storey.floor_y, 1)} m`));
  byId("plan-storeys").append(figure);
  return { figure, svg, path, marker, index };
}

/// The path's pieces, each from one frame to the next on the same storey, all over a wider dark or light line.
function addPath(plan, storeys) {
  const pieces = [];
  for (const { path, index } of storeys) {
    const casing = [];
    for (let f = 1; f < plan.x.length; ++f) {
      if (plan.storey[f] === index) casing.push(`M${plan.x[f - 1]} ${plan.y[f - 1]}L${plan.x[f]} ${plan.y[f]}`);
    }
    svgElement("path", { class: "casing", d: casing.join("") }, path);
  }
  for (let f = 1; f < plan.x.length; ++f) {
    const line = svgElement("line", { x1: plan.x[f - 1], y1: plan.y[f - 1], x2: plan.x[f], y2: plan.y[f] },
      storeys[plan.storey[f]].path);
    pieces.push({ frame: f, line });
  }
  return pieces;
}

/// The frame whose place is nearest to the event's, of several as near the one next to the pointer; -1: none near.
function frameAt(event, plan, { svg, index }) {
  const box = svg.getBoundingClientRect();
  const scale = plan.size[0] / box.width;
  const x = (event.clientX - box.left) * scale;
  const y = (event.clientY - box.top) * scale;
  let best = -1;
  let least = (30 * scale) ** 2;
  for (let f = 0; f < plan.x.length; ++f) {
    if (plan.storey[f] !== index) continue;
    const distance = (plan.x[f] - x) ** 2 + (plan.y[f] - y) ** 2;
    const nearer = Math.abs(f - pointed) < Math.abs(best - pointed);
    if (distance < least - 1 || (distance < least + 1 && nearer)) {
      least = Math.min(distance, least);
      best = f;
    }
  }
  return best;
}

function showScale(low, high) {
  const stops = Array.from({ length: 11 }, (_, i) => scaleColor(i / 10));
  byId("plan-scale").style.background = `linear-gradient(to right, ${stops.join(",")})`;
  byId("plan-low").textContent = `${number(low, 1)} ms`;
  byId("plan-high").textContent = `${number(high, 1)} ms and more`;
}

/// From the least frame time to the 98th percentile: a single slow frame must not take all colours.
function colorPath(pieces, values) {
  const sorted = [...values].sort((a, b) => a - b);
  const low = sorted[0];
  const high = Math.max(percentileOf(sorted, 98), low + 1e-6);
  for (const { frame, line } of pieces) {
    line.style.stroke = scaleColor((values[frame] - low) / (high - low));
  }
  showScale(low, high);
}

function followOnPlan(plan, storeys) {
  const point = (storey) => (event) => {
    const frame = frameAt(event, plan, storey);
    if (frame >= 0 && frame !== pointed) pointAt(frame);
  };
  for (const storey of storeys) {
    // One that the walk is not on may be small: it takes a click to go there.
    storey.svg.addEventListener("pointermove", (event) => {
      if (!storey.figure.classList.contains("away")) point(storey)(event);
    });
    storey.svg.addEventListener("pointerdown", point(storey));
  }
  followers.push((frame) => {
    for (const { figure, marker, index } of storeys) {
      figure.classList.toggle("away", plan.storey[frame] !== index);
      marker.style.display = plan.storey[frame] === index ? "" : "none";
      marker.setAttribute("transform",
        `translate(${plan.x[frame]} ${plan.y[frame]}) rotate(${plan.heading[frame]})`);
    }
  });
}

function addPlan() {
  const { plan } = data;
  if (!plan) return;
  byId("plan").hidden = false;
  const storeys = plan.storeys.map((_, index) => addStorey(plan, index));
  const pieces = addPath(plan, storeys);
  let chosen = methods[methods.length - 1];
  const color = () => colorPath(pieces, series[chosen].frametime_ms);
  addChoice(byId("plan").querySelector(".switches"), methods, chosen, (method) => { chosen = method; color(); });
  followOnPlan(plan, storeys);
  zoomers.push((range) => {
    for (const { frame, line } of pieces) {
      line.classList.toggle("outside", Boolean(range) && (frame < range[0] || frame > range[1]));
    }
  });
  repainters.push(color);
  color();
}
