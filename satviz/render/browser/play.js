// The widget of sv.play: the player, with files made by the kernel.

function render({ model, el }) {
  const asks = (form, step, which) => model.send({ kind: "save", form, step, which });
  const player = new Player(el.appendChild(element("div")), model.get("shows"), { predict: model.get("predict"), narrow: model.get("narrow") ?? [], save: asks, link: model.get("link"), site: model.get("site") });
  const heard = (content, buffers) => {
    if (content.kind === "file") download(content, buffers);
    else if (content.kind === "refused") player.done.textContent = content.why;
  };
  model.on("msg:custom", heard);
  return () => {
    model.off("msg:custom", heard);
    player.remove();
  };
}

export default { render };
