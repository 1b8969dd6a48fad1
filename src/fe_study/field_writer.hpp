// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "strainwave/core/ranks.hpp"
#include "strainwave/fe_study/output_files.hpp"

namespace strainwave::fe_study {

/// Writes one field of all ranks: one file per rank, and on the first rank the file that lists
/// them.
class FieldWriter {
 public:
  FieldWriter(std::vector<OutputFile>& files, const Ranks& ranks)
      : files_(files), rank_(ranks.rank()), size_(ranks.size()) {}

  /// @param text    makes the document of this rank
  /// @param record  makes the document that lists the files of all ranks
  /// @return  name of the file that readers open
  template <class Text, class Record>
  std::string add(const std::string& stem, const Text& text, const Record& record) {
    if (size_ == 1) {
      files_.push_back({stem + ".vtu", text()});
      return stem + ".vtu";
    }
    const auto piece = [&](int rank) { return fmt::format("{}.{}.vtu", stem, rank); };
    files_.push_back({piece(rank_), text()});
    if (rank_ != 0) return stem + ".pvtu";
    std::vector<std::string> pieces;
    for (int rank = 0; rank < size_; ++rank) pieces.push_back(piece(rank));
    files_.push_back({stem + ".pvtu", record(pieces)});
    return stem + ".pvtu";
  }

 private:
  std::vector<OutputFile>& files_;
  int rank_;
  int size_;
};

}  // namespace strainwave::fe_study
