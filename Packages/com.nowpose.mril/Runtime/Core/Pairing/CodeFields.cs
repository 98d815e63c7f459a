using System;
using System.Collections.Generic;
using System.Globalization;
using Nowpose.Messages;

namespace Nowpose.Pairing
{
    /// <summary>The fields of a pairing code. Rejects a string that does not match the grammar, with a one-line message.</summary>
    /// <remarks>Unknown fields are rejected, because such a field might be relevant to security; each new field needs a new version.</remarks>
    sealed class CodeFields
    {
        readonly string _what;
        readonly Dictionary<char, string> _values = new Dictionary<char, string>();

        /// <param name="kind">"cell" or "token".</param>
        /// <param name="version">The only supported version.</param>
        /// <param name="keys">All allowed keys; each may occur once.</param>
        /// <exception cref="InputException">
        /// The text is too long, of another kind or version, or invalid. The message never contains the value of a field.
        /// </exception>
        public CodeFields(string text, string kind, int version, string keys)
        {
            _what = kind + " code";
            // The length is checked first, because a code in view may contain thousands of characters.
            if (text == null || text.Length > PairingCode.MaxLength)
                throw Fault(PairingCodeMessages.TooLong(text?.Length ?? 0, PairingCode.MaxLength));
            RequirePlain(text);
            var begin = PairingCode.Scheme + kind + "/";
            if (!text.StartsWith(begin, StringComparison.Ordinal)) throw Fault(PairingCodeMessages.OtherBegin(begin));
            var query = text.IndexOf('?');
            RequireVersion(query < 0 ? text.Substring(begin.Length) : text.Substring(begin.Length, query - begin.Length), version);
            if (query < 0) throw Fault(PairingCodeMessages.NoFields(List(keys)));
            foreach (var field in text.Substring(query + 1).Split('&')) Add(field, keys);
        }

        /// <exception cref="InputException">The field is missing.</exception>
        public string Text(char key) => OptionalText(key) ?? throw Fault(PairingCodeMessages.FieldMissing(key));

        /// <returns>Null if the field is missing.</returns>
        public string OptionalText(char key) => _values.TryGetValue(key, out var value) ? value : null;

        /// <summary>Reads an integer without sign and leading zeros; returns <paramref name="otherwise"/> if the field is missing.</summary>
        public long Count(char key, long otherwise, long min, long max)
        {
            var text = OptionalText(key);
            if (text == null) return otherwise;
            var isNumber = long.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var value)
                && (text.Length == 1 || text[0] != '0');
            if (isNumber && value >= min && value <= max) return value;
            // A value that is not a number may contain any characters, so the message does not repeat it.
            throw Fault(isNumber ? PairingCodeMessages.OutOfRange(key, value, min, max) : PairingCodeMessages.NotWhole(key, min, max));
        }

        public InputException Fault(string what) => new InputException(_what + ": " + what);

        void RequirePlain(string text)
        {
            for (var i = 0; i < text.Length; i++)
                if (text[i] <= ' ' || text[i] > '~')
                    throw Fault(PairingCodeMessages.Character(i + 1, (int)text[i]));
        }

        void RequireVersion(string text, int version)
        {
            if (text.Length == 0 || text.Length > 4 || text[0] == '0'
                || !int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var read))
                throw Fault(PairingCodeMessages.NoVersion(version));
            if (read != version) throw Fault(PairingCodeMessages.OtherVersion(read, version));
        }

        void Add(string field, string keys)
        {
            if (field.Length < 2 || field[1] != '=') throw Fault(PairingCodeMessages.NotAField(List(keys)));
            var key = field[0];
            if (keys.IndexOf(key) < 0) throw Fault(PairingCodeMessages.UnknownField(key, List(keys)));
            if (field.Length == 2) throw Fault(PairingCodeMessages.FieldEmpty(key));
            if (!_values.TryAdd(key, field.Substring(2))) throw Fault(PairingCodeMessages.FieldTwice(key));
        }

        static string List(string keys) => string.Join(", ", keys.ToCharArray());
    }
}
