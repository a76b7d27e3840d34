// The schedule, scrolling past now: what each motion played, what is decided, and how fast.

import { COLORS, known, on, TONES } from "./link.js";
import { block, clamp, hatching, INK, letter, line, pen, RULE, size, SOFT, ticks, words } from "./canvas.js";

const PAST = 6.0;
const AHEAD = 2.0;
const LEFT = 118;
const RIGHT = 14;
const ON_COLOR = "#10151a";

// Per motion: runs of one phase, [start, end, support, held, [[time, weight], …]], and rates.
let lanes = new Map();
let result = [];
let rates = new Map();
let cues = [];
let last = null;
let received = 0;

function forget() {
  lanes = new Map();
  rates = new Map();
  result = [];
  cues = [];
}

on("tick", (tick) => {
  if (!tick.begun || (last && tick.clock < last.clock - 1e-6)) forget();
  const time = tick.clock;
  received = performance.now();
  if (tick.begun) {
    for (const action of tick.actions) {
      remember(action, time);
      const before = last?.actions.find((each) => each.name === action.name);
      mark(action, before, time);
    }
    const run = result.at(-1);
    if (run && run[2] === tick.support) run[1] = time;
    else result.push([run?.[1] ?? time, time, tick.support]);
  }
  const gone = time - PAST - 0.5;
  result = result.filter((run) => run[1] > gone);
  cues = cues.filter((cue) => cue[0] > gone);
  for (const runs of lanes.values()) while (runs.length && runs[0][1] < gone) runs.shift();
  for (const curve of rates.values()) while (curve.length && curve[0][0] < gone) curve.shift();
  last = tick;
});

function remember(action, time) {
  const runs = lanes.get(action.name) ?? [];
  lanes.set(action.name, runs);
  const curve = rates.get(action.name) ?? [];
  rates.set(action.name, curve);
  if (action.activity === "idle" || action.activity === "waiting") {
    if (curve.length && curve.at(-1)[1] !== null) curve.push([time, null]);
    if (runs.length) runs.at(-1)[5] = true;
    return;
  }
  curve.push([time, action.rate]);
  const run = runs.at(-1);
  if (run && !run[5] && run[6] === action.phase) {
    run[1] = time;
    run[3] ||= action.held;
    run[4].push([time, action.weight]);
  } else {
    const start = run && !run[5] ? run[1] : time;
    runs.push([start, time, action.support ?? "", action.held, [[start, action.weight], [time, action.weight]],
      false, action.phase]);
  }
}

function mark(action, before, time) {
  const idle = (each) => !each || each.activity === "idle";
  const stopped = (each) => idle(each) || each.activity === "fading out";
  if (idle(before) && !idle(action)) cues.push([time, "start", action.name, action.activity === "waiting"]);
  if (before?.activity === "waiting" && !stopped(action) && action.activity !== "waiting") {
    cues.push([time, "began", action.name]);
  }
  if (!stopped(before) && before && stopped(action)) cues.push([time, "stop", action.name]);
}

export function draw() {
  const tick = known.tick;
  const cards = known.state?.cards ?? [];
  const { width, height } = size;
  if (!tick) return;
  const running = tick.begun && !known.state.paused;
  const now = tick.clock + (running ? Math.min((performance.now() - received) / 1000, 0.1) * known.state.speed : 0);
  const span = width - LEFT - RIGHT;
  const x = (time) => LEFT + ((time - now + PAST) / (PAST + AHEAD)) * span;
  const bottom = height - 20;
  const speedHeight = clamp(height * 0.16, 36, 60);
  const resultHeight = 22;
  const top = 22;
  const room = bottom - speedHeight - 10 - resultHeight - 10 - top;
  const lane = clamp(room / Math.max(cards.length, 1), 9, 34);
  for (const [time, label] of ticks(now - PAST, now + AHEAD, span)) {
    if (time < -1e-9 || x(time) < LEFT) continue;
    line(x(time), top - 6, x(time), bottom, RULE);
    words(`${label}${time < 1e-9 ? " s" : ""}`, x(time), height - 5, { color: SOFT, size: 11, align: "center" });
  }
  block(x(now), top - 6, span - x(now) + LEFT, bottom - top + 6, "#eef1f5", 0.55);
  cards.forEach((card, index) => {
    const base = top + (index + 1) * lane - 3;
    const tall = lane - 5;
    const playing = tick.actions.find((each) => each.name === card.name);
    const active = playing && playing.activity !== "idle";
    block(14, base - tall / 2 - 4.5, 9, 9, TONES[index % TONES.length], active ? 1 : 0.35, 2.5);
    words(card.name, 30, base - tall / 2 + 4, { size: Math.min(12.5, lane + 1), weight: active ? 600 : 400,
      color: active ? INK : SOFT, most: LEFT - 36 });
    line(LEFT, base + 0.5, width - RIGHT, base + 0.5, RULE);
    pen.save();
    pen.beginPath();
    pen.rect(LEFT, 0, span, height);
    pen.clip();
    for (const run of lanes.get(card.name) ?? []) drawRun(run, x, base, tall);
    drawPlans(tick, index, x, base, tall, now);
    for (const cue of cues) if (cue[2] === card.name) drawCue(cue, x, base - tall);
    pen.restore();
  });
  const under = top + cards.length * lane + 8;
  pen.save();
  pen.beginPath();
  pen.rect(LEFT, 0, span, height);
  pen.clip();
  for (const [start, end, support] of result) bar(x(start), x(end), under, resultHeight, support, 1);
  for (const slot of tick.ahead) {
    const start = Math.max(slot.start, now);
    bar(x(start), x(slot.start + slot.duration), under, resultHeight, slot.support, 0.5);
  }
  pen.restore();
  words("result", 14, under + 15, { weight: 600 });
  drawSpeeds(cards, x, under + resultHeight + 10, bottom - under - resultHeight - 14, span);
  line(x(now), top - 6, x(now), bottom, "#d7263d", 1.6);
  words("now", x(now), 12, { color: "#d7263d", size: 10.5, align: "center", weight: 600 });
  if (!tick.begun) {
    words("Start a motion: press its number, or Start on its card", LEFT + span * 0.35, under - 12 - cards.length * lane / 2,
      { color: SOFT, size: 14, align: "center" });
  }
}

function bar(left, right, top, tall, support, alpha) {
  if (right - left < 0.3) return;
  block(left + 0.5, top, right - left - 1, tall, COLORS[support] ?? "#ccd3da", alpha, 3);
  if (right - left > 14) {
    words(letter(support), (left + right) / 2, top + tall / 2 + 4.5,
      { align: "center", weight: 600, color: alpha < 0.7 ? "#10151aa0" : ON_COLOR });
  }
}

function drawRun([start, end, support, held, weights], x, base, tall) {
  const [left, right] = [x(start), x(end)];
  if (right - left < 0.3) return;
  const color = COLORS[support] ?? "#b9c2cc";
  block(left + 0.5, base - tall, right - left - 1, tall, color, 0.16);
  pen.beginPath();
  pen.moveTo(left + 0.5, base);
  for (const [time, weight] of weights) pen.lineTo(clamp(x(time), left + 0.5, right - 0.5), base - tall * weight);
  pen.lineTo(right - 0.5, base - tall * weights.at(-1)[1]);
  pen.lineTo(right - 0.5, base);
  pen.closePath();
  pen.fillStyle = color;
  pen.fill();
  if (held) {
    pen.fillStyle = hatching;
    pen.fill();
  }
  if (right - left > 15 && tall > 11) {
    words(letter(support), (left + right) / 2, base - tall / 2 + 4.5,
      { align: "center", size: 11.5, weight: 600, color: weights[weights.length >> 1][1] > 0.45 ? ON_COLOR : SOFT });
  }
}

// What is decided: outlines; a phase that goes on in the next slot is one that is held.
function drawPlans(tick, index, x, base, tall, now) {
  for (const slot of tick.ahead) {
    const support = slot.lanes[index];
    if (support === null || support === undefined) continue;
    const left = x(Math.max(slot.start, now)) + 0.5;
    const right = x(slot.start + slot.duration) - 0.5;
    if (right - left < 1) continue;
    block(left, base - tall, right - left, tall, COLORS[support], 0.3, 2);
    if (slot.held[index]) {
      pen.fillStyle = hatching;
      pen.globalAlpha = 0.7;
      pen.fillRect(left, base - tall, right - left, tall);
      pen.globalAlpha = 1;
    }
    if (right - left > 15 && tall > 11) {
      words(letter(support), (left + right) / 2, base - tall / 2 + 4.5,
        { align: "center", size: 11.5, weight: 600, color: "#10151a90" });
    }
  }
}

function drawCue([time, kind], x, top) {
  const at = x(time);
  pen.fillStyle = INK;
  pen.beginPath();
  if (kind === "stop") pen.rect(at - 3, top - 1, 6, 6);
  else {
    pen.moveTo(at - 3, top - 1);
    pen.lineTo(at + 4, top + 2.5);
    pen.lineTo(at - 3, top + 6);
    pen.closePath();
  }
  if (kind === "began") {
    pen.strokeStyle = INK;
    pen.lineWidth = 1;
    pen.stroke();
  } else pen.fill();
}

// How fast each clip runs: the middle line is its own speed, one line up and down twice and half.
function drawSpeeds(cards, x, top, tall, span) {
  if (tall < 18) return;
  const y = (rate) => top + tall / 2 - clamp(Math.log2(Math.max(rate, 0.05)), -1.3, 1.3) * tall / 2.6;
  words("speed", 14, top + tall / 2 + 4, { weight: 600 });
  for (const [rate, label] of [[2, "×2"], [1, "×1"], [0.5, "×½"]]) {
    line(LEFT, y(rate), LEFT + span, y(rate), RULE, 1, rate === 1 ? [] : [3, 4]);
    words(label, LEFT - 6, y(rate) + 3.5, { color: SOFT, size: 10, align: "right" });
  }
  pen.save();
  pen.beginPath();
  pen.rect(LEFT, top - 2, span, tall + 4);
  pen.clip();
  cards.forEach((card, index) => {
    pen.strokeStyle = TONES[index % TONES.length];
    pen.lineWidth = 1.7;
    pen.beginPath();
    let down = false;
    for (const [time, rate] of rates.get(card.name) ?? []) {
      if (rate === null) down = false;
      else if (down) pen.lineTo(x(time), y(rate));
      else {
        pen.moveTo(x(time), y(rate));
        down = true;
      }
    }
    pen.stroke();
  });
  pen.restore();
}
