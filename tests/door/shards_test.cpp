// SPDX-License-Identifier: Apache-2.0
// Studies that several processes compute in shares.
#include "strainwave/command/shards.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "door/answers.hpp"
#include "strainwave/core/error.hpp"
#include "support/expect.hpp"
#include "support/kept_rows.hpp"

namespace strainwave {
namespace {

using Shards = std::vector<std::pair<std::string, Shard>>;

/// A study of an example.
struct Study {
  std::string command;
  std::string example;  ///< empty: the command takes no drive
  std::vector<std::pair<std::string, std::string>> options;

  [[nodiscard]] const Command& row() const { return command_named(commands(), command); }
  [[nodiscard]] std::shared_ptr<const Drive> drive() const {
    return example.empty() ? nullptr : test::example_drives().at(example);
  }
  [[nodiscard]] OptionValues values() const {
    OptionValues values(row().options);
    for (const auto& [name, text] : options) values.set(name, text);
    return values;
  }
  [[nodiscard]] Shard shard(const Share& share) const {
    const OptionValues set = values();
    return computed_shard(row(), drive(), set, shared_study(row(), drive().get(), {}, set, {}),
                          share);
  }
};

std::vector<Study> studies() {
  return {
      {"sweep", "article", {{"vary", "output_shaft.crack[0].depth=0.05 mm..20 mm:9"}}},
      {"sweep",
       "cracked_size25",
       {{"vary", "load.torque=10 N*m..40 N*m:2"}, {"vary", "mesh.friction_coefficient=0..0.1:3"}}},
      {"sensitivity", "article_scatter", {{"scatter", "true"}, {"samples", "500"}}},
      {"sensitivity", "article_scatter", {{"sobol", "true"}, {"points", "64"}, {"seed", "7"}}},
      {"torsion", "catalogue_size25", {{"draws", "4"}}},
      {"torsion", "cracked_size25", {{"compare", "true"}, {"angles", "4"}, {"draws", "0"}}},
      {"torsion", "catalogue_size25", {{"tolerances", "3"}, {"draws", "0"}}},
      {"validate", "", {{"draws", "2"}}},
      {"inspect",
       "inspected_shaft",
       {{"draws", "40"}, {"a50", "1 mm"}, {"a90", "2 mm"}, {"every", "100 h"}}},
  };
}

// Kind: identity.  The merged answer has the bytes of one run, in every document, for any division
// and order of the shards, which pass through their files.  Both have the same rows, bit for bit,
// and without rows the answer is the same.
TEST(Shards, IdentityWithOneRun) {
  for (const Study& study : studies()) {
    test::KeptRows of_whole;
    const Answer whole =
        run(study.row(), study.drive(), study.values(), {}, {}, {.rows = &of_whole});
    const int parts = study.command == "validate" ? 2 : 3;
    Shards shards;
    for (int part = parts; part >= 1; --part) {
      const std::string name = fmt::format("{}.shard", part);
      shards.emplace_back(name, parse_shard(shard_text(study.shard({part, parts})), name));
    }
    test::KeptRows of_merged;
    const Answer answer = merged(commands(), shards, {}, {.rows = &of_merged});
    EXPECT_EQ(answer.json(), whole.json()) << study.command;
    EXPECT_GT(of_whole.head.rows, 0U) << study.command;
    EXPECT_EQ(of_whole.numbers.size(), of_whole.head.rows) << study.command;
    EXPECT_TRUE(test::same_rows(of_merged, of_whole)) << study.command;
    for (const Document& document : study.row().documents)
      EXPECT_EQ(answer.document(document.name), whole.document(document.name))
          << study.command << ' ' << document.name;
    if (study.command != "validate") {
      EXPECT_EQ(run(study.row(), study.drive(), study.values()).json(), whole.json());
    }
  }
}

/// The commands, and none of them has rows.
std::span<const Command> commands_without_rows() {
  static const std::vector<Command> table = [] {
    std::vector<Command> without(commands().begin(), commands().end());
    for (Command& command : without) command.rows = {};
    return without;
  }();
  return table;
}

// Kind: input.  Rows of a study that has none are refused before the shards are merged, and before
// the second one is read.
TEST(Shards, InputRowsOfAStudyWithoutRows) {
  const Study study = studies().front();
  const Shards shards = {{"1.shard", study.shard({1, 2})}, {"2.shard", study.shard({2, 2})}};
  constexpr const char* kRefusal =
      "rows: cannot be written, because the study of sweep has none; merge its shards without "
      "--rows";
  test::KeptRows rows;
  const Host host{.rows = &rows};
  EXPECT_EQ(test::broken_rule([&] { (void)merged(commands_without_rows(), shards, {}, host); }),
            kRefusal);
  const Command merge = merge_command(commands_without_rows);
  OptionValues values(merge.options);
  values.set("shards", "1.shard");
  values.set("shards", "not_there.shard");
  const OptionTexts texts = {{"1.shard", shard_text(shards[0].second)}};
  EXPECT_EQ(test::broken_rule([&] { (void)run(merge, nullptr, values, texts, {}, host); }),
            kRefusal);
  EXPECT_EQ(rows.origins, 0);
  EXPECT_NO_THROW((void)merged(commands_without_rows(), shards));
}

// Kind: behaviour.  Every command that says that it shares its study is in the list above.
TEST(Shards, BehaviourEverySharedStudyIsTried) {
  for (const Command& command : commands())
    EXPECT_EQ(!command.shares.empty(), std::ranges::any_of(studies(), [&](const Study& s) {
      return s.command == command.name;
    })) << command.name;
}

std::string shard_refusal(const auto& call) { return test::broken_rule(call); }

TEST(Shards, InputSharesAreRefused) {
  const auto refusal = [](const std::string& text) {
    return shard_refusal([&] { return parse_share(text); });
  };
  EXPECT_EQ(parse_share("3/16"), (Share{3, 16}));
  for (const char* const text : {"", "3", "3/", "/16", "a/b", "3/16 ", "3.5/16", "3//16", " 3/16"})
    EXPECT_NE(refusal(text).find("it must be a share such as 3/16"), std::string::npos) << text;
  for (const char* const text : {"0/3", "4/3", "-1/3", "1/0", "1/100001"})
    EXPECT_NE(refusal(text).find("must be from 1 to the second"), std::string::npos) << text;
}

TEST(Shards, InputStudiesWithoutSharesAreRefused) {
  const auto refusal = [](const Study& study) {
    return shard_refusal([&] { return study.shard({1, 2}); });
  };
  EXPECT_EQ(refusal({"stiffness", "article", {}}), "shard: is not known to stiffness");
  EXPECT_EQ(refusal({"sensitivity", "article_scatter", {}}),
            "shard: needs either --scatter or --sobol; give one of them");
  EXPECT_EQ(refusal({"sensitivity", "article_scatter", {{"scatter", "true"}, {"sobol", "true"}}}),
            "shard: needs either --scatter or --sobol; give one of them");
  EXPECT_EQ(refusal({"torsion", "catalogue_size25", {{"draws", "0"}}}),
            "shard: divides draws of --tolerances, else positions of --compare, else draws of the "
            "ranges, and there are none with these options");
}

/// Three shards of a small study, and what `merged` says of them after a change.
class OtherShards : public testing::Test {
 protected:
  static Study study() {
    return {
        "sensitivity", "article_scatter", {{"scatter", "true"}, {"samples", "12"}, {"seed", "3"}}};
  }
  static Shards three() {
    Shards shards;
    for (int part = 1; part <= 3; ++part)
      shards.emplace_back(fmt::format("{}.shard", part), study().shard({part, 3}));
    return shards;
  }
  static std::string refusal(const auto& change) {
    Shards shards = three();
    change(shards);
    return shard_refusal([&] { return merged(commands(), shards); });
  }
};

TEST_F(OtherShards, InputMissingAndRepeatedSharesAreNamed) {
  EXPECT_EQ(refusal([](Shards& s) { s.clear(); }),
            "shards: must be given; name the files of all shards");
  EXPECT_EQ(refusal([](Shards& s) { s.erase(s.begin() + 1); }),
            "shards: 2 of 3 are missing; compute them with --shard 2/3 and so on");
  EXPECT_EQ(refusal([](Shards& s) { s[2].second = s[0].second; }),
            "3.shard: is share 1/3, and so is 1.shard; give each share once");
  EXPECT_EQ(refusal([](Shards& s) {
              s[1].second = study().shard({1, 4});
            }),
            "2.shard: is share 1/4, but 1.shard is share 1/3; merge the shares of one division");
  EXPECT_EQ(refusal([](Shards& s) {
              s = {{"a.shard", study().shard({1, 12})}};
            }),
            "shards: 2, 3, 4, 5, 6, 7, 8, 9 of 12 are missing, and 3 more; compute them with "
            "--shard 2/12 and so on");
}

TEST_F(OtherShards, InputShardsOfOtherStudiesAreRefusedByName) {
  const std::string begin = "2.shard: is a shard of another study than 1.shard: ";
  const auto changed = [&](const auto& change) {
    return refusal([&](Shards& s) { change(s[1].second.study); });
  };
  EXPECT_EQ(changed([](SharedStudy& s) { s.version = "0.0.1"; }),
            begin + fmt::format("the version is {} in one and 0.0.1 in the other",
                                three()[0].second.study.version));
  EXPECT_EQ(changed([](SharedStudy& s) { s.command = "sweep"; }),
            begin + "the command is sensitivity in one and sweep in the other");
  EXPECT_EQ(changed([](SharedStudy& s) { s.drive_name = "b.toml"; }),
            begin + "the name of the drive is article_scatter.toml in one and b.toml in the other");
  EXPECT_EQ(changed([](SharedStudy& s) { s.drive_text += "\n"; }),
            begin + "the text of the drive differs");
  EXPECT_EQ(changed([](SharedStudy& s) { s.attachments["a.csv"] = "x"; }),
            begin + "a file that the drive names differs");
  EXPECT_EQ(changed([](SharedStudy& s) { s.texts["a.csv"] = "x"; }),
            begin + "a file that an option names differs");
  EXPECT_EQ(changed([](SharedStudy& s) { s.options[2].second = "4"; }),
            begin + "the option seed is 3 in one and 4 in the other");
  EXPECT_EQ(changed([](SharedStudy& s) { s.options.pop_back(); }),
            begin + "the option seed is 3 in one and left out in the other");
  EXPECT_EQ(changed([](SharedStudy& s) { std::swap(s.options[0], s.options[1]); }),
            begin + "the options have another order");
  EXPECT_NE(changed([](SharedStudy& s) { s.code_path = "other"; }).find("the code path is "),
            std::string::npos);
  EXPECT_EQ(refusal([](Shards& s) { s[1].second.rows = 13; }),
            "2.shard: is a shard of 13 rows, but 1.shard of 12");
  const std::string other = refusal([](Shards& s) {
    for (auto& [name, shard] : s) shard.study.code_path = "PDP-11";
  });
  EXPECT_NE(other.find("1.shard: has the code path PDP-11, and this program has "),
            std::string::npos)
      << other;
}

// Kind: behaviour.  The number of threads may differ between machines, because no answer depends on
// it.
TEST_F(OtherShards, BehaviourThreadsMayDiffer) {
  Shards shards = three();
  Study threaded = study();
  threaded.options.emplace_back("threads", "2");
  shards[1].second = threaded.shard({2, 3});
  EXPECT_EQ(merged(commands(), shards).json(),
            run(study().row(), study().drive(), study().values()).json());
}

TEST_F(OtherShards, InputDamagedFilesAreRefused) {
  const std::string text = shard_text(three()[0].second);
  const auto refusal = [](const std::string& damaged) {
    return shard_refusal([&] { return parse_shard(damaged, "a.shard"); });
  };
  EXPECT_TRUE(begins_as_shard(text));
  EXPECT_FALSE(begins_as_shard("format = 1\n"));
  EXPECT_EQ(refusal("format = 1\n"),
            "a.shard: is not a shard; its first line must be strainwave-shard/1");
  EXPECT_EQ(refusal(""), "a.shard: is not a shard; its first line must be strainwave-shard/1");
  const std::string damaged = "a.shard: is a damaged shard; compute it again";
  EXPECT_EQ(refusal("strainwave-shard/1"), damaged);
  EXPECT_EQ(refusal("strainwave-shard/1\n{}\n"), damaged);
  for (const std::size_t at : {std::size_t{30}, text.size() / 2}) {  // the digest, and the drive
    std::string changed = text;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    EXPECT_EQ(refusal(changed), damaged) << at;
  }
  EXPECT_EQ(refusal(text.substr(0, text.size() - 1)), damaged);
  EXPECT_EQ(refusal(text.substr(0, 200)), damaged);
  EXPECT_EQ(refusal(text + "x"), damaged);
  std::string flipped = text;
  flipped.back() = static_cast<char>(flipped.back() ^ 1);
  EXPECT_EQ(refusal(flipped), damaged);
  Shard none = three()[0].second;
  none.share = {0, 3};
  EXPECT_EQ(refusal(shard_text(none)), damaged);
}

// Kind: input.  A file that is no shard may be larger than the memory, so its beginning decides.
TEST_F(OtherShards, InputAnotherLargeFileIsNotReadToItsEnd) {
  int pieces = 0;
  Host host;
  host.open = [&](const std::string&) -> TextPieces {
    return [&](std::span<char> to) {
      ++pieces;
      std::ranges::fill(to, 'x');
      return to.size();
    };
  };
  const Command merge = merge_command(commands);
  OptionValues values(merge.options);
  values.set("shards", "rows.h5");
  EXPECT_EQ(test::broken_rule([&] { (void)run(merge, nullptr, values, {}, {}, host); }),
            "rows.h5: is not a shard; its first line must be strainwave-shard/1");
  EXPECT_LE(pieces, 2);
}

// Kind: identity.  A file keeps every byte of the texts, those that are no UTF-8 too.
TEST_F(OtherShards, IdentityOfAFile) {
  Shard shard = three()[1].second;
  shard.study.attachments["table \xFF.csv"] = std::string("\xE9\0\n# caf\xE9", 9);
  shard.study.texts["b"] = "\x80";
  const Shard read = parse_shard(shard_text(shard), "a.shard");
  EXPECT_EQ(read.study.attachments, shard.study.attachments);
  EXPECT_EQ(read.study.texts, shard.study.texts);
  EXPECT_EQ(difference(read.study, shard.study), "");
  EXPECT_EQ(read.bytes, shard.bytes);
  EXPECT_EQ(read.share, shard.share);
  EXPECT_EQ(read.rows, shard.rows);
}

// Kind: behaviour.  Rows of another form, whose digest is right, are refused.
TEST_F(OtherShards, InputRowsOfAnotherForm) {
  EXPECT_EQ(refusal([](Shards& s) { s[1].second.bytes.resize(8); }),
            "shards: have rows of another form than this program; compute all again");
}

}  // namespace
}  // namespace strainwave
