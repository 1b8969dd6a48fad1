// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "strainwave/command/command.hpp"

namespace strainwave::cli {

/// The file of the checkpoint of a record.
[[nodiscard]] inline std::string checkpoint_of(const std::string& record) {
  return record + ".checkpoint";
}

/// A record in a file, with its checkpoint in a file beside it.  While the
/// record is open, no other process can open it.
class FileRecording : public Recording {
 public:
  /// @param resume  whether to go on from the checkpoint, if the record was begun
  /// @throws UnwritableError  if the path cannot be that of a file
  /// @throws UsageError       if there is a checkpoint although none is asked for, or a record
  ///                          without the checkpoint that is asked for
  FileRecording(std::string path, bool resume);
  ~FileRecording() override;
  FileRecording(const FileRecording&) = delete;
  FileRecording& operator=(const FileRecording&) = delete;
  FileRecording(FileRecording&&) = delete;
  FileRecording& operator=(FileRecording&&) = delete;

  [[nodiscard]] std::string name() const override { return path_; }
  [[nodiscard]] std::optional<std::string> checkpoint() const override { return checkpoint_; }
  void begin(const std::string& checkpoint) override;
  void go_on(std::uint64_t size) override;
  void append(std::string_view bytes) override;
  [[nodiscard]] std::uint64_t size() const override { return size_ + waiting_.size(); }
  [[nodiscard]] bool due() override { return Clock::now() >= next_; }
  void keep(const std::string& checkpoint) override;

  /// Whether a run can go on with the record.
  [[nodiscard]] bool can_go_on() const { return kept_; }
  /// Stores the rest of the record.
  void store();
  /// Removes the checkpoint, because the answer is written too.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void open();
  void flush();
  void write_checkpoint(const std::string& text);

  std::string path_;
  std::string checkpoint_path_;
  std::optional<std::string> checkpoint_;
  int file_ = -1;
  std::uint64_t size_ = 0;  ///< bytes in the file
  std::string waiting_;     ///< bytes that follow
  bool kept_ = false;
  Clock::time_point next_ = {};
};

}  // namespace strainwave::cli
