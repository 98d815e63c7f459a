using System.Text.Json;

namespace Nowpose.Cli.SessionFiles;

/// <summary>
/// The fields of a JSON object. If a required field is missing, or a field has the wrong type, the error names the file, the line and the field.
/// </summary>
readonly struct LineFields(string place, JsonElement fields)
{
    readonly JsonElement _fields = fields;

    /// <summary>File and line, for error messages.</summary>
    public string Place => place;

    public bool Has(string name) => _fields.TryGetProperty(name, out var value) && value.ValueKind != JsonValueKind.Null;

    public string Text(string name) => StringOf(Required(name)) ?? throw Wrong(name, SessionFileMessages.NotAString);

    public string TextOrNull(string name) => Has(name) ? Text(name) : null;

    public bool FlagOr(string name, bool otherwise)
    {
        if (!Has(name)) return otherwise;
        var kind = Required(name).ValueKind;
        return kind is JsonValueKind.True or JsonValueKind.False ? kind == JsonValueKind.True : throw Wrong(name, SessionFileMessages.NotASwitch);
    }

    /// <summary>Gets a 64-bit integer, for example a time in nanoseconds.</summary>
    public long Whole(string name)
    {
        var value = Required(name);
        return value.ValueKind == JsonValueKind.Number && value.TryGetInt64(out var number)
            ? number : throw Wrong(name, SessionFileMessages.NotWhole(Shown(value)));
    }

    /// <summary>Gets a duration in nanoseconds; zero if the field is missing.</summary>
    /// <param name="maxNs">Maximum duration, ns.</param>
    public TimeSpan NanosecondsOrZero(string name, long maxNs)
    {
        var value = Has(name) ? Whole(name) : 0;
        return value >= 0 && value <= maxNs
            ? new TimeSpan(value / TimeSpan.NanosecondsPerTick) : throw Wrong(name, SessionFileMessages.Nanoseconds(value, maxNs));
    }

    public double Number(string name)
    {
        var value = Required(name);
        return value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out var number) && double.IsFinite(number)
            ? number : throw Wrong(name, SessionFileMessages.NotFinite(Shown(value)));
    }

    public double NumberOr(string name, double otherwise) => Has(name) ? Number(name) : otherwise;

    /// <param name="count">Required number of elements; null to allow any number.</param>
    /// <param name="mayBeAbsent">Whether elements can be null. A null element is returned as NaN.</param>
    public double[] Numbers(string name, int? count = null, bool mayBeAbsent = false)
    {
        var array = Array(name);
        if (count.HasValue && array.GetArrayLength() != count) throw Wrong(name, SessionFileMessages.Count(array.GetArrayLength(), count));
        var numbers = new double[array.GetArrayLength()];
        var i = 0;
        foreach (var value in array.EnumerateArray())
        {
            if (value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out numbers[i]) && double.IsFinite(numbers[i])) i++;
            else if (mayBeAbsent && value.ValueKind == JsonValueKind.Null) numbers[i++] = double.NaN;
            else throw Wrong(name, SessionFileMessages.ElementNotFinite(i + 1, Shown(value)));
        }
        return numbers;
    }

    public string[] Texts(string name)
    {
        var array = Array(name);
        var texts = new string[array.GetArrayLength()];
        var i = 0;
        foreach (var value in array.EnumerateArray())
        {
            texts[i] = StringOf(value) ?? throw Wrong(name, SessionFileMessages.ElementNotAString(i + 1, Shown(value)));
            i++;
        }
        return texts;
    }

    public LineFields Object(string name) => Required(name) is { ValueKind: JsonValueKind.Object } value
        ? new LineFields(place, value) : throw Wrong(name, SessionFileMessages.NotAnObject);

    public IEnumerable<LineFields> Objects(string name)
    {
        foreach (var value in Array(name).EnumerateArray())
            yield return value.ValueKind == JsonValueKind.Object
                ? new LineFields(place, value) : throw Wrong(name, SessionFileMessages.ValueNotAnObject(Shown(value)));
    }

    public InputException Wrong(string field, string what) => new($"{place}: field '{field}' {what}");

    JsonElement Array(string name) => Required(name) is { ValueKind: JsonValueKind.Array } value ? value : throw Wrong(name, SessionFileMessages.NotAnArray);

    JsonElement Required(string name) => _fields.TryGetProperty(name, out var value) ? value : throw Wrong(name, SessionFileMessages.Missing);

    // Returns null if the value is not a string, or contains half of a surrogate pair such as \ud800.
    static string StringOf(JsonElement value)
    {
        try
        {
            return value.ValueKind == JsonValueKind.String ? value.GetString() : null;
        }
        catch (InvalidOperationException)
        {
            return null;
        }
    }

    static string Shown(JsonElement value)
    {
        var text = value.GetRawText().ReplaceLineEndings(" ");
        return text.Length <= 40 ? text : text[..40] + "…";
    }
}
