using System.CommandLine;
using System.CommandLine.Parsing;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Plants;

namespace Nowpose.Gateway.Configuration;

/// <summary>Inserts the entries of a configuration file before the typed arguments. Keys are option names; typed options take precedence.</summary>
sealed class ConfiguredArguments
{
    public const string Option = "--config", Check = "--check";

    readonly ConfiguredPlaces _places = new();
    readonly InvalidEntries _wrong = new();

    /// <summary>Maps the key of a list to the option that each element of the list sets.</summary>
    static readonly Dictionary<string, string> Plurals = new() { ["plants"] = "plant" };

    // Options that a configuration file must not contain.
    static readonly string[] NotInAFile = [Option, Check, "--help"];

    // Placeholders of options that take a path. In a file, paths are relative to the file's folder.
    static readonly string[] Paths = ["FILE", "FOLDER"];

    /// <summary>The errors in the file, one line each. Not empty only with <see cref="Check"/>, which reports them together with its own.</summary>
    public IReadOnlyList<string> Wrong => _wrong.Lines;

    /// <summary>Whether no error in the file concerns these options, so that a rule about them can be checked.</summary>
    public bool AreKnown(params ReadOnlySpan<Option> options)
    {
        foreach (var option in options)
            if (!_wrong.Allow(KeyOf(option))) return false;
        return true;
    }

    /// <summary>Inserts the entries of the file that <see cref="Option"/> names; with <see cref="Check"/>, only the valid ones.</summary>
    /// <returns>The combined arguments; the typed arguments if no file is given.</returns>
    /// <exception cref="InputException">
    /// The file cannot be read, or has invalid entries and is not only to be checked. The message lists all of them with their lines.
    /// </exception>
    public string[] Of(Command root, string[] args)
    {
        var typed = Invocation.Parse(root, args);
        var verb = typed.CommandResult.Command;
        if (verb.Options.OfType<Option<string>>().FirstOrDefault(option => option.Name == Option) is not { } config
            || typed.GetResult(config) is not { Tokens.Count: 1 } named) return args;
        var path = named.Tokens[0].Value;
        var added = new List<string>();
        foreach (var entry in ConfigurationFile.Read(path, _wrong)) Add(root, typed, entry, path, added);
        _wrong.Correct(KeysOf(verb));
        var isCheck = verb.Options.OfType<Option<bool>>().Any(option => option.Name == Check && typed.GetValue(option));
        if (Wrong.Count > 0 && !(isCheck && typed.Errors.Count == 0)) throw new WrongEntriesException(Wrong);
        // The file's arguments come first, because the typed arguments may end with values that belong to no option.
        var place = Array.IndexOf(args, verb.Name) + 1;
        return [.. args[..place], .. added, .. args[place..]];
    }

    /// <summary>Adds file and line to a message about an option that the file sets.</summary>
    public string Place(string complaint) => _places.Place(complaint);

    void Add(Command root, ParseResult typed, ConfigurationEntry entry, string path, List<string> added)
    {
        var verb = typed.CommandResult.Command;
        var name = "--" + (Plurals.TryGetValue(entry.Key, out var singular) ? singular : entry.Key);
        var option = verb.Options.FirstOrDefault(option => option.Name == name);
        if (option == null || NotInAFile.Contains(name))
        {
            _wrong.Add(entry.Key, entry.Wrong(ConfigurationMessages.UnknownEntry(verb.Name, Allowed(entry.Key, verb))));
            return;
        }

        var arguments = new List<string>();
        var fault = Fault(entry, option);
        if (fault == null)
        {
            // Passes name and value as one argument, because a value may begin with a dash.
            foreach (var value in entry.Values) arguments.Add($"{name}={Placed(value, option, path)}");
            fault = Invocation.Parse(root, [verb.Name, .. arguments]).Errors.FirstOrDefault(error => IsOf(error, option))?.Message;
        }

        if (fault != null) _wrong.Add(entry.Key, entry.Wrong(fault.StartsWith(name + ": ", StringComparison.Ordinal) ? fault[(name.Length + 2)..] : fault));
        else if (typed.GetResult(option) is null or { Implicit: true })
        {
            added.AddRange(arguments);
            _places.Add(name, entry, entry.Values.Where(value => IsPath(value, option)).Select(value => Placed(value, option, path)));
        }
    }

    // Returns the error in an option's value, worded as the command line words it; null for a valid value.
    static string Fault(ConfigurationEntry entry, Option option)
    {
        var takesMany = option.Arity.MaximumNumberOfValues > 1;
        if (entry.IsList && !takesMany) return ConfigurationMessages.List;
        if (entry.Values.Count == 0 || entry.Values.Any(value => value.Length == 0)) return "has no value";
        if (entry.Values.Any(value => value.Any(char.IsControl))) return ConfigurationMessages.ControlCharacter;
        if (option.ValueType == typeof(bool) && entry.Values[0] is not ("true" or "false"))
            return ConfigurationMessages.NotASwitch(entry.Values[0]);
        return null;
    }

    static bool IsOf(ParseError error, Option option) =>
        error.SymbolResult is OptionResult result && result.Option == option;

    static string Placed(string value, Option option, string path) =>
        IsPath(value, option) ? Path.Combine(Path.GetDirectoryName(Path.GetFullPath(path)), value) : value;

    static bool IsPath(string value, Option option) =>
        Paths.Contains(option.HelpName) || (option.HelpName == "ROBOT" && !RobotFiles.IsIncluded(value));

    // Returns the key that was probably meant, or the allowed keys, for the message.
    static string Allowed(string key, Command verb)
    {
        var keys = KeysOf(verb);
        return Nearest.Of(key, keys) is { } near ? $"did you mean '{near}'?" : $"allowed: {string.Join(", ", keys.Order(StringComparer.Ordinal))}";
    }

    static string[] KeysOf(Command verb) => [.. verb.Options.Where(option => !NotInAFile.Contains(option.Name)).Select(KeyOf)];

    static string KeyOf(Option option) => Plurals.FirstOrDefault(plural => plural.Value == option.Name[2..]).Key ?? option.Name[2..];
}
