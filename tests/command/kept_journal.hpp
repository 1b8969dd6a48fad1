// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "strainwave/command/command.hpp"

namespace strainwave::test {

/// A journal that is kept in memory.
class KeptJournal : public Journal {
 public:
  [[nodiscard]] std::string name() const override { return "kept"; }
  [[nodiscard]] std::optional<std::string> text() const override { return text_; }
  void begin(const std::string& text) override { text_ = text; }
  void append(const std::string& line) override { *text_ += line; }

 private:
  std::optional<std::string> text_;
};

}  // namespace strainwave::test
