// SPDX-License-Identifier: Apache-2.0
#include "hdf5_rows.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <system_error>

#include "strainwave/io/write_file.hpp"

namespace strainwave {
namespace {

/// Deflate: higher levels take half as much time again for less than 1 % of the size.
constexpr unsigned kDeflateLevel = 1;

/// An identifier of the HDF5 library, which is closed at the end.
class Identifier {
 public:
  Identifier() = default;
  Identifier(hid_t id, herr_t (*closer)(hid_t)) : id_(id), close_(closer) {}
  ~Identifier() { (void)close(); }
  Identifier(const Identifier&) = delete;
  Identifier& operator=(const Identifier&) = delete;
  Identifier(Identifier&& other) noexcept { swap(other); }
  Identifier& operator=(Identifier&& other) noexcept {
    swap(other);
    return *this;
  }

  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] bool good() const { return id_ >= 0; }
  /// Whether the library could close it.
  bool close() {
    const bool closed = id_ < 0 || close_(id_) >= 0;
    id_ = -1;
    return closed;
  }

 private:
  void swap(Identifier& other) {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
  }

  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

/// The fault of the system in the description of one fault of the library.
herr_t find_errno(unsigned, const H5E_error2_t* fault, void* found) {
  const std::string_view text = fault->desc != nullptr ? fault->desc : "";
  constexpr std::string_view kBefore = "errno = ";
  const std::size_t at = text.find(kBefore);
  if (at != std::string_view::npos)
    (void)std::from_chars(text.data() + at + kBefore.size(), text.data() + text.size(),
                          *static_cast<int*>(found));
  return 0;
}

/// The library neither prints faults nor writes at the end of the program, when a full disk would
/// stop it again.
void prepare_library() {
  static const bool done = [] {
    (void)H5dont_atexit();
    (void)H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return true;
  }();
  (void)done;
}

/// The name of a column's dataset.  A slash would mean a group, so it is written %2F, and a per
/// cent sign %25.
std::string dataset_name(std::string_view column) {
  std::string name;
  for (const char c : column)
    if (c == '/')
      name += "%2F";
    else if (c == '%')
      name += "%25";
    else
      name += c;
  return name;
}

/// Rows in an HDF5 file: a dataset for each column, compressed by chunks.  The file contains no
/// times, so the same rows give the same bytes.
class Hdf5RowFile : public RowFile {
 public:
  explicit Hdf5RowFile(const std::string& path) : path_(path), waiting_(path, "") {
    prepare_library();
  }

  void come_from(std::vector<std::pair<std::string, std::string>> origin) override {
    origin_ = std::move(origin);
  }

  void begin(const RowHead& head) override {
    rows_ = head.rows;
    const Identifier access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    checked(H5Pset_fclose_degree(access.id(), H5F_CLOSE_STRONG));
    // The temporary file is ours alone, and some network disks cannot lock files.
    checked(H5Pset_file_locking(access.id(), 0, 1));
    file_ = made(H5Fcreate(waiting_.temporary().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()),
                 H5Fclose);
    const Identifier root = made(H5Gopen2(file_.id(), "/", H5P_DEFAULT), H5Gclose);
    write_text(root, "format", kRowsFormat);
    for (const auto& [name, text] : origin_) write_text(root, name.c_str(), text);
    write_text(root, "rows_are", head.of);
    write_whole(root, "row_count", head.rows);
    if (head.seed) write_whole(root, "seed", *head.seed);

    std::vector<std::string> names;
    for (const RowColumn& column : head.columns) names.push_back(column.name);
    write_texts("columns", names);
    // A link in the old form of a group has no time; its object header must have none either.
    const Identifier properties = made(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    checked(H5Pset_obj_track_times(properties.id(), 0));
    const Identifier group =
        made(H5Gcreate2(file_.id(), "rows", H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Gclose);
    for (const RowColumn& column : head.columns) {
      numbers_.push_back({dataset(group, dataset_name(column.name), H5T_IEEE_F64LE), {}});
      write_text(numbers_.back().dataset, "unit", column.unit);
      numbers_.back().values.reserve(kRowsOfChunk);
    }
    const Identifier status_type = made(H5Tenum_create(H5T_STD_U8LE), H5Tclose);
    for (std::size_t i = 0; i < EnumNames<RowStatus>::names.size(); ++i) {
      const auto value = static_cast<std::uint8_t>(i);
      checked(H5Tenum_insert(status_type.id(), std::string(EnumNames<RowStatus>::names[i]).c_str(),
                             &value));
    }
    status_.dataset = dataset(file_, "status", status_type.id());
    rule_.dataset = dataset(file_, "rule", H5T_STD_U32LE);
    write_text(rule_.dataset, "of", "index in the dataset rules; 0 is no rule");
    rules_ = {{std::string(), 0}};
  }

  void add(std::span<const double> numbers, RowStatus status, std::string_view rule) override {
    for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i].values.push_back(numbers[i]);
    status_.values.push_back(static_cast<std::uint8_t>(status));
    rule_.values.push_back(index_of(rule));
    if (status_.values.size() == kRowsOfChunk) flush();
  }

  void finish() override {
    flush();
    if (written_ != rows_)
      throw Error(fmt::format("{}: {} rows are missing", path_, rows_ - written_));
    std::vector<std::string> rules(rules_.size());
    for (const auto& [rule, index] : rules_) rules[index] = rule;
    write_texts("rules", rules);
    for (Column<double>& column : numbers_) require(column.dataset.close());
    require(status_.dataset.close() && rule_.dataset.close());
    checked(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL));
    require(file_.close());
  }

  void replace() override { waiting_.replace(); }

 private:
  template <class Value>
  struct Column {
    Identifier dataset;
    std::vector<Value> values;  ///< that are not written yet
  };

  /// @throws Error  with the reason that the library or the system gives, unless `good`
  void require(bool good) const {
    if (good) return;
    int fault = 0;
    (void)H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, find_errno, &fault);
    throw Error(fmt::format("{}: cannot be written: {}", path_,
                            fault != 0 ? std::generic_category().message(fault)
                                       : std::string("the HDF5 library reports a fault")));
  }
  void checked(herr_t result) const { require(result >= 0); }
  [[nodiscard]] Identifier made(hid_t id, herr_t (*close)(hid_t)) const {
    Identifier identifier(id, close);
    require(identifier.good());
    return identifier;
  }

  void write_text(const Identifier& to, const char* name, std::string_view text) const {
    const Identifier type = made(H5Tcopy(H5T_C_S1), H5Tclose);
    checked(H5Tset_size(type.id(), H5T_VARIABLE));
    checked(H5Tset_cset(type.id(), H5T_CSET_UTF8));
    const std::string whole(text);
    const char* const begin = whole.c_str();
    write_attribute(to, name, type.id(), type.id(), &begin);
  }
  void write_whole(const Identifier& to, const char* name, std::uint64_t number) const {
    write_attribute(to, name, H5T_STD_U64LE, H5T_NATIVE_UINT64, &number);
  }
  void write_attribute(const Identifier& to, const char* name, hid_t in_file, hid_t in_memory,
                       const void* value) const {
    const Identifier space = made(H5Screate(H5S_SCALAR), H5Sclose);
    const Identifier attribute =
        made(H5Acreate2(to.id(), name, in_file, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    checked(H5Awrite(attribute.id(), in_memory, value));
  }

  /// Writes texts as a dataset of texts of one length, filled up with zeros.
  void write_texts(const char* name, const std::vector<std::string>& texts) const {
    std::size_t length = 1;
    for (const std::string& text : texts) length = std::max(length, text.size());
    std::string all;
    for (const std::string& text : texts) {
      all += text;
      all.append(length - text.size(), '\0');
    }
    const Identifier type = made(H5Tcopy(H5T_C_S1), H5Tclose);
    checked(H5Tset_size(type.id(), length));
    checked(H5Tset_cset(type.id(), H5T_CSET_UTF8));
    checked(H5Tset_strpad(type.id(), H5T_STR_NULLPAD));
    const hsize_t n = texts.size();
    const Identifier space = made(H5Screate_simple(1, &n, nullptr), H5Sclose);
    const Identifier properties = made(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    checked(H5Pset_obj_track_times(properties.id(), 0));
    const Identifier set = made(H5Dcreate2(file_.id(), name, type.id(), space.id(), H5P_DEFAULT,
                                           properties.id(), H5P_DEFAULT),
                                H5Dclose);
    if (n > 0) checked(H5Dwrite(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()));
  }

  [[nodiscard]] Identifier dataset(const Identifier& group, const std::string& name,
                                   hid_t type) const {
    const hsize_t n = rows_;
    const Identifier space = made(H5Screate_simple(1, &n, nullptr), H5Sclose);
    const Identifier properties = made(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    const hsize_t chunk = std::clamp<hsize_t>(n, 1, kRowsOfChunk);
    checked(H5Pset_chunk(properties.id(), 1, &chunk));
    checked(H5Pset_shuffle(properties.id()));
    checked(H5Pset_deflate(properties.id(), kDeflateLevel));
    checked(H5Pset_fletcher32(properties.id()));
    checked(H5Pset_obj_track_times(properties.id(), 0));
    // A chunk is written whole and once, so none is kept.
    const Identifier access = made(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
    checked(H5Pset_chunk_cache(access.id(), 0, 0, 1.0));
    return made(H5Dcreate2(group.id(), name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(),
                           access.id()),
                H5Dclose);
  }

  std::uint32_t index_of(std::string_view rule) {
    if (const auto found = rules_.find(rule); found != rules_.end()) return found->second;
    const std::string text(rules_.size() + 1 < kMostRules ? rule : "another rule");
    return rules_.try_emplace(text, static_cast<std::uint32_t>(rules_.size())).first->second;
  }

  template <class Value>
  void write(Column<Value>& column, hid_t type) {
    const hsize_t n = column.values.size();
    const hsize_t first = written_;
    const Identifier memory = made(H5Screate_simple(1, &n, nullptr), H5Sclose);
    const Identifier place = made(H5Dget_space(column.dataset.id()), H5Sclose);
    checked(H5Sselect_hyperslab(place.id(), H5S_SELECT_SET, &first, nullptr, &n, nullptr));
    checked(H5Dwrite(column.dataset.id(), type, memory.id(), place.id(), H5P_DEFAULT,
                     column.values.data()));
    column.values.clear();
  }
  void flush() {
    const std::size_t n = status_.values.size();
    if (n == 0) return;
    if (written_ + n > rows_) throw Error(fmt::format("{}: there are more rows than said", path_));
    for (Column<double>& column : numbers_) write(column, H5T_NATIVE_DOUBLE);
    const Identifier type = made(H5Dget_type(status_.dataset.id()), H5Tclose);
    write(status_, type.id());
    write(rule_, H5T_NATIVE_UINT32);
    written_ += n;
  }

  std::string path_;
  WaitingFile waiting_;
  std::vector<std::pair<std::string, std::string>> origin_;
  Identifier file_;
  std::vector<Column<double>> numbers_;
  Column<std::uint8_t> status_;
  Column<std::uint32_t> rule_;
  std::map<std::string, std::uint32_t, std::less<>> rules_;
  std::size_t rows_ = 0;
  std::size_t written_ = 0;
};

}  // namespace

std::unique_ptr<RowFile> hdf5_row_file(const std::string& path) {
  return std::make_unique<Hdf5RowFile>(path);
}

}  // namespace strainwave
