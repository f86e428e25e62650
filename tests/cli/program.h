// Runs boxcar as a person would, in a folder of its own.
#pragma once

#include <filesystem>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "samples/files/picture.h"
#include "tests/reference/box.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace boxcar {

using Outcome = test::RunResult;

// A folder for one test, with boxcar to run in it.
class Folder : public test::TemporaryFolder {
public:
    // `boxcar ARGUMENTS` in this folder, through the shell, under the validation layer and on the test device where
    // it takes a device. `environment`: NAME=VALUE words in front. Ended after so many seconds (exit code 124).
    Outcome Run(const std::string& arguments, const std::string& environment = "", int seconds = 120) const;

    // The same with --device `device`.
    Outcome RunOn(const std::string& device, const std::string& arguments, const std::string& environment = "",
                  int seconds = 120) const;
};

// A picture of random samples in [0, 1], in whole codes of what it is stored as.
Picture RandomPicture(uint32_t widthTexels, uint32_t heightTexels, uint32_t channels, SampleType stored);

// sRGB codes to linear light and back, in double. Written from IEC 61966-2-1.
double ReferenceDecode(double code);
double ReferenceEncode(double light);

// The picture's samples for the reference filter; missing channels are 0. With `srgb`: linear light, colours times
// alpha.
reference::DoubleImage ReferenceLight(const Picture& picture, bool srgb);

}  // namespace boxcar
