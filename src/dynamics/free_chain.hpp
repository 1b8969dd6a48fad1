// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <span>
#include <vector>

#include "strainwave/dynamics/torsional_chain.hpp"

namespace strainwave {

/// The matrices of the inertias that are free to turn.
struct FreeChain {
  std::vector<std::size_t> inertia;  ///< index in the chain of each free inertia
  Eigen::VectorXd mass;              ///< J
  Eigen::MatrixXd stiffness;         ///< sum of g g^T/lambda
  Eigen::MatrixXd damping;           ///< sum of c g g^T, and B
  Eigen::MatrixXd twist;             ///< g of each spring as a row
};

/// @throws InputError  as `chain_modes`
[[nodiscard]] FreeChain free_chain(const TorsionalChain& chain, std::span<const std::size_t> held);

/// Throws the error of an infinite response.
[[noreturn]] void refuse_infinite_response();

}  // namespace strainwave
