namespace Nowpose.Headless.Tests.Shaders;

/// <summary>A shader as its ShaderLab text declares it.</summary>
/// <param name="Path">Path of the file that contains the text, relative to the repository.</param>
public sealed record ShaderSource(string Path, string Name, IReadOnlyList<ShaderProperty> Properties, IReadOnlyList<SubShader> SubShaders)
{
    public override string ToString() => System.IO.Path.GetFileName(Path);
}

/// <summary>A material property of the shader, with ShaderLab's type: Color, Range, 2D and so on.</summary>
public sealed record ShaderProperty(string Name, string Type, int Line);

/// <param name="Requirements">Packages without which Unity skips it; empty for none.</param>
public sealed record SubShader(
    IReadOnlyList<string> Requirements, IReadOnlyDictionary<string, string> Tags, IReadOnlyList<ShaderPass> Passes, int Line)
{
    /// <summary>Whether it is for URP; the built-in pipeline has no tag.</summary>
    public bool IsUniversal => Tags.GetValueOrDefault("RenderPipeline") == "UniversalPipeline";

    public string Pipeline => IsUniversal ? "URP" : "built-in";
}

/// <param name="States">Render states by their keyword: ZWrite, Blend and so on.</param>
public sealed record ShaderPass(
    string Name, IReadOnlyDictionary<string, string> Tags, IReadOnlyDictionary<string, string> States, ShaderProgram Program, int Line);

/// <summary>The text between CGPROGRAM and ENDCG, or HLSLPROGRAM and ENDHLSL.</summary>
/// <param name="Line">Line number in the file of the first line of the text.</param>
public sealed record ShaderProgram(string Text, int Line, bool IsCg);
