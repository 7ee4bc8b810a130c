#!/usr/bin/env bash
# Installs what is missing (Debian, as root or with sudo), builds, and times tricover beside what people use. Prints the
# targets' tables; build/report/ gets all tables, CSV and SVG. --full: every kind on the whole grid, which measures for about 20
# minutes, and bench/results/ keeps the figures. BOX2D_V3=<its sources> (github.com/erincatto/box2d): beside it, too.
set -eu
cd "$(dirname "$0")/.."
bash .ci/install build-essential cmake libeigen3-dev libfcl-dev libccd-dev libgeos++-dev libbox2d-dev \
  libboost-dev libtbb-dev libgmp-dev libbenchmark-dev gnuplot-nox ninja-build

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
quietly cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTRICOVER_BUILD_BENCH=ON \
  -DTRICOVER_WERROR=ON -DTRICOVER_BENCH_BOX2D_V3="${BOX2D_V3-}"
step "building (FCL's headers take their time)"
quietly cmake --build "$build" --target bench_main bench_scenes bench_tradeoff bench_modelled bench_growth bench_first bench_first_fcl bench_asked bench_still bench_pages \
  ${BOX2D_V3:+bench_box2d_v3}
step "collisions, distances, impacts, contacts"
"$build/bench/bench_main" bench/data/countries_110m.txt "$report" "$@"
step "scenes"
"$build/bench/bench_scenes" bench/data/countries_110m.txt "$report" "$@"
step "counting wrong answers around contact and at the extremes"
"$build/bench/bench_tradeoff" bench/data/countries_110m.txt "$report" "$@"
"$build/bench/bench_modelled" "$report"
step "first answers"
"$build/bench/bench_first" "$report"
"$build/bench/bench_first_fcl" "$report"
step "contacts, caches and islands"
"$build/bench/bench_asked" "$report"
step "still maps and containers"
"$build/bench/bench_still" "$report"
step "asking what is hard"
"$build/bench/bench_growth" "$report"
[ -z "${BOX2D_V3-}" ] || "$build/bench/bench_box2d_v3" "$report"
step ""
for plots in plots tradeoff; do LC_ALL=C.UTF-8 gnuplot -e "report='$report'" "bench/$plots.gp"; done
"$build/bench/bench_pages" bench/pages.html "$report"
if [ "${1-}" = --full ]; then
  mkdir -p bench/results
  # Of some 30,000 rows those that the READMEs quote: of sweeps the farthest, of first answers the first, tenth and hundredth.
  grep -f bench/quoted.txt "$report/results.csv" > bench/results/quoted.csv
  for sweep in extremes value_extremes; do
    grep -E '^(sweep|query),|,1e(0|15|-15|300|-300),' "$report/$sweep.csv" > "bench/results/$sweep.csv"
  done
  for first in first first_fcl; do
    grep -E '^polygons,|^([^,]*,){3}(1|10|100),' "$report/$first.csv" > "bench/results/$first.csv"
  done
  [ -z "${BOX2D_V3-}" ] || cp "$report/box2d_v3.csv" bench/results/
  cp "$report"/{targets,scene_targets,first_targets,first_fcl_targets,scenes,growth,gaps,gap_targets,asked,asked_targets,still_targets,tradeoff,values,modelled}.csv "$report"/{conditions.md,tradeoff.svg,layout.svg} bench/results/
fi
echo
echo "$report/index.html shows it all; the tables, CSV files and pictures are beside it"
