using System.Text.RegularExpressions;

namespace Nowpose.Headless.Tests.Shaders;

/// <summary>The program of a pass with its includes, and the variants that Unity compiles from it.</summary>
public sealed class PassProgram
{
    /// <summary>Folder of the substitutes for Unity's includes.</summary>
    public const string StandIns = "Tests/Shaders/StandIns";

    static readonly Regex Includes = new("(?m)^\\s*#include\\s+\"([^\"]+)\"", RegexOptions.CultureInvariant);
    static readonly Regex Pragmas = new("(?m)^\\s*#pragma\\s+(\\S+)[ \t]*(.*)$", RegexOptions.CultureInvariant);

    public PassProgram(ShaderSource shader, SubShader subShader, ShaderPass pass)
    {
        (Shader, SubShader, Pass) = (shader, subShader, pass);
    }

    public ShaderSource Shader { get; }

    public SubShader SubShader { get; }

    public ShaderPass Pass { get; }

    /// <summary>Folders that are searched for includes, in this order.</summary>
    public IEnumerable<string> Folders =>
        new[] { Path.GetDirectoryName(Shader.Path), StandIns, "" }.Select(folder => Path.Combine(RepositoryFiles.Root, folder ?? ""));

    public string VertexFunction => Single("vertex");

    public string FragmentFunction => Single("fragment");

    /// <summary>Sets of keywords. Each set is a separate program on the device.</summary>
    public IReadOnlyList<string[]> Variants
    {
        get
        {
            // Unity adds the stereo keywords to every program. Only the built-in pipeline has double-wide stereo.
            string[] stereo = ["", "STEREO_INSTANCING_ON", "STEREO_MULTIVIEW_ON"];
            List<string[]> axes = [SubShader.IsUniversal ? stereo : [.. stereo, "UNITY_SINGLE_PASS_STEREO"]];
            foreach (Match pragma in Pragmas.Matches(Pass.Program.Text))
                if (KeywordsOf(pragma.Groups[1].Value, pragma.Groups[2].Value) is { } keywords) axes.Add(keywords);
            List<string[]> sets = [[]];
            foreach (var axis in axes) sets = sets.SelectMany(set => axis.Select(keyword => Union(set, keyword))).ToList();
            return sets;
        }
    }

    /// <summary>The program with the package's own includes inserted, but without Unity's includes.</summary>
    public string OwnText => Inlined(Pass.Program.Text, new HashSet<string>());

    /// <summary>Unity's includes that the program uses.</summary>
    public IReadOnlyList<string> UnityIncludes =>
        Includes.Matches(Pass.Program.Text).Select(m => m.Groups[1].Value).Where(IsStandIn).Select(Path.GetFileName).ToList();

    public override string ToString() => $"{Shader}, {SubShader.Pipeline}, pass {Pass.Name}";

    static string[] Union(string[] set, string keyword) => keyword == "" ? set : [.. set, keyword];

    string[] KeywordsOf(string pragma, string words)
    {
        var keywords = words.Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(k => k.Trim('_') == "" ? "" : k).ToArray();
        switch (pragma)
        {
            case "vertex" or "fragment" or "target":
                return null;
            case "multi_compile_instancing":
                return ["", "INSTANCING_ON"];
            case "multi_compile" or "multi_compile_local":
                return keywords;
            case "shader_feature" or "shader_feature_local":
                return keywords.Length == 1 ? ["", keywords[0]] : keywords;
            default:
                throw new ShaderLabException(Shader.Path, Pass.Line, $"#pragma {pragma} is not understood");
        }
    }

    string Single(string pragma)
    {
        var names = Pragmas.Matches(Pass.Program.Text).Where(m => m.Groups[1].Value == pragma).Select(m => m.Groups[2].Value.Trim()).ToList();
        return names.Count == 1
            ? names[0]
            : throw new ShaderLabException(Shader.Path, Pass.Line, $"the pass has {names.Count} lines #pragma {pragma}");
    }

    string Inlined(string text, HashSet<string> done) => Includes.Replace(text, match =>
    {
        var name = match.Groups[1].Value;
        if (IsStandIn(name)) return "";
        var file = Folders.Select(folder => Path.Combine(folder, name)).FirstOrDefault(File.Exists)
            ?? throw new ShaderLabException(Shader.Path, Pass.Program.Line, $"include {name} is missing");
        return done.Add(file) ? Inlined(File.ReadAllText(file), done) : "";
    });

    static bool IsStandIn(string include) => RepositoryFiles.Exists(StandIns + "/" + include);
}
