// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/output_files.hpp"

#include <cctype>

namespace strainwave::fe_study {

std::string file_stem(const std::string& path) {
  std::string stem;
  for (const char c : path)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      stem += c;
    else if (c != ']')
      stem += '_';
  return stem;
}

}  // namespace strainwave::fe_study
