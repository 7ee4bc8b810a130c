// SPDX-License-Identifier: BSD-3-Clause
// A program that is linked with libfcl alone and opens plugins: host local|global first|then PLUGIN...
// Asks each in turn, then FCL about spheres; or about these first, too.
#include <dlfcn.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <iostream>
#include <string>
#include <vector>

namespace {

void askSpheres() {
  const fcl::Sphered sphere(1);
  fcl::Transform3d beside = fcl::Transform3d::Identity();
  beside.translation().x() = 3;
  fcl::CollisionResultd collision;
  fcl::DistanceResultd distance;
  fcl::collide<double>(&sphere, beside, &sphere, beside, fcl::CollisionRequestd(), collision);
  std::cout << "spheres: " << collision.numContacts() << " "
            << fcl::distance<double>(&sphere, fcl::Transform3d::Identity(), &sphere, beside, fcl::DistanceRequestd(),
                                     distance)
            << "\n";
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> said(arguments + 1, arguments + count);
  if (said.size() < 3) return 2;
  if (said[1] == "first") askSpheres();
  for (std::size_t i = 2; i < said.size(); ++i) {
    const bool is_checked = said[i] == "checked";
    if (is_checked) ++i;
    void* const plugin = dlopen(said[i].c_str(), RTLD_NOW | (said[0] == "local" ? RTLD_LOCAL : RTLD_GLOBAL));
    const auto ask = plugin ? reinterpret_cast<void (*)(bool)>(dlsym(plugin, "askPlugin")) : nullptr;
    if (!ask) {
      std::cout << dlerror() << "\n";
      return 1;
    }
    ask(is_checked);
    dlclose(plugin);
  }
  askSpheres();
}
