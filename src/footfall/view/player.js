// Plays two takes of one body side by side: WebGL 2, no library. Reads the JSON in #data.

const data = JSON.parse(document.getElementById("data").textContent);
const COLORS = { R: "--right", L: "--left", D: "--double", "-": "--flight" };
const NAMES = { R: "right foot", L: "left foot", D: "both feet", "-": "flight" };
const LIGHT = [-0.55, 1.0, 0.5];
const SLIDING = 0.012; // a planted foot that moves farther is shown as sliding [m]

const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const unpack = (text, Kind) => new Kind(bytes(text).buffer);
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const rgb = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);

// ---------------------------------------------------------------- data

function readTake(take) {
  const roots = unpack(take.roots, Float32Array);
  const places = unpack(take.places, Int16Array);
  const rotations = unpack(take.rotations, Int16Array);
  const slid = unpack(take.slid, Uint16Array);
  const total = new Float32Array(slid.length / 2 + 1);
  for (let frame = 1; frame < slid.length / 2; frame++) {
    total[frame] = total[frame - 1];
    for (const foot of [0, 1]) {
      total[frame] += Math.max(0, slid[2 * frame + foot] - slid[2 * frame - 2 + foot]) / 1e4;
    }
  }
  return { ...take, roots, places, rotations, slid, total, centers: smoothed(roots, take.fps) };
}

// Where the camera looks: the way of the pelvis, averaged over about a second.
function smoothed(roots, fps) {
  const frames = roots.length / 3;
  const half = Math.round(0.5 * fps);
  const sums = new Float64Array(2 * (frames + 1));
  for (let f = 0; f < frames; f++) {
    sums[2 * f + 2] = sums[2 * f] + roots[3 * f];
    sums[2 * f + 3] = sums[2 * f + 1] + roots[3 * f + 2];
  }
  return Float32Array.from({ length: 2 * frames }, (_, i) => {
    const reach = Math.min(half, i >> 1, frames - 1 - (i >> 1));
    const [from, to] = [(i >> 1) - reach, (i >> 1) + reach + 1];
    return (sums[2 * to + (i & 1)] - sums[2 * from + (i & 1)]) / (to - from);
  });
}

// ---------------------------------------------------------------- matrices, column by column

function perspective(angle, aspect, near, far) {
  const f = 1 / Math.tan(angle / 2);
  const d = 1 / (near - far);
  return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) * d, -1, 0, 0, 2 * far * near * d, 0];
}

function lookAt(eye, target) {
  const unit = (v) => v.map((x) => x / Math.hypot(...v));
  const cross = (a, b) => [0, 1, 2].map((i) =>
    a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
  const z = unit(eye.map((x, i) => x - target[i]));
  const x = unit(cross([0, 1, 0], z));
  const y = cross(z, x);
  const along = (axis) => -axis.reduce((sum, value, i) => sum + value * eye[i], 0);
  return [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0,
    along(x), along(y), along(z), 1];
}

function times(a, b) {
  return Array.from({ length: 16 }, (_, i) =>
    [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + (i & 3)] * b[4 * (i >> 2) + k], 0));
}

// ---------------------------------------------------------------- shaders

const BODY_VERTEX = (joints) => `#version 300 es
uniform mat4 view; uniform float unit; uniform vec4 turned[${joints}]; uniform vec3 placed[${joints}];
uniform bool flat_; uniform vec3 light;
in vec3 position; in vec3 normal; in float joint; in float tone;
out vec3 n; out vec3 p; flat out int t;
vec3 turn(vec4 q, vec3 v) { return v + 2.0 * cross(q.yzw, cross(q.yzw, v) + q.x * v); }
void main() {
  int j = int(joint);
  vec4 q = normalize(turned[j]);
  p = placed[j] + turn(q, position * unit);
  n = turn(q, normal / 127.0);
  t = int(tone);
  if (flat_) p = vec3(p.x - light.x / light.y * p.y, 0.004, p.z - light.z / light.y * p.y);
  gl_Position = view * vec4(p, 1.0);
}`;

const BODY_FRAGMENT = `#version 300 es
precision highp float;
uniform vec3 tones[6]; uniform vec4 glow[2]; uniform vec3 light; uniform vec3 eye; uniform bool flat_;
in vec3 n; in vec3 p; flat in int t; out vec4 color;
void main() {
  if (flat_) { color = vec4(0.0, 0.0, 0.0, 0.26); return; }
  vec3 m = normalize(n);
  float sun = max(dot(m, normalize(light)), 0.0);
  float sky = 0.5 + 0.5 * m.y;
  float edge = pow(1.0 - max(dot(m, normalize(eye - p)), 0.0), 3.0);
  vec3 base = tones[t];
  if (t >= 4) base = mix(base, glow[t - 4].rgb, glow[t - 4].a);
  vec3 lit = base * (0.4 + 0.28 * sky + 0.44 * sun) + 0.08 * edge;
  if (t >= 4) lit = mix(lit, base, 0.35 * glow[t - 4].a);
  color = vec4(lit, 1.0);
}`;

const GROUND_VERTEX = `#version 300 es
uniform mat4 view; uniform vec2 center;
in vec2 corner; out vec2 p;
void main() { p = center + corner * 40.0; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`;

const GROUND_FRAGMENT = `#version 300 es
precision highp float;
uniform vec3 ground; uniform vec3 grid; uniform vec3 sky; uniform vec2 center;
in vec2 p; out vec4 color;
float lines(float step, float width) {
  vec2 q = p / step;
  vec2 d = abs(fract(q - 0.5) - 0.5) / fwidth(q);
  return 1.0 - clamp(min(d.x, d.y) - width, 0.0, 1.0);
}
void main() {
  float away = length(p - center);
  float fade = exp(-away * away / 90.0);
  vec3 c = mix(ground, grid, (0.85 * lines(1.0, 0.4) + 0.3 * lines(0.25, 0.0) * exp(-away * 0.3)) * fade);
  color = vec4(mix(sky, c, exp(-away * away / 260.0)), 1.0);
}`;

const MARK_VERTEX = `#version 300 es
uniform mat4 view;
in vec2 place; in vec4 paint; out vec4 c;
void main() { c = paint; gl_Position = view * vec4(place.x, 0.002, place.y, 1.0); }`;

const MARK_FRAGMENT = `#version 300 es
precision mediump float;
in vec4 c; out vec4 color;
void main() { color = c; }`;

function program(gl, vertex, fragment) {
  const made = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) {
    throw new Error(gl.getProgramInfoLog(made) || "a shader does not compile");
  }
  return { made, at: (name) => gl.getUniformLocation(made, name) };
}

function attribute(gl, shader, name, values, size, kind) {
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
  const slot = gl.getAttribLocation(shader.made, name);
  gl.enableVertexAttribArray(slot);
  gl.vertexAttribPointer(slot, size, kind, false, 0, 0);
}

// ---------------------------------------------------------------- marks on the ground

const SHOE = [[-0.27, 0.012], [-0.22, 0.025], [-0.1, 0.033], [0.1, 0.034], [0.45, 0.031],
  [0.7, 0.038], [0.95, 0.046], [1.15, 0.046], [1.3, 0.037], [1.41, 0.019]];

function shoeTriangles([heel, toe], shift) {
  const way = [toe[0] - heel[0], toe[1] - heel[1]];
  const length = Math.max(Math.hypot(...way), 0.06);
  const ahead = way.map((x) => x / Math.hypot(...way) || 0);
  const at = (along, wide) => [
    heel[0] + shift[0] + along * length * ahead[0] + wide * ahead[1],
    heel[1] + shift[1] + along * length * ahead[1] - wide * ahead[0]];
  const points = [];
  for (let i = 1; i < SHOE.length; i++) {
    const [a, b] = [SHOE[i - 1], SHOE[i]];
    points.push(at(a[0], a[1]), at(a[0], -a[1]), at(b[0], b[1]));
    points.push(at(b[0], b[1]), at(a[0], -a[1]), at(b[0], -b[1]));
  }
  return points;
}

function streakTriangles([, toe], end) {
  const length = Math.hypot(...end);
  const [x, z] = [end[0] / length * 0.012, end[1] / length * 0.012];
  const corners = [[toe[0] + z, toe[1] - x], [toe[0] - z, toe[1] + x],
    [toe[0] + end[0] + z, toe[1] + end[1] - x], [toe[0] + end[0] - z, toe[1] + end[1] + x]];
  return [0, 1, 2, 2, 1, 3].map((i) => corners[i]);
}

// Triangles in the order of time, and how many of them are there from each frame on.
function groundMarks(take) {
  const events = [];
  const [left, right, slip] = ["--left", "--right", "--slip"].map((name) => rgb(css(name)));
  for (const plant of take.plants) {
    const color = plant.foot ? right : left;
    events.push([plant.start, shoeTriangles(plant.print, [0, 0]), [...color, 0.6]]);
    if (plant.slip > SLIDING && Math.hypot(...plant.end) > 1e-6) {
      events.push([plant.stop, shoeTriangles(plant.print, plant.end), [...slip, 0.35]]);
      events.push([plant.stop, streakTriangles(plant.print, plant.end), [...slip, 1]]);
    }
  }
  events.sort((a, b) => a[0] - b[0]);
  const counts = events.map(([frame], i) => [
    frame, events.slice(0, i + 1).reduce((sum, event) => sum + event[1].length, 0)]);
  return {
    places: new Float32Array(events.flatMap((event) => event[1].flat())),
    paints: new Float32Array(events.flatMap((event) => event[1].flatMap(() => event[2]))),
    until: (frame) => counts.filter(([first]) => first <= frame).at(-1)?.[1] ?? 0,
  };
}

// ---------------------------------------------------------------- one player

class Player {
  constructor(figure, take) {
    this.take = take;
    this.canvas = figure.querySelector("canvas");
    this.slip = figure.querySelector(".slip");
    this.badges = [...figure.querySelectorAll(".foot")];
    this.gl = this.canvas.getContext("webgl2", { alpha: false, antialias: true, stencil: true });
    if (!this.gl) {
      this.canvas.insertAdjacentHTML("afterend",
        '<p class="broken">This browser offers no WebGL 2; the pictures below show the same.</p>');
      return;
    }
    this.build();
  }

  build() {
    const gl = this.gl;
    const mesh = data.mesh;
    this.body = program(gl, BODY_VERTEX(this.take.joints), BODY_FRAGMENT);
    this.bodyArray = gl.createVertexArray();
    gl.bindVertexArray(this.bodyArray);
    attribute(gl, this.body, "position", unpack(mesh.positions, Int16Array), 3, gl.SHORT);
    attribute(gl, this.body, "normal", unpack(mesh.normals, Int8Array), 3, gl.BYTE);
    attribute(gl, this.body, "joint", unpack(mesh.joints, Uint8Array), 1, gl.UNSIGNED_BYTE);
    attribute(gl, this.body, "tone", unpack(mesh.tones, Uint8Array), 1, gl.UNSIGNED_BYTE);
    const triangles = unpack(mesh.triangles, Uint16Array);
    this.count = triangles.length;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
    this.ground = program(gl, GROUND_VERTEX, GROUND_FRAGMENT);
    this.groundArray = gl.createVertexArray();
    gl.bindVertexArray(this.groundArray);
    attribute(gl, this.ground, "corner", new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]), 2, gl.FLOAT);
    this.mark = program(gl, MARK_VERTEX, MARK_FRAGMENT);
    this.marks = groundMarks(this.take);
    this.markArray = gl.createVertexArray();
    gl.bindVertexArray(this.markArray);
    attribute(gl, this.mark, "place", this.marks.places, 2, gl.FLOAT);
    attribute(gl, this.mark, "paint", this.marks.paints, 4, gl.FLOAT);
    gl.bindVertexArray(null);
  }

  // State of a foot at a time: whether it is commanded to carry, and how it slides.
  foot(side, time) {
    const symbol = supportAt(time);
    const at = clamp(Math.round(time * data.rate), 0, this.take.slid.length / 2 - 1);
    const slid = this.take.slid[2 * at + side] / 1e4;
    const before = this.take.slid[2 * Math.max(at - 4, 0) + side] / 1e4;
    const speed = Math.max(0, slid - before) * data.rate / 4;
    return {
      down: symbol === "D" || symbol === (side ? "R" : "L"),
      sliding: clamp((speed - 0.05) / 0.15, 0, 1),
      slid,
    };
  }

  draw(time, camera) {
    const feet = [this.foot(0, time), this.foot(1, time)];
    this.label(time, feet);
    if (!this.gl) return;
    const gl = this.gl;
    const scale = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight].map(
      (size) => Math.max(1, Math.round(size * scale)));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      Object.assign(this.canvas, { width, height });
    }
    const frame = clamp(time * this.take.fps, 0, this.take.frames - 1);
    const base = Math.floor(frame);
    const center = [this.take.centers[2 * base], this.take.centers[2 * base + 1]];
    const target = [center[0], 0.82, center[1]];
    const eye = [
      target[0] + camera.distance * Math.cos(camera.pitch) * Math.sin(camera.yaw),
      target[1] + camera.distance * Math.sin(camera.pitch),
      target[2] + camera.distance * Math.cos(camera.pitch) * Math.cos(camera.yaw)];
    const view = times(perspective(0.6, width / height, 0.05, 120), lookAt(eye, target));
    gl.viewport(0, 0, width, height);
    gl.clearColor(...rgb(css("--sky")), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    this.drawGround(view, center);
    this.drawMarks(view, time);
    this.drawBody(view, eye, this.pose(frame), feet);
  }

  drawGround(view, center) {
    const gl = this.gl;
    gl.useProgram(this.ground.made);
    gl.uniformMatrix4fv(this.ground.at("view"), false, view);
    gl.uniform2fv(this.ground.at("center"), center);
    for (const name of ["ground", "grid", "sky"]) {
      gl.uniform3fv(this.ground.at(name), rgb(css(`--${name}`)));
    }
    gl.bindVertexArray(this.groundArray);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }

  drawMarks(view, time) {
    const gl = this.gl;
    gl.useProgram(this.mark.made);
    gl.uniformMatrix4fv(this.mark.at("view"), false, view);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    gl.disable(gl.DEPTH_TEST);
    gl.bindVertexArray(this.markArray);
    gl.drawArrays(gl.TRIANGLES, 0, this.marks.until(time * data.rate));
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  drawBody(view, eye, pose, feet) {
    const gl = this.gl;
    const at = this.body.at;
    gl.useProgram(this.body.made);
    gl.uniformMatrix4fv(at("view"), false, view);
    gl.uniform1f(at("unit"), data.mesh.unit);
    gl.uniform4fv(at("turned"), pose.turned);
    gl.uniform3fv(at("placed"), pose.placed);
    gl.uniform3fv(at("light"), LIGHT);
    gl.uniform3fv(at("eye"), eye);
    gl.uniform3fv(at("tones"), TONES.flat());
    const slip = rgb(css("--slip"));
    const flash = 0.8 + 0.2 * Math.cos(performance.now() / 60);
    const glow = feet.map((foot, side) => {
      if (foot.sliding > 0.05) return [...slip, (0.55 + 0.45 * foot.sliding) * flash];
      return [...rgb(css(side ? "--right" : "--left")), foot.down ? 1 : 0];
    });
    gl.uniform4fv(at("glow"), glow.flat());
    gl.bindVertexArray(this.bodyArray);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilFunc(gl.EQUAL, 0, 255);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
    gl.enable(gl.BLEND);
    gl.uniform1i(at("flat_"), 1);
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_SHORT, 0);
    gl.disable(gl.STENCIL_TEST);
    gl.disable(gl.BLEND);
    gl.uniform1i(at("flat_"), 0);
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_SHORT, 0);
  }

  // Joints between two frames: places linearly, rotations the short way round.
  pose(frame) {
    const { joints, frames, roots, places, rotations } = this.take;
    const base = Math.min(Math.floor(frame), frames - 1);
    const next = Math.min(base + 1, frames - 1);
    const share = frame - base;
    const turned = new Float32Array(4 * joints);
    const placed = new Float32Array(3 * joints);
    for (let j = 0; j < joints; j++) {
      const [a, b] = [4 * (base * joints + j), 4 * (next * joints + j)];
      let cosine = 0;
      for (let i = 0; i < 4; i++) cosine += rotations[a + i] * rotations[b + i];
      const sign = cosine < 0 ? -share : share;
      for (let i = 0; i < 4; i++) {
        turned[4 * j + i] = ((1 - share) * rotations[a + i] + sign * rotations[b + i]) / 32767;
      }
      for (let i = 0; i < 3; i++) {
        const at = (f) => roots[3 * f + i] + places[3 * (f * joints + j) + i] * data.mesh.unit;
        placed[3 * j + i] = (1 - share) * at(base) + share * at(next);
      }
    }
    return { turned, placed };
  }

  label(time, feet) {
    const at = clamp(Math.round(time * data.rate), 0, this.take.slid.length / 2 - 1);
    const total = this.take.total[at];
    this.slip.innerHTML = `planted feet have slid <b>${(100 * total).toFixed(0)} cm</b>`;
    this.slip.classList.toggle("bad", total > 0.15);
    feet.forEach((foot, side) => {
      this.badges[side].classList.toggle("down", foot.down);
      this.badges[side].classList.toggle("slides", foot.down && foot.sliding > 0.05);
    });
  }
}

const TONES = [[0.83, 0.81, 0.78], [0.2, 0.22, 0.25], [0.55, 0.69, 0.8], [0.87, 0.69, 0.51],
  [0.3, 0.42, 0.52], [0.55, 0.43, 0.3]];

// ---------------------------------------------------------------- the page

const takes = data.takes.map(readTake);
const duration = Math.max(...takes.map((take) => (take.frames - 1) / take.fps));
const weights = data.actions.map((action) => unpack(action.weights, Uint8Array));
const camera = { yaw: -1.15, pitch: 0.22, distance: 3.7 };
const players = [...document.querySelectorAll(".player")].map(
  (figure, index) => new Player(figure, takes[index]));
const byId = (id) => document.getElementById(id);
const state = { time: 0, speed: 1, playing: !matchMedia("(prefers-reduced-motion: reduce)").matches };

function supportAt(time) {
  return data.supports[clamp(Math.floor(time * data.scheduleRate), 0, data.supports.length - 1)];
}

function seek(time) {
  state.time = clamp(time, 0, duration);
}

function play(playing) {
  state.playing = playing;
  byId("play").textContent = playing ? "Pause" : "Play";
}

function buildControls() {
  for (const [speed, label] of [[1, "1×"], [0.5, "½×"], [0.25, "¼×"], [0.1, "⅒×"]]) {
    const button = document.createElement("button");
    button.textContent = label;
    button.setAttribute("aria-pressed", speed === 1);
    button.onclick = () => {
      state.speed = speed;
      for (const other of button.parentElement.children) {
        other.setAttribute("aria-pressed", other === button);
      }
    };
    document.querySelector(".speeds").append(button);
  }
  byId("actions").innerHTML = data.actions.map((action) => '<div class="action"><b></b>'
    + "<i></i><span></span></div>").join("");
  data.actions.forEach((action, i) => {
    byId("actions").children[i].firstChild.textContent = action.name;
  });
  byId("play").onclick = () => play(!state.playing);
  byId("scrub").oninput = (event) => {
    play(false);
    seek(event.target.value * duration);
  };
  addEventListener("keydown", (event) => {
    if (event.target.matches("button,input") && event.key === " ") return;
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (event.key === " ") play(!state.playing);
    else if (step) { play(false); seek(state.time + step / data.rate); }
    else return;
    event.preventDefault();
  });
}

function buildCamera() {
  for (const { canvas } of players) {
    canvas.onpointerdown = (event) => canvas.setPointerCapture(event.pointerId);
    canvas.onpointermove = (event) => {
      if (!canvas.hasPointerCapture(event.pointerId)) return;
      camera.yaw -= event.movementX * 0.008;
      camera.pitch = clamp(camera.pitch + event.movementY * 0.006, -0.02, 1.5);
    };
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      camera.distance = clamp(camera.distance * Math.exp(event.deltaY * 0.001), 1.2, 14);
    }, { passive: false });
  }
}

// The schedule picture says where its time axis lies; a line follows the time, a click sets it.
function buildPlayhead() {
  const box = byId("schedule");
  const { left, right, width, duration: seconds } = box.querySelector("svg").dataset;
  const line = box.appendChild(Object.assign(document.createElement("div"), { id: "playhead" }));
  const set = (event) => {
    const area = box.getBoundingClientRect();
    const x = (event.clientX - area.left) / area.width * width;
    seek((x - left) / (right - left) * seconds);
  };
  box.onpointerdown = (event) => { box.setPointerCapture(event.pointerId); play(false); set(event); };
  box.onpointermove = (event) => { if (box.hasPointerCapture(event.pointerId)) set(event); };
  return () => {
    const share = (+left + Math.min(state.time / seconds, 1) * (right - left)) / width;
    line.style.left = `${100 * share}%`;
  };
}

function showNow() {
  const symbol = supportAt(state.time);
  byId("support").innerHTML = `<b style="background:var(${COLORS[symbol]})">`
    + `${symbol === "-" ? "–" : symbol}</b><span>${NAMES[symbol]}</span>`;
  weights.forEach((each, i) => {
    const frame = clamp(Math.round(state.time * data.scheduleRate), 0, each.length - 1);
    const weight = each[frame] / 255;
    const box = byId("actions").children[i];
    box.classList.toggle("idle", weight === 0);
    box.style.setProperty("--weight", weight);
    box.lastChild.textContent = `${Math.round(100 * weight)} %`;
  });
  byId("clock").textContent = `${state.time.toFixed(2)} s`;
  byId("scrub").value = state.time / duration;
}

buildControls();
buildCamera();
const movePlayhead = buildPlayhead();
play(state.playing);
let last = performance.now();

function tick(now) {
  if (state.playing) {
    seek(state.time + Math.min((now - last) / 1000, 0.1) * state.speed);
    if (state.time >= duration) state.time = 0;
  }
  last = now;
  for (const player of players) player.draw(state.time, camera);
  showNow();
  movePlayhead();
  requestAnimationFrame(tick);
}

// For tests and scripts: ?t=SECONDS shows that instant, paused.
const asked = new URLSearchParams(location.search).get("t");
if (asked !== null) {
  play(false);
  seek(+asked);
}
requestAnimationFrame(tick);
