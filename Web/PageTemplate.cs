using System.Text.Json;
using Nowpose.Web.Messages;

namespace Nowpose.Web;

/// <summary>A bundled HTML page with a placeholder for its data. The page needs no network.</summary>
sealed class PageTemplate
{
    const string Placeholder = "__REPORT_DATA__";

    readonly string _html;

    PageTemplate(string html) => _html = html;

    /// <returns>The page; null if this assembly was built without Node.js.</returns>
    public static PageTemplate Named(string resource)
    {
        var html = Read(resource);
        return html == null ? null : new PageTemplate(html);
    }

    /// <summary>Reads a page that needs no data; null if this assembly was built without Node.js.</summary>
    public static string Read(string resource)
    {
        using var stream = typeof(PageTemplate).Assembly.GetManifestResourceStream(resource);
        if (stream == null) return null;
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }

    /// <exception cref="ArgumentException">The text is not a valid JSON object. JSON has no NaN.</exception>
    public static JsonDocument Parse(string json)
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

    /// <summary>
    /// Inserts the data. Escapes each &lt;, which in JSON occurs only within strings, so that no string can end the script element.
    /// </summary>
    public string With(string json)
    {
        var at = _html.IndexOf(Placeholder, StringComparison.Ordinal);
        var data = json.Replace("<", "\\u003c", StringComparison.Ordinal);
        return string.Concat(_html.AsSpan(0, at), data, _html.AsSpan(at + Placeholder.Length));
    }
}
