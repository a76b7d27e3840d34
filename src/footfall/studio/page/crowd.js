// The crowd: who does what, in groups, and how that changes.

import { known, on, say } from "./link.js";
import { block, line, pen, RULE, size, SOFT, words } from "./canvas.js";

const TONES = ["#788696", "#3b8fd0", "#e6912a", "#35a47a", "#9b6ebe", "#d65d78", "#5aaab4", "#b2963c", "#6e78c8",
  "#8d6e55"];
const LEFT = 62;
const SECONDS = 30;
const box = document.getElementById("herding");
const on_ = new Set();
let history = [];

function build() {
  const crowd = known.crowd;
  const state = known.state;
  if (!crowd || !state) return;
  box.innerHTML = '<div class="box"><h2>Crowd <small></small></h2>'
    + '<label class="slider"><span>characters</span><input type="range" min="10" max="1000" step="10"><output></output></label></div>'
    + '<div class="box"><h2>Groups <small>start and stop</small></h2><div class="groups"></div></div>'
    + '<div class="box"><p class="keys">Each group is a stripe of the field. Every member starts within half a second, '
    + "so that no two march in step; all share one engine and one library.</p></div>";
  const [input, output] = box.querySelectorAll(".slider input, .slider output");
  input.value = crowd.size;
  output.textContent = crowd.size;
  input.oninput = () => { output.textContent = input.value; };
  input.onchange = () => { on_.clear(); say("gather", { size: +input.value }); };
  const table = box.querySelector(".groups");
  table.append(document.createElement("span"), ...[...state.groups, "all"].map((name) => {
    const head = document.createElement("b");
    head.textContent = name;
    return head;
  }));
  crowd.actions.forEach((name, action) => {
    const label = document.createElement("span");
    label.innerHTML = `<i style="background:${TONES[(action + 1) % TONES.length]}"></i>`;
    label.append(name);
    table.append(label, ...state.groups.map((_, group) => cell(name, action, [group])), cell(name, action, state.groups.map((__, i) => i)));
  });
}

function cell(name, action, groups) {
  const button = document.createElement("button");
  button.style.setProperty("--tone", TONES[(action + 1) % TONES.length]);
  const key = (group) => `${action}/${group}`;
  button.dataset.keys = groups.map(key).join(" ");
  button.setAttribute("aria-label", `${name}, group ${groups.length > 1 ? "all" : known.state.groups[groups[0]]}`);
  button.onclick = () => {
    const starts = !groups.every((group) => on_.has(key(group)));
    for (const group of groups) {
      say(starts ? "crowd-start" : "crowd-stop", { name, group });
      starts ? on_.add(key(group)) : on_.delete(key(group));
    }
    show();
  };
  return button;
}

function show() {
  for (const button of box.querySelectorAll(".groups button")) {
    const all = button.dataset.keys.split(" ").every((key) => on_.has(key));
    button.classList.toggle("on", all);
    button.textContent = all ? "■" : "▶";
  }
}

on("crowd", () => { history = []; on_.clear(); known.state?.groups.forEach((_, group) => on_.add(`0/${group}`)); build(); show(); });
on("herd", (herd) => {
  const small = box.querySelector("h2 small");
  if (small) small.textContent = `${(herd.frame / 30).toFixed(1)} s`;
  history.push([herd.frame / 30, herd.shares]);
  while (history.length > 2 && history.at(-1)[0] - history[0][0] > SECONDS) history.shift();
});

export function draw() {
  const { width, height } = size;
  const groups = known.state?.groups ?? [];
  if (!history.length) {
    words("gathering…", width / 2, height / 2, { color: SOFT, align: "center" });
    return;
  }
  const end = history.at(-1)[0];
  const shown = Math.min(SECONDS, Math.max(10, end - history[0][0]));
  const span = width - LEFT - 16;
  const x = (time) => LEFT + (1 - (end - time) / shown) * span;
  const tall = (height - 44) / groups.length;
  words(`share of each action in each group, the last ${shown.toFixed(0)} seconds`, LEFT, 14, { color: SOFT, size: 11.5 });
  groups.forEach((name, group) => {
    const base = 22 + (group + 1) * tall - 5;
    words(name, 26, base - tall / 2 + 8, { weight: 600, size: 13 });
    line(LEFT, base + 0.5, LEFT + span, base + 0.5, RULE);
    const actions = history[0][1][group].length;
    const lower = history.map(() => 0);
    for (let action = 0; action < actions; action++) {
      pen.beginPath();
      history.forEach(([time, shares], i) => pen.lineTo(x(time), base - (tall - 8) * Math.min(1, lower[i] + shares[group][action])));
      for (let i = history.length - 1; i >= 0; i--) pen.lineTo(x(history[i][0]), base - (tall - 8) * lower[i]);
      pen.closePath();
      pen.globalAlpha = action ? 0.92 : 0.28;
      pen.fillStyle = TONES[action % TONES.length];
      pen.fill();
      history.forEach(([, shares], i) => { lower[i] += shares[group][action]; });
    }
    pen.globalAlpha = 1;
  });
  block(LEFT + span, 22, 1.6, height - 44, "#d7263d");
  words("now", LEFT + span, height - 6, { color: "#d7263d", size: 10.5, align: "right", weight: 600 });
}
