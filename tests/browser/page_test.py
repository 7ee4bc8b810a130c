#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plays a recording in headless Chromium: no error, bodies where Trajectory::at() and frames put them, keys, a picture, two themes.

usage: tests/browser/page_test.py PROGRAM   (which writes a page to its first argument, and prints "time body x y heading margin meets" lines)
Status 77 where Chromium is missing.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HOOK = "<script>const bad=[];window.onerror=m=>{bad.push(String(m))};console.error=m=>bad.push(String(m));</script>"
TEST = """<script>
const wait = (is) => new Promise((done) => { let left = 400; const look = () => is() || !left-- ? done() : setTimeout(look, 10); look(); });
const key = (name) => window.dispatchEvent(new KeyboardEvent("keydown", {key: name}));
const isOut = (p) => p.x < 0 || p.y < 0 || p.x > view.width || p.y > view.height;
const colourCount = () => { drawPicture(); const p = pen.getImageData(0, 0, canvas.width, canvas.height).data, s = new Set();
  for (let i = 0; i < p.length; i += 4) s.add(p[i] << 16 | p[i + 1] << 8 | p[i + 2]); return s.size; };
(async () => {
  await wait(() => drawn.length > 0);
  const r = {worst: 0, count: 0};
  for (const [t, b, x, y, h, margin, meets] of WANTED) {
    seek(t); drawPicture(); ++r.count;
    if (Number.isNaN(x)) { if (drawn.some((each) => each.body === bodies[b])) bad.push(`${t}: body ${b} is there`); continue; }
    const item = drawn.find((each) => each.body === bodies[b]), p = placeOf(item.body, item.pose), s = toScreen(p), w = toScreen({x, y});
    r.worst = Math.max(r.worst, Math.hypot(s.x - w.x, s.y - w.y), Math.abs(Math.sin(p.heading * Math.PI / 180 - h)) * view.scale);
    if (isOut(w)) bad.push(`${t}: body ${b} is out of the picture`);
    if (Math.abs(item.pose.margin - margin) > 1e-6) bad.push(`${t}: the margin of body ${b}`);
    const met = meetingsAt(t).some((each) => each.a === item.body || each.b === item.body);
    if (meets !== -1 && met !== (meets === 1)) bad.push(`${t}: body ${b} meets: ${met}`);
  }
  key("Home"); r.home = state.time === begin; key("End"); r.end = state.time === end; key("Home");
  key("ArrowRight"); r.step = state.time > begin; key("n"); r.mark = marks.some((m) => m.begin === state.time);
  const later = (t) => Math.min(...marks.map((m) => m.begin).filter((each) => each > t)), goes = [];
  key("Home"); for (let i = 0; i < 3; ++i) { goes.push(later(state.time)); key("n"); if (state.time !== goes[i]) bad.push(`n goes to ${state.time}`); }
  key("p"); if (state.time !== goes[1]) bad.push(`p goes to ${state.time}`);
  const faster = speeds[speeds.indexOf(state.speed) + 1]; key("ArrowUp"); if (state.speed !== faster) bad.push("ArrowUp"); key("ArrowDown");
  for (const [t, count] of [[3.99, 0], [4, 1], [6, 1], [6.01, 0], [14.9, 1], [14.95, 1], [15, 0]])
    if (itemsAt(t).length !== count) bad.push(`${t}: ${itemsAt(t).length} things drawn`);
  canvas.setPointerCapture = () => {};
  const box = canvas.getBoundingClientRect();
  const fire = (kind, p, more) => { canvas.dispatchEvent(new (kind === "wheel" ? WheelEvent : PointerEvent)(
    kind, {clientX: box.left + p.x, clientY: box.top + p.y, bubbles: true, cancelable: true, pointerId: 1, button: 0, ...more})); };
  seek(10); drawPicture();
  // Events have whole pixels. A point there, and where it is in the world.
  const from = {x: Math.round(0.3 * view.width) - box.left % 1, y: Math.round(0.4 * view.height) - box.top % 1};
  const fixed = {x: view.x + (from.x - view.width / 2) / view.scale, y: view.y - (from.y - view.height / 2) / view.scale}, before = view.scale;
  const isAt = (x, y, what) => { const p = toScreen(fixed); if (!(Math.hypot(p.x - x, p.y - y) < 1e-3)) bad.push(`${what}: ${p.x - x}, ${p.y - y}`); };
  fire("wheel", from, {deltaY: -200}); isAt(from.x, from.y, "zooming moves its point"); if (!(view.scale > 1.2 * before)) bad.push("the wheel");
  fire("pointerdown", from); fire("pointermove", {x: from.x + 37, y: from.y - 21}); fire("pointerup", {x: from.x + 37, y: from.y - 21});
  isAt(from.x + 37, from.y - 21, "dragging"); drawPicture();
  r.hovered = 0;
  const met = meetingsAt(10), named = () => byId("info").querySelector("b").textContent;
  for (const {body, pose} of drawn) {  // robots that are alone, at their middles
    const at = placeOf(body, pose), p = toScreen(at);
    const isNear = (other) => { const there = placeOf(other.body, other.pose); return other.body !== body && Math.hypot(at.x - there.x, at.y - there.y) < 0.7; };
    if (!body.legs || body === bodies[0] || drawn.some(isNear) || isOut(p)) continue;
    fire("pointermove", p); drawPicture(); showInfo(met);
    if (state.hovered !== body || named() !== body.name) bad.push(`hovering over ${body.name} finds ${state.hovered && state.hovered.name}`);
    ++r.hovered;
  }
  fire("pointermove", {x: 1, y: 1}); if (state.hovered) bad.push("the corner is hovered"); key("0");
  const scale = view.scale; key("+"); r.zoom = view.scale > scale; key("0"); r.fit = Math.abs(view.scale - fitScale()) < 1e-9 * scale;
  r.colours = colourCount(); drawPicture(); const one = canvas.toDataURL(); key("d"); drawPicture(); r.themes = one !== canvas.toDataURL();
  key("Home"); key(" "); await wait(() => state.time > begin); r.plays = state.time > begin && isPlaying; key(" "); r.pauses = !isPlaying;
  r.tags = document.querySelectorAll("main b:not(#info b)").length; r.bad = bad;
  document.title = "RESULT " + JSON.stringify(r);
})().catch((e) => { document.title = "RESULT " + JSON.stringify({bad: [String(e)]}); });
</script>"""


def main() -> int:
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not chromium:
        print("skipped: Chromium is not installed")
        return 77
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        path = pathlib.Path(folder) / "page.html"
        lines = subprocess.run([sys.argv[1], path], check=True, capture_output=True, text=True, timeout=60).stdout
        wanted = [[float(x) for x in line.split()] for line in lines.splitlines()]
        page = path.read_text().replace("<style>", HOOK + "<style>", 1)
        path.write_text(page.replace("</body>\n</html>", TEST.replace("WANTED", json.dumps(wanted)) + "</body>\n</html>"))
        dom = subprocess.run([chromium, "--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile",
                              "--virtual-time-budget=20000", "--dump-dom", path.as_uri()],
                             capture_output=True, text=True, timeout=120).stdout
    found = re.search(r"<title>RESULT (.*?)</title>", dom)
    result = json.loads(found[1]) if found else {"bad": ["the page's test did not end"]}
    print(result)
    held = ("home", "end", "step", "mark", "zoom", "fit", "themes", "plays", "pauses")
    good = result["bad"] == [] and all(result.get(each) is True for each in held) and result["tags"] == 0
    return 0 if good and result["count"] == len(wanted) > 0 and result["worst"] < 1 and result["colours"] > 20 and result["hovered"] > 5 else 1


if __name__ == "__main__":
    sys.exit(main())
