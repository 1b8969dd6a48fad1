// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "given.hpp"

namespace strainwave::cli {

/// The files of a command line, each with the argument that names it.
class KnownFiles {
 public:
  /// @param inputs  the files of the drives
  /// @throws UsageError  if an output has no name, or would be written twice, or would overwrite an
  ///                     input
  KnownFiles(const Given& given, const std::vector<std::string>& inputs);

  /// @throws UsageError  if an output would overwrite a table that the drive names
  void add_tables_of(const Drive& drive, const std::string& file);
  /// @throws UsageError  if the file is also an input
  void require_not_read(const std::string& name, const std::string& path) const;

 private:
  void add_input(const std::string& name, const std::string& path);
  void add_output(const std::string& name, const std::string& path);
  void require_free(const std::string& name, const std::string& path);

  std::vector<std::pair<std::string, std::string>> outputs_;  // argument, path
  std::map<std::string, std::string> inputs_;                 // argument by identity
  std::map<std::string, std::string> written_;
  std::string to_standard_output_;
};

}  // namespace strainwave::cli
