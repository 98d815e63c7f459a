using System.Text.Json;
using Nowpose.Web.Messages;

namespace Nowpose.Web;

/// <summary>
/// A page that contains its data: one HTML file that needs no network. It has plots and tables, or only tables if this assembly was built without
/// Node.js.
/// </summary>
public sealed class DataPage
{
    const string Placeholder = "__REPORT_DATA__";

    readonly string _html;
    readonly Func<JsonElement, string> _plain;

    internal DataPage(string resource, Func<JsonElement, string> plain)
    {
        _html = Read(resource);
        _plain = plain;
    }

    /// <summary>Whether the page has plots; false if this assembly was built without Node.js.</summary>
    public bool HasPlots => _html != null;

    /// <summary>Creates the page.</summary>
    /// <param name="json">The data as a JSON object.</param>
    /// <exception cref="ArgumentException">The text is not a valid JSON object. JSON has no NaN.</exception>
    public string Render(string json)
    {
        using var data = Parse(json);
        return HasPlots ? With(json) : _plain(data.RootElement);
    }

    /// <summary>Reads a page; null if this assembly was built without Node.js.</summary>
    internal static string Read(string resource)
    {
        using var stream = typeof(DataPage).Assembly.GetManifestResourceStream(resource);
        if (stream == null) return null;
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }

    static JsonDocument Parse(string json)
    {
        JsonDocument data;
        try
        {
            data = JsonDocument.Parse(json);
        }
        catch (JsonException e)
        {
            throw new ArgumentException(PageMessages.NotJson(e.Message), nameof(json), e);
        }
        var kind = data.RootElement.ValueKind;
        if (kind == JsonValueKind.Object) return data;
        data.Dispose();
        throw new ArgumentException(PageMessages.NotAnObject(kind), nameof(json));
    }

    // Inserts the data. Escapes each <, which in JSON occurs only within strings, so that no string can end the script element.
    string With(string json)
    {
        var at = _html.IndexOf(Placeholder, StringComparison.Ordinal);
        var data = json.Replace("<", "\\u003c", StringComparison.Ordinal);
        return string.Concat(_html.AsSpan(0, at), data, _html.AsSpan(at + Placeholder.Length));
    }
}
