using System.Globalization;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace Nowpose.Cli;

/// <summary>
/// Creates the JSON text that commands print: the properties of a value in snake case, numbers with all digits. Only characters outside ASCII have
/// escape sequences, because PowerShell writes them to a file in an encoding that JSON does not allow.
/// </summary>
static partial class JsonText
{
    static readonly JsonSerializerOptions Indented = new()
    {
        PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower, WriteIndented = true, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    static readonly JsonSerializerOptions OneLine = new(Indented) { WriteIndented = false };

    /// <exception cref="ArgumentException">A number is not finite. JSON has no NaN, and valid results have only finite numbers.</exception>
    public static string Of(object value, bool isIndented = true) => BeyondAscii().Replace(
        JsonSerializer.Serialize(value, isIndented ? Indented : OneLine),
        character => string.Create(CultureInfo.InvariantCulture, $@"\u{(int)character.Value[0]:x4}"));

    [GeneratedRegex(@"[^\x00-\x7f]")]
    private static partial Regex BeyondAscii();
}
