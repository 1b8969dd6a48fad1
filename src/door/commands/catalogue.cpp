// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/catalogue.hpp"

#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct CatalogueOptions {
  std::optional<int> size;
  std::optional<double> ratio;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"size", "", "only this size"}, &CatalogueOptions::size);
    field({"ratio", "1", "only this ratio, or its class"}, &CatalogueOptions::ratio);
  }
};

}  // namespace

Command catalogue_command() {
  return command<CatalogueOptions, CatalogueRows>({
      .name = "catalogue",
      .summary = "Print makers' data: K1, K2, K3 and torques",
      .description =
          "Prints the stiffness tables of the makers' catalogues, 35 rows of size and ratio, and "
          "36 rows of ratings, each with its source. --ratio selects the class of the stiffness "
          "table (30, 50, or 80 and more) and the exact ratio of the ratings.",
      .example = "strainwave catalogue --size 25 --ratio 100",
      .takes = Takes::nothing,
      .function =
          [](const Request&, const CatalogueOptions& o) {
            return from_option([&] { return catalogue_rows({.size = o.size, .ratio = o.ratio}); });
          },
      .documents = {{Format::text, catalogue_text}, {Format::csv, catalogue_csv}},
  });
}

}  // namespace strainwave
