// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// A reader of XML for tests.  It is strict about the rules that documents must keep, and ignores
// everything else.

namespace strainwave::test {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< text of this element and all elements below, with entities unchanged

  [[nodiscard]] const std::string& at(const std::string& attribute) const {
    const auto found = attributes.find(attribute);
    if (found == attributes.end()) throw std::runtime_error(name + " has no " + attribute);
    return found->second;
  }
  [[nodiscard]] bool has(const std::string& attribute) const {
    return attributes.contains(attribute);
  }
};

/// All elements in the order of their begin.
/// @throws std::runtime_error  if tags do not balance, an attribute is not quoted, an entity is not
///                             one of the five or a bare `<` or `&` stands in text
inline std::vector<Element> parse_xml(std::string_view text) {
  const auto fail = [&](const std::string& why, std::size_t at) {
    throw std::runtime_error(why + " near: " + std::string(text.substr(at, 80)));
  };
  std::vector<Element> elements;
  std::vector<std::size_t> open;
  std::size_t at = 0;
  const auto check_text = [&](std::string_view part) {
    for (std::size_t i = part.find('&'); i != std::string_view::npos; i = part.find('&', i + 1)) {
      const std::string_view rest = part.substr(i);
      const auto is = [&](std::string_view entity) { return rest.starts_with(entity); };
      if (!is("&amp;") && !is("&lt;") && !is("&gt;") && !is("&quot;") && !is("&#39;"))
        throw std::runtime_error("not an entity: " + std::string(rest.substr(0, 20)));
    }
    for (const char c : part)
      if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
        throw std::runtime_error("control character");
  };
  while (at < text.size()) {
    const std::size_t tag = std::min(text.find('<', at), text.size());
    const std::string_view content = text.substr(at, tag - at);
    check_text(content);
    for (const std::size_t i : open) elements[i].text += content;
    at = tag;
    if (at == text.size()) break;
    const std::size_t end = text.find('>', at);
    if (end == std::string_view::npos) fail("tag without end", at);
    std::string_view inside = text.substr(at + 1, end - at - 1);
    if (inside.starts_with("!DOCTYPE")) {
      at = end + 1;
      continue;
    }
    if (inside.starts_with('/')) {
      if (open.empty() || elements[open.back()].name != inside.substr(1)) fail("wrong end tag", at);
      open.pop_back();
      at = end + 1;
      continue;
    }
    const bool empty = inside.ends_with('/');
    if (empty) inside.remove_suffix(1);
    Element element;
    const std::size_t name = std::min(inside.find_first_of(" \n"), inside.size());
    element.name = inside.substr(0, name);
    inside.remove_prefix(name);
    while (inside.find_first_not_of(" \n") != std::string_view::npos) {
      inside.remove_prefix(inside.find_first_not_of(" \n"));
      const std::size_t equals = inside.find("=\"");
      if (equals == std::string_view::npos) fail("attribute without value", at);
      const std::size_t close = inside.find('"', equals + 2);
      if (close == std::string_view::npos) fail("attribute without end", at);
      const std::string key(inside.substr(0, equals));
      const std::string_view value = inside.substr(equals + 2, close - equals - 2);
      check_text(value);
      if (!element.attributes.emplace(key, value).second) fail("attribute twice", at);
      inside.remove_prefix(close + 1);
    }
    elements.push_back(element);
    if (!empty) open.push_back(elements.size() - 1);
    at = end + 1;
  }
  if (!open.empty()) throw std::runtime_error("not closed: " + elements[open.back()].name);
  return elements;
}

struct Box {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
};

/// Extent of a path of M and L with absolute coordinates "M1 2L3 4Z".
inline Box box_of(const std::string& d) {
  Box box;
  std::size_t at = 0;
  while (at < d.size()) {
    if (d[at] == 'Z') break;
    if (d[at] != 'M' && d[at] != 'L') throw std::runtime_error("not a path of M and L: " + d);
    std::size_t used = 0;
    const double x = std::stod(d.substr(at + 1), &used);
    at += 1 + used;
    const double y = std::stod(d.substr(at), &used);
    at += used;
    box.left = std::min(box.left, x);
    box.right = std::max(box.right, x);
    box.top = std::min(box.top, y);
    box.bottom = std::max(box.bottom, y);
  }
  return box;
}

}  // namespace strainwave::test
