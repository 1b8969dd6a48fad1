// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace strainwave {

/// One meaning of a word.
struct Meaning {
  std::string kind;  ///< "field of the input"
  std::string name;
  std::string text;
  std::string more;  ///< the command that prints more; empty if there is none

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"kind", "", "the kind of thing that the word names"}, &Meaning::kind);
    field({"name", "", "the full name"}, &Meaning::name);
    field({"text", "", "the meaning of the word"}, &Meaning::text);
    field({"more", "", "the command that prints more; empty if there is none"}, &Meaning::more);
  }
};

}  // namespace strainwave
