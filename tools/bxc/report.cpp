#include "tools/bxc/report.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "tools/base/printable.h"

namespace boxcar {

void Report::Add(const Diagnostics& diagnostics, const std::string& root) {
    bool told = false;
    for (Diagnostic diagnostic : diagnostics) {
        std::string& file = diagnostic.place.file;
        file = (std::filesystem::path(root) / file).lexically_normal().generic_string();
        const std::string text = ToText(diagnostic);
        if (diagnostic.severity != Severity::Note) told = !m_told.insert(text).second;
        if (told) continue;
        ClearProgress();
        fmt::print(stderr, "{}\n", Printable(text));
    }
}

void Report::Progress(size_t done, size_t total, const std::string& name) {
    if (!isatty(STDERR_FILENO)) return;
    ClearProgress();
    fmt::print(stderr, "[{}/{}] {}", done, total, Printable(name));
    std::fflush(stderr);
    m_progressShown = true;
}

void Report::ClearProgress() {
    if (m_progressShown) fmt::print(stderr, "\r\033[K");
    m_progressShown = false;
}

void Report::Summary(size_t compiled, size_t upToDate, size_t failed) {
    ClearProgress();
    std::string text;
    const auto add = [&](size_t count, const char* what) {
        if (count > 0) text += fmt::format("{} {} {}", text.empty() ? ":" : ",", count, what);
    };
    add(compiled, "compiled");
    add(upToDate, "up to date");
    add(failed, "failed");
    const size_t total = compiled + upToDate + failed;
    fmt::print("bxc: {} shader{}{}\n", total, total == 1 ? "" : "s", text);
}

}  // namespace boxcar
