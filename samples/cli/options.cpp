#include "samples/cli/options.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "samples/cli/console.h"
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

// Two whole numbers with `between` them.
std::optional<glm::uvec2> ParsePair(const std::string& text, char between) {
    glm::uvec2 pair(0);
    const char* const end = text.data() + text.size();
    const auto x = std::from_chars(text.data(), end, pair.x);
    if (x.ec != std::errc() || x.ptr == end || *x.ptr != between) return {};
    const auto y = std::from_chars(x.ptr + 1, end, pair.y);
    return y.ec == std::errc() && y.ptr == end ? std::optional(pair) : std::nullopt;
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
                            PrintProblem(message);
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
    std::error_code unseen;
    if (path != "-" && !folder.empty() && !std::filesystem::is_directory(folder, unseen))
        throw Error("{}: there is no folder {}", path, folder.string());
}

void AddReadOptions(CLI::App& command, ReadOptions& options) {
    command
        .add_option(
            "--transfer", options.transferWord,
            "srgb (default): work in linear light. 8 and 16-bit files hold sRGB codes and straight alpha, float "
            "files "
            "linear light, colors times alpha; what is read as the one and written as the other is converted. raw: "
            "numbers as they stand")
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
        PrintProblem(fmt::format("{}: {}", InputName(path), note));
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

void RequireSameSize(const Picture& picture, const Picture& beside, const std::string& path,
                     const std::string& what) {
    if (beside.widthTexels != picture.widthTexels || beside.heightTexels != picture.heightTexels)
        throw Error("{}: {} x {} texels; the {} must be as large as the picture, {} x {}", path, beside.widthTexels,
                    beside.heightTexels, what, picture.widthTexels, picture.heightTexels);
}

Picture ReadBeside(const Picture& picture, const std::string& path, const std::string& what, const Device& device,
                   const ReadOptions& options) {
    Picture beside = ReadForDevice(path, device, options);
    RequireSameSize(picture, beside, path, what);
    return beside;
}

void WriteResult(const Picture& picture, const std::string& path, FileFormat format, SampleType sampleType) {
    const std::string lost = LostColorSpace(picture.colorSpace, format);
    if (!lost.empty()) PrintProblem(fmt::format("{}: {}", OutputName(path), lost));
    WritePicture(picture, path, format, sampleType);
}

Transfer TransferOf(const ReadOptions& options) {
    return options.transferWord == "raw" ? Transfer::Raw : Transfer::Srgb;
}

uint32_t TapsOption::Count() const {
    return static_cast<uint32_t>(std::stoul(word));
}

void AddTableOptions(CLI::App& command, TableOptions& options, const std::string& biasDefault,
                     const std::string& precisionDefault) {
    command
        .add_option(
            "--precision", options.precisionWord,
            "fp32: floats, which round; u32, u64: sums modulo 2^32, 2^64 of whole codes: the file's own under raw, "
            "else round(65535 light); float files times 2^24 (default: " +
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

std::optional<BlurBias> BiasOf(const TableOptions& options) {
    if (options.biasWord.empty()) return {};
    return options.biasWord == "mean" ? BlurBias::Mean : options.biasWord == "half" ? BlurBias::Half : BlurBias::None;
}

void RequireFloatOptionsFit(const TableOptions& options, SATPrecision standard, SATOrigin alsoFrom) {
    if (PrecisionOf(options).value_or(standard) == SATPrecision::FP32) return;
    const std::string where =
        options.precisionWord.empty() ? "without --precision fp32" : "with --precision " + options.precisionWord;
    if (!options.biasWord.empty() && options.biasWord != "none")
        throw UsageError("--bias {} {}: integers do not round; a bias is for fp32", options.biasWord, where);
    const SATOrigin origin = OriginOf(options);
    if (origin != SATOrigin::Corner && origin != alsoFrom)
        throw UsageError("--origin {} {}: integers do not round, and are summed from the corner; it is for fp32",
                         options.originWord, where);
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

glm::uvec2 ParseTexel(const std::string& flag, const std::string& text, Extent2D extent) {
    const auto texel = ParsePair(text, ',');
    if (!texel || texel->x >= extent.widthTexels || texel->y >= extent.heightTexels)
        throw UsageError("{} {}: expected x,y from 0,0 to {},{}", flag, text, extent.widthTexels - 1,
                         extent.heightTexels - 1);
    return *texel;
}

Extent2D ParseExtent(const std::string& text) {
    const auto extent = ParsePair(text, 'x');
    const auto fits = [](uint32_t side) { return side >= 1 && side <= kMaxSideTexels; };
    if (!extent || !fits(extent->x) || !fits(extent->y))
        throw UsageError("--size {}: expected WxH, two whole numbers from 1 to {}", text, kMaxSideTexels);
    return {extent->x, extent->y};
}

}  // namespace boxcar
