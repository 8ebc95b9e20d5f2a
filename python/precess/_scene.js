// A run as a moving picture: the scene on the left, graphs with a cursor on the right, a time line and sliders below.
// It knows no mechanics: `_widget.py` says which columns are places, what is joined, and what is drawn over what.

const WIDTH = 760;
const HEIGHT = 340;
const INKS = ["#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17becf", "#8c564b", "#e377c2"];
/** How many samples a trail reaches back. */
const TRAIL = 600;

/** The columns of a run as arrays of doubles. */
function columns(run) {
  const view = run.numbers;
  const bytes = view.buffer.slice(view.byteOffset, view.byteOffset + view.byteLength);
  const all = new Float64Array(bytes);
  return run.columns.map((_, k) => all.subarray(k * run.samples, (k + 1) * run.samples));
}

function range(arrays) {
  let [low, high] = [Infinity, -Infinity];
  for (const array of arrays)
    for (const x of array) {
      if (x < low) low = x;
      if (x > high) high = x;
    }
  if (!(low <= high)) return [-1, 1];
  const room = (high - low) * 0.06 || Math.abs(low) * 0.1 || 1;
  return [low - room, high + room];
}

/** Round numbers inside a range. */
function ticks([low, high], most) {
  const rough = (high - low) / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((n) => n * power).find((n) => n >= rough);
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, k) => (first + k) * step);
}

const short = (x) => String(Number(x.toPrecision(4)));

/** Draws a run at a place in time, a number of samples that need not be whole. */
function picture(canvas, run, data, turn) {
  const pixels = window.devicePixelRatio || 1;
  canvas.width = WIDTH * pixels;
  canvas.height = HEIGHT * pixels;
  const pen = canvas.getContext("2d");
  pen.scale(pixels, pixels);
  const style = getComputedStyle(canvas);
  const ink = style.color;
  pen.font = `11px ${style.fontFamily}`;
  const scene = run.scene;
  const panels = run.graphs.length;
  const split = scene ? (panels ? HEIGHT : WIDTH) : 0;
  const projected = scene && project(scene, data, turn, { width: split, height: HEIGHT });

  return (time) => {
    pen.clearRect(0, 0, WIDTH, HEIGHT);
    const k = Math.min(Math.floor(time), run.samples - 1);
    if (projected) drawScene(pen, ink, scene, projected, time, k);
    run.graphs.forEach((graph, number) => {
      const height = HEIGHT / panels;
      const box = { left: split + 52, top: number * height + 20, right: WIDTH - 8, bottom: (number + 1) * height - 34 };
      drawGraph(pen, ink, graph, data, box, k);
    });
  };
}

/** Where the places of a scene lie on the canvas. */
function project(scene, data, turn, size) {
  const solid = scene.bodies.some((body) => body.length > 2);
  const [c, s, cc, ss] = [Math.cos(turn.round), Math.sin(turn.round), Math.cos(turn.up), Math.sin(turn.up)];
  const flat = solid ? (x, y, z) => [c * y - s * x, cc * z - ss * (c * x + s * y)] : (x, y) => [x, y];
  const at = (body, k) => body.map((column) => data[column][k]);
  let [left, right] = [Infinity, -Infinity];
  let [low, high] = [Infinity, -Infinity];
  const see = ([x, y], room = 0) => {
    if (!Number.isFinite(x + y)) return;
    left = Math.min(left, x - room);
    right = Math.max(right, x + room);
    low = Math.min(low, y - room);
    high = Math.max(high, y + room);
  };
  const count = data[0].length;
  const stride = Math.max(1, Math.floor(count / 2000));
  for (const body of scene.bodies) for (let k = 0; k < count; k += stride) see(flat(...at(body, k)));
  for (const mark of scene.marks) see(flat(...mark, 0));
  if (scene.rods.some(([from]) => from < 0)) see(flat(0, 0, 0));
  if (scene.sphere) see([0, 0], scene.sphere);
  if (!(left <= right)) [left, right, low, high] = [-1, 1, -1, 1];
  const reach = Math.max((right - left) / size.width, (high - low) / size.height) * 1.16 || 2 / size.height;
  const [x0, y0] = [(left + right) / 2, (low + high) / 2];
  const onto = (place) => {
    const [x, y] = flat(...place);
    return [size.width / 2 + (x - x0) / reach, size.height / 2 - (y - y0) / reach];
  };
  const between = (body, time) => {
    const k = Math.min(Math.floor(time), count - 1);
    const [a, b, share] = [at(body, k), at(body, Math.min(k + 1, count - 1)), time - k];
    return a.map((x, i) => x + (b[i] - x) * share);
  };
  const trails = scene.bodies.map((body) => Array.from({ length: count }, (_, k) => onto(at(body, k))));
  return { onto, trails, scale: 1 / reach, now: (body, time) => onto(between(body, time)) };
}

function drawScene(pen, ink, scene, { onto, trails, scale, now }, time, k) {
  const origin = onto([0, 0, 0]);
  if (scene.sphere) {
    pen.strokeStyle = ink;
    pen.globalAlpha = 0.25;
    pen.beginPath();
    pen.arc(...origin, scene.sphere * scale, 0, 2 * Math.PI);
    pen.stroke();
    for (const height of [-0.5, 0, 0.5]) {
      const radius = Math.sqrt(1 - height * height);
      stroke(
        pen,
        Array.from({ length: 73 }, (_, j) => {
          const angle = (j * Math.PI) / 36;
          return onto([radius * Math.cos(angle), radius * Math.sin(angle), height].map((x) => x * scene.sphere));
        }),
      );
    }
    stroke(pen, [origin, onto([0, 0, scene.sphere])]);
    pen.globalAlpha = 1;
  }
  scene.marks.forEach((mark, j) => dot(pen, onto([...mark, 0]), 7, INKS[(j + 1) % INKS.length], true));
  trails.forEach((trail, j) => {
    pen.strokeStyle = INKS[j % INKS.length];
    const from = Math.max(0, k - TRAIL);
    // Older pieces are fainter.
    for (let piece = 0; piece < 4; piece++) {
      const [a, b] = [piece, piece + 1].map((n) => from + Math.floor(((k - from) * n) / 4));
      pen.globalAlpha = 0.2 + 0.2 * piece;
      stroke(pen, [...trail.slice(a, b + 1), ...(piece === 3 ? [now(scene.bodies[j], time)] : [])]);
    }
    pen.globalAlpha = 1;
  });
  const places = scene.bodies.map((body) => now(body, time));
  pen.strokeStyle = ink;
  pen.lineWidth = 2.5;
  for (const [from, to] of scene.rods) stroke(pen, [from < 0 ? origin : places[from], places[to]]);
  pen.lineWidth = 1;
  if (scene.rods.some(([from]) => from < 0)) dot(pen, origin, 3, ink);
  places.forEach((place, j) => dot(pen, place, scene.bodies.length > 4 ? 3 : 7, INKS[j % INKS.length]));
}

function stroke(pen, points) {
  pen.beginPath();
  for (const [x, y] of points) pen.lineTo(x, y);
  pen.stroke();
}

function dot(pen, [x, y], radius, colour, ring = false) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fillStyle = pen.strokeStyle = colour;
  if (ring) pen.stroke();
  else pen.fill();
}

function drawGraph(pen, ink, graph, data, box, k) {
  const x = data[graph.x];
  const ys = graph.y.map((column) => data[column]);
  const [across, upwards] = [range([x]), range(ys)];
  const px = (value) => box.left + ((value - across[0]) / (across[1] - across[0])) * (box.right - box.left);
  const py = (value) => box.bottom - ((value - upwards[0]) / (upwards[1] - upwards[0])) * (box.bottom - box.top);
  pen.fillStyle = pen.strokeStyle = ink;
  pen.textAlign = "center";
  for (const value of ticks(across, 6)) {
    line(pen, 0.12, [px(value), box.top], [px(value), box.bottom]);
    pen.fillText(short(value), px(value), box.bottom + 13);
  }
  pen.fillText(graph.x_label, (box.left + box.right) / 2, box.bottom + 27);
  pen.textAlign = "right";
  for (const value of ticks(upwards, 5)) {
    line(pen, 0.12, [box.left, py(value)], [box.right, py(value)]);
    pen.fillText(short(value), box.left - 5, py(value) + 4);
  }
  pen.textAlign = "left";
  pen.fillText(graph.y_label, box.left, box.top - 7);
  ys.forEach((y, j) => {
    pen.strokeStyle = INKS[j % INKS.length];
    pen.beginPath();
    y.forEach((value, n) => pen.lineTo(px(x[n]), py(value)));
    pen.stroke();
    dot(pen, [px(x[k]), py(y[k])], 4, INKS[j % INKS.length]);
  });
}

function line(pen, alpha, from, to) {
  pen.globalAlpha = alpha;
  stroke(pen, [from, to]);
  pen.globalAlpha = 1;
}

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

function render({ model, el }) {
  const title = element("div", { className: "precess-title" });
  const canvas = element("canvas", { className: "precess-canvas" });
  const play = element("button", { type: "button" });
  const line = element("input", { type: "range", min: 0, step: "any", ariaLabel: "time" });
  const clock = element("span", { className: "precess-clock" });
  const sliders = element("div", { className: "precess-sliders" });
  const problem = element("div", { className: "precess-problem", role: "alert" });
  el.replaceChildren(
    element("div", { className: "precess" }, title, canvas, element("div", {}, play, line, clock), sliders, problem),
  );

  const turn = { round: 0.5, up: 0.35 };
  let [run, data, draw, frame] = [null, [], () => {}, 0];
  let [time, before, playing] = [0, 0, model.get("playing")];

  const show = () => {
    draw(time);
    line.value = time;
    const k = Math.min(Math.floor(time), run.samples - 1);
    clock.textContent = `t = ${data[run.time][k].toFixed(2)} s`;
    play.textContent = playing ? "⏸" : "▶";
    play.ariaLabel = playing ? "pause" : "play";
  };
  const step = (now) => {
    const seconds = Math.min((now - before) / 1000, 0.1);
    before = now;
    time += (seconds * model.get("speed") * (run.samples - 1)) / run.length;
    if (time >= run.samples - 1) time = 0;
    show();
    frame = playing ? requestAnimationFrame(step) : 0;
  };
  const go = (on) => {
    playing = on && run.samples > 1;
    cancelAnimationFrame(frame);
    if (playing) {
      before = performance.now();
      frame = requestAnimationFrame(step);
    }
    show();
  };
  const take = () => {
    run = model.get("run");
    data = columns(run);
    title.textContent = run.title;
    line.max = run.samples - 1;
    // The same time goes on in the new run, where it has one.
    time = Math.min(time, run.samples - 1);
    draw = picture(canvas, run, data, turn);
    show();
  };
  const offer = () =>
    sliders.replaceChildren(
      ...model.get("sliders").map(({ name, low, high, value: given, unit }) => {
        const value = model.get("wish")[name] ?? given;
        const input = element("input", { type: "range", min: low, max: high, step: (high - low) / 200, value });
        const told = element("output", { textContent: `${short(value)} ${unit}` });
        input.oninput = () => {
          told.textContent = `${short(Number(input.value))} ${unit}`;
          model.set("wish", { ...model.get("wish"), [name]: Number(input.value) });
          model.save_changes();
        };
        return element("label", {}, element("span", { textContent: name }), input, told);
      }),
    );
  const complain = () => (problem.textContent = model.get("problem"));

  play.onclick = () => go(!playing);
  line.oninput = () => {
    time = Number(line.value);
    show();
  };
  canvas.onpointermove = (event) => {
    if (!event.buttons || !run.scene?.bodies.some((body) => body.length > 2)) return;
    turn.round -= event.movementX / 120;
    turn.up = Math.max(-1.5, Math.min(1.5, turn.up + event.movementY / 120));
    draw = picture(canvas, run, data, turn);
    show();
  };
  model.on("change:run", take);
  model.on("change:sliders", offer);
  model.on("change:problem", complain);
  const follow = () => go(model.get("playing"));
  model.on("change:playing", follow);
  take();
  offer();
  complain();
  go(playing);
  return () => {
    cancelAnimationFrame(frame);
    playing = false;
    for (const [name, heard] of [["run", take], ["sliders", offer], ["problem", complain], ["playing", follow]])
      model.off(`change:${name}`, heard);
  };
}

export default { render };
