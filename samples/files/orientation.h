// Which way up a file holds its picture.
#pragma once

#include "samples/files/bytes.h"
#include "samples/files/picture.h"

namespace boxcar {

// The orientation that EXIF data give, 1 to 8 as EXIF counts them; 1, upright, where they give none.
//
//   exif  "Exif\0\0" and the TIFF structure, as in a JPEG's segment
int ExifOrientation(ByteView exif);

// `stored`, of that orientation in its file, turned upright.
Picture Upright(Picture stored, int orientation);

}  // namespace boxcar
