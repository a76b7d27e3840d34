// The line to the session: what is said, what is heard, and what is known so far.

export const COLORS = { R: "#e6912a", L: "#3b8fd0", D: "#35a47a", "-": "#a4adb8", "!": "#d7263d" };
export const NAMES = { R: "right foot", L: "left foot", D: "both feet", "-": "flight", "!": "conflict" };
export const TONES = ["#3b8fd0", "#e6912a", "#35a47a", "#9b6ebe", "#d65d78", "#5aaab4", "#b2963c", "#6e78c8", "#8d6e55"];
export const FEET = ["#3b8fd0", "#e6912a"];

export const known = { state: null, tick: null, clip: null, edit: null, crowd: null, time: 0 };
const listeners = new Map();
const waiting = new Map();
let socket = null;
let count = 0;

export function on(kind, listener) {
  listeners.set(kind, [...(listeners.get(kind) ?? []), listener]);
}

// Say something; the promise is kept once the session has obeyed.
export function say(word, fields = {}) {
  if (socket?.readyState !== WebSocket.OPEN) return Promise.resolve();
  const id = ++count;
  socket.send(JSON.stringify({ do: word, ...fields, id }));
  return new Promise((resolve) => waiting.set(id, resolve));
}

function heard(message) {
  if (message.kind === "done") {
    waiting.get(message.id)?.();
    waiting.delete(message.id);
    return;
  }
  if (message.kind === "clock") known.time = message.time;
  else known[message.kind] = message;
  for (const listener of listeners.get(message.kind) ?? []) listener(message);
}

export function connect() {
  socket = new WebSocket(`ws://${location.host}/session`);
  socket.onmessage = (event) => heard(JSON.parse(event.data));
  socket.onopen = () => { document.getElementById("lost").hidden = true; };
  socket.onclose = () => {
    document.getElementById("lost").hidden = false;
    for (const resolve of waiting.values()) resolve();
    waiting.clear();
    setTimeout(connect, 600);
  };
}

// For tests and scripts: the same line the page uses.
window.studio = { say, known, on };
