// SPDX-License-Identifier: BSD-3-Clause
// Runs a fuzz target without libFuzzer: on the files given, or on seeded random bytes for some seconds.
//   <target> file...                  replay these inputs
//   <target> [--seconds=S] [--seed=N]  random inputs; a seed means the same inputs on every machine
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "random.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

bool replay(const char* path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "%s: can't be read\n", path);
    return false;
  }
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return true;
}

void runRandom(double seconds, std::uint64_t seed) {
  tricover::support::Random random(seed);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  long inputs = 0;
  do {
    for (int i = 0; i < 64; ++i, ++inputs) {
      std::vector<std::uint8_t> bytes(static_cast<std::size_t>(random.integer(8, 256)));
      for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
      LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }
  } while (std::chrono::steady_clock::now() < end);
  std::printf("%ld inputs from seed %llu, none failed\n", inputs, static_cast<unsigned long long>(seed));
}

}  // namespace

int main(int argc, char** argv) {
  double seconds = 5;
  std::uint64_t seed = 1;
  int files = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.rfind("--seconds=", 0) == 0) {
      seconds = std::atof(argument.c_str() + 10);
    } else if (argument.rfind("--seed=", 0) == 0) {
      seed = std::strtoull(argument.c_str() + 7, nullptr, 10);
    } else {
      if (!replay(argv[i])) return 1;
      ++files;
    }
  }
  if (files > 0)
    std::printf("%d inputs replayed, none failed\n", files);
  else
    runRandom(seconds, seed);
  return 0;
}
