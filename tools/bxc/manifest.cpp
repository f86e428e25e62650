#include "tools/bxc/manifest.h"

#include <algorithm>
#include <filesystem>
#include <map>
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

// The shader's name: its output's path in the output folder, without .spv.
std::string OutputName(const CompileOptions& options, const Permutation& line) {
    std::string name;
    if (!options.binary.empty() || options.output.ends_with(".spv")) {
        name = WithoutEnding(options.binary.empty() ? options.output : options.binary, ".spv");
        if (!line.entryFromBraces.empty()) name += "." + line.entryFromBraces;
    } else {
        fs::path file = options.file;
        if (!options.output.empty()) file = options.output / file.filename();
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
    std::vector<ShaderJob> jobs;
    std::map<std::string, int> lineOfOutput;
    Conditions conditions(defaults.defines);
    const auto readLine = [&](std::string_view lineText, int line) {
        const std::vector<std::string> directive = DirectiveWords(lineText);
        if ((!directive.empty() && conditions.Read(directive)) || !conditions.Hold() || IsComment(lineText)) return;
        for (const Permutation& permutation : Permute(SplitWords(lineText))) {
            if (permutation.words.empty()) continue;
            ShaderJob job{root, ParseCompileOptions(permutation.words, defaults), ""};
            if (!job.options.header.empty())
                throw UsageError("'-Fh {}': in a manifest no line has a header; --embed NAME makes one of them all",
                                 job.options.header);
            job.options.output = OutputName(job.options, permutation);
            job.output = (fs::path(outputDir) / (job.options.output + ".spv")).generic_string();
            const auto [other, isNew] = lineOfOutput.emplace(job.options.output, line);
            if (!isNew)
                throw UsageError("the output '{}.spv' is also written by line {}", job.options.output, other->second);
            jobs.push_back(std::move(job));
        }
    };
    int line = 0;
    const auto report = [&](const std::string& error) {
        diagnostics.push_back({{manifestFile, line, 0}, Severity::Error, error});
    };
    while (!text.empty()) {
        ++line;
        const size_t end = std::min(text.find('\n'), text.size());
        try {
            readLine(text.substr(0, end), line);
        } catch (const UsageError& error) {
            report(error.what());
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (!conditions.AreClosed()) report("a condition without its #endif");
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
