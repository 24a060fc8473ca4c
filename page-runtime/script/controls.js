// Mouse, fingers, wheel and keys. `changed` is called where the camera has moved; `pick` gives the place that is seen at a pixel.

function listen(changed, pick) {
  const fingers = new Map();
  const act = change => { change(); changed(); };
  const middle = () => {
    const all = [...fingers.values()];
    return { x: all.reduce((sum, f) => sum + f.x, 0) / all.length, y: all.reduce((sum, f) => sum + f.y, 0) / all.length,
      spread: all.length > 1 ? Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y) : 0 };
  };
  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  canvas.addEventListener("pointermove", event => {
    if (!fingers.has(event.pointerId)) return;
    const before = middle();
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const after = middle(), high = canvas.clientHeight;
    const x = (after.x - before.x) / high, y = (after.y - before.y) / high;
    const moves = fingers.size > 1 || event.buttons & 6 || event.shiftKey;
    act(() => {
      if (moves) camera.move(-2 * camera.tangent * x, 2 * camera.tangent * y);
      else camera.turn(-3.5 * x, -3.5 * y);
      if (before.spread && after.spread) camera.approach(after.spread / before.spread);
    });
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, event => fingers.delete(event.pointerId));
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? event.deltaY * 30 : event.deltaY;
    act(() => camera.approach(Math.exp(-Math.min(Math.max(lines, -300), 300) / 600)));
  }, { passive: false });
  canvas.addEventListener("dblclick", async event => {
    const place = await pick(event.clientX, event.clientY);
    if (place) act(() => camera.aim(camera.eye(), place));
  });
  const keys = {
    ArrowLeft: () => camera.turn(0.1, 0), ArrowRight: () => camera.turn(-0.1, 0),
    ArrowUp: () => camera.turn(0, 0.1), ArrowDown: () => camera.turn(0, -0.1),
    "+": () => camera.approach(1.15), "=": () => camera.approach(1.15), "-": () => camera.approach(1 / 1.15), 0: () => camera.reset(),
    x: () => camera.setParallel(!camera.isParallel),
    ...frameKeys,
    w: () => camera.move(0, 0, 0.06), s: () => camera.move(0, 0, -0.06), a: () => camera.move(-0.06, 0), d: () => camera.move(0.06, 0),
  };
  canvas.addEventListener("keydown", event => {
    const action = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act(action);
  });
  new ResizeObserver(changed).observe(canvas);
}
