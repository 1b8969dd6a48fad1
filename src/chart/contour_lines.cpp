// SPDX-License-Identifier: Apache-2.0
#include "contour_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace strainwave {
namespace {

/// An edge of the grid: from a point to the next one along i or along j.
struct Edge {
  std::size_t i = 0;
  std::size_t j = 0;
  bool along_i = false;
  friend auto operator<=>(const Edge&, const Edge&) = default;
};
using Segment = std::pair<Edge, Edge>;

class Grid {
 public:
  Grid(std::span<const double> values, std::size_t n_j, double level)
      : values_(values), n_j_(n_j), level_(level) {}

  /// The value at a point minus the level.
  [[nodiscard]] double above(std::size_t i, std::size_t j) const {
    return values_[i * n_j_ + j] - level_;
  }
  [[nodiscard]] bool crosses(const Edge& e) const {
    const auto [from, to] = ends(e);
    return (from >= 0) != (to >= 0);
  }
  [[nodiscard]] GridPoint crossing(const Edge& e) const {
    const auto [from, to] = ends(e);
    const double share = from / (from - to);
    const auto i = static_cast<double>(e.i);
    const auto j = static_cast<double>(e.j);
    return e.along_i ? GridPoint{i + share, j} : GridPoint{i, j + share};
  }

  /// The pieces of the line in the cell whose first corner is (i, j): none, one or two.
  void add_pieces(std::size_t i, std::size_t j, std::vector<Segment>& pieces) const {
    // The edges round the cell, beginning at its corner (i, j).
    const std::array<double, 4> corner = {above(i, j), above(i + 1, j), above(i + 1, j + 1),
                                          above(i, j + 1)};
    if (!std::ranges::all_of(corner, [](double value) { return std::isfinite(value); })) return;
    const std::array<Edge, 4> edge = {
        {{i, j, true}, {i + 1, j, false}, {i, j + 1, true}, {i, j, false}}};
    std::vector<std::size_t> cut;
    for (std::size_t k = 0; k < 4; ++k)
      if (crosses(edge[k])) cut.push_back(k);
    if (cut.size() == 2) pieces.emplace_back(edge[cut[0]], edge[cut[1]]);
    if (cut.size() != 4) return;
    // In a saddle, the mean decides on which side of the level the middle lies.
    const double middle = (corner[0] + corner[1] + corner[2] + corner[3]) / 4;
    const std::size_t shift = (corner[0] >= 0) == (middle >= 0) ? 0 : 3;
    pieces.emplace_back(edge[shift % 4], edge[(shift + 1) % 4]);
    pieces.emplace_back(edge[(shift + 2) % 4], edge[(shift + 3) % 4]);
  }

 private:
  [[nodiscard]] std::pair<double, double> ends(const Edge& e) const {
    return {above(e.i, e.j), e.along_i ? above(e.i + 1, e.j) : above(e.i, e.j + 1)};
  }

  std::span<const double> values_;
  std::size_t n_j_;
  double level_;
};

/// Joins pieces that share edges into lines.
class Chains {
 public:
  explicit Chains(const std::vector<Segment>& pieces) : pieces_(pieces), used_(pieces.size()) {
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      at_[pieces[p].first].push_back(p);
      at_[pieces[p].second].push_back(p);
    }
  }

  /// Follow open lines from their ends first, then closed lines.
  [[nodiscard]] std::vector<std::vector<Edge>> all() {
    std::vector<std::vector<Edge>> chains;
    for (const auto& [edge, touching] : at_)
      if (touching.size() == 1 && !used_[touching[0]]) chains.push_back(from(edge));
    for (const Segment& piece : pieces_)
      if (!used_[static_cast<std::size_t>(&piece - pieces_.data())])
        chains.push_back(from(piece.first));
    return chains;
  }

 private:
  std::vector<Edge> from(Edge edge) {
    std::vector<Edge> chain = {edge};
    for (;;) {
      const auto& touching = at_.at(edge);
      const auto next = std::ranges::find_if(touching, [&](std::size_t p) { return !used_[p]; });
      if (next == touching.end()) return chain;
      used_[*next] = true;
      const auto& [first, second] = pieces_[*next];
      edge = first == edge ? second : first;
      chain.push_back(edge);
    }
  }

  const std::vector<Segment>& pieces_;
  std::vector<bool> used_;
  std::map<Edge, std::vector<std::size_t>> at_;
};

}  // namespace

std::vector<GridLine> contour_lines(std::span<const double> values, std::size_t n_i,
                                    std::size_t n_j, double level) {
  const Grid grid(values, n_j, level);
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i + 1 < n_i; ++i)
    for (std::size_t j = 0; j + 1 < n_j; ++j) grid.add_pieces(i, j, pieces);
  std::vector<GridLine> lines;
  for (const std::vector<Edge>& chain : Chains(pieces).all()) {
    GridLine& line = lines.emplace_back();
    for (const Edge& edge : chain) line.push_back(grid.crossing(edge));
  }
  return lines;
}

}  // namespace strainwave
