// The words and flags that several commands share: the same flag means the same thing everywhere.
#pragma once

#include <CLI/CLI.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "runtime/passes/blur.h"
#include "samples/app/light.h"
#include "samples/files/picture.h"
#include "tools/base/error.h"

namespace boxcar {

struct DeviceOptions {
    std::string selector;
    bool validation = false;
};
void AddDeviceOptions(CLI::App& command, DeviceOptions& options);

// With validation on, each message of the layer is printed; RequireClean() then makes the work a failure.
struct CheckedDevice {
    explicit CheckedDevice(const DeviceOptions& options);
    Device& operator*() { return device; }
    Device* operator->() { return &device; }

    // Throws Error where the validation layer had something to say.
    void RequireClean() const;

    std::size_t messages = 0;
    Device device;
};

// --format: of the output, instead of its name's ending.
void AddFormatOption(CLI::App& command, std::string& word);

// Throws Error where the folder that `path` is to be written into does not exist, so that it can be known before the
// work.
void RequireFolder(const std::string& path);

// Flags of every command that reads a picture.
struct ReadOptions {
    std::string transferWord = "srgb";
    std::string nanWord = "refuse";
};
void AddReadOptions(CLI::App& command, ReadOptions& options);

// Prints what of the file of `picture` is not in it, a line each.
void ReportNotes(const std::string& path, const Picture& picture);

// Reads a picture that fits the device, reports its notes, refuses or replaces what is not finite.
Picture ReadForDevice(const std::string& path, const Device& device, const ReadOptions& options);

// Throws Error where a picture that goes with another, texel for texel, has another size. `what`: how the line calls
// it.
void RequireSameSize(const Picture& picture, const Picture& beside, const std::string& path, const std::string& what);

// ReadForDevice for a picture that goes with another, texel for texel; `what` as above.
Picture ReadBeside(const Picture& picture, const std::string& path, const std::string& what, const Device& device,
                   const ReadOptions& options);

// WritePicture, with a line on what of the color space the format cannot hold.
void WriteResult(const Picture& picture, const std::string& path, FileFormat format, SampleType sampleType);

Transfer TransferOf(const ReadOptions& options);

// --taps: of the commands that build a table.
struct TapsOption {
    std::string word = "4";

    uint32_t Count() const;
};
void AddTapsOption(CLI::App& command, TapsOption& taps);

// Flags of the commands that choose a table.
struct TableOptions {
    std::string precisionWord;  // empty: the command chooses
    std::string biasWord;       // empty: the command chooses
    std::string originWord = "corner";
};
void AddTableOptions(CLI::App& command, TableOptions& options, const std::string& biasDefault,
                     const std::string& precisionDefault);

std::optional<SATPrecision> PrecisionOf(const TableOptions& options);
SATOrigin OriginOf(const TableOptions& options);

// What --bias asks for, if anything.
std::optional<BlurBias> BiasOf(const TableOptions& options);

// Throws UsageError: a bias, or sums from elsewhere than the corner, for integers.
//
//   standard  the precision without --precision
//   alsoFrom  another place that integers may be summed from; Corner: none
void RequireFloatOptionsFit(const TableOptions& options, SATPrecision standard, SATOrigin alsoFrom);

// Flags of the commands that blur under discs.
struct DiscOptions {
    std::optional<uint32_t> boxes;
    std::optional<uint32_t> sides;

    uint32_t Boxes() const { return boxes.value_or(16); }
    uint32_t Sides() const { return sides.value_or(0); }
};
void AddDiscOptions(CLI::App& command, DiscOptions& options);

// The largest width that a command takes: twice the largest side.
constexpr float kMaxSizeTexels = 32768;

// "W" or "WxH": real numbers above 0 and at most 32768 (twice the largest side). Throws UsageError naming the flag.
glm::vec2 ParseSize(const std::string& flag, const std::string& text);

// The largest side of a picture that a command makes.
constexpr uint32_t kMaxSideTexels = 8192;

// "x,y" of a flag: a texel of a picture. Throws UsageError.
glm::uvec2 ParseTexel(const std::string& flag, const std::string& text, Extent2D extent);

// "WxH" of --size: whole numbers from 1 to kMaxSideTexels. Throws UsageError.
Extent2D ParseExtent(const std::string& text);

}  // namespace boxcar
