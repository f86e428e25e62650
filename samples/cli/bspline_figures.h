// The gallery's page on third-order filters.
#pragma once

#include <filesystem>
#include <vector>

#include "samples/cli/gallery_page.h"
#include "samples/files/picture.h"

namespace boxcar {

class Device;

// Writes the pictures and plots into `folder` and appends their sections. `photograph`: 8 bits, RGB, at least 300 x
// 250 texels.
void AddBSplineSections(Device& device, const std::filesystem::path& folder, const Picture& photograph,
                        std::vector<GallerySection>& sections);

}  // namespace boxcar
