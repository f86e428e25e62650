// The gallery's page: one HTML file with its style inside, which loads nothing but the pictures beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "samples/cli/plot.h"
#include "samples/files/picture.h"

namespace boxcar {

struct Figure {
    std::string file;     // beside the page
    std::string caption;  // what is seen
};

// Numbers of a small table, row by row.
struct NumberGrid {
    std::string caption;
    std::vector<std::vector<float>> rows;
};

struct GallerySection {
    std::string title;
    std::string paper;  // which figure or section of which paper it shows
    std::string text;   // what to look for
    std::vector<NumberGrid> grids;
    std::vector<Figure> figures;
};

// Write a figure beside the page: 8-bit PNG, SVG.
Figure SaveFigure(const std::filesystem::path& folder, const std::string& file, const Picture& picture,
                  const std::string& caption);
Figure SaveFigure(const std::filesystem::path& folder, const std::string& file, const Plot& plot,
                  const std::string& caption);

// `madeBy`: the device, for the foot of the page.
std::string GalleryPage(const std::vector<GallerySection>& sections, const std::string& madeBy);

}  // namespace boxcar
