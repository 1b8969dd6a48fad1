// SPDX-License-Identifier: Apache-2.0
#include "row.hpp"

namespace strainwave::sif {

std::vector<Row> tube_rows() { return {}; }

}  // namespace strainwave::sif
