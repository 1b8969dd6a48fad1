// SPDX-License-Identifier: Apache-2.0
#include "csv_reader.hpp"
#include "strainwave/catalogue/calibration.hpp"

namespace strainwave {

std::vector<MeasuredPoint> parse_measured_curve(std::string_view text, std::string_view file_name) {
  CsvReader reader(file_name,
                   {{.name = "torque", .si = "N*m", .usual = "N*m"},
                    {.name = "twist", .si = "rad", .usual = "arcmin"}},
                   "must name the columns torque and twist with their units, such as \"torque "
                   "[N*m],twist [arcmin]\"");
  std::vector<MeasuredPoint> points;
  reader.read(text, [&] {
    const double torque = reader.number("torque");
    const double twist = reader.number("twist");
    if (torque == 0.0 && twist == 0.0) return;
    if (!(torque * twist > 0))
      reader.refuse(
          "twist",
          "torque and twist must have the same sign; measure the twist from the unloaded state");
    points.push_back({torque, twist});
  });
  if (points.empty()) reader.refuse_at(0, "has no point with a torque; give at least one");
  return points;
}

}  // namespace strainwave
