// A file under a temporary name until it is complete. Ctrl-C leaves none behind.
#pragma once

#include <sys/types.h>

#include <string>

#include "tools/base/descriptor.h"

namespace boxcar {

// A new file that will take another file's name. It is removed with this object, or by a signal that ends the
// process: SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU or SIGXFSZ. The process still ends with that signal.
// Signals that the program ignores or handles are left alone.
//
// Limits: SIGKILL leaves the file behind. A signal removes at most 16 files. Each thread may have files of its own.
class TemporaryFile {
public:
    // Makes the file in `folder` ("" is the working folder) with those of the `permissions` that the umask allows. If
    // it cannot be made, Number() is -1 and errno says why, as after open(2).
    TemporaryFile(const std::string& folder, mode_t permissions);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    int Number() const { return m_descriptor.Number(); }

    // As Descriptor::Close().
    bool Close() { return m_descriptor.Close(); }

    // As rename(2). After that the file is no longer temporary.
    bool RenameTo(const std::string& path);

private:
    std::string m_name;  // "" if there is no such file
    Descriptor m_descriptor;
};

}  // namespace boxcar
