#include "samples/files/orientation.h"

#include <libexif/exif-data.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "samples/files/codecs.h"

namespace boxcar {

int ExifOrientation(ByteView exif) {
    const auto bytes = static_cast<unsigned>(std::min<size_t>(exif.size(), std::numeric_limits<unsigned>::max()));
    const std::unique_ptr<ExifData, decltype(&exif_data_unref)> data(exif_data_new_from_data(exif.data(), bytes),
                                                                     &exif_data_unref);
    if (!data) return 1;
    const ExifEntry* entry = exif_content_get_entry(data->ifd[EXIF_IFD_0], EXIF_TAG_ORIENTATION);
    if (entry == nullptr || entry->format != EXIF_FORMAT_SHORT || entry->size < 2) return 1;
    const int orientation = exif_get_short(entry->data, exif_data_get_byte_order(data.get()));
    return orientation >= 1 && orientation <= 8 ? orientation : 1;
}

// Exif 2.32, sect. 4.6.4.A: the orientation says at which edges of the scene the first row and the first column lie.
Picture Upright(Picture stored, int orientation) {
    if (orientation == 1) return stored;
    const bool swapAxes = orientation >= 5;
    const bool flipX = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool flipY = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;

    Picture upright =
        MakePicture(swapAxes ? stored.heightTexels : stored.widthTexels,
                    swapAxes ? stored.widthTexels : stored.heightTexels, stored.channels, stored.stored);
    upright.colorSpace = std::move(stored.colorSpace);
    upright.notes = std::move(stored.notes);
    auto to = upright.samples.begin();
    for (uint32_t y = 0; y < upright.heightTexels; ++y) {
        for (uint32_t x = 0; x < upright.widthTexels; ++x) {
            const uint32_t alongX = swapAxes ? y : x;
            const uint32_t alongY = swapAxes ? x : y;
            const size_t column = flipX ? stored.widthTexels - 1 - alongX : alongX;
            const size_t row = flipY ? stored.heightTexels - 1 - alongY : alongY;
            to = std::copy_n(&stored.samples[(row * stored.widthTexels + column) * stored.channels], stored.channels,
                             to);
        }
    }
    return upright;
}

}  // namespace boxcar
