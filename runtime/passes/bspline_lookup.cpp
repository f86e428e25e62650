#include "runtime/passes/bspline_lookup.h"

#include "hlsl/constants/bspline_constants.h"
#include "runtime/passes/quad_shaders.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

bool IsGaussian(BSplineKernel kernel) {
    return kernel == BSplineKernel::Gaussian || kernel == BSplineKernel::GaussianFirstDerivative;
}

const char* ShaderOf(BSplineKernel kernel) {
    switch (kernel) {
        case BSplineKernel::Value: return "bspline_lookup.ps.KERNEL=VALUE";
        case BSplineKernel::FirstDerivative: return "bspline_lookup.ps.KERNEL=FIRST";
        case BSplineKernel::Gaussian: return "bspline_lookup.ps.KERNEL=GAUSS";
        case BSplineKernel::GaussianFirstDerivative: break;
    }
    return "bspline_lookup.ps.KERNEL=GAUSS_FIRST";
}

const BSplineLookupDesc& Checked(const BSplineLookupDesc& desc) {
    if (desc.sizeTexels < 2)
        throw Error("a lookup texture of {} texels: at least 2, for both ends of a kernel", desc.sizeTexels);
    if (!IsGaussian(desc.kernel)) return desc;
    if (!(desc.sigmaTexels >= 0.3f && desc.sigmaTexels <= 0.8f))
        throw Error("a Gaussian of sigma {} texels: 0.3 to 0.8 fit into four texels", desc.sigmaTexels);
    if (desc.format == Format::RGBA8)
        throw Error("the lookup texture of a Gaussian in RGBA8: its offsets are over 1; take RGBA16F or RGBA32F");
    return desc;
}

}  // namespace

BSplineLookup::BSplineLookup(Device& device, const BSplineLookupDesc& desc)
    : m_desc(Checked(desc)),
      m_pipeline(device, QuadShaders(ShaderOf(desc.kernel), {desc.format})),
      m_lookup(device, {{desc.sizeTexels, 1}, desc.format, "kernel lookup"}) {}

const Image& BSplineLookup::Record(CommandList& commands) {
    const BSplineLookupConstants constants{static_cast<int>(m_desc.sizeTexels), m_desc.sigmaTexels};
    commands.Draw({.name = "kernel lookup",
                   .pipeline = m_pipeline,
                   .writes = {&m_lookup},
                   .constants = ConstantBytes(constants)});
    return m_lookup;
}

}  // namespace boxcar
