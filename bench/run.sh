#!/usr/bin/env bash
# Installs what is missing (Debian, as root or with sudo), builds, and times tricover beside what people use. Prints the
# targets' table; build/report/ gets all tables, CSV and SVG. --full: every kind on the whole grid, for about an hour,
# and bench/results/ keeps the figures.
set -eu
cd "$(dirname "$0")/.."
bash .ci/install build-essential cmake libeigen3-dev libfcl-dev libccd-dev libgeos++-dev libbox2d-dev \
  libboost-dev libbenchmark-dev gnuplot-nox ninja-build

# Ninja compiles across targets: the tables of FCL's functions, two minutes each, beside all the rest.
build=build/bench-ninja
report=build/report
mkdir -p "$report"
step() { if [ -t 2 ]; then printf '\r\033[K%s' "$1" >&2; fi; }
quietly() { "$@" >"build/bench.log" 2>&1 || { cat build/bench.log; return 1; }; }

step "configuring"
quietly cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTRICOVER_BUILD_TESTS=OFF \
  -DTRICOVER_BUILD_BENCH=ON
step "building (FCL's headers take their time)"
quietly cmake --build "$build" --target bench_main
step ""
"$build/bench/bench_main" bench/data/countries_110m.txt "$report" "$@"
LC_ALL=C.UTF-8 gnuplot -e "report='$report'" bench/plots.gp
if [ "${1-}" = --full ]; then
  mkdir -p bench/results
  cp "$report"/{targets.csv,results.csv,conditions.md} bench/results/
fi
echo
echo "$report/: tables.md, targets.csv, results.csv; times.svg, figure12.svg, speedup.svg; countries.svg,"
echo "algorithm.svg, workloads.svg"
