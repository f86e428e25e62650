// Between bytes and pictures: a pair of functions a format, for picture.cpp alone. They know no file names; an
// Error's text continues "PATH: ".
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "samples/files/bytes.h"
#include "samples/files/picture.h"
#include "tools/base/error.h"

namespace boxcar {

Picture DecodePng(ByteView file, const PictureLimits& limits);
Picture DecodeJpeg(ByteView file, const PictureLimits& limits);
Picture DecodeHdr(ByteView file, const PictureLimits& limits);
Picture DecodeExr(ByteView file, const PictureLimits& limits);
Picture DecodePfm(ByteView file, const PictureLimits& limits);

Bytes EncodePng(const Picture& picture, SampleType sampleType);
Bytes EncodeJpeg(const Picture& picture);
Bytes EncodeExr(const Picture& picture);
Bytes EncodePfm(const Picture& picture);

// What every decoder says of a file that its library cannot make sense of.
Error Unreadable(FileFormat format, std::string_view reason);

// Throws Error unless the sides a header gives are 1 at least and within the limits.
void RequireWithin(uint64_t widthTexels, uint64_t heightTexels, const PictureLimits& limits);

// The most that a file of a picture within the limits can need: its texels and some more.
uint64_t MaxFileBytes(const PictureLimits& limits);

// What every decoder throws at a file that ends too early.
Error CutOff(FileFormat format);

// What the codes of 8 bits are as samples.
const std::array<float, 256>& SamplesOf8Bits();

// A picture whose samples are 0.
Picture MakePicture(uint64_t widthTexels, uint64_t heightTexels, uint32_t channels, SampleType stored);

// Give `picture`, whose channels are known, what its file says of its colors; primaries that are sRGB's, or none at
// all, are not kept, and a profile that is not for such a picture becomes a note.
void SetPrimaries(Picture& picture, const Primaries& primaries);
void SetIccProfile(Picture& picture, ByteView profile);

// Makes the note of a profile that is for pictures of another `space`, as profiles name it; damaged where that is
// empty.
void LeaveOutProfile(Picture& picture, std::string_view space);

// The samples as integers: clamped to [0,1], times the largest Code, rounded to nearest; NaN becomes 0.
template <typename Code>
std::vector<Code> ToCodes(const std::vector<float>& samples) {
    constexpr double kLargest = static_cast<Code>(~Code{0});
    std::vector<Code> codes(samples.size());
    for (size_t i = 0; i < samples.size(); ++i) {
        const double sample = samples[i] > 0.0f ? (samples[i] < 1.0f ? samples[i] : 1.0) : 0.0;
        codes[i] = static_cast<Code>(sample * kLargest + 0.5);
    }
    return codes;
}

}  // namespace boxcar
