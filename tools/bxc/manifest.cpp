#include "tools/bxc/manifest.h"

#include <filesystem>
#include <map>

#include "tools/bxc/source.h"

namespace boxcar {
namespace {

namespace fs = std::filesystem;

// Splits at spaces outside "" and {}; drops what follows a #.
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
    if (inQuotes) throw UsageError("a \" without its partner");
    if (inBraces) throw UsageError("a {{ without its }}");
    if (inWord) words.push_back(word);
    return words;
}

// "{2,4}" -> "2", "4"; anything else -> nothing.
std::vector<std::string> Alternatives(const Define& define) {
    const std::string_view text = define.value;
    if (!text.starts_with('{') || !text.ends_with('}')) return {};
    std::vector<std::string> values;
    for (size_t start = 1; start < text.size();) {
        const size_t end = std::min(text.find(',', start), text.size() - 1);
        values.emplace_back(text.substr(start, end - start));
        if (values.back().empty() || values.back().find('/') != std::string::npos)
            throw UsageError(
                "'-D {}={}': a value in braces becomes part of a file name: expected at least one "
                "character and no /",
                define.name, define.value);
        start = end + 1;
    }
    return values;
}

// A shader under construction: the values in braces that it has taken so far are part of its name.
struct Permutation {
    CompileOptions options;
    std::string suffix;
};

std::vector<Permutation> Permute(const CompileOptions& options) {
    std::vector<Permutation> permutations = {{options, ""}};
    for (size_t i = 0; i < options.defines.size(); ++i) {
        const std::vector<std::string> values = Alternatives(options.defines[i]);
        if (values.empty()) continue;
        std::vector<Permutation> multiplied;
        for (const Permutation& permutation : permutations)
            for (const std::string& value : values) {
                multiplied.push_back(permutation);
                multiplied.back().options.defines[i].value = value;
                multiplied.back().suffix += fmt::format(".{}={}", options.defines[i].name, value);
            }
        permutations = std::move(multiplied);
        if (permutations.size() > 4096) throw UsageError("more than 4096 permutations");
    }
    return permutations;
}

std::string WithoutEnding(std::string name, std::string_view ending) {
    if (name.ends_with(ending)) name.resize(name.size() - ending.size());
    return name;
}

// The shader's name: its output's path in the output folder, without .spv.
std::string OutputName(const Permutation& permutation) {
    const CompileOptions& options = permutation.options;
    std::string name = WithoutEnding(options.output, ".spv");
    if (name.empty()) {
        name = WithoutEnding(options.file, ".hlsl");
        if (options.entry != "main") name += "." + options.entry;
    }
    const fs::path path = fs::path(name + permutation.suffix).lexically_normal();
    if (path.is_absolute() || *path.begin() == ".." || !path.has_filename())
        throw UsageError("the output '{}' is outside the output folder; give its name with -o NAME.spv",
                         path.string());
    return path.generic_string();
}

}  // namespace

std::vector<ShaderJob> ParseManifest(std::string_view text, const std::string& manifestFile,
                                     const std::string& outputDir, Diagnostics& diagnostics) {
    const std::string root = fs::path(manifestFile).parent_path().generic_string();
    std::vector<ShaderJob> jobs;
    std::map<std::string, int> lineOfOutput;
    for (int line = 1; !text.empty(); ++line) {
        const size_t end = std::min(text.find('\n'), text.size());
        const std::string_view lineText = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        try {
            const std::vector<std::string> words = SplitWords(lineText);
            if (words.empty()) continue;
            for (const Permutation& permutation : Permute(ParseCompileOptions(words))) {
                ShaderJob job{root, permutation.options, ""};
                job.options.output = OutputName(permutation);
                job.output = (fs::path(outputDir) / (job.options.output + ".spv")).generic_string();
                const auto [other, isNew] = lineOfOutput.emplace(job.options.output, line);
                if (!isNew)
                    throw UsageError("the output '{}.spv' is also written by line {}", job.options.output,
                                     other->second);
                jobs.push_back(std::move(job));
            }
        } catch (const UsageError& error) {
            diagnostics.push_back({{manifestFile, line, 0}, Severity::Error, error.what()});
        }
    }
    return jobs;
}

std::vector<ShaderJob> ReadManifest(const std::string& manifestFile, const std::string& outputDir,
                                    Diagnostics& diagnostics) {
    Source source("", {});
    std::string error;
    const Source::File* file = source.Open(manifestFile, error);
    if (!file) throw Error("{}", error);
    return ParseManifest(file->text, manifestFile, outputDir, diagnostics);
}

}  // namespace boxcar
