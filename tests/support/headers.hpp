// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// What nearly all tests include, for the precompiled headers.  No test includes this file.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "strainwave/core/described.hpp"
#include "strainwave/core/error.hpp"
