// SPDX-License-Identifier: Apache-2.0
#include "condensed_solver.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>

namespace strainwave::fem {
namespace {

using Eigen::Index;
using Matrix = Eigen::MatrixXd;
using Column = Eigen::VectorXd;

/// The parts of an element from which its own unknowns are recovered.
struct Inner {
  std::vector<Index> alone;   ///< numbers of the unknowns that belong to this element alone
  std::vector<Index> shared;  ///< numbers of the other unknowns
  Eigen::LLT<Matrix> factor;
  Matrix coupling;  ///< rows: alone, columns: shared
};

/// True if no pivot vanishes in rounding.
bool is_safe(const Column& pivots, const Column& diagonal) {
  return (pivots.array() > kLeastPivot * diagonal.array()).all();
}

}  // namespace

std::optional<Column> solve_condensed(const std::vector<std::vector<Index>>& elements,
                                      const std::function<Matrix(std::size_t)>& matrix,
                                      const Column& load) {
  std::vector<int> holders(static_cast<std::size_t>(load.size()), 0);
  for (const auto& element : elements)
    for (const Index i : element) ++holders[static_cast<std::size_t>(i)];
  std::vector<Index> number(holders.size(), -1);  // index in the sparse equations
  Index shared = 0;
  for (std::size_t i = 0; i < holders.size(); ++i)
    if (holders[i] > 1) number[i] = shared++;

  std::vector<Inner> inner;
  std::vector<Eigen::Triplet<double>> entries;
  std::size_t count = 0;
  for (const auto& element : elements) count += element.size() * (element.size() + 1) / 2;
  entries.reserve(count);
  Column forces = Column::Zero(shared);
  Column diagonal = forces;
  for (std::size_t i = 0; i < holders.size(); ++i)
    if (number[i] >= 0) forces(number[i]) = load(static_cast<Index>(i));
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const Matrix k = matrix(e).selfadjointView<Eigen::Lower>();
    std::vector<Index> inside;  // indices in the element
    std::vector<Index> outside;
    Inner& cell = inner.emplace_back();
    for (Index i = 0; i < k.rows(); ++i) {
      const Index unknown = elements[e][static_cast<std::size_t>(i)];
      const bool alone = number[static_cast<std::size_t>(unknown)] < 0;
      (alone ? inside : outside).push_back(i);
      (alone ? cell.alone : cell.shared).push_back(unknown);
    }
    Matrix rest = k(outside, outside);
    std::vector<Index> places;
    for (const Index i : cell.shared) places.push_back(number[static_cast<std::size_t>(i)]);
    diagonal(places) += rest.diagonal();
    if (!inside.empty()) {
      cell.factor.compute(k(inside, inside));
      if (cell.factor.info() != Eigen::Success ||
          !is_safe(cell.factor.matrixLLT().diagonal().cwiseAbs2(), k.diagonal()(inside)))
        return std::nullopt;
      cell.coupling = k(inside, outside);
      const Matrix half = cell.factor.matrixL().solve(cell.coupling);
      rest.noalias() -= half.transpose() * half;
      const Column own = load(cell.alone);
      forces(places) -= half.transpose() * cell.factor.matrixL().solve(own);
    }
    for (Index j = 0; j < rest.cols(); ++j)
      for (Index i = 0; i < rest.rows(); ++i) {
        const Index row = places[static_cast<std::size_t>(i)];
        const Index column = places[static_cast<std::size_t>(j)];
        if (row >= column) entries.emplace_back(row, column, rest(i, j));
      }
  }

  Column x = Column::Zero(load.size());
  if (shared > 0) {
    Eigen::SparseMatrix<double> sum(shared, shared);
    sum.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(sum);
    if (solver.info() != Eigen::Success) return std::nullopt;
    if (!is_safe(solver.vectorD(), solver.permutationP() * diagonal)) return std::nullopt;
    const Column found = solver.solve(forces);
    for (std::size_t i = 0; i < number.size(); ++i)
      if (number[i] >= 0) x(static_cast<Index>(i)) = found(number[i]);
  }
  for (const Inner& cell : inner) {
    if (cell.alone.empty()) continue;
    const Column rest = load(cell.alone) - cell.coupling * x(cell.shared);
    const Column found = cell.factor.solve(rest);
    x(cell.alone) = found;
  }
  return x;
}

}  // namespace strainwave::fem
