#include "tools/bxc/header.h"

#include <fmt/format.h>

#include <cstddef>

#include "tools/base/printable.h"

namespace boxcar {

std::string CHeader(std::span<const uint32_t> spirv, const CompileOptions& options) {
    std::string text = fmt::format(
        "// Made by bxc of {}, {}.\n"
        "#if defined(__cplusplus)\n"
        "alignas(4)\n"
        "#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L\n"
        "_Alignas(4)\n"
        "#endif\n"
        "const unsigned char {}[] = {{",
        Printable(options.file), options.entry, options.variable.empty() ? "g_" + options.entry : options.variable);
    constexpr size_t kBytesOfALine = 20;
    size_t count = 0;
    for (const std::byte byte : std::as_bytes(spirv))
        text +=
            fmt::format("{}0x{:02x},", count++ % kBytesOfALine == 0 ? "\n    " : " ", static_cast<unsigned>(byte));
    return text + "\n};\n";
}

}  // namespace boxcar
