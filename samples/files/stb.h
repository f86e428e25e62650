// stb_image behind a guard: no read past the file's end goes unnoticed, no memory is left behind, none is taken that
// the header does not explain.
#pragma once

#include "samples/files/codecs.h"

namespace boxcar {

// Decodes PNG and JPEG (as Unorm8 or Unorm16) and HDR (as Float32), the sides as the caller has found them in the
// header and within the limits. Throws Error as DecodePng does.
Picture DecodeWithStb(ByteView file, FileFormat format, SampleType sampleType, uint64_t widthTexels,
                      uint64_t heightTexels);

}  // namespace boxcar
