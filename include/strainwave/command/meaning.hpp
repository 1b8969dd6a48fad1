// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace strainwave {

/// One meaning of a word.
struct Meaning {
  std::string kind;  ///< "field of the input"
  std::string name;
  std::string text;
  std::string more;  ///< the command that tells more; empty: none

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"kind", "", "what the word names"}, &Meaning::kind);
    field({"name", "", "in full"}, &Meaning::name);
    field({"text", "", "what it means"}, &Meaning::text);
    field({"more", "", "the command that tells more; empty: none"}, &Meaning::more);
  }
};

}  // namespace strainwave
