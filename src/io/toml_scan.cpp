// SPDX-License-Identifier: Apache-2.0
#include "toml_scan.hpp"

#include <algorithm>
#include <map>

#include "strainwave/core/error.hpp"
#include "strainwave/core/toml_library.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kBlanks = " \t";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {
    if (text.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  TomlScan document() {
    scan_.sections.push_back({.path = {}, .line = {at_, at_}, .header = at_, .end = at_});
    for (skip_to_statement(); at_ < text_.size(); skip_to_statement()) {
      if (text_[at_] == '[')
        header();
      else
        entry();
    }
    for (TomlSection& section : scan_.sections) section.end = with_comments_below(section.end);
    return std::move(scan_);
  }

  TomlValue value() {
    skip_blanks();
    TomlValue value{.kind = {}, .span = {at_, at_}, .items = {}};
    const char c = peek();
    if (c == '[' || c == '{') {
      value.kind = c == '[' ? TomlValue::Kind::list : TomlValue::Kind::table;
      const char close = c == '[' ? ']' : '}';
      ++at_;
      for (skip_within_list(); peek() != close; skip_within_list()) {
        if (peek() == ',') {
          ++at_;
          continue;
        }
        value.items.push_back(c == '[' ? element() : key_and_value());
      }
      ++at_;
    } else if (c == '"' || c == '\'') {
      skip_string();
    } else {
      // A date may contain a blank before its time.
      at_ = std::min(text_.find_first_of(",]}#\r\n", at_), text_.size());
      while (at_ > value.span.begin && kBlanks.find(text_[at_ - 1]) != kBlanks.npos) --at_;
      if (at_ == value.span.begin) refuse();
    }
    value.span.end = at_;
    return value;
  }

 private:
  [[noreturn]] static void refuse() {
    throw InputError("text", "is TOML of a form that cannot be edited; write it more plainly");
  }

  [[nodiscard]] char peek() const {
    if (at_ >= text_.size()) refuse();
    return text_[at_];
  }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size()); }

  void skip_line() { at_ = line_at(text_, at_).end; }

  void skip_to_statement() {
    for (skip_blanks();
         at_ < text_.size() && (text_[at_] == '#' || text_[at_] == '\r' || text_[at_] == '\n');
         skip_blanks())
      skip_line();
  }

  void skip_within_list() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    while (at_ < text_.size() && text_[at_] == '#') {
      skip_line();
      at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    }
  }

  void skip_string() {
    const char quote = peek();
    const std::string three(3, quote);
    const bool long_form = text_.substr(at_).starts_with(three);
    for (at_ += long_form ? 3 : 1;; ++at_) {
      if (peek() == '\\' && quote == '"') {
        ++at_;
      } else if (long_form ? text_.substr(at_).starts_with(three) : peek() == quote) {
        at_ += long_form ? 3 : 1;
        // Up to two more quotes belong to a long string.
        for (int more = 0; long_form && more < 2 && at_ < text_.size() && text_[at_] == quote;
             ++more)
          ++at_;
        return;
      }
    }
  }

  std::vector<std::string> keys() {
    std::vector<std::string> keys;
    do {
      if (!keys.empty()) ++at_;
      skip_blanks();
      const std::size_t begin = at_;
      if (peek() == '"' || peek() == '\'') {
        skip_string();
        const toml::table key = toml::parse(std::string(text_.substr(begin, at_ - begin)) + "=0");
        keys.emplace_back(key.begin()->first.str());
      } else {
        at_ = std::min(text_.find_first_of(" \t.=]", at_), text_.size());
        keys.emplace_back(text_.substr(begin, at_ - begin));
      }
      skip_blanks();
    } while (peek() == '.');
    return keys;
  }

  TomlItem element() {
    TomlItem item;
    item.value = value();
    item.span = item.value.span;
    return item;
  }

  TomlItem key_and_value() {
    TomlItem item;
    item.span.begin = at_;
    item.keys = keys();
    if (peek() != '=') refuse();
    ++at_;
    item.value = value();
    item.span.end = at_;
    return item;
  }

  /// Only blanks and a comment may follow a statement on its line.
  std::size_t end_of_statement() {
    skip_blanks();
    if (at_ < text_.size() && std::string_view("#\r\n").find(text_[at_]) == std::string_view::npos)
      refuse();
    skip_line();
    return at_;
  }

  void header() {
    const std::size_t begin = line_at(text_, at_).begin;
    const bool element = text_.substr(at_).starts_with("[[");
    at_ += element ? 2 : 1;
    const std::vector<std::string> names = keys();
    if (!text_.substr(at_).starts_with(element ? "]]" : "]")) refuse();
    at_ += element ? 2 : 1;
    Steps path;
    for (std::size_t i = 0; i < names.size(); ++i) {
      path.push_back(key_step(names[i]));
      const bool last = i + 1 == names.size();
      if (last && element)
        path.push_back(index_step(counts_[path]++));
      else if (const auto found = counts_.find(path); found != counts_.end())
        path.push_back(index_step(found->second - 1));
    }
    const std::size_t brackets = at_;
    const std::size_t end = end_of_statement();
    scan_.sections.push_back(
        {.path = std::move(path), .line = {begin, end}, .header = brackets, .end = end});
  }

  void entry() {
    TomlEntry entry{.path = scan_.sections.back().path,
                    .section = scan_.sections.size() - 1,
                    .line = {line_at(text_, at_).begin, 0},
                    .item = key_and_value()};
    // A byte order mark does not belong to the first line.
    entry.line.begin = std::max(entry.line.begin, scan_.sections.front().line.begin);
    for (const std::string& key : entry.item.keys) entry.path.push_back(key_step(key));
    entry.line.end = scan_.sections.back().end = end_of_statement();
    scan_.entries.push_back(std::move(entry));
  }

  /// Comments directly below the last entry belong to it, unless a header follows at once.
  [[nodiscard]] std::size_t with_comments_below(std::size_t end) const {
    for (std::size_t at = end; at < text_.size();) {
      const Span line = line_at(text_, at);
      const std::string_view content = text_.substr(line.begin, line.end - line.begin);
      if (is_blank(content)) return at;
      if (!is_comment(content)) return end;
      at = line.end;
    }
    return text_.size();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  TomlScan scan_;
  std::map<Steps, std::size_t> counts_;  ///< elements of each array of tables so far
};

}  // namespace

TomlScan scan_toml(std::string_view text) { return Scanner(text).document(); }

TomlValue scan_toml_value(std::string_view text) { return Scanner(text).value(); }

Span line_at(std::string_view text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t end = text.find('\n', at);
  return {before == std::string_view::npos ? 0 : before + 1,
          end == std::string_view::npos ? text.size() : end + 1};
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

bool is_comment(std::string_view line) {
  const std::size_t first = line.find_first_not_of(kBlanks);
  return first != std::string_view::npos && line[first] == '#';
}

}  // namespace strainwave
