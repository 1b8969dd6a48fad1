// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/chart/chart.hpp"

/// @file
/// A chart as a part of an animated SVG document.

namespace strainwave {

/// The clock of an animation by SMIL: rounds of equal length, which repeat without end.
struct Rounds {
  double seconds{};  ///< time of a round [s]; > 0
  /// Share of a round at which the animation starts [-]; in [0, 1).  Viewers that cannot animate
  /// show this moment.
  double start{};

  /// The attributes of an animation element that all animations of a document share.
  /// @param later  share of a round by which the animation lags [-]
  [[nodiscard]] std::string attributes(double later = 0) const;
};

/// A line that moves along the x axis, with a disc on each series.
struct MovingCursor {
  double from{};  ///< x at the beginning of a round
  double to{};    ///< x at its end
  Rounds rounds;
};

/// A place in the document around a chart [px].
struct PlotPlace {
  double x{};
  double y{};
  double width{};
};

/// Height of a panel that is `width` wide [px].
[[nodiscard]] double panel_height(double width);

/// One panel with a moving cursor, as an SVG element for another document.  A series gets a disc if
/// it is drawn without gaps from `from` to `to`, with x ascending.
[[nodiscard]] std::string moving_plot(const PlotPanel& panel, const MovingCursor& cursor,
                                      const PlotPlace& place);

}  // namespace strainwave
