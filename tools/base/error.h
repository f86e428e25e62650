// How every part of Boxcar reports what the outside did wrong, and what a caller did wrong.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "tools/base/printable.h"

namespace boxcar {

// Something outside the program is not as it must be: a file, a device, a flag. The text names the offending value
// and what would be accepted; it is made Printable(), so it is one line of UTF-8 whatever the value is. Programs
// print it after their own name and exit 1.
class Error : public std::runtime_error {
public:
    template <typename... Args>
    explicit Error(fmt::format_string<Args...> format, Args&&... args)
        : std::runtime_error(Printable(fmt::format(format, std::forward<Args>(args)...))) {}
};

// The command line is wrong. Programs exit 2.
class UsageError : public Error {
public:
    using Error::Error;
};

// Prints the broken condition and aborts.
[[noreturn]] void AssertFailed(const char* condition, const char* file, int line);

}  // namespace boxcar

// A caller's mistake, never the outside's. On in release builds.
#define BOXCAR_ASSERT(condition) ((condition) ? void() : ::boxcar::AssertFailed(#condition, __FILE__, __LINE__))
