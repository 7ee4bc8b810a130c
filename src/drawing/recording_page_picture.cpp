// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/recording_page.h"

const char* const tricover::detail::kPagePicture = R"js(
"use strict";
const byId = (id) => document.getElementById(id);
const canvas = byId("view"), pen = canvas.getContext("2d");
// Okabe and Ito's colours, which colour-blind people can tell apart; vermilion is left for bodies that meet.
const hues = ["#56b4e9", "#009e73", "#cc79a7", "#f0e442", "#0072b2", "#e69f00"];
const themes = {
  light: {paper: "#ffffff", grid: "#f0efec", axis: "#dfddd8", ink: "#1f2328", soft: "#5d6168", still: "#a8a49c",
          hit: "#d55e00", note: "#0057a8"},
  dark: {paper: "#15171b", grid: "#1f2227", axis: "#31353c", ink: "#e8e6e1", soft: "#a2a6ae", still: "#6f7680",
         hit: "#ff8a3d", note: "#7cc7f5"}};
const mostZoom = 1024;  // times the size that fits: what the data is precise enough for

const state = {time: begin, hovered: null, pinned: null, trails: true, names: true, speed: 1, theme: "light"};
const view = {x: 0, y: 0, scale: 1, width: 1, height: 1, ratio: 1, isFitted: true};
let colours = themes.light, drawn = [], hatching = null;

const mixed = (a, b, share) => "#" + [1, 3, 5].map((i) => {
  const p = parseInt(a.slice(i, i + 2), 16), q = parseInt(b.slice(i, i + 2), 16);
  return Math.round(p + (q - p) * share).toString(16).padStart(2, "0");
}).join("");
const hueOf = (body, pose) => body.moves ? hues[Math.max(0, 31 - Math.clz32(pose.category & -pose.category)) % hues.length]
                                         : colours.still;
function useTheme(theme) {
  state.theme = theme;
  colours = themes[theme];
  const tile = document.createElement("canvas"), line = tile.getContext("2d");
  tile.width = tile.height = 8;
  line.strokeStyle = colours.hit;
  line.lineWidth = 1.6;
  line.stroke(new Path2D("M-2 6L6 -2M2 10L10 2"));
  hatching = pen.createPattern(tile, "repeat");
}

const fitScale = () => Math.max(1e-300, Math.min(Math.max(20, view.width - 32) / (high.x - low.x),
                                                 Math.max(20, view.height - 32) / (high.y - low.y)));
function fitView() {
  Object.assign(view, {x: low.x / 2 + high.x / 2, y: low.y / 2 + high.y / 2, scale: fitScale(), isFitted: true});
}
const toScreen = (p) => ({x: view.width / 2 + (p.x - view.x) * view.scale, y: view.height / 2 - (p.y - view.y) * view.scale});
const toWorld = (p) => ({x: view.x + (p.x - view.width / 2) / view.scale, y: view.y - (p.y - view.height / 2) / view.scale});

/// Zooms about a point of the screen, which stays where it is.
function zoom(factor, at = {x: view.width / 2, y: view.height / 2}) {
  const before = toWorld(at), least = fitScale() / 20;
  view.scale = Math.min(Math.max(view.scale * factor, least), mostZoom * fitScale());
  const after = toWorld(at);
  view.x += before.x - after.x;
  view.y += before.y - after.y;
  view.isFitted = false;
}

function resize() {
  const box = canvas.getBoundingClientRect(), ratio = window.devicePixelRatio || 1;
  const width = Math.max(1, Math.round(box.width * ratio)), height = Math.max(1, Math.round(box.height * ratio));
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  Object.assign(view, {width: box.width, height: box.height, ratio});
  if (view.isFitted) fitView();
}
const onScreen = () => pen.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);

/// Draws in units of the body's shape from now on. Returns the length of a pixel there.
function place({body, pose}) {
  const unit = view.scale * body.shape.unit, s = unit * view.ratio, at = toScreen(pose);
  pen.setTransform(s * pose.xx, -s * pose.yx, s * pose.xy, -s * pose.yy, at.x * view.ratio, at.y * view.ratio);
  return 1 / unit;
}
/// The region's path. An unbounded one has a rectangle around all that is seen.
function pathOf({body, pose}) {
  if (!body.shape.unbounded) return body.shape.path;
  const at = toScreen(pose), far = Math.hypot(view.width, view.height) + Math.hypot(at.x - view.width / 2, at.y - view.height / 2);
  const half = 1.1 * Math.max(2, far / (view.scale * body.shape.unit)), path = new Path2D(body.shape.path);
  path.rect(-half, -half, 2 * half, 2 * half);
  return path;
}
const marginOf = ({body, pose}) => Math.max(0, pose.margin) / body.shape.unit;

function isSeen({body, pose}) {
  if (body.shape.unbounded) return true;
  const at = toScreen(pose), radius = (body.shape.radius * body.shape.unit + Math.max(0, pose.margin)) * view.scale + 4;
  return at.x > -radius && at.y > -radius && at.x < view.width + radius && at.y < view.height + radius;
}

/// Fills all within a length of the outline, and of points: what is within a margin of a region is that and the region.
function strokeAround(item, width, style) {
  pen.strokeStyle = pen.fillStyle = style;
  pen.lineWidth = width;
  pen.lineJoin = pen.lineCap = "round";
  pen.stroke(item.body.shape.path);
  for (const {x, y} of item.body.shape.points) {
    pen.beginPath();
    pen.arc(x, y, width / 2, 0, 7);
    pen.fill();
  }
}
function drawMargin(item) {
  const margin = marginOf(item);
  if (!margin) return;
  const pixel = place(item), hue = hueOf(item.body, item.pose);
  strokeAround(item, 2 * (margin + pixel), mixed(hue, colours.paper, 0.45));
  pen.fillStyle = mixed(hue, colours.paper, 0.78);
  strokeAround(item, 2 * margin, pen.fillStyle);
  pen.fill(pathOf(item), item.body.shape.rule);
}
function drawBody(item, isMet) {
  const pixel = place(item), hue = hueOf(item.body, item.pose), {body} = item, path = pathOf(item), size = body.shape.radius / pixel;
  pen.globalAlpha = body.moves ? 0.85 : 1;
  pen.fillStyle = mixed(hue, colours.paper, body.moves ? 0.35 : 0.62);
  pen.fill(path, body.shape.rule);
  pen.globalAlpha = 1;
  if (isMet) {
    hatching.setTransform(pen.getTransform().inverse());
    pen.fillStyle = hatching;
    pen.fill(path, body.shape.rule);
    if (size < 4 && marginOf(item)) strokeAround(item, 2 * marginOf(item), hatching);
  }
  const isChosen = body === state.hovered || body === state.pinned;
  const edge = isMet ? colours.hit : mixed(hue, colours.ink, body.moves ? 0.5 : 0.35);
  strokeAround(item, (isMet ? 2.6 : size < 1.5 ? 4 : 1.2) * pixel, edge);
  if (isChosen) {
    pen.setLineDash([4 * pixel, 3 * pixel]);
    strokeAround(item, 2 * pixel, colours.ink);
    pen.setLineDash([]);
  }
}

/// Where a body was in the last seconds of playing. A body that jumps leaves no line there.
function drawTrail(body) {
  const from = Math.max(begin, state.time - 3 * state.speed), times = [];
  if (body.legs) {
    for (let i = 0; i <= 48; ++i) times.push(from + (state.time - from) * i / 48);
  } else {
    const last = frameAt(state.time), first = Math.max(frameAt(from), 0), by = Math.max(1, (last - first) / 96);
    for (let i = first; i < last; i += by) times.push(frames[Math.round(i)]);
    times.push(state.time);
  }
  pen.lineWidth = 2;
  pen.lineCap = "butt";
  let before = null;
  times.forEach((time, i) => {
    const pose = poseAt(body, time);
    if (pose && before && pose.piece === before.piece && (pose.x !== before.x || pose.y !== before.y)) {
      const p = toScreen(before), q = toScreen(pose);
      pen.globalAlpha = 0.75 * i / times.length;
      pen.strokeStyle = mixed(hueOf(body, pose), colours.ink, 0.15);
      pen.beginPath();
      pen.moveTo(p.x, p.y);
      pen.lineTo(q.x, q.y);
      pen.stroke();
    }
    before = pose;
  });
  pen.globalAlpha = 1;
}

/// 1, 2 or 5 times a power of ten, at least as much.
function niceStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5].find((factor) => factor * power >= least * (1 - 1e-9)) || 10);
}
const plain = (x, digits = 6) => {
  const size = Math.abs(x);
  return size >= 1e9 || (size > 0 && size < 1e-4) ? x.toExponential(4) : String(Number(x.toPrecision(digits)));
};
function drawGrid() {
  const step = niceStep(70 / view.scale), from = toWorld({x: 0, y: view.height}), to = toWorld({x: view.width, y: 0});
  if (!(step > 0 && Number.isFinite(step))) return;
  for (const axis of ["x", "y"]) {
    const first = Math.ceil(from[axis] / step), many = Math.min(500, Math.floor(to[axis] / step) - first);
    for (let i = 0; i <= many; ++i) {
      const at = toScreen({x: (first + i) * step, y: (first + i) * step})[axis];
      pen.fillStyle = first + i === 0 ? colours.axis : colours.grid;
      if (axis === "x") pen.fillRect(Math.round(at), 0, 1, view.height); else pen.fillRect(0, Math.round(at), view.width, 1);
    }
  }
}
function drawScale() {
  const step = niceStep(70 / view.scale), length = step * view.scale, y = view.height - 10, x = view.width - 12 - length;
  write(plain(step), x + length / 2, y - 6, colours.soft, "11px system-ui, sans-serif");
  line([{x, y: y - 4}, {x, y}, {x: x + length, y}, {x: x + length, y: y - 4}], colours.soft, 1.2);
}

function write(words, x, y, colour, font = "12px system-ui, sans-serif") {
  pen.font = font;
  pen.textAlign = "center";
  pen.lineJoin = "round";
  pen.lineWidth = 3.5;
  pen.strokeStyle = colours.paper;
  pen.strokeText(words, x, y);
  pen.fillStyle = colour;
  pen.fillText(words, x, y);
}
function line(path, colour, width, dash = []) {
  pen.setLineDash(dash);
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.lineCap = "butt";
  pen.beginPath();
  path.forEach(({x, y}, i) => i ? pen.lineTo(x, y) : pen.moveTo(x, y));
  pen.stroke();
  pen.setLineDash([]);
}
function dot({x, y}, colour, radius = 4) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 7);
  pen.fillStyle = colour;
  pen.fill();
  pen.strokeStyle = colours.paper;
  pen.lineWidth = 1.2;
  pen.stroke();
}
/// An arrow of so many pixels from a point of the screen along a direction of the world.
function arrow(from, direction, colour, length = 28) {
  const size = Math.hypot(direction.x, direction.y);
  if (!(size > 0)) return;
  const x = direction.x / size, y = -direction.y / size, tip = {x: from.x + length * x, y: from.y + length * y};
  line([from, tip], colour, 2);
  line([{x: tip.x - 7 * x - 4 * y, y: tip.y - 7 * y + 4 * x}, tip, {x: tip.x - 7 * x + 4 * y, y: tip.y - 7 * y - 4 * x}], colour, 2);
}

function drawNearest(p, q, distance) {
  line([p, q], colours.paper, 4);
  line([p, q], colours.note, 2);
  dot(p, colours.note);
  dot(q, colours.note);
  write(plain(distance, 4), (p.x + q.x) / 2, (p.y + q.y) / 2 - 9, colours.note);
}
function drawItem(item) {
  const at = Array.from({length: item.points}, (_, i) => toScreen({x: pointX(item.from + i), y: pointY(item.from + i)}));
  if (item.kind === "contact") {
    const length = item.length * view.scale;
    line([at[0], {x: at[0].x + item.normal.x * length, y: at[0].y - item.normal.y * length}], colours.note, 4);
    arrow(at[0], item.normal, colours.hit);
    dot(at[0], colours.hit, 3.5);
  } else if (item.kind === "nearest") {
    drawNearest(at[0], at[1], item.length);
  } else if (item.kind === "ray") {
    const stop = at[2] || at[1];
    line([at[0], stop], colours.note, 1.6);
    if (at[2]) line([stop, at[1]], mixed(colours.note, colours.paper, 0.5), 1.2, [3, 5]);
    if (at[2]) dot(stop, colours.hit); else arrow(at[1], {x: at[1].x - at[0].x, y: at[0].y - at[1].y}, colours.note, 0.1);
    dot(at[0], colours.note, 2.5);
  } else {
    write(item.text, at[0].x, at[0].y + 4, colours.ink, "600 13px system-ui, sans-serif");
  }
}

/// Impacts, and the points where conflicts begin, are right at one time: they are shown around it.
const around = (end - begin) / 100;
function drawMarks() {
  for (const mark of marks) {
    if (mark.begin > state.time + around) break;
    if (!mark.point || Math.abs(mark.begin - state.time) > around) continue;
    if (mark.kind === "least") {
      drawNearest(toScreen(mark.points[0]), toScreen(mark.points[1]), mark.distance);
      continue;
    }
    const at = toScreen(mark.point);
    arrow(at, mark.normal, colours.hit);
    dot(at, colours.hit);
  }
}
function drawName(item) {
  const {body, pose} = item, radius = Math.max(body.shape.radius * body.shape.unit, Math.max(0, pose.margin)) * view.scale;
  if (radius < 9 || body.shape.unbounded) return;
  const at = toScreen(pose);
  write(body.name, at.x, at.y + 4, colours.ink, "11px system-ui, sans-serif");
}

// Large bodies lie below small ones, and unbounded ones below all.
const order = bodies.slice().sort((p, q) => q.shape.unbounded - p.shape.unbounded ||
    q.shape.radius * q.shape.unit - p.shape.radius * p.shape.unit || p.index - q.index);

function drawPicture() {
  resize();
  onScreen();
  pen.fillStyle = colours.paper;
  pen.fillRect(0, 0, view.width, view.height);
  drawGrid();
  const now = meetingsAt(state.time), met = new Set(now.flatMap(({a, b}) => [a, b]));
  drawn = [];
  for (const body of order) {
    const pose = poseAt(body, state.time);
    if (pose && isSeen({body, pose})) drawn.push({body, pose});
  }
  drawn.filter(({body}) => !body.moves).forEach((item) => { drawMargin(item); drawBody(item, met.has(item.body)); });
  const moving = drawn.filter(({body}) => body.moves);
  moving.forEach(drawMargin);
  onScreen();
  if (state.trails) bodies.filter((body) => body.moves).forEach(drawTrail);
  moving.forEach((item) => drawBody(item, met.has(item.body)));
  onScreen();
  if (state.names) drawn.filter(({body}) => body.isNamed).forEach(drawName);
  itemsAt(state.time).forEach(drawItem);
  drawMarks();
  drawScale();
  return now;
}

/// The body at a point of the screen: on top, or else the one whose outline or margin is near.
function bodyAt({x, y}) {
  const px = x * view.ratio, py = y * view.ratio;
  for (const near of [false, true])
    for (let i = drawn.length - 1; i >= 0; --i) {
      const item = drawn[i], {shape} = item.body, pixel = place(item);
      pen.lineWidth = 2 * Math.max(marginOf(item), 5 * pixel);
      pen.lineJoin = "round";
      const isPoint = () => shape.points.some((p) => {
        const m = pen.getTransform(), dx = px - (m.a * p.x + m.c * p.y + m.e), dy = py - (m.b * p.x + m.d * p.y + m.f);
        return Math.hypot(dx, dy) <= pen.lineWidth / 2 / pixel * view.ratio;
      });
      if (near ? pen.isPointInStroke(shape.path, px, py) || isPoint() : pen.isPointInPath(pathOf(item), px, py, shape.rule))
        return item.body;
    }
  return null;
}
)js";
