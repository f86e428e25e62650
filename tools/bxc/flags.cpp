#include "tools/bxc/flags.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

#include "tools/base/error.h"

namespace boxcar {
namespace {

namespace fs = std::filesystem;

// "-T" is also "/T".
bool Names(const Flag& flag, std::string_view word) {
    return word == flag.name ||
           (word.starts_with('/') && !flag.name.starts_with("--") && word.substr(1) == flag.name.substr(1));
}

std::optional<std::string> JoinedValue(const Flag& flag, std::string_view word) {
    const bool takesPath = flag.name == "-I" || flag.name.starts_with("-F");  // /Iinclude/lib
    const bool slash =
        word.starts_with('/') && (word.find('/', 1) >= word.find('=') || (takesPath && !fs::exists(word)));
    if (flag.joined && word.size() > flag.name.size() && (word[0] == '-' || slash) &&
        word.substr(1).starts_with(flag.name.substr(1)))
        return std::string(word.substr(flag.name.size()));
    const bool takesEquals = flag.name.starts_with("--") || flag.name.starts_with("-f");
    if (const size_t equals = word.find('='); takesEquals && flag.valueCount == 1 &&
                                              equals != std::string_view::npos && Names(flag, word.substr(0, equals)))
        return std::string(word.substr(equals + 1));
    return std::nullopt;
}

bool ApplyJoined(std::span<const Flag> flags, const std::string& word) {
    for (const Flag& flag : flags)
        if (const auto value = JoinedValue(flag, word)) {
            flag.apply({&*value, 1});
            return true;
        }
    return false;
}

}  // namespace

std::vector<std::string> ParseFlags(std::span<const std::string> words, std::span<const Flag> flags) {
    for (const std::string& word : words)
        if (word.find('\n') != std::string::npos)
            throw UsageError("'{}': no makefile can name a word with a line break", word);
    std::vector<std::string> others;
    for (size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (const auto flag = std::ranges::find_if(flags, [&](const Flag& f) { return Names(f, word); });
            flag != flags.end()) {
            if (words.size() - i <= flag->valueCount)
                throw UsageError("'{}' needs {}", word, flag->valueCount == 1 ? "a value" : "two values");
            flag->apply(words.subspan(i + 1, flag->valueCount));
            i += flag->valueCount;
            continue;
        }
        if (ApplyJoined(flags, word)) continue;

        const bool path = word.starts_with('/') && (word.find('/', 1) != std::string::npos || fs::exists(word));
        if (word.size() > 1 && (word[0] == '-' || (word[0] == '/' && !path))) {
            std::string accepted;
            for (const Flag& flag : flags)
                if (flag.told) accepted += (accepted.empty() ? "" : " ") + std::string(flag.name);
            throw UsageError("unknown flag '{}'; accepted: {}", word, accepted);
        }
        others.push_back(word);
    }
    return others;
}

int ParseNumber(std::string_view flag, const std::string& text, int min, int max) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < min || number > max)
        throw UsageError("'{} {}': expected a whole number from {} to {}", flag, text, min, max);
    return number;
}

bool IsIdentifier(std::string_view text) {
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    return !text.empty() && !isDigit(text[0]) &&
           std::ranges::all_of(text, [&](char c) { return isLetter(c) || isDigit(c); });
}

}  // namespace boxcar
