// One card per motion: start and stop, what it does and why, priorities and fades.

import { known, on, say, TONES } from "./link.js";

const PARTS = [["legs", "legs"], ["trunk", "trunk"], ["head", "head"], ["left_arm", "left arm"],
  ["right_arm", "right arm"]];
const box = document.getElementById("cards");
const open = new Set();
let shown = "";

const card = (name) => [...box.children].find((each) => each.dataset.name === name);

function slider(label, value, most, step, digits, change) {
  const row = document.createElement("label");
  row.className = "slider";
  row.innerHTML = `<span></span><input type="range" min="0" max="${most}" step="${step}"><output></output>`;
  const [text, input, output] = row.children;
  text.textContent = label;
  input.value = value;
  output.textContent = value.toFixed(digits);
  input.setAttribute("aria-label", label);
  input.oninput = () => { output.textContent = (+input.value).toFixed(digits); };
  input.onchange = () => change(+input.value);
  return row;
}

// A gait goes as fast and turns as much as its sliders say; what its motions cannot do has none.
const GAIT = [["speed", "speeds", (value) => `${value.toFixed(2)} m/s`],
  ["turn", "turns", (value) => `${(value * 180 / Math.PI).toFixed(0).replace(/^-0$/, "0").replace("-", "−")} °/s`]];
const NARROW = 0.05;
const asked = new Map();
let steered = 0;

function sayGait(name) {
  steered = performance.now();
  const [speed, turn] = asked.get(name);
  say("steer", { name, speed, turn });
}

function steering(data) {
  const area = document.createElement("div");
  area.className = "steering";
  GAIT.forEach(([key, span], index) => {
    const [low, high] = data.gait[span];
    if (high - low < NARROW) return;
    const row = document.createElement("label");
    row.className = "slider";
    row.innerHTML = `<span>${key}</span><input type="range" step="0.01" data-steer="${key}"><output></output>`;
    const input = row.children[1];
    Object.assign(input, { min: Math.ceil(100 * low - 1e-6) / 100, max: Math.floor(100 * high + 1e-6) / 100 });
    input.setAttribute("aria-label", `${key} of ${data.name}`);
    input.oninput = () => {
      asked.get(data.name)[index] = +input.value;
      sayGait(data.name);
    };
    input.ondblclick = () => {
      if (key === "turn") {
        input.value = 0;
        input.oninput();
      }
    };
    // So that arrow keys steer again, whichever slider was dragged last.
    input.onpointerup = () => input.blur();
    area.append(row);
  });
  return area;
}

function tellGait(each, action) {
  const mine = performance.now() - steered < 400 && asked.has(action.name);
  if (!mine) asked.set(action.name, action.gait.slice(2));
  GAIT.forEach(([key, , text], index) => {
    const input = each.querySelector(`[data-steer=${key}]`);
    if (!input) return;
    input.value = asked.get(action.name)[index];
    put(input.nextElementSibling, text(action.gait[index]));
  });
}

const FASTER = 0.1;
const SHARPER = 0.25;

// Up and down change the speed; left and right turn as long as they are held.
export function steer(key, held) {
  const gaits = (known.state?.cards ?? []).filter((data) => data.gait && asked.has(data.name));
  const active = (data) => !["idle", "fading out"].includes(card(data.name)?.dataset.activity ?? "idle");
  const data = gaits.find(active) ?? gaits[0];
  if (!data) return;
  const upright = key === "ArrowUp" || key === "ArrowDown";
  if (upright && !held) return;
  const index = upright ? 0 : 1;
  const [low, high] = data.gait[GAIT[index][1]];
  if (high - low < NARROW) return;
  const now = asked.get(data.name)[index];
  const step = { ArrowUp: FASTER, ArrowDown: -FASTER, ArrowLeft: SHARPER, ArrowRight: -SHARPER }[key];
  const wanted = held ? now + step : 0;
  asked.get(data.name)[index] = Math.min(Math.max(wanted, low), high);
  sayGait(data.name);
}

function settings(data, motion) {
  const area = document.createElement("div");
  area.className = "settings";
  const name = data.name;
  for (const [part, label] of PARTS) {
    area.append(slider(label, data.priority[part], 10, 0.1, 1,
      (value) => say("priority", { name, part, value })));
  }
  const fades = { fadeIn: data.fadeIn, fadeOut: data.fadeOut };
  for (const [key, label] of [["fadeIn", "fade in"], ["fadeOut", "fade out"]]) {
    const row = slider(label, data[key], 2, 0.05, 2, (value) => {
      fades[key] = value;
      say("fades", { name, ...fades });
    });
    area.append(row);
  }
  const text = document.createElement("div");
  text.className = "sequence";
  text.textContent = data.supports;
  const links = document.createElement("div");
  links.className = "links";
  for (const [option, label] of data.gait ? [] : [["cyclic", "loop"], ["mirror", "mirror"], ["clean", "clean"]]) {
    const check = document.createElement("label");
    check.className = "check";
    check.innerHTML = `<input type="checkbox">${label}`;
    check.firstChild.checked = motion?.[option] ?? false;
    check.firstChild.onchange = (event) => say("option", { name, option, on: event.target.checked });
    links.append(check);
  }
  const edit = () => {
    say("select", { name });
    say("view", { view: "supports" });
  };
  for (const [label, act] of [...(data.gait ? [] : [["supports", edit]]), ["remove", () => say("remove", { name })]]) {
    const link = document.createElement("button");
    link.className = "link";
    link.textContent = label;
    link.onclick = act;
    links.append(link);
  }
  area.append(text, links);
  return area;
}

function build(state) {
  const key = JSON.stringify([state.cards, state.motions]);
  if (key === shown) return;
  shown = key;
  const focus = document.activeElement?.closest?.(".card")?.dataset.name;
  box.replaceChildren(...state.cards.map((data, index) => {
    const each = document.createElement("article");
    each.className = "card";
    each.dataset.name = data.name;
    each.style.setProperty("--tone", TONES[index % TONES.length]);
    each.classList.toggle("open", open.has(data.name));
    each.innerHTML = '<div class="row"><kbd></kbd><span class="name"></span>'
      + '<span class="pill state"></span>'
      + '<button class="go">Start</button><button class="more" aria-label="Settings"></button></div>'
      + '<div class="row under"><div class="bar"><i></i></div><span class="pill held"></span></div><p class="reason"></p>';
    const badge = each.querySelector("kbd");
    badge.textContent = index < 9 ? index + 1 : "";
    badge.hidden = index >= 9;
    each.querySelector(".name").textContent = data.name;
    each.querySelector(".name").title = data.name;
    each.querySelector(".go").onclick = () => {
      const activity = each.dataset.activity ?? "idle";
      say(activity === "idle" || activity === "fading out" ? "start" : "stop", { name: data.name });
    };
    each.querySelector(".more").onclick = () => {
      open.has(data.name) ? open.delete(data.name) : open.add(data.name);
      each.classList.toggle("open", open.has(data.name));
    };
    if (data.gait) each.append(steering(data));
    each.append(settings(data, state.motions.find((motion) => motion.name === data.name)));
    return each;
  }));
  if (!state.cards.length) {
    box.innerHTML = '<div class="box"><p class="keys">No motion is loaded yet. '
      + "Open one at the top right.</p></div>";
  }
  if (focus) card(focus)?.querySelector(".go")?.focus();
}

const STATE = { idle: "", waiting: "waiting", "fading in": "fading in", running: "running",
  "fading out": "fading out" };

function tell(tick) {
  for (const action of tick.actions) {
    const each = card(action.name);
    if (!each) continue;
    each.dataset.activity = action.activity;
    const fading = action.activity.startsWith("fading");
    each.classList.toggle("running", action.activity === "running");
    each.classList.toggle("fading", fading);
    each.classList.toggle("waiting", action.activity === "waiting");
    const share = `${Math.round(100 * action.most)} %`;
    const text = STATE[action.activity] + (action.activity === "running" ? ` ${share}` : "")
      + (fading ? ` ${Math.round(100 * action.progress)} %` : "");
    put(each.querySelector(".state"), text);
    const stretch = action.rate > 0 ? 1 / action.rate : 0;
    put(each.querySelector(".held"), action.held && stretch > 1.1 ? `held ×${stretch.toFixed(1)}` : "");
    put(each.querySelector(".reason"), action.reason ? `waiting because ${action.reason}` : "");
    put(each.querySelector(".go"),
      action.activity === "idle" || action.activity === "fading out" ? "Start" : "Stop");
    each.style.setProperty("--weight", action.most);
    if (action.gait) tellGait(each, action);
  }
}

function put(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

on("state", build);
on("tick", tell);

export function toggle(index) {
  const data = known.state?.cards[index];
  if (data) say("toggle", { name: data.name });
}
