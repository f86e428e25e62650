#include "tools/bxc/validate.h"

#include <spirv-tools/libspirv.hpp>
#include <sstream>

namespace boxcar {
namespace {

// The validator's message, and the instructions that it shows below, in one line.
std::string OneLine(const std::string& message) {
    std::string text, line;
    for (std::istringstream lines(message); std::getline(lines, line);) {
        const size_t begin = line.find_first_not_of(' ');
        if (begin != std::string::npos) text += (text.empty() ? "" : "; ") + line.substr(begin);
    }
    return text;
}

}  // namespace

void Validate(const std::vector<uint32_t>& spirv, ValidationStep step, const std::string& file,
              Diagnostics& diagnostics) {
    const bool final = step == ValidationStep::Final;
    spvtools::ValidatorOptions options;
    options.SetBeforeHlslLegalization(!final);

    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_1);
    const size_t before = diagnostics.size();
    tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
        diagnostics.push_back({{file, 0, 0},
                               Severity::Error,
                               fmt::format("invalid SPIR-V {}: {}",
                                           final ? "after optimisation" : "from the compiler", OneLine(message))});
    });
    if (!tools.Validate(spirv.data(), spirv.size(), options) && diagnostics.size() == before)
        diagnostics.push_back({{file, 0, 0}, Severity::Error, "invalid SPIR-V, and the validator does not say why"});
}

}  // namespace boxcar
