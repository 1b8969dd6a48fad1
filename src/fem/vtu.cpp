// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/vtu.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

static_assert(std::endian::native == std::endian::little, "the documents say LittleEndian");

// The writer of deal.II 9.4 is not used, because its documents lack the types of the cells.

/// A field on the points of a document.
struct PointField {
  std::string_view name;
  std::string_view unit;
  std::size_t components = 1;
};

using Fields = std::vector<PointField>;

Fields body_fields(bool without_crack) {
  Fields fields = {
      {"displacement", "m", 3}, {"stress", "Pa", 9}, {"strain_energy_density", "J/m^3", 1}};
  if (without_crack) fields.push_back({"strain_energy_density_added", "J/m^3", 1});
  return fields;
}

Fields face_fields() { return {{"displacement", "m", 3}, {"opening", "m", 1}}; }

Fields front_fields() {
  return {{"K_I", "Pa*m^0.5", 1},
          {"K_II", "Pa*m^0.5", 1},
          {"K_III", "Pa*m^0.5", 1},
          {"energy_release_rate", "J/m^2", 1},
          {"front", "1", 1}};
}

std::string base64(const std::string& bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = (word << 8U) | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[(word >> (18U - 6U * k)) & 63U];
  }
  return text;
}

/// A "<DataArray ...>" with its numbers as one block of base64 after their size.
template <class Stored, class Number>
std::string data_array(const std::string& attributes, const std::vector<Number>& numbers) {
  static constexpr std::string_view kType = std::is_same_v<Stored, double>         ? "Float64"
                                            : std::is_same_v<Stored, float>        ? "Float32"
                                            : std::is_same_v<Stored, std::int32_t> ? "Int32"
                                                                                   : "UInt8";
  const std::size_t size = numbers.size() * sizeof(Stored);
  if (size > 0xFFFFFFFFU) throw Error("fields of more than 4 GB do not fit into a .vtu file");
  std::string bytes(sizeof(std::uint32_t) + size, '\0');
  const auto header = static_cast<std::uint32_t>(size);
  std::memcpy(bytes.data(), &header, sizeof header);
  char* to = bytes.data() + sizeof header;
  for (const Number number : numbers) {
    const auto stored = static_cast<Stored>(number);
    std::memcpy(to, &stored, sizeof stored);
    to += sizeof stored;
  }
  return fmt::format("<DataArray type=\"{}\" {} format=\"binary\">\n{}\n</DataArray>\n", kType,
                     attributes, base64(bytes));
}

/// Grids of cells with fields, as one document; grids do not share points.
class Document {
 public:
  /// @param dimension  dimension of the grids, 1 to 3
  /// @param divisions  cells in each direction
  Document(Fields fields, int dimension, int divisions)
      : fields_(std::move(fields)),
        values_(fields_.size()),
        dimension_(static_cast<std::size_t>(dimension)),
        divisions_(static_cast<std::size_t>(divisions)) {}

  void begin_grid() {
    const std::size_t n = divisions_;
    const std::size_t first = points_.size() / 3;
    const std::array<std::size_t, 3> stride = {1, n + 1, (n + 1) * (n + 1)};
    // Order of the corners of a line, a quadrilateral and a hexahedron in VTK.
    static constexpr std::array<std::array<std::size_t, 3>, 8> kCorners = {
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    const std::size_t corners = std::size_t{1} << dimension_;
    const std::size_t n_y = dimension_ > 1 ? n : 1;
    const std::size_t n_z = dimension_ > 2 ? n : 1;
    for (std::size_t k = 0; k < n_z; ++k)
      for (std::size_t j = 0; j < n_y; ++j)
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t c = 0; c < corners; ++c)
            connectivity_.push_back(first + (i + kCorners[c][0]) * stride[0] +
                                    (j + kCorners[c][1]) * stride[1] +
                                    (k + kCorners[c][2]) * stride[2]);
  }

  /// Adds a point of the grid just begun; the first index runs fastest.  Each field gets as many
  /// numbers as it has components.
  void point(const Point3& place, std::initializer_list<double> numbers) {
    points_.insert(points_.end(), place.begin(), place.end());
    const double* number = numbers.begin();
    for (std::size_t f = 0; f < fields_.size(); ++f)
      for (std::size_t c = 0; c < fields_[f].components; ++c) values_[f].push_back(*number++);
  }

  [[nodiscard]] std::string text() const {
    constexpr std::array<int, 4> kTypes = {1, 3, 9, 12};  // cell types of VTK by dimension
    const std::size_t corners = std::size_t{1} << dimension_;
    const std::size_t cells = connectivity_.size() / corners;
    std::vector<std::size_t> offsets;
    for (std::size_t c = 1; c <= cells; ++c) offsets.push_back(c * corners);
    const std::vector<int> types(cells, kTypes[dimension_]);
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" header_type=\"UInt32\">\n<UnstructuredGrid>\n<Piece "
        "NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
        points_.size() / 3, cells);
    text += data_array<double>("Name=\"Points\" NumberOfComponents=\"3\"", points_);
    text += "</Points>\n<Cells>\n";
    text += data_array<std::int32_t>("Name=\"connectivity\"", connectivity_);
    text += data_array<std::int32_t>("Name=\"offsets\"", offsets);
    text += data_array<std::uint8_t>("Name=\"types\"", types);
    text += "</Cells>\n<PointData>\n";
    for (std::size_t f = 0; f < fields_.size(); ++f)
      text += data_array<float>(attributes(fields_[f]), values_[f]);
    return text + "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

  [[nodiscard]] static std::string attributes(const PointField& field) {
    return fmt::format("Name=\"{}\"{} units=\"{}\"", field.name,
                       field.components == 1
                           ? std::string()
                           : fmt::format(" NumberOfComponents=\"{}\"", field.components),
                       field.unit);
  }

 private:
  Fields fields_;
  std::vector<double> points_;
  std::vector<std::size_t> connectivity_;
  std::vector<std::vector<double>> values_;  ///< values of each field
  std::size_t dimension_;
  std::size_t divisions_;
};

std::string record(const std::vector<std::string>& pieces, const Fields& fields) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt32\">\n<PUnstructuredGrid "
      "GhostLevel=\"0\">\n<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" "
      "NumberOfComponents=\"3\"/>\n</PPoints>\n<PPointData>\n";
  for (const PointField& field : fields)
    text += fmt::format("<PDataArray type=\"Float32\" {}/>\n", Document::attributes(field));
  text += "</PPointData>\n";
  for (const std::string& piece : pieces) text += fmt::format("<Piece Source=\"{}\"/>\n", piece);
  return text + "</PUnstructuredGrid>\n</VTKFile>\n";
}

void check_divisions(const SampledFields& fields) {
  require(fields.divisions >= 1, "divisions", fields.divisions, "1",
          ">= 1: fields that were asked for");
}

}  // namespace

std::string vtu_text(const SampledFields& fields) {
  check_divisions(fields);
  Document document(body_fields(fields.without_crack), fields.dimension, fields.divisions);
  for (const FieldCell& cell : fields.cells) {
    document.begin_grid();
    for (const FieldPoint& p : cell.points) {
      const auto& u = p.displacement;
      const auto& s = p.stress;
      // If the sound body is not known, the last number is superfluous and not read.
      document.point(p.place,
                     {u[0], u[1], u[2], s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2],
                      p.energy_density, p.energy_density - p.energy_density_without_crack});
    }
  }
  return document.text();
}

std::string crack_faces_vtu_text(const SampledFields& fields) {
  check_divisions(fields);
  Document document(face_fields(), 2, fields.divisions);
  for (const auto side : {&CrackFacePoint::upper, &CrackFacePoint::lower})
    for (const CrackFacePatch& patch : fields.crack_faces) {
      document.begin_grid();
      for (const CrackFacePoint& p : patch.points)
        document.point(p.place, {(p.*side)[0], (p.*side)[1], (p.*side)[2], p.opening});
    }
  return document.text();
}

std::string fronts_vtu_text(std::span<const CrackFront> fronts) {
  Document document(front_fields(), 1, 1);
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    const std::vector<FrontStation>& stations = fronts[f].stations;
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
      document.begin_grid();
      for (const FrontStation* const s : {&stations[i], &stations[i + 1]})
        document.point(s->place,
                       {s->K_I, s->K_II, s->K_III, s->energy_release_rate, static_cast<double>(f)});
    }
  }
  return document.text();
}

std::string pvtu_text(const std::vector<std::string>& pieces, const SampledFields& fields) {
  return record(pieces, body_fields(fields.without_crack));
}

std::string pvd_text(std::span<const SeriesFile> files) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const SeriesFile& file : files)
    text +=
        fmt::format("<DataSet timestep=\"{:.12g}\" part=\"0\" file=\"{}\"/>\n", file.at, file.name);
  return text + "</Collection>\n</VTKFile>\n";
}

std::string crack_faces_pvtu_text(const std::vector<std::string>& pieces) {
  return record(pieces, face_fields());
}

}  // namespace strainwave::fem
