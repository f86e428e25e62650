#include "tools/bxc/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "tools/base/error.h"
#include "tools/base/read_file.h"

namespace boxcar {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxFileBytes = 16 << 20;
constexpr size_t kMaxIncludeDepth = 64;

// Throws Error: the file cannot be read, is longer than 16 MiB or is not text.
std::string ReadText(const fs::path& path, const std::string& name) {
    const std::string shown = fmt::format("'{}'", name);
    const std::vector<uint8_t> bytes = ReadFile(path, {shown, kMaxFileBytes});
    std::string text(bytes.begin(), bytes.end());
    if (const size_t zero = text.find('\0'); zero != std::string::npos)
        throw Error("{}: not text: byte {} is 0", shown, zero);
    if (!text.empty() && std::iscntrl(bytes[0]) && !std::isspace(bytes[0]))
        throw Error("{}: not text: byte 0 is {}", shown, bytes[0]);
    if (constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf"; text.starts_with(kByteOrderMark))
        text.erase(0, kByteOrderMark.size());
    return text;
}

// Position of `word` in `text` as a whole word, or npos.
size_t FindWord(std::string_view text, std::string_view word) {
    if (word.empty()) return std::string_view::npos;
    for (size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const bool startsInside = at > 0 && IsWordChar(word.front()) && IsWordChar(text[at - 1]);
        const size_t end = at + word.size();
        const bool endsInside = end < text.size() && IsWordChar(word.back()) && IsWordChar(text[end]);
        if (!startsInside && !endsInside) return at;
    }
    return std::string_view::npos;
}

}  // namespace

bool IsWordChar(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

Source::Source(std::string root, std::vector<std::string> includeDirs)
    : m_root(std::move(root)), m_includeDirs(std::move(includeDirs)) {
    m_includeDirs.push_back("");
}

const Source::File* Source::Open(std::string_view name, std::string& error) {
    const std::string normal = fs::path(name).lexically_normal().generic_string();
    if (const auto known = m_files.find(normal); known != m_files.end()) return &known->second;

    std::string text;
    try {
        text = ReadText(fs::path(m_root) / normal, normal);
    } catch (const Error& problem) {
        error = problem.what();
        return nullptr;
    }
    m_names.push_back(normal);
    return &m_files.emplace(normal, File{normal, std::move(text)}).first->second;
}

const Source::File* Source::Include(std::string_view header, std::string_view includer, size_t depth,
                                    std::string& error) {
    if (depth > kMaxIncludeDepth) {
        error = fmt::format("includes are nested more than {} deep: does a file include itself?", kMaxIncludeDepth);
        return nullptr;
    }
    std::vector<std::string> folders = {fs::path(includer).parent_path().generic_string()};
    folders.insert(folders.end(), m_includeDirs.begin(), m_includeDirs.end());

    std::string searched;
    for (const std::string& folder : folders) {
        const std::string name = (fs::path(folder) / header).generic_string();
        std::error_code none;
        if (fs::exists(fs::path(m_root) / name, none)) return Open(name, error);
        const std::string shown = folder.empty() ? "." : folder;
        if (fmt::format(", {},", searched).find(fmt::format(", {},", shown)) == std::string::npos)
            searched += (searched.empty() ? "" : ", ") + shown;
    }
    error = fmt::format("cannot find '{}'; searched: {}", header, searched);
    return nullptr;
}

std::string_view Source::Line(std::string_view name, int line) const {
    const auto file = m_files.find(name);
    if (file == m_files.end()) return {};
    std::string_view text = file->second.text;
    for (; line > 1; --line) {
        const size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    return text.substr(0, text.find('\n'));
}

SourcePlace Source::PlaceOf(std::string_view name, int line, std::string_view word) const {
    const size_t at = FindWord(Line(name, line), word);
    return {std::string(name), line, at == std::string_view::npos ? 0 : static_cast<int>(at) + 1};
}

bool Source::DefinesMacro(std::string_view name) const {
    constexpr std::string_view kDefine = "define", kSpaces = " \t";
    const auto definesIt = [&](std::string_view text) {
        for (size_t at = FindWord(text, kDefine); at != std::string_view::npos; at = FindWord(text, kDefine)) {
            text.remove_prefix(at + kDefine.size());
            std::string_view rest = text;
            rest.remove_prefix(std::min(rest.find_first_not_of(kSpaces), rest.size()));
            if (rest.starts_with(name) && (rest.size() == name.size() || !IsWordChar(rest[name.size()]))) return true;
        }
        return false;
    };
    return std::ranges::any_of(m_files, [&](const auto& file) { return definesIt(file.second.text); });
}

}  // namespace boxcar
