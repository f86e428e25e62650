// How the library says what the user should know: one line at a time, as soon as it is known.
#pragma once

#include <functional>
#include <string>

namespace boxcar {

// Takes a line without its end. The command line prints it, a window shows it.
using Tell = std::function<void(const std::string& line)>;

}  // namespace boxcar
