using System;
using System.Globalization;
using Newtonsoft.Json;

namespace Nowpose.Protocol
{
    /// <summary>
    /// Id of a rosbridge request, which its sender chooses and the reply repeats: a string or an integer. The default value stands for no id. An integer
    /// creates no string object, because a source may number its samples.
    /// </summary>
    readonly struct RequestId : IEquatable<RequestId>
    {
        readonly long? _number;

        RequestId(string text, long? number) => (Text, _number) = (text, number);

        public bool IsNone => Text == null && _number == null;

        /// <summary>The id if it is a string; otherwise null.</summary>
        public string Text { get; }

        public static implicit operator RequestId(string text) => new RequestId(text, null);

        public static implicit operator RequestId(long number) => new RequestId(null, number);

        public static bool operator ==(RequestId left, RequestId right) => left.Equals(right);

        public static bool operator !=(RequestId left, RequestId right) => !left.Equals(right);

        /// <summary>Writes the id as a field; writes nothing for no id.</summary>
        public void Write(JsonWriter json)
        {
            if (IsNone) return;
            json.WritePropertyName("id");
            if (_number is { } number) json.WriteValue(number);
            else json.WriteValue(Text);
        }

        public bool Equals(RequestId other) => Text == other.Text && _number == other._number;

        public override bool Equals(object obj) => obj is RequestId other && Equals(other);

        public override int GetHashCode() => Text?.GetHashCode() ?? _number.GetHashCode();

        public override string ToString() => Text ?? _number?.ToString(CultureInfo.InvariantCulture) ?? "";
    }
}
