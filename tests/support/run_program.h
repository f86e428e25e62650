// Runs a program as a person would, and looks at what it says.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace boxcar::test {

struct RunResult {
    int exitCode = -1;
    std::string out;  // what it wrote to stdout
    std::string err;  // and to stderr
};

// Runs a program to its end, with an empty stdin.
//
//   words   its name or path, then its arguments. They are passed as they are; no shell reads them
//   folder  its working folder. Nothing else is written there
//
// Fails the test if the program cannot be started or is ended by a signal.
RunResult RunProgram(const std::vector<std::string>& words, const std::filesystem::path& folder);

}  // namespace boxcar::test
