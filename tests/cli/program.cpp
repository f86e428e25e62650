#include "tests/cli/program.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace boxcar {
namespace {

std::string DeviceFlags(const std::string& arguments, const std::string& device) {
    for (const char* command :
         {"filter ", "sat ", "dof ", "gallery ", "render ", "sweep ", "inspect ", "resize ", "derive "})
        if (arguments.starts_with(command)) return fmt::format(" --validation --device '{}'", device);
    return "";
}

}  // namespace

Outcome Folder::Run(const std::string& arguments, const std::string& environment, int seconds) const {
    const char* named = std::getenv("BOXCAR_TEST_DEVICE");
    return RunOn(named ? named : "llvmpipe", arguments, environment, seconds);
}

Outcome Folder::RunOn(const std::string& device, const std::string& arguments, const std::string& environment,
                      int seconds) const {
    const std::string command = fmt::format("{} timeout {} " BOXCAR_PROGRAM " {}{}", environment, seconds, arguments,
                                            DeviceFlags(arguments, device));
    return test::RunProgram({"sh", "-c", command}, Path());
}

Picture RandomPicture(uint32_t widthTexels, uint32_t heightTexels, uint32_t channels, SampleType stored) {
    std::mt19937 random(widthTexels * 31 + heightTexels * 7 + channels);
    const uint32_t codes = stored == SampleType::Unorm8 ? 256 : 65536;
    Picture picture{widthTexels, heightTexels, channels, stored, {}};
    picture.samples.resize(size_t{widthTexels} * heightTexels * channels);
    for (float& sample : picture.samples)
        sample = static_cast<float>(random() % codes) / static_cast<float>(codes - 1);
    return picture;
}

double ReferenceDecode(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

double ReferenceEncode(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

reference::DoubleImage ReferenceLight(const Picture& picture, bool srgb) {
    reference::DoubleImage image{static_cast<int>(picture.widthTexels), static_cast<int>(picture.heightTexels), {}};
    const int channels = static_cast<int>(picture.channels);
    const int alpha = channels % 2 == 0 ? channels - 1 : -1;
    for (size_t at = 0; at < picture.samples.size(); at += picture.channels) {
        glm::dvec4 texel(0);
        for (int c = 0; c < channels; c++) {
            texel[c] = picture.samples[at + c];
            if (!srgb || c == alpha) continue;
            texel[c] = ReferenceDecode(texel[c]);
            if (alpha >= 0) texel[c] *= picture.samples[at + alpha];
        }
        image.texels.push_back(texel);
    }
    return image;
}

}  // namespace boxcar
