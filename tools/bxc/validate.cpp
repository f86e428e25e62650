#include "tools/bxc/validate.h"

#include <spirv-tools/libspirv.hpp>

namespace boxcar {

void Validate(const std::vector<uint32_t>& spirv, ValidationStep step, const std::string& file,
              Diagnostics& diagnostics) {
    const bool final = step == ValidationStep::Final;
    spvtools::ValidatorOptions options;
    options.SetBeforeHlslLegalization(!final);

    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_1);
    const size_t before = diagnostics.size();
    tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
        diagnostics.push_back(
            {{file, 0, 0},
             Severity::Error,
             fmt::format("invalid SPIR-V {}: {}", final ? "after optimisation" : "from the compiler", message)});
    });
    if (!tools.Validate(spirv.data(), spirv.size(), options) && diagnostics.size() == before)
        diagnostics.push_back({{file, 0, 0}, Severity::Error, "invalid SPIR-V, and the validator does not say why"});
}

}  // namespace boxcar
