// SPDX-License-Identifier: Apache-2.0
#include "strainwave/row_files/row_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <iterator>
#include <system_error>

#include "hdf5_rows.hpp"
#include "strainwave/io/write_file.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

/// Rows as CSV: the columns, `status` and `rule`.  A number keeps every bit; NaN is an empty cell.
class CsvRowFile : public RowFile {
 public:
  explicit CsvRowFile(const std::string& path)
      : path_(path),
        waiting_(path, ""),
        file_(::open(waiting_.temporary().c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)) {
    if (file_ < 0) fail(errno);
  }
  ~CsvRowFile() override {
    if (file_ >= 0) (void)::close(file_);
  }
  CsvRowFile(const CsvRowFile&) = delete;
  CsvRowFile& operator=(const CsvRowFile&) = delete;
  CsvRowFile(CsvRowFile&&) = delete;
  CsvRowFile& operator=(CsvRowFile&&) = delete;

  void come_from(std::vector<std::pair<std::string, std::string>>) override {}
  void begin(const RowHead& head) override {
    left_ = head.rows;
    std::vector<std::string> names;
    for (const RowColumn& column : head.columns)
      names.push_back(fmt::format("{} [{}]", column.name, column.unit));
    names.insert(names.end(), {"status", "rule"});
    text_ += csv_line(names);
  }
  void add(std::span<const double> numbers, RowStatus status, std::string_view rule) override {
    for (const double number : numbers)
      if (std::isnan(number))
        text_ += ',';
      else
        fmt::format_to(std::back_inserter(text_), "{},", number);
    text_ += csv_line({std::string(enum_name(status)), std::string(rule)});
    --left_;
    if (text_.size() >= kMostWaiting) flush();
  }
  void finish() override {
    if (left_ != 0) throw Error(fmt::format("{}: {} rows are missing", path_, left_));
    flush();
    const int closed = ::close(file_);
    file_ = -1;
    if (closed != 0) fail(errno);
  }
  void replace() override { waiting_.replace(); }

 private:
  static constexpr std::size_t kMostWaiting = std::size_t{1} << 20;

  [[noreturn]] void fail(int fault) const {
    throw Error(
        fmt::format("{}: cannot be written: {}", path_, std::generic_category().message(fault)));
  }
  void flush() {
    write_to(file_, path_, text_);
    text_.clear();
  }

  std::string path_;
  WaitingFile waiting_;
  int file_;
  std::string text_;
  std::size_t left_ = 0;
};

}  // namespace

std::unique_ptr<RowFile> row_file(const std::string& path) {
  if (path.ends_with(".h5") || path.ends_with(".hdf5")) return hdf5_row_file(path);
  if (path.ends_with(".csv")) return std::make_unique<CsvRowFile>(path);
  throw InputError("--rows", fmt::format("{} must end in .h5 or .csv, which chooses HDF5 or CSV; "
                                         "name another file",
                                         shown(path)));
}

}  // namespace strainwave
