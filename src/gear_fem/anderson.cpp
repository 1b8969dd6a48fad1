// SPDX-License-Identifier: Apache-2.0
#include "anderson.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace strainwave::gear_fem {
namespace {

using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

Vector difference(const Vector& a, const Vector& b) {
  Vector result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] - b[i];
  return result;
}

/// Subtracts a multiple of b from a.
void subtract(Vector& a, double factor, const Vector& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= factor * b[i];
}

}  // namespace

Vector Anderson::next(const Vector& x, const Vector& g) {
  constexpr double kDependent = 1e-8;  // remainder of a change that adds nothing new
  Vector residual = difference(g, x);
  if (!residual_.empty()) {
    steps_.push_front({difference(residual, residual_), difference(g, answer_)});
    if (steps_.size() > depth_) steps_.pop_back();
  }
  residual_ = residual;
  answer_ = g;

  // Remove from the residual, by Gram and Schmidt, what the earlier changes can cancel.
  Vector result = g;
  std::vector<Step> basis;
  for (const Step& step : steps_) {
    Step change = step;
    const double size = std::sqrt(dot(change.residual, change.residual));
    for (const Step& of : basis) {
      const double along = dot(change.residual, of.residual);
      subtract(change.residual, along, of.residual);
      subtract(change.answer, along, of.answer);
    }
    const double rest = std::sqrt(dot(change.residual, change.residual));
    if (!(rest > kDependent * size)) continue;
    for (double& value : change.residual) value /= rest;
    for (double& value : change.answer) value /= rest;
    const double along = dot(residual, change.residual);
    subtract(residual, along, change.residual);
    subtract(result, along, change.answer);
    basis.push_back(std::move(change));
  }
  return result;
}

}  // namespace strainwave::gear_fem
