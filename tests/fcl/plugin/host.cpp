// SPDX-License-Identifier: BSD-3-Clause
// Opens plugins that bring tricover: host local|global PLUGIN... Linked with libfcl or, without HOST_LINKS_FCL, not.
#include <dlfcn.h>

#include <iostream>
#include <string>
#include <vector>

#ifdef HOST_LINKS_FCL
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

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
#else
void askSpheres() {}
#endif

int main(int count, char** arguments) {
  const std::vector<std::string> said(arguments + 1, arguments + count);
  if (said.size() < 2) return 2;
  askSpheres();
  for (std::size_t i = 1; i < said.size(); ++i) {
    void* const plugin = dlopen(said[i].c_str(), RTLD_NOW | (said[0] == "local" ? RTLD_LOCAL : RTLD_GLOBAL));
    const auto ask = plugin ? reinterpret_cast<void (*)()>(dlsym(plugin, "askPlugin")) : nullptr;
    if (!ask) {
      std::cout << dlerror() << "\n";
      return 1;
    }
    ask();
    dlclose(plugin);
  }
  askSpheres();
}
