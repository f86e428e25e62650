#include "tools/bxc/glslang_log.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <span>
#include <sstream>

namespace boxcar {
namespace {

// What stands before the first `separator`; `text` becomes what follows it. Nothing if there is none.
std::optional<std::string_view> CutAt(std::string_view& text, std::string_view separator) {
    const size_t at = text.find(separator);
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view before = text.substr(0, at);
    text.remove_prefix(at + separator.size());
    return before;
}

std::string_view WithoutSpaces(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
        text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
        text.remove_suffix(1);
    return text;
}

// "file:12: message" -> the place, and `text` becomes the message. Nothing if it does not start with a place.
std::optional<SourcePlace> CutPlace(std::string_view& text) {
    for (size_t colon = text.find(':'); colon != std::string_view::npos; colon = text.find(':', colon + 1)) {
        const size_t end = text.find_first_not_of("0123456789", colon + 1);
        if (end == std::string_view::npos || end == colon + 1 || text.substr(end, 2) != ": ") continue;
        const SourcePlace place{std::string(text.substr(0, colon)), std::atoi(&text[colon + 1]), 0};
        text.remove_prefix(end + 2);
        return place;
    }
    return std::nullopt;
}

// True if an attribute that means nothing to Vulkan stands in the text: it steers Direct3D or its optimizer.
bool HasDirect3dAttribute(std::string_view text) {
    constexpr std::string_view kNames[] = {
        "rootsignature", "shader", "allow_uav_condition", "fastopt",      "call", "forcecase", "isolate",
        "ifall",         "ifany",  "predicate",           "maxtessfactor"};
    std::string word;
    for (const char c : text) {
        if (IsWordChar(c)) {
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            continue;
        }
        if (std::ranges::find(kNames, word) != std::end(kNames)) return true;
        word.clear();
    }
    return false;
}

// A warning that there is nothing to do about:
//   'RootSignature' : unrecognized attribute
//   '' : attribute does not apply to a loop
bool IsIdle(std::string_view message, const SourcePlace& place, const Source& source) {
    if (message.ends_with(": unrecognized attribute")) return HasDirect3dAttribute(message);
    if (!message.starts_with("'' : attribute does not apply to ")) return false;
    // An attribute often has a line of its own, and an entry point several.
    const auto isAttribute = [&](int line) {
        return line > 0 && WithoutSpaces(source.Line(place.file, line)).starts_with('[');
    };
    int line = place.line;
    while (!HasDirect3dAttribute(source.Line(place.file, line)))
        if (!isAttribute(--line)) return false;
    return true;
}

// "'token' : message", as glslang words it -> what bxc says. The column is that of the token.
void ReadMessage(std::string_view message, const Source& source, Diagnostic& diagnostic) {
    std::string_view rest = message;
    constexpr std::string_view kMissing = "Missing functionality: ";
    if (message.starts_with(kMissing)) {
        diagnostic.text = fmt::format("the compiler cannot translate this, which is its fault, not the shader's: {}",
                                      message.substr(kMissing.size()));
        return;
    }
    const auto token = message.starts_with('\'') ? CutAt(rest, "' : ") : std::nullopt;
    if (!token) {
        diagnostic.text = message;
        return;
    }
    const std::string_view word = token->substr(1);
    rest = WithoutSpaces(rest);
    if (rest == "Expected") {  // the token is what is not there
        diagnostic.text = word.empty() || IsWordChar(word[0]) ? fmt::format("expected {}", word)
                                                              : fmt::format("expected '{}'", word);
        return;
    }
    if (word == "#include") rest = rest.substr(0, rest.find(" for header name:"));
    diagnostic.text = word.empty() ? rest : fmt::format("'{}': {}", word, rest);
    diagnostic.place = source.PlaceOf(diagnostic.place.file, diagnostic.place.line, word);
}

// "file(12): error at column 7, HLSL parsing failed.": where the parser stood after the errors of that line. It is
// the column of those that have none; the message itself is told only if there are no others.
bool ReadParserPosition(std::string_view text, const Source& source, std::span<Diagnostic> others,
                        Diagnostics& diagnostics) {
    const auto file = CutAt(text, "(");
    const auto line = CutAt(text, "): error at column ");
    const auto column = CutAt(text, ", HLSL parsing failed.");
    if (!file || !line || !column) return false;
    SourcePlace place{std::string(*file), std::atoi(line->data()), std::atoi(column->data())};
    // The position is the end of the last word that was read.
    const std::string_view lineText = source.Line(place.file, place.line);
    const auto isWord = [&](int at) {
        return at >= 1 && at <= static_cast<int>(lineText.size()) && IsWordChar(lineText[at - 1]);
    };
    while (isWord(place.column) && isWord(place.column - 1))
        --place.column;
    for (Diagnostic& other : others)
        if (other.place.line == place.line && other.place.column == 0) other.place.column = place.column;
    if (others.empty()) diagnostics.push_back({place, Severity::Error, "the parser stopped here"});
    return true;
}

}  // namespace

void AppendGlslangLog(const std::string& log, const std::string& mainFile, const Source& source,
                      Diagnostics& diagnostics) {
    const size_t first = diagnostics.size();
    std::string line;
    for (std::istringstream lines(log); std::getline(lines, line);) {
        std::string_view text = WithoutSpaces(line);
        if (text.empty()) continue;
        if (ReadParserPosition(text, source, std::span(diagnostics).subspan(first), diagnostics)) continue;
        Diagnostic diagnostic{{mainFile, 0, 0}, Severity::Error, ""};
        if (text.starts_with("WARNING: ")) diagnostic.severity = Severity::Warning;
        if (text.starts_with("WARNING: ") || text.starts_with("ERROR: ")) CutAt(text, ": ");
        // The linker's are of line 0 of a file named 0.
        if (const auto place = CutPlace(text); place && place->line > 0) diagnostic.place = *place;
        if (text.ends_with(" compilation errors.  No code generated.") && HasErrors(diagnostics)) continue;
        if (diagnostic.severity == Severity::Warning && IsIdle(text, diagnostic.place, source)) continue;
        ReadMessage(text, source, diagnostic);
        if (std::ranges::find(diagnostics, diagnostic) == diagnostics.end())
            diagnostics.push_back(std::move(diagnostic));
    }
}

}  // namespace boxcar
