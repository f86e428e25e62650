#include "tools/bxc/optimize.h"

#include <spirv-tools/optimizer.hpp>

namespace boxcar {
namespace {

std::vector<uint32_t> Run(spvtools::Optimizer& optimizer, const std::vector<uint32_t>& spirv, const std::string& file,
                          Diagnostics& diagnostics) {
    optimizer.SetMessageConsumer(
        [&](spv_message_level_t level, const char*, const spv_position_t&, const char* text) {
            if (level > SPV_MSG_WARNING) return;  // a higher level is milder: information about the passes
            diagnostics.push_back({{file, 0, 0},
                                   level == SPV_MSG_WARNING ? Severity::Warning : Severity::Error,
                                   fmt::format("the optimizer: {}", text)});
        });
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);  // that is a stage of its own
    std::vector<uint32_t> result;
    if (optimizer.Run(spirv.data(), spirv.size(), &result, options)) return result;
    if (!HasErrors(diagnostics)) diagnostics.push_back({{file, 0, 0}, Severity::Error, "the optimizer failed"});
    return {};
}

}  // namespace

std::vector<uint32_t> Optimize(const std::vector<uint32_t>& spirv, int level, const std::string& file,
                               Diagnostics& diagnostics) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
    optimizer.RegisterLegalizationPasses();
    if (level == 1) optimizer.RegisterSizePasses();
    if (level >= 2) optimizer.RegisterPerformancePasses();
    return Run(optimizer, spirv, file, diagnostics);
}

std::vector<uint32_t> StripSemantics(const std::vector<uint32_t>& spirv, const std::string& file,
                                     Diagnostics& diagnostics) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
    optimizer.RegisterPass(spvtools::CreateStripNonSemanticInfoPass());
    return Run(optimizer, spirv, file, diagnostics);
}

}  // namespace boxcar
