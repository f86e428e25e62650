#include "runtime/passes/resize.h"

#include "runtime/passes/quad_shaders.h"

namespace boxcar {
namespace {

const char* ShaderOf(ResizeFilter filter) {
    switch (filter) {
        case ResizeFilter::Nearest: return "resize.ps.FILTER=NEAREST";
        case ResizeFilter::Linear: return "resize.ps.FILTER=LINEAR";
        case ResizeFilter::CatmullRom: return "resize.ps.FILTER=CATMULL_ROM";
        default: return "resize.ps.FILTER=BSPLINE";
    }
}

}  // namespace

Resize::Resize(Device& device, const ResizeDesc& desc) : m_pipeline(device, QuadShaders(ShaderOf(desc.filter))) {
    const bool interpolates = desc.filter == ResizeFilter::InterpolatingBSpline;
    const auto along = [&](Axis axis, Extent2D from, Extent2D to) {
        const float step = axis == Axis::X ? desc.stepTexels.x : desc.stepTexels.y;
        AxisPasses& passes = m_axes.emplace_back(
            AxisPasses{{step, axis == Axis::X}, {}, {}, Image(device, {to, Format::RGBA32F, "resized"})});
        if (!interpolates) return;
        if (step > 1)
            passes.after.emplace(device, to, axis);
        else
            passes.before.emplace(device, from, axis);
    };
    const Extent2D wide{desc.result.widthTexels, desc.source.heightTexels};
    along(Axis::X, desc.source, wide);
    along(Axis::Y, wide, desc.result);
}

const Image& Resize::Record(CommandList& commands, const Image& source) {
    const Image* image = &source;
    for (AxisPasses& axis : m_axes) {
        if (axis.before) image = &axis.before->Record(commands, *image);
        commands.Draw({.name = axis.constants.alongX ? "resize x" : "resize y",
                       .pipeline = m_pipeline,
                       .reads = {{"source", image}},
                       .writes = {&axis.result},
                       .constants = ConstantBytes(axis.constants)});
        image = &axis.result;
        if (axis.after) image = &axis.after->Record(commands, *image);
    }
    return *image;
}

}  // namespace boxcar
