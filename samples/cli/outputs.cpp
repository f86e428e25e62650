#include "samples/cli/outputs.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "samples/cli/options.h"

namespace boxcar {
namespace {

namespace fs = std::filesystem;

std::string EndingOf(const std::string& formatWord) {
    return formatWord == "jpeg" ? ".jpg" : "." + formatWord;
}

FileFormat FormatOf(const std::string& path) {
    try {
        return FormatFromName(path);
    } catch (const Error& error) {
        throw UsageError("{}", error.what());
    }
}

}  // namespace

std::vector<Job> PlanJobs(const OutputOptions& options) {
    std::optional<FileFormat> forced;
    if (!options.formatWord.empty()) forced = FormatFromWord(options.formatWord);

    if (options.output.empty()) throw UsageError("-o: an empty name; a file, folder/ or - is expected");
    if (std::ranges::count(options.inputs, "") > 0) throw UsageError("IN: an empty name; a file or - is expected");
    std::error_code error;
    const bool isFolder = options.output.ends_with('/') || fs::is_directory(options.output, error);
    if (!isFolder) {
        if (options.inputs.size() > 1)
            throw UsageError("-o {}: {} inputs need a folder, as in -o {}/", options.output, options.inputs.size(),
                             options.output);
        if (options.output == "-" && !forced)
            throw UsageError("-o -: standard output needs --format png, jpg, exr or pfm");
        return {{options.inputs[0], options.output, forced ? *forced : FormatOf(options.output)}};
    }

    std::vector<Job> jobs;
    std::map<std::string, std::string> inputOf;
    for (const std::string& input : options.inputs) {
        if (input == "-")
            throw UsageError("-o {}: standard input has no name to keep in a folder; give a file", options.output);
        fs::path name = fs::path(input).filename();
        if (forced) name.replace_extension(EndingOf(options.formatWord));
        const std::string output = (fs::path(options.output) / name).string();
        const auto [known, added] = inputOf.emplace(output, input);
        if (!added) throw UsageError("{} and {} would both be written to {}", known->second, input, output);
        jobs.push_back({input, output, forced ? *forced : FormatOf(output)});
    }
    fs::create_directories(options.output, error);
    if (error) throw Error("{}: cannot make this folder: {}", options.output, error.message());
    return jobs;
}

}  // namespace boxcar
