using System.Globalization;
using System.Text;

namespace Nowpose.Gateway.Status;

/// <summary>Writes metrics in the text format of Prometheus, version 0.0.4: each with its help and type, then its samples.</summary>
sealed class PrometheusText
{
    public const string ContentType = "text/plain; version=0.0.4; charset=utf-8";

    readonly StringBuilder _text = new();
    // The written samples of the current metric. A duplicate would make the whole text invalid for Prometheus.
    readonly HashSet<string> _written = [];
    string _name;

    /// <summary>Starts a metric; its samples follow.</summary>
    public PrometheusText Begin(string name, string type, string help)
    {
        _name = name;
        _written.Clear();
        _text.Append("# HELP ").Append(name).Append(' ').Append(help.Replace("\\", "\\\\").Replace("\n", "\\n")).Append('\n');
        _text.Append("# TYPE ").Append(name).Append(' ').Append(type).Append('\n');
        return this;
    }

    /// <summary>Adds a sample. A value that is unknown or not finite is skipped, and so is a second one with the same labels.</summary>
    public PrometheusText Add(double? value, params ReadOnlySpan<(string Name, string Value)> labels) => Add("", value, labels);

    /// <param name="suffix">Suffix of the metric's name, for example "_bucket".</param>
    public PrometheusText Add(string suffix, double? value, params ReadOnlySpan<(string Name, string Value)> labels)
    {
        if (value is not { } known || !double.IsFinite(known)) return this;
        var series = SeriesOf(_name + suffix, labels);
        if (_written.Add(series)) _text.Append(series).Append(' ').Append(known.ToString("R", CultureInfo.InvariantCulture)).Append('\n');
        return this;
    }

    /// <summary>Adds a metric with one sample without labels.</summary>
    public PrometheusText One(string name, string type, string help, double? value) => value == null ? this : Begin(name, type, help).Add(value);

    public override string ToString() => _text.ToString();

    static string SeriesOf(string name, ReadOnlySpan<(string Name, string Value)> labels)
    {
        var text = new StringBuilder(name);
        for (var i = 0; i < labels.Length; i++)
        {
            text.Append(i == 0 ? '{' : ',').Append(labels[i].Name).Append("=\"");
            Escape(text, labels[i].Value);
            text.Append('"');
        }

        return labels.Length > 0 ? text.Append('}').ToString() : text.ToString();
    }

    // A lone surrogate is not valid UTF-8. It is replaced here, so that duplicates are detected before the encoder replaces it.
    static void Escape(StringBuilder text, string value)
    {
        foreach (var rune in value.EnumerateRunes()) _ = rune.Value switch
        {
            '\\' => text.Append("\\\\"),
            '"' => text.Append("\\\""),
            '\n' => text.Append("\\n"),
            _ => text.Append(rune.ToString()),
        };
    }
}
