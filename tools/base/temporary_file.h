// A file that has a name of its own only until it is complete; ctrl-C leaves none behind.
#pragma once

#include <sys/types.h>

#include <string>

#include "tools/base/descriptor.h"

namespace boxcar {

// A new file that will take another's name. It is gone with this object, or with a signal that ends the process:
// SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU or SIGXFSZ, after which the process still ends by that signal. A
// signal that is ignored, or that the program handles, stays so.
//
// Limits: SIGKILL leaves the file. Past 16 files at a time, a signal leaves those. Threads may each have their own.
class TemporaryFile {
public:
    // Makes the file in `folder` (empty: the working folder) with those of the `permissions` that the umask allows.
    // Where it cannot be made, Number() is -1 and errno as of open(2).
    TemporaryFile(const std::string& folder, mode_t permissions);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    int Number() const { return m_descriptor.Number(); }

    // As Descriptor::Close().
    bool Close() { return m_descriptor.Close(); }

    // As rename(2); then it is no longer temporary.
    bool RenameTo(const std::string& path);

private:
    std::string m_name;  // empty: there is no such file
    Descriptor m_descriptor;
};

}  // namespace boxcar
