// Between a picture as its file holds it and the texels that the device filters.
#pragma once

#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "samples/files/picture.h"

namespace boxcar {

// Light in, light out: how values in files become values that are filtered.
enum class Transfer {
    Srgb,  // 8 and 16-bit files hold sRGB codes and straight alpha, float files linear light and colors times alpha
    Raw,   // values as they stand
};

// RGBA texels of what is filtered, rows from the top. Under Srgb: linear light, colors times alpha. (Float files
// hold that already, by the convention of EXR.) Channels that the picture does not have are 0.
std::vector<glm::vec4> ToLight(const Picture& picture, Transfer transfer);

// The picture that `texels` are to be in a file with samples of `sampleType`. Under Srgb, integers hold sRGB codes
// and colors not multiplied by alpha; floats hold the texels as they are. In integers a texel that is not finite
// becomes magenta, in gray pictures white. The color space is that of `like`, under Srgb without its gamma.
Picture FromLight(const std::vector<glm::vec4>& texels, const Picture& like, Transfer transfer,
                  SampleType sampleType);

// Whether no channel is NaN or infinite.
bool IsFinite(const glm::vec4& texel);

// Throws Error, which begins with `name`, where sums of floats have overflowed.
void RequireFiniteSums(const std::vector<glm::vec4>& texels, const std::string& name);

}  // namespace boxcar
