// What was embedded, unpacked: takes, their camera paths, and small mathematics.

const data = JSON.parse(document.getElementById("data").textContent);
const COLORS = { R: "--right", L: "--left", D: "--double", "-": "--flight" };
const NAMES = { R: "right foot", L: "left foot", D: "both feet", "-": "flight" };
const LIGHT = [-0.55, 1.0, 0.5];
const SLIDING = 0.015; // a planted foot that moves farther is shown as sliding [m]

const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const unpack = (text, Kind) => new Kind(bytes(text).buffer);
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const rgb = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);

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
