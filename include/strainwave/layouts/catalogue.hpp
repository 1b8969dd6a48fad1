// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/catalogue/catalogue.hpp"

namespace strainwave {

/// Stiffness and ratings as two tables, with sources.
[[nodiscard]] std::string catalogue_text(const CatalogueRows& rows);
/// The stiffness rows as CSV.
[[nodiscard]] std::string catalogue_csv(const CatalogueRows& rows);

}  // namespace strainwave
