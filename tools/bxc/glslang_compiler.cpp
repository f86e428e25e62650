// The only file that knows glslang.
#include "tools/bxc/compiler.h"
#include "tools/bxc/glslang_text.h"

#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <glslang/build_info.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <map>

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

SourcePlace PlaceOf(const Source& source, const glslang::TSourceLoc& loc, std::string_view word) {
    return source.PlaceOf(loc.getFilenameStr(), loc.line, word);
}

std::string TypeName(const glslang::TType& type) {
    std::string name = type.getBasicTypeString().c_str();
    if (type.isMatrix()) return fmt::format("{}{}x{}", name, type.getMatrixCols(), type.getMatrixRows());
    return type.getVectorSize() > 1 ? fmt::format("{}{}", name, type.getVectorSize()) : name;
}

// Walks the functions that the entry point reaches (glslang has dropped the others).
class FunctionWalker : public glslang::TIntermTraverser {
public:
    FunctionWalker(const Source& source, const std::string& entry) : m_source(source), m_entry(entry) {}

    SourcePlace entryPlace;
    std::map<long long, SourcePlace> firstUse;       // of a symbol, by its id
    std::map<std::string, SourcePlace> fieldPlaces;  // of the entry point's inputs and outputs: "i.uv"

    bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
        if (node->getOp() == glslang::EOpLinkerObjects) return false;
        // glslang calls the entry point as it is written @name, and wraps it in a function without parameters.
        if (node->getOp() == glslang::EOpFunction && node->getName().starts_with(("@" + m_entry + "(").c_str()))
            AddEntry(*node);
        return true;
    }

    void visitSymbol(glslang::TIntermSymbol* symbol) override {
        firstUse.try_emplace(symbol->getId(), PlaceOf(m_source, symbol->getLoc(), symbol->getName().c_str()));
    }

private:
    void AddEntry(const glslang::TIntermAggregate& function) {
        entryPlace = PlaceOf(m_source, function.getLoc(), m_entry);
        AddFields("@entryPointOutput", function.getType(), entryPlace);
        const auto& sequence = function.getSequence();
        const glslang::TIntermAggregate* parameters = sequence.empty() ? nullptr : sequence[0]->getAsAggregate();
        if (!parameters) return;
        for (const TIntermNode* node : parameters->getSequence())
            if (const glslang::TIntermSymbol* parameter = node->getAsSymbolNode())
                AddFields(parameter->getName().c_str(), parameter->getType(),
                          PlaceOf(m_source, function.getLoc(), parameter->getName().c_str()));
    }

    void AddFields(const std::string& prefix, const glslang::TType& type, const SourcePlace& place) {
        fieldPlaces[prefix] = place;
        if (!type.isStruct()) return;
        for (const glslang::TTypeLoc& field : *type.getStruct()) {
            const std::string name = field.type->getFieldName().c_str();
            AddFields(prefix + "." + name, *field.type, PlaceOf(m_source, field.loc, name));
        }
    }

    const Source& m_source;
    const std::string m_entry;
};

// "TEXCOORD1" and element 2 -> "TEXCOORD3"; "NORMAL" -> "NORMAL0".
std::string SemanticOf(const char* name, uint32_t element) {
    std::string semantic = name ? name : "";
    const size_t digits = semantic.find_last_not_of("0123456789") + 1;
    if (digits == 0) return "";
    const std::string index = semantic.substr(digits);
    semantic.resize(digits);
    return semantic + std::to_string((index.empty() ? 0 : std::stoul(index)) + element);
}

DeclaredVariable MakeVariable(const glslang::TIntermSymbol& symbol, const FunctionWalker& walker) {
    const glslang::TQualifier& qualifier = symbol.getQualifier();
    const std::string path = symbol.getName().c_str();
    // Arrays are taken apart: "i.uv[2]".
    const size_t bracket = path.find_last_of('[');
    const uint32_t element =
        bracket == std::string::npos ? 0 : static_cast<uint32_t>(std::strtoul(&path[bracket + 1], nullptr, 10));
    const size_t dot = path.find_last_of('.');

    DeclaredVariable variable;
    variable.name = dot != std::string::npos ? path.substr(dot + 1) : path.starts_with('@') ? "" : path;
    variable.semantic = SemanticOf(qualifier.semanticName, element);
    variable.type = TypeName(symbol.getType());
    variable.builtIn = !qualifier.hasLocation();
    variable.location = variable.builtIn ? 0 : qualifier.layoutLocation;
    if (const auto place = walker.fieldPlaces.find(path.substr(0, bracket)); place != walker.fieldPlaces.end())
        variable.place = place->second;
    return variable;
}

void AddGlobals(const glslang::TIntermediate& tree, const FunctionWalker& walker,
                const std::map<std::string, SourcePlace>& globals, const Source& source, CompiledShader& shader) {
    for (const TIntermNode* node : tree.findLinkerObjects()->getSequence()) {
        const glslang::TIntermSymbol* symbol = node->getAsSymbolNode();
        if (!symbol) continue;
        const glslang::TType& type = symbol->getType();
        const glslang::TQualifier& qualifier = symbol->getQualifier();
        if (qualifier.isPipeInput()) shader.inputs.push_back(MakeVariable(*symbol, walker));
        if (qualifier.isPipeOutput()) shader.outputs.push_back(MakeVariable(*symbol, walker));
        if (!qualifier.isUniformOrBuffer()) continue;

        const bool isConstants = type.getBasicType() == glslang::EbtBlock && symbol->getName().starts_with("anon@");
        const std::string name = isConstants ? type.getTypeName().c_str() : symbol->getName().c_str();
        if (name == "$Global")
            for (const glslang::TTypeLoc& member : *type.getStruct()) {
                const std::string constant = member.type->getFieldName().c_str();
                shader.looseGlobals.push_back({constant, PlaceOf(source, member.loc, constant)});
            }
        if (!qualifier.hasBinding()) continue;
        DeclaredResource resource;
        resource.name = name;
        resource.set = qualifier.hasSet() ? qualifier.layoutSet : 0;
        resource.binding = qualifier.layoutBinding;
        if (type.isArray()) resource.count = type.isUnsizedArray() ? 0 : type.getCumulativeArraySize();
        const auto use = walker.firstUse.find(symbol->getId());
        resource.used = use != walker.firstUse.end();
        if (const auto place = globals.find(name); place != globals.end())
            resource.place = place->second;
        else if (resource.used)
            resource.place = use->second;
        shader.resources.push_back(std::move(resource));
    }
}

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
    }

    EShLanguage Stage() const {
        constexpr EShLanguage kStages[] = {EShLangVertex, EShLangFragment, EShLangCompute};
        return kStages[static_cast<int>(m_options.stage)];
    }

    EShMessages Messages() const {
        unsigned messages = EShMsgSpvRules | EShMsgVulkanRules | EShMsgReadHlsl | EShMsgHlslOffsets;
        if (m_options.dx9Compatible) messages |= EShMsgHlslDX9Compatible;
        if (m_options.debugInfo) messages |= EShMsgDebugInfo;
        return static_cast<EShMessages>(messages);
    }

    void Prepare(glslang::TShader& shader) const {
        shader.setStringsWithLengthsAndNames(&m_text, &m_length, &m_name, 1);
        shader.setPreamble(m_preamble.c_str());
        shader.setEntryPoint(m_options.entry.c_str());
        shader.setSourceEntryPoint(m_options.entry.c_str());
        shader.setEnvInput(glslang::EShSourceHlsl, Stage(), glslang::EShClientVulkan, 100);
        shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
        shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
        shader.setHlslIoMapping(true);  // without it the shift of u registers does nothing
        shader.setAutoMapBindings(true);
        shader.setAutoMapLocations(true);
        shader.setShiftBinding(glslang::EResSampler, 16);
        shader.setShiftBinding(glslang::EResUav, 32);
        shader.setShiftBinding(glslang::EResTexture, 96);
    }

    std::string Preprocess(Includer& includer) const {
        glslang::TShader shader(Stage());
        Prepare(shader);
        std::string text;
        shader.preprocess(GetDefaultResources(), 100, ENoProfile, false, false, Messages(), &text, includer);
        return text;
    }

private:
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
        CompiledShader result{.file = options.file, .entry = options.entry, .stage = options.stage};
        result.entryPlace = {options.file, 1, 0};
        std::string error;
        const Source::File* file = source.Open(options.file, error);
        if (!file) {
            diagnostics.push_back({{options.file, 0, 0}, Severity::Error, error});
            return result;
        }
        const Request request(options, *file);
        Includer includer(source);
        const std::string preprocessed = request.Preprocess(includer);

        glslang::TShader shader(request.Stage());
        request.Prepare(shader);
        const bool parsed = shader.parse(GetDefaultResources(), 100, false, request.Messages(), includer);
        AppendGlslangLog(shader.getInfoLog(), options.file, source, diagnostics);
        if (!parsed) return Refuse(result, diagnostics);

        glslang::TProgram program;
        program.addShader(&shader);
        const bool linked = program.link(request.Messages());
        const glslang::TIntermediate* tree = program.getIntermediate(request.Stage());
        result.hasEntry = linked && tree->getNumEntryPoints() > 0;
        if (linked && !result.hasEntry) return result;  // glslang warns; the rule missing_entry refuses it
        const bool mapped = linked && program.mapIO();
        AppendGlslangLog(program.getInfoLog(), options.file, source, diagnostics);
        if (!mapped) return Refuse(result, diagnostics);

        FunctionWalker walker(source, options.entry);
        tree->getTreeRoot()->traverse(&walker);
        result.entryPlace = walker.entryPlace;
        AddGlobals(*tree, walker, PlacesOfGlobals(preprocessed, file->name, source), source, result);

        glslang::SpvOptions spirvOptions;
        spirvOptions.generateDebugInfo = options.debugInfo;
        spirvOptions.disableOptimizer = true;  // that is a stage of its own
        spv::SpvBuildLogger logger;
        glslang::GlslangToSpv(*tree, result.spirv, &logger, &spirvOptions);
        AppendGlslangLog(logger.getAllMessages(), options.file, source, diagnostics);
        return result;
    }

private:
    static CompiledShader Refuse(CompiledShader& result, Diagnostics& diagnostics) {
        if (!HasErrors(diagnostics))
            diagnostics.push_back({{result.file, 0, 0}, Severity::Error, "the compiler refuses it without a reason"});
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
