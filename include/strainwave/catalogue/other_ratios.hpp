// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/catalogue/factors.hpp"
#include "strainwave/catalogue/proportions.hpp"
#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

/// @file
/// Prediction of other ratios of a size from a calibration at one ratio, with its measured error.

namespace strainwave {

struct Calibration;

/// One stiffness predicted at a ratio, beside the stated one.
struct RatioPrediction {
  double ratio = 0.0;            ///< [-]
  std::string name;              ///< "K1", "K2" or "K3"
  double from_torque = 0.0;      ///< [N*m]
  double to_torque = 0.0;        ///< [N*m]
  double predicted = 0.0;        ///< [N*m/rad]
  std::string series;            ///< series whose table states the ratio; empty if no table does
  std::optional<double> stated;  ///< stiffness that this table states [N*m/rad]
  bool same_row = false;  ///< the calibration was fitted to the row that states the stiffness
  /// median and largest error of such predictions over the catalogue (TransferError) [-]; absent at
  /// the calibrated ratio, if no row but the fitted one states the class of the ratio, and beyond
  /// the ratios of the catalogue
  std::optional<double> usual_error;
  std::optional<double> worst_error;

  /// predicted/stated - 1 [-]; absent if no table states the stiffness
  [[nodiscard]] std::optional<double> error() const {
    return stated ? std::optional(predicted / *stated - 1) : std::nullopt;
  }

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"ratio", "1", "reduction ratio"}, &RatioPrediction::ratio);
    field({"name", "", "name of the stiffness"}, &RatioPrediction::name);
    field({"from_torque", "N*m", "torque at which the interval begins"},
          &RatioPrediction::from_torque);
    field({"to_torque", "N*m", "torque at which the interval ends"}, &RatioPrediction::to_torque);
    field({"predicted", "N*m/rad", "predicted with the fitted factors"},
          &RatioPrediction::predicted);
    field({"series", "", "series whose table states the ratio"}, &RatioPrediction::series);
    field({"stated", "N*m/rad", "stiffness that the table states"}, &RatioPrediction::stated);
    field({"same_row", "", "whether the calibration was fitted to the row that states it"},
          &RatioPrediction::same_row);
    field({"error", "1", "predicted/stated - 1"},
          [](const RatioPrediction& p) { return p.error(); });
    field({"usual_error", "1", "median error of such predictions over the catalogue"},
          &RatioPrediction::usual_error);
    field({"worst_error", "1", "largest error of such predictions over the catalogue"},
          &RatioPrediction::worst_error);
  }
};

/// Errors |predicted/stated - 1| of one class of ratio, predicted from calibrations at one ratio.
/// Values of a row that its own calibration was fitted to are left out.
struct TransferError {
  RatioClass to = RatioClass::eighty_up;
  int sizes = 0;
  int values = 0;       ///< a row of several ratios counts at each of them
  double median = 0.0;  ///< [-]
  double worst = 0.0;   ///< [-]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"to", "", "class of the predicted ratio"}, &TransferError::to);
    field({"sizes", "1", "number of sizes"}, &TransferError::sizes);
    field({"values", "1", "number of values; a row of several ratios counts at each of them"},
          &TransferError::values);
    field({"median", "1", "median of |predicted/stated - 1|"}, &TransferError::median);
    field({"worst", "1", "largest of |predicted/stated - 1|"}, &TransferError::worst);
  }
};

/// Errors of the same calibration and prediction, repeated with each size of the catalogue.
struct TransferErrors {
  std::vector<TransferError> classes;  ///< one for each class with a stated value
  int left_out =
      0;  ///< sizes left out because a drive cannot be computed or its fit does not converge
};

/// Largest geometry_difference of a drive that counts as typical [-]: the uncertainty of a row's
/// values by rounding.
inline constexpr double kTypicalDrive = 0.02;

/// The other ratios of a drive's size and type, predicted by a calibration.
struct OtherRatios {
  double from = 0.0;  ///< calibrated ratio [-]
  int size = 0;
  DriveType type;  ///< form and length of the drive, and the blank of the other drives
  /// largest |K of the typical drive with the fitted factors/K of the calibrated drive - 1| at the
  /// calibrated ratio [-]; 0 for a drive with typical geometry
  double geometry_difference = 0.0;
  std::vector<RatioPrediction> predictions;
  /// of |error| over the other ratios, without the values of the fitted row [-]
  std::optional<double> median;
  std::optional<double> worst;
  TransferErrors transfer;  ///< empty unless the drive is a short cup of kLeastSimilarSize

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"from", "1", "calibrated ratio"}, &OtherRatios::from);
    field({"size", "", "size of the drive in the catalogue"}, &OtherRatios::size);
    field({"form", "", "cup, or hat with the diaphragm outward"},
          [](const OtherRatios& o) { return o.type.form; });
    field({"length", "", "length class of the flexspline"},
          [](const OtherRatios& o) { return o.type.length; });
    field({"blank", "", "the wave for which the walls of the other drives are made"},
          [](const OtherRatios& o) { return o.type.blank; });
    field({"geometry_difference", "1",
           "largest difference in K1 to K3 between the typical drive with the fitted factors and "
           "the calibrated drive, at the calibrated ratio"},
          &OtherRatios::geometry_difference);
    field({"median", "1",
           "median of |error| over the other ratios, without the values of the fitted row"},
          &OtherRatios::median);
    field({"worst", "1", "largest |error|, likewise"}, &OtherRatios::worst);
    field({"left_out", "", "sizes left out of transfer_errors because a drive cannot be computed"},
          [](const OtherRatios& o) { return o.transfer.left_out; });
    field({"transfer_errors", "",
           "errors of the same calibration and prediction over the catalogue's sizes of 17 and "
           "more, without the values of fitted rows"},
          [](const OtherRatios& o) -> const std::vector<TransferError>& {
            return o.transfer.classes;
          });
    field({"predictions", "", "each stiffness at each ratio"}, &OtherRatios::predictions);
  }
};

/// Whether the catalogue shows the errors of such predictions: those of short cups of
/// kLeastSimilarSize and more.
[[nodiscard]] bool errors_are_known(const OtherRatios& other);

/// Reads ratios such as "50,80,100", none repeated, or "all" for all other ratios of the tables,
/// which gives an empty list.
/// @throws InputError  unless typical_drive accepts each ratio
[[nodiscard]] std::vector<double> parse_ratios(std::string_view text);

/// Predicts K1, K2, K3 of ratios of the calibrated drive's size, form and length.
///
/// At the calibrated ratio, this is the calibrated drive itself.  At any other ratio, it is the
/// typical drive of size, form and length with the fitted factors, without cracks, output shaft and
/// flange.  The rows of catalogue and other series judge the predictions.  If the calibration was
/// fitted to one of these rows, this row judges no prediction, though it may state several ratios.
/// The errors over the catalogue are those of short cups of kLeastSimilarSize and more; any other
/// drive has none.
///
/// @param calibration  of a drive of a catalogue size, cup or hat, by stiffness
/// @param ratios       i_h [-]; if the list is empty, all other ratios that the tables state for
///                     this size, form and length
/// @param blank        that of the typical drives
/// @param options      of the coupled drive; {}: the values of CoupledOptions
/// @param progress     receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError   if the drive has no size of the catalogue, is neither cup nor hat, if a
///                      ratio is out of range, or if the list is empty and no table states a ratio
/// @throws SolverError  if a drive cannot be computed
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] OtherRatios predict_other_ratios(const Calibration& calibration,
                                               const std::vector<double>& ratios,
                                               Blank blank = Blank::ratio,
                                               const CoupledOptions& options = {},
                                               const Progress& progress = {});

/// Calibrates the typical short cup of each catalogue size from kLeastSimilarSize on to its row at
/// one ratio and predicts the ratios that other rows of its size state.
///
/// A row that has fewer values than there are factors is left out.
/// @param from      calibrated ratio [-]
/// @param factors   one to three
/// @param blank     that of the typical drives
/// @param options   of the coupled drive; {}: the values of CoupledOptions
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError  if the ratio is out of range, or unless there are one to three factors
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] TransferErrors transfer_errors(double from, const std::vector<Factor>& factors,
                                             Blank blank = Blank::ratio,
                                             const CoupledOptions& options = {},
                                             const Progress& progress = {});

}  // namespace strainwave
