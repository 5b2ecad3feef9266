// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/plot.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <iterator>
#include <optional>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/process/find_program.h"
#include "eval/report/violin.h"

extern char** environ;

namespace hydrabench {
namespace {

/// Colours that stay apart for the colour-blind (Okabe and Ito 2008), in an order in which
/// neighbours differ in brightness, too.
struct Style {
  const char* color;
  const char* dash;
  int marker;  ///< gnuplot's point type
};
constexpr Style kStyles[] = {
    {"#0072b2", "solid", 7},          {"#d55e00", "(12,5)", 5}, {"#009e73", "(3,3)", 9},
    {"#000000", "(12,4,3,4)", 13},    {"#cc79a7", "(7,4)", 11}, {"#e69f00", "(3,5)", 15},
    {"#56b4e9", "(16,4,3,4,3,4)", 6}, {"#7f7f7f", "(9,3)", 4},
};

constexpr int kPanelWidth = 360;  // [px] at 96 dpi, as gnuplot counts them for SVG
constexpr int kPanelHeight = 300;
constexpr int kAxisName = 50;  // height of what stands below a panel
constexpr int kLegendRow = 20;
constexpr int kCurvesPerRow = 4;
constexpr int kLegendSample = 50;      // width of what stands before a name
constexpr int kLegendLetter = 9;       // as gnuplot reckons
constexpr int kViolinWidth = 62;       // at least, of each; panels get wider for it
constexpr int kViolinNames = 100;      // height of their names, which stand at a slant
constexpr double kViolinShare = 0.42;  // of its room that a violin takes to each side

const Style& styleOf(std::size_t curve) { return kStyles[curve % std::size(kStyles)]; }

/// In gnuplot's double quotes, without its markup.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (std::string("_^{}@&~").find(c) != std::string::npos) out += "\\\\";
    out += c == '\n' ? ' ' : c;
  }
  return out + "\"";
}

/// Data of all curves as named blocks.
void writeData(const Plot& plot, std::string& script) {
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const PlotPanel& panel = plot.panels[p];
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
      const PlotCurve& curve = panel.curves[c];
      script += fmt::format("$curve_{}_{} << EOD\n", p, c);
      for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const Eigen::Vector2d& point = curve.points[i];
        // A step still has the value before it: up first, then along.
        if (curve.steps && i > 0) {
          script += fmt::format("{:.9g} {:.9g}\n", point.x(), curve.points[i - 1].y());
        }
        script += fmt::format("{:.9g} {:.9g}\n", point.x(), point.y());
      }
      if (curve.steps && !curve.points.empty()) {
        script += fmt::format("{:.9g} {:.9g}\n", curve.end.value_or(panel.x_range.y()),
                              curve.points.back().y());
      }
      script += "EOD\n";
      if (curve.band.empty()) continue;
      script += fmt::format("$band_{}_{} << EOD\n", p, c);
      for (const PlotCurve::Band& band : curve.band) {
        script += fmt::format("{:.9g} {:.9g} {:.9g}\n", band.x, band.low, band.high);
      }
      script += "EOD\n";
    }
  }
}

/// Where a curve is at x; nullopt outside its points.
std::optional<double> valueAt(const PlotCurve& curve, double x) {
  if (curve.end && x > *curve.end) return std::nullopt;
  std::size_t after = 0;
  while (after < curve.points.size() && curve.points[after].x() < x) ++after;
  if (after == 0) return std::nullopt;
  const Eigen::Vector2d& a = curve.points[after - 1];
  if (curve.steps) return a.y();
  if (after == curve.points.size()) return std::nullopt;
  const Eigen::Vector2d& b = curve.points[after];
  return a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
}

/// Markers at even distances along x, where the points of a step function lie in lumps, and each
/// curve's between those of the others.
void writeMarkers(const Plot& plot, std::string& script) {
  constexpr int kMarkers = 6;
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const PlotPanel& panel = plot.panels[p];
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
      script += fmt::format("$markers_{}_{} << EOD\n", p, c);
      const PlotCurve& curve = panel.curves[c];
      for (int i = 0; i < kMarkers && !curve.points.empty(); ++i) {
        const double share =
            (i + (0.5 + static_cast<double>(c)) / static_cast<double>(panel.curves.size())) /
            kMarkers;
        const double x = panel.x_range.x() + share * (panel.x_range.y() - panel.x_range.x());
        if (const auto y = valueAt(curve, x)) script += fmt::format("{:.9g} {:.9g}\n", x, *y);
      }
      script += "EOD\n";
    }
  }
}

/// Outlines, bars and medians of violins as named blocks.
void writeViolins(const Plot& plot, std::string& script) {
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const PlotPanel& panel = plot.panels[p];
    for (std::size_t v = 0; v < panel.violins.size(); ++v) {
      const auto shape = violinShape(panel.violins[v].values, panel.log_y);
      if (!shape) continue;
      const auto center = static_cast<double>(v + 1);
      script += fmt::format("$violin_{}_{} << EOD\n", p, v);
      const auto corner = [&](const ViolinShape::Width& at, double side) {
        script += fmt::format("{:.6g} {:.6g}\n", center + side * at.width, at.value);
      };
      for (auto at = shape->outline.begin(); at != shape->outline.end(); ++at) {
        corner(*at, kViolinShare);
      }
      for (auto at = shape->outline.rbegin(); at != shape->outline.rend(); ++at) {
        corner(*at, -kViolinShare);
      }
      script += fmt::format(
          "EOD\n$bar_{0}_{1} << EOD\n{2} {3:.6g}\n{2} {4:.6g}\nEOD\n"
          "$median_{0}_{1} << EOD\n{2} {5:.6g}\nEOD\n",
          p, v, center, shape->p25, shape->p75, shape->median);
    }
  }
}

/// How many columns of names fit beside each other.
int legendColumns(const Plot& plot, int width) {
  std::size_t longest = 0;
  for (const PlotCurve& curve : plot.panels.front().curves) {
    longest = std::max(longest, curve.label.size());
  }
  const int column = kLegendSample + kLegendLetter * static_cast<int>(longest);
  return std::clamp(width / column, 1, kCurvesPerRow);
}

/// Curves below each other in columns, in a strip above the panels that nothing else is drawn in.
void writeLegend(const Plot& plot, double bottom, int columns, std::string& script) {
  script += fmt::format(
      "set lmargin at screen 0.02\nset rmargin at screen 0.98\nset bmargin at screen {:.4f}\n"
      "set tmargin at screen 0.99\nunset title\nunset xlabel\nunset ylabel\nunset arrow\n"
      "unset label\nunset logscale y\nunset border\nunset tics\nunset grid\nset xrange [0:1]\nset "
      "yrange [0:1]\n"
      "set key center center horizontal maxcols {} Left reverse samplen 3.4 spacing 1.15 width 1\n",
      bottom, columns);
  const std::vector<PlotCurve>& curves = plot.panels.front().curves;
  if (!curves.empty()) script += "plot ";
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const Style& style = styleOf(c);
    script += fmt::format("2 with linespoints lc rgb '{}' lw 2 dt {} pt {} ps 0.7 title {}{}",
                          style.color, style.dash, style.marker, quoted(curves[c].label),
                          c + 1 == curves.size() ? "\n" : ", \\\n  ");
  }
  script +=
      "unset key\nset border 3 lw 1\nset xtics nomirror out scale 0.6\nset ytics nomirror out "
      "scale 0.6\n"
      "set grid back lc rgb '#c4c4c4' lw 0.6 dt solid\n";
}

bool hasViolins(const Plot& plot) {
  return std::any_of(plot.panels.begin(), plot.panels.end(),
                     [](const PlotPanel& panel) { return !panel.violins.empty(); });
}

/// The axes of violins, the names below them and what stands where there is none.
void writeViolinAxes(const PlotPanel& panel, std::string& script) {
  script += fmt::format("set xrange [0.4:{:g}]\nset xtics (",
                        static_cast<double>(panel.violins.size()) + 0.6);
  for (std::size_t v = 0; v < panel.violins.size(); ++v) {
    script += fmt::format("{}{} {}", v == 0 ? "" : ", ", quoted(panel.violins[v].label), v + 1);
  }
  script += ") rotate by 25 right\n";
  for (std::size_t v = 0; v < panel.violins.size(); ++v) {
    if (!panel.violins[v].values.empty()) continue;
    script += fmt::format(
        "set label \"not available\" at {}, graph 0.05 rotate by 90 left textcolor rgb '#606060'\n",
        v + 1);
  }
}

/// gnuplot needs something to plot.
void plotViolins(const PlotPanel& panel, std::size_t p, std::string& script) {
  script += "plot NaN notitle";
  for (std::size_t v = 0; v < panel.violins.size(); ++v) {
    if (panel.violins[v].values.empty()) continue;
    script += fmt::format(
        ", \\\n  $violin_{0}_{1} using 1:2 with filledcurves closed fc rgb '{2}' fs transparent "
        "solid 0.35 border lc rgb '{2}' lw 1.2 notitle, \\\n  "
        "$bar_{0}_{1} using 1:2 with lines lc rgb '#202020' lw 4 dt solid notitle, \\\n  "
        "$median_{0}_{1} using 1:2 with points lc rgb 'white' pt 7 ps 0.4 notitle",
        p, v, styleOf(v).color);
  }
  script += "\n";
}

void writePanel(const Plot& plot, std::size_t p, double bottom, double top, std::string& script) {
  const PlotPanel& panel = plot.panels[p];
  const auto count = static_cast<double>(plot.panels.size());
  const auto index = static_cast<double>(p);
  script += fmt::format("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n",
                        (index + (panel.log_y ? 0.19 : 0.16)) / count, (index + 0.965) / count);
  script +=
      fmt::format("set bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\n", bottom, top);
  script += fmt::format("set xlabel {} offset 0,0.4\nset ylabel {} offset {},0\n",
                        quoted(panel.x_label), quoted(panel.y_label), panel.log_y ? "0.2" : "1.0");
  script += panel.title.empty() ? "unset title\n"
                                : fmt::format("set title {} offset 0,-0.5\n", quoted(panel.title));
  script += fmt::format("set xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\n", panel.x_range.x(),
                        panel.x_range.y(), panel.y_range.x(), panel.y_range.y());
  if (hasViolins(plot)) script += "set xtics autofreq norotate\n";
  script += panel.log_y ? "set logscale y\nset format y \"10^{%T}\"\n"
                        : "unset logscale y\nset format y\n";
  script += "unset arrow\nunset label\n";
  for (const PlotPanel::Mark& mark : panel.marks) {
    script += fmt::format(
        "set arrow from {0:g}, graph 0 to {0:g}, graph 1 nohead lc rgb '#606060' lw 1 dt (2,3) "
        "back\n"
        "set label {1} at {0:g}, graph 0.04 offset 0.6,0 left textcolor rgb '#404040' "
        "front\n",
        mark.x, quoted(mark.label));
  }
  if (!panel.violins.empty()) {
    writeViolinAxes(panel, script);
    plotViolins(panel, p, script);
    return;
  }
  script += "plot ";
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    if (panel.curves[c].band.empty()) continue;
    script += fmt::format(
        "$band_{}_{} using 1:2:3 with filledcurves fs transparent solid 0.13 "
        "noborder lc rgb '{}' notitle, \\\n  ",
        p, c, styleOf(c).color);
  }
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Style& style = styleOf(c);
    script += fmt::format(
        "$curve_{0}_{1} using 1:2 with lines lc rgb '{2}' lw 2 dt {3} notitle, \\\n  "
        "$markers_{0}_{1} using 1:2 with points lc rgb '{2}' pt {4} ps 0.7 notitle{5}",
        p, c, style.color, style.dash, style.marker,
        c + 1 == panel.curves.size() ? "\n" : ", \\\n  ");
  }
}

/// Runs `gnuplot file` in a folder; its exit status, what it says in `log`.
int runGnuplot(const std::string& program, const std::filesystem::path& folder,
               const std::string& file, const std::string& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::string name = "gnuplot";
  std::string argument = file;
  char* const arguments[] = {name.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return -1;
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return -1;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

bool canPlot() { return !findProgram("gnuplot").empty(); }

std::string gnuplotScript(const Plot& plot, const std::string& name) {
  const auto panels = static_cast<int>(plot.panels.size());
  std::size_t curves = 0;
  for (const PlotPanel& panel : plot.panels) curves = std::max(curves, panel.curves.size());
  int panel_width = kPanelWidth;
  for (const PlotPanel& panel : plot.panels) {
    panel_width = std::max(panel_width, kViolinWidth * static_cast<int>(panel.violins.size()));
  }
  const int width = panels * panel_width;
  const int columns = legendColumns(plot, width);
  const int legend_rows = (static_cast<int>(curves) + columns - 1) / columns;
  const int legend = legend_rows * kLegendRow + 12;
  const int below = hasViolins(plot) ? kViolinNames : kAxisName;
  const int height = kPanelHeight + legend + below - kAxisName;
  const bool titles = !plot.panels.front().title.empty();
  const double legend_bottom = 1 - static_cast<double>(legend) / height;
  const double top = legend_bottom - (titles ? 26.0 : 4.0) / height;
  const double bottom = static_cast<double>(below) / height;

  std::string script = fmt::format("# gnuplot {}.gp draws {}.png and {}.svg\n", name, name, name);
  writeData(plot, script);
  writeMarkers(plot, script);
  writeViolins(plot, script);
  script += "set encoding utf8\n";
  const auto draw = [&](const std::string& terminal, const std::string& file) {
    script += fmt::format("set terminal {}\nset output '{}'\nset multiplot\n", terminal, file);
    writeLegend(plot, legend_bottom, columns, script);
    for (std::size_t p = 0; p < plot.panels.size(); ++p) writePanel(plot, p, bottom, top, script);
    script += "unset multiplot\nunset output\n";
  };
  // Twice the pixels at the same proportions: 200 dpi.
  draw(fmt::format("pngcairo size {},{} font 'DejaVu Sans,10' fontscale 2 linewidth 2 pointscale 2 "
                   "dashlength 1.6 background rgb 'white'",
                   2 * width, 2 * height),
       name + ".png");
  draw(fmt::format("svg size {},{} dynamic font 'DejaVu Sans,10' dashlength 0.8 background rgb "
                   "'white'",
                   width, height),
       name + ".svg");
  return script;
}

std::string drawPlot(const Plot& plot, const std::filesystem::path& folder,
                     const std::string& name) {
  if (plot.panels.empty()) return "";
  const std::string script = name + ".gp";
  writeFileAtomic(folder / script, gnuplotScript(plot, name));
  const std::string program = findProgram("gnuplot");
  if (program.empty()) {
    return fmt::format(
        "{}: not drawn, gnuplot is not installed (Debian: gnuplot-nox); later: "
        "'gnuplot {}' there",
        script, script);
  }
  const std::string log = name + ".log";
  const int status = runGnuplot(program, folder, script, log);
  std::string said = std::filesystem::exists(folder / log) ? readFile(folder / log) : "";
  if (status == 0) {
    std::filesystem::remove(folder / log);
    return "";
  }
  while (!said.empty() && (said.back() == '\n' || said.back() == ' ')) said.pop_back();
  return fmt::format("{}: gnuplot failed (exit {}), see {}: {}", script, status, log,
                     said.substr(said.rfind('\n') + 1));
}

}  // namespace hydrabench
