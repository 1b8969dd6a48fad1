// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/shared_rows.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/records.hpp"

namespace strainwave {
namespace {

enum class TriedFate { good, bad };

struct TriedPart {
  std::string name;
  std::optional<double> value;
  friend bool operator==(const TriedPart&, const TriedPart&) = default;
};

struct TriedRow {
  double number = 0.0;
  int whole = 0;
  bool flag = false;
  TriedFate fate = TriedFate::good;
  std::string text;
  std::array<double, 2> pair{};
  std::vector<TriedPart> parts;
  friend bool operator==(const TriedRow&, const TriedRow&) = default;
};

template <class Archive>
void archive(Archive& to, TriedPart& part) {
  to(part.name, part.value);
}
template <class Archive>
void archive(Archive& to, TriedRow& row) {
  to(row.number, row.whole, row.flag, row.fate, row.text, row.pair, row.parts);
}

TriedRow tried_row(std::size_t n) {
  const auto x = static_cast<double>(n);
  TriedRow row{.number = std::sqrt(x) / 3,
               .whole = -static_cast<int>(n),
               .flag = n % 2 == 0,
               .fate = n % 3 == 0 ? TriedFate::bad : TriedFate::good,
               .text = std::string(n, '\n'),
               .pair = {-0.0, std::numeric_limits<double>::infinity()},
               .parts = {}};
  for (std::size_t i = 0; i < n % 4; ++i)
    row.parts.push_back({std::to_string(i), i % 2 == 0 ? std::optional(x) : std::nullopt});
  return row;
}

std::vector<TriedRow> rows_by(std::size_t n, SharedRows* shared) {
  return shared_rows<TriedRow>(n, {.block = 2, .threads = 3}, {}, shared, [] {
    return [](std::size_t i, TriedRow& row) { row = tried_row(i); };
  });
}

/// The bytes of a share.
std::string bytes_of(std::size_t n, const Share& share) {
  SharedRows shared(share);
  EXPECT_THROW((void)rows_by(n, &shared), ShareDone);
  EXPECT_EQ(shared.rows(), n);
  return shared.bytes();
}

// Kind: identity.  The shares of any division contain each row once, in order.
TEST(SharedRows, IdentityOfTheDivision) {
  for (const std::size_t rows : {0U, 1U, 5U, 16U, 1000U})
    for (const int parts : {1, 2, 3, 7, 16, 2000}) {
      std::size_t next = 0;
      for (int part = 1; part <= parts; ++part) {
        const RowRange range = rows_of({part, parts}, rows);
        EXPECT_EQ(range.first, next);
        EXPECT_LE(range.last - range.first, rows / static_cast<std::size_t>(parts) + 1);
        next = range.last;
      }
      EXPECT_EQ(next, rows);
    }
  const RowRange last = rows_of({100'000, 100'000}, std::size_t{1} << 50);
  EXPECT_EQ(last.last, std::size_t{1} << 50);
}

// Kind: identity.  Rows that were computed in shares are the rows of one process, to the bit.
TEST(SharedRows, IdentityWithOneProcess) {
  constexpr std::size_t kRows = 11;
  const std::vector<TriedRow> whole = rows_by(kRows, nullptr);
  ASSERT_EQ(whole.size(), kRows);
  for (const int parts : {1, 2, 5, 20}) {
    std::string bytes;
    for (int part = 1; part <= parts; ++part) bytes += bytes_of(kRows, {part, parts});
    SharedRows read(kRows, bytes);
    const std::vector<TriedRow> rows = rows_by(kRows, &read);
    EXPECT_EQ(rows, whole);
    EXPECT_TRUE(std::signbit(rows[3].pair[0]));
    // The same shares, each held alone.
    SharedRows in_turn(kRows, parts, [&](int part) { return bytes_of(kRows, {part, parts}); });
    EXPECT_EQ(rows_by(kRows, &in_turn), whole);
    EXPECT_EQ(rows_by(kRows, &in_turn), whole);
  }
}

// Kind: behaviour.  Bytes that are cut, too long, or of another number of rows are refused.
TEST(SharedRows, BehaviourBrokenRecords) {
  constexpr std::size_t kRows = 4;
  const std::string bytes = bytes_of(kRows, {});
  const auto refused = [](std::size_t rows, const std::string& text) {
    SharedRows read(rows, text);
    EXPECT_THROW((void)rows_by(kRows, &read), BrokenRecord) << text.size();
  };
  for (std::size_t size = 0; size < bytes.size(); ++size) refused(kRows, bytes.substr(0, size));
  refused(kRows, bytes + '\0');
  refused(kRows + 1, bytes);
  // The rows of one share in two halves at another place than that of the division.
  SharedRows uneven(kRows, 2, [&](int part) { return part == 1 ? bytes : std::string(); });
  EXPECT_THROW((void)rows_by(kRows, &uneven), BrokenRecord);
  std::string wild = bytes;
  wild[4 * 8 + 6] = '\x7F';  // the length of the first text
  refused(kRows, wild);
}

}  // namespace
}  // namespace strainwave
