// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace strainwave {

/// The text of data/through_crack.txt.
[[nodiscard]] std::string through_crack_data();

}  // namespace strainwave
