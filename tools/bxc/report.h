// What the user sees: each message once, on stderr, as soon as it is there; one line on stdout at the end of a build.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "tools/bxc/diagnostic.h"

namespace boxcar {

class Report {
public:
    ~Report() { ClearProgress(); }

    // Prints the messages that have not been printed before, with their notes, one line each. File names in them
    // are relative to `root`.
    void Add(const Diagnostics& diagnostics, const std::string& root);

    // Shows how far a build is, on a terminal only.
    void Progress(size_t done, size_t total, const std::string& name);

    // "bxc: 12 shaders: 3 compiled, 9 up to date"
    void Summary(size_t compiled, size_t upToDate, size_t failed);

private:
    void ClearProgress();

    std::set<std::string> m_told;
    bool m_progressShown = false;
};

}  // namespace boxcar
