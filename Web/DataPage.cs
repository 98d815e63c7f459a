using System.Text.Json;

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
    public string Render(string json)
    {
        if (HasPlots) return With(json);
        using var data = JsonDocument.Parse(json);
        return _plain(data.RootElement);
    }

    /// <summary>Reads a page; null if this assembly was built without Node.js.</summary>
    internal static string Read(string resource)
    {
        using var stream = typeof(DataPage).Assembly.GetManifestResourceStream(resource);
        if (stream == null) return null;
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }

    // Inserts the data. Escapes each <, which in JSON occurs only within strings, so that no string can end the script element.
    string With(string json)
    {
        var at = _html.IndexOf(Placeholder, StringComparison.Ordinal);
        var data = json.Replace("<", "\\u003c", StringComparison.Ordinal);
        return string.Concat(_html.AsSpan(0, at), data, _html.AsSpan(at + Placeholder.Length));
    }
}
