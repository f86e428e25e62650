#include "tools/bxc/permute.h"

#include <algorithm>
#include <cstddef>

#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr size_t kMaxPermutations = 4096;
constexpr ptrdiff_t kMaxBracesOfAWord = 16;

// A flag and its value are one choice, however they are written.
bool IsFlag(std::string_view word, char letter) {
    return word.size() == 2 && (word[0] == '-' || word[0] == '/') && word[1] == letter;
}

// "A={1,2}" -> "A=1", "A=2". A word without braces stands for itself.
std::vector<std::string> Alternatives(const std::string& word) {
    if (std::ranges::count(word, '{') > kMaxBracesOfAWord)
        throw UsageError("more than {} braces in one word", kMaxBracesOfAWord);
    std::vector<std::string> words = {word};
    const auto hasBraces = [](const std::string& each) {
        return each.find('}', std::min(each.find('{'), each.size())) != std::string::npos;
    };
    while (std::ranges::any_of(words, hasBraces)) {
        std::vector<std::string> chosen;
        for (const std::string& each : words) {
            if (!hasBraces(each)) {
                chosen.push_back(each);
                continue;
            }
            const size_t opening = each.find('{'), closing = each.find('}', opening);
            if (closing == opening + 1) throw UsageError("'{}': braces without a value", word);
            for (size_t start = opening + 1; start <= closing;) {
                const size_t end = std::min(each.find(',', start), closing);
                chosen.push_back(each.substr(0, opening) + each.substr(start, end - start) +
                                 each.substr(closing + 1));
                start = end + 1;
            }
            if (chosen.size() > kMaxPermutations) throw UsageError("more than {} permutations", kMaxPermutations);
        }
        words = std::move(chosen);
    }
    return words;
}

// What a choice adds to the name of the output, without the dot: "TAPS=2" of -D TAPS=2, -DTAPS=2 and {-D TAPS=2,}.
std::string NameOf(std::string_view before, std::string_view choice, const std::string& word) {
    const bool isFlagOrValue = choice.starts_with('-') || before.starts_with('-') || before.starts_with('/');
    if (!isFlagOrValue) return "";  // the file
    if (choice.starts_with("-D")) choice.remove_prefix(2);
    if (choice.starts_with('-')) choice.remove_prefix(1);
    if (choice.find('/') != std::string_view::npos)
        throw UsageError("'{}': a value in braces becomes part of a file name: expected no /", word);
    return std::string(choice);
}

void Append(Permutation& line, const std::string& choice, const std::string& word) {
    const std::string before = line.words.empty() ? "" : line.words.back();
    const bool isChosen = choice != word;
    if (isChosen && choice.empty()) {
        if (IsFlag(before, 'D')) line.words.pop_back();
        return;
    }
    line.words.push_back(choice);
    if (!isChosen) return;
    const bool isJoinedEntry = choice.starts_with("-E");
    if (IsFlag(before, 'E') || isJoinedEntry) {
        line.entryFromBraces = choice.substr(isJoinedEntry ? 2 : 0);
    } else if (const std::string name = NameOf(before, choice, word); !name.empty()) {
        line.suffix += "." + name;
    }
}

}  // namespace

std::vector<std::string> SplitWords(std::string_view line) {
    std::vector<std::string> words;
    std::string word;
    bool inWord = false, inQuotes = false, inBraces = false;
    for (const char c : line) {
        if (c == '"') {
            inQuotes = !inQuotes;
            inWord = true;
            continue;
        }
        const bool isSpace = c == ' ' || c == '\t' || c == '\r';
        if (!inQuotes) {
            if (c == '#' && !inWord) break;
            if (c == '{') inBraces = true;
            if (c == '}') inBraces = false;
            if (isSpace && inBraces) continue;
            if (isSpace) {
                if (inWord) words.push_back(word);
                word.clear();
                inWord = false;
                continue;
            }
        }
        word += c;
        inWord = true;
    }
    if (inQuotes) throw UsageError("a \" that is never closed");
    if (inBraces) throw UsageError("a {{ that is never closed");
    if (inWord) words.push_back(word);
    return words;
}

std::vector<Permutation> Permute(const std::vector<std::string>& words) {
    std::vector<Permutation> lines(1);
    for (const std::string& word : words) {
        const std::vector<std::string> choices = Alternatives(word);
        if (lines.size() * choices.size() > kMaxPermutations)
            throw UsageError("more than {} permutations", kMaxPermutations);
        std::vector<Permutation> multiplied;
        for (const Permutation& line : lines)
            for (const std::string& choice : choices)
                Append(multiplied.emplace_back(line), choice, word);
        lines = std::move(multiplied);
    }
    return lines;
}

}  // namespace boxcar
