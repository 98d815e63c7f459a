using System.Text.RegularExpressions;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>Reads the declarations in the source of a shader: its name, its tags, and the properties that a material can set.</summary>
/// <param name="Name">Name of the shader.</param>
/// <param name="Tags">Tags of the last SubShader, which is the SubShader for the built-in pipeline.</param>
/// <param name="Floats">Number properties with their default values.</param>
/// <param name="Colours">Colour and vector properties with their default values.</param>
sealed record ShaderDeclaration(
    string Name, IReadOnlyDictionary<string, string> Tags, IReadOnlyDictionary<string, float> Floats, IReadOnlyDictionary<string, Color> Colours)
{
    static readonly Regex Heads = new Regex("^\\s*Shader\\s+\"([^\"]+)\"", RegexOptions.Multiline | RegexOptions.CultureInvariant);
    static readonly Regex Blocks = new Regex("\\bProperties\\s*\\{(.*?)\\n\\s*\\}", RegexOptions.Singleline | RegexOptions.CultureInvariant);
    static readonly Regex Comments = new Regex("//[^\n]*|/\\*.*?\\*/", RegexOptions.Singleline | RegexOptions.CultureInvariant);

    static readonly Regex Declarations = new Regex(
        "(\\w+)\\s*\\(\\s*\"[^\"]*\"\\s*,\\s*(Color|Vector|Float|Range|Int|Integer|2D|3D|Cube)\\b[^=]*=\\s*([^\n]+)", RegexOptions.CultureInvariant);

    static readonly Regex TagBlocks = new Regex("\\bTags\\s*\\{([^}]*)\\}", RegexOptions.CultureInvariant);
    static readonly Regex Tag = new Regex("\"([^\"]+)\"\\s*=\\s*\"([^\"]+)\"", RegexOptions.CultureInvariant);

    /// <summary>Reads the source of a shader. Ignores texture properties, because no material of the package has a texture.</summary>
    /// <exception cref="AssetException">The text is not a shader.</exception>
    public static ShaderDeclaration Read(string text, string file)
    {
        text = Comments.Replace(text, "");
        var head = Heads.Match(text);
        if (!head.Success) throw new AssetException(AssetFault.Document, file + ": declares no shader");

        var floats = new Dictionary<string, float>();
        var colours = new Dictionary<string, Color>();
        foreach (Match match in Declarations.Matches(Blocks.Match(text).Groups[1].Value))
        {
            var (name, type, value) = (match.Groups[1].Value, match.Groups[2].Value, match.Groups[3].Value.Trim());
            if (type is "2D" or "3D" or "Cube") continue;
            if (type is "Color" or "Vector") colours.Add(name, Colour(value, name, file));
            else floats.Add(name, Number(value, name, file));
        }
        var last = text.Substring(Math.Max(0, text.LastIndexOf("SubShader", StringComparison.Ordinal)));
        var tags = Tag.Matches(TagBlocks.Match(last).Groups[1].Value).ToDictionary(t => t.Groups[1].Value, t => t.Groups[2].Value);
        return new ShaderDeclaration(head.Groups[1].Value, tags, floats, colours);
    }

    static Color Colour(string value, string name, string file)
    {
        var parts = value.Trim('(', ')').Split(',').Select(p => Number(p.Trim(), name, file)).ToArray();
        return parts.Length == 4
            ? new Color(parts[0], parts[1], parts[2], parts[3])
            : throw new AssetException(AssetFault.Value, file + ": property " + name + ": its default needs four numbers");
    }

    static float Number(string text, string name, string file) =>
        Numbers.TryRead(text, out float value)
            ? value
            : throw new AssetException(AssetFault.Value, file + ": property " + name + ": \"" + text + "\" is not a number");
}
