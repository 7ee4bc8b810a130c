#!/usr/bin/env bash
# Installs what is missing (Debian, as root or with sudo), builds, and times tricover beside FCL's own ways. Prints the
# tables; build/report/ gets them too, with CSV and SVG. --full: every kind on the whole grid, for about an hour.
set -eu
cd "$(dirname "$0")/.."
bash .ci/install build-essential cmake libeigen3-dev libfcl-dev libccd-dev libgeos++-dev libbox2d-dev \
  libboost-dev libbenchmark-dev gnuplot-nox

build=build/bench
mkdir -p build/report
step() { if [ -t 2 ]; then printf '\r\033[K%s' "$1" >&2; fi; }
quietly() { "$@" >"build/bench.log" 2>&1 || { cat build/bench.log; return 1; }; }

step "configuring"
quietly cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DTRICOVER_BUILD_TESTS=OFF -DTRICOVER_BUILD_BENCH=ON
step "building (FCL's headers take their time)"
quietly cmake --build "$build" --target bench_main -j "$(nproc)"
step ""
"$build/bench/bench_main" bench/data/countries_110m.txt build/report "$@"
LC_ALL=C.UTF-8 gnuplot -e "report='build/report'" bench/plots.gp
echo
echo "build/report/: tables.md, results.csv, times.svg, figure12.svg, countries.svg, algorithm.svg, workloads.svg"
