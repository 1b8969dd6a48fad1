// SPDX-License-Identifier: Apache-2.0
#include "condensed_solver.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <utility>

#include "direct_solver.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

using Matrix = Eigen::MatrixXd;
using Column = Eigen::VectorXd;

/// The parts of an element from which its own unknowns are recovered.
struct Inner {
  std::vector<Eigen::Index> alone;   ///< numbers of the unknowns that belong to this element alone
  std::vector<Eigen::Index> shared;  ///< numbers of the other unknowns
  CondensedMatrix matrix;            ///< without its `outer`
};

/// True if no pivot vanishes in rounding.
bool is_safe(const Column& pivots, const Column& diagonal) {
  return (pivots.array() > kLeastPivot * diagonal.array()).all();
}

}  // namespace

struct CondensedEquations::Parts {
  Eigen::Index unknowns = 0;
  std::vector<Eigen::Index> number;  ///< index of an unknown in the sparse equations; -1: not there
  Eigen::Index shared = 0;           ///< size of the sparse equations
  std::vector<Inner> inner;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;

  [[nodiscard]] std::vector<Eigen::Index> places(const Inner& cell) const {
    std::vector<Eigen::Index> places;
    for (const Eigen::Index i : cell.shared) places.push_back(number[static_cast<std::size_t>(i)]);
    return places;
  }
};

CondensedEquations::CondensedEquations(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
CondensedEquations::~CondensedEquations() = default;
CondensedEquations::CondensedEquations(CondensedEquations&&) noexcept = default;
CondensedEquations& CondensedEquations::operator=(CondensedEquations&&) noexcept = default;

std::optional<CondensedEquations> CondensedEquations::factor(
    const std::vector<std::vector<Eigen::Index>>& elements,
    const std::function<Matrix(std::size_t)>& matrix, Eigen::Index unknowns) {
  auto made = std::make_unique<Parts>();
  Parts& parts = *made;
  parts.unknowns = unknowns;
  std::vector<int> holders(static_cast<std::size_t>(unknowns), 0);
  for (const auto& element : elements)
    for (const Eigen::Index i : element) ++holders[static_cast<std::size_t>(i)];
  parts.number.assign(holders.size(), -1);
  for (std::size_t i = 0; i < holders.size(); ++i)
    if (holders[i] > 1) parts.number[i] = parts.shared++;

  std::vector<Eigen::Triplet<double>> entries;
  std::size_t count = 0;
  for (const auto& element : elements) count += element.size() * (element.size() + 1) / 2;
  entries.reserve(count);
  Column diagonal = Column::Zero(parts.shared);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const Matrix k = matrix(e).selfadjointView<Eigen::Lower>();
    std::vector<Eigen::Index> order;  // indices in the element, its own unknowns first
    std::vector<Eigen::Index> outside;
    Inner& cell = parts.inner.emplace_back();
    for (Eigen::Index i = 0; i < k.rows(); ++i) {
      const Eigen::Index unknown = elements[e][static_cast<std::size_t>(i)];
      const bool alone = parts.number[static_cast<std::size_t>(unknown)] < 0;
      (alone ? order : outside).push_back(i);
      (alone ? cell.alone : cell.shared).push_back(unknown);
    }
    order.insert(order.end(), outside.begin(), outside.end());
    const std::vector<Eigen::Index> places = parts.places(cell);
    const Matrix sorted = k(order, order);
    const auto own = static_cast<Eigen::Index>(cell.alone.size());
    diagonal(places) += sorted.diagonal().tail(sorted.rows() - own);
    try {
      cell.matrix = condense(sorted, own);
    } catch (const SolverError&) {
      return std::nullopt;
    }
    if (!is_safe(cell.matrix.factor.diagonal().cwiseAbs2(), sorted.diagonal().head(own)))
      return std::nullopt;
    const Matrix rest = std::exchange(cell.matrix.outer, Matrix());
    for (Eigen::Index j = 0; j < rest.cols(); ++j)
      for (Eigen::Index i = 0; i < rest.rows(); ++i) {
        const Eigen::Index row = places[static_cast<std::size_t>(i)];
        const Eigen::Index column = places[static_cast<std::size_t>(j)];
        if (row >= column) entries.emplace_back(row, column, rest(std::max(i, j), std::min(i, j)));
      }
  }
  if (parts.shared > 0) {
    Eigen::SparseMatrix<double> sum(parts.shared, parts.shared);
    sum.setFromTriplets(entries.begin(), entries.end());
    parts.solver.compute(sum);
    if (parts.solver.info() != Eigen::Success) return std::nullopt;
    if (!is_safe(parts.solver.vectorD(), parts.solver.permutationP() * diagonal))
      return std::nullopt;
  }
  return CondensedEquations(std::move(made));
}

Matrix CondensedEquations::solve(const Matrix& loads) const {
  const Parts& parts = *parts_;
  Matrix forces = Matrix::Zero(parts.shared, loads.cols());
  for (std::size_t i = 0; i < parts.number.size(); ++i)
    if (parts.number[i] >= 0) forces.row(parts.number[i]) = loads.row(static_cast<Eigen::Index>(i));
  std::vector<Matrix> own;  // L^-1 f of the unknowns of each element alone
  for (const Inner& cell : parts.inner) {
    Matrix& f = own.emplace_back(loads(cell.alone, Eigen::all));
    cell.matrix.factor.triangularView<Eigen::Lower>().solveInPlace(f);
    forces(parts.places(cell), Eigen::all) -= cell.matrix.coupling.transpose() * f;
  }
  Matrix x = Matrix::Zero(parts.unknowns, loads.cols());
  if (parts.shared > 0) {
    const Matrix found = parts.solver.solve(forces);
    for (std::size_t i = 0; i < parts.number.size(); ++i)
      if (parts.number[i] >= 0) x.row(static_cast<Eigen::Index>(i)) = found.row(parts.number[i]);
  }
  for (std::size_t e = 0; e < parts.inner.size(); ++e) {
    const Inner& cell = parts.inner[e];
    if (cell.alone.empty()) continue;
    Matrix rest = own[e] - cell.matrix.coupling * x(cell.shared, Eigen::all);
    cell.matrix.factor.triangularView<Eigen::Lower>().transpose().solveInPlace(rest);
    x(cell.alone, Eigen::all) = rest;
  }
  return x;
}

std::optional<Matrix> solve_condensed(const std::vector<std::vector<Eigen::Index>>& elements,
                                      const std::function<Matrix(std::size_t)>& matrix,
                                      const Matrix& loads) {
  const auto equations = CondensedEquations::factor(elements, matrix, loads.rows());
  if (!equations) return std::nullopt;
  return equations->solve(loads);
}

}  // namespace strainwave::fem
