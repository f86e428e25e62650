// What bxc can be asked to do. Each command is one file in this folder: its options, its help, its work.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace boxcar {

struct Command {
    std::string_view name;                           // the first word of the command line
    int (*run)(std::span<const std::string> words);  // the words after it; returns the exit code. Throws UsageError
    std::string (*help)();                           // nullptr: not for people
};

// The texts one after another. Each starts with a line break, so that it looks in the source as it does on the
// screen; those line breaks are left out.
std::string HelpText(std::initializer_list<std::string_view> texts);

}  // namespace boxcar
