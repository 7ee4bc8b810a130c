#!/usr/bin/env bash
# Installs what is missing (Debian, as root or with sudo), builds, and runs every test: optimised, then under AddressSanitizer
# and UndefinedBehaviorSanitizer, then the threads under ThreadSanitizer, then libFuzzer where clang has it. Prints CTest's
# closing lines; exits non-zero if a test fails.
set -eu
cd "$(dirname "$0")/.."
bash .ci/install build-essential cmake libeigen3-dev libfcl-dev libccd-dev libgtest-dev libgmp-dev libompl-dev doxygen

suite() {  # suite <title> <build directory> <targets> <test filter> <cmake options ...>
  local title=$1 build=$2 targets=$3 filter=$4
  shift 4
  echo "== $title"
  cmake -S . -B "$build" -DTRICOVER_BUILD_TESTS=ON -DTRICOVER_WERROR=ON "$@" >"$build.log" 2>&1 || { cat "$build.log"; return 1; }
  cmake --build "$build" --target $targets -j "$(nproc)" >>"$build.log" 2>&1 || { tail -n 60 "$build.log"; return 1; }
  ctest --test-dir "$build" -R "$filter" --output-on-failure -j "$(nproc)"
}

mkdir -p build
suite "optimised" build/tests all . -DCMAKE_BUILD_TYPE=Release
# Instrumented code is some ten times slower: fewer random cases.
export TRICOVER_TEST_SCALE=0.3
suite "address, undefined" build/sanitize all . -DCMAKE_BUILD_TYPE=Release -DTRICOVER_SANITIZE=address,undefined
suite "thread" build/thread threads_test threads -DCMAKE_BUILD_TYPE=Release -DTRICOVER_SANITIZE=thread -DTRICOVER_BUILD_FCL=OFF
if echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
  clang++ -fsanitize=fuzzer -x c++ -o /dev/null - 2>/dev/null; then
  suite "libFuzzer" build/clang "fuzz_collide_libfuzzer fuzz_locate_libfuzzer fuzz_validation_libfuzzer" libfuzzer \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=clang++ -DTRICOVER_BUILD_FCL=OFF
fi
