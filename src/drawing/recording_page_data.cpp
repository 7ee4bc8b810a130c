// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/recording_page.h"

// Reads the columns in the order in which recording_writer.cpp writes them.
const char* const tricover::detail::kPageData = R"js(
"use strict";
const file = JSON.parse(document.getElementById("data").textContent);

function decoded(base64, Numbers) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = text.charCodeAt(i);
  return new Numbers(bytes.buffer);
}
const reals = decoded(file.reals, Float64Array), singles = decoded(file.singles, Float32Array);
const counts = decoded(file.counts, Uint32Array);
let nextReal = 0, nextSingle = 0, nextCount = 0, nextText = 0;
const real = () => reals[nextReal++], single = () => singles[nextSingle++], count = () => counts[nextCount++];
const text = () => file.texts[nextText++];
const point = () => ({x: real(), y: real()});
const list = (length, read) => Array.from({length}, (_, i) => read(i));

/// A column of numbers, as a function of the row.
function column(length) {
  if (!count()) {
    const value = real();
    return () => value;
  }
  const middle = real(), unit = real(), from = nextSingle;
  nextSingle += length;
  return (row) => middle + unit * singles[from + row];
}

/// A shape in units from its centre, as a path. Rings that are a single point have no path that all browsers draw.
function readShape() {
  const flags = count();
  const shape = {rule: flags & 1 ? "nonzero" : "evenodd", unbounded: (flags & 2) > 0, centre: point(), unit: real(),
                 path: new Path2D(), points: [], radius: 0};
  for (let rings = count(); rings > 0; --rings) {
    const length = count(), x = singles[nextSingle], y = singles[nextSingle + 1];
    let isPoint = true;
    for (let i = 0; i < length; ++i) {
      const u = single(), v = single();
      if (i) shape.path.lineTo(u, v); else shape.path.moveTo(u, v);
      isPoint = isPoint && u === x && v === y;
      shape.radius = Math.max(shape.radius, Math.hypot(u, v));
    }
    shape.path.closePath();
    if (isPoint) shape.points.push({x, y});
  }
  return shape;
}

function readLook() {
  return {row: count(), margin: real(), category: count(), base: [real(), real(), real(), real()]};
}

const turned = (base, angle) => {
  const c = Math.cos(angle), s = Math.sin(angle), [xx, xy, yx, yy] = base;
  return {xx: c * xx - s * yx, xy: c * xy - s * yy, yx: s * xx + c * yx, yy: s * xy + c * yy};
};

/// The legs of a trajectory. The pivot is given from the shape's centre. A leg that doesn't jump begins where the one
/// before ends.
function readLegs() {
  const legs = [];
  let x = 0, y = 0, turn = 0, base = [1, 0, 0, 1], pivot = {x: 0, y: 0}, jumps = 0;
  for (let left = count(); left > 0; --left) {
    const parts = count(), leg = {begin: real()};
    if (parts & 2) {
      const now = point(), linear = turned(base, turn), dx = now.x - pivot.x, dy = now.y - pivot.y;
      x += linear.xx * dx + linear.xy * dy;
      y += linear.yx * dx + linear.yy * dy;
      pivot = now;
    }
    if (parts & 1) {
      x = real(), y = real(), turn = 0, base = [real(), real(), real(), real()];
      ++jumps;
    }
    const zero = {x: 0, y: 0}, cubic = (parts & 8) > 0, bends = (parts & 32) > 0;
    Object.assign(leg, {x, y, turn, base, pivot, jumps, first: parts & 4 ? point() : zero, second: cubic ? point() : zero,
                        third: cubic ? point() : zero, turns: [parts & 16 ? real() : 0, bends ? real() : 0, bends ? real() : 0]});
    legs.push(leg);
    x += leg.first.x + leg.second.x + leg.third.x;
    y += leg.first.y + leg.second.y + leg.third.y;
    turn += leg.turns[0] + leg.turns[1] + leg.turns[2];
  }
  return legs;
}

function readBody(index) {
  const body = {index, shape: shapes[count()], name: text()};
  body.isNamed = !/^body \d+$/.test(body.name);
  if (count()) {
    Object.assign(body, {margin: real(), category: count()});
    const flags = count();
    Object.assign(body, {appears: (flags & 1) > 0, vanishes: (flags & 2) > 0, legs: readLegs()});
    body.moves = body.legs.length > 1;
    body.mostMargin = body.margin;
  } else {
    const looks = list(count(), readLook), firstFrame = count(), rows = count(), before = nextSingle;
    Object.assign(body, {looks, firstFrame, rows, x: column(rows), y: column(rows), turn: column(rows)});
    body.moves = nextSingle > before || looks.length > 1;
    body.mostMargin = Math.max(...looks.map((look) => look.margin));
  }
  return body;
}

/// The last index at which key(index) isn't more than a value; -1 where all are.
function lastUpTo(length, key, value) {
  let low = -1, high = length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (key(middle) <= value) low = middle; else high = middle;
  }
  return low;
}

const low = point(), high = point(), begin = real(), end = real();
const shapes = list(count(), readShape), frames = list(count(), real), bodies = list(count(), readBody);
const frameAt = (time) => lastUpTo(frames.length, (i) => frames[i], time);

/// Where the shape's centre is, and the linear part of the pose, or null where the body isn't there. As
/// tricover::Trajectory::at() and tricover::Motion::at() compute it.
function poseOnLegs(body, time) {
  const legs = body.legs, last = legs.length - 1;
  if ((body.appears && time < legs[0].begin) || (body.vanishes && time > legs[last].begin)) return null;
  const i = last === 0 ? 0 : Math.max(0, lastUpTo(legs.length, (j) => legs[j].begin, time)), leg = legs[i];
  const t = i === last || time <= leg.begin ? 0 : (time - leg.begin) / (legs[i + 1].begin - leg.begin);
  const [a, b, c] = leg.turns, pose = turned(leg.base, leg.turn + ((c * t + b) * t + a) * t);
  const along = (axis) => ((leg.third[axis] * t + leg.second[axis]) * t + leg.first[axis]) * t;
  pose.x = leg.x + along("x") - (pose.xx * leg.pivot.x + pose.xy * leg.pivot.y);
  pose.y = leg.y + along("y") - (pose.yx * leg.pivot.x + pose.yy * leg.pivot.y);
  return Object.assign(pose, {margin: body.margin, category: body.category, piece: leg.jumps});
}
function poseInFrame(body, frame) {
  const row = frame - body.firstFrame;
  if (row < 0 || row >= body.rows || Number.isNaN(body.x(row))) return null;
  const look = body.looks[lastUpTo(body.looks.length, (i) => body.looks[i].row, row)];
  const pose = turned(look.base, body.turn(row));
  return Object.assign(pose, {x: body.x(row), y: body.y(row), margin: look.margin, category: look.category, piece: 0});
}
const poseAt = (body, time) => body.legs ? poseOnLegs(body, time) : poseInFrame(body, frameAt(time));

/// Where the polygon's own frame is, as the program sees the pose.
function placeOf(body, pose) {
  const {x, y} = body.shape.centre;
  return {x: pose.x - (pose.xx * x + pose.xy * y), y: pose.y - (pose.yx * x + pose.yy * y),
          heading: Math.atan2(pose.yx, pose.xx) * 180 / Math.PI};
}

// What the library has found: pairs that meet in frames, and marks.
const pair = () => ({a: bodies[count()], b: bodies[count()]});
const meetings = list(count(), () => ({...pair(), kind: "meeting", first: count(), until: count()}));
for (const each of meetings) {
  each.begin = frames[each.first];
  each.end = each.until < frames.length ? frames[each.until] : end;
}
const conflicts = list(count(), () => {
  const each = {...pair(), kind: "conflict", begin: real(), point: point(), normal: point(), end: real()}, flags = count();
  return Object.assign(each, {budgetEnded: (flags & 1) > 0, meetsAtEnd: (flags & 2) > 0});
});
const impacts = list(count(), () => ({...pair(), kind: "impact", begin: real(), point: point(), normal: point(),
                                      budgetEnded: count() > 0}));
const least = list(count(), () => ({kind: "least", begin: real(), distance: real(), points: [point(), point()]}));
for (const each of [...impacts, ...least]) each.end = each.begin;
for (const each of least)
  each.point = {x: (each.points[0].x + each.points[1].x) / 2, y: (each.points[0].y + each.points[1].y) / 2};
const marks = [...meetings, ...conflicts, ...impacts, ...least].sort((p, q) => p.begin - q.begin);

/// The meetings and conflicts at a time.
function meetingsAt(time) {
  const frame = frameAt(time), found = conflicts.filter((each) => each.begin <= time && time <= each.end);
  for (const each of meetings) {
    if (each.first > frame) break;
    if (frame < each.until) found.push(each);
  }
  return found;
}

// What is drawn beside the bodies.
const kinds = [{name: "contact", points: 1}, {name: "nearest", points: 2}, {name: "ray", points: 2}, {name: "ray", points: 3},
               {name: "text", points: 1}];
let nextPoint = 0;
function readItem() {
  const kind = kinds[count()], item = {kind: kind.name, from: nextPoint, points: kind.points};
  nextPoint += kind.points;
  if (kind.name === "contact") item.normal = {x: single(), y: single()};
  if (kind.name === "contact" || kind.name === "nearest") item.length = real();
  if (kind.name === "text") item.text = text();
  return item;
}
const momentsOfFrames = new Map(), momentsOfTimes = [];
for (let left = count(); left > 0; --left) {
  if (count()) {
    momentsOfTimes.push({begin: real(), end: real(), items: list(count(), readItem)});
  } else {
    const frame = count(), items = list(count(), readItem);
    momentsOfFrames.set(frame, [...(momentsOfFrames.get(frame) || []), ...items]);
  }
}
const points = count(), pointX = column(points), pointY = column(points);

function itemsAt(time) {
  const found = momentsOfTimes.filter((moment) => moment.begin <= time && time <= moment.end).flatMap((moment) => moment.items);
  return found.concat(momentsOfFrames.get(frameAt(time)) || []);
}
)js";
