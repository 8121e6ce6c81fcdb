// Pictures of the frame pointed at: small ones that lie beside the page, evenly spaced along the walk,
// and whole ones where --frames-dir kept them.
const fiveDigits = (frame) => String(frame).padStart(5, "0");
const keptFile = (method, frame) => `${data.pictures.folder}/${method}/${fiveDigits(frame)}.jpg`;
const wholeFile = (method, frame) => `${data.frames_dir}/${method}/frame-${fiveDigits(frame)}.png`;

/// The frame nearest to `frame` of which there is a picture.
function picturedFrame(frame) {
  if (!data.pictures) return frame;
  const { stride } = data.pictures;
  const last = Math.floor((summary.frames - 1) / stride);
  return stride * Math.min(Math.round(frame / stride), last);
}

const heldPictures = [];  // or the browser might let go of them

/// Asks for all small pictures, those near the pointer first, so that they are there when they are pointed at.
function preloadPictures() {
  const { stride } = data.pictures;
  const frames = everyFrame.filter((frame) => frame % stride === 0);
  frames.sort((a, b) => Math.abs(a - pointed) - Math.abs(b - pointed));
  const waiting = frames.flatMap((frame) => methods.map((method) => keptFile(method, frame)));
  const next = () => {
    const file = waiting.shift();
    if (!file) return;
    const image = new Image();
    image.onload = image.onerror = next;
    image.src = file;
    heldPictures.push(image);
  };
  for (let i = 0; i < 6; ++i) next();
}

function addPictureFigure(method) {
  const figure = element("figure");
  const image = element("img", undefined, { alt: `the frame by ${method}` });
  const caption = element("figcaption");
  caption.append(methodDot(method), method);
  const link = element("a");
  link.append(image);
  figure.append(link, caption);
  byId("picture-row").append(figure);
  return { image, figure, link };
}

function addPictures() {
  if (!data.pictures && !data.frames_dir) return;
  byId("pictures").hidden = false;
  const figures = new Map(methods.map((method) => [method, addPictureFigure(method)]));
  const file = data.pictures ? keptFile : wholeFile;
  followers.push((frame) => {
    const pictured = picturedFrame(frame);
    byId("picture-number").textContent = pictured === frame ? "" : `as of frame ${pictured}, the nearest kept`;
    for (const [method, { image, figure, link }] of figures) {
      figure.hidden = !shown.has(method);
      image.src = file(method, pictured);
      if (data.frames_dir) link.href = wholeFile(method, frame);
    }
  });
  if (data.pictures) addEventListener("load", preloadPictures);
}
