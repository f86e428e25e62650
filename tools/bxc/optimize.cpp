#include "tools/bxc/optimize.h"

#include <spirv-tools/optimizer.hpp>

namespace boxcar {

std::vector<uint32_t> Optimize(const std::vector<uint32_t>& spirv, int level, const std::string& file,
                               Diagnostics& diagnostics) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
    optimizer.SetMessageConsumer(
        [&](spv_message_level_t severity, const char*, const spv_position_t&, const char* message) {
            if (severity > SPV_MSG_WARNING) return;  // higher is milder: information about the passes
            diagnostics.push_back({{file, 0, 0},
                                   severity == SPV_MSG_WARNING ? Severity::Warning : Severity::Error,
                                   fmt::format("the optimiser: {}", message)});
        });
    optimizer.RegisterLegalizationPasses();
    if (level == 1) optimizer.RegisterSizePasses();
    if (level == 3) optimizer.RegisterPass(spvtools::CreateLoopUnrollPass(true));
    if (level >= 2) optimizer.RegisterPerformancePasses();

    spvtools::OptimizerOptions options;
    options.set_run_validator(false);  // that is a stage of its own
    std::vector<uint32_t> optimized;
    if (!optimizer.Run(spirv.data(), spirv.size(), &optimized, options)) {
        if (!HasErrors(diagnostics)) diagnostics.push_back({{file, 0, 0}, Severity::Error, "the optimiser failed"});
        return {};
    }
    return optimized;
}

}  // namespace boxcar
