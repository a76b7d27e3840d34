// The page: views, transport, menus, keys; and a picture of the timeline, frame by frame.

import { COLORS, connect, known, NAMES, on, say } from "./link.js";
import { canvas, fit } from "./canvas.js";
import { steer, toggle } from "./cards.js";
import * as schedule from "./schedule.js";
import * as editor from "./editor.js";
import * as crowd from "./crowd.js";

const byId = (id) => document.getElementById(id);
const SPEEDS = [[1, "1×"], [0.5, "½×"], [0.25, "¼×"], [0.1, "⅒×"]];
const SAMPLES = ["walk", "walk-slow", "walk-fast", "walk-left", "walk-right", "walk-backward", "run", "run-left",
  "run-right", "hop-right", "hop-left", "side-step", "idle", "kick", "punch", "jump", "shot", "walk-to-hop"];
const views = { stage: schedule, supports: editor, crowd };
const ARROW = /^Arrow/;
const percent = (value) => (Math.abs(value) < 0.5 ? "0" : value.toFixed(0).replace("-", "−"));
const view = () => known.state?.view ?? "stage";

function choices(select, values, first) {
  const key = JSON.stringify(values);
  if (select.dataset.key === key) return;
  select.dataset.key = key;
  select.replaceChildren(...(first ? [new Option(first, "")] : []), ...values.map((value) => new Option(value, value)));
}

function buildControls() {
  for (const [value, label] of SPEEDS) {
    const button = document.createElement("button");
    button.textContent = label;
    button.dataset.speed = value;
    button.onclick = () => say("speed", { value });
    byId("speeds").append(button);
  }
  for (const tab of document.querySelectorAll("nav button")) tab.onclick = () => say("view", { view: tab.dataset.show });
  byId("pause").onclick = pause;
  byId("restart").onclick = () => say("restart");
  byId("ghost").onchange = (event) => say("ghost", { on: event.target.checked });
  byId("lift").oninput = (event) => say("lift", { value: +event.target.value });
  for (const id of ["ahead", "aside"]) byId(id).oninput = () => say("tilt", { ahead: +byId("ahead").value, aside: +byId("aside").value });
  for (const id of ["lift", "ahead", "aside"]) {
    byId(id).ondblclick = () => { byId(id).value = 0; byId(id).oninput({ target: byId(id) }); };
  }
  byId("ground-kind").onchange = (event) => say("ground", { name: event.target.value });
  byId("body").onchange = (event) => say("body", { name: event.target.value });
  for (const [id, word] of [["file", "load"], ["scenario", "open"]]) {
    byId(id).onchange = (event) => {
      if (event.target.value) say(word, { file: event.target.value });
      event.target.value = "";
      byId("open").open = false;
    };
  }
  byId("sample").onchange = (event) => {
    if (event.target.value) say("load", { file: `sample:${event.target.value}` });
    event.target.value = "";
    byId("open").open = false;
  };
  choices(byId("sample"), SAMPLES, "choose…");
  byId("gait").onclick = () => { say("gait"); byId("open").open = false; };
  byId("load-all").onclick = () => { say("load-all"); byId("open").open = false; };
  for (const button of document.querySelectorAll("[data-form]")) {
    button.onclick = () => { say("export", { form: button.dataset.form, name: byId("take").value }); byId("save").open = false; };
  }
  addEventListener("pointerdown", (event) => {
    for (const menu of document.querySelectorAll(".menu[open]")) if (!menu.contains(event.target)) menu.open = false;
  });
}

function pause() {
  if (view() === "supports") playClip(!clipPlays);
  else say("pause", { on: !known.state.paused });
}

let clipPlays = true;
function playClip(plays) {
  clipPlays = plays;
  if (plays && known.state.paused) say("pause", { on: false });
  say("play", { on: plays });
  showPause();
}

function showPause() {
  const still = view() === "supports" ? !clipPlays || known.state.paused : known.state.paused;
  byId("pause").classList.toggle("paused", still);
  byId("pause").setAttribute("aria-label", still ? "Play" : "Pause");
}

on("scene", ({ port }) => {
  const frame = document.querySelector("#scene iframe");
  const address = `http://${location.hostname}:${port}/`;
  if (frame.src !== address) frame.src = address;
});

on("state", (state) => {
  document.body.dataset.view = state.view;
  for (const tab of document.querySelectorAll("nav button")) tab.setAttribute("aria-selected", tab.dataset.show === state.view);
  for (const button of byId("speeds").children) button.setAttribute("aria-pressed", +button.dataset.speed === state.speed);
  choices(byId("file"), state.files, state.files.length ? "choose…" : "none here");
  choices(byId("scenario"), state.scenarios, state.scenarios.length ? "choose…" : "none here");
  choices(byId("body"), state.bodies);
  choices(byId("ground-kind"), state.grounds);
  byId("ground-kind").value = state.ground;
  byId("body").value = byId("body").title = state.body;
  byId("ghost").checked = state.ghost;
  byId("folder").textContent = `files go to ${state.folder}`;
  byId("load-all").disabled = !state.files.length;
  const sliders = [["lift", state.lifts, state.lift], ["ahead", state.tilts, state.tilt[0]], ["aside", state.tilts, state.tilt[1]]];
  for (const [id, [min, max], value] of sliders) {
    Object.assign(byId(id), { min, max });
    if (document.activeElement !== byId(id)) byId(id).value = value;
  }
  if (state.view !== "stage") byId("now").hidden = byId("against").hidden = true;
  showPause();
});

on("changed", () => say("news"));
on("clip", () => { clipPlays = true; if (known.state) showPause(); });
on("clock", ({ time }) => { if (view() === "supports") byId("clock").textContent = `${time.toFixed(2)} s`; });
on("herd", ({ frame }) => { if (view() === "crowd") byId("clock").textContent = `${(frame / 30).toFixed(2)} s`; });

on("tick", (tick) => {
  byId("clock").textContent = `${tick.clock.toFixed(2)} s`;
  byId("now").hidden = view() !== "stage" || !tick.begun;
  byId("against").hidden = byId("now").hidden || !known.state.ghost;
  byId("support").textContent = tick.support === "-" ? "–" : tick.support;
  byId("support").style.background = COLORS[tick.support];
  byId("support-name").textContent = NAMES[tick.support];
  const [left, right] = tick.slip;
  byId("slip").textContent = `slip of this step  L ${left.toFixed(1)}  R ${right.toFixed(1)} mm`;
  const long = (mm) => (mm < 100 ? `${mm.toFixed(0)} mm` : `${(mm / 1000).toFixed(2)} m`);
  byId("against").innerHTML = `planted feet have slid <i>${long(tick.slipTotal)}</i>, the ghost's <b>${long(tick.ghostSlip)}</b>`;
  byId("lift-now").textContent = `${tick.lift.toFixed(2)} m`;
  for (const [id, value] of [["ahead-now", tick.tilt[0]], ["aside-now", tick.tilt[1]]]) byId(id).textContent = `${percent(value)} %`;
});

on("jobs", ({ jobs }) => {
  const [job] = jobs;
  document.body.classList.toggle("busy", Boolean(job));
  byId("work").hidden = !job;
  if (!job) return;
  byId("work").title = job.detail;
  byId("work").querySelector("span").textContent = jobs.length > 1 ? `${job.title} (+${jobs.length - 1})` : job.title;
  const bar = byId("work").querySelector("progress");
  job.share > 0 ? (bar.value = job.share) : bar.removeAttribute("value");
  const button = byId("work").querySelector("button");
  button.disabled = job.canceled;
  button.onclick = () => say("cancel", { number: job.number });
});

on("notice", ({ level, text }) => {
  const note = document.createElement("p");
  note.className = level;
  note.append(text);
  const close = document.createElement("button");
  close.textContent = "×";
  close.setAttribute("aria-label", "Close");
  close.onclick = () => note.remove();
  note.append(close);
  const notices = byId("notices");
  notices.append(note);
  while (notices.children.length > 4) notices.firstChild.remove();
  setTimeout(() => note.remove(), level === "error" ? 15000 : 4500);
});

// The 3D scene is a page of its own: when it is clicked the keys would go there.
addEventListener("blur", () => setTimeout(() => {
  if (document.activeElement?.tagName === "IFRAME") {
    document.activeElement.blur();
    window.focus();
  }
}));

addEventListener("keydown", (event) => {
  if (event.target.matches("input:not([type=range]):not([type=checkbox]),select")) return;
  if (!known.state || event.altKey) return;
  const control = event.ctrlKey || event.metaKey;
  if (view() === "supports" && known.clip && editor.key(event)) event.preventDefault();
  else if (event.key === " " && !event.target.matches("button:focus-visible,summary:focus-visible")) {
    event.preventDefault();
    pause();
  } else if (!control && view() === "stage" && /^[1-9]$/.test(event.key)) toggle(+event.key - 1);
  else if (!control && view() === "stage" && ARROW.test(event.key) && !event.target.matches("input")) {
    event.preventDefault();
    steer(event.key, true);
  }
});

addEventListener("keyup", (event) => {
  if (known.state && view() === "stage" && ARROW.test(event.key) && !event.target.matches("input,select")) {
    steer(event.key, false);
  }
});

const place = (event) => {
  const area = canvas.getBoundingClientRect();
  return [event.clientX - area.left, event.clientY - area.top];
};
canvas.onpointerdown = (event) => {
  if (view() !== "supports") return;
  canvas.setPointerCapture(event.pointerId);
  editor.down(...place(event));
};
canvas.onpointermove = (event) => {
  if (view() === "supports") editor.move(...place(event));
  else canvas.style.cursor = "default";
};
canvas.onpointerup = (event) => { if (view() === "supports") editor.up(...place(event)); };
canvas.onpointercancel = canvas.onpointerup;
canvas.ondblclick = (event) => { if (view() === "supports") editor.twice(...place(event)); };

function frame() {
  fit();
  views[view()].draw();
  requestAnimationFrame(frame);
}

buildControls();
connect();
requestAnimationFrame(frame);
