#include "samples/cli/options.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "samples/files/bytes.h"
#include "samples/files/color.h"

namespace boxcar {
namespace {

double ParseLength(const std::string& flag, const std::string& whole, std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(value > 0 && value <= kMaxSizeTexels))
        throw UsageError("{} {}: expected W or WxH in texels, numbers above 0 and at most {}", flag, whole,
                         kMaxSizeTexels);
    return value;
}

}  // namespace

void AddDeviceOptions(CLI::App& command, DeviceOptions& options) {
    command
        .add_option("--device", options.selector, "Vulkan device: an index or a part of its name (boxcar devices)")
        ->type_name("D");
    command.add_flag("--validation", options.validation, "Run under the validation layer; a message is a failure");
}

CheckedDevice::CheckedDevice(const DeviceOptions& options)
    : device(DeviceDesc{.selector = options.selector,
                        .validation = options.validation,
                        .onValidationMessage = [this](const std::string& message) {
                            messages++;
                            fmt::print(stderr, "boxcar: {}\n", message);
                        }}) {}

void CheckedDevice::RequireClean() const {
    if (messages > 0) throw Error("the validation layer had {} messages", messages);
}

void AddFormatOption(CLI::App& command, std::string& word) {
    command.add_option("--format", word, "Format of the output, instead of its name's ending")
        ->check(CLI::IsMember({"png", "jpg", "jpeg", "exr", "pfm"}))
        ->type_name("F");
}

void RequireFolder(const std::string& path) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (path != "-" && !folder.empty() && !std::filesystem::is_directory(folder))
        throw Error("{}: there is no folder {}", path, folder.string());
}

void AddReadOptions(CLI::App& command, ReadOptions& options) {
    command
        .add_option(
            "--transfer", options.transferWord,
            "srgb: filter in linear light (the default for 8 and 16-bit files); raw: take values as they stand "
            "(the default for float files)")
        ->check(CLI::IsMember({"srgb", "raw"}))
        ->type_name("T");
    command.add_option("--nan", options.nanWord, "What to do with NaN and infinity: refuse (default) or zero")
        ->check(CLI::IsMember({"refuse", "zero"}))
        ->type_name("N");
}

void AddTapsOption(CLI::App& command, TapsOption& taps) {
    command.add_option("--taps", taps.word, "Texels added per pass while the table is built: 2, 4 (default), 8, 16")
        ->check(CLI::IsMember({"2", "4", "8", "16"}))
        ->type_name("T");
}

void ReportNotes(const std::string& path, const Picture& picture) {
    for (const std::string& note : picture.notes)
        fmt::print(stderr, "boxcar: {}: {}\n", InputName(path), note);
}

Picture ReadForDevice(const std::string& path, const Device& device, const ReadOptions& options) {
    const DeviceLimits& limits = device.Limits();
    Picture picture = ReadPicture(path, {limits.maxSideTexels, limits.maxImageBytes});
    ReportNotes(path, picture);
    if (options.nanWord == "zero") {
        ZeroNotFinite(picture);
    } else if (const auto at = FirstNotFinite(picture)) {
        throw Error("{}: NaN or infinity at ({}, {}), which would spread from there; --nan zero replaces it", path,
                    at->x, at->y);
    }
    return picture;
}

Picture ReadBeside(const Picture& picture, const std::string& path, const std::string& what, const Device& device,
                   const ReadOptions& options) {
    Picture beside = ReadForDevice(path, device, options);
    if (beside.widthTexels != picture.widthTexels || beside.heightTexels != picture.heightTexels)
        throw Error("{}: {} x {} texels; the {} must be as large as the picture, {} x {}", path, beside.widthTexels,
                    beside.heightTexels, what, picture.widthTexels, picture.heightTexels);
    return beside;
}

void WriteResult(const Picture& picture, const std::string& path, FileFormat format, SampleType sampleType) {
    const std::string lost = LostColorSpace(picture.colorSpace, format);
    if (!lost.empty()) fmt::print(stderr, "boxcar: {}: {}\n", OutputName(path), lost);
    WritePicture(picture, path, format, sampleType);
}

Transfer TransferFor(const Picture& picture, const ReadOptions& options) {
    if (options.transferWord == "auto") return picture.stored == SampleType::Float32 ? Transfer::Raw : Transfer::Srgb;
    return options.transferWord == "srgb" ? Transfer::Srgb : Transfer::Raw;
}

uint32_t TapsOption::Count() const {
    return static_cast<uint32_t>(std::stoul(word));
}

void AddTableOptions(CLI::App& command, TableOptions& options, const std::string& biasDefault,
                     const std::string& precisionDefault) {
    command
        .add_option("--precision", options.precisionWord,
                    "fp32: floats, which round; u32, u64: exact integers modulo 2^32, 2^64 (default: " +
                        precisionDefault + ")")
        ->check(CLI::IsMember({"fp32", "u32", "u64"}))
        ->type_name("P");
    command
        .add_option("--bias", options.biasWord,
                    "Taken off before summing, which rounds less (fp32): none, half (0.5) or mean (default: " +
                        biasDefault + ")")
        ->check(CLI::IsMember({"none", "half", "mean"}))
        ->type_name("B");
    command
        .add_option(
            "--origin", options.originWord,
            "Where sums start: corner, the upper left (default); center, which rounds less (fp32); lower-left")
        ->check(CLI::IsMember({"corner", "center", "lower-left"}))
        ->type_name("O");
}

std::optional<SATPrecision> PrecisionOf(const TableOptions& options) {
    if (options.precisionWord.empty()) return {};
    return options.precisionWord == "fp32"  ? SATPrecision::FP32
           : options.precisionWord == "u32" ? SATPrecision::U32
                                            : SATPrecision::U64;
}

SATOrigin OriginOf(const TableOptions& options) {
    return options.originWord == "corner"   ? SATOrigin::Corner
           : options.originWord == "center" ? SATOrigin::Center
                                            : SATOrigin::LowerLeft;
}

void RequireFloatOptionsFit(const TableOptions& options) {
    if (options.precisionWord.empty() || options.precisionWord == "fp32") return;
    if (!options.biasWord.empty() && options.biasWord != "none")
        throw UsageError("--bias {} with --precision {}: integers do not round; a bias is for fp32", options.biasWord,
                         options.precisionWord);
    if (options.originWord == "center")
        throw UsageError("--origin center with --precision {}: integers do not round; it is for fp32",
                         options.precisionWord);
}

void AddDiscOptions(CLI::App& command, DiscOptions& options) {
    command.add_option("--disc-boxes", options.boxes, "disc: boxes of equal height that it is made of (default 16)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command
        .add_option("--disc-sides", options.sides,
                    "disc: a polygon of 3 to 16 sides instead, as the blades of a lens make it; 0: round (default)")
        ->check(CLI::IsMember({0, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}))
        ->type_name("N");
}

glm::vec2 ParseSize(const std::string& flag, const std::string& text) {
    const size_t cross = text.find('x');
    const std::string_view view = text;
    const double width = ParseLength(flag, text, view.substr(0, cross));
    const double height = cross == std::string::npos ? width : ParseLength(flag, text, view.substr(cross + 1));
    return {width, height};
}

Extent2D ParseExtent(const std::string& text) {
    Extent2D extent;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, extent.widthTexels);
    bool isRight = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    if (isRight) {
        const auto height = std::from_chars(width.ptr + 1, end, extent.heightTexels);
        isRight = height.ec == std::errc() && height.ptr == end;
    }
    const auto fits = [](uint32_t side) { return side >= 1 && side <= kMaxSideTexels; };
    if (!isRight || !fits(extent.widthTexels) || !fits(extent.heightTexels))
        throw UsageError("--size {}: expected WxH, two whole numbers from 1 to {}", text, kMaxSideTexels);
    return extent;
}

}  // namespace boxcar
