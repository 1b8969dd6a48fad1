// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/vtu.hpp"

// deal.II's own headers do not pass this project's warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#include <deal.II/base/data_out_base.h>
#include <deal.II/numerics/data_component_interpretation.h>
#pragma GCC diagnostic pop

#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

namespace component = dealii::DataComponentInterpretation;

/// A field of one, three or nine rows.
using Range = std::tuple<unsigned, unsigned, std::string, component::DataComponentInterpretation>;

struct Layout {
  std::vector<std::string> names;  ///< one for each row
  std::vector<Range> ranges;       ///< vectors and tensors among them
  std::map<std::string, std::string> units;

  void scalar(const std::string& name, const std::string& unit) {
    names.push_back(name);
    units[name] = unit;
  }
  void several(const std::string& name, const std::string& unit, unsigned rows,
               component::DataComponentInterpretation kind) {
    const auto first = static_cast<unsigned>(names.size());
    ranges.emplace_back(first, first + rows - 1, name, kind);
    names.insert(names.end(), rows, name);
    units[name] = unit;
  }
  [[nodiscard]] dealii::DataOutBase::VtkFlags flags() const {
    dealii::DataOutBase::VtkFlags flags;
    flags.print_date_and_time = false;  // the same input gives the same bytes
    flags.write_higher_order_cells = true;
    flags.physical_units = units;
    return flags;
  }
};

Layout body_layout(bool without_crack) {
  Layout layout;
  layout.several("displacement", "m", 3, component::component_is_part_of_vector);
  layout.several("stress", "Pa", 9, component::component_is_part_of_tensor);
  layout.scalar("strain_energy_density", "J/m^3");
  if (without_crack) layout.scalar("strain_energy_density_added", "J/m^3");
  return layout;
}

Layout face_layout() {
  Layout layout;
  layout.several("displacement", "m", 3, component::component_is_part_of_vector);
  layout.scalar("opening", "m");
  return layout;
}

/// Fills patches column by column: the fields, then the place.
template <int dimension>
class Patches {
 public:
  Patches(std::size_t rows, int divisions)
      : rows_(rows), divisions_(static_cast<unsigned>(divisions)) {}

  void begin() {
    patches_.emplace_back();
    auto& patch = patches_.back();
    patch.patch_index = static_cast<unsigned>(patches_.size() - 1);
    patch.n_subdivisions = divisions_;
    patch.points_are_available = true;
    patch.data.reinit(static_cast<unsigned>(rows_ + 3),
                      static_cast<unsigned>(std::lround(std::pow(divisions_ + 1, dimension))));
    column_ = 0;
  }

  void point(const std::vector<double>& fields, const Point3& place) {
    auto& patch = patches_.back();
    unsigned row = 0;
    for (const double value : fields) patch.data(row++, column_) = static_cast<float>(value);
    for (const double x : place) patch.data(row++, column_) = static_cast<float>(x);
    // The corners once more, where deal.II looks for them when nothing is subdivided.
    unsigned rest = column_;
    unsigned corner = 0;
    bool is_corner = true;
    for (unsigned d = 0; d < static_cast<unsigned>(dimension); ++d, rest /= divisions_ + 1) {
      const unsigned i = rest % (divisions_ + 1);
      is_corner = is_corner && (i == 0 || i == divisions_);
      if (i == divisions_) corner |= 1U << d;
    }
    if (is_corner) patch.vertices[corner] = dealii::Point<3>(place[0], place[1], place[2]);
    ++column_;
  }

  [[nodiscard]] std::string vtu(const Layout& layout) const {
    std::ostringstream text;
    dealii::DataOutBase::write_vtu(patches_, layout.names, layout.ranges, layout.flags(), text);
    return text.str();
  }

 private:
  std::size_t rows_;
  unsigned divisions_;
  unsigned column_ = 0;
  std::vector<dealii::DataOutBase::Patch<dimension, 3>> patches_;
};

template <int dimension>
std::string body_text(const SampledFields& fields) {
  const Layout layout = body_layout(fields.without_crack);
  Patches<dimension> patches(layout.names.size(), fields.divisions);
  for (const FieldCell& cell : fields.cells) {
    patches.begin();
    for (const FieldPoint& p : cell.points) {
      const auto& s = p.stress;
      std::vector<double> values = {p.displacement[0],
                                    p.displacement[1],
                                    p.displacement[2],
                                    s[0],
                                    s[5],
                                    s[4],
                                    s[5],
                                    s[1],
                                    s[3],
                                    s[4],
                                    s[3],
                                    s[2],
                                    p.energy_density};
      if (fields.without_crack) values.push_back(p.energy_density - p.energy_density_without_crack);
      patches.point(values, p.place);
    }
  }
  return patches.vtu(layout);
}

std::string record(const std::vector<std::string>& pieces, const Layout& layout) {
  std::ostringstream text;
  dealii::DataOutBase::write_pvtu_record(text, pieces, layout.names, layout.ranges, layout.flags());
  return text.str();
}

void check_divisions(const SampledFields& fields) {
  require(fields.divisions >= 1, "divisions", fields.divisions, "1",
          ">= 1: fields that were asked for");
}

}  // namespace

std::string vtu_text(const SampledFields& fields) {
  check_divisions(fields);
  return fields.dimension == 2 ? body_text<2>(fields) : body_text<3>(fields);
}

std::string crack_faces_vtu_text(const SampledFields& fields) {
  check_divisions(fields);
  const Layout layout = face_layout();
  Patches<2> patches(layout.names.size(), fields.divisions);
  for (const auto side : {&CrackFacePoint::upper, &CrackFacePoint::lower})
    for (const CrackFacePatch& patch : fields.crack_faces) {
      patches.begin();
      for (const CrackFacePoint& p : patch.points) {
        const Point3& u = p.*side;
        patches.point({u[0], u[1], u[2], p.opening}, p.place);
      }
    }
  return patches.vtu(layout);
}

std::string fronts_vtu_text(std::span<const CrackFront> fronts) {
  Layout layout;
  for (const char* const mode : {"K_I", "K_II", "K_III"}) layout.scalar(mode, "Pa*m^0.5");
  layout.scalar("energy_release_rate", "J/m^2");
  layout.scalar("front", "1");
  Patches<1> patches(layout.names.size(), 1);
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    const std::vector<FrontStation>& stations = fronts[f].stations;
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
      patches.begin();
      for (const FrontStation* const s : {&stations[i], &stations[i + 1]})
        patches.point({s->K_I, s->K_II, s->K_III, s->energy_release_rate, static_cast<double>(f)},
                      s->place);
    }
  }
  return patches.vtu(layout);
}

std::string pvtu_text(const std::vector<std::string>& pieces, const SampledFields& fields) {
  return record(pieces, body_layout(fields.without_crack));
}

std::string crack_faces_pvtu_text(const std::vector<std::string>& pieces) {
  return record(pieces, face_layout());
}

}  // namespace strainwave::fem
