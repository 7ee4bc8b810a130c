// SPDX-License-Identifier: BSD-3-Clause
// Cells that the outline touches are marked, with a margin for rounding. The outline is nowhere else, so the cells
// around them are all on one side, which crossings of rows tell. How far a cell is from the nearest marked one is an
// exact transform of integers: Meijster, Roerdink and Hesselink, "A General Algorithm for Computing Distance Transforms
// in Linear Time" (2000). Between any two points of two cells that are i columns and j rows apart there are at least
// sqrt((|i| - 1)^2 + (|j| - 1)^2) sides: that is the distance of the middles if each marked cell stands for the nine
// around it.
#include "hierarchy/influence_field.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "polygon/edge_walk.h"

namespace tricover::detail {
namespace {

/// A cell counts as larger by this, in sides, where the outline touches it. Vertices and crossings are rounded by far
/// less.
constexpr double kPadding = 0x1p-16;
/// A cell that the outline touches, while the field is made.
constexpr std::uint8_t kTouched = 255;
/// Distances that a cell can tell, in sides.
constexpr int kFarthest = 64;

/// An edge in sides from the grid's corner.
struct GridEdge {
  double left() const { return std::min(v.x(), w.x()); }
  double right() const { return std::max(v.x(), w.x()); }
  double low() const { return std::min(v.y(), w.y()); }
  double high() const { return std::max(v.y(), w.y()); }
  /// Where it is at a height, within its own width.
  double x(double y) const {
    const double share = std::clamp((y - v.y()) / (w.y() - v.y()), 0.0, 1.0);
    return v.x() + share * (w.x() - v.x());
  }

  Vec2 v, w;
};

struct Grid {
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  int column(double x) const { return std::clamp(static_cast<int>(std::floor(x)), 0, columns - 1); }
  int row(double y) const { return std::clamp(static_cast<int>(std::floor(y)), 0, rows - 1); }
  GridEdge edge(const PolygonData& polygon, EdgePosition e) const {
    return {(polygon.inUnits(polygon.path[e]) - low) * inverse_side,
            (polygon.inUnits(polygon.path[e + 1]) - low) * inverse_side};
  }

  /// Calls visit(row, first column, last column) for the cells that an edge touches.
  template <typename Visit>
  void forEachTouched(const GridEdge& edge, Visit visit) const {
    const double low_y = edge.low(), high_y = edge.high();
    for (int row_at = row(low_y - kPadding), last = row(high_y + kPadding); row_at <= last; ++row_at) {
      double from = edge.left(), to = edge.right();
      if (low_y < high_y) {
        from = edge.x(std::max(row_at - kPadding, low_y)), to = edge.x(std::min(row_at + 1 + kPadding, high_y));
        if (from > to) std::swap(from, to);
      }
      visit(row_at, column(from - kPadding), column(to + kPadding));
    }
  }

  /// Counts an edge where it crosses the middle of a row: from there on to the right the winding is another one.
  void count(const GridEdge& edge, std::vector<int>& changes) const {
    const int up = edge.v.y() < edge.w.y() ? 1 : -1;
    for (int row_at = row(edge.low() - 1), last = row(edge.high()); row_at <= last; ++row_at) {
      const double middle = row_at + 0.5;
      if (edge.low() <= middle && middle < edge.high()) changes[at(column(edge.x(middle)), row_at)] -= up;
    }
  }

  Vec2 low;
  double inverse_side;
  int columns, rows;
};

/// The distances of all cells from marked ones, squared, where each marked cell stands for the nine around it.
class Distances {
 public:
  Distances(const Grid& grid, const std::vector<std::uint8_t>& touched, std::vector<int>& squares)
      : grid_(grid), squares_(squares) {
    alongColumns(touched);
    for (int row = 0; row < grid_.rows; ++row) alongRow(row);
  }

 private:
  static constexpr int kNoneNear = kFarthest + 2;

  void alongColumns(const std::vector<std::uint8_t>& touched) {
    const auto columns = static_cast<std::size_t>(grid_.columns);
    for (std::size_t k = 0; k < touched.size(); ++k)
      squares_[k] =
          touched[k] == kTouched ? 0 : std::min(k < columns ? kNoneNear : squares_[k - columns] + 1, kNoneNear);
    for (std::size_t k = touched.size() - columns; k-- > 0;)
      squares_[k] = std::min(squares_[k], squares_[k + columns] + 1);
  }

  /// The lower envelope of parabolas, one for each column, that begin at the columns' squares.
  void alongRow(int row) {
    const int n = grid_.columns;
    int* line = squares_.data() + grid_.at(0, row);
    heights_.resize(static_cast<std::size_t>(n));
    tops_.clear();
    for (int i = 0; i < n; ++i) {
      const int nearest = std::min({line[std::max(i - 1, 0)], line[i], line[std::min(i + 1, n - 1)]});
      const int height = std::max(nearest - 1, 0);
      heights_[static_cast<std::size_t>(i)] = height * height;
    }
    for (int i = 0; i < n; ++i) {
      while (!tops_.empty() && value(tops_.back().from, tops_.back().column) > value(tops_.back().from, i))
        tops_.pop_back();
      const std::int64_t from = tops_.empty() ? 0 : 1 + crossing(tops_.back().column, i);
      if (from < n) tops_.push_back({i, static_cast<int>(from)});
    }
    for (int i = n - 1; i >= 0; --i) {
      line[i] = static_cast<int>(std::min<std::int64_t>(value(i, tops_.back().column), kFarthest * kFarthest));
      if (i == tops_.back().from) tops_.pop_back();
    }
  }

  std::int64_t value(int at, int column) const {
    return std::int64_t{at - column} * (at - column) + heights_[static_cast<std::size_t>(column)];
  }
  /// The last place where the parabola of i is no higher than that of k, i < k: that is none before the first.
  std::int64_t crossing(int i, int k) const {
    const std::int64_t above =
        std::int64_t{k - i} * (k + i) + heights_[static_cast<std::size_t>(k)] - heights_[static_cast<std::size_t>(i)];
    return above >= 0 ? above / (2 * (k - i)) : -1;
  }

  struct Top {
    int column, from;
  };
  const Grid& grid_;
  std::vector<int>& squares_;
  std::vector<int> heights_;
  std::vector<Top> tops_;
};

}  // namespace

InfluenceField::InfluenceField(const PolygonData& polygon) : is_complement_(polygon.fill.is_complement) {
  low_ = polygon.inUnits(polygon.path[0]);
  Vec2 high = low_, ways(0, 0);
  detail::forEachEdge(polygon, [&](EdgePosition e) {
    const Vec2 v = polygon.inUnits(polygon.path[e]);
    low_ = low_.cwiseMin(v), high = high.cwiseMax(v);
    ways += (polygon.inUnits(polygon.path[e + 1]) - v).cwiseAbs();
    return true;
  });
  // The cells, the rows, and the tiles of all edges are no more than so many an edge.
  const Vec2 size = high - low_;
  const auto edges = static_cast<double>(std::min(polygon.path.size(), kMostCells / kCellsOfEdge));
  const double wanted = kCellsOfEdge * edges;
  side_ = std::max({std::sqrt(size.x() * size.y() / wanted), 32 * size.maxCoeff() / wanted,
                    ways.sum() / (kTile * static_cast<double>(polygon.path.size()))});
  inverse_side_ = 1 / side_;
  const Grid grid{low_, inverse_side_, static_cast<int>(size.x() * inverse_side_) + 1,
                  static_cast<int>(size.y() * inverse_side_) + 1};
  columns_ = grid.columns, rows_ = grid.rows;
  const std::size_t cell_count = grid.at(0, grid.rows);
  cells_.resize(cell_count);
  std::vector<int> work(cell_count);
  detail::forEachEdge(polygon, [&](EdgePosition e) {
    const GridEdge edge = grid.edge(polygon, e);
    grid.count(edge, work);
    grid.forEachTouched(edge, [&](int row, int first, int last) {
      std::fill_n(cells_.begin() + static_cast<std::ptrdiff_t>(grid.at(first, row)), last - first + 1, kTouched);
    });
    return true;
  });
  for (int row = 0; row < grid.rows; ++row) {
    int winding = 0;
    for (std::size_t k = grid.at(0, row); k < grid.at(0, row + 1); ++k) {
      winding += work[k];
      const bool is_inside = polygon.fill.rule == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0;
      if (cells_[k] != kTouched) cells_[k] = is_inside != is_complement_ ? kInside : 0;
    }
  }
  const Distances distances(grid, cells_, work);
  std::array<std::uint8_t, kFarthest * kFarthest + 1> steps{};
  for (std::size_t k = 0; k < steps.size(); ++k)
    steps[k] =
        static_cast<std::uint8_t>(std::min(1 + static_cast<unsigned>(2 * std::sqrt(static_cast<double>(k))), kSteps));
  for (std::size_t k = 0; k < cell_count; ++k)
    cells_[k] =
        static_cast<std::uint8_t>(cells_[k] == kTouched ? 0 : steps[static_cast<std::size_t>(work[k])] | cells_[k]);
  addEdges(polygon);
}

/// Counted, then placed.
void InfluenceField::addEdges(const PolygonData& polygon) {
  const auto tiles = [](double cells) { return (static_cast<int>(cells) - 1) / kTile + 1; };
  const Grid grid{low_, inverse_side_ / kTile, tiles(columns_), tiles(rows_)};
  const auto forEachTile = [&](auto visit) {
    detail::forEachEdge(polygon, [&](EdgePosition e) {
      grid.forEachTouched(grid.edge(polygon, e), [&](int row, int first, int last) {
        for (int column = first; column <= last; ++column) visit(grid.at(column, row), e);
      });
      return true;
    });
  };
  tile_columns_ = static_cast<std::size_t>(grid.columns);
  tile_begins_.resize(grid.at(0, grid.rows) + 1);
  forEachTile([&](std::size_t tile, EdgePosition) { ++tile_begins_[tile + 1]; });
  for (std::size_t tile = 0; tile + 1 < tile_begins_.size(); ++tile) tile_begins_[tile + 1] += tile_begins_[tile];
  tile_edges_.resize(tile_begins_.back());
  std::vector<std::uint32_t> ends(tile_begins_.begin(), tile_begins_.end() - 1);
  forEachTile([&](std::size_t tile, EdgePosition e) { tile_edges_[ends[tile]++] = e; });
}

const InfluenceField& fieldOf(const PolygonData& polygon) { return topOf(polygon).field.made<InfluenceField>(polygon); }

void payForField(const PolygonData& polygon, std::size_t cost) {
  constexpr std::size_t kOfCell = 4;
  const std::size_t cells = std::min(InfluenceField::kCellsOfEdge * polygon.path.size(), InfluenceField::kMostCells);
  if (topOf(polygon).field_rental.isDue(cost, kOfCell * cells)) fieldOf(polygon);
}

/// Outside of the grid nothing is.
InfluenceField::Look InfluenceField::beyond(double column, double row) const {
  const auto outside = [](double at, double size) { return at < 0 ? -at : std::max(at - size, 0.0); };
  const double free = std::hypot(outside(column, columns_), outside(row, rows_)) * (1 - 0x1p-20) * side_;
  return {free, kNone, is_complement_};
}

}  // namespace tricover::detail
