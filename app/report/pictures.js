// The frames that --frames-dir kept.
function addPictures() {
  if (!data.frames_dir) return;
  byId("pictures").hidden = false;
  const images = new Map();
  for (const method of methods) {
    const figure = element("figure");
    const image = element("img", undefined, { alt: `the frame by ${method}` });
    images.set(method, image);
    figure.append(image, element("figcaption", method));
    byId("picture-row").append(figure);
  }
  followers.push((frame) => {
    for (const [method, image] of images) {
      image.src = `${data.frames_dir}/${method}/frame-${String(frame).padStart(5, "0")}.png`;
    }
    byId("picture-number").textContent = frame;
  });
}
