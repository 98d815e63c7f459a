using System.Text.RegularExpressions;
using YamlDotNet.Core;

namespace Nowpose.UnityPlayer.Assets.Yaml;

/// <summary>Reads the objects in a file in Unity's text format.</summary>
/// <remarks>
/// The headers of Unity's documents are not valid YAML: they may have <c>stripped</c> after the anchor, and one tag directive applies to all
/// documents. The contents of the documents are valid YAML.
/// </remarks>
static class UnityDocumentReader
{
    const string Header = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";

    static readonly Regex Heads = new Regex(@"^--- !u!(\d+) &(-?\d+)( stripped)?$", RegexOptions.Multiline | RegexOptions.CultureInvariant);
    static readonly Regex DocumentStarts = new Regex("^---", RegexOptions.Multiline | RegexOptions.CultureInvariant);

    /// <summary>Reads a file.</summary>
    /// <param name="text">Content of the file, with LF or CRLF line endings.</param>
    /// <param name="file">Name of the file in error messages.</param>
    /// <exception cref="AssetException">Unity cannot read the file: it has an invalid header, invalid YAML, or a duplicate fileID.</exception>
    public static IReadOnlyList<UnityDocument> Read(string text, string file)
    {
        text = text.Replace("\r\n", "\n");
        if (!text.StartsWith(Header, StringComparison.Ordinal))
            throw new AssetException(AssetFault.Header, file + ": does not begin with the two header lines of Unity's YAML");
        var heads = Heads.Matches(text);
        RequireAllHeadsKnown(text, heads, file);

        var documents = new List<UnityDocument>(heads.Count);
        var ids = new HashSet<long>();
        for (var i = 0; i < heads.Count; i++)
        {
            var end = i + 1 < heads.Count ? heads[i + 1].Index : text.Length;
            var document = Document(heads[i], text, end, file);
            if (!ids.Add(document.FileId))
                throw new AssetException(AssetFault.Duplicate, file + " &" + document.FileId + ": this fileID occurs twice in the file");
            documents.Add(document);
        }
        return documents;
    }

    static void RequireAllHeadsKnown(string text, MatchCollection heads, string file)
    {
        if (heads.Count == 0) throw new AssetException(AssetFault.NoObject, file + ": contains no object");
        if (heads[0].Index != Header.Length) throw new AssetException(AssetFault.Header, file + ": text before the first object");
        var known = new HashSet<int>();
        foreach (Match head in heads) known.Add(head.Index);
        foreach (Match start in DocumentStarts.Matches(text))
        {
            if (!known.Contains(start.Index))
                throw new AssetException(AssetFault.Header, file + " line " + LineOf(text, start.Index)
                    + ": not the header of an object (--- !u!CLASS &FILEID)");
        }
    }

    static UnityDocument Document(Match head, string text, int end, string file)
    {
        var where = file + " &" + head.Groups[2].Value;
        if (!Numbers.TryRead(head.Groups[2].Value, out long fileId) || fileId == 0)
            throw new AssetException(AssetFault.FileId, where + ": not a fileID (a 64-bit integer other than 0)");
        var start = head.Index + head.Length;
        var root = Body(text, start, end, where);
        if (root.Children.Count != 1) throw new AssetException(AssetFault.ClassCount, where + ": must contain one class name with its fields");
        foreach (var entry in root.Children)
        {
            if (!(entry.Key is YamlScalarNode name) || !(entry.Value is YamlMappingNode fields))
                throw new AssetException(AssetFault.ClassCount, where + ": must contain one class name with its fields");
            return new UnityDocument(int.Parse(head.Groups[1].Value), name.Value, fileId, fields, head.Groups[3].Success);
        }
        throw new AssetException(AssetFault.ClassCount, where + ": is empty");
    }

    static YamlMappingNode Body(string text, int start, int end, string where)
    {
        var stream = new YamlStream();
        try
        {
            stream.Load(new StringReader(text.Substring(start, end - start)));
        }
        catch (YamlException exception)
        {
            throw new AssetException(AssetFault.Syntax, where + " line " + (LineOf(text, start) + exception.Start.Line - 1) + ": "
                + exception.Message, exception);
        }
        if (stream.Documents.Count != 1 || !(stream.Documents[0].RootNode is YamlMappingNode root))
            throw new AssetException(AssetFault.ClassCount, where + ": must contain one class name with its fields");
        return root;
    }

    static int LineOf(string text, int index)
    {
        var line = 1;
        for (var i = 0; i < index; i++)
        {
            if (text[i] == '\n') line++;
        }
        return line;
    }
}
