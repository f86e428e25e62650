// Every mistake gets one clear line and exit 1 or 2, and leaves nothing behind.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/cli/program.h"

namespace boxcar {
namespace {

class BadInput : public testing::Test {
protected:
    void SetUp() override {
        WritePicture(RandomPicture(6, 4, 3, SampleType::Unorm8), m_folder.Path("ok.png"), FileFormat::Png,
                     SampleType::Unorm8);
        WritePicture(RandomPicture(6, 4, 4, SampleType::Unorm8), m_folder.Path("alpha.png"), FileFormat::Png,
                     SampleType::Unorm8);
    }

    // The command fails with this code and this one line, prints nothing else, and writes nothing.
    void Refused(const std::string& arguments, int exitCode, const std::string& line,
                 const std::string& environment = "") {
        const auto before = m_folder.Names();
        const Outcome outcome = m_folder.Run(arguments, environment);
        EXPECT_EQ(outcome.exitCode, exitCode) << arguments;
        EXPECT_EQ(outcome.err, "boxcar: " + line + "\n") << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_EQ(m_folder.Names(), before) << arguments;
    }

    Folder m_folder;
};

TEST_F(BadInput, WidthsThatAreNone) {
    for (const char* width : {"0", "-3", "nan", "inf", "1e30", "5x", "x5", "5x0", "five", "5x5x5", "32769", "0x10"})
        Refused(fmt::format("filter ok.png -o out.png --width='{}'", width), 2,
                fmt::format("--width {}: expected W or WxH in texels, numbers above 0 and at most 32768", width));
}

TEST_F(BadInput, UnknownWordsAndFlags) {
    EXPECT_EQ(m_folder.Run("").exitCode, 2);
    Refused(
        "foo", 2,
        "no command 'foo'; there is filter, dof, sat, resize, derive, precision, gallery, render, sweep, inspect, "
        "list, fit-lobe, devices");
    Refused("filter ok.png -o '' --width 3", 2, "-o: an empty name; a file, folder/ or - is expected");
    Refused("filter '' -o out.png --width 3", 2, "IN: an empty name; a file or - is expected");
    Refused("render soft-shadow -o ''", 2, "-o: an empty name; a file, folder/ or - is expected");
    Refused("filter ok.png -o out.png --width 3 --sharpen", 2, "The following argument was not expected: --sharpen");
    Refused("filter ok.png -o out.png", 2, "--width is missing: W or WxH in texels, or a --width-map");
    Refused("filter ok.png --width 3", 2, "--output is required");
    Refused("filter ok.png -o out.png --width 3 --edge soft", 2, "--edge: soft not in {clip,zero,repeat,mirror}");
    Refused("filter ok.png -o out.png --width 3 --taps 3", 2, "--taps: 3 not in {2,4,8,16}");
}

TEST_F(BadInput, FilesThatAreNoPictures) {
    m_folder.WriteText("empty.png", "");
    m_folder.WriteText("text.png", "this is no picture at all");
    Refused("filter missing.png -o out.png --width 3", 1, "missing.png: cannot be read: No such file or directory");
    Refused("filter . -o out.png --width 3", 1, ".: a folder; a file is expected");
    Refused("filter empty.png -o out.png --width 3", 1,
            "empty.png: the file is empty; a PNG, JPEG, HDR, EXR or PFM picture is expected");
    Refused("filter text.png -o out.png --width 3", 1,
            "text.png: no picture that is known; PNG, JPEG, HDR, EXR or PFM is expected");
}

TEST_F(BadInput, TruncatedPictures) {
    WritePicture(RandomPicture(60, 40, 3, SampleType::Unorm8), m_folder.Path("a.jpg"), FileFormat::Jpeg,
                 SampleType::Unorm8);
    for (const auto& [name, format] : {std::pair{"a.exr", FileFormat::Exr}, std::pair{"a.pfm", FileFormat::Pfm}})
        WritePicture(RandomPicture(60, 40, 3, SampleType::Float32), m_folder.Path(name), format, SampleType::Float32);
    for (const char* name : {"ok.png", "a.jpg", "a.exr", "a.pfm"}) {
        const auto path = m_folder.Path(name);
        std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
        const auto before = m_folder.Names();
        const Outcome outcome = m_folder.Run(fmt::format("filter {} -o out.png --width 3", name));
        EXPECT_EQ(outcome.exitCode, 1) << name;
        EXPECT_TRUE(outcome.err.starts_with(fmt::format("boxcar: {}: ", name))) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_EQ(m_folder.Names(), before);
    }
}

TEST_F(BadInput, SizesThatDoNotFit) {
    m_folder.WriteText("wide.pfm", "PF\n16385 1\n-1.0\n" + std::string(16385 * 12, '\0'));
    m_folder.WriteText("absurd.pfm", "PF\n4000000000 4000000000\n-1.0\n");
    m_folder.WriteText("none.pfm", "PF\n0 7\n-1.0\n");
    m_folder.WriteText("heavy.pfm", "PF\n16384 16384\n-1.0\n");
    Refused("filter wide.pfm -o out.pfm --width 3", 1, "wide.pfm: 16385 x 1 texels; a side may be at most 16384");
    Refused("filter none.pfm -o out.pfm --width 3", 1, "none.pfm: 0 x 7 texels; a side must be at least 1");
    EXPECT_EQ(m_folder.Run("filter absurd.pfm -o out.pfm --width 3").exitCode, 1);
    const Outcome heavy = m_folder.Run("filter heavy.pfm -o out.pfm --width 3");
    EXPECT_EQ(heavy.exitCode, 1);
    EXPECT_TRUE(heavy.err.starts_with("boxcar: heavy.pfm: 16384 x 16384 texels need 4096 MiB as RGBA32F; at most "))
        << heavy.err;
}

TEST_F(BadInput, OutputsThatCannotBe) {
    Refused("filter ok.png -o out.gif --width 3", 2,
            "out.gif: the name says no format; an ending .png, .jpg, .jpeg, .exr or .pfm is expected");
    Refused("filter ok.png -o out.hdr --width 3", 1,
            "out.hdr: HDR is read, not written; .exr or .pfm holds the same");
    Refused("filter alpha.png -o out.pfm --width 3", 1, "out.pfm: PFM holds no alpha; EXR does");
    Refused("filter alpha.png -o out.jpg --width 3", 1, "out.jpg: JPEG holds no alpha; PNG and EXR do");
    Refused("filter ok.png -o missing/out.png --width 3", 1,
            "missing/out.png: cannot be written: No such file or directory");
    Refused("filter ok.png -o /dev/full --format png --width 3", 1,
            "/dev/full: cannot be written: No space left on device");
    Refused("filter ok.png -o - --width 3", 2, "-o -: standard output needs --format png, jpg, exr or pfm");
    Refused("filter ok.png -o - --format png --json --width 3", 2,
            "--json and -o - would both write to standard output");
    Refused("filter ok.png alpha.png -o out.png --width 3", 2,
            "-o out.png: 2 inputs need a folder, as in -o out.png/");
    Refused("filter ok.png ./ok.png -o ./ --width 3", 2, "ok.png and ./ok.png would both be written to ./ok.png");
    Refused("gallery -o ok.png/gallery", 1, "ok.png/gallery: cannot make this folder: Not a directory");
    Refused("gallery -o ok.png/gallery --size 0x60", 2,
            "--size 0x60: expected WxH, two whole numbers from 1 to 8192");
}

TEST_F(BadInput, NoVulkanDriver) {
    const std::string line =
        "no Vulkan driver: install one, such as mesa-vulkan-drivers, and see that VK_ICD_FILENAMES, "
        "if it is set, names it";
    Refused("filter ok.png -o out.png --width 3", 1, line, "VK_ICD_FILENAMES=/nowhere.json");
    Refused("devices", 1, line, "VK_ICD_FILENAMES=/nowhere.json");
}

TEST_F(BadInput, UnknownDevice) {
    const Outcome outcome = m_folder.RunOn("Voodoo2", "filter ok.png -o out.png --width 3");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_TRUE(outcome.err.starts_with("boxcar: no Vulkan device matches 'Voodoo2'; there is 0: ")) << outcome.err;
}

TEST_F(BadInput, HelpExistsForEveryCommandWithAnExample) {
    for (const char* command : {"", "filter ", "sat ", "gallery ", "devices "}) {
        const Outcome outcome = m_folder.Run(fmt::format("{}--help", command), "");
        EXPECT_EQ(outcome.exitCode, 0) << command;
        EXPECT_NE(outcome.out.find("Example"), std::string::npos) << outcome.out;
    }
}

}  // namespace
}  // namespace boxcar
