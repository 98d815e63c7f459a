using System.CommandLine;

namespace Nowpose.Gateway.Options;

/// <summary>Creates options that take a text, such as a name or a path.</summary>
public static class TextOption
{
    /// <param name="placeholder">
    /// The value's name in the help, such as NAME; null for the option's name. With FILE or FOLDER, a path in a configuration file is relative to that file.
    /// </param>
    /// <param name="standard">The value if the option is not given.</param>
    public static Option<string> Create(string name, string description, string placeholder = null, string standard = null)
    {
        var option = new Option<string>(name) { Description = description, HelpName = placeholder };
        if (standard != null) option.DefaultValueFactory = _ => standard;
        return option;
    }

    /// <summary>Creates an option that can be given several times. Its value is empty if it is not given.</summary>
    /// <inheritdoc cref="Create"/>
    public static Option<string[]> CreateList(string name, string description, string placeholder = null) =>
        new(name) { Description = description, HelpName = placeholder };
}
