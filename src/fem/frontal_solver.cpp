// SPDX-License-Identifier: Apache-2.0
#include "fem/frontal_solver.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <map>
#include <ranges>
#include <span>
#include <utility>

namespace strainwave::fem {
namespace {

using Eigen::Index;
using Matrix = Eigen::MatrixXd;
using Column = Eigen::VectorXd;
using Unknowns = std::vector<Eigen::Index>;

/// An element, or several merged.
struct Front {
  std::vector<std::size_t> children = {};  ///< fronts; none for an element
  Unknowns unknowns = {};                  ///< those that are eliminated here, then those that stay
  Index eliminated = 0;
  Matrix panel = {};  ///< columns of the eliminated unknowns; then those of the Cholesky factor
  Matrix rest = {};   ///< what is left for the unknowns that stay, lower half

  [[nodiscard]] std::span<const Index> gone() const {
    return std::span(unknowns).first(static_cast<std::size_t>(eliminated));
  }
  [[nodiscard]] std::span<const Index> staying() const {
    return std::span(unknowns).subspan(static_cast<std::size_t>(eliminated));
  }
};

/// Unknowns that are in the same elements.
struct Bundle {
  Unknowns unknowns = {};
  std::vector<std::size_t> holders = {};  ///< fronts that have them, rising
};

/// Which fronts are merged, and what is eliminated where: by least degree.
class Order {
 public:
  Order(const std::vector<Unknowns>& elements, Index n) {
    std::vector<std::vector<std::size_t>> holders(static_cast<std::size_t>(n));
    for (std::size_t e = 0; e < elements.size(); ++e)
      for (const Index i : elements[e]) holders[static_cast<std::size_t>(i)].push_back(e);
    fronts_.resize(elements.size());
    shared_.resize(elements.size());
    std::map<std::vector<std::size_t>, std::size_t> known;
    for (Index i = 0; i < n; ++i) {
      const auto& mine = holders[static_cast<std::size_t>(i)];
      if (mine.size() == 1) eliminate(mine.front(), {i});
      if (mine.size() < 2) continue;
      const auto [at, added] = known.try_emplace(mine, bundles_.size());
      if (added) {
        for (const std::size_t e : mine) shared_[e].push_back(bundles_.size());
        bundles_.push_back({.unknowns = {}, .holders = mine});
      }
      bundles_[at->second].unknowns.push_back(i);
    }
    for (std::size_t e = 0; e < elements.size(); ++e) keep(e);
    merge();
  }

  [[nodiscard]] std::vector<Front> fronts() && { return std::move(fronts_); }

 private:
  void eliminate(std::size_t front, const Unknowns& unknowns) {
    auto& list = fronts_[front].unknowns;
    list.insert(list.end(), unknowns.begin(), unknowns.end());
    fronts_[front].eliminated = static_cast<Index>(list.size());
  }

  void keep(std::size_t front) {
    auto& list = fronts_[front].unknowns;
    for (const std::size_t b : shared_[front])
      list.insert(list.end(), bundles_[b].unknowns.begin(), bundles_[b].unknowns.end());
  }

  /// Bundles of all fronts that have this one.
  [[nodiscard]] std::vector<std::size_t> joined(const Bundle& bundle) const {
    std::vector<std::size_t> all;
    for (const std::size_t f : bundle.holders)
      all.insert(all.end(), shared_[f].begin(), shared_[f].end());
    std::ranges::sort(all);
    const auto twice = std::ranges::unique(all);
    all.erase(twice.begin(), twice.end());
    return all;
  }

  [[nodiscard]] std::size_t degree(const Bundle& bundle) const {
    std::size_t count = 0;
    for (const std::size_t b : joined(bundle)) count += bundles_[b].unknowns.size();
    return count;
  }

  void merge() {
    constexpr auto kDone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> degrees;
    for (const Bundle& bundle : bundles_) degrees.push_back(degree(bundle));
    while (true) {
      const auto least = std::ranges::min_element(degrees);
      if (least == degrees.end() || *least == kDone) return;
      const Bundle next = bundles_[static_cast<std::size_t>(least - degrees.begin())];
      const std::size_t merged = fronts_.size();
      fronts_.push_back({.children = next.holders});
      shared_.emplace_back();
      for (const std::size_t b : joined(next)) {
        auto& holders = bundles_[b].holders;
        std::erase_if(holders,
                      [&](std::size_t f) { return std::ranges::binary_search(next.holders, f); });
        if (holders.empty()) {
          eliminate(merged, bundles_[b].unknowns);
          degrees[b] = kDone;
        } else {
          shared_[merged].push_back(b);
        }
        holders.push_back(merged);
      }
      keep(merged);
      for (const std::size_t b : shared_[merged]) degrees[b] = degree(bundles_[b]);
    }
  }

  std::vector<Front> fronts_;
  std::vector<Bundle> bundles_;
  std::vector<std::vector<std::size_t>> shared_;  ///< bundles that stay, of each front
};

/// Adds the lower half of a matrix to a front, row and column n going to place[n].
void add(Front& front, const Matrix& lower, const std::vector<Index>& place) {
  const Index k = front.eliminated;
  for (Index j = 0; j < lower.cols(); ++j)
    for (Index i = j; i < lower.rows(); ++i) {
      const auto [column, row] =
          std::minmax(place[static_cast<std::size_t>(i)], place[static_cast<std::size_t>(j)]);
      if (column < k)
        front.panel(row, column) += lower(i, j);
      else
        front.rest(row - k, column - k) += lower(i, j);
    }
}

/// Eliminates from a front, and from the right-hand side `x`; false if a pivot is too small.
bool eliminate(Front& front, Column& x, const Column& diagonal) {
  const Index k = front.eliminated;
  const Index stay = front.rest.rows();
  Eigen::Ref<Matrix> top = front.panel.topRows(k);
  Eigen::Ref<Matrix> low = front.panel.bottomRows(stay);
  const Eigen::LLT<Eigen::Ref<Matrix>> root(top);  // in place
  if (root.info() != Eigen::Success) return false;
  for (Index i = 0; i < k; ++i)
    if (!(top(i, i) * top(i, i) >
          kLeastPivot * diagonal(front.unknowns[static_cast<std::size_t>(i)])))
      return false;
  top.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(low);
  front.rest.selfadjointView<Eigen::Lower>().rankUpdate(low, -1.0);
  Column y = x(front.gone());
  top.triangularView<Eigen::Lower>().solveInPlace(y);
  x(front.gone()) = y;
  x(front.staying()) -= low * y;
  return true;
}

/// The eliminated unknowns, when those that stay are known.
void substitute_back(const Front& front, Column& x) {
  const Index k = front.eliminated;
  Column y = x(front.gone());
  y -= front.panel.bottomRows(front.panel.rows() - k).transpose() * x(front.staying());
  front.panel.topRows(k).triangularView<Eigen::Lower>().transpose().solveInPlace(y);
  x(front.gone()) = y;
}

}  // namespace

std::optional<Column> solve_by_fronts(const std::vector<Unknowns>& elements,
                                      const std::function<Matrix(std::size_t)>& matrix,
                                      const Column& load) {
  std::vector<Front> fronts = Order(elements, load.size()).fronts();
  Column x = Column::Zero(load.size());
  Column diagonal = x;
  std::vector<Index> where(static_cast<std::size_t>(load.size()));  // in the front at hand
  const auto places = [&](const auto& unknowns) {
    std::vector<Index> place;
    for (const Index i : unknowns) place.push_back(where[static_cast<std::size_t>(i)]);
    return place;
  };
  for (const Unknowns& element : elements) x(element) = load(element);
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    Front& front = fronts[f];
    const auto all = static_cast<Index>(front.unknowns.size());
    for (Index i = 0; i < all; ++i)
      where[static_cast<std::size_t>(front.unknowns[static_cast<std::size_t>(i)])] = i;
    front.panel = Matrix::Zero(all, front.eliminated);
    front.rest = Matrix::Zero(all - front.eliminated, all - front.eliminated);
    if (f < elements.size()) {
      const Matrix element = matrix(f);
      diagonal(elements[f]) += element.diagonal();
      add(front, element, places(elements[f]));
    }
    for (const std::size_t child : front.children) {
      add(front, fronts[child].rest, places(fronts[child].staying()));
      fronts[child].rest = Matrix();
    }
    if (!eliminate(front, x, diagonal)) return std::nullopt;
  }
  for (const Front& front : fronts | std::views::reverse) substitute_back(front, x);
  return x;
}

}  // namespace strainwave::fem
