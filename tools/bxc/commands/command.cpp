#include "tools/bxc/commands/command.h"

namespace boxcar {

std::string HelpText(std::initializer_list<std::string_view> texts) {
    std::string help;
    for (const std::string_view text : texts)
        help += text.substr(text.starts_with('\n') ? 1 : 0);
    return help;
}

}  // namespace boxcar
