// What bxc is asked to do: its command line.
#pragma once

#include <span>
#include <string>

#include "tools/bxc/compile_options.h"

namespace boxcar {

enum class Command { Compile, Build, Worker, Help, Version };

struct Options {
    Command command = Command::Help;
    CompileOptions compile;   // of `compile`; of `build`: what every line of the manifest starts from
    std::string manifest;     // of `build`, as are the next four
    std::string outputDir;    // -o
    int jobs = 0;             // -j: worker processes, 1..256; 0 is one a core
    std::string embed;        // --embed NAME: a C++ identifier, or ""
    std::string depfile;      // --depfile FILE, or ""
    int timeoutSeconds = 60;  // --timeout: of one shader, 1..86400
    int maxMemoryMib = 1024;  // --max-memory: resident size of one worker, 64..1048576
    std::string help;         // of `help`: the text to print
};

// `words` is argv without the program's name. Throws UsageError.
Options ParseOptions(std::span<const std::string> words);

}  // namespace boxcar
