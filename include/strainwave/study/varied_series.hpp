// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/study/table_evidence.hpp"

namespace strainwave {

/// An output of the sum of the members, computed without a report.
struct SeriesOutput {
  std::string_view name;  ///< as in a result, or "..._loss", the change with the other sign
  std::string_view unit;  ///< SI unit of the output
  /// the output from the compliances and the load of the drive [unit]
  double (*of)(const SeriesCompliance<double>&, const Load&);
};

/// All outputs of that kind.  The first five are those of the scatter study.
[[nodiscard]] std::span<const SeriesOutput> series_outputs();
/// Number of the outputs of the scatter study.
inline constexpr std::size_t kScatterOutputs = 5;

/// Why a varied drive has no outputs, if it has none.
enum class Fate : unsigned char {
  evaluated,
  refused,   ///< it breaks a rule of the input
  unusable,  ///< it is outside the validity of the model
};

/// Outputs of the sum of the members, and strength margins of cracks, for many drives that differ
/// in some numbers: what all threads share.
///
/// The same numbers as those of `evaluate`: to the last bit without tables (`prepare`), and within
/// 1e-10 with them (ST-21, ST-22).
class VariedSeries {
 public:
  /// Fills the values of a row, one for each path.
  using Fill = std::function<void(std::size_t row, std::span<double> values)>;

  /// @param gear     has passed `check`; must outlive this object
  /// @param paths    of numbers of the drive that `can_vary` accepts
  /// @param outputs  names that `covers` accepts
  VariedSeries(const GearSet& gear, const std::vector<std::string>& paths,
               const std::vector<std::string>& outputs);
  ~VariedSeries();
  /// Takes over the tables of another object, which must not be used after that.
  VariedSeries(VariedSeries&&) noexcept;

  /// Whether all outputs are those of the sum of the members, or strength margins of cracks: the
  /// numbers of a strength apart from critical sizes.
  [[nodiscard]] static bool covers(std::span<const std::string> outputs);
  /// Whether all outputs are those of the sum of the members.
  [[nodiscard]] static bool of_sum(std::span<const std::string> outputs);
  /// Whether all paths are of numbers of the drive, not of its ranges, scatters or inspection.
  [[nodiscard]] static bool can_vary(std::span<const std::string> paths);

  /// Prepares tables of the cracks, where they save time for this number of rows.
  /// @param rows      number of rows that will be evaluated
  /// @param fill      gives the values of a row, of which some hundred are asked for
  /// @param threads   that will evaluate, and fill the tables first; 0: as many as the machine runs
  ///                  at once; 1 fills what it reads, later
  /// @param progress  may stop the work
  void prepare(std::size_t rows, const Fill& fill, int threads = 1, const Progress& progress = {});

  /// Compares the tables with the engine at random rows; absent if no output read a table.  Asks
  /// for the same rows on every machine.
  /// @param rows  as in `prepare`
  /// @param fill  as in `prepare`
  [[nodiscard]] std::optional<TableEvidence> table_evidence(std::size_t rows,
                                                            const Fill& fill) const;
  /// Largest number of rows at which tables and engine are compared: 10 ms.
  static constexpr std::size_t kEvidencePoints = 1000;

  /// Evaluates drives for one thread.
  class Evaluator {
   public:
    /// Takes the tables that the series has by now.  The series must outlive the evaluator.
    explicit Evaluator(const VariedSeries& of) : Evaluator(of, true) {}
    /// @param of         as above
    /// @param by_tables  false: the engine alone answers
    Evaluator(const VariedSeries& of, bool by_tables);
    ~Evaluator();
    /// Takes over the state of another evaluator, which must not be used after that.
    Evaluator(Evaluator&&) noexcept;

    /// Fills the outputs of the drive with these values.
    Fate operator()(std::span<const double> values, std::span<double> outputs);

   private:
    friend class VariedSeries;
    struct State;
    std::unique_ptr<State> state_;
  };

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace strainwave
