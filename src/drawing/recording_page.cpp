// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/recording_page.h"

namespace tricover::detail {

const char* const kPageStyle = R"css(
:root { --paper: #ffffff; --panel: #f6f6f4; --line: #dcdbd7; --ink: #1f2328; --soft: #5d6168; --hit: #c24e00;
  --accent: #0072b2; color-scheme: light; }
@media (prefers-color-scheme: dark) { :root { --paper: #15171b; --panel: #1d2025; --line: #363a42; --ink: #e8e6e1;
  --soft: #a2a6ae; --hit: #ff8a3d; --accent: #56b4e9; color-scheme: dark; } }
:root[data-theme=light] { --paper: #ffffff; --panel: #f6f6f4; --line: #dcdbd7; --ink: #1f2328; --soft: #5d6168;
  --hit: #c24e00; --accent: #0072b2; color-scheme: light; }
:root[data-theme=dark] { --paper: #15171b; --panel: #1d2025; --line: #363a42; --ink: #e8e6e1; --soft: #a2a6ae;
  --hit: #ff8a3d; --accent: #56b4e9; color-scheme: dark; }
* { box-sizing: border-box; }
html, body { height: 100%; margin: 0; }
body { display: flex; flex-direction: column; background: var(--panel); color: var(--ink); overflow: hidden;
  font: 13px/1.45 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
header, footer { flex: none; padding: 6px 12px; }
header { display: flex; gap: 12px; align-items: baseline; border-bottom: 1px solid var(--line); min-width: 0; }
h1 { font-size: 14px; font-weight: 600; margin: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
#summary { color: var(--soft); white-space: nowrap; overflow: hidden; text-overflow: ellipsis; flex: 0 10 auto; }
#now { margin-left: auto; white-space: nowrap; color: var(--soft); font-variant-numeric: tabular-nums; }
#now.hit { color: var(--hit); font-weight: 600; }
main { position: relative; flex: 1; min-height: 80px; background: var(--paper); }
#view { position: absolute; inset: 0; width: 100%; height: 100%; touch-action: none; cursor: grab; outline-offset: -2px; }
#view.over { cursor: pointer; } #view.drags { cursor: grabbing; }
.panel { position: absolute; background: color-mix(in srgb, var(--panel) 92%, transparent); border: 1px solid var(--line);
  border-radius: 6px; padding: 7px 10px; max-width: calc(100% - 16px); overflow-wrap: anywhere; }
#info { left: 8px; top: 8px; pointer-events: none; font-variant-numeric: tabular-nums; max-width: min(320px, calc(100% - 16px)); }
#info b { display: block; } #info .hit { color: var(--hit); } #info .soft { color: var(--soft); }
#help { right: 8px; bottom: 8px; max-height: calc(100% - 16px); overflow: auto; }
#help table { border-spacing: 0; } #help td { padding: 1px 12px 1px 0; vertical-align: top; }
#help td:first-child { white-space: nowrap; color: var(--soft); }
[hidden] { display: none !important; }
footer { border-top: 1px solid var(--line); }
#time { position: relative; height: 40px; touch-action: none; cursor: pointer; border-radius: 4px; }
#time canvas { position: absolute; inset: 0; width: 100%; height: 100%; }
#tip { bottom: calc(100% + 6px); pointer-events: none; white-space: nowrap; max-width: none; z-index: 1; }
.bar { display: flex; flex-wrap: wrap; gap: 4px; align-items: center; margin-top: 4px; }
button, select { font: inherit; color: inherit; background: transparent; border: 1px solid transparent; border-radius: 5px;
  height: 28px; min-width: 28px; padding: 0 5px; cursor: pointer; }
button:hover, select:hover { background: var(--line); }
button svg { display: block; width: 16px; height: 16px; margin: auto; fill: currentColor; }
button[aria-pressed=true] { border-color: var(--line); background: var(--paper); }
#play { background: var(--accent); color: var(--paper); min-width: 38px; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 1px; }
select option { background: var(--panel); }
#clock { font-variant-numeric: tabular-nums; margin: 0 6px; white-space: nowrap; }
#clock span { color: var(--soft); }
.gap { flex: 1; }
@media (max-width: 560px) { #summary, #clock span { display: none; } header, footer { padding: 5px 8px; } }
@media (max-width: 400px) { .gap { display: none; } button, select { padding: 0 3px; min-width: 25px; } }
)css";

const char* const kPageBody = R"html(
<header><h1 id="title"></h1><span id="summary"></span><span id="now"></span></header>
<main id="stage">
<canvas id="view" tabindex="0" role="img" aria-label="The scene at the time shown"></canvas>
<div id="info" class="panel" hidden></div>
<div id="help" class="panel" hidden></div>
</main>
<footer>
<div id="time" role="slider" tabindex="0" aria-label="Time"><canvas id="marks"></canvas>
<div id="tip" class="panel" hidden></div></div>
<div class="bar">
<button id="previous" title="Previous mark (p)" aria-label="Previous mark">
<svg viewBox="0 0 16 16"><path d="M2 2h2v12H2zM14 2v12L5 8z"/></svg></button>
<button id="back" title="One step back (left arrow)" aria-label="One step back">
<svg viewBox="0 0 16 16"><path d="M11 2v12L3 8zM12 2h2v12h-2z"/></svg></button>
<button id="play" title="Play or pause (space)" aria-label="Play">
<svg viewBox="0 0 16 16"><path id="symbol" d="M4 2l10 6-10 6z"/></svg></button>
<button id="step" title="One step on (right arrow)" aria-label="One step on">
<svg viewBox="0 0 16 16"><path d="M5 2v12l8-6zM2 2h2v12H2z"/></svg></button>
<button id="next" title="Next mark (n)" aria-label="Next mark">
<svg viewBox="0 0 16 16"><path d="M12 2h2v12h-2zM2 2v12l9-6z"/></svg></button>
<output id="clock"></output>
<select id="speed" title="Speed (up and down arrow)" aria-label="Speed"></select>
<i class="gap"></i>
<button id="fit" title="Show everything (0)" aria-label="Show everything">
<svg viewBox="0 0 16 16"><path d="M1 1h5v2H3v3H1zM10 1h5v5h-2V3h-3zM1 10h2v3h3v2H1zM13 10h2v5h-5v-2h3z"/></svg></button>
<button id="trails" title="Trails (t)" aria-label="Trails" aria-pressed="true">
<svg viewBox="0 0 16 16"><path d="M1 13c4 0 4-8 9-8" fill="none" stroke="currentColor" stroke-width="2"
 stroke-dasharray="2.5 1.5"/><circle cx="12" cy="5" r="3"/></svg></button>
<button id="names" title="Names (l)" aria-label="Names" aria-pressed="true">
<svg viewBox="0 0 16 16"><path d="M1 3h8l6 5-6 5H1zM4 7v2h5V7z" fill-rule="evenodd"/></svg></button>
<button id="theme" title="Dark or light (d)" aria-label="Dark or light">
<svg viewBox="0 0 16 16"><path d="M8 1a7 7 0 100 14A7 7 0 008 1zm0 2v10A5 5 0 018 3z" fill-rule="evenodd"/></svg></button>
<button id="keys" title="Keys (?)" aria-label="Keys" aria-expanded="false"><b>?</b></button>
</div>
</footer>
)html";

std::string recordingPage(const std::string& data) {
  // The policy lets the page load nothing at all.
  std::string page = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="tricover">
<meta http-equiv="Content-Security-Policy"
 content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:">
<link rel="icon" href="data:,">
<title>Recording</title>
<style>)html";
  page += std::string(kPageStyle) + "</style>\n</head>\n<body>" + kPageBody +
          "<noscript>This page needs JavaScript. It loads nothing from elsewhere.</noscript>\n" +
          "<script type=\"application/json\" id=\"data\">" + data + "</script>\n";
  for (const char* script : {kPageData, kPagePicture, kPageControls})
    page += std::string("<script>") + script + "</script>\n";
  return page + "</body>\n</html>\n";
}

}  // namespace tricover::detail
