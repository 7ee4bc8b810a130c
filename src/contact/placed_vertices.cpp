// SPDX-License-Identifier: BSD-3-Clause
#include "contact/placed_vertices.h"

#include "contact/boundary_point.h"
#include "contact/translation_space.h"

namespace tricover::detail {

void PlacedVertices::place(std::size_t i) const {
  const std::size_t ring = polygon_->ringOf(i), begin = polygon_->edgeBegin(ring), end = polygon_->edgeEnd(ring);
  PlacedVertex& vertex = vertices_[i];
  is_placed_[i] = 1;
  vertex.at = origin_ + inUnits(polygon_->path[i], polygon_->origin);
  vertex.incoming = vertex.outgoing = Vec2::Zero();
  vertex.is_edge = vertex.is_reflex = false;
  vertex.side = 0;
  if (i < end && isEdge(i)) {
    std::size_t before = i;
    do before = (before == begin ? end : before) - 1;
    while (!isEdge(before));
    vertex.is_edge = true;
    vertex.incoming = edge(before);
    vertex.outgoing = edge(i);
    if (sides_ == nullptr) return;
    const int turned = linear_.determinant() < 0 ? -1 : 1;
    vertex.side = static_cast<std::int8_t>(turned * sides_->rings[ring]);
    const double error = kVertexError * vertex.incoming.lpNorm<1>() * vertex.outgoing.lpNorm<1>();
    vertex.is_reflex = vertex.side * cross(vertex.incoming, vertex.outgoing) < -error;
  } else {
    vertex.is_edge = beginsPoint(*polygon_, i);  // one edge without a length
  }
}

}  // namespace tricover::detail
