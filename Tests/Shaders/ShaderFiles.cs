
namespace Nowpose.Headless.Tests.Shaders;

/// <summary>Finds the shaders of the package, and the example shaders of its manual.</summary>
static class ShaderFiles
{
    const string Fence = "```shaderlab\n";

    /// <summary>The shaders of the package.</summary>
    public static IEnumerable<ShaderSource> Shipped =>
        RepositoryFiles.Under(RepositoryFiles.Package, ".shader").Select(path => ShaderLabReader.Read(RepositoryFiles.Read(path), path));

    /// <summary>Code blocks of the manual that are marked as ShaderLab.</summary>
    public static IEnumerable<ShaderSource> Examples => RepositoryFiles.Under(RepositoryFiles.Package, ".md").SelectMany(ExamplesIn);

    public static IEnumerable<PassProgram> Programs => Shipped.Concat(Examples).SelectMany(Of);

    public static IEnumerable<PassProgram> Of(ShaderSource shader) =>
        shader.SubShaders.SelectMany(s => s.Passes.Select(p => new PassProgram(shader, s, p)));

    static IEnumerable<ShaderSource> ExamplesIn(string path)
    {
        var text = RepositoryFiles.Read(path);
        for (var at = text.IndexOf(Fence, StringComparison.Ordinal); at >= 0; at = text.IndexOf(Fence, at, StringComparison.Ordinal))
        {
            at += Fence.Length;
            var end = text.IndexOf("\n```", at, StringComparison.Ordinal);
            yield return ShaderLabReader.Read(text[at..end], path, 1 + text.AsSpan(0, at).Count('\n'));
        }
    }
}
