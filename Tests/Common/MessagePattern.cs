using System.Text.RegularExpressions;

namespace Nowpose.Tests.Common;

/// <summary>Creates the pattern of a message of which a part is not known in advance, for example the reason that the system states.</summary>
static class MessagePattern
{
    /// <summary>Argument of a catalogue member in place of the unknown part.</summary>
    public const string Any = "<any>";

    /// <param name="message">Text of the catalogue in which each <see cref="Any"/> stands for one or more characters of the same line.</param>
    public static string Of(string message) => Regex.Escape(message).Replace(Any, ".+", StringComparison.Ordinal);
}
