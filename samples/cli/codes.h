// Pictures as the whole numbers that an exact table sums.
//
//   8 and 16-bit files, raw   their own codes, 0..255 or 0..65535
//   8 and 16-bit files, srgb  linear light, colours times alpha, as round(65535 v)
//   float files               v 2^24 in two words: every half float is a multiple of 2^-24; others are rounded to one
#pragma once

#include <glm/ext/vector_uint4.hpp>
#include <vector>

#include "runtime/passes/sat_filter.h"
#include "samples/cli/device_run.h"
#include "samples/cli/options.h"
#include "samples/files/picture.h"

namespace boxcar {

enum class Rounding { Refuse, Allow };

// What the codes of a picture stand for. Throws Error, which begins with `name`: a float picture for U32; a sample of
// 65536 or more; with Rounding::Refuse a sample that is no multiple of 2^-24.
SATCodes CodesFor(const Picture& picture, const std::string& name, Transfer transfer, SATPrecision precision,
                  Rounding rounding = Rounding::Refuse);

// RGBA; channels that the picture does not have are 0. Two's complement.
struct CodeWords {
    std::vector<glm::uvec4> low;
    std::vector<glm::uvec4> high;  // empty for U32
};

// The codes of rows [firstRow, firstRow + rows), from the top.
CodeWords EncodeRows(const Picture& picture, Transfer transfer, SATPrecision precision, uint32_t firstRow,
                     uint32_t rows);

// The same on the device.
UploadedWords UploadCodes(Device& device, const Picture& picture, Transfer transfer, SATPrecision precision,
                          uint32_t firstRow, uint32_t rows);

}  // namespace boxcar
