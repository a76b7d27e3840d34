// The page: players in step, controls, and the line that runs through the schedule.

const takes = data.takes.map(readTake);
const duration = Math.max(...takes.map((take) => (take.frames - 1) / take.fps));
const weights = data.actions.map((action) => unpack(action.weights, Uint8Array));
const camera = { yaw: -1.15, pitch: 0.22, distance: 3.7 };
const players = [...document.querySelectorAll(".player")].map(
  (figure, index) => new Player(figure, takes[index]));
const byId = (id) => document.getElementById(id);
const state = { time: 0, speed: 1, playing: !matchMedia("(prefers-reduced-motion: reduce)").matches };

function supportAt(time) {
  return data.supports[clamp(Math.floor(time * data.scheduleRate), 0, data.supports.length - 1)];
}

function seek(time) {
  state.time = clamp(time, 0, duration);
}

function play(playing) {
  state.playing = playing;
  byId("play").textContent = playing ? "Pause" : "Play";
}

function buildControls() {
  for (const [speed, label] of [[1, "1×"], [0.5, "½×"], [0.25, "¼×"], [0.1, "⅒×"]]) {
    const button = document.createElement("button");
    button.textContent = label;
    button.setAttribute("aria-pressed", speed === 1);
    button.onclick = () => {
      state.speed = speed;
      for (const other of button.parentElement.children) {
        other.setAttribute("aria-pressed", other === button);
      }
    };
    document.querySelector(".speeds").append(button);
  }
  byId("actions").innerHTML = data.actions.map((action) => '<div class="action"><b></b>'
    + "<i></i><span></span></div>").join("");
  data.actions.forEach((action, i) => {
    byId("actions").children[i].firstChild.textContent = action.name;
  });
  byId("play").onclick = () => play(!state.playing);
  byId("scrub").oninput = (event) => {
    play(false);
    seek(event.target.value * duration);
  };
  addEventListener("keydown", (event) => {
    if (event.target.matches("button,input") && event.key === " ") return;
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (event.key === " ") play(!state.playing);
    else if (step) { play(false); seek(state.time + step / data.rate); }
    else return;
    event.preventDefault();
  });
}

function buildCamera() {
  for (const { canvas } of players) {
    canvas.onpointerdown = (event) => canvas.setPointerCapture(event.pointerId);
    canvas.onpointermove = (event) => {
      if (!canvas.hasPointerCapture(event.pointerId)) return;
      camera.yaw -= event.movementX * 0.008;
      camera.pitch = clamp(camera.pitch + event.movementY * 0.006, -0.02, 1.5);
    };
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      camera.distance = clamp(camera.distance * Math.exp(event.deltaY * 0.001), 1.2, 14);
    }, { passive: false });
  }
}

// The schedule picture says where its time axis lies; a line follows the time, a click sets it.
function buildPlayhead() {
  const box = byId("schedule");
  const picture = box.querySelector("svg");
  const { left, right, top, bottom, duration: seconds } = picture.dataset;
  const { width, height } = picture.viewBox.baseVal;
  const line = box.appendChild(Object.assign(document.createElement("div"), { id: "playhead" }));
  line.style.top = `${100 * top / height}%`;
  line.style.bottom = `${100 - 100 * bottom / height}%`;
  const set = (event) => {
    const area = box.getBoundingClientRect();
    const x = (event.clientX - area.left) / area.width * width;
    seek((x - left) / (right - left) * seconds);
  };
  box.onpointerdown = (event) => { box.setPointerCapture(event.pointerId); play(false); set(event); };
  box.onpointermove = (event) => { if (box.hasPointerCapture(event.pointerId)) set(event); };
  return () => {
    const share = (+left + Math.min(state.time / seconds, 1) * (right - left)) / width;
    line.style.left = `${100 * share}%`;
  };
}

function showNow() {
  const symbol = supportAt(state.time);
  byId("support").innerHTML = `<b style="background:var(${COLORS[symbol]})">`
    + `${symbol === "-" ? "–" : symbol}</b><span>${NAMES[symbol]}</span>`;
  weights.forEach((each, i) => {
    const frame = clamp(Math.round(state.time * data.scheduleRate), 0, each.length - 1);
    const weight = each[frame] / 255;
    const box = byId("actions").children[i];
    box.classList.toggle("idle", weight === 0);
    box.style.setProperty("--weight", weight);
    box.lastChild.textContent = `${Math.round(100 * weight)} %`;
  });
  byId("clock").textContent = `${state.time.toFixed(2)} s`;
  byId("scrub").value = state.time / duration;
}

buildControls();
buildCamera();
const movePlayhead = buildPlayhead();
play(state.playing);
let last = performance.now();

function tick(now) {
  if (state.playing) {
    seek(state.time + Math.min((now - last) / 1000, 0.1) * state.speed);
    if (state.time >= duration) state.time = 0;
  }
  last = now;
  for (const player of players) player.draw(state.time, camera);
  showNow();
  movePlayhead();
  requestAnimationFrame(tick);
}

// For tests and scripts: ?t=SECONDS shows that instant, paused.
const asked = new URLSearchParams(location.search).get("t");
if (asked !== null) {
  play(false);
  seek(+asked);
}
requestAnimationFrame(tick);
