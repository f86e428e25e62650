#include "tools/bxc/manifest.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "tools/bxc/permute.h"
#include "tools/bxc/source.h"

namespace boxcar {
namespace {

namespace fs = std::filesystem;

std::string WithoutEnding(std::string name, std::string_view ending) {
    if (name.ends_with(ending)) name.resize(name.size() - ending.size());
    return name;
}

// One shader of a line, not named yet.
struct Entry {
    int line;
    Permutation permutation;
    CompileOptions options;
};

// What -o gives that may be a folder. A name belongs to one line; what lines share is a folder, as in ShaderMake.
std::set<std::string> FoldersIn(const std::vector<Entry>& entries) {
    std::map<std::string, int> lineOf;
    std::set<std::string> folders;
    for (const Entry& entry : entries) {
        const std::string& output = entry.options.output;
        if (output.empty() || output.ends_with(".spv")) continue;
        const auto [other, isNew] = lineOf.emplace(output, entry.line);
        if (output.ends_with('/') || other->second != entry.line) folders.insert(output);
    }
    return folders;
}

// The shader's name: its output's path in the output folder, without .spv.
std::string OutputName(const CompileOptions& options, const Permutation& line, const std::set<std::string>& folders) {
    const bool isFolder = folders.contains(options.output);
    const std::string& given = options.binary.empty() ? options.output : options.binary;
    std::string name;
    if (!given.empty() && !isFolder) {
        name = WithoutEnding(given, ".spv");
        if (!line.entryFromBraces.empty()) name += "." + line.entryFromBraces;
    } else {
        fs::path file = options.file;
        if (isFolder) file = options.output / file.filename();
        name = WithoutEnding(file.generic_string(), ".hlsl");
        if (options.entry != "main") name += "." + options.entry;
    }
    const fs::path path = fs::path(name + options.outputSuffix + line.suffix).lexically_normal();
    if (path.is_absolute() || *path.begin() == ".." || !path.has_filename())
        throw UsageError("the output '{}' is outside the output folder; give its name with -o NAME.spv",
                         path.string());
    return path.generic_string();
}

// Which lines count: #ifdef NAME, #if 0, #if 1, #else, #endif, as ShaderMake's manifests have them.
class Conditions {
public:
    explicit Conditions(const std::vector<Define>& defines) : m_defines(defines) {}

    // True if the line is one of these. Throws UsageError for one that has nothing to end.
    bool Read(const std::vector<std::string>& words) {
        if (words[0] == "#ifdef" && words.size() > 1)
            m_open.push_back(IsDefined(words[1]));
        else if (words[0] == "#if" && words.size() > 1 && (words[1] == "0" || words[1] == "1"))
            m_open.push_back(words[1] == "1");
        else if ((words[0] == "#else" || words[0] == "#endif") && m_open.empty())
            throw UsageError("{} without #ifdef NAME, #if 0 or #if 1", words[0]);
        else if (words[0] == "#else")
            m_open.back() = !m_open.back();
        else if (words[0] == "#endif")
            m_open.pop_back();
        else
            return false;
        return true;
    }

    bool Hold() const { return std::ranges::find(m_open, false) == m_open.end(); }
    bool AreClosed() const { return m_open.empty(); }

private:
    bool IsDefined(const std::string& name) const {
        return std::ranges::find(m_defines, name, &Define::name) != m_defines.end();
    }

    const std::vector<Define>& m_defines;
    std::vector<bool> m_open;
};

// The words of a directive; none if the line is something else.
std::vector<std::string> DirectiveWords(std::string_view line) {
    std::vector<std::string> words;
    std::istringstream stream{std::string(line)};
    for (std::string word; stream >> word;)
        words.push_back(word);
    if (words.empty() || !words[0].starts_with('#')) return {};
    return words;
}

bool IsComment(std::string_view line) {
    const size_t begin = line.find_first_not_of(" \t");
    return begin != std::string_view::npos && line.substr(begin).starts_with("//");
}

}  // namespace

std::vector<ShaderJob> ParseManifest(std::string_view text, const std::string& manifestFile,
                                     const std::string& outputDir, const CompileOptions& defaults,
                                     Diagnostics& diagnostics) {
    const std::string root = fs::path(manifestFile).parent_path().generic_string();
    std::vector<Entry> entries;
    Conditions conditions(defaults.defines);
    const auto readLine = [&](std::string_view lineText, int line) {
        const std::vector<std::string> directive = DirectiveWords(lineText);
        if ((!directive.empty() && conditions.Read(directive)) || !conditions.Hold() || IsComment(lineText)) return;
        for (const Permutation& permutation : Permute(SplitWords(lineText))) {
            if (permutation.words.empty()) continue;
            const CompileOptions options = ParseCompileOptions(permutation.words, defaults);
            if (!options.header.empty())
                throw UsageError(
                    "'-Fh {}': a line of a manifest cannot have a header; --embed NAME makes one for all of them",
                    options.header);
            entries.push_back({line, permutation, options});
        }
    };
    const size_t first = diagnostics.size();
    const auto report = [&](int line, const std::string& error) {
        diagnostics.push_back({{manifestFile, line, 0}, Severity::Error, error});
    };
    int line = 0;
    while (!text.empty()) {
        const size_t end = std::min(text.find('\n'), text.size());
        try {
            readLine(text.substr(0, end), ++line);
        } catch (const UsageError& error) {
            report(line, error.what());
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (!conditions.AreClosed()) report(line, "a condition that no #endif ends");

    std::vector<ShaderJob> jobs;
    std::map<std::string, int> lineOfOutput;
    const std::set<std::string> folders = FoldersIn(entries);
    for (Entry& entry : entries) {
        try {
            const std::string name = OutputName(entry.options, entry.permutation, folders);
            const auto [other, isNew] = lineOfOutput.emplace(name, entry.line);
            if (!isNew) throw UsageError("the output '{}.spv' is also written by line {}", name, other->second);
            entry.options.output = name;
            jobs.push_back({root, entry.options, (fs::path(outputDir) / (name + ".spv")).generic_string()});
        } catch (const UsageError& error) {
            report(entry.line, error.what());
        }
    }
    std::stable_sort(diagnostics.begin() + static_cast<ptrdiff_t>(first), diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.place.line < b.place.line; });
    return jobs;
}

std::vector<ShaderJob> ReadManifest(const std::string& manifestFile, const std::string& outputDir,
                                    const CompileOptions& defaults, Diagnostics& diagnostics) {
    Source source("", {});
    std::string error;
    const Source::File* file = source.Open(manifestFile, error);
    if (!file) throw Error("{}", error);
    CompileOptions relative = defaults;
    for (std::string& dir : relative.includeDirs)
        dir = fs::proximate(dir, fs::absolute(manifestFile).parent_path()).generic_string();
    return ParseManifest(file->text, manifestFile, outputDir, relative, diagnostics);
}

}  // namespace boxcar
