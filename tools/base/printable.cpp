#include "tools/base/printable.h"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>

namespace boxcar {
namespace {

struct Character {
    size_t bytes;  // 0: `text` does not begin with UTF-8
    uint32_t code;
};

// The first character of `text`, which is not empty. Unicode 15, table 3-7
Character FirstOf(std::string_view text) {
    const auto at = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
    if (at(0) < 0x80) return {1, at(0)};
    const size_t bytes = at(0) >= 0xf0 ? 4 : at(0) >= 0xe0 ? 3 : 2;
    if (at(0) < 0xc2 || at(0) > 0xf4 || text.size() < bytes) return {0, 0};
    uint32_t code = at(0) & (0xffu >> (bytes + 1));
    for (size_t i = 1; i < bytes; i++) {
        if ((at(i) & 0xc0) != 0x80) return {0, 0};
        code = code << 6 | (at(i) & 0x3fu);
    }
    const bool isOverlong = code < (bytes == 4 ? 0x10000u : bytes == 3 ? 0x800u : 0x80u);
    const bool isSurrogate = code >= 0xd800 && code <= 0xdfff;
    return isOverlong || isSurrogate || code > 0x10ffff ? Character{0, 0} : Character{bytes, code};
}

// C0, DEL and C1; the separators of lines and paragraphs; marks, embeddings and isolates of the bidirectional order.
bool IsControl(uint32_t code) {
    const auto within = [&](uint32_t first, uint32_t last) { return code >= first && code <= last; };
    return code < 0x20 || within(0x7f, 0x9f) || within(0x200e, 0x200f) || within(0x2028, 0x202e) ||
           within(0x2066, 0x2069) || code == 0x061c;
}

std::string Escaped(std::string_view text, bool controlsToo) {
    std::string escaped;
    while (!text.empty()) {
        const auto [bytes, code] = FirstOf(text);
        const std::string_view character = text.substr(0, bytes > 0 ? bytes : 1);
        text.remove_prefix(character.size());
        if (bytes > 0 && !(controlsToo && IsControl(code))) {
            escaped += character;
        } else if (bytes > 0 && (code == '\n' || code == '\r' || code == '\t')) {
            escaped += code == '\n' ? "\\n" : code == '\r' ? "\\r" : "\\t";
        } else {
            for (const char byte : character)
                fmt::format_to(std::back_inserter(escaped), "\\x{:02x}", static_cast<uint8_t>(byte));
        }
    }
    return escaped;
}

}  // namespace

std::string Printable(std::string_view text) {
    return Escaped(text, true);
}

std::string ValidUtf8(std::string_view text) {
    return Escaped(text, false);
}

}  // namespace boxcar
