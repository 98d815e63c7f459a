using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace Nowpose.Cli;

/// <summary>Creates the JSON text that commands print: numbers with all digits, names without escape sequences.</summary>
static class JsonText
{
    /// <param name="write">Writes one JSON value.</param>
    public static string Of(bool isIndented, Action<Utf8JsonWriter> write)
    {
        using var bytes = new MemoryStream();
        var options = new JsonWriterOptions { Indented = isIndented, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };
        using (var json = new Utf8JsonWriter(bytes, options)) write(json);
        return Encoding.UTF8.GetString(bytes.ToArray());
    }
}
