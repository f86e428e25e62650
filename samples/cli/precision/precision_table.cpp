#include "samples/cli/precision/precision_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>

#include "hlsl/constants/precision_constants.h"
#include "hlsl/constants/sat_constants.h"
#include "passes_shaders.h"
#include "precision_shaders.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr uint32_t kBlockTexels = 16;
constexpr int2 kAxes[] = {{1, 0}, {0, 1}};

Format FormatOf(Precision precision) {
    if (precision == Precision::Fp16) return Format::RGBA16F;
    return precision == Precision::U32 ? Format::RGBA32UI : Format::RGBA32F;
}

int2 SizeOf(Extent2D extent) {
    return {extent.widthTexels, extent.heightTexels};
}

uint32_t Blocks(uint32_t sizeTexels) {
    return (sizeTexels + kBlockTexels - 1) / kBlockTexels;
}

}  // namespace

const char* Name(Precision precision) {
    constexpr const char* kNames[] = {"fp16", "fp24", "fp24t", "fp32", "u32"};
    return kNames[static_cast<size_t>(precision)];
}
const char* Name(SATOrigin origin) {
    constexpr const char* kNames[] = {"corner", "center", "lower-left"};
    return kNames[static_cast<size_t>(origin)];
}
const char* Name(Builder builder) {
    constexpr const char* kNames[] = {"raster", "frame", "lines", "blocks"};
    return kNames[static_cast<size_t>(builder)];
}

PrecisionTable::PrecisionTable(Device& device, Extent2D extent) : m_device(device), m_extent(extent) {}

const Pipeline& PrecisionTable::PipelineOf(const std::string& pixel, Format target, const std::string& vertex) {
    const std::string name = pixel + " to " + FormatName(target);
    const auto known = m_pipelines.find(name);
    if (known != m_pipelines.end()) return known->second;
    return m_pipelines
        .emplace(name, Pipeline(m_device, {passes_shaders::Find("shaders/" + vertex),
                                           precision_shaders::Find("shaders/" + pixel),
                                           {target}}))
        .first->second;
}

PingPong& PrecisionTable::Targets(Format format, Extent2D extent) {
    const std::string name =
        fmt::format("table {} {}x{}", FormatName(format), extent.widthTexels, extent.heightTexels);
    const auto known = m_pairs.find(name);
    if (known != m_pairs.end()) return known->second;
    return m_pairs.emplace(name, PingPong(m_device, {extent, format, name})).first->second;
}

const Image& PrecisionTable::Target(const std::string& name, Format format, Extent2D extent) {
    const auto known = m_images.find(name);
    if (known != m_images.end()) return known->second;
    return m_images.emplace(name, Image(m_device, {extent, format, name})).first->second;
}

const Image& PrecisionTable::Record(CommandList& commands, const Image& source, const TableSetup& setup) {
    BOXCAR_ASSERT(source.Extent() == m_extent);
    switch (setup.builder) {
        case Builder::Frame: return RecordFrame(commands, source, setup);
        case Builder::Lines: return RecordLines(commands, source, setup);
        case Builder::Blocks: return RecordBlocks(commands, source, setup);
        case Builder::Raster: break;
    }
    return RecordRaster(commands, source, setup);
}

// The first pass of every builder: into the front of `targets`.
const Image& PrecisionTable::RecordTexels(CommandList& commands, const Image& source, const TableSetup& setup,
                                          PingPong& targets) {
    const PrecisionTexelConstants constants{setup.bias, SizeOf(m_extent), setup.builder == Builder::Frame ? 1 : 0,
                                            static_cast<float>(setup.largestCode)};
    const std::string shader = fmt::format("precision_texel.ps.PRECISION={}", Name(setup.precision));
    commands.Draw({.name = "texels",
                   .pipeline = PipelineOf(shader, FormatOf(setup.precision)),
                   .reads = {{"source", &source}},
                   .writes = {&targets.Back()},
                   .constants = ConstantBytes(constants)});
    targets.Swap();
    return targets.Front();
}

const Image& PrecisionTable::RecordRaster(CommandList& commands, const Image& source, const TableSetup& setup) {
    const Format format = FormatOf(setup.precision);
    PingPong& targets = Targets(format, m_extent);
    RecordTexels(commands, source, setup, targets);
    const int2 middle = OriginTexels(setup.origin, m_extent);
    for (const int2 axis : kAxes) {
        const int2 farther = glm::max(middle, SizeOf(m_extent) - middle) * axis;
        const auto sizeTexels = static_cast<uint32_t>(farther.x + farther.y);
        for (uint32_t stride = 1; stride < sizeTexels; stride *= setup.taps) {
            const SATPassConstants constants{float2(0), static_cast<int>(stride) * axis, middle};
            const std::string shader = fmt::format("precision_pass.ps.PRECISION={}.TAPS={}", Name(setup.precision),
                                                   SummedAreaTablePassTaps(setup.taps, stride, sizeTexels));
            commands.Draw({.name = "sums",
                           .pipeline = PipelineOf(shader, format),
                           .reads = {{"source", &targets.Front()}},
                           .writes = {&targets.Back()},
                           .constants = ConstantBytes(constants)});
            targets.Swap();
        }
    }
    return targets.Front();
}

const Image& PrecisionTable::RecordFrame(CommandList& commands, const Image& source, const TableSetup& setup) {
    constexpr uint32_t kTaps = 4;
    BOXCAR_ASSERT(setup.precision == Precision::Fp32 && setup.origin == SATOrigin::Corner && setup.taps == kTaps);
    const Extent2D framed{m_extent.widthTexels + 2, m_extent.heightTexels + 2};
    PingPong& targets = Targets(Format::RGBA32F, framed);
    RecordTexels(commands, source, setup, targets);
    for (const int2 axis : kAxes) {
        const int2 along = SizeOf(framed) * axis;
        const auto sizeTexels = static_cast<uint32_t>(along.x + along.y);
        for (uint32_t stride = 1; stride < sizeTexels; stride *= kTaps) {
            const int2 strideTexels = static_cast<int>(stride) * axis;
            const SATPassConstants constants{float2(strideTexels) / float2(SizeOf(framed)), strideTexels, int2(0)};
            commands.Draw({.name = "framed sums",
                           .pipeline = PipelineOf("precision_frame_pass.ps", Format::RGBA32F, "sat_pass.vs.TAPS=4"),
                           .reads = {{"source", &targets.Front()}},
                           .writes = {&targets.Back()},
                           .constants = ConstantBytes(constants)});
            targets.Swap();
        }
    }
    return targets.Front();
}

const Image& PrecisionTable::RecordLines(CommandList& commands, const Image& source, const TableSetup& setup) {
    BOXCAR_ASSERT(setup.origin == SATOrigin::Corner);
    const Format format = FormatOf(setup.precision);
    PingPong& table = Targets(format, m_extent);
    const Image* turns[] = {&Target(fmt::format("even lines {}", Name(setup.precision)), format, m_extent),
                            &Target(fmt::format("odd lines {}", Name(setup.precision)), format, m_extent)};
    RecordTexels(commands, source, setup, table);
    const std::string shader = fmt::format("precision_line.ps.PRECISION={}", Name(setup.precision));
    for (const int2 axis : kAxes) {
        const PrecisionLineConstants constants{int4(axis, 0, 0)};
        const int2 along = SizeOf(m_extent) * axis;
        for (int line = 0; line < along.x + along.y; line++) {
            Rect area{0, 0, m_extent.widthTexels, m_extent.heightTexels};
            (axis.x ? area.xTexels : area.yTexels) = static_cast<uint32_t>(line);
            (axis.x ? area.widthTexels : area.heightTexels) = 1;
            commands.Draw({.name = "line",
                           .pipeline = PipelineOf(shader, format),
                           .reads = {{"source", &table.Front()}, {"before", turns[(line + 1) % 2]}},
                           .writes = {turns[line % 2]},
                           .constants = ConstantBytes(constants),
                           .area = area});
        }
        commands.Draw({.name = "merge",
                       .pipeline = PipelineOf("precision_merge.ps", format),
                       .reads = {{"even", turns[0]}, {"odd", turns[1]}},
                       .writes = {&table.Back()},
                       .constants = ConstantBytes(constants)});
        table.Swap();
    }
    return table.Front();
}

const Image& PrecisionTable::RecordBlocks(CommandList& commands, const Image& source, const TableSetup& setup) {
    BOXCAR_ASSERT(setup.precision == Precision::U32 && setup.largestCode <= 255);
    const Image& table = RecordRaster(commands, source, setup);
    const auto [width, height] = m_extent;
    const auto part = [&](const std::string& name, Extent2D extent) -> const Image& {
        const Image& image = Target("blocks " + name, Format::RGBA32UI, extent);
        commands.Draw({.name = "split",
                       .pipeline = PipelineOf("precision_blocks_split.ps.PART=" + name, Format::RGBA32UI),
                       .reads = {{"table", &table}},
                       .writes = {&image}});
        return image;
    };
    const Image& local = part("Local", m_extent);
    const Image& left = part("Left", {Blocks(width), height});
    const Image& top = part("Top", {width, Blocks(height)});
    PingPong& targets = Targets(Format::RGBA32UI, m_extent);
    commands.Draw({.name = "join",
                   .pipeline = PipelineOf("precision_blocks_join.ps", Format::RGBA32UI),
                   .reads = {{"local", &local}, {"left", &left}, {"top", &top}},
                   .writes = {&targets.Back()}});
    targets.Swap();
    return targets.Front();
}

const Image& PrecisionTable::RecordBox(CommandList& commands, const Image& table, const TableSetup& setup,
                                       uint32_t sizeTexels) {
    BOXCAR_ASSERT(sizeTexels % 2 == 1);
    const bool whole = setup.precision == Precision::U32;
    const Format format = whole ? Format::RGBA32UI : Format::RGBA32F;
    const Image& result = Target(whole ? "box sums" : "box means", format, m_extent);
    const PrecisionBoxConstants constants{SizeOf(m_extent), OriginTexels(setup.origin, m_extent), setup.bias,
                                          int2(static_cast<int>(sizeTexels)),
                                          int2(setup.builder == Builder::Frame ? 1 : 0)};
    commands.Draw(
        {.name = "box",
         .pipeline = PipelineOf(whole ? "precision_box.ps.PRECISION=u32" : "precision_box.ps.PRECISION=fp32", format),
         .reads = {{"table", &table}},
         .writes = {&result},
         .constants = ConstantBytes(constants)});
    return result;
}

}  // namespace boxcar
