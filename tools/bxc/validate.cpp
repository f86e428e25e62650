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

std::optional<SpirvFault> FindFault(const std::vector<uint32_t>& spirv, ValidationStep step) {
    spvtools::ValidatorOptions options;
    options.SetBeforeHlslLegalization(step == ValidationStep::BeforeLegalization);

    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_1);
    std::optional<SpirvFault> fault;
    tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t& place, const char* message) {
        if (!fault) fault = SpirvFault{OneLine(message), place.index};
    });
    if (tools.Validate(spirv.data(), spirv.size(), options)) return std::nullopt;
    return fault ? fault : SpirvFault{"the validator does not say why", 0};
}

}  // namespace boxcar
