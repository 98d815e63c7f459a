using System.Globalization;
using System.Text.RegularExpressions;

namespace Nowpose.Headless.Tests.Shaders;

/// <summary>Reads ShaderLab, the part of a .shader file that Unity interprets before it compiles the programs in the file.</summary>
/// <remarks>Supports only the commands that the package uses. For any other command, the error names the line.</remarks>
public sealed class ShaderLabReader
{
    static readonly Regex Tokens = new(
        """(?<space>\s+|//[^\n]*|/\*.*?\*/)|(?<program>(CG|HLSL)PROGRAM\b(?<text>.*?)\bEND(CG|HLSL)\b)"""
        + """|(?<token>"[^"\n]*"|[\w.+-]+|[{}()\[\],=:])|(?<other>.)""",
        RegexOptions.Singleline | RegexOptions.CultureInvariant);

    static readonly HashSet<string> StateNames = new() { "Blend", "ZWrite", "ZTest", "Cull", "ColorMask" };

    readonly string _path;
    readonly List<(string Text, int Line, bool IsProgram)> _tokens = new();
    int _at;

    ShaderLabReader(string text, string path, int firstLine)
    {
        _path = path;
        var (line, from) = (firstLine, 0);
        foreach (Match match in Tokens.Matches(text))
        {
            line += text.AsSpan(from, match.Index - from).Count('\n');
            from = match.Index;
            if (match.Groups["other"].Success) throw new ShaderLabException(path, line, $"'{match.Value}' is not understood");
            if (!match.Groups["space"].Success) _tokens.Add((match.Value, line, match.Groups["program"].Success));
        }
    }

    /// <param name="firstLine">Line number, within the file, of the first line of the text.</param>
    public static ShaderSource Read(string text, string path, int firstLine = 1) => new ShaderLabReader(text, path, firstLine).Shader();

    ShaderSource Shader()
    {
        Take("Shader");
        var name = TakeString();
        IReadOnlyList<ShaderProperty> properties = [];
        var subShaders = new List<SubShader>();
        Take("{");
        while (!TryTake("}"))
        {
            if (TryTake("Properties")) properties = Properties();
            else if (Next == "SubShader") subShaders.Add(SubShader());
            else throw NotUnderstood("Shader");
        }
        if (_at < _tokens.Count) throw Error($"'{Next}' stands after the end of the shader: its braces do not match");
        return new ShaderSource(_path, name, properties, subShaders);
    }

    List<ShaderProperty> Properties()
    {
        var properties = new List<ShaderProperty>();
        Take("{");
        while (!TryTake("}"))
        {
            while (TryTake("["))
                while (!TryTake("]")) TakeAny();
            var line = Line;
            var name = TakeAny();
            Take("(");
            TakeString();
            Take(",");
            var type = TakeAny();
            if (TryTake("(")) TakeThrough(")");
            Take(")");
            Take("=");
            Default(type);
            if (properties.Any(p => p.Name == name)) throw new ShaderLabException(_path, line, $"property {name} is declared twice");
            properties.Add(new ShaderProperty(name, type, line));
        }
        return properties;
    }

    void Default(string type)
    {
        switch (type)
        {
            case "Color" or "Vector":
                Take("(");
                for (var i = 0; i < 4; i++)
                {
                    TakeNumber();
                    Take(i < 3 ? "," : ")");
                }
                break;
            case "2D":
                TakeString();
                Take("{");
                Take("}");
                break;
            case "Float" or "Range":
                TakeNumber();
                break;
            default:
                throw Error($"a property of type {type} is not understood");
        }
    }

    SubShader SubShader()
    {
        var line = Line;
        Take("SubShader");
        Take("{");
        IReadOnlyList<string> requirements = [];
        // Unity requires this block before all others.
        if (TryTake("PackageRequirements")) requirements = Requirements();
        var tags = new Dictionary<string, string>();
        var passes = new List<ShaderPass>();
        while (!TryTake("}"))
        {
            if (TryTake("Tags")) tags = Tags();
            else if (Next == "Pass") passes.Add(Pass());
            else throw NotUnderstood("SubShader");
        }
        return new SubShader(requirements, tags, passes, line);
    }

    List<string> Requirements()
    {
        var packages = new List<string>();
        Take("{");
        while (!TryTake("}"))
        {
            packages.Add(TakeString());
            if (TryTake(":")) TakeString();
        }
        return packages;
    }

    Dictionary<string, string> Tags()
    {
        var tags = new Dictionary<string, string>();
        Take("{");
        while (!TryTake("}"))
        {
            var name = TakeString();
            Take("=");
            tags.Add(name, TakeString());
        }
        return tags;
    }

    ShaderPass Pass()
    {
        var line = Line;
        Take("Pass");
        Take("{");
        var (name, tags) = ("", new Dictionary<string, string>());
        var states = new Dictionary<string, string>();
        ShaderProgram program = null;
        while (!TryTake("}"))
        {
            if (TryTake("Name")) name = TakeString();
            else if (TryTake("Tags")) tags = Tags();
            else if (StateNames.Contains(Next)) State(states);
            else if (program == null && _at < _tokens.Count && _tokens[_at].IsProgram) program = Program();
            else throw NotUnderstood("Pass");
        }
        if (program == null) throw new ShaderLabException(_path, line, "the pass has no program");
        return new ShaderPass(name, tags, states, program, line);
    }

    // A render state ends at the end of the line.
    void State(Dictionary<string, string> states)
    {
        var line = Line;
        var name = TakeAny();
        var value = new List<string>();
        while (Line == line && Next != "}") value.Add(TakeAny());
        if (value.Count == 0) throw new ShaderLabException(_path, line, $"{name} has no value");
        states.Add(name, string.Join(" ", value));
    }

    ShaderProgram Program()
    {
        var (text, line, _) = _tokens[_at++];
        var match = Tokens.Match(text);
        var isCg = text.StartsWith("CG", StringComparison.Ordinal);
        if (text.EndsWith("ENDCG", StringComparison.Ordinal) != isCg) throw new ShaderLabException(_path, line, "the program ends as the other kind");
        return new ShaderProgram(match.Groups["text"].Value, line, isCg);
    }

    ShaderLabException NotUnderstood(string block) =>
        Error(_at == _tokens.Count ? "the file ends too early: its braces do not match" : $"'{Next}' is not understood in a {block}");

    string Next => _at < _tokens.Count ? _tokens[_at].Text : "the end of the file";

    int Line => _at < _tokens.Count ? _tokens[_at].Line : _tokens.Count > 0 ? _tokens[^1].Line : 1;

    string TakeAny()
    {
        if (_at == _tokens.Count) throw Error("the file ends too early: its braces do not match");
        return _tokens[_at++].Text;
    }

    void Take(string expected)
    {
        if (!TryTake(expected)) throw Error($"'{expected}' is expected before '{Next.Split('\n')[0]}'");
    }

    bool TryTake(string expected)
    {
        if (_at == _tokens.Count || _tokens[_at].Text != expected) return false;
        _at++;
        return true;
    }

    string TakeString()
    {
        if (!Next.StartsWith('"')) throw Error($"a string in quotes is expected before '{Next}'");
        return TakeAny().Trim('"');
    }

    void TakeNumber()
    {
        var text = TakeAny();
        if (!double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out _)) throw Error($"'{text}' is not a number");
    }

    void TakeThrough(string last)
    {
        while (!TryTake(last)) TakeAny();
    }

    ShaderLabException Error(string problem) => new(_path, Line, problem);
}
