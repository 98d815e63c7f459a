using YamlDotNet.Core;
using YamlDotNet.Core.Events;
using Nowpose.Gateway.Options;

namespace Nowpose.Gateway.Configuration;

/// <summary>Reads a configuration file: YAML with one mapping from keys to a word or a list of words.</summary>
/// <remarks>
/// Reads YAML event by event and builds no tree, so that deep nesting needs no memory. Refuses references, tags and anchors.
/// </remarks>
static class ConfigurationFile
{
    const int MaxBytes = 64 * 1024;

    /// <param name="wrong">Receives the errors in the file.</param>
    /// <exception cref="InputException">The file cannot be read.</exception>
    public static IReadOnlyList<ConfigurationEntry> Read(string path, InvalidEntries wrong) => Parse(Load(path), path, wrong);

    /// <param name="path">Path used in messages.</param>
    internal static IReadOnlyList<ConfigurationEntry> Parse(string text, string path, InvalidEntries wrong)
    {
        var entries = new List<ConfigurationEntry>();
        var parser = new Parser(new StringReader(text));
        try
        {
            parser.Consume<StreamStart>();
            if (parser.TryConsume<DocumentStart>(out _) && TryReadDocument(parser, path, entries, wrong) && !parser.Accept<StreamEnd>(out _))
                wrong.AddUnknown(ConfigurationMessages.SecondDocument(PlaceOf(path, parser.Current)));
        }
        catch (YamlException broken)
        {
            wrong.AddUnknown($"{path}:{broken.Start.Line}: not valid YAML: {(broken.InnerException ?? broken).Message.ReplaceLineEndings(" ")}");
        }
        // YamlDotNet's parser also throws these for some invalid input, for example for a plain word in an unclosed flow mapping.
        catch (Exception broken) when (broken is InvalidOperationException or ArgumentException or IndexOutOfRangeException or EndOfStreamException)
        {
            wrong.AddUnknown(ConfigurationMessages.NotYaml(PlaceOf(path, parser.Current)));
        }

        return entries;
    }

    static string Load(string path) => FileFault.Report(
        () =>
        {
            var file = new FileInfo(path);
            if (file.Exists && file.Length > MaxBytes)
                throw new InputException(ConfigurationMessages.TooLong(path, file.Length, MaxBytes));
            return File.ReadAllText(path);
        },
        e => PathMessages.NotRead($"--config {path}", e));

    static bool TryReadDocument(Parser parser, string path, List<ConfigurationEntry> entries, InvalidEntries wrong)
    {
        // A file with only comments is one empty scalar. It sets no option.
        if (parser.Accept<Scalar>(out var only) && only.Value.Length == 0)
        {
            parser.Consume<Scalar>();
        }
        else if (!IsBare(parser.Current) || !parser.TryConsume<MappingStart>(out _))
        {
            wrong.AddUnknown(ConfigurationMessages.NoEntry(PlaceOf(path, parser.Current)));
            return false;
        }
        else
        {
            while (!parser.TryConsume<MappingEnd>(out _)) ReadEntry(parser, path, entries, wrong);
        }

        parser.Consume<DocumentEnd>();
        return true;
    }

    static void ReadEntry(Parser parser, string path, List<ConfigurationEntry> entries, InvalidEntries wrong)
    {
        var place = PlaceOf(path, parser.Current);
        if (!TryReadWord(parser, out var key))
        {
            wrong.AddUnknown(ConfigurationMessages.KeyNotAWord(place));
            Skip(parser);
            Skip(parser);
            return;
        }

        var entry = ReadValue(parser, key, place);
        var earlier = entries.FirstOrDefault(other => other.Key == key);
        if (earlier != null) wrong.Add(key, ConfigurationMessages.KeyTwice(place, key, earlier.Place));
        else if (entry == null) wrong.Add(key, ConfigurationMessages.ValueNotAWord(place, key));
        else entries.Add(entry);
    }

    // Returns null for a value that is neither a scalar nor a list of scalars.
    static ConfigurationEntry ReadValue(Parser parser, string key, string place)
    {
        if (TryReadWord(parser, out var word)) return new ConfigurationEntry(key, [word], false, place);
        if (!IsBare(parser.Current) || !parser.TryConsume<SequenceStart>(out _))
        {
            Skip(parser);
            return null;
        }

        var values = new List<string>();
        var isGood = true;
        while (!parser.TryConsume<SequenceEnd>(out _))
        {
            if (TryReadWord(parser, out var item)) values.Add(item);
            else
            {
                isGood = false;
                Skip(parser);
            }
        }

        return isGood ? new ConfigurationEntry(key, values, true, place) : null;
    }

    static bool TryReadWord(Parser parser, out string word)
    {
        word = parser.Current is Scalar scalar && IsBare(scalar) ? scalar.Value : null;
        return word != null && parser.MoveNext();
    }

    static bool IsBare(ParsingEvent at) => at is NodeEvent { Tag.IsEmpty: true, Anchor.IsEmpty: true };

    // Skips the next node with all its content.
    static void Skip(Parser parser)
    {
        var depth = 0;
        do
        {
            depth += parser.Consume<ParsingEvent>().NestingIncrease;
        }
        while (depth > 0);
    }

    static string PlaceOf(string path, ParsingEvent at) => $"{path}:{at?.Start.Line ?? 1}";
}
