// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "strainwave/command/command.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::test {

/// A record that is kept in memory, with a checkpoint after every so many bytes.
class KeptRecording : public Recording {
 public:
  explicit KeptRecording(std::string name, std::uint64_t every = 10'000)
      : name_(std::move(name)), every_(every) {}

  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] std::optional<std::string> checkpoint() const override { return kept; }
  void begin(const std::string& checkpoint) override {
    kept = checkpoint;
    bytes.clear();
  }
  void go_on(std::uint64_t size) override {
    if (bytes.size() < size) throw InputError(name_, "is shorter than its checkpoint says");
    bytes.resize(size);
    last_ = size;
  }
  void append(std::string_view more) override { bytes += more; }
  [[nodiscard]] std::uint64_t size() const override { return bytes.size(); }
  [[nodiscard]] bool due() override { return bytes.size() >= last_ + every_; }
  void keep(const std::string& checkpoint) override {
    kept = checkpoint;
    last_ = bytes.size();
  }

  std::optional<std::string> kept = {};
  std::string bytes = {};

 private:
  std::string name_;
  std::uint64_t every_;
  std::uint64_t last_ = 0;
};

}  // namespace strainwave::test
