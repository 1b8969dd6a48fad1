// SPDX-License-Identifier: Apache-2.0
// Files of rows.  tests/cli/rows.py reads the HDF5 files by h5py.
#include "strainwave/row_files/row_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <limits>
#include <string>

#include "support/program.hpp"

namespace strainwave {
namespace {

namespace fs = std::filesystem;

class RowFiles : public test::ProgramTest {
 protected:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  /// Writes as many rows as given, of a head that promises `promised`.
  void write(RowFile& file, std::size_t rows, std::size_t promised) const {
    file.come_from({{"program", "a test"}});
    file.begin({.of = "draws",
                .rows = promised,
                .columns = {{"depth", "m"}, {"stiffness", "N*m/rad"}},
                .seed = 7});
    for (std::size_t n = 0; n < rows; ++n) {
      const bool refused = n % 3 == 1;
      file.add(std::array{0.1 * static_cast<double>(n), refused ? kNone : 1.0 / 3.0},
               refused ? RowStatus::refused : RowStatus::usable,
               refused ? "depth must be < 1 m, or \"less\"" : "");
    }
  }
  [[nodiscard]] std::string path(const std::string& name) const { return in_folder(name).string(); }
};

#ifdef STRAINWAVE_HDF5
constexpr bool kWithHdf5 = true;
#else
constexpr bool kWithHdf5 = false;
#endif

TEST_F(RowFiles, ReferenceTextOfCsv) {
  const auto file = row_file(path("rows.csv"));
  write(*file, 3, 3);
  file->finish();
  EXPECT_FALSE(fs::exists(in_folder("rows.csv")));  // until it replaces the file
  file->replace();
  EXPECT_EQ(test::contents(in_folder("rows.csv")),
            "depth [m],stiffness [N*m/rad],status,rule\n"
            "0,0.3333333333333333,usable,\n"
            "0.1,,refused,\"depth must be < 1 m, or \"\"less\"\"\"\n"
            "0.2,0.3333333333333333,usable,\n");
}

TEST_F(RowFiles, BehaviourAFileThatIsNotFinishedLeavesNothing) {
  for (const std::string name : {"rows.csv", "rows.h5"}) {
    if (name == "rows.h5" && !kWithHdf5) continue;
    {
      const auto file = row_file(path(name));
      write(*file, 2 * kRowsOfChunk, 3 * kRowsOfChunk);
      EXPECT_THROW(file->finish(), Error) << name;  // rows are missing
    }
    EXPECT_TRUE(fs::is_empty(folder_)) << name;
  }
  if (!kWithHdf5) return;
  const auto file = row_file(path("rows.h5"));
  EXPECT_THROW(write(*file, kRowsOfChunk, kRowsOfChunk - 1), Error);  // more than said
}

// The same rows give the same bytes, at ends of chunks too.
TEST_F(RowFiles, IdentityOfTheBytes) {
  if (!kWithHdf5) GTEST_SKIP() << "built without HDF5";
  for (const std::size_t rows : {std::size_t{0}, std::size_t{1}, kRowsOfChunk, kRowsOfChunk + 1}) {
    std::string bytes;
    for (int time = 0; time < 2; ++time) {
      const auto file = row_file(path("rows.h5"));
      write(*file, rows, rows);
      file->finish();
      file->replace();
      std::string made = test::contents(in_folder("rows.h5"));
      EXPECT_EQ(made.substr(1, 3), "HDF");
      if (time == 1) {
        EXPECT_EQ(made, bytes) << rows;
      }
      bytes = std::move(made);
    }
  }
}

// No number of different rules takes more memory than the rules that the file can name.
TEST_F(RowFiles, LimitOfTheRules) {
  if (!kWithHdf5) GTEST_SKIP() << "built without HDF5";
  const auto file = row_file(path("rows.h5"));
  file->begin({.of = "draws", .rows = kMostRules + 100, .columns = {}});
  for (std::size_t n = 0; n < kMostRules + 100; ++n)
    file->add({}, RowStatus::refused, std::to_string(n));
  file->finish();
  file->replace();
  EXPECT_NE(test::contents(in_folder("rows.h5")).find("another rule"), std::string::npos);
}

// A path may contain a slash, because a material may be called "AISI 4340/A"; in the name of a
// dataset it would mean a group.
TEST_F(RowFiles, BehaviourSlashInAName) {
  if (!kWithHdf5) GTEST_SKIP() << "built without HDF5";
  const auto file = row_file(path("rows.h5"));
  file->begin({.of = "draws",
               .rows = 1,
               .columns = {{"material.4340/A.youngs_modulus", "Pa"}, {"material.4340", "Pa"}}});
  file->add(std::array{2e11, 1e11}, RowStatus::usable, {});
  file->finish();
  file->replace();
  const std::string made = test::contents(in_folder("rows.h5"));
  EXPECT_NE(made.find("material.4340%2FA.youngs_modulus"), std::string::npos);
  EXPECT_NE(made.find("material.4340/A.youngs_modulus"), std::string::npos);  // in `columns`
}

TEST_F(RowFiles, InputNames) {
  const auto refused = [&](const std::string& name) -> std::string {
    try {
      (void)row_file(path(name));
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(refused("rows.txt").find("must end in .h5 or .csv, which chooses HDF5 or CSV"),
            std::string::npos);
  EXPECT_NE(refused("h5").find("must end in"), std::string::npos);
  if (!kWithHdf5) {
    EXPECT_NE(refused("rows.h5").find("needs HDF5, which is not part of this program; install "
                                      "libhdf5-dev and build with cmake -D STRAINWAVE_HDF5=ON, or "
                                      "name a file that ends in .csv"),
              std::string::npos);
  }
  EXPECT_THROW((void)row_file(path("none/rows.csv")), Error);
}

}  // namespace
}  // namespace strainwave
