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
    return fmt::format("{}: {}: {}", text, diagnostic.severity == Severity::Error ? "error" : "warning",
                       diagnostic.text);
}

}  // namespace boxcar
