using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Latency.Profile
{
    /// <summary>Reads individual fields of a flat JSON object. Each error message is one line that names the file and the field.</summary>
    sealed class ProfileFields
    {
        /// <summary>Maximum nesting depth. Unknown fields may be nested.</summary>
        const int Nesting = 8;

        const int MaxShownLength = 40;

        /// <summary>Represents a value that is neither a string nor a number.</summary>
        static readonly object Other = new object();

        readonly string _name;
        readonly Dictionary<string, object> _values = new Dictionary<string, object>();

        /// <exception cref="InputException">The text is not one JSON object, or a field occurs twice.</exception>
        public ProfileFields(string text, string name)
        {
            _name = name;
            var utf8 = Encoding.UTF8.GetBytes(text);
            if (JsonUtf8Reader.Check(utf8, Nesting) != DropReason.None)
                throw Fault(ProfileMessages.NotComplete);
            var json = new JsonUtf8Reader(utf8, Nesting);
            json.BeginObject();
            while (json.NextField(out var field))
                if (!_values.TryAdd(field, Read(ref json))) throw Fault(ProfileMessages.Twice(field));
        }

        static object Read(ref JsonUtf8Reader json)
        {
            if (json.TakeNull()) return null;
            if (json.IsText && json.Text(out var text)) return text;
            if (json.IsNumber && json.Number(out var number)) return number;
            json.Skip();
            return Other;
        }

        public double Number(string field, double min, double max, string unit) =>
            OptionalNumber(field, min, max, unit) ?? throw Missing(field);

        /// <returns>Null when the value is null or the field is missing.</returns>
        public double? OptionalNumber(string field, double min, double max, string unit)
        {
            switch (ValueOf(field))
            {
                case null: return null;
                case double value: return SettingRange.Require(value, min, max, _name + ": " + field, unit);
                default: throw Fault(ProfileMessages.NotANumber(field, Shown(ValueOf(field)), min, max, SettingRange.Suffix(unit)));
            }
        }

        public int Count(string field)
        {
            var value = Number(field, 0, int.MaxValue, "");
            return value == Math.Floor(value) ? (int)value : throw Fault(ProfileMessages.NotWhole(field, value));
        }

        public string Text(string field) => OptionalText(field) ?? throw Missing(field);

        /// <inheritdoc cref="OptionalNumber"/>
        public string OptionalText(string field)
        {
            var value = ValueOf(field);
            return value == null ? null : value as string ?? throw Fault(ProfileMessages.NotAText(field, Shown(value)));
        }

        public DateTime Utc(string field)
        {
            var text = Text(field);
            const DateTimeStyles styles = DateTimeStyles.AdjustToUniversal | DateTimeStyles.AssumeUniversal;
            return DateTime.TryParse(text, CultureInfo.InvariantCulture, styles, out var utc)
                ? utc : throw Fault(ProfileMessages.NotADate(field, text));
        }

        public InputException Fault(string what) => new InputException(_name + ": " + what);

        InputException Missing(string field) => Fault(ProfileMessages.Missing(field));

        static string Shown(object value) => value switch
        {
            string text => "'" + InputException.OneLine(text, MaxShownLength) + "'",
            double number => number.ToString(CultureInfo.InvariantCulture),
            _ => ProfileMessages.OtherKind,
        };

        object ValueOf(string field) => _values.TryGetValue(field, out var value) ? value : null;
    }
}
