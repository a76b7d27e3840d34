// Shaders, and the marks that feet leave on the ground. WebGL 2, no library.

const TONES = [[0.83, 0.81, 0.78], [0.2, 0.22, 0.25], [0.55, 0.69, 0.8], [0.87, 0.69, 0.51],
  [0.3, 0.42, 0.52], [0.55, 0.43, 0.3]];

const BODY_VERTEX = (joints) => `#version 300 es
uniform mat4 view; uniform float unit; uniform vec4 turned[${joints}]; uniform vec3 placed[${joints}]; uniform vec3 rest[${joints}];
uniform bool flat_; uniform vec3 light;
in vec3 position; in vec3 normal; in float joint; in float other; in float share; in float tone;
out vec3 n; out vec3 p; flat out int t;
vec3 turn(vec4 q, vec3 v) { return v + 2.0 * cross(q.yzw, cross(q.yzw, v) + q.x * v); }
void main() {
  int j = int(joint);
  int o = int(other);
  vec4 q = normalize(turned[j]);
  vec4 r = normalize(turned[o]);
  float s = share / 255.0;
  vec3 own = placed[j] + turn(q, position * unit);
  p = mix(own, placed[o] + turn(r, (position + rest[j] - rest[o]) * unit), s);
  n = mix(turn(q, normal), turn(r, normal), s);
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
