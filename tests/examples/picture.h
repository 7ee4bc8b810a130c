// SPDX-License-Identifier: BSD-3-Clause
// What the examples that draw have in common.
#pragma once

#include <algorithm>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

/// Saves a drawing or a recording, and says where.
template <typename Picture>
void savePicture(const Picture& picture, const std::string& path) {
  picture.save(path);
  std::cerr << "drawn: " << path << "\n";
}

/// An example's main(): calls run(arguments), the first of which is the picture's path, `picture` where there is none,
/// and returns its status. `--help` says the usage; other options, and more arguments than `most`, are errors. Errors
/// are one sentence, and status 1.
template <typename Run>
int runExample(int argc, char** argv, const std::string& usage, const std::string& picture, std::size_t most,
               const Run& run) {
  try {
    std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    for (const std::string& argument : arguments) {
      if (argument == "--help" || argument == "-h") {
        std::cout << usage;
        return 0;
      }
      if (argument.rfind("--", 0) == 0) throw std::runtime_error(argument + ": is no option\n" + usage);
    }
    if (arguments.size() > most) throw std::runtime_error(arguments[most] + ": is one argument too many\n" + usage);
    if (arguments.empty()) arguments.push_back(picture);
    return run(arguments);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << "\n";
    return 1;
  }
}
