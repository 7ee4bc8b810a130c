// SPDX-License-Identifier: BSD-3-Clause
// A program without tricover that opens two plugins, each with a static tricover: host PLUGIN OTHER.
// Either makes its first polygon, and either queries both polygons. Ids of the two copies must differ.
#include <dlfcn.h>

#include <cstdio>

int main(int count, char** arguments) {
  if (count != 3) return 2;
  using Make = const void* (*)(double half);
  using Ask = bool (*)(const void* small, const void* large);
  Ask ask[2];
  const void* made[2];
  for (int i = 0; i < 2; ++i) {
    void* const plugin = dlopen(arguments[i + 1], RTLD_NOW | RTLD_LOCAL);
    const auto make = plugin ? reinterpret_cast<Make>(dlsym(plugin, "makeFirst")) : nullptr;
    ask[i] = plugin ? reinterpret_cast<Ask>(dlsym(plugin, "askAboutBoth")) : nullptr;
    if (!make || !ask[i]) {
      std::printf("%s\n", dlerror());
      return 1;
    }
    made[i] = make(i == 0 ? 0.5 : 2);
  }
  bool is_right = true;
  for (const Ask each : ask) is_right = each(made[0], made[1]) && is_right;
  return is_right ? 0 : 1;
}
