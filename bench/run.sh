#!/usr/bin/env bash
# Installs what is missing (Debian, as root or with sudo), builds, and times tricover beside what people use. Measures for
# about four minutes; --full: every kind on the whole grid, about 20 minutes, and bench/results/ keeps the figures. Prints the
# table of floors; build/report/ gets all tables, CSV and SVG. BOX2D_V3=<its sources> (github.com/erincatto/box2d): beside
# Box2D v3, too.
set -eu
cd "$(dirname "$0")/.."
bash .ci/install build-essential cmake libeigen3-dev libfcl-dev libccd-dev libgeos++-dev libbox2d-dev \
  libboost-dev libtbb-dev libgmp-dev libbenchmark-dev libyaml-cpp-dev libpng-dev nlohmann-json3-dev gnuplot-nox ninja-build

# Ninja compiles across targets: the tables of FCL's functions, two minutes each, beside all the rest.
build=build/bench-ninja
report=build/report
mkdir -p "$report"
# On a terminal one line for all, elsewhere a line each.
step() {
  if [ -t 2 ]; then printf '\r\033[K%s' "$1" >&2; elif [ -n "$1" ]; then echo "== $1" >&2; fi
}
quietly() { "$@" >"build/bench.log" 2>&1 || { cat build/bench.log; return 1; }; }

step "configuring"
quietly cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTRICOVER_BUILD_BENCH=ON -DTRICOVER_BUILD_IO=ON \
  -DTRICOVER_WERROR=ON -DTRICOVER_BENCH_BOX2D_V3="${BOX2D_V3-}"
step "building (FCL's headers take their time)"
quietly cmake --build "$build" --target bench_main bench_scenes bench_tradeoff bench_modelled bench_first bench_asked \
  bench_floors ${BOX2D_V3:+bench_box2d_v3}
# Nothing of an earlier run may pass for a figure of this one.
rm -f "$report"/*.{csv,md,dat,svg,html}
failed=
measure() { "$build/bench/$1" "${@:2}" || failed+=" $1"; }
step "contacts, caches, islands, maps at rest"
measure bench_asked "$report"
step "first answers"
measure bench_first "$report"
step "collisions, distances, impacts, contacts"
measure bench_main "$report" "$@"
step "scenes"
measure bench_scenes "$report" "$@"
step "counting wrong answers around contact and at the extremes"
measure bench_tradeoff "$report" "$@"
measure bench_modelled "$report"
[ -z "${BOX2D_V3-}" ] || measure bench_box2d_v3 "$report"
step ""
for plots in plots tradeoff; do LC_ALL=C.UTF-8 gnuplot -e "report='$report'" "bench/$plots.gp" || failed+=" $plots.gp"; done
"$build/bench/bench_floors" "$report"
[ "${1-}" = --full ] || echo "--full measures more cells of the same rows: the column cells says how many count here."
# Fills the page with what is in the report: `@picture <file>` is an SVG, `@tables <file>` Markdown, which the page's own
# script turns into HTML, `@details <file> <title>` the same folded away.
awk -v report="$report" '
  !/^@(picture|tables|details) / { print; next }
  (getline line < (report "/" $2)) <= 0 { print "<p class=\"missing\">" $2 " was not made in this run.</p>"; next }
  $1 == "@picture" { print "<a href=\"" $2 "\"><img src=\"" $2 "\" alt=\"" $2 "\"></a>"; next }
  $1 == "@details" { title = $0; sub(/^@details [^ ]+ /, "", title); print "<details><summary>" title "</summary>" }
  { print "<script type=\"text/markdown\">"
    do print line; while ((getline line < (report "/" $2)) > 0)
    print "</script>" }
  $1 == "@details" { print "</details>" }' bench/page.html >"$report/index.html"
if [ "${1-}" = --full ]; then
  mkdir -p bench/results
  # Rows that the READMEs quote; of the extremes the farthest; of first answers the first, tenth and hundredth.
  grep -f bench/quoted.txt "$report/results.csv" > bench/results/quoted.csv
  grep -E '^query,|,1e(0|15|-15|300|-300),' "$report/extremes.csv" > bench/results/extremes.csv
  grep -E '^job,|k=(1|10|100),' "$report/first.csv" > bench/results/first.csv
  [ -z "${BOX2D_V3-}" ] || cp "$report/box2d_v3.csv" bench/results/
  cp "$report"/{floors,scenes,asked,tradeoff,values,modelled}.csv "$report"/{conditions.md,tradeoff.svg,layout.svg} bench/results/
fi
echo
echo "$report/index.html shows it all; the tables, CSV files and pictures are beside it"
[ -z "$failed" ] || { echo "failed:$failed" >&2; exit 1; }
