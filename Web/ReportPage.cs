using System.Text.Json;

namespace Nowpose.Web;

/// <summary>The report as one HTML page that needs no network: plots and tables, or tables alone when built without Node.js.</summary>
public static class ReportPage
{
    const string Placeholder = "__REPORT_DATA__";

    static readonly string Template = ReadTemplate();

    /// <summary>True when the page draws plots; false when Node.js was missing where this assembly was built.</summary>
    public static bool HasPlots => Template != null;

    /// <param name="json">One JSON object; the fields are those of <c>Web/src/data.ts</c>, each of which may be null or absent.</param>
    /// <exception cref="ArgumentException">The text is not JSON (which has no NaN) or not an object.</exception>
    public static string Render(string json)
    {
        using var data = Parse(json);
        return HasPlots ? Insert(Template, json) : PlainReport.Render(data.RootElement);
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
            throw new ArgumentException($"the report's data is not JSON: {e.Message}", nameof(json), e);
        }
        var kind = data.RootElement.ValueKind;
        if (kind == JsonValueKind.Object) return data;
        data.Dispose();
        throw new ArgumentException($"the report's data is a JSON {kind}, an object is needed", nameof(json));
    }

    /// <summary>In JSON a &lt; stands only inside strings, where its escape means the same and cannot end the script element.</summary>
    static string Insert(string template, string json)
    {
        var at = template.IndexOf(Placeholder, StringComparison.Ordinal);
        var data = json.Replace("<", "\\u003c", StringComparison.Ordinal);
        return string.Concat(template.AsSpan(0, at), data, template.AsSpan(at + Placeholder.Length));
    }

    static string ReadTemplate()
    {
        using var stream = typeof(ReportPage).Assembly.GetManifestResourceStream("report.html");
        if (stream == null) return null;
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }
}
