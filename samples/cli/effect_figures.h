// The gallery's pages on the effects.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "samples/cli/gallery_page.h"

namespace boxcar {

class Device;

// Writes a picture of each figure, `size` (WxH) large, into `folder` and appends their sections. Captions tell the
// time of a frame on this device and what a pixel of the effect reads. Throws UsageError: not a size.
void AddEffectSections(Device& device, const std::filesystem::path& folder, const std::string& size,
                       std::vector<GallerySection>& sections);

}  // namespace boxcar
