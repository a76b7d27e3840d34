// A canvas that follows its box and the sharpness of the screen, and small things to draw with.

export const INK = "#1d2228";
export const SOFT = "#66707c";
export const RULE = "#dde1e6";
const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';

export const canvas = document.querySelector("#timeline canvas");
export const pen = canvas.getContext("2d");
export const size = { width: 0, height: 0 };

export function fit() {
  const { clientWidth: width, clientHeight: height } = canvas;
  const sharp = window.devicePixelRatio || 1;
  if (canvas.width !== Math.round(width * sharp) || canvas.height !== Math.round(height * sharp)) {
    canvas.width = Math.round(width * sharp);
    canvas.height = Math.round(height * sharp);
  }
  size.width = width;
  size.height = height;
  pen.setTransform(sharp, 0, 0, sharp, 0, 0);
  pen.clearRect(0, 0, width, height);
}

export function words(text, x, y, { color = INK, size: points = 12.5, weight = 400, align = "left",
  most } = {}) {
  pen.font = `${weight} ${points}px ${FONT}`;
  pen.fillStyle = color;
  pen.textAlign = align;
  pen.textBaseline = "alphabetic";
  if (most) while (text.length > 2 && pen.measureText(text).width > most) text = `${text.slice(0, -2)}…`;
  pen.fillText(text, x, y);
}

export function line(x0, y0, x1, y1, color = RULE, width = 1, dash = []) {
  pen.strokeStyle = color;
  pen.lineWidth = width;
  pen.setLineDash(dash);
  pen.beginPath();
  pen.moveTo(x0, y0);
  pen.lineTo(x1, y1);
  pen.stroke();
  pen.setLineDash([]);
}

export function block(x, y, width, height, color, alpha = 1, radius = 0) {
  pen.globalAlpha = alpha;
  pen.fillStyle = color;
  pen.beginPath();
  pen.roundRect(x, y, width, height, Math.max(0, Math.min(radius, width / 2, height / 2)));
  pen.fill();
  pen.globalAlpha = 1;
}

const tile = document.createElement("canvas");
tile.width = tile.height = 8;
const grain = tile.getContext("2d");
grain.strokeStyle = "#10151a";
grain.globalAlpha = 0.42;
grain.lineWidth = 2;
for (const shift of [-8, 0, 8]) {
  grain.beginPath();
  grain.moveTo(shift - 1, 9);
  grain.lineTo(shift + 9, -1);
  grain.stroke();
}
export const hatching = pen.createPattern(tile, "repeat");

export const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
export const letter = (symbol) => (symbol === "-" ? "–" : symbol);

// Marks of an axis: whole numbers of a step that leaves each of them room.
export function ticks(from, to, width, room = 70) {
  const least = (to - from) * room / Math.max(width, 1);
  const step = [0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 60, 120, 300].find((each) => each >= least) ?? 600;
  const found = [];
  for (let tick = Math.ceil(from / step - 1e-9) * step; tick <= to + 1e-9; tick += step) {
    found.push([tick, step < 0.1 ? tick.toFixed(2) : step < 1 ? tick.toFixed(1) : tick.toFixed(0)]);
  }
  return found;
}
