// The only file that knows glslang.
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <glslang/build_info.h>

#include <deque>
#include <map>
#include <utility>

#include "tools/bxc/compiler.h"
#include "tools/bxc/glslang_log.h"
#include "tools/bxc/prelude.h"
#include "tools/layout/registers.h"

namespace boxcar {
namespace {

// Hands glslang what Source finds.
class Includer : public glslang::TShader::Includer {
public:
    explicit Includer(Source& source) : m_source(source) {}

    IncludeResult* includeLocal(const char* header, const char* includer, size_t depth) override {
        const Source::File* file = m_source.Include(header, includer, depth, m_error);
        return file ? Keep(file->name, file->text) : nullptr;
    }

    // glslang asks here last, and shows the text of a result without a name as the error.
    IncludeResult* includeSystem(const char* header, const char* includer, size_t depth) override {
        const Source::File* file = m_source.Include(header, includer, depth, m_error);
        return file ? Keep(file->name, file->text) : Keep("", m_error);
    }

    void releaseInclude(IncludeResult*) override {}

private:
    IncludeResult* Keep(const std::string& name, const std::string& text) {
        return &m_results.emplace_back(name, text.data(), text.size(), nullptr);
    }

    Source& m_source;
    std::string m_error;
    std::deque<IncludeResult> m_results;
};

// What glslang needs to know before it reads a shader. Holds the texts that glslang only points to.
class Request {
public:
    Request(const CompileOptions& options, const Source::File& file)
        : m_options(options),
          m_text(file.text.data()),
          m_length(static_cast<int>(file.text.size())),
          m_name(file.name.c_str()) {
        for (const Define& define : options.defines)
            m_preamble += fmt::format("#define {} {}\n", define.name, define.value);
        if (options.rowMajor) m_preamble += "#pragma pack_matrix(row_major)\n";
    }

    EShLanguage Stage() const {
        constexpr EShLanguage kStages[] = {EShLangVertex,   EShLangFragment,    EShLangCompute,
                                           EShLangGeometry, EShLangTessControl, EShLangTessEvaluation};
        return kStages[static_cast<int>(m_options.stage)];
    }

    EShMessages Messages() const {
        unsigned messages = EShMsgSpvRules | EShMsgVulkanRules | EShMsgReadHlsl | EShMsgHlslOffsets;
        if (m_options.dx9Compatible) messages |= EShMsgHlslDX9Compatible;
        if (m_options.debugInfo) messages |= EShMsgDebugInfo;
        if (m_options.native16Bit) messages |= EShMsgHlslEnable16BitTypes;
        return static_cast<EShMessages>(messages);
    }

    // Adds a text before the shader, which has no lines in its messages.
    void AddPrelude(const std::string& text) { m_preamble += text; }

    void Prepare(glslang::TShader& shader) const {
        shader.setStringsWithLengthsAndNames(&m_text, &m_length, &m_name, 1);
        shader.setPreamble(m_preamble.c_str());
        shader.setEntryPoint(m_options.entry.c_str());
        shader.setSourceEntryPoint(m_options.entry.c_str());
        shader.setEnvInput(glslang::EShSourceHlsl, Stage(), glslang::EShClientVulkan, 100);
        shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
        shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
        shader.setEnvTargetHlslFunctionality1();  // semantics as decorations
        shader.setHlslIoMapping(true);            // without it the shift of u registers does nothing
        shader.setAutoMapBindings(true);
        shader.setAutoMapLocations(true);
        shader.setInvertY(m_options.invertY);
        shader.setDxPositionW(m_options.dxPositionW);
        if (m_options.shifts.empty())
            for (const RegisterBase& base : kRegisterBases)
                shader.setShiftBinding(ResourceType(base.registerClass), base.binding);
        else
            ShiftRegisters(shader);
    }

    std::string Preprocess(Includer& includer) const {
        glslang::TShader shader(Stage());
        Prepare(shader);
        std::string text;
        shader.preprocess(GetDefaultResources(), 100, ENoProfile, false, false, Messages(), &text, includer);
        return text;
    }

private:
    static glslang::TResourceType ResourceType(char registerClass) {
        switch (registerClass) {
            case 's': return glslang::EResSampler;
            case 't': return glslang::EResTexture;
            case 'u': return glslang::EResUav;
            default: return glslang::EResUbo;
        }
    }

    // A set's own shift goes before that of all. glslang takes a set's shift of 0 for none, so that "all" has to
    // stand for the other sets one by one.
    void ShiftRegisters(glslang::TShader& shader) const {
        constexpr int kMaxSets = 32;  // that "all" stands for beside sets of their own; drivers have no more
        for (const char registerClass : {'b', 's', 't', 'u'}) {
            const glslang::TResourceType type = ResourceType(registerClass);
            std::map<int, unsigned> shifts;  // by set
            for (const RegisterShift& each : m_options.shifts)
                if (each.registerClass == registerClass) shifts[each.set] = static_cast<unsigned>(each.shift);
            const auto all = shifts.find(RegisterShift::kAllSets);
            if (all != shifts.end() && shifts.size() == 1) shader.setShiftBinding(type, all->second);
            for (int set = 0; all != shifts.end() && shifts.size() > 1 && set < kMaxSets; ++set)
                shifts.emplace(set, all->second);
            for (const auto& [set, shift] : shifts)
                if (set != RegisterShift::kAllSets)
                    shader.setShiftBindingForSet(type, shift, static_cast<unsigned>(set));
        }
    }

    const CompileOptions& m_options;
    const char* m_text;
    int m_length;
    const char* m_name;
    std::string m_preamble;
};

class GlslangCompiler : public Compiler {
public:
    GlslangCompiler() { glslang::InitializeProcess(); }
    ~GlslangCompiler() override { glslang::FinalizeProcess(); }

    CompiledShader Compile(const CompileOptions& options, Source& source, Diagnostics& diagnostics) override {
        CompiledShader result;
        std::string error;
        const Source::File* file = source.Open(options.file, error);
        if (!file) {
            diagnostics.push_back({{options.file, 0, 0}, Severity::Error, error});
            return result;
        }
        Request request(options, *file);
        Includer includer(source);
        result.preprocessed = request.Preprocess(includer);
        request.AddPrelude(MakePrelude(options, Outline(result.preprocessed, options.file, source), source));

        glslang::TShader shader(request.Stage());
        request.Prepare(shader);
        const bool parsed = shader.parse(GetDefaultResources(), 100, false, request.Messages(), includer);
        AppendGlslangLog(shader.getInfoLog(), options.file, source, diagnostics);
        if (!parsed) return Refuse(result, options, diagnostics);

        glslang::TProgram program;
        program.addShader(&shader);
        const bool linked = program.link(request.Messages());
        const std::string linkLog = program.getInfoLog();
        // glslang only warns; the rule missing_entry refuses it.
        if (linkLog.find("Entry point not found") != std::string::npos) return result;
        const bool mapped = linked && program.mapIO();
        AppendGlslangLog(program.getInfoLog(), options.file, source, diagnostics);
        if (!mapped) return Refuse(result, options, diagnostics);

        result.hasEntry = true;
        glslang::SpvOptions spirvOptions;
        spirvOptions.generateDebugInfo = options.debugInfo;
        spirvOptions.disableOptimizer = true;  // that is a stage of its own
        spv::SpvBuildLogger logger;
        glslang::GlslangToSpv(*program.getIntermediate(request.Stage()), result.spirv, &logger, &spirvOptions);
        AppendGlslangLog(logger.getAllMessages(), options.file, source, diagnostics);
        return result;
    }

private:
    static CompiledShader Refuse(CompiledShader& result, const CompileOptions& options, Diagnostics& diagnostics) {
        if (!HasErrors(diagnostics))
            diagnostics.push_back(
                {{options.file, 0, 0}, Severity::Error, "the compiler refuses this shader without giving a reason"});
        return std::move(result);
    }
};

}  // namespace

std::string CompilerVersion() {
    return fmt::format("glslang {}.{}.{}", GLSLANG_VERSION_MAJOR, GLSLANG_VERSION_MINOR, GLSLANG_VERSION_PATCH);
}

std::unique_ptr<Compiler> MakeCompiler() {
    return std::make_unique<GlslangCompiler>();
}

}  // namespace boxcar
