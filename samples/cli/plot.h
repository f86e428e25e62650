// Curves as one SVG file: axes, ticks, a legend to the right, colors that do not rest on telling red from green.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace boxcar {

struct Curve {
    std::string label;
    std::vector<std::pair<double, double>> points;  // a NaN or an infinity breaks the line
    int color = 0;                                  // 0 to 4
    bool dashed = false;
    bool dotted = true;  // a dot at each point
};

struct Plot {
    std::string title;
    std::string xLabel;
    std::string yLabel;
    std::vector<double> xTicks;      // at least two, ascending; the axis goes from the first to the last
    bool xLog = true;                // then ticks are above 0
    bool yLog = false;               // a tick a decade
    double yStep = 20;               // else: a tick a step
    std::vector<Curve> curves;       // with at least one finite point
    std::vector<std::string> notes;  // under the legend
};

std::string PlotSvg(const Plot& plot);

}  // namespace boxcar
