// SPDX-License-Identifier: Apache-2.0
// HDF5 files of a program that was built without HDF5.
#include <fmt/format.h>

#include "hdf5_rows.hpp"

namespace strainwave {

std::unique_ptr<RowFile> hdf5_row_file(const std::string& path) {
  throw InputError("--rows",
                   fmt::format("{} needs HDF5, which is not part of this program; install "
                               "libhdf5-dev and build with cmake -D STRAINWAVE_HDF5=ON, or name a "
                               "file that ends in .csv",
                               shown(path)));
}

}  // namespace strainwave
