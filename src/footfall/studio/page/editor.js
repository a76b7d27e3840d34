// The support editor: curves, thresholds that are dragged, bands that are dragged, split, deleted.

import { COLORS, FEET, known, on, say } from "./link.js";
import { block, canvas, clamp, INK, letter, line, pen, RULE, size, SOFT, ticks, words } from "./canvas.js";

const LEFT = 118;
const RIGHT = 18;
const GRIP = 7;
const box = document.getElementById("editing");
let held = null; // What the pointer holds: {kind, foot, band, side}
let chosen = null; // The band that keys act on: {foot, band}
let hover = null;
const queue = [];
let sending = false;

// While something is dragged only its latest place matters: one message is on its way at a time.
async function stream(word, fields) {
  if (queue.at(-1)?.[0] === word) queue.pop();
  queue.push([word, fields]);
  if (sending) return;
  sending = true;
  while (queue.length) await say(...queue.shift());
  sending = false;
}

function layout() {
  const { width, height } = size;
  const clip = known.clip;
  const span = width - LEFT - RIGHT;
  const bottom = height - 22;
  const bandTall = clamp(height * 0.075, 24, 34);
  const opinion = 11;
  const feet = 2 * (bandTall + opinion + 12);
  const resultTall = 22;
  const plots = bottom - 18 - feet - resultTall - 14;
  const each = plots / 2 - 10;
  const top = 22;
  const heightPlot = { top, tall: each };
  const speedPlot = { top: top + each + 18, tall: each };
  const first = top + 2 * each + 34;
  const lanes = [0, 1].map((foot) => ({ top: first + foot * (bandTall + opinion + 12), tall: bandTall, opinion }));
  return {
    width, height, bottom, span, lanes, heightPlot, speedPlot,
    result: { top: first + feet - 2, tall: resultTall },
    x: (time) => LEFT + (time / clip.duration) * span,
    time: (x) => clamp((x - LEFT) / span, 0, 1) * clip.duration,
    highest: Math.max(0.12, 1.6 * known.edit.height, Math.min(0.9, most(clip.heights))),
    fastest: Math.max(1.0, 1.6 * known.edit.speed, Math.min(8, most(clip.speeds))),
  };
}

const most = (rows) => Math.max(...rows.map((row) => row.reduce((a, b) => Math.max(a, b), 0)));

export function draw() {
  if (!known.clip || !known.edit) return;
  const at = layout();
  const { clip, edit } = known;
  for (const [time, label] of ticks(0, clip.duration, at.span)) {
    line(at.x(time), 12, at.x(time), at.bottom, RULE);
    words(label + (time < 1e-9 ? " s" : ""), at.x(time), at.height - 6, { color: SOFT, size: 11, align: "center" });
  }
  plot(at, at.heightPlot, clip.heights, edit.height, at.highest, "height", "m", "height");
  plot(at, at.speedPlot, clip.speeds, edit.speed, at.fastest, "speed", "m/s", "speed");
  for (const foot of [0, 1]) drawFoot(at, foot);
  drawResult(at);
  const now = at.x(known.time);
  line(now, 10, now, at.bottom, "#d7263d", 1.6);
  block(now - 5, 4, 10, 9, "#d7263d", 1, 3);
}

function plot(at, area, rows, limit, highest, name, unit, kind) {
  const y = (value) => area.top + area.tall * (1 - clamp(value / highest, 0, 1.03));
  words(name, 14, area.top + 12, { weight: 600 });
  words("lowest point", 14, area.top + 28, { color: SOFT, size: 11 });
  words(`${highest.toFixed(highest < 1 ? 2 : 1)} ${unit}`, LEFT - 6, area.top + 9, { color: SOFT, size: 10.5, align: "right" });
  words("0", LEFT - 6, area.top + area.tall + 3, { color: SOFT, size: 10.5, align: "right" });
  line(LEFT, area.top + area.tall + 0.5, LEFT + at.span, area.top + area.tall + 0.5, RULE);
  block(LEFT, y(limit), at.span, area.top + area.tall - y(limit), "#35a47a", 0.07);
  pen.save();
  pen.beginPath();
  pen.rect(LEFT, area.top - 3, at.span, area.tall + 5);
  pen.clip();
  rows.forEach((row, foot) => {
    pen.strokeStyle = FEET[foot];
    pen.lineWidth = 1.8;
    pen.lineJoin = "round";
    pen.beginPath();
    const stride = Math.max(1, Math.floor(row.length / (2 * at.span)));
    for (let i = 0; i < row.length; i += stride) pen.lineTo(at.x(i / known.clip.fps), y(row[i]));
    pen.stroke();
  });
  pen.restore();
  const grabbed = held?.kind === kind || hover?.kind === kind;
  line(LEFT, y(limit), LEFT + at.span, y(limit), grabbed ? INK : "#2b7f60", grabbed ? 2 : 1.4, [6, 4]);
  const text = `${limit.toFixed(kind === "height" ? 3 : 2)} ${unit}`;
  pen.font = "600 11px system-ui, sans-serif";
  const wide = pen.measureText(text).width + 14;
  block(LEFT + at.span - wide, y(limit) - 9, wide, 18, grabbed ? INK : "#2b7f60", 1, 5);
  words(text, LEFT + at.span - wide / 2, y(limit) + 4, { color: "#fff", size: 11, weight: 600, align: "center" });
}

// A band that goes on over the end of a cycle is drawn at both ends.
const copies = (band) => (known.clip.cyclic && band[1] > known.clip.duration ? [0, -known.clip.duration] : [0]);

function drawFoot(at, foot) {
  const { edit } = known;
  const lane = at.lanes[foot];
  words(foot ? "right foot" : "left foot", 14, lane.top + lane.opinion + lane.tall / 2 + 4, { weight: 600, color: INK });
  words("detector", LEFT - 6, lane.top + 8.5, { color: SOFT, size: 10, align: "right" });
  pen.save();
  pen.beginPath();
  pen.rect(LEFT, 0, at.span, at.height);
  pen.clip();
  for (const [start, end, sureStart, sureEnd] of edit.opinion[foot]) {
    for (const turn of copies([start, end])) opinionBar(at, lane, foot, start + turn, end + turn, sureStart, sureEnd);
  }
  block(LEFT, lane.top + lane.opinion, at.span, lane.tall, "#f1f3f6", 1, 4);
  edit.bands[foot].forEach(([start, end], band) => {
    for (const turn of copies([start, end])) {
      const [left, right] = [at.x(start + turn), at.x(end + turn)];
      const mine = chosen?.foot === foot && chosen?.band === band;
      block(left, lane.top + lane.opinion, right - left, lane.tall, FEET[foot], mine ? 1 : 0.82, 4);
      if (mine) {
        pen.strokeStyle = INK;
        pen.lineWidth = 2;
        pen.strokeRect(left + 1, lane.top + lane.opinion + 1, right - left - 2, lane.tall - 2);
      }
    }
  });
  pen.restore();
  edit.bands[foot].forEach(([start, end], band) => {
    for (const turn of copies([start, end])) {
      for (const [edge, side] of [[at.x(start + turn), "start"], [at.x(end + turn), "end"]]) {
        if (edge < LEFT - 1 || edge > LEFT + at.span + 1) continue;
        const near = [held, hover].some((it) => it?.kind === "edge" && it.foot === foot && it.band === band && it.side === side);
        block(edge - (near ? 3 : 2), lane.top + lane.opinion - 2, near ? 6 : 4, lane.tall + 4, INK, near ? 1 : 0.75, 2);
      }
    }
  });
}

// The detector's confidence in an edge: a sharp one is a wall, a doubtful one fades away.
function opinionBar(at, lane, foot, start, end, sureStart, sureEnd) {
  const [left, right] = [at.x(start), at.x(end)];
  const ink = pen.createLinearGradient(left, 0, right, 0);
  const reach = (sure) => clamp(((1 - sure) * 0.12 / known.clip.duration * at.span + 0.5) / Math.max(right - left, 1), 0.001, 0.45);
  const [rgb, soft] = [FEET[foot], `${FEET[foot]}22`];
  ink.addColorStop(0, sureStart > 0.95 ? rgb : soft);
  ink.addColorStop(reach(sureStart), rgb);
  ink.addColorStop(1 - reach(sureEnd), rgb);
  ink.addColorStop(1, sureEnd > 0.95 ? rgb : soft);
  pen.fillStyle = ink;
  pen.fillRect(left, lane.top + 2, right - left, lane.opinion - 5);
}

function drawResult(at) {
  const { clip, edit } = known;
  words("supports", 14, at.result.top + 15, { weight: 600 });
  const edges = new Set([0, clip.duration]);
  for (const foot of edit.bands) {
    for (const [start, end] of foot) for (const time of [start, end]) edges.add(clip.cyclic ? time % clip.duration : time);
  }
  const times = [...edges].filter((time) => time >= 0 && time <= clip.duration).sort((a, b) => a - b);
  const carries = (foot, time) => edit.bands[foot].some(([start, end]) => (time >= start && time < end)
    || (clip.cyclic && time + clip.duration >= start && time + clip.duration < end));
  for (let i = 1; i < times.length; i++) {
    const middle = (times[i - 1] + times[i]) / 2;
    const [left, right] = [carries(0, middle), carries(1, middle)];
    const symbol = left && right ? "D" : left ? "L" : right ? "R" : "-";
    const [x0, x1] = [at.x(times[i - 1]), at.x(times[i])];
    block(x0 + 0.5, at.result.top, x1 - x0 - 1, at.result.tall, COLORS[symbol], 1, 3);
    if (x1 - x0 > 13) words(letter(symbol), (x0 + x1) / 2, at.result.top + 15.5, { align: "center", weight: 600, color: "#10151a" });
  }
}

// What lies under the pointer: an edge, a band, a threshold, or time.
function find(px, py) {
  const at = layout();
  for (const foot of [0, 1]) {
    const lane = at.lanes[foot];
    if (py < lane.top + lane.opinion - 4 || py > lane.top + lane.opinion + lane.tall + 4) continue;
    let best = null;
    known.edit.bands[foot].forEach(([start, end], band) => {
      for (const turn of copies([start, end])) {
        for (const [time, side] of [[start, "start"], [end, "end"]]) {
          const distance = Math.abs(at.x(time + turn) - px);
          if (distance < GRIP && (!best || distance < best.distance)) best = { kind: "edge", foot, band, side, distance };
        }
      }
    });
    if (best) return best;
    const time = at.time(px);
    const band = known.edit.bands[foot].findIndex(([start, end]) => copies([start, end]).some(
      (turn) => time >= start + turn && time <= end + turn));
    return band >= 0 ? { kind: "band", foot, band } : { kind: "gap", foot };
  }
  for (const [kind, area, highest] of [["height", at.heightPlot, at.highest], ["speed", at.speedPlot, at.fastest]]) {
    const y = area.top + area.tall * (1 - clamp(known.edit[kind] / highest, 0, 1.03));
    if (Math.abs(py - y) < GRIP && px > LEFT - 4) return { kind };
  }
  return { kind: "time" };
}

const CURSORS = { edge: "ew-resize", height: "ns-resize", speed: "ns-resize", band: "pointer", gap: "copy", time: "crosshair" };

export function down(px, py) {
  if (!known.edit) return;
  held = find(px, py);
  const at = layout();
  if (held.kind === "edge" || held.kind === "band") chosen = { foot: held.foot, band: held.band };
  else if (held.kind !== "time") chosen = null;
  if (held.kind === "gap") held.from = at.time(px);
  if (held.kind === "height" || held.kind === "speed") held.frozen = at;
  if (held.kind === "time") stream("seek", { time: at.time(px) });
}

export function move(px, py) {
  if (!known.edit) return;
  if (!held) {
    hover = find(px, py);
    canvas.style.cursor = CURSORS[hover.kind];
    return;
  }
  const at = held.frozen ?? layout();
  const time = at.time(px);
  if (held.kind === "edge") stream("drag", { foot: held.foot, band: held.band, side: held.side, time });
  if (held.kind === "time") stream("seek", { time });
  if (held.kind === "height" || held.kind === "speed") {
    const [area, highest] = held.kind === "height" ? [at.heightPlot, at.highest] : [at.speedPlot, at.fastest];
    const value = clamp((1 - (py - area.top) / area.tall) * highest, 0.005, highest);
    stream("thresholds", { height: known.edit.height, speed: known.edit.speed, [held.kind]: value });
  }
}

export function up(px) {
  const was = held;
  held = null;
  if (!was || !known.edit) return;
  if (was.kind === "edge") stream("release", {});
  if (was.kind === "gap") {
    const [from, to] = [was.from, layout().time(px)].sort((a, b) => a - b);
    if (to - from > 0.02) say("add", { foot: was.foot, start: from, end: to });
  }
}

export function twice(px, py) {
  const what = known.edit && find(px, py);
  if (what?.kind === "band") say("split", { foot: what.foot, time: layout().time(px) });
}

export function key(event) {
  const control = event.ctrlKey || event.metaKey;
  if ((event.key === "Delete" || event.key === "Backspace") && chosen) {
    say("delete", chosen);
    chosen = null;
  } else if (event.key === "s" && !control && chosen) say("split", { foot: chosen.foot, time: known.time });
  else if (control && event.key.toLowerCase() === "z") say(event.shiftKey ? "redo" : "undo");
  else if (control && event.key === "y") say("redo");
  else if (control && event.key === "s") say("save");
  else if (event.key === "ArrowLeft" || event.key === "ArrowRight") {
    const step = (event.key === "ArrowLeft" ? -1 : 1) / known.clip.fps;
    say("seek", { time: clamp(known.time + step, 0, known.clip.duration) });
  } else return false;
  return true;
}

function buildPanel() {
  box.innerHTML = '<div class="box"><h2>Motions</h2><div class="list"></div></div>'
    + '<div class="box" id="edit-box"><h2><span></span><small></small></h2><div class="sequence"></div>'
    + '<div class="buttons"><button data-do="undo">Undo</button><button data-do="redo">Redo</button>'
    + '<button data-do="discard">Discard</button><button data-do="save" class="primary">Save</button></div></div>'
    + '<div class="box"><h2>Detector <small></small></h2><div class="sequence"></div>'
    + '<div class="buttons"><button data-do="own-thresholds">Own thresholds</button>'
    + '<button data-do="adopt">Use its bands</button></div></div>'
    + '<div class="box"><p class="keys">drag an edge · drag a dashed line · drag in a gap to add a band<br>'
    + "double-click a band, or <kbd>S</kbd>, splits it at the red line<br>"
    + "<kbd>Del</kbd> deletes · <kbd>Ctrl Z</kbd> undoes · <kbd>Ctrl S</kbd> saves · <kbd>←</kbd> <kbd>→</kbd> a frame</p></div>";
  for (const button of box.querySelectorAll("[data-do]")) button.onclick = () => say(button.dataset.do);
}

function showMotions(state) {
  const list = box.querySelector(".list");
  list.replaceChildren(...state.motions.filter((motion) => !motion.gait).map((motion) => {
    const button = document.createElement("button");
    button.setAttribute("aria-pressed", motion.name === state.editing);
    button.innerHTML = "<span></span><small></small>";
    button.firstChild.textContent = motion.name;
    button.lastChild.textContent = `${motion.cyclic ? "loop" : "once"} · ${motion.duration.toFixed(2)} s`;
    button.onclick = () => say("select", { name: motion.name });
    return button;
  }));
}

function showEdit() {
  const { clip, edit } = known;
  if (!clip || !edit) return;
  const [, mine, theirs] = box.querySelectorAll(".box");
  mine.querySelector("h2 span").textContent = clip.name;
  const note = mine.querySelector("small");
  note.textContent = edit.changed ? "not saved" : clip.file;
  note.classList.toggle("unsaved", edit.changed);
  mine.querySelector(".sequence").textContent = edit.sequence;
  theirs.querySelector("small").textContent = edit.own ? "at its own thresholds" : "at yours";
  theirs.querySelector(".sequence").textContent = edit.detected;
  box.querySelector("[data-do=undo]").disabled = !edit.canUndo;
  box.querySelector("[data-do=redo]").disabled = !edit.canRedo;
  box.querySelector("[data-do=discard]").disabled = !edit.changed;
  box.querySelector("[data-do=own-thresholds]").disabled = edit.own;
}

buildPanel();
on("state", showMotions);
on("clip", () => { chosen = null; showEdit(); });
on("edit", showEdit);

// For tests and scripts: where things are on the canvas.
window.studio.editor = { layout: () => layout(), left: LEFT };
