// What a picture of depth holds, in its own units, and its way to disparities for the lens.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "runtime/device.h"
#include "samples/files/picture.h"

namespace boxcar {

struct DepthOptions {
    std::string path;
    std::string isWord = "disparity";  // or "distance"
    std::string scaleText;             // empty: of the kind of file
    std::vector<std::string> unknownWords;
    std::string focusText;
};
void AddDepthOptions(CLI::App& command, DepthOptions& options);

// For Lens: what is in focus and how far the rest is from it.
struct DepthMap {
    std::vector<float> disparity;  // of every texel; of distances: the distance in focus over the texel's
    float focusDisparity = 0;      // of distances: 1
};

// Reads the depth that goes with `picture`, texel for texel; unknown values become the nearest known (FillUnknown).
// Throws UsageError: the words of a flag, or a focus that the file cannot have. Throws Error: another size, nothing
// known, or a value that says nothing and is not among the unknown ones.
DepthMap ReadDepth(const DepthOptions& options, const Picture& picture, const Device& device);

// Throws UsageError where it is known before any file is read that ReadDepth would.
void RequireWords(const DepthOptions& options);

}  // namespace boxcar
