using System.Text.Encodings.Web;
using System.Text.Json;

namespace Nowpose.Cli;

/// <summary>
/// Creates the JSON text that commands print: the properties of a value in snake case, numbers with all digits, names without escape sequences.
/// </summary>
static class JsonText
{
    static readonly JsonSerializerOptions Indented = new()
    {
        PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower, WriteIndented = true, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    static readonly JsonSerializerOptions OneLine = new(Indented) { WriteIndented = false };

    /// <exception cref="ArgumentException">A number is not finite. JSON has no NaN, and valid results have only finite numbers.</exception>
    public static string Of(object value, bool isIndented = true) => JsonSerializer.Serialize(value, isIndented ? Indented : OneLine);
}
