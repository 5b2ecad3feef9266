// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hydrabench {

/// One line of a plot. Curves are told apart by colour, dash pattern and marker, so that a print in
/// grey can be read.
struct PlotCurve {
  /// Where a confidence interval lies at one x.
  struct Band {
    double x = 0;
    double low = 0;
    double high = 0;
  };
  std::string label;
  std::vector<Eigen::Vector2d> points;  ///< x ascending
  /// A step function: points are where it changes, and at a point it still has the value before.
  bool steps = false;
  std::optional<double> end;  ///< where a step function stops; the end of the axis without it
  std::vector<Band> band;     ///< drawn as a light area; may be empty
};

/// A distribution: its density to both sides of a vertical line, from the least value to the
/// greatest, with a bar from p25 to p75 and a dot at the median (violin.h).
struct PlotViolin {
  std::string label;           ///< stands below it
  std::vector<double> values;  ///< none: said so in its place
};

struct PlotPanel {
  std::string title;
  std::string x_label;
  std::string y_label;
  Eigen::Vector2d x_range = {0, 1};
  Eigen::Vector2d y_range = {0, 1};
  std::vector<PlotCurve> curves;
  /// A vertical line with a word at its top, e.g. the setting in use.
  struct Mark {
    double x = 0;
    std::string label;
  };
  std::vector<Mark> marks;
  bool log_y = false;  ///< y_range and all values above 0
  /// Side by side, instead of curves; their names are the x axis.
  std::vector<PlotViolin> violins;
};

/// Panels side by side. Curve i of every panel has the style and the name of curve i of the first,
/// which stand once above the panels; violin i of every panel has the colour of curve i.
struct Plot {
  std::vector<PlotPanel> panels;
};

/// Whether gnuplot is there to draw. It is a program of its own, not a library: Debian package
/// gnuplot-nox.
bool canPlot();

/// What gnuplot is given: self-contained, data included.
std::string gnuplotScript(const Plot& plot, const std::string& name);

/// Writes NAME.gp into the folder, and NAME.png and NAME.svg where gnuplot is there. Returns an
/// empty text, or one line that says what is missing or went wrong: a picture is never worth a
/// result.
std::string drawPlot(const Plot& plot, const std::filesystem::path& folder,
                     const std::string& name);

}  // namespace hydrabench
