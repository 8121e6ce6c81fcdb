// What was played, on what machine, with which parameters, and how to repeat it.
function addTerms(list, lines) {
  for (const [term, text] of lines) list.append(element("dt", term), element("dd", text || "–"));
}

function showFacts() {
  const { house } = summary;
  byId("title").textContent = `A walk through ${house.folder}`;
  document.title = `Enfilade: ${house.folder}`;
  byId("facts").textContent = `${number(summary.frames, 0)} frames of ${summary.size.join(" × ")} pixels · ` +
    `${house.cells} cells, ${house.portals} portals, ${number(house.triangles, 0)} triangles, ` +
    `${house.images} portal images · model ${house.model}`;
}

function showAbout() {
  const { machine, house, parameters } = summary;
  addTerms(byId("machine"), [["CPU", machine.cpu], ["Cores", `${machine.cores}`],
    ["Memory", `${number(machine.memory_bytes / 2 ** 30, 1)} GiB`], ["System", machine.system],
    ["OpenGL", machine.gl_renderer], ["Enfilade", summary.tool_version],
    ["House made by", house.tool_version && `Enfilade ${house.tool_version}`]]);
  addTerms(byId("parameters"), [["Tour", summary.tour], ["Frames", number(summary.frames, 0)],
    ["Size", `${summary.size.join(" × ")} pixels`], ["Field of view", `${number(summary.vertical_fov_degrees, 1)}° vertical`],
    ["Threads", `${summary.threads}`],
    ...Object.entries(parameters).filter(([, value]) => value !== "").map(([name, value]) => [`--${name}`, value])]);
  addTerms(byId("house-parameters"), Object.entries(house.parameters));
  byId("house-details").hidden = Object.keys(house.parameters).length === 0;
  byId("command").textContent = summary.command;
  addCopying(byId("copy"), byId("command"));
}

function addCopying(button, source) {
  const select = () => getSelection().selectAllChildren(source);
  button.addEventListener("click", async () => {
    let done = true;
    try {
      await navigator.clipboard.writeText(source.textContent);
    } catch {  // pages from a disk may not use the clipboard everywhere
      select();
      done = document.execCommand("copy");
    }
    button.textContent = done ? "Copied" : "Selected: copy it";
    setTimeout(() => { button.textContent = "Copy"; }, 2000);
  });
}
