using System.Text;
using System.Xml.Linq;

namespace Nowpose.Packing;

/// <summary>Collects the licence texts of NuGet packages.</summary>
/// <param name="standard">
/// Licence texts by SPDX identifier, for packages that contain no licence text. If a package states several identifiers, the first one that has a
/// text here is used.
/// </param>
public sealed class LicenceTexts(IReadOnlyDictionary<string, string> standard)
{
    readonly StringBuilder _text = new();

    public override string ToString() => _text.ToString();

    /// <param name="folder">Folder with the unpacked package.</param>
    /// <exception cref="InvalidDataException">The package states no licence whose text is available.</exception>
    public void Add(string folder)
    {
        var package = XDocument.Load(Directory.GetFiles(folder, "*.nuspec").Single()).Root!.Elements().Single(element => element.Name.LocalName == "metadata");
        string Entry(string name) => package.Elements().FirstOrDefault(element => element.Name.LocalName == name)?.Value.Trim();

        var title = $"{Entry("id")} {Entry("version")}, {Entry("license")}";
        var own = Files(folder, "LICENSE*").Concat(Files(folder, "THIRD-PARTY-NOTICES*")).Select(File.ReadAllText).ToArray();
        var text = own.Length > 0 ? string.Join("\n\n", own) : Standard(title, Entry("license"), Entry("copyright"));
        _text.Append(title).Append("\n\n").Append(text.ReplaceLineEndings("\n").Trim()).Append("\n\n\n");
    }

    string Standard(string title, string licence, string copyright)
    {
        var known = (licence ?? "").Split(" OR ").FirstOrDefault(standard.ContainsKey)
            ?? throw new InvalidDataException($"{title}: the package has no text of its licence; add one of {string.Join(", ", standard.Keys)}");
        return $"{copyright}\n\n{standard[known]}";
    }

    static IEnumerable<string> Files(string folder, string pattern) => Directory
        .GetFiles(folder, pattern, new EnumerationOptions { MatchCasing = MatchCasing.CaseInsensitive }).Order(StringComparer.Ordinal);
}
