#include "samples/cli/gallery_page.h"

#include <fmt/format.h>

#include "samples/files/bytes.h"

namespace boxcar {
namespace {

constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Boxcar gallery</title>
<style>
  :root { color-scheme: light dark; }
  body { font: 16px/1.5 system-ui, sans-serif; max-width: 1200px; margin: 2rem auto; padding: 0 1rem; }
  section { margin: 3rem 0; }
  h2 { margin-bottom: 0; }
  .paper { opacity: .7; margin: 0 0 .5rem; }
  .figures { display: flex; flex-wrap: wrap; gap: 1rem; align-items: flex-start; }
  figure { margin: 0; max-width: 100%; flex: 0 1 auto; }
  .figures img { max-width: 100%; display: block; }
  figcaption { max-width: 34rem; padding-top: .3rem; }
  table { border-collapse: collapse; }
  td { border: 1px solid; width: 2.4em; height: 2.4em; text-align: center; font-variant-numeric: tabular-nums; }
</style>
</head>
<body>
<h1>Boxcar gallery</h1>
<p>Summed-area tables: sum a picture once, then blur it by any width at one cost. Every picture here went through HLSL
shaders, compiled by <code>bxc</code> and run by Vulkan. Open one to see it at full size.</p>
)";

std::string Escaped(const std::string& text) {
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '&': html += "&amp;"; break;
            case '<': html += "&lt;"; break;
            case '>': html += "&gt;"; break;
            case '"': html += "&quot;"; break;
            default: html += c;
        }
    }
    return html;
}

std::string GridHtml(const NumberGrid& grid) {
    std::string html = "<figure><table>";
    for (const auto& row : grid.rows) {
        html += "<tr>";
        for (const float value : row)
            html += fmt::format("<td>{:g}</td>", value);
        html += "</tr>";
    }
    return html + fmt::format("</table><figcaption>{}</figcaption></figure>\n", Escaped(grid.caption));
}

std::string FigureHtml(const Figure& figure) {
    const std::string file = Escaped(figure.file);
    const std::string caption = Escaped(figure.caption);
    return fmt::format(
        "<figure><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a><figcaption>{1}</figcaption></figure>\n", file,
        caption);
}

}  // namespace

Figure SaveFigure(const std::filesystem::path& folder, const std::string& file, const Picture& picture,
                  const std::string& caption) {
    WritePicture(picture, (folder / file).string(), FileFormat::Png, SampleType::Unorm8);
    return {file, caption};
}

Figure SaveFigure(const std::filesystem::path& folder, const std::string& file, const Plot& plot,
                  const std::string& caption) {
    const std::string svg = PlotSvg(plot);
    WriteFileAtomically((folder / file).string(), {reinterpret_cast<const uint8_t*>(svg.data()), svg.size()});
    return {file, caption};
}

std::string GalleryPage(const std::vector<GallerySection>& sections, const std::string& madeBy) {
    std::string html = kHead;
    for (const GallerySection& section : sections) {
        html += fmt::format("<section>\n<h2>{}</h2>\n<p class=\"paper\">{}</p>\n<p>{}</p>\n<div class=\"figures\">\n",
                            Escaped(section.title), Escaped(section.paper), Escaped(section.text));
        for (const NumberGrid& grid : section.grids)
            html += GridHtml(grid);
        for (const Figure& figure : section.figures)
            html += FigureHtml(figure);
        html += "</div>\n</section>\n";
    }
    return html + fmt::format("<p class=\"paper\">Made on {}.</p>\n</body>\n</html>\n", Escaped(madeBy));
}

}  // namespace boxcar
