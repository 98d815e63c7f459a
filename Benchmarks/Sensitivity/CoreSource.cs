using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Nowpose.Kinematics;

namespace Nowpose.Benchmarks.Sensitivity;

/// <summary>The source code of the package's Core, which can be compiled with another value of one constant.</summary>
sealed class CoreSource
{
    static readonly CSharpParseOptions Language = new(LanguageVersion.CSharp9);

    readonly Dictionary<string, string> _texts;
    readonly CSharpCompilation _compilation;

    /// <param name="folder">Folder of the assembly's source code.</param>
    public CoreSource(string folder)
    {
        _texts = Directory.EnumerateFiles(folder, "*.cs", SearchOption.AllDirectories).ToDictionary(path => path, File.ReadAllText);
        // The runtime's own assemblies and the libraries beside this program, but not the assemblies of Nowpose.
        var references = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES"))!.Split(Path.PathSeparator)
            .Where(path => !Path.GetFileName(path).StartsWith("Nowpose", StringComparison.Ordinal))
            .Select(path => MetadataReference.CreateFromFile(path));
        _compilation = CSharpCompilation.Create(
            typeof(RigidTransform).Assembly.GetName().Name, _texts.Select(file => Tree(file.Key, file.Value)), references,
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, optimizationLevel: OptimizationLevel.Release));
    }

    /// <summary>Gets the numeric constants of a folder in the order of the files, without those of local scope.</summary>
    public IReadOnlyList<SourceConstant> ConstantsOf(string folder) =>
    [
        .. from tree in _compilation.SyntaxTrees
           where tree.FilePath.StartsWith(folder + Path.DirectorySeparatorChar, StringComparison.Ordinal)
           orderby tree.FilePath
           let model = _compilation.GetSemanticModel(tree)
           from field in tree.GetRoot().DescendantNodes().OfType<FieldDeclarationSyntax>()
           where field.Modifiers.Any(SyntaxKind.ConstKeyword) && field.Declaration.Type is PredefinedTypeSyntax
           from variable in field.Declaration.Variables
           let symbol = (IFieldSymbol)model.GetDeclaredSymbol(variable)
           where symbol.ConstantValue is double or float or int
           select new SourceConstant($"{symbol.ContainingType.Name}.{symbol.Name}", tree.FilePath, variable.Initializer!.Value.Span,
               field.Declaration.Type.ToString(), Convert.ToDouble(symbol.ConstantValue, null)),
    ];

    /// <summary>Compiles the assembly with a constant multiplied by a factor.</summary>
    /// <returns>The assembly.</returns>
    /// <exception cref="InvalidOperationException">The source code cannot be compiled with this value.</exception>
    public byte[] Compile(SourceConstant constant, double factor)
    {
        var text = _texts[constant.Path];
        var (before, after) = (text[..constant.Place.Start], text[constant.Place.End..]);
        var changed = before + constant.Scaled(text.Substring(constant.Place.Start, constant.Place.Length), factor) + after;
        var tree = _compilation.SyntaxTrees.Single(one => one.FilePath == constant.Path);
        using var assembly = new MemoryStream();
        var result = _compilation.ReplaceSyntaxTree(tree, Tree(constant.Path, changed)).Emit(assembly);
        if (!result.Success) throw new InvalidOperationException(result.Diagnostics.First(one => one.Severity == DiagnosticSeverity.Error).ToString());
        return assembly.ToArray();
    }

    static SyntaxTree Tree(string path, string text) => CSharpSyntaxTree.ParseText(text, Language, path);
}
