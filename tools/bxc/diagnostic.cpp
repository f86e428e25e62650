#include "tools/bxc/diagnostic.h"

#include <algorithm>

namespace boxcar {

bool HasErrors(const Diagnostics& diagnostics) {
    return std::ranges::any_of(diagnostics, [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

std::string ToText(const Diagnostic& diagnostic) {
    std::string text = diagnostic.place.file;
    if (diagnostic.place.line > 0) text += fmt::format(":{}", diagnostic.place.line);
    if (diagnostic.place.line > 0 && diagnostic.place.column > 0) text += fmt::format(":{}", diagnostic.place.column);
    constexpr const char* kNames[] = {"note", "warning", "error"};
    return fmt::format("{}: {}: {}", text, kNames[static_cast<int>(diagnostic.severity)], diagnostic.text);
}

}  // namespace boxcar
