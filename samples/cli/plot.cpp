#include "samples/cli/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace boxcar {
namespace {

// Okabe and Ito's colors: blue, vermilion, bluish green, orange, black.
constexpr const char* kColors[] = {"#0072b2", "#d55e00", "#009e73", "#e69f00", "#000000"};

constexpr double kWidth = 900, kHeight = 480;
constexpr double kLeft = 90, kRight = 610, kTop = 50, kBottom = 410;
constexpr double kLegend = 640, kLegendStep = 26;

// A value on an axis to its place in the picture.
struct Axis {
    double low, high;  // log10 of the value on a logarithmic axis
    double atLow, atHigh;
    bool log;

    double Place(double value) const {
        const double v = log ? std::log10(value) : value;
        return atLow + (v - low) / (high - low) * (atHigh - atLow);
    }
};

bool Drawn(const Plot& plot, const std::pair<double, double>& point) {
    return std::isfinite(point.second) && (!plot.yLog || point.second > 0);
}

Axis YAxis(const Plot& plot) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Curve& curve : plot.curves) {
        for (const auto& point : curve.points) {
            if (!Drawn(plot, point)) continue;
            low = std::min(low, plot.yLog ? std::log10(point.second) : point.second / plot.yStep);
            high = std::max(high, plot.yLog ? std::log10(point.second) : point.second / plot.yStep);
        }
    }
    const double unit = plot.yLog ? 1 : plot.yStep;
    return {unit * std::floor(low), unit * std::max(std::ceil(high), std::floor(low) + 1), kBottom, kTop, plot.yLog};
}

std::string Escaped(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&': escaped += "&amp;"; break;
            case '<': escaped += "&lt;"; break;
            case '>': escaped += "&gt;"; break;
            case '"': escaped += "&quot;"; break;
            default: escaped += c;
        }
    }
    return escaped;
}

std::string Text(double x, double y, const char* anchor, const std::string& text, const char* more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                       Escaped(text));
}

std::string Line(double x0, double y0, double x1, double y1, const char* color, const char* more = "") {
    return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\"{}/>\n", x0, y0, x1, y1, color, more);
}

const char* Dashes(const Curve& curve) {
    return curve.dashed ? " stroke-width=\"2.5\" stroke-dasharray=\"7 5\"" : " stroke-width=\"2.5\"";
}

std::string CurveSvg(const Plot& plot, const Curve& curve, const Axis& x, const Axis& y) {
    std::string path, dots;
    bool broken = true;
    for (const auto& point : curve.points) {
        if (!Drawn(plot, point)) {
            broken = true;
            continue;
        }
        const double px = x.Place(point.first), py = y.Place(point.second);
        path += fmt::format("{}{:.1f} {:.1f}", broken ? "M" : "L", px, py);
        if (curve.dotted)
            dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n", px, py,
                                kColors[curve.color]);
        broken = false;
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\"{}/>\n", path, kColors[curve.color],
                       Dashes(curve)) +
           dots;
}

}  // namespace

std::string PlotSvg(const Plot& plot) {
    const double first = plot.xTicks.front(), last = plot.xTicks.back();
    const Axis x = plot.xLog ? Axis{std::log10(first), std::log10(last), kLeft, kRight, true}
                             : Axis{first, last, kLeft, kRight, false};
    const Axis y = YAxis(plot);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" font-size=\"15\" fill=\"#222\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
        kWidth, kHeight);
    svg += Text((kLeft + kRight) / 2, 30, "middle", plot.title, " font-size=\"17\" font-weight=\"bold\"");

    for (const double tick : plot.xTicks) {
        svg += Line(x.Place(tick), kTop, x.Place(tick), kBottom, "#ddd");
        svg += Text(x.Place(tick), kBottom + 22, "middle", fmt::format("{:g}", tick));
    }
    const double step = plot.yLog ? 1 : plot.yStep;
    for (double tick = std::round(y.low / step); tick <= y.high / step + 1e-9; tick++) {
        const double at = tick * step, value = plot.yLog ? std::pow(10.0, at) : at;
        svg += Line(kLeft, y.Place(value), kRight, y.Place(value), "#ddd");
        svg += Text(kLeft - 8, y.Place(value) + 5, "end",
                    plot.yLog ? fmt::format("1e{:g}", at) : fmt::format("{:g}", value));
    }
    svg += Line(kLeft, kBottom, kRight, kBottom, "#222") + Line(kLeft, kTop, kLeft, kBottom, "#222");
    svg += Text((kLeft + kRight) / 2, kBottom + 50, "middle", plot.xLabel);
    svg += fmt::format("<g transform=\"translate(22 {:.1f}) rotate(-90)\">", (kTop + kBottom) / 2) +
           Text(0, 0, "middle", plot.yLabel) + "</g>\n";

    double row = kTop + 10;
    for (const Curve& curve : plot.curves) {
        svg += CurveSvg(plot, curve, x, y);
        svg += Line(kLegend, row, kLegend + 38, row, kColors[curve.color], Dashes(curve));
        svg += Text(kLegend + 46, row + 5, "start", curve.label);
        row += kLegendStep;
    }
    for (const std::string& note : plot.notes) {
        svg += Text(kLegend, row + 14, "start", note, " font-size=\"13\"");
        row += 18;
    }
    return svg + "</svg>\n";
}

}  // namespace boxcar
