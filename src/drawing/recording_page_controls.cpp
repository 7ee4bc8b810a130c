// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/recording_page.h"

const char* const tricover::detail::kPageControls = R"js(
"use strict";
const strip = byId("time"), ruler = byId("marks"), ink = ruler.getContext("2d");
const span = end - begin, inset = 10;
let isPlaying = false, lastTick = 0, waiting = 0, hashTimer = 0;

const speeds = [0.001, 0.005, 0.01, 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 10000];
// What is long or short plays in a few tens of seconds.
state.speed = span >= 4 && span <= 180 ? 1
    : speeds.reduce((best, each) => Math.abs(Math.log(span / each / 30)) < Math.abs(Math.log(span / best / 30)) ? each : best);
for (const each of speeds) byId("speed").add(new Option("\u00d7" + each, each));

// Times are written with as many digits as tell a thousandth of the whole.
const digits = span > 0 ? Math.min(12, Math.max(0, Math.ceil(3 - Math.log10(span)))) : 3;
const clock = (time) => time.toFixed(digits);

function redraw() {
  if (!waiting) waiting = requestAnimationFrame(tick);
}
function tick(now) {
  waiting = 0;
  if (isPlaying) {
    const passed = Math.min(0.25, Math.max(0, (now - lastTick) / 1000));
    lastTick = now;
    state.time = Math.min(end, state.time + passed * state.speed);
    if (state.time >= end) play(false);
  }
  const met = drawPicture();
  drawRuler();
  showInfo(met);
  byId("clock").replaceChildren(clock(state.time), Object.assign(document.createElement("span"), {textContent: " / " + clock(end)}));
  const now_ = byId("now");
  now_.className = met.length ? "hit" : "";
  now_.textContent = marks.length || frames.length ? (met.length === 1 ? "1 pair meets" : met.length + " pairs meet") : "";
  strip.setAttribute("aria-valuenow", state.time);
  strip.setAttribute("aria-valuetext", clock(state.time) + ", " + now_.textContent);
  if (isPlaying) redraw();
}

function play(on) {
  if (on && state.time >= end) state.time = begin;
  isPlaying = on && span > 0;
  lastTick = performance.now();
  byId("symbol").setAttribute("d", isPlaying ? "M3 2h4v12H3zM9 2h4v12H9z" : "M4 2l10 6-10 6z");
  byId("play").setAttribute("aria-label", isPlaying ? "Pause" : "Play");
  if (!isPlaying) keepInAddress();
  redraw();
}
/// Puts the time into the page's address, where that is allowed: a link to this moment.
function keepInAddress() {
  clearTimeout(hashTimer);
  hashTimer = setTimeout(() => {
    try { history.replaceState(null, "", "#t=" + state.time); } catch (error) { /* a frame without an address */ }
  }, 300);
}
function seek(time) {
  state.time = Math.min(end, Math.max(begin, time));
  if (!isPlaying) keepInAddress();
  redraw();
}
function readAddress() {
  const found = /[#&]t=([^&]+)/.exec(location.hash), time = found ? Number(found[1]) : NaN;
  if (!Number.isNaN(time)) seek(time);
}

/// To the next frame, or, of trajectories, by a two hundredth of the whole.
function stepBy(direction) {
  play(false);
  if (frames.length > 1) {
    const at = frameAt(state.time);
    seek(direction > 0 ? at + 1 < frames.length ? frames[at + 1] : end
                       : at < 0 ? begin : frames[at] < state.time || at === 0 ? frames[at] : frames[at - 1]);
  } else if (span > 0) {
    seek(state.time + direction * niceStep(span / 200));
  }
}
function goTo(mark) {
  seek(mark.begin);
  if (!mark.point) return;
  const at = toScreen(mark.point);
  if (at.x < 0 || at.y < 0 || at.x > view.width || at.y > view.height) Object.assign(view, mark.point, {isFitted: false});
}
function goToMark(direction) {
  const found = direction > 0 ? marks.find((mark) => mark.begin > state.time)
                              : [...marks].reverse().find((mark) => mark.begin < state.time);
  if (found) goTo(found);
}
function changeSpeed(direction) {
  const at = speeds.indexOf(state.speed) + direction;
  state.speed = speeds[Math.min(speeds.length - 1, Math.max(0, at))];
  byId("speed").value = state.speed;
  redraw();
}

// The time line.
const toX = (time) => inset + (span > 0 ? (time - begin) / span : 0) * Math.max(1, strip.clientWidth - 2 * inset);
const toTime = (x) => begin + span * Math.min(1, Math.max(0, (x - inset) / Math.max(1, strip.clientWidth - 2 * inset)));
const lanes = [0, 0, 0];
for (const mark of marks) {
  const free = lanes.findIndex((until) => until <= mark.begin);
  mark.lane = free < 0 ? lanes.indexOf(Math.min(...lanes)) : free;
  if (mark === marks[0]) lanes.fill(-Infinity);
  lanes[mark.lane] = mark.end;
}
function drawRuler() {
  const width = strip.clientWidth, height = strip.clientHeight, ratio = view.ratio, now = toX(state.time);
  if (ruler.width !== Math.round(width * ratio) || ruler.height !== Math.round(height * ratio)) {
    ruler.width = Math.round(width * ratio);
    ruler.height = Math.round(height * ratio);
  }
  ink.setTransform(ratio, 0, 0, ratio, 0, 0);
  ink.clearRect(0, 0, width, height);
  const box = (x, y, w, h, colour) => { ink.fillStyle = colour; ink.fillRect(x, y, w, h); };
  box(inset, 4, width - 2 * inset, 21, mixed(colours.paper, colours.ink, 0.08));
  box(inset, 4, now - inset, 21, mixed(colours.paper, colours.ink, 0.17));
  for (const mark of marks) {
    const x = toX(mark.begin), y = 6 + 6 * mark.lane;
    if (mark.kind === "least" || mark.kind === "impact") {
      ink.fillStyle = mark.kind === "least" ? colours.note : colours.hit;
      ink.fill(new Path2D(mark.kind === "least" ? `M${x} 7l6 7-6 7-6-7z` : `M${x} 24l-5-10h10z`));
      continue;
    }
    ink.globalAlpha = 0.55;
    box(x, y, Math.max(2.5, toX(mark.end) - x), 5, colours.hit);
    ink.globalAlpha = 1;
    box(x, y - 1, 2, 7, colours.hit);
  }
  ink.font = "10.5px system-ui, sans-serif";
  ink.fillStyle = colours.soft;
  const step = span > 0 ? niceStep(span * Math.max(70, 8 * clock(end).length) / width) : 0;
  for (let i = Math.ceil(begin / step), left = 50; step > 0 && i * step <= end && left > 0; ++i, --left) {
    const label = step >= 1 ? String(i * step) : (i * step).toFixed(Math.min(12, Math.ceil(-Math.log10(step) - 1e-9)));
    const half = ink.measureText(label).width / 2;
    ink.fillRect(toX(i * step), 25, 1, 3);
    ink.fillText(label, Math.min(width - 2 * half, Math.max(0, toX(i * step) - half)), 38);
  }
  box(now - 1, 2, 2, 25, colours.ink);
  ink.fillStyle = colours.ink;
  ink.fill(new Path2D(`M${now - 6} 0h12v3l-6 6-6-6z`));
}
/// The mark whose begin is nearest to a place on the time line, or else one that lasts there.
function markAt(x) {
  let best = null, least = 6;
  for (const mark of marks) {
    const off = Math.abs(toX(mark.begin) - x);
    if (off <= least) [best, least] = [mark, off];
  }
  return best;
}
const during = (x) => marks.find((mark) => mark.begin <= toTime(x) && toTime(x) <= mark.end) || null;
function describe(mark) {
  if (mark.kind === "least") return `${clock(mark.begin)}: least distance ${plain(mark.distance)}`;
  const who = `${mark.a.name} and ${mark.b.name}`, unproven = mark.budgetEnded ? " (not proven: a search ended)" : "";
  if (mark.kind === "impact") return `${clock(mark.begin)}: ${who} meet first${unproven}`;
  return `${clock(mark.begin)} to ${clock(mark.end)}: ${who}${unproven}`;
}
const xOn = (event) => event.clientX - strip.getBoundingClientRect().left;
strip.addEventListener("pointerdown", (event) => {
  if (event.button !== 0) return;
  strip.setPointerCapture(event.pointerId);
  const mark = markAt(xOn(event));
  if (mark) goTo(mark); else seek(toTime(xOn(event)));
  strip.dataset.from = xOn(event);
});
strip.addEventListener("pointermove", (event) => {
  const x = xOn(event), drags = strip.dataset.from !== undefined;
  if (drags && Math.abs(x - strip.dataset.from) > 3) {
    strip.dataset.from = -1e9;
    seek(toTime(x));
  }
  const mark = drags ? null : markAt(x) || during(x), tip = byId("tip");
  tip.hidden = !mark;
  if (!mark) return;
  tip.textContent = describe(mark);
  tip.style.left = Math.max(0, Math.min(strip.clientWidth - tip.offsetWidth, x - tip.offsetWidth / 2)) + "px";
});
for (const kind of ["pointerup", "pointercancel"]) strip.addEventListener(kind, () => { delete strip.dataset.from; });
strip.addEventListener("pointerleave", () => { byId("tip").hidden = true; });

// What is known about the body below the pointer.
function showInfo(met) {
  const body = state.hovered || state.pinned, pose = body && poseAt(body, state.time), panel = byId("info");
  panel.hidden = !body;
  if (!body) return;
  const rows = [["b", body.name, ""]];
  if (pose) {
    const at = placeOf(body, pose), places = Math.min(12, Math.max(0, Math.ceil(Math.log10(view.scale)) + 1));
    rows.push(["div", `x ${at.x.toFixed(places)}, y ${at.y.toFixed(places)}, heading ${at.heading.toFixed(2)}\u00b0`, ""]);
    rows.push(["div", `category ${pose.category}, margin ${plain(pose.margin)}`, "soft"]);
  } else {
    rows.push(["div", "is not there now", "soft"]);
  }
  const with_ = met.filter(({a, b}) => a === body || b === body);
  for (const each of with_.slice(0, 8)) {
    const until = each.kind === "conflict" ? ` from ${clock(each.begin)} to ${clock(each.end)}` : "";
    rows.push(["div", `meets ${(each.a === body ? each.b : each.a).name}${until}`, "hit"]);
  }
  if (with_.length > 8) rows.push(["div", `and ${with_.length - 8} more`, "hit"]);
  if (!with_.length) rows.push(["div", "meets nothing", "soft"]);
  panel.replaceChildren(...rows.map(([tag, textContent, className]) =>
      Object.assign(document.createElement(tag), {textContent, className})));
}

// The pointer: pan, pinch, hover and choose.
const fingers = new Map();
const on = (event) => ({x: event.clientX - canvas.getBoundingClientRect().left, y: event.clientY - canvas.getBoundingClientRect().top});
let dragged = 0;
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, on(event));
  dragged = 0;
});
canvas.addEventListener("pointermove", (event) => {
  const at = on(event), before = fingers.get(event.pointerId);
  if (!before) {
    state.hovered = bodyAt(at);
    canvas.classList.toggle("over", state.hovered !== null);
    return redraw();
  }
  const others = [...fingers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
  if (others.length) {
    const far = (p) => Math.max(1, Math.hypot(p.x - others[0].x, p.y - others[0].y));
    zoom(far(at) / far(before), others[0]);
  } else {
    dragged += Math.hypot(at.x - before.x, at.y - before.y);
    view.x -= (at.x - before.x) / view.scale;
    view.y += (at.y - before.y) / view.scale;
    view.isFitted = false;
    canvas.classList.add("drags");
  }
  fingers.set(event.pointerId, at);
  redraw();
});
for (const kind of ["pointerup", "pointercancel"])
  canvas.addEventListener(kind, (event) => {
    if (kind === "pointerup" && dragged < 4 && fingers.size === 1) state.pinned = bodyAt(on(event));
    fingers.delete(event.pointerId);
    canvas.classList.remove("drags");
    redraw();
  });
canvas.addEventListener("pointerleave", () => { state.hovered = null; redraw(); });
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), on(event));
  redraw();
}, {passive: false});

// Keys and buttons.
function toggle(what) {
  state[what] = !state[what];
  byId(what).setAttribute("aria-pressed", state[what]);
  redraw();
}
function changeTheme(theme) {
  document.documentElement.dataset.theme = theme;
  useTheme(theme);
  redraw();
}
function toggleHelp(on = byId("help").hidden) {
  byId("help").hidden = !on;
  byId("keys").setAttribute("aria-expanded", on);
}
const commands = [
  [[" ", "k"], "space", "play or pause", () => play(!isPlaying)],
  [["ArrowRight"], "\u2190 \u2192", "a step back, a step on", (event) => event && event.shiftKey ? goToMark(1) : stepBy(1)],
  [["ArrowLeft"], "", "", (event) => event && event.shiftKey ? goToMark(-1) : stepBy(-1)],
  [["n"], "n, p", "next, previous mark on the time line", () => goToMark(1)],
  [["p"], "", "", () => goToMark(-1)],
  [["Home"], "Home, End", "to the begin, to the end", () => seek(begin)],
  [["End"], "", "", () => seek(end)],
  [["ArrowUp"], "\u2191 \u2193", "faster, slower", () => changeSpeed(1)],
  [["ArrowDown"], "", "", () => changeSpeed(-1)],
  [["+", "="], "+ \u2212", "zoom (or the wheel); drag to pan", () => zoom(1.25)],
  [["-", "_"], "", "", () => zoom(0.8)],
  [["0"], "0", "show everything", fitView],
  [["t"], "t, l", "trails, names", () => toggle("trails")],
  [["l"], "", "", () => toggle("names")],
  [["d"], "d", "dark or light", () => changeTheme(state.theme === "dark" ? "light" : "dark")],
  [["?", "h"], "?", "these keys", () => toggleHelp()],
  [["Escape"], "", "", () => { toggleHelp(false); state.pinned = null; }]];
window.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === "SELECT") return;
  if (event.key === " " && event.target.tagName === "BUTTON") return;
  const found = commands.find(([keys]) => keys.includes(event.key) || keys.includes(event.key.toLowerCase()));
  if (!found) return;
  event.preventDefault();
  found[3](event);
  redraw();
});
const table = document.createElement("table");
const legend = [["", "Hatched in orange: meets something now."], ["", "Pale rim: the margin. Grey: always rests."],
                ["", "Click a body to keep it chosen."]];
for (const [name, what] of [...commands.filter((each) => each[1]).map((each) => [each[1], each[2]]), ...legend]) {
  const row = table.insertRow();
  row.insertCell().textContent = name;
  row.insertCell().textContent = what;
}
byId("help").append(table);
const buttons = {previous: "p", back: "ArrowLeft", play: " ", step: "ArrowRight", next: "n", fit: "0", trails: "t", names: "l", theme: "d",
                 keys: "?"};
for (const [id, key] of Object.entries(buttons))
  byId(id).addEventListener("click", () => {
    commands.find(([keys]) => keys.includes(key))[3](null);
    redraw();
  });
byId("previous").hidden = byId("next").hidden = marks.length === 0;
byId("names").hidden = !bodies.some((body) => body.isNamed);
byId("speed").value = state.speed;
byId("speed").addEventListener("change", (event) => { state.speed = Number(event.target.value); redraw(); });

// The page's own words.
document.title = byId("title").textContent = byId("title").title = file.title;
const many = (count, one, more) => count ? [count + " " + (count === 1 ? one : more)] : [];
byId("summary").textContent = [...many(bodies.length, "body", "bodies"), ...many(frames.length, "frame", "frames"),
    ...many(conflicts.length, "conflict", "conflicts"), ...many(impacts.length, "impact", "impacts")].join(" \u00b7 ");
strip.setAttribute("aria-valuemin", begin);
strip.setAttribute("aria-valuemax", end);

const prefersDark = matchMedia("(prefers-color-scheme: dark)");
useTheme(prefersDark.matches ? "dark" : "light");
prefersDark.addEventListener("change", () => {
  if (!document.documentElement.dataset.theme) { useTheme(prefersDark.matches ? "dark" : "light"); redraw(); }
});
new ResizeObserver(redraw).observe(byId("stage"));
window.addEventListener("resize", redraw);
window.addEventListener("hashchange", readAddress);
readAddress();
redraw();
)js";
