#include "runtime/transfer.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/test_device.h"

namespace boxcar {
namespace {

// Bytes that are no NaN in any of the formats: every 16-bit half of them is below 0x3c00.
std::vector<std::byte> Pattern(size_t count) {
    std::vector<std::byte> bytes(count);
    for (size_t i = 0; i < count; i++)
        bytes[i] = static_cast<std::byte>((i * 7 + i / 4096) % 60);
    return bytes;
}

class TransferOfFormat : public testing::TestWithParam<Format> {};

TEST_P(TransferOfFormat, WhatIsWrittenIsReadBack) {
    for (const Extent2D extent :
         {Extent2D{1, 1}, Extent2D{1, 6}, Extent2D{6, 1}, Extent2D{12, 19}, Extent2D{49, 2}}) {
        const Image image(TestDevice(), {extent, GetParam(), "round trip"});
        const std::vector<std::byte> written = Pattern(extent.Texels() * BytesPerTexel(GetParam()));
        WriteTexels(TestDevice(), image, written);
        std::vector<std::byte> read(written.size());
        ReadTexels(TestDevice(), image, read);
        EXPECT_EQ(read, written) << extent.widthTexels << " x " << extent.heightTexels;
    }
}

INSTANTIATE_TEST_SUITE_P(All, TransferOfFormat,
                         testing::Values(Format::RGBA32F, Format::RGBA16F, Format::RGBA8, Format::R32F,
                                         Format::RGBA32UI, Format::Depth32F),
                         [](const auto& tested) { return std::string(FormatName(tested.param)); });

TEST(Transfer, VolumesGoSliceBySlice) {
    for (const auto& [extent, depth] : {std::pair(Extent2D{1, 1}, 1u), std::pair(Extent2D{7, 5}, 3u),
                                        std::pair(Extent2D{2, 3}, 64u), std::pair(Extent2D{512, 512}, 70u)}) {
        const Image image(TestDevice(),
                          {.extent = extent, .format = Format::R32F, .name = "volume", .depthTexels = depth});
        const std::vector<std::byte> written = Pattern(image.Desc().Texels() * 4);
        WriteTexels(TestDevice(), image, written);
        std::vector<std::byte> read(written.size());
        ReadTexels(TestDevice(), image, read);
        EXPECT_TRUE(read == written) << extent.widthTexels << " x " << extent.heightTexels << " x " << depth;
    }
}

// 160 MiB go in three bands of at most 64 MiB, the last one smaller.
TEST(Transfer, LargeImagesGoInBandsThatJoinWithoutASeam) {
    const Extent2D extent{4096, 2560};
    const Image image(TestDevice(), {extent, Format::RGBA32F, "banded"});
    const std::vector<std::byte> written = Pattern(extent.Texels() * 16);
    WriteTexels(TestDevice(), image, written);
    std::vector<std::byte> read(written.size());
    ReadTexels(TestDevice(), image, read);
    EXPECT_TRUE(read == written);
}

}  // namespace
}  // namespace boxcar
