// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "random.h"
#include "tricover/scene.h"

namespace tricover::support {

/// Areas and a part that they may cover together.
struct Sheet {
  std::vector<BodyPlacement> areas;
  Polygon part;
  Pose pose;
};

/// One way in which areas and parts touch; in all of them areas often abut, and the part is covered as often as not.
struct SheetKind {
  const char* name;
  Sheet (*make)(Random& random);
};

const std::vector<SheetKind>& sheetKinds();

struct CoversCounts {
  int covered = 0, not_covered = 0;
  int unions = 0;  ///< covered by several together, and by none alone
};

/// The first answer of covers() or Scene::covers() that is not the one of exact rationals; empty if there is none.
std::string wrongCovers(const Sheet& sheet, double margin, CoversCounts& counts);

/// A case an area.
std::string reproduction(const Sheet& sheet);

}  // namespace tricover::support
