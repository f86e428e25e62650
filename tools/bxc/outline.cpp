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

Outline::Outline(std::string_view preprocessed, const std::string& mainFile, const Source& source)
    : m_source(&source), m_mainFile(mainFile) {
    std::string file = mainFile;
    int depth = 0;
    for (int line = 1; !preprocessed.empty(); ++line) {
        const std::string text(preprocessed.substr(0, preprocessed.find('\n')));
        preprocessed.remove_prefix(std::min(text.size() + 1, preprocessed.size()));
        if (text.starts_with("#line ")) {  // #line 12 "file": the number of the next line
            line = std::atoi(&text[6]) - 1;
            if (const size_t quote = text.find('"'); quote != kNone)
                file = text.substr(quote + 1, text.rfind('"') - quote - 1);
            continue;
        }
        for (size_t begin = 0, end = 0; begin < text.size(); begin = end) {
            end = begin + 1;
            if (std::isspace(static_cast<unsigned char>(text[begin]))) continue;
            if (IsWordChar(text[begin]))
                end = std::min(
                    text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_", begin),
                    text.size());
            const std::string token = text.substr(begin, end - begin);
            if (IsOneOf(token, ")}]")) --depth;
            m_tokens.push_back({token, file, line, depth});
            if (IsOneOf(token, "({[")) ++depth;
        }
    }
}

const Outline::Token& Outline::At(size_t index) const {
    static const Token none;
    return index < m_tokens.size() ? m_tokens[index] : none;
}

SourcePlace Outline::PlaceOf(size_t index) const {
    if (index == kNone) return {m_mainFile, 1, 0};
    return m_source->PlaceOf(m_tokens[index].file, m_tokens[index].line, m_tokens[index].text);
}

size_t Outline::ClosingOf(size_t opening) const {
    for (size_t i = opening + 1; i < m_tokens.size(); ++i)
        if (m_tokens[i].depth == m_tokens[opening].depth) return i;
    return m_tokens.size();
}

size_t Outline::FindFunction(std::string_view name) const {
    for (size_t i = 0; i < m_tokens.size(); ++i) {
        if (m_tokens[i].depth != 0 || m_tokens[i].text != name || At(i + 1).text != "(") continue;
        const size_t after = ClosingOf(i + 1) + 1;
        if (At(after).text == "{" || At(after).text == ":") return i;
    }
    return kNone;
}

// Among the declarations from token `begin` to `end`, which are parameters or fields, and in the structs they are of.
size_t Outline::FindVariable(std::string_view name, size_t begin, size_t end) const {
    std::string_view type;
    for (size_t i = begin; i < end; ++i) {
        if (m_tokens[i].depth != m_tokens[begin].depth || !IsName(m_tokens[i].text)) continue;
        const bool isDeclared = IsOneOf(At(i + 1).text, ":;,)[=") && m_tokens[i - 1].text != ":";
        if (!isDeclared) {
            type = m_tokens[i].text;
        } else if (m_tokens[i].text == name) {
            return i;
        } else if (const size_t field = FindField(name, type); field != kNone) {
            return field;
        }
    }
    return kNone;
}

size_t Outline::FindField(std::string_view name, std::string_view structName) const {
    for (size_t i = 0; i < m_tokens.size(); ++i)
        if (m_tokens[i].text == "struct" && At(i + 1).text == structName && At(i + 2).text == "{")
            return FindVariable(name, i + 3, ClosingOf(i + 2));
    return kNone;
}

SourcePlace Outline::Global(std::string_view name) const {
    for (size_t i = 0; i < m_tokens.size(); ++i)
        if (m_tokens[i].depth == 0 && m_tokens[i].text == name) return PlaceOf(i);
    return PlaceOf(kNone);
}

std::optional<SourcePlace> Outline::Function(std::string_view name) const {
    const size_t function = FindFunction(name);
    return function == kNone ? std::nullopt : std::optional(PlaceOf(function));
}

SourcePlace Outline::Input(std::string_view function, std::string_view name) const {
    const size_t at = FindFunction(function);
    if (at == kNone) return PlaceOf(kNone);
    return PlaceOf(FindVariable(name.substr(0, name.find('[')), at + 2, ClosingOf(at + 1)));
}

SourcePlace Outline::Output(std::string_view function, std::string_view name) const {
    const size_t at = FindFunction(function);
    if (at == kNone || name.empty()) return PlaceOf(at);
    const std::string_view returnType = at > 0 ? std::string_view(m_tokens[at - 1].text) : "";
    const size_t field = FindField(name.substr(0, name.find('[')), returnType);
    return field != kNone ? PlaceOf(field) : Input(function, name);
}

}  // namespace boxcar
