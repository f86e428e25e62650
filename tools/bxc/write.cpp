#include "tools/bxc/write.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <deque>
#include <filesystem>
#include <span>
#include <sstream>

#include "tools/base/descriptor.h"
#include "tools/base/error.h"
#include "tools/base/output_file.h"
#include "tools/base/read_file.h"
#include "tools/bxc/compiler.h"
#include "tools/bxc/header.h"
#include "tools/bxc/version.h"

namespace boxcar {
namespace {

namespace fs = std::filesystem;

bool IsDevice(const std::string& path) {
    if (DescriptorOf(path)) return true;  // /dev/stdout, even where that is a file
    std::error_code none;
    const fs::file_status status = fs::status(path, none);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// A file that exists under a temporary name until Commit(); a device is written at once.
class PendingFile {
public:
    PendingFile(const std::string& path, std::string bytes)
        : m_path(path), m_bytes(std::move(bytes)), m_file(path, std::as_bytes(std::span(m_bytes))) {
        std::error_code none;
        if (const fs::path folder = fs::path(path).parent_path(); !folder.empty())
            fs::create_directories(folder, none);
        if (!m_file.Prepare()) Fail();
    }

    void Commit() {
        if (!m_file.Commit()) Fail();
    }

private:
    [[noreturn]] void Fail() { throw Error("cannot write '{}': {}", m_path, std::strerror(errno)); }

    std::string m_path, m_bytes;
    OutputFile m_file;
};

// What a file of an earlier run holds; "" if it cannot be read, which counts as out of date.
std::string OldText(const std::string& path) {
    try {
        const std::vector<uint8_t> bytes = ReadFile(path, {path});
        return {bytes.begin(), bytes.end()};
    } catch (const Error&) {
        return "";
    }
}

FileTime TimeOf(const struct stat& status) {
    return {status.st_mtim.tv_sec * 1'000'000'000LL + status.st_mtim.tv_nsec};
}

FileTime ModifiedAt(const std::string& path) {
    struct stat status;
    if (stat(path.c_str(), &status) != 0) return {-1};
    return TimeOf(status);
}

// Two outputs with the same record were made alike.
std::string RecordOf(const ShaderJob& job) {
    const std::string file = (fs::path(job.root) / job.options.file).lexically_normal().generic_string();
    return fmt::format("# bxc {}, {}: {} {}", Version(), CompilerVersion(), file, ToText(job.options));
}

}  // namespace

OutputFiles FilesOf(const ShaderJob& job) {
    OutputFiles files{job.output, job.options.header, "", ""};
    std::string base = files.spirv.empty() || IsDevice(files.spirv) ? files.header : files.spirv;
    for (const std::string_view ending : {".spv", ".h"})
        if (base.ends_with(ending)) base.resize(base.size() - ending.size());
    if (base.empty() || IsDevice(base)) return files;
    files.layout = base + ".layout.json";
    files.depfile = base + ".d";
    return files;
}

// What a new file is stamped with. Since Linux 6.13 files may be stamped ahead of CLOCK_REALTIME_COARSE.
FileTime Now() {
    const Descriptor file(memfd_create("now", MFD_CLOEXEC));
    struct stat status;
    if (fstat(file.Number(), &status) != 0) throw Error("cannot ask for the time: {}", std::strerror(errno));
    return TimeOf(status);
}

std::set<std::string> DependenciesOf(const ShaderJob& job) {
    const std::string text = OldText(FilesOf(job).depfile);
    std::set<std::string> names;
    // One name a line, after a line that names the target.
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("  ")) continue;
        if (line.ends_with(" \\")) line.resize(line.size() - 2);
        std::string name;
        for (size_t i = 2; i < line.size(); ++i) {
            if (line[i] == '\\' && i + 1 < line.size() && (line[i + 1] == ' ' || line[i + 1] == '#')) ++i;
            if (line[i] == '$' && i + 1 < line.size() && line[i + 1] == '$') ++i;
            name += line[i];
        }
        names.insert(name);
    }
    return names;
}

std::string DepfileText(const std::string& comment, const std::string& target,
                        const std::set<std::string>& dependencies) {
    const auto escaped = [](const std::string& name) {
        std::string text;
        for (const char c : name) {
            if (c == ' ' || c == '#') text += '\\';
            if (c == '$') text += '$';
            text += c;
        }
        return text;
    };
    std::string text = comment.empty() ? "" : comment + "\n";
    text += escaped(target) + ":";
    for (const std::string& dependency : dependencies)
        text += " \\\n  " + escaped(dependency);
    return text + "\n";
}

bool IsUpToDate(const ShaderJob& job) {
    const OutputFiles files = FilesOf(job);
    if (!fs::exists(files.spirv) || !fs::exists(files.layout) || !fs::exists(files.depfile)) return false;
    if (!OldText(files.depfile).starts_with(RecordOf(job) + "\n")) return false;

    std::set<std::string> dependencies = DependenciesOf(job);
    dependencies.insert("/proc/self/exe");
    const FileTime made = ModifiedAt(files.depfile);
    return std::ranges::all_of(dependencies, [&](const std::string& name) {
        const FileTime modified = ModifiedAt(name);
        return modified.nanoseconds >= 0 && modified.nanoseconds <= made.nanoseconds;
    });
}

void WriteOutputs(const ShaderJob& job, const CompileResult& result, FileTime started) {
    const OutputFiles files = FilesOf(job);
    const std::string_view spirvBytes(reinterpret_cast<const char*>(result.spirv.data()),
                                      result.spirv.size() * sizeof(uint32_t));
    std::deque<PendingFile> pending;
    if (!files.spirv.empty()) pending.emplace_back(files.spirv, std::string(spirvBytes));
    if (!files.header.empty()) pending.emplace_back(files.header, CHeader(result.spirv, job.options));
    if (!files.depfile.empty()) {
        std::set<std::string> dependencies;
        for (const std::string& name : result.dependencies)
            dependencies.insert((fs::path(job.root) / name).lexically_normal().generic_string());
        const bool hasSpirv = !files.spirv.empty() && !IsDevice(files.spirv);
        const std::string& target = hasSpirv ? files.spirv : files.header;
        pending.emplace_back(files.layout, ShaderLayoutToJson(result.layout));
        pending.emplace_back(files.depfile, DepfileText(RecordOf(job), target, dependencies));
    }
    for (PendingFile& file : pending)
        file.Commit();

    const timespec stamp = {started.nanoseconds / 1'000'000'000, started.nanoseconds % 1'000'000'000};
    const timespec times[2] = {stamp, stamp};
    utimensat(AT_FDCWD, files.depfile.c_str(), times, 0);
}

void RemoveOutputs(const ShaderJob& job) {
    const OutputFiles files = FilesOf(job);
    for (const std::string& file : {files.depfile, files.layout, files.header, files.spirv})
        if (!file.empty() && !IsDevice(file)) unlink(file.c_str());
}

void WriteFile(const std::string& path, std::string_view bytes) {
    PendingFile(path, std::string(bytes)).Commit();
}

void WriteFileIfChanged(const std::string& path, std::string_view bytes) {
    if (!fs::is_regular_file(path) || OldText(path) != bytes) WriteFile(path, bytes);
}

}  // namespace boxcar
