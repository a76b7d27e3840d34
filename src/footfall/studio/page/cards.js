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
  for (const [option, label] of [["cyclic", "loop"], ["mirror", "mirror"], ["clean", "clean"]]) {
    const check = document.createElement("label");
    check.className = "check";
    check.innerHTML = `<input type="checkbox">${label}`;
    check.firstChild.checked = motion?.[option] ?? false;
    check.firstChild.onchange = (event) => say("option", { name, option, on: event.target.checked });
    links.append(check);
  }
  for (const [label, act] of [["supports", () => {
    say("select", { name });
    say("view", { view: "supports" });
  }], ["remove", () => say("remove", { name })]]) {
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
