using System.Globalization;
using System.Text;

namespace Nowpose.Gateway.Status.Prometheus;

/// <summary>Writes metrics in the text format of Prometheus, version 0.0.4: help and type of each metric, then its samples.</summary>
sealed class PrometheusText
{
    public const string ContentType = "text/plain; version=0.0.4; charset=utf-8";

    readonly StringBuilder _text = new();
    // The samples of the current metric that are already written, because a duplicate makes the whole text invalid for Prometheus.
    readonly HashSet<string> _written = [];
    string _name;

    /// <summary>Starts a metric. Samples added afterwards belong to this metric.</summary>
    /// <param name="type">Type of the metric; null for a counter if the name ends with "_total", and for a gauge otherwise.</param>
    public PrometheusText Begin(string name, string help, string type = null)
    {
        _name = name;
        _written.Clear();
        _text.Append("# HELP ").Append(name).Append(' ').Append(help.Replace("\\", "\\\\").Replace("\n", "\\n")).Append('\n');
        type ??= name.EndsWith("_total", StringComparison.Ordinal) ? "counter" : "gauge";
        _text.Append("# TYPE ").Append(name).Append(' ').Append(type).Append('\n');
        return this;
    }

    /// <summary>Adds a sample. Skips a value that is unknown or not finite, and a second sample with the same labels.</summary>
    public PrometheusText Add(double? value, params ReadOnlySpan<(string Name, string Value)> labels) => Add("", value, labels);

    /// <inheritdoc cref="Add(double?, ReadOnlySpan{ValueTuple{string, string}})"/>
    /// <param name="suffix">Suffix of the metric's name, for example "_bucket".</param>
    public PrometheusText Add(string suffix, double? value, params ReadOnlySpan<(string Name, string Value)> labels)
    {
        if (value is not { } known || !double.IsFinite(known)) return this;
        var series = SeriesOf(_name + suffix, labels);
        if (_written.Add(series)) _text.Append(series).Append(' ').Append(known.ToString("R", CultureInfo.InvariantCulture)).Append('\n');
        return this;
    }

    /// <summary>Adds a metric that has one sample without labels. Skips a metric whose value is unknown.</summary>
    public PrometheusText One(string name, string help, double? value) => value == null ? this : Begin(name, help).Add(value);

    /// <summary>Adds a metric that has one sample for each of several things, such as headsets. Skips a metric without things.</summary>
    public void Each<T>(string name, string help, IReadOnlyList<T> all, Func<T, (string, string)[]> labels, Func<T, double?> value)
    {
        if (all.Count == 0) return;
        Begin(name, help);
        foreach (var one in all) Add(value(one), labels(one));
    }

    /// <summary>Adds a metric with a sample for each state of each thing: 1 for the present state, otherwise 0. Skips it without things.</summary>
    public void States<T>(
        string name, string help, IReadOnlyList<T> all, Func<T, (string, string)[]> labels, Func<T, string> present, IReadOnlyList<string> states)
    {
        if (all.Count == 0) return;
        Begin(name, help);
        foreach (var one in all)
            foreach (var state in states) Add(state == present(one) ? 1 : 0, [.. labels(one), ("state", state)]);
    }

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

    // Also replaces unpaired surrogates, as the UTF-8 encoder would do later, so that duplicates are detected.
    static void Escape(StringBuilder text, string value)
    {
        foreach (var rune in InputException.OneLine(value, int.MaxValue).EnumerateRunes()) _ = rune.Value switch
        {
            '\\' => text.Append("\\\\"),
            '"' => text.Append("\\\""),
            _ => text.Append(rune.ToString()),
        };
    }
}
