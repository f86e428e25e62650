// Which input goes to which output, in which format.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "samples/files/picture.h"

namespace boxcar {

struct OutputOptions {
    std::vector<std::string> inputs;
    std::string output;
    std::string formatWord;  // --format, or empty
};

struct Job {
    std::string input;
    std::string output;  // a file or "-"
    FileFormat format = FileFormat::Png;
};

// One input: OUT is a file, "-" (which needs --format), or a folder (a name that ends in / or an existing folder).
// Several inputs: OUT is a folder; each keeps its name, with the ending of --format where that is given. The folder
// is made if it is missing. Throws UsageError: no such combination, an unknown ending, two inputs that would be one
// output.
std::vector<Job> PlanJobs(const OutputOptions& options);

}  // namespace boxcar
