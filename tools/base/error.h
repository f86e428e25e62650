// How every part of Boxcar reports errors: those of the outside world and those of a caller.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "tools/base/printable.h"

namespace boxcar {

// Something outside the program is wrong: a file, a device, a flag. The text names the offending value and what would
// be accepted. It is made Printable(), so it is one line of UTF-8 whatever the value is. Programs print it after
// their own name and exit with 1.
class Error : public std::runtime_error {
public:
    template <typename... Args>
    explicit Error(fmt::format_string<Args...> format, Args&&... args)
        : std::runtime_error(Printable(fmt::format(format, std::forward<Args>(args)...))) {}
};

// The command line is wrong. Programs exit with 2.
class UsageError : public Error {
public:
    using Error::Error;
};

// Prints the broken condition and aborts.
[[noreturn]] void AssertFailed(const char* condition, const char* file, int line);

}  // namespace boxcar

// For mistakes of the caller, never of the outside world. On in release builds.
#define BOXCAR_ASSERT(condition) ((condition) ? void() : ::boxcar::AssertFailed(#condition, __FILE__, __LINE__))
