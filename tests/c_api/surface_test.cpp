// SPDX-License-Identifier: Apache-2.0 The names that a user of the library or of the program can
// use: commands, options, result fields, documents.

#include "command/surface.hpp"

#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

TEST(Surface, RegressionCommandsOptionsDocumentsAndResultFields) {
  test::expect_listed(commands(), "public_surface.txt");
}

}  // namespace
}  // namespace strainwave
