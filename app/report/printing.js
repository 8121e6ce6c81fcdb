// Changes of the page's colours and, on paper, of its width.
const kPaperWidth = 660;  // [CSS pixels] between the margins of A4 and of letter

function repaint() {
  paintDots();
  refreshAll();
  for (const paint of repainters) paint();
}

/// Charts are shrunk or stretched to the paper as they are: browsers print nothing of a canvas whose size changes
/// while they prepare to print.
function fitCharts(fit) {
  for (const plot of document.querySelectorAll(".plot")) {
    const scale = fit && plot.clientWidth > 0 ? kPaperWidth / plot.clientWidth : 1;
    for (const drawn of plot.children) {
      drawn.style.transformOrigin = "0 0";
      drawn.style.transform = scale === 1 ? "" : `scale(${scale})`;
    }
    plot.style.height = scale === 1 ? "" : `${scale * plot.clientHeight}px`;
  }
}

function setPrinting(on) {
  fitCharts(on);
  document.documentElement.classList.toggle("printing", on);
  for (const details of document.querySelectorAll("details")) details.open = on;
  repaint();
}

function watchLook() {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", repaint);
  addEventListener("beforeprint", () => setPrinting(true));
  addEventListener("afterprint", () => setPrinting(false));
}
