using System.Text.RegularExpressions;

namespace Nowpose.Metas;

/// <summary>Reads and writes the text of a .meta file.</summary>
public sealed partial class MetaFile
{
    static readonly string[] Trailer = { "  userData: ", "  assetBundleName: ", "  assetBundleVariant: " };

    readonly string _text;

    public MetaFile(string text) => _text = text;

    /// <summary>GUID with 32 lower-case hexadecimal digits; null if the file contains no valid one.</summary>
    public string AssetGuid => Guids().Match(_text) is { Success: true } match ? match.Groups[1].Value : null;

    /// <summary>Name of the importer block; null if there is none.</summary>
    public string ImporterName => Importers().Match(_text) is { Success: true } match ? match.Groups[1].Value : null;

    public bool IsFolder => FolderLine().IsMatch(_text);

    /// <summary>Creates the text as Unity writes it, with LF line endings and a space after <c>userData:</c>.</summary>
    public static string Format(AssetEntry asset, string assetGuid)
    {
        var importer = Importer.For(asset);
        var lines = new List<string> { "fileFormatVersion: 2", "guid: " + assetGuid };
        if (asset.IsFolder) lines.Add("folderAsset: yes");
        lines.Add(importer.Name + ":");
        lines.AddRange(importer.Fields.Select(field => "  " + field));
        lines.AddRange(Trailer);
        return string.Join('\n', lines) + "\n";
    }

    [GeneratedRegex(@"^guid: ([0-9a-f]{32})\s*$", RegexOptions.Multiline)]
    private static partial Regex Guids();

    [GeneratedRegex(@"^(\w+Importer):\s*$", RegexOptions.Multiline)]
    private static partial Regex Importers();

    [GeneratedRegex(@"^folderAsset: yes\s*$", RegexOptions.Multiline)]
    private static partial Regex FolderLine();
}
