using System.Collections.Generic;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>Keys and values of a diagnostics message, which stays below the maximum length of a message.</summary>
    sealed class DiagnosticValues
    {
        /// <summary>
        /// Maximum length of all values up to a detail, in bytes, as <see cref="RosMessageWriter.MaxBytesOf"/> counts them. The rest of the maximum message length
        /// is for the values without details and for the text of the message.
        /// </summary>
        const int MaxBytes = 40 * 1024;

        // Two lists of joints of this length, and the details, are shorter than a message even if each character needs 3 bytes.
        const int MaxValueLength = 4000;

        // {"key":"","value":""},
        const int BytesPerPair = 24;

        readonly List<KeyValuePair<string, string>> _pairs = new List<KeyValuePair<string, string>>();
        int _bytes;

        public IReadOnlyList<KeyValuePair<string, string>> Pairs => _pairs;

        /// <summary>Adds a value. A longer value than the maximum is shortened.</summary>
        public void Add(string key, string value)
        {
            value = InputException.OneLine(value, MaxValueLength);
            _bytes += BytesOf(key, value);
            _pairs.Add(new KeyValuePair<string, string>(key, value));
        }

        /// <summary>Adds a value about one part, such as a joint, if the message has enough room.</summary>
        public void AddDetail(string key, string value)
        {
            if (_bytes + BytesOf(key, value) <= MaxBytes) Add(key, value);
        }

        static int BytesOf(string key, string value) => BytesPerPair + RosMessageWriter.MaxBytesOf(key) + RosMessageWriter.MaxBytesOf(value);
    }
}
