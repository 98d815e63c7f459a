using System.Globalization;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization;
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

    static readonly JsonSerializerOptions IndentedAndRounded = new(Indented) { Converters = { new RoundedNumber() } };

    static readonly JsonSerializerOptions OneLineAndRounded = new(IndentedAndRounded) { WriteIndented = false };

    /// <param name="isRounded">Whether numbers have ten digits, because the last digits of sine and cosine differ between machines.</param>
    /// <exception cref="ArgumentException">A number is not finite. JSON has no NaN, and valid results have only finite numbers.</exception>
    public static string Of(object value, bool isIndented = true, bool isRounded = false) => BeyondAscii().Replace(
        JsonSerializer.Serialize(value, isIndented ? isRounded ? IndentedAndRounded : Indented : isRounded ? OneLineAndRounded : OneLine),
        character => string.Create(CultureInfo.InvariantCulture, $@"\u{(int)character.Value[0]:x4}"));

    [GeneratedRegex(@"[^\x00-\x7f]")]
    private static partial Regex BeyondAscii();

    sealed class RoundedNumber : JsonConverter<double>
    {
        public override double Read(ref Utf8JsonReader reader, Type type, JsonSerializerOptions options) => reader.GetDouble();

        public override void Write(Utf8JsonWriter writer, double value, JsonSerializerOptions options) =>
            writer.WriteNumberValue(double.Parse(value.ToString("G10", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture));
    }
}
