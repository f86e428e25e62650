#include "tools/bxc/outline.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace boxcar {
namespace {

constexpr size_t kNone = std::string_view::npos;

bool IsName(std::string_view token) {
    return !token.empty() && IsWordChar(token[0]) && !std::isdigit(static_cast<unsigned char>(token[0]));
}

bool IsOneOf(std::string_view token, std::string_view characters) {
    return token.size() == 1 && characters.find(token[0]) != kNone;
}

}  // namespace

Outline::Outline(std::string preprocessed, const std::string& mainFile, const Source& source)
    : m_source(&source), m_text(std::move(preprocessed)), m_files{mainFile} {
    int line = 1;
    for (size_t begin = 0, end = 0; begin < m_text.size(); begin = end + 1, ++line) {
        end = std::min(m_text.find('\n', begin), m_text.size());
        const std::string_view text = std::string_view(m_text).substr(begin, end - begin);
        if (!text.starts_with("#line ")) {
            ReadLine(begin, end, line);
            continue;
        }
        line = std::atoi(&m_text[begin + 6]) - 1;  // #line 12 "file" numbers the next line
        if (const size_t quote = text.find('"'); quote != kNone)
            m_files.emplace_back(text.substr(quote + 1, text.rfind('"') - quote - 1));
    }
}

// Words of letters and digits, and all else character by character.
void Outline::ReadLine(size_t begin, size_t end, int line) {
    int depth = m_tokens.empty() ? 0 : m_tokens.back().depth + (IsOneOf(Text(m_tokens.size() - 1), "({[") ? 1 : 0);
    while (begin < end) {
        size_t length = 1;
        if (IsWordChar(m_text[begin]))
            while (begin + length < end && IsWordChar(m_text[begin + length]))
                ++length;
        const std::string_view token = std::string_view(m_text).substr(begin, length);
        if (IsOneOf(token, ")}]")) --depth;
        if (!std::isspace(static_cast<unsigned char>(token[0])))
            m_tokens.push_back({begin, length, m_files.size() - 1, line, depth});
        if (IsOneOf(token, "({[")) ++depth;
        begin += length;
    }
}

std::string_view Outline::Text(size_t index) const {
    if (index >= m_tokens.size()) return {};
    return std::string_view(m_text).substr(m_tokens[index].begin, m_tokens[index].length);
}

SourcePlace Outline::PlaceOf(size_t index) const {
    if (index == kNone) return {m_files[0], 1, 0};
    return m_source->PlaceOf(m_files[m_tokens[index].file], m_tokens[index].line, Text(index));
}

size_t Outline::ClosingOf(size_t opening) const {
    for (size_t i = opening + 1; i < m_tokens.size(); ++i)
        if (m_tokens[i].depth == m_tokens[opening].depth) return i;
    return m_tokens.size();
}

// The preprocessor's reading: only round brackets keep a comma from ending an argument.
size_t Outline::ArgumentCount(size_t opening) const {
    if (Text(opening) != "(") return 0;
    const size_t closing = ClosingOf(opening);
    size_t count = closing > opening + 1 ? 1 : 0;
    int nested = 0;
    for (size_t i = opening + 1; i < closing; ++i) {
        nested += (Text(i) == "(") - (Text(i) == ")");
        if (Text(i) == "," && nested == 0) ++count;
    }
    return count;
}

size_t Outline::FindFunction(std::string_view name) const {
    for (size_t i = 0; i < m_tokens.size(); ++i) {
        if (m_tokens[i].depth != 0 || Text(i) != name || Text(i + 1) != "(") continue;
        const size_t after = ClosingOf(i + 1) + 1;
        if (Text(after) == "{" || Text(after) == ":") return i;
    }
    return kNone;
}

// Among the parameters or fields between the brackets at `opening`, and in the structs that they are of. The function
// or struct that they belong to starts at token `owner`, and sees what is declared before.
size_t Outline::FindVariable(std::string_view name, size_t owner, size_t opening) const {
    std::string_view type;
    const size_t end = ClosingOf(opening);
    for (size_t i = opening + 1; i < end; ++i) {
        if (m_tokens[i].depth != m_tokens[opening].depth + 1 || !IsName(Text(i))) continue;
        const bool isDeclared = IsOneOf(Text(i + 1), ":;,)[=") && Text(i - 1) != ":";
        if (!isDeclared) {
            type = Text(i);
        } else if (Text(i) == name) {
            return i;
        } else if (const size_t field = FindField(name, type, owner); field != kNone) {
            return field;
        }
    }
    return kNone;
}

// In a struct that is declared before token `before`.
size_t Outline::FindField(std::string_view name, std::string_view structName, size_t before) const {
    for (size_t i = 0; i < before; ++i)
        if (Text(i) == "struct" && Text(i + 1) == structName && Text(i + 2) == "{")
            return FindVariable(name, i, i + 2);
    return kNone;
}

SourcePlace Outline::Global(std::string_view name) const {
    for (size_t i = 0; i < m_tokens.size(); ++i)
        if (m_tokens[i].depth == 0 && Text(i) == name) return PlaceOf(i);
    return PlaceOf(kNone);
}

std::vector<Outline::Mention> Outline::Mentions(std::string_view name) const {
    std::vector<Mention> mentions;
    for (size_t i = 0; i < m_tokens.size(); ++i)
        if (Text(i) == name) mentions.push_back({i > 0 && Text(i - 1) == ".", ArgumentCount(i + 1)});
    return mentions;
}

std::optional<SourcePlace> Outline::Function(std::string_view name) const {
    const size_t function = FindFunction(name);
    return function == kNone ? std::nullopt : std::optional(PlaceOf(function));
}

SourcePlace Outline::Input(std::string_view function, std::string_view name) const {
    const size_t at = FindFunction(function);
    if (at == kNone) return PlaceOf(kNone);
    return PlaceOf(FindVariable(name.substr(0, name.find('[')), at, at + 1));
}

SourcePlace Outline::Output(std::string_view function, std::string_view name) const {
    const size_t at = FindFunction(function);
    if (at == kNone || name.empty()) return PlaceOf(at);
    const std::string_view returnType = at > 0 ? Text(at - 1) : std::string_view();
    const size_t field = FindField(name.substr(0, name.find('[')), returnType, at);
    return field != kNone ? PlaceOf(field) : Input(function, name);
}

}  // namespace boxcar
