// Reads command lines as fxc, dxc and GNU programs do: -T ps, /T ps, -Tps, --depfile=FILE.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace boxcar {

struct Flag {
    std::string_view name;  // as typed, with its dashes; a slash may stand for a single dash
    size_t valueCount = 0;  // words that follow
    std::function<void(std::span<const std::string> values)> apply;
    bool joined = false;  // the value may follow without a space: -DNAME
    bool told = true;     // listed in the message about an unknown flag
};

// Applies the flags among `words` and returns the other words. Throws UsageError for a flag that is not one of
// `flags` and for a flag without its values.
std::vector<std::string> ParseFlags(std::span<const std::string> words, std::span<const Flag> flags);

// The number in `text`. Throws UsageError naming the flag and the limits.
int ParseNumber(std::string_view flag, const std::string& text, int min, int max);

bool IsIdentifier(std::string_view text);

}  // namespace boxcar
