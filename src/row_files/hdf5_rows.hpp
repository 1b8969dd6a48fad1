// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "strainwave/row_files/row_file.hpp"

namespace strainwave {

/// An HDF5 file of rows.
/// @throws InputError  if HDF5 is not part of this program
[[nodiscard]] std::unique_ptr<RowFile> hdf5_row_file(const std::string& path);

}  // namespace strainwave
