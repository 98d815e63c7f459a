using System.Text;
using YamlDotNet.Core.Events;

namespace Nowpose.UnityPlayer.Assets.Yaml;

/// <summary>
/// Writes objects in Unity's text format: an indent of two spaces per level, the dashes of a list at the indent of its field, references and
/// vectors in braces on one line, and an empty scalar as <c>name: </c>.
/// </summary>
sealed class UnityDocumentWriter
{
    const int Step = 2;

    readonly StringBuilder _text = new StringBuilder("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n");

    public static string Write(IEnumerable<UnityDocument> documents)
    {
        var writer = new UnityDocumentWriter();
        foreach (var document in documents) writer.Add(document);
        return writer._text.ToString();
    }

    void Add(UnityDocument document)
    {
        _text.Append("--- !u!").Append(Numbers.Write(document.ClassId)).Append(" &").Append(Numbers.Write(document.FileId));
        if (document.IsStripped) _text.Append(" stripped");
        _text.Append('\n').Append(document.ClassName).Append(":\n");
        Entries(document.Fields, Step, indentFirst: true);
    }

    void Entries(YamlMappingNode mapping, int indent, bool indentFirst)
    {
        foreach (var entry in mapping.Children)
        {
            if (indentFirst) _text.Append(' ', indent);
            indentFirst = true;
            ScalarText.Append(_text, (YamlScalarNode)entry.Key, indent + Step);
            _text.Append(':');
            Value(entry.Value, indent);
        }
    }

    void Value(YamlNode value, int indent)
    {
        switch (value)
        {
            case YamlMappingNode mapping when IsBlock(mapping):
                _text.Append('\n');
                Entries(mapping, indent + Step, indentFirst: true);
                break;
            case YamlSequenceNode sequence when IsBlock(sequence):
                _text.Append('\n');
                Items(sequence, indent);
                break;
            default:
                _text.Append(' ');
                Inline(value, indent + Step);
                _text.Append('\n');
                break;
        }
    }

    void Items(YamlSequenceNode sequence, int indent)
    {
        foreach (var item in sequence.Children)
        {
            _text.Append(' ', indent).Append("- ");
            if (item is YamlMappingNode mapping && IsBlock(mapping))
            {
                Entries(mapping, indent + Step, indentFirst: false);
                continue;
            }
            Inline(item, indent + Step);
            _text.Append('\n');
        }
    }

    void Inline(YamlNode node, int continuation)
    {
        switch (node)
        {
            case YamlScalarNode scalar:
                ScalarText.Append(_text, scalar, continuation);
                break;
            case YamlMappingNode mapping:
                Braced('{', mapping.Children, '}', continuation);
                break;
            case YamlSequenceNode sequence:
                Bracketed(sequence, continuation);
                break;
        }
    }

    void Braced(char open, IEnumerable<KeyValuePair<YamlNode, YamlNode>> entries, char close, int continuation)
    {
        _text.Append(open);
        var first = true;
        foreach (var entry in entries)
        {
            if (!first) _text.Append(", ");
            first = false;
            Inline(entry.Key, continuation);
            _text.Append(": ");
            Inline(entry.Value, continuation);
        }
        _text.Append(close);
    }

    void Bracketed(YamlSequenceNode sequence, int continuation)
    {
        _text.Append('[');
        for (var i = 0; i < sequence.Children.Count; i++)
        {
            if (i > 0) _text.Append(", ");
            Inline(sequence.Children[i], continuation);
        }
        _text.Append(']');
    }

    static bool IsBlock(YamlMappingNode mapping) => mapping.Children.Count > 0 && mapping.Style != MappingStyle.Flow;

    static bool IsBlock(YamlSequenceNode sequence) => sequence.Children.Count > 0 && sequence.Style != SequenceStyle.Flow;
}
