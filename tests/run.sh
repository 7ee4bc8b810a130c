#!/usr/bin/env bash
# Installs what is missing (Debian, as root or with sudo), builds, and runs every test: optimised, and on libraries with
# asserts and sanitizers; then threads under ThreadSanitizer; then, where there is clang, shared libraries that it built
# and libFuzzer. Prints CTest's closing lines; exits non-zero if a test fails.
# --fast: only the optimised tests with the label fast. src/README.md says where the time goes.
set -eu
cd "$(dirname "$0")/.."
bash .ci/install build-essential cmake pkg-config libeigen3-dev libfcl-dev libccd-dev libgtest-dev libgmp-dev \
  libompl-dev libtbb-dev libopenmpi-dev openmpi-bin doxygen python3 \
  python3-dev python3-numpy pybind11-dev libyaml-cpp-dev libpng-dev nlohmann-json3-dev

# Ninja compiles across targets and ccache across runs; neither is needed.
generator=make
tools=(-DTRICOVER_BUILD_TESTS=ON -DTRICOVER_WERROR=ON)
if command -v ninja >/dev/null; then generator=ninja tools+=(-G Ninja); fi
if command -v ccache >/dev/null; then tools+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

# suite <title> <build directory> <targets> <ctest's filter> <cmake options ...>
suite() {
  local title=$1 build=build/$generator-$2 targets=$3 filter=$4
  shift 4
  echo "== $title"
  mkdir -p build
  echo "-- building $targets in $build, as $build.log says"
  cmake -S . -B "$build" "${tools[@]}" "$@" >"$build.log" 2>&1 || { cat "$build.log"; return 1; }
  cmake --build "$build" --target $targets -j "$(nproc)" >>"$build.log" 2>&1 || { tail -n 60 "$build.log"; return 1; }
  ctest --test-dir "$build" $filter --no-tests=error --output-on-failure -j "$(nproc)"
}
TIMEFORMAT="== took %lR, of processors %lU and %lS"

if [ "${1-}" = --fast ]; then
  time suite "fast" tests all "-L fast" -DCMAKE_BUILD_TYPE=Release
  exit
fi
time suite "optimised; and with asserts and sanitizers" tests all "" -DCMAKE_BUILD_TYPE=Release -DTRICOVER_TEST_CHECKED=ON \
  -DTRICOVER_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3
# Linked as a whole, it shows, too, whether two types have one name.
time TRICOVER_TEST_SCALE=0.3 suite "threads; one definition" threads "threads_test one_definition" "-R threads" \
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O1 -flto=auto -Wodr -Werror=odr" -DTRICOVER_SANITIZE=thread -DTRICOVER_BUILD_FCL=OFF
if command -v clang++ >/dev/null; then
  targets="tricover tricover_io tricover_fcl" filter="-R consumer"
  if echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
    clang++ -fsanitize=fuzzer -x c++ -o /dev/null - 2>/dev/null; then
    targets+=" fuzz_collide_libfuzzer fuzz_geojson_libfuzzer fuzz_locate_libfuzzer fuzz_map_libfuzzer"
    targets+=" fuzz_scales_libfuzzer fuzz_scene_libfuzzer"
    targets+=" fuzz_validation_libfuzzer fuzz_wkt_libfuzzer" filter+="|libfuzzer"
  fi
  time suite "clang: shared libraries, libFuzzer" clang "$targets" "$filter" -DCMAKE_CXX_COMPILER=clang++ \
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DBUILD_SHARED_LIBS=ON
fi
