using System;
using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>
    /// Reads the types of values that occur in the protocol's fields: names, optional strings and counts, finite numbers, and arrays of numbers.
    /// </summary>
    static class JsonFields
    {
        /// <summary>Reads a name: a non-empty string that is not longer than the protocol allows.</summary>
        public static bool Name(ref this JsonUtf8Reader json, out string name) =>
            json.Text(out name) && json.IsName(name, name.Length <= ProtocolLimits.NameLength);

        /// <summary>Reads a key of diagnostics.</summary>
        public static bool Key(ref this JsonUtf8Reader json, out string key) =>
            json.Text(out key) && json.IsName(key, key.Length <= ProtocolLimits.KeyLength);

        /// <summary>Reads a name. Creates no string object if the cache contains the name.</summary>
        /// <inheritdoc cref="Name(ref JsonUtf8Reader, out string)"/>
        public static bool Name(ref this JsonUtf8Reader json, JsonNameCache cache, out string name) =>
            json.Text(cache, out name) && json.IsName(name, name.Length <= ProtocolLimits.NameLength);

        /// <summary>Reads a name that may have the namespace of a robot before it.</summary>
        public static bool QualifiedName(ref this JsonUtf8Reader json, out string name) =>
            json.Text(out name) && json.IsName(name, RobotTopic.HasNameLength(name));

        /// <summary>Reads a name that may have the namespace of a robot before it. Creates no string object if the cache contains the name.</summary>
        public static bool QualifiedName(ref this JsonUtf8Reader json, JsonNameCache cache, out string name) =>
            json.Text(cache, out name) && json.IsName(name, RobotTopic.HasNameLength(name));

        /// <summary>Reads a string; the result is null for JSON null, which some languages write for a missing field.</summary>
        public static bool OptionalText(ref this JsonUtf8Reader json, out string text)
        {
            text = null;
            return json.TakeNull() || json.Text(out text);
        }

        /// <summary>Reads an optional string. Creates no string object if the cache contains the string.</summary>
        /// <inheritdoc cref="OptionalText(ref JsonUtf8Reader, out string)"/>
        public static bool OptionalText(ref this JsonUtf8Reader json, JsonNameCache cache, out string text)
        {
            text = null;
            return json.TakeNull() || json.Text(cache, out text);
        }

        public static bool OptionalCount(ref this JsonUtf8Reader json, out int count)
        {
            count = 0;
            if (json.TakeNull()) return true;
            if (!json.Integer(out var value)) return false;
            count = (int)Math.Min(Math.Max(value, 0), int.MaxValue);
            return value == count || json.Fail(DropReason.OutOfRange);
        }

        /// <summary>Reads an id: a string, an integer, or null for none.</summary>
        public static bool OptionalId(ref this JsonUtf8Reader json, out RequestId id)
        {
            var isNumber = json.IsNumber;
            var number = 0L;
            var text = default(string);
            var isRead = isNumber ? json.Integer(out number) : json.OptionalText(out text);
            id = !isRead ? default : isNumber ? (RequestId)number : text;
            return isRead;
        }

        /// <summary>Reads a number; rejects null, NaN and infinity.</summary>
        public static bool FiniteNumber(ref this JsonUtf8Reader json, out double value) =>
            json.Number(out value) && (!double.IsNaN(value) && !double.IsInfinity(value) || json.Fail(DropReason.NotFinite));

        /// <summary>Reads an array of at most 256 numbers; rejects infinite numbers.</summary>
        /// <param name="areOptional">Whether null and NaN are allowed as missing values; both become NaN.</param>
        /// <param name="tooMany">Fault if the array is longer.</param>
        public static bool Numbers(ref this JsonUtf8Reader json, List<double> into, bool areOptional, DropReason tooMany = DropReason.TooManyJoints)
        {
            if (!json.BeginArray()) return false;
            while (json.NextElement())
            {
                if (!json.Number(out var value)) return false;
                if (double.IsInfinity(value) || (double.IsNaN(value) && !areOptional)) return json.Fail(DropReason.NotFinite);
                into.Add(value);
                if (into.Count > ProtocolLimits.Joints) return json.Fail(tooMany);
            }

            return json.Fault == DropReason.None;
        }

        static bool Text(ref this JsonUtf8Reader json, JsonNameCache cache, out string text)
        {
            var isRead = json.ReadText(out var read);
            text = isRead ? cache[read] : null;
            return isRead;
        }

        static bool IsName(ref this JsonUtf8Reader json, string text, bool isShort)
        {
            if (text.Length == 0) return json.Fail(DropReason.MissingField);
            return isShort || json.Fail(DropReason.NameTooLong);
        }
    }
}
