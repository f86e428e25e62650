#include "tools/bxc/workers.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <thread>

#include "tools/base/descriptor.h"
#include "tools/base/error.h"

namespace boxcar {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Define, name, value)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RegisterShift, registerClass, shift, set)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CompileOptions, file, stage, entry, defines, includeDirs, optimization, debugInfo,
                                   warningsAreErrors, dx9Compatible, hlslVersion, rowMajor, strictMath, native16Bit,
                                   invertY, dxPositionW, shifts, after, afterStage, afterEntry, output, binary,
                                   outputSuffix, header, variable)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ShaderJob, root, options, output)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SourcePlace, file, line, column)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Diagnostic, place, severity, text)

static void to_json(nlohmann::json& json, const ShaderLayout& layout) {
    json = ShaderLayoutToJson(layout);
}
static void from_json(const nlohmann::json& json, ShaderLayout& layout) {
    layout = ShaderLayoutFromJson(json.get<std::string>());
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CompileResult, diagnostics, dependencies, spirv, layout)

namespace {

using Clock = std::chrono::steady_clock;

// CBOR, since strings in JSON are UTF-8 and the name of a file is any bytes.
std::string ToCbor(const nlohmann::json& json) {
    std::string bytes;
    nlohmann::json::to_cbor(json, bytes);
    return bytes;
}

using AnswerSize = uint64_t;  // of the CBOR in bytes, which is sent before it

// One process. It ends with this object.
class Worker {
public:
    Worker() {
        int input[2], output[2];
        if (pipe2(input, O_CLOEXEC) != 0) throw Error("cannot make a pipe: {}", std::strerror(errno));
        Descriptor childInput(input[0]);
        m_input = Descriptor(input[1]);
        if (pipe2(output, O_CLOEXEC) != 0) throw Error("cannot make a pipe: {}", std::strerror(errno));
        Descriptor childOutput(output[1]);
        m_output = Descriptor(output[0]);

        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, input[0], STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
        char name[] = "bxc", command[] = "worker";
        char* const arguments[] = {name, command, nullptr};
        const int error = posix_spawn(&m_process, "/proc/self/exe", &actions, nullptr, arguments, environ);
        posix_spawn_file_actions_destroy(&actions);
        if (error != 0) throw Error("cannot start /proc/self/exe as a worker process: {}", std::strerror(error));
    }

    ~Worker() {
        if (!m_process) return;
        kill(m_process, SIGKILL);
        waitpid(m_process, nullptr, 0);
    }

    void Start(size_t jobIndex, const ShaderJob& job) {
        m_jobIndex = jobIndex;
        m_started = Clock::now();
        const std::string bytes = ToCbor(job);
        WriteAll(m_input.Number(), std::as_bytes(std::span(bytes)));  // fails if the worker is dead; Read() sees it
    }

    std::optional<size_t> JobIndex() const { return m_jobIndex; }  // nothing while the worker is idle
    int Output() const { return m_output.Number(); }

    // Reads what has arrived. Returns false once the worker has ended.
    bool Read() {
        char bytes[65536];
        const ssize_t count = read(m_output.Number(), bytes, sizeof bytes);
        if (count < 0 && errno == EINTR) return true;
        if (count <= 0) return false;
        m_text.append(bytes, static_cast<size_t>(count));
        return true;
    }

    // The answer to the job, once it is complete.
    std::optional<CompileResult> TakeAnswer() {
        if (m_text.size() < sizeof(AnswerSize)) return std::nullopt;
        AnswerSize size;
        std::memcpy(&size, m_text.data(), sizeof size);
        if (m_text.size() - sizeof size < size) return std::nullopt;
        m_jobIndex.reset();
        const std::string answer = std::exchange(m_text, {}).substr(sizeof size);
        return nlohmann::json::from_cbor(answer).get<CompileResult>();
    }

    // Why a worker ended that Read() found dead.
    std::string CauseOfDeath() {
        int status = 0;
        waitpid(m_process, &status, 0);
        m_process = 0;
        return WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : fmt::format("exit code {}", WEXITSTATUS(status));
    }

    // What to say of the limit that the worker is over, or "".
    std::string BrokenLimit(const WorkerLimits& limits) const {
        if (Clock::now() - m_started > std::chrono::seconds(limits.timeoutSeconds))
            return fmt::format("it took more than {} s", limits.timeoutSeconds);
        std::ifstream statm(fmt::format("/proc/{}/statm", m_process));
        uint64_t totalPages = 0, residentPages = 0;
        statm >> totalPages >> residentPages;
        if (residentPages * static_cast<uint64_t>(sysconf(_SC_PAGESIZE)) >> 20 >
            static_cast<uint64_t>(limits.maxMemoryMib))
            return fmt::format("it took more than {} MiB of memory", limits.maxMemoryMib);
        return "";
    }

private:
    pid_t m_process = 0;
    Descriptor m_input, m_output;
    std::optional<size_t> m_jobIndex;
    Clock::time_point m_started;
    std::string m_text;
};

CompileResult Failure(const ShaderJob& job, const std::string& text) {
    CompileResult result;
    result.diagnostics = {{{job.options.file, 0, 0}, Severity::Error, text}};
    result.dependencies = {job.options.file};
    return result;
}

}  // namespace

void CompileAll(const std::vector<ShaderJob>& jobs, const WorkerLimits& limits,
                const std::function<void(const ShaderJob&, CompileResult)>& done) {
    signal(SIGPIPE, SIG_IGN);  // a dead worker is found by reading from it
    const size_t cores = std::max(std::thread::hardware_concurrency(), 1u);
    const size_t count = std::min(limits.workers > 0 ? static_cast<size_t>(limits.workers) : cores, jobs.size());
    std::vector<std::unique_ptr<Worker>> workers(count);
    std::vector<std::optional<CompileResult>> results(jobs.size());
    size_t next = 0, delivered = 0;

    while (delivered < jobs.size()) {
        for (std::unique_ptr<Worker>& worker : workers) {
            if (next == jobs.size() || (worker && worker->JobIndex())) continue;
            if (!worker) worker = std::make_unique<Worker>();
            worker->Start(next, jobs[next]);
            ++next;
        }

        std::vector<pollfd> waits;
        for (const std::unique_ptr<Worker>& worker : workers)
            waits.push_back({worker && worker->JobIndex() ? worker->Output() : -1, POLLIN, 0});
        constexpr int kMillisecondsBetweenLooksAtTheLimits = 10;
        poll(waits.data(), waits.size(), kMillisecondsBetweenLooksAtTheLimits);

        for (size_t i = 0; i < workers.size(); ++i) {
            if (waits[i].fd < 0) continue;
            const size_t job = *workers[i]->JobIndex();
            if (waits[i].revents != 0 && !workers[i]->Read()) {
                results[job] = Failure(jobs[job], "the compiler crashed: " + workers[i]->CauseOfDeath());
                workers[i].reset();
            } else if (auto answer = workers[i]->TakeAnswer()) {
                results[job] = std::move(*answer);
            } else if (const std::string limit = workers[i]->BrokenLimit(limits); !limit.empty()) {
                results[job] = Failure(jobs[job], "the compiler was stopped: " + limit);
                workers[i].reset();
            }
        }

        for (; delivered < jobs.size() && results[delivered]; ++delivered)
            done(jobs[delivered], std::move(*results[delivered]));
    }
}

void RunWorker(const std::function<CompileResult(const ShaderJob&)>& compile) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // no worker outlives its parent, not even one that hangs
    const rlimit noCoreFile = {0, 0};
    setrlimit(RLIMIT_CORE, &noCoreFile);
    // What a library prints must not mix with the answers.
    const int answers = dup(STDOUT_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO);

    constexpr bool kToTheEndOfTheStream = false;  // only to the end of one job
    while (std::cin.peek() != std::istream::traits_type::eof()) {
        const auto job = nlohmann::json::from_cbor(std::cin, kToTheEndOfTheStream).get<ShaderJob>();
        const std::string answer = ToCbor(compile(job));
        const AnswerSize size = answer.size();
        WriteAll(answers, std::as_bytes(std::span(&size, 1)));
        WriteAll(answers, std::as_bytes(std::span(answer)));
    }
}

}  // namespace boxcar
