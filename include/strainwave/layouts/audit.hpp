// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "strainwave/audit/audit.hpp"

namespace strainwave {

/// The rows as a table for a terminal, each followed by its verdict and reason.
[[nodiscard]] std::string audit_text(std::span<const AuditRow> rows);

/// The rows as a table of the theory manual.
[[nodiscard]] std::string audit_markdown(std::span<const AuditRow> rows);

}  // namespace strainwave
