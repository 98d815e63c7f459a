namespace Nowpose.Headless.Tests.Shaders;

/// <summary>A shader as declared by its ShaderLab text.</summary>
/// <param name="Path">Path of the file that contains the text, relative to the repository.</param>
public sealed record ShaderSource(string Path, string Name, IReadOnlyList<ShaderProperty> Properties, IReadOnlyList<SubShader> SubShaders)
{
    public override string ToString() => System.IO.Path.GetFileName(Path);
}

/// <summary>A material property of the shader. The type is a type of ShaderLab, for example Color, Range or 2D.</summary>
public sealed record ShaderProperty(string Name, string Type, int Line);

/// <param name="Requirements">Packages without which Unity skips the SubShader; empty if there are none.</param>
public sealed record SubShader(
    IReadOnlyList<string> Requirements, IReadOnlyDictionary<string, string> Tags, IReadOnlyList<ShaderPass> Passes, int Line)
{
    /// <summary>Whether the SubShader is for URP. A SubShader for the built-in pipeline does not have this tag.</summary>
    public bool IsUniversal => Tags.GetValueOrDefault("RenderPipeline") == "UniversalPipeline";

    public string Pipeline => IsUniversal ? "URP" : "built-in";
}

/// <param name="States">Render states by their keywords, for example ZWrite and Blend.</param>
public sealed record ShaderPass(
    string Name, IReadOnlyDictionary<string, string> Tags, IReadOnlyDictionary<string, string> States, ShaderProgram Program, int Line);

/// <summary>The text between CGPROGRAM and ENDCG, or between HLSLPROGRAM and ENDHLSL.</summary>
/// <param name="Line">Line number, within the file, of the first line of the text.</param>
public sealed record ShaderProgram(string Text, int Line, bool IsCg);
