// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/chebyshev_cells.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/crack_tables/similarity.hpp"
#include "strainwave/drive_cracks/wall_group.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// Tables of the added compliance of one crack of a drive whose numbers vary.
///
/// Implements theory manual eqs. (ST-21), (ST-22).  The engine of the added compliance fills the
/// tables where they are read, over those arguments that vary.
template <class Solution>
class SimilarCracks {
 public:
  using Similar = Similarity<Solution>;
  using Numbers = CrackNumbers<Solution>;
  using Arguments = std::array<double, Similar::kArguments>;
  static constexpr std::size_t kParts = Similar::kParts.size();
  static_assert(kParts <= ChebyshevCells::kMaxValues);

  /// @param first   numbers of the crack in one of its drives
  /// @param varies  the arguments that vary, 1 to ChebyshevCells::kMaxVariables of them
  SimilarCracks(const Numbers& first, std::vector<std::size_t> varies)
      : first_(first.parameters),
        constant_(Similar::arguments(first.parameters)),
        varies_(std::move(varies)) {
    ChebyshevCells::Options options{.widths = {}, .values = kParts};
    for (const std::size_t i : varies_) options.widths.push_back(Similar::kWidths[i]);
    for (auto& cells : cells_) {
      const Faces faces = &cells == cells_.data() ? Faces::open : Faces::pressed;
      cells.emplace(
          [this, faces](const ChebyshevCells::Place& place, ChebyshevCells::Values& values) {
            return fill(place, values, faces);
          },
          options);
      if (!Similar::kFacesChangeShape) break;
    }
  }
  SimilarCracks(const SimilarCracks&) = delete;  // its cells refer to it
  SimilarCracks& operator=(const SimilarCracks&) = delete;

  /// Reads the tables for one thread.
  class Reader {
   public:
    explicit Reader(SimilarCracks& of) : of_(&of) {
      for (auto& cells : of.cells_)
        if (cells) readers_.emplace_back(*cells);
    }

    /// Added compliance under each sense of the torque, or under the lobe force.
    /// @return  empty if the tables do not contain this crack, so that the engine must answer
    [[nodiscard]] std::optional<UnderBothSenses<double>> operator()(const Numbers& crack) {
      if (crack.moduli.anisotropic) return std::nullopt;  // no weight exists for the coupling
      if (Similar::fixed(crack.parameters) != Similar::fixed(of_->first_)) return std::nullopt;
      const Arguments x = Similar::arguments(crack.parameters);
      ChebyshevCells::Place place{};
      std::size_t next = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        if (next < of_->varies_.size() && of_->varies_[next] == i)
          place[next++] = table_coordinate<Solution>(i, x[i]);
        else if (x[i] != of_->constant_[i])
          return std::nullopt;
      }
      ChebyshevCells::Values f{};
      const auto read = [&](Faces faces) { return readers_[table_of(faces)](place, f); };
      const auto sum = [&](Faces faces) {
        const auto w = Similar::weights(crack.parameters, crack.moduli, faces);
        double total = 0.0;
        for (std::size_t i = 0; i < kParts; ++i) total += w[i] * f[i];  // (ST-21)
        return total * vanishing(x, faces);
      };
      if (!read(crack.faces.positive)) return std::nullopt;
      UnderBothSenses<double> added;
      added.positive = added.negative = sum(crack.faces.positive);
      if (crack.faces.differ()) {
        if (Similar::kFacesChangeShape && !read(crack.faces.negative)) return std::nullopt;
        added.negative = sum(crack.faces.negative);
      }
      return added;
    }

   private:
    SimilarCracks* of_;
    std::vector<ChebyshevCells::Reader> readers_;
  };

  /// The table of a state of the faces; 1 if pressed faces have a solution of their own.
  [[nodiscard]] static std::size_t table_of(Faces faces) {
    return Similar::kFacesChangeShape && faces == Faces::pressed ? 1 : 0;
  }

  /// Fills the box of one table at the given arguments, unless it is filled.
  /// @param table  0 or 1, as `table_of` gives it
  void fill_box(const Arguments& x, std::size_t table) {
    ChebyshevCells::Place place{};
    for (std::size_t v = 0; v < varies_.size(); ++v)
      place[v] = table_coordinate<Solution>(varies_[v], x[varies_[v]]);
    ChebyshevCells::Values ignored{};
    (void)ChebyshevCells::Reader (*cells_[table])(place, ignored);
  }

  /// Largest error of the polynomials used so far [-].
  [[nodiscard]] double largest_error() const {
    double largest = 0.0;
    for (const auto& cells : cells_)
      if (cells) largest = std::max(largest, cells->largest_error());
    return largest;
  }

 private:
  static double vanishing(const Arguments& x, Faces faces) {
    if constexpr (requires { Similar::vanishing(x, faces); })
      return Similar::vanishing(x, faces);
    else
      return 1.0;
  }

  bool fill(const ChebyshevCells::Place& place, ChebyshevCells::Values& values, Faces faces) const {
    Arguments x = constant_;
    for (std::size_t i = 0; i < varies_.size(); ++i)
      x[varies_[i]] = argument_at<Solution>(varies_[i], place[i]);
    for (std::size_t i = 0; i < kParts; ++i) {
      const CrackPart part = Similar::kParts[i];
      // A node of a box may be a crack that touches its neighbours.
      if constexpr (requires { Similar::known(first_); })
        if (!Similar::known(Similar::shape(first_, x, part))) return false;
      const auto of = similar_part<Solution>(first_, x, part, faces, moduli_of<double>(part),
                                             {.relative_tolerance = 1e-12});
      if (!of.converged) return false;
      values[i] = of.value / vanishing(x, faces);
    }
    return true;
  }

  typename ParametersOf<Solution>::type first_;
  Arguments constant_;
  std::vector<std::size_t> varies_;
  std::array<std::optional<ChebyshevCells>, 2> cells_;  ///< faces apart; pressed, if it differs
};

/// Tables for the cracks of a drive whose numbers vary, for those cracks where filling them takes
/// less time than it saves.
class CrackTables {
 public:
  /// Fills the varied drive with the numbers of one of its rows; null: the row breaks a rule.
  using Sample = std::function<const GearSet*(std::size_t row)>;

  /// @param rows    number of drives to be evaluated
  /// @param sample  the drives; up to kSamples of them, evenly spread, say what varies
  CrackTables(std::size_t rows, const Sample& sample);

  static constexpr std::size_t kSamples = 512;

  /// Number of cracks that have tables.
  [[nodiscard]] std::size_t tables() const;

  /// Fills the boxes in which the sampled drives lie, each by one of several threads.  Other boxes
  /// are filled when a drive asks for them, and other threads that need such a box wait.
  /// @param threads   0: as many as the machine runs at once
  /// @param progress  may stop the work
  void fill(int threads, const Progress& progress);

  /// Largest relative error of the tables read so far, against the engine [-].
  [[nodiscard]] double largest_error() const;

  class Reader;

 private:
  template <class Solution>
  using Table = std::shared_ptr<SimilarCracks<Solution>>;
  using AnyTable = OfAnySolution<double, Table>;

  std::vector<AnyTable> of_crack_;               ///< in the order of `for_each_series_crack`
  std::vector<std::function<void()>> unfilled_;  ///< each fills one box
};

/// Reads the tables for one thread.
class CrackTables::Reader {
 public:
  explicit Reader(const CrackTables& tables);

  /// Added compliance of a crack under each sense of the torque, or under the lobe force.
  /// @param index  of the crack, in the order of `for_each_series_crack`
  /// @return       empty if the engine must answer
  template <class Solution>
  [[nodiscard]] std::optional<UnderBothSenses<double>> operator()(
      std::size_t index, const CrackNumbers<Solution>& crack) {
    if (index >= readers_.size()) return std::nullopt;
    auto* const reader = std::get_if<typename SimilarCracks<Solution>::Reader>(&readers_[index]);
    if (reader == nullptr) return std::nullopt;
    return (*reader)(crack);
  }

  /// Ellipses of the contacts of balls, which most studies do not vary.
  [[nodiscard]] ContactEllipses& ellipses() { return ellipses_; }

 private:
  template <class Solution>
  using ReaderOf = typename SimilarCracks<Solution>::Reader;

  std::vector<OfAnySolution<double, ReaderOf>> readers_;
  ContactEllipses ellipses_;
};

/// Calls f(crack) for each crack of the series model: wave generator, flexspline, output shaft.
template <class F>
void for_each_series_crack(const GearSet& gear, const F& f) {
  const auto each = [&](const auto& member) {
    if (!member) return;
    for (const auto& any : member->crack) std::visit(f, any);
  };
  each(gear.wave_generator);
  each(gear.flexspline);
  each(gear.output_shaft);
}

}  // namespace strainwave
