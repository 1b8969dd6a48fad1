// SPDX-License-Identifier: Apache-2.0 `strainwave fe tabulate` seen from outside, and its refusals
// if the memory does not suffice.
#include "strainwave/fe_study/tabulate.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "along_front.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/fe_study/memory.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "support/mpi.hpp"

namespace strainwave {
namespace {

// Kind: reference (FE-23).  The mean along segments of a front on which K is a parabola: 1, 4, 1 at
// the ends and the middle has the mean 3; 1 + s^2 over two segments of unlike length that of its
// integral.
TEST(AlongFront, ReferenceParabolas) {
  const auto front = [](const std::vector<std::pair<double, double>>& values) {
    fem::CrackFront made;
    for (const auto& [position, K] : values) {
      made.stations.emplace_back();
      made.stations.back().position = position;
      made.stations.back().K_I = K;
    }
    return fe_study::along(made, [](const fem::FrontStation& s) { return s.K_I; });
  };
  const fe_study::AlongFront one = front({{0, 1}, {0.5, 4}, {1, 1}});
  EXPECT_NEAR(one.mean, 3, 1e-14);
  EXPECT_EQ(one.least, 1);
  EXPECT_EQ(one.largest, 4);
  const auto f = [](double s) { return std::pair(s, 1 + s * s); };
  EXPECT_NEAR(front({f(0), f(0.5), f(1), f(2), f(3)}).mean, 1 + 9.0 / 3, 1e-14);
}

class FeTable : public testing::Test {
 protected:
  struct Ended {
    int exit_code = -1;
    std::string out;
    std::string err;
  };

  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() / ("strainwave table " + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }

  [[nodiscard]] Ended shell(const std::string& command) const {
    const std::string all = "(" + command + ") >'" + path("out") + "' 2>'" + path("err") + "'";
    const int status = std::system(all.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(path("out")),
            text_of(path("err"))};
  }
  /// `strainwave-fe tabulate` of an example, with its table in the folder.
  [[nodiscard]] Ended tabulate(const std::string& example, const std::string& options,
                               const std::string& before = "") const {
    return shell(before + "'" STRAINWAVE_FE "' tabulate '" + example + "' " + options);
  }
  [[nodiscard]] Ended shaft(const std::string& options) const {
    return tabulate(STRAINWAVE_EXAMPLES "/solid_shaft.toml", kDepth + options);
  }
  [[nodiscard]] std::string to(const std::string& name) const {
    return " -o '" + path(name) + "' ";
  }

  /// An example with texts replaced by others.
  std::string changed(const std::string& example,
                      const std::vector<std::array<std::string, 2>>& changes) {
    std::string text = text_of(std::filesystem::path(STRAINWAVE_EXAMPLES) / example);
    for (const auto& [from, by] : changes) {
      const std::size_t at = text.find(from);
      EXPECT_NE(at, std::string::npos) << from;
      text.replace(at, from.size(), by);
    }
    std::ofstream(folder_ / "changed.toml") << text;
    return path("changed.toml");
  }

  // Order 4 is enough for the checks of a shaft, and takes a third of a second for each depth.
  static inline const std::string kDepth =
      "--order 4 --over 'output_shaft.crack[0].depth=6 mm..12 mm:4:log' ";
  std::filesystem::path folder_;
};

/// Table lines without their times.
std::vector<std::string> rows_without_seconds(const std::string& table) {
  std::vector<std::string> rows;
  for (const TablePoint& row : parse_table_file(table, "t").rows) {
    TablePoint timeless = row;
    timeless.seconds = 0;
    rows.push_back(table_row_text(timeless));
  }
  return rows;
}

// The whole chain of a family of runs, a drive that names its table, and the stiffness, compared
// with the closed form.  A run that was killed within a line continues.
TEST_F(FeTable, CrosscheckShaftTableFeedsTheStiffness) {
  const Ended made = shaft(to("depth.csv"));
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("4 points, 0 of them not usable"), std::string::npos) << made.out;
  EXPECT_EQ(made.err.find("solutions"), std::string::npos) << "progress only where asked for";
  const std::string table = text_of(path("depth.csv"));
  for (const char* const line :
       {"# kind: annular\n", "# input: solid_shaft.toml\n", "# order: 4\n",
        "# fixed: outer_diameter = 0.06 m\n", "# fixed: inner_diameter = 0 m\n",
        "# fixed: length = 0.3 m\n", "# fixed: youngs_modulus = 210000000000 Pa\n",
        "# fixed: poissons_ratio = 0.3\n", "# equations: FE-3 "})
    EXPECT_NE(table.find(line), std::string::npos) << line << table;

  const auto stiffness = [&](const std::string& more) {
    const Ended ended =
        shell("'" STRAINWAVE_CLI "' stiffness '" +
              changed("solid_shaft.toml", {{"\"9 mm\"", "\"9 mm\"" + more}}) + "' --format json");
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return nlohmann::json::parse(ended.out);
  };
  const auto tabulated = stiffness("\ncompliance_table = \"depth.csv\"");
  const auto closed_form = stiffness("");
  const auto at = [](const nlohmann::json& result, const std::string& pointer) {
    return result.at(nlohmann::json::json_pointer(pointer));
  };
  const std::string torsion = "/result/cracks/0/added_compliance/positive/at_output";
  const double here = at(tabulated, torsion + "/value");
  const double there = at(closed_form, torsion + "/value");
  const double error = at(tabulated, torsion + "/relative_uncertainty");
  EXPECT_LT(error, 0.03);                       // four depths
  EXPECT_NEAR(here / there, 1, error + 0.002);  // (FE-42), and the error of the closed form
  const std::string axial = "/result/cracks/0/added_compliance/positive/axial_axial/value";
  EXPECT_NEAR(at(tabulated, axial).get<double>() / at(closed_form, axial).get<double>(), 1,
              error + 0.005);
  EXPECT_NE(tabulated.dump().find("interpolated from depth.csv (strainwave-fe "),
            std::string::npos);

  // Killed within the last line: the incomplete line is dropped, and the point is computed again.
  std::ofstream(folder_ / "depth.csv", std::ios::binary) << table.substr(0, table.size() - 20);
  const Ended again = shaft(to("depth.csv") + "--progress");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.err.find("dropped an incomplete last line"), std::string::npos) << again.err;
  EXPECT_NE(again.err.find("3 of 4 points are done"), std::string::npos) << again.err;
  EXPECT_NE(again.err.find("output_shaft.crack[0]: torsion and tension, 14 solutions"),
            std::string::npos)
      << again.err;
  EXPECT_EQ(rows_without_seconds(text_of(path("depth.csv"))), rows_without_seconds(table));

  // A different table is refused with the differing line and stays unchanged.
  const std::string now = text_of(path("depth.csv"));
  const auto refused = [&](const Ended& ended, const std::string& words) {
    EXPECT_EQ(ended.exit_code, 3) << words;
    EXPECT_NE(ended.err.find(words), std::string::npos) << ended.err;
    EXPECT_EQ(text_of(path("depth.csv")), now);
  };
  refused(tabulate(
              STRAINWAVE_EXAMPLES "/solid_shaft.toml",
              "--order 5 --over 'output_shaft.crack[0].depth=6 mm..12 mm:4:log'" + to("depth.csv")),
          "the file has \"# order: 4\", but this run has \"# order: 5\"");
  refused(tabulate(
              STRAINWAVE_EXAMPLES "/solid_shaft.toml",
              "--order 4 --over 'output_shaft.crack[0].depth=6 mm..12 mm:5:log'" + to("depth.csv")),
          "4 points");
  refused(
      tabulate(changed("solid_shaft.toml", {{"\"60 mm\"", "\"61 mm\""}}), kDepth + to("depth.csv")),
      "# input: ");
  std::filesystem::create_directories(folder_ / "other");
  std::filesystem::copy_file(path("changed.toml"), folder_ / "other/solid_shaft.toml");
  refused(tabulate(path("other/solid_shaft.toml"), kDepth + to("depth.csv")), "# drive sha256: ");
  std::ofstream(folder_ / "depth.csv", std::ios::binary) << "something else\n";
  EXPECT_EQ(shaft(to("depth.csv")).exit_code, 3);
}

// A refused point becomes a line with the reason; the exit code is 4, now and in the next run.
TEST_F(FeTable, IdentityPointsThatCannotBeUsedAreKept) {
  const std::string over = "--order 4 --over 'output_shaft.crack[0].depth=20 mm..32 mm:2'";
  const std::string example = STRAINWAVE_EXAMPLES "/solid_shaft.toml";
  const Ended ended = tabulate(example, over + to("deep.csv"));
  EXPECT_EQ(ended.exit_code, 4) << ended.err;
  EXPECT_NE(ended.err.find("strainwave-fe: point 2: output_shaft.crack[0].depth"),
            std::string::npos)
      << ended.err;
  const TableFile file = parse_table_file(text_of(path("deep.csv")), "deep.csv");
  ASSERT_EQ(file.rows.size(), 2U);
  EXPECT_TRUE(file.rows[0].usable);
  EXPECT_FALSE(file.rows[1].usable);
  EXPECT_FALSE(file.rows[1].values[0]);
  EXPECT_NE(file.rows[1].reason.find("depth < outer_diameter/2"), std::string::npos);
  EXPECT_EQ(tabulate(example, over + to("deep.csv")).exit_code, 4);
  // Two ranks write the same table, once.
  const Ended two = tabulate(example, over + to("two.csv"),
                             "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                             "OMP_NUM_THREADS=1 mpirun --oversubscribe -n 2 ");
  EXPECT_NE(two.err.find("strainwave-fe: point 2: "), std::string::npos) << two.err;
  EXPECT_EQ(rows_without_seconds(text_of(path("two.csv"))),
            rows_without_seconds(text_of(path("deep.csv"))));
  // The plan of the family reports it in advance.
  const Ended plan = tabulate(example, over + to("plan.csv") + "--dry-run");
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_NE(plan.out.find("1 points of "), std::string::npos) << plan.out;
  EXPECT_NE(plan.out.find("refused: point 2: output_shaft.crack[0].depth"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path("plan.csv")));
}

TEST_F(FeTable, InputFaultsByCode) {
  const std::string wall = STRAINWAVE_EXAMPLES "/through_crack.toml";
  const std::string length = "--over 'flexspline.crack[0].half_length=";
  EXPECT_EQ(tabulate(wall, to("t.csv")).exit_code, 2);
  const Ended bare = tabulate(wall, length + "4..8:3'" + to("t.csv"));
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_NE(bare.err.find("--over flexspline.crack[0].half_length: \"4\" has no unit"),
            std::string::npos)
      << bare.err;
  // A family without any valid point is refused as a whole.
  const Ended nothing = tabulate(wall, length + "70 mm..75 mm:2'" + to("t.csv"));
  EXPECT_EQ(nothing.exit_code, 3);
  EXPECT_NE(nothing.err.find("no point can be computed; point 1: flexspline.crack[0]: half_length"),
            std::string::npos)
      << nothing.err;
  EXPECT_FALSE(std::filesystem::exists(path("t.csv")));
}

// The rules of a family, each broken once, and the numbers in its head.
TEST_F(FeTable, InputFamiliesByName) {
  const std::string wall = STRAINWAVE_EXAMPLES "/through_crack.toml";
  const auto study = [](const std::string& file, const std::vector<std::string>& over,
                        const std::string& crack = "") {
    const GearSet gear = read_gear_set_file(file);
    std::vector<Variation> variations;
    for (const std::string& text : over)
      variations.push_back(parse_variation(gear, text, "--over"));
    fe_study::RunOptions options;
    if (!crack.empty()) options.crack = crack;
    return fe_study::table_study(gear, "file.toml", options, variations);
  };
  const auto refused = [&](const std::string& file, const std::vector<std::string>& over,
                           const std::string& words, const std::string& crack = "") {
    try {
      (void)study(file, over, crack);
      ADD_FAILURE() << "accepted: " << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const std::string size = "flexspline.crack[0].half_length=4 mm..8 mm:3";
  refused(wall, {}, "--over: must be given");
  refused(wall, {"flexspline.size=4 mm..8 mm:3"}, "--over: flexspline.size: is not a number");
  refused(wall, {"load.torque=1 N*m..2 N*m:3"},
          "--over load.torque: does not affect the finite elements of flexspline.crack[0]: "
          "half_length, angle, outer_diameter");
  refused(wall, {size, "flexspline.crack[0].half_length=5 mm..6 mm:3"}, "varies half_length twice");
  refused(wall, {size + "00", "flexspline.length=150 mm..160 mm:1000"}, "more than 100000 points");
  refused(wall, {size},
          "\"flexspline.crack[1]\" is not a crack that a table can describe: "
          "flexspline.crack[0]",
          "flexspline.crack[1]");
  refused(changed("through_crack.toml", {{"poissons_ratio = 0.3", "shear_modulus = \"80 GPa\""}}),
          {"material.steel.youngs_modulus=200 GPa..220 GPa:3"},
          "changes youngs_modulus and poissons_ratio at once");
  refused(changed("through_crack.toml",
                  {{"[[flexspline.crack]]",
                    "[[flexspline.crack]]\nkind = \"through\"\nhalf_length = \"1 mm\"\n\n"
                    "[[flexspline.crack]]"}}),
          {size}, "--crack: must name one crack");
  refused(changed("solid_shaft.toml",
                  {{"[[output_shaft.crack]]\nkind = \"annular\"\ndepth = \"9 mm\"", ""}}),
          {"output_shaft.length=300 mm..310 mm:3"}, "can describe: none");

  // Two numbers, the last running fastest; all others are fixed.
  const fe_study::TableStudy two = study(wall, {size, "flexspline.wall_thickness=1 mm..2 mm:2"});
  ASSERT_EQ(two.points.size(), 6U);
  EXPECT_EQ(two.points[3], (std::vector{6e-3, 2e-3}));
  std::string fixed;
  for (const TableParameter& number : two.head.fixed) fixed += number.name + ' ';
  EXPECT_EQ(fixed, "angle outer_diameter length youngs_modulus poissons_ratio ");
  EXPECT_EQ(two.head.order, 3);
  EXPECT_EQ(two.run.crack, "flexspline.crack[0]");
  // Only numbers that affect the crack change the digest.
  const auto digest = [&](const std::string& from, const std::string& by) {
    return study(changed("through_crack.toml", {{from, by}}), {size}).head.digest;
  };
  const std::string same = study(wall, {size}).head.digest;
  EXPECT_EQ(digest("\"10 mm\"", "\"5 mm\""), same);  // varied
  EXPECT_EQ(digest("[load]", "# remark\n[load]"), same);
  EXPECT_NE(digest("2.24 mm", "2.25 mm"), same);
}

// (FE-44): a run that does not fit into memory is refused before the first solution, with its name
// and both numbers.
TEST_F(FeTable, InputMoreMemoryThanThereIs) {
  const std::string small =
      changed("through_crack.toml", {{"\"10 mm\"", "\"0.1 mm\""}});  // many cells, 110 k unknowns
  const Ended plan =
      shell("ulimit -v 1500000; '" STRAINWAVE_FE "' '" + small + "' --order 4 --dry-run");
  EXPECT_EQ(plan.exit_code, 3) << plan.err;
  EXPECT_NE(plan.out.find("unknowns, 2 solutions"), std::string::npos)
      << "says the size all the same";
  for (const char* const words : {"flexspline.crack[0]: ", " GB of memory, and ", "ulimit -v"})
    EXPECT_NE(plan.err.find(words), std::string::npos) << plan.err;
  const Ended run = shell("ulimit -v 1500000; '" STRAINWAVE_FE "' '" + small + "' --order 4");
  EXPECT_EQ(run.exit_code, 3) << run.err;
  EXPECT_NE(run.err.find(" GB of memory, and "), std::string::npos) << run.err;
}

TEST(FeMemory, InputRuleAtItsBoundary) {
  using fe_study::AvailableMemory;
  using fe_study::RunSize;
  const AvailableMemory here{.machine = {2e9, "a test"}, .process = {}};
  const RunSize fits{.path = "flexspline.crack[0]", .dofs = 50'000, .memory = 2e9, .divided = true};
  RunSize large = fits;
  large.memory = 2.1e9;
  EXPECT_NO_THROW(fe_study::require_memory({fits}, here, 1, 1));
  const auto words = [](const RunSize& size, const AvailableMemory& memory, int some, int all) {
    try {
      fe_study::require_memory({size}, memory, some, all);
    } catch (const fe_study::MemoryRefusal& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(words(large, here, 1, 1),
            "flexspline.crack[0]: 50000 unknowns need about 2.1 GB of memory, and 2 GB are "
            "available (a test)");
  // (FE-44): each of two ranks takes 0.6 of the 1.8 GB above the program's 0.2 GB, each of four
  // ranks 0.4; two machines hold two ranks each.
  EXPECT_DOUBLE_EQ(fe_study::memory_of_rank(fits, 1), 2e9);
  EXPECT_DOUBLE_EQ(fe_study::memory_of_rank(fits, 2), 1.28e9);
  EXPECT_DOUBLE_EQ(fe_study::memory_of_rank(fits, 4), 0.92e9);
  RunSize small = fits;
  small.memory = 1e8;
  EXPECT_EQ(fe_study::memory_of_rank(small, 4), 1e8);
  EXPECT_EQ(words(fits, {.machine = {2.57e9, "a test"}, .process = {}}, 2, 2), "");
  EXPECT_NE(words(fits, {.machine = {2.55e9, "a test"}, .process = {}}, 2, 2), "");
  EXPECT_EQ(words(fits, {.machine = {1.85e9, "a test"}, .process = {}}, 2, 4), "");
  EXPECT_NE(words(fits, {.machine = {1.7e9, "a test"}, .process = {}}, 2, 4)
                .find("1.8 GB of memory on each machine, and 1.7 GB"),
            std::string::npos);
  // The limit of a process is compared with one process.
  EXPECT_EQ(words(fits, {.machine = {9e9, "a test"}, .process = {1.3e9, "ulimit"}}, 4, 2), "");
  EXPECT_NE(words(fits, {.machine = {9e9, "a test"}, .process = {1.2e9, "ulimit"}}, 2, 2)
                .find("1.3 GB of memory in each process, and 1.2 GB are available (ulimit)"),
            std::string::npos);
  // Only the first rank computes a body of revolution.
  const RunSize shaft{.path = "output_shaft.crack[0]", .dofs = 9, .memory = 2e9};
  EXPECT_EQ(words(shaft, here, 4, 4), "");
  EXPECT_NE(words(shaft, {.machine = {1.9e9, "a test"}, .process = {}}, 4, 4), "");
  const AvailableMemory now = fe_study::available_memory();
  EXPECT_GT(now.machine.bytes, 1e8);
  EXPECT_LT(now.machine.bytes, 1e14);
}

// Control groups with made-up files: the least of all levels counts, without pages that can be
// dropped.
TEST(FeMemory, InputControlGroups) {
  using Files = std::map<std::string, std::string>;
  const auto left = [](const Files& files) {
    return fe_study::control_group_memory(
        [&](const std::string& path) -> std::optional<std::string> {
          const auto found = files.find(path);
          if (found == files.end()) return std::nullopt;
          return found->second;
        });
  };
  EXPECT_EQ(left({}).bytes, std::numeric_limits<double>::infinity());
  const std::string job = "/sys/fs/cgroup/slurm/job_7/";
  Files two = {{"/proc/self/cgroup", "0::/slurm/job_7/step\n"},
               {job + "step/memory.max", "max\n"},
               {job + "step/memory.current", "100\n"},
               {job + "memory.max", "4000000000\n"},
               {job + "memory.current", "1000000000\n"}};
  EXPECT_EQ(left(two).bytes, 3e9);
  EXPECT_EQ(left(two).from, "memory.max of the control group");
  two[job + "memory.stat"] = "anon 5\nactive_file 700\ninactive_file 400000000\n";
  EXPECT_EQ(left(two).bytes, 3.4e9);
  two["/sys/fs/cgroup/slurm/memory.max"] = "2000000000\n";  // limit of the parent group
  two["/sys/fs/cgroup/slurm/memory.current"] = "1500000000\n";
  EXPECT_EQ(left(two).bytes, 5e8);
  two[job + "memory.current"] = "5000000000\n";
  EXPECT_EQ(left(two).bytes, 0.0);
  two[job + "memory.max"] = "max\n";
  EXPECT_EQ(left(two).bytes, 5e8);
  // Inside a container, the group is the root.
  EXPECT_EQ(left({{"/proc/self/cgroup", "0::/\n"},
                  {"/sys/fs/cgroup/memory.max", "300\n"},
                  {"/sys/fs/cgroup/memory.current", "100\n"}})
                .bytes,
            200.0);
  const fe_study::MemoryLimit one =
      left({{"/proc/self/cgroup", "12:cpu,cpuacct:/a\n4:memory:/b\n"},
            {"/sys/fs/cgroup/memory/b/memory.limit_in_bytes", "900\n"},
            {"/sys/fs/cgroup/memory/b/memory.usage_in_bytes", "500\n"},
            {"/sys/fs/cgroup/memory/b/memory.stat", "inactive_file 1\ntotal_inactive_file 50\n"}});
  EXPECT_EQ(one.bytes, 450.0);
  EXPECT_EQ(one.from, "memory.limit_in_bytes of the control group");
}

// Points of a table are computed in a tube, as its head states, while a single run of the same
// crack uses the cup.
TEST(FeTableRun, IdentityOfATubeInAnyDrive) {
  test::start_mpi();
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  const std::vector<Variation> over{
      parse_variation(gear, "flexspline.crack[0].half_length=1.9 mm..2 mm:2", "--over")};
  const fe_study::RunOptions options{.crack = "flexspline.crack[0]"};
  const std::size_t cup = fe_study::plan(gear, options).plan.at(0).dofs;
  const auto size =
      fe_study::table_size(fe_study::table_study(gear, "cracked_size25.toml", options, over));
  EXPECT_EQ(size.points, 2U);
  EXPECT_LT(size.largest.dofs, cup * 2 / 3);
}

// Lack of memory ends the run without a row in the table, because the next run may have enough.
TEST(FeMemory, InputEndsATableAndIsNoRow) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/solid_shaft.toml");
  const std::vector<Variation> over{
      parse_variation(gear, "output_shaft.crack[0].depth=20 mm..32 mm:2", "--over")};
  const fe_study::TableStudy study =
      fe_study::table_study(gear, "solid_shaft.toml", {.member = {}, .order = 2}, over);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  std::ifstream status("/proc/self/statm");
  double pages = 0;
  ASSERT_TRUE(status >> pages);
  rlimit little = before;  // 0.1 GB more than it has; the point needs 0.2 GB
  little.rlim_cur = static_cast<rlim_t>(pages * static_cast<double>(getpagesize()) + 1e8);
  ASSERT_EQ(setrlimit(RLIMIT_AS, &little), 0);
  EXPECT_THROW((void)fe_study::table_point(study, 0, test::mpi()), fe_study::MemoryRefusal);
  const TablePoint misfit = fe_study::table_point(study, 1, test::mpi());  // deeper than the shaft
  ASSERT_EQ(setrlimit(RLIMIT_AS, &before), 0);
  EXPECT_FALSE(misfit.usable);
  EXPECT_NE(misfit.reason.find("depth < outer_diameter/2"), std::string::npos) << misfit.reason;
}

// (FE-42) uses the worst check, and at least the error that is known to remain.
TEST(FeTableSize, IdentityText) {
  fe_study::TableSize size;
  size.points = 7;
  size.misfits = {"point 3: too long"};
  size.least_unknowns = 4000;
  size.largest.dofs = 51000;
  size.largest.memory = 5.26e9;
  size.seconds = 120;
  EXPECT_EQ(fe_study::table_size_text(size),
            "Plan, with estimates:\n"
            "  6 points of 4000 to 51000 unknowns, at most 5.3 GB, 1.2e+02 s in all\n"
            "  refused: point 3: too long\n");
}

TEST(FeTableError, IdentityWorstOfTheEvidence) {
  fe_study::TubeCrackRun run;
  run.tube.order = 3;
  run.positive.energy_release_rate = 1;
  run.positive.closed_release_rate = 1e-3;
  run.positive.growth_check = -1e-3;
  run.positive.solid.fronts.resize(2);
  run.negative.closed_release_rate = 1e-3;
  run.negative.growth_check = 0.7;  // for a sense that releases no energy
  EXPECT_EQ(fe_study::table_error(run), 2e-3);
  run.positive.growth_check = -4e-3;
  EXPECT_EQ(fe_study::table_error(run), 4e-3);
  run.positive.solid.fronts[1].ring_spread = 5e-3;
  EXPECT_EQ(fe_study::table_error(run), 5e-3);
  run.tube.order = 2;
  EXPECT_EQ(fe_study::table_error(run), 2e-2);
  run.negative.energy_release_rate = 1e-3;  // counts as zero
  EXPECT_EQ(fe_study::table_error(run), 2e-2);
  run.negative.energy_release_rate = -1;
  EXPECT_EQ(fe_study::table_error(run), 0.7);
  fe_study::ShaftCrackRun shaft;
  shaft.result.torsion.growth_check = 1e-6;
  EXPECT_EQ(fe_study::table_error(shaft), 2e-4);
  shaft.result.tension.growth_check = -3e-4;
  EXPECT_EQ(fe_study::table_error(shaft), 3e-4);
  shaft.result.torsion.tip.ring_spread = 1e-3;
  EXPECT_EQ(fe_study::table_error(shaft), 1e-3);
}

}  // namespace
}  // namespace strainwave
