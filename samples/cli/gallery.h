// boxcar gallery: the papers' figures as pictures, on a page.
#pragma once

#include <CLI/CLI.hpp>

namespace boxcar {

void AddGalleryCommand(CLI::App& app);

}  // namespace boxcar
