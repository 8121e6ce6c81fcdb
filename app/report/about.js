// What was played, on what machine, and how to repeat it.
function showFacts() {
  const { house, machine } = summary;
  byId("title").textContent = `A walk through ${house.folder}`;
  document.title = `Enfilade: ${house.folder}`;
  byId("facts").textContent = `${number(summary.frames, 0)} frames of ${summary.size.join(" × ")} pixels · ` +
    `${house.cells} cells, ${house.portals} portals, ${number(house.triangles, 0)} triangles, ` +
    `${house.images} portal images · model ${house.model}`;
  const lines = [["CPU", machine.cpu],
    ["Cores", `${machine.cores}, threads used: ${summary.threads}`],
    ["Memory", `${number(machine.memory_bytes / 2 ** 30, 1)} GiB`], ["System", machine.system],
    ["OpenGL", machine.gl_renderer], ["Enfilade", summary.tool_version], ["Tour", summary.tour]];
  for (const [term, text] of lines) byId("machine").append(element("dt", term), element("dd", text || "–"));
  byId("command").textContent = summary.command;
}
