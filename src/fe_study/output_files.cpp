// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/output_files.hpp"

#include <fmt/format.h>

#include <cctype>
#include <fstream>
#include <system_error>

#include "strainwave/core/error.hpp"

namespace strainwave::fe_study {

namespace fs = std::filesystem;

std::string file_stem(const std::string& path) {
  std::string stem;
  for (const char c : path)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      stem += c;
    else if (c != ']')
      stem += '_';
  return stem;
}

void write_files(const fs::path& folder, const std::vector<OutputFile>& files,
                 const fem::MpiSession& session) {
  std::error_code fault;
  bool made = false;
  std::string problem;
  if (session.rank() == 0) {
    made = fs::create_directories(folder, fault);
    std::error_code unseen;
    if (!fs::is_directory(folder, unseen))
      problem = fmt::format("{}: no folder of this name can be made", folder.string());
  }
  const auto part = [&](const OutputFile& file) { return folder / (file.name + ".part"); };
  const bool ready = session.all(problem.empty());
  if (ready)
    for (const OutputFile& file : files) {
      std::ofstream stream(part(file), std::ios::binary);
      stream.write(file.text.data(), static_cast<std::streamsize>(file.text.size()));
      stream.close();
      if (!stream) {
        problem = fmt::format("{}: cannot be written", (folder / file.name).string());
        break;
      }
    }
  if (session.all(problem.empty()))
    for (const OutputFile& file : files) {
      fs::rename(part(file), folder / file.name, fault);
      if (fault) {
        problem = fmt::format("{}: {}", (folder / file.name).string(), fault.message());
        break;
      }
    }
  if (session.all(problem.empty())) return;
  for (const OutputFile& file : files) fs::remove(part(file), fault);
  (void)session.all(true);  // the others have taken theirs back
  if (made) fs::remove(folder, fault);
  throw Error(problem.empty() ? folder.string() + ": another rank cannot write there" : problem);
}

}  // namespace strainwave::fe_study
