// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_tables/crack_tables.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <type_traits>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"

namespace strainwave {
namespace {

/// What the sampled drives say about one crack: the arguments that vary, and the boxes of a table
/// over all arguments.
template <class Solution>
class Survey {
 public:
  using Similar = Similarity<Solution>;
  using Arguments = typename SimilarCracks<Solution>::Arguments;

  void add(const CrackNumbers<Solution>& crack) {
    const Arguments x = Similar::arguments(crack.parameters);
    if (!first_) {
      first_ = crack;
      constant_ = x;
    }
    std::array<long, Similar::kArguments> box{};
    for (std::size_t i = 0; i < x.size(); ++i) {
      varies_[i] = varies_[i] || x[i] != constant_[i];
      box[i] = std::lround(std::floor(table_coordinate<Solution>(i, x[i]) / Similar::kWidths[i]));
    }
    boxes_.try_emplace(box, x);
    reads_[SimilarCracks<Solution>::table_of(crack.faces.positive)] = true;
    reads_[SimilarCracks<Solution>::table_of(crack.faces.negative)] = true;
  }

  /// @return  null if tables would not save time
  [[nodiscard]] std::shared_ptr<SimilarCracks<Solution>> table(std::size_t rows) const {
    std::vector<std::size_t> varies;
    for (std::size_t i = 0; i < varies_.size(); ++i)
      if (varies_[i]) varies.push_back(i);
    if (varies.size() > ChebyshevCells::kMaxVariables) return nullptr;
    // A constant argument needs a variable too, because a table has at least one.
    if (varies.empty()) varies.push_back(0);
    double nodes = static_cast<double>(boxes_.size() * Similar::kParts.size());
    for (std::size_t v = 0; v < varies.size(); ++v) nodes *= ChebyshevCells::kNodes;
    constexpr double kPays = 4.0;  // some boxes are halved, and some are not in the sample
    if (kPays * nodes > static_cast<double>(rows)) return nullptr;
    return std::make_shared<SimilarCracks<Solution>>(*first_, std::move(varies));
  }

  /// Adds the work of filling each box of the tables that this survey has made.
  void add_work(const std::shared_ptr<SimilarCracks<Solution>>& tables,
                std::vector<std::function<void()>>& work) const {
    for (const auto& box : boxes_)
      for (const std::size_t table : {0U, 1U})
        if (reads_[table])
          work.emplace_back([tables, x = box.second, table] { tables->fill_box(x, table); });
  }

 private:
  std::optional<CrackNumbers<Solution>> first_;
  Arguments constant_{};
  std::array<bool, Similar::kArguments> varies_{};
  /// Each box with the arguments of a crack in it.
  std::map<std::array<long, Similar::kArguments>, Arguments> boxes_;
  std::array<bool, 2> reads_{};  ///< whether a crack reads the table of this index
};

using AnySurvey = OfAnySolution<double, Survey>;

struct Surveyor {
  AnySurvey& survey;

  template <class Solution>
  void operator()(const CrackNumbers<Solution>& crack) const {
    if (crack.table) return;               // the file gives the compliance
    if (crack.moduli.anisotropic) return;  // the engine answers
    if (std::holds_alternative<std::monostate>(survey)) survey.emplace<Survey<Solution>>();
    // A shaft whose bore varies through 0 has two solutions; the first gets the table.
    if (auto* const of = std::get_if<Survey<Solution>>(&survey)) of->add(crack);
  }
  void operator()(const LoadedGroove&) const {}
  void operator()(const ActsInCoupledDrive&) const {}
};

}  // namespace

CrackTables::CrackTables(std::size_t rows, const Sample& sample) {
  std::vector<AnySurvey> surveys;
  const std::size_t samples = std::min(rows, kSamples);
  for (std::size_t n = 0; n < samples; ++n) {
    const GearSet* const gear = sample(n * rows / samples);
    if (gear == nullptr) continue;
    const CrackLoads<double> loads(*gear);
    std::size_t index = 0;
    for_each_series_crack(*gear, [&](const auto& crack) {
      if (index == surveys.size()) surveys.emplace_back();
      loads.describe(crack, Surveyor{surveys[index++]});
    });
  }
  for (const AnySurvey& survey : surveys)
    of_crack_.push_back(std::visit(
        [&](const auto& of) -> AnyTable {
          if constexpr (requires { of.table(rows); })
            if (auto made = of.table(rows)) {
              of.add_work(made, unfilled_);
              return made;
            }
          return {};
        },
        survey));
}

void CrackTables::fill(int threads, const Progress& progress) {
  for_each_index(unfilled_.size(), {.threads = threads}, progress, [&] {
    return [&](std::size_t n) {
      try {
        unfilled_[n]();
      } catch (const Error&) {
        // The drive that asks for this box has the same fault and reports it.
      }
    };
  });
  unfilled_.clear();
}

std::size_t CrackTables::tables() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(of_crack_, [](const AnyTable& table) { return table.index() != 0; }));
}

double CrackTables::largest_error() const {
  double largest = 0.0;
  for (const AnyTable& any : of_crack_)
    std::visit(
        [&](const auto& table) {
          if constexpr (requires { table->largest_error(); })
            largest = std::max(largest, table->largest_error());
        },
        any);
  return largest;
}

CrackTables::Reader::Reader(const CrackTables& tables) {
  for (const AnyTable& any : tables.of_crack_)
    std::visit(
        [&](const auto& table) {
          if constexpr (requires { *table; })
            readers_.emplace_back(typename std::decay_t<decltype(*table)>::Reader(*table));
          else
            readers_.emplace_back();
        },
        any);
}

}  // namespace strainwave
