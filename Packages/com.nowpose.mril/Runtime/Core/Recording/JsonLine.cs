using System;
using System.Globalization;

namespace Nowpose.Recording
{
    /// <summary>Builds one line of JSON in a reused buffer; allocates only to enlarge it.</summary>
    /// <remarks>
    /// A garbage collection on a headset stops all threads, including the frame loop's thread, so the writing thread must not allocate.
    /// Numbers are written so that they are read back exactly; a number that is not finite is written as null.
    /// </remarks>
    sealed class JsonLine
    {
        const int MaxNumberLength = 32;

        char[] _text = new char[4096];
        int _length;
        bool _isFirst;

        public ReadOnlySpan<char> Text => _text.AsSpan(0, _length);

        public JsonLine Begin(string kind)
        {
            _length = 0;
            Put('{');
            _isFirst = true;
            return Add("kind", kind);
        }

        /// <summary>Ends the outermost object and the line.</summary>
        public void End()
        {
            Put('}');
            Put('\n');
        }

        public JsonLine Add(string name, long value)
        {
            Name(name);
            Put(value);
            return this;
        }

        public JsonLine Add(string name, double value)
        {
            Name(name);
            Put(value);
            return this;
        }

        /// <summary>Adds a number unless it is NaN (unknown).</summary>
        public JsonLine AddKnown(string name, double value) => double.IsNaN(value) ? this : Add(name, value);

        public JsonLine Add(string name, bool value)
        {
            Name(name);
            Put(value ? "true" : "false");
            return this;
        }

        /// <param name="value">Null is written as null.</param>
        public JsonLine Add(string name, string value)
        {
            Name(name);
            if (value == null) Put("null");
            else Quote(value);
            return this;
        }

        public JsonLine Add(string name, ReadOnlySpan<double> values)
        {
            Open(name, '[');
            foreach (var value in values)
            {
                Separate();
                Put(value);
            }
            return Close(']');
        }

        /// <param name="prefix">Prefix of each value; null if there is none.</param>
        public JsonLine Add(string name, string prefix, string[] values)
        {
            Open(name, '[');
            foreach (var value in values)
            {
                Separate();
                Quote(prefix, value);
            }
            return Close(']');
        }

        /// <param name="bracket">{ or [</param>
        public JsonLine Open(string name, char bracket)
        {
            Name(name);
            return Open(bracket);
        }

        /// <summary>Opens an object as an element of an array.</summary>
        public JsonLine OpenElement()
        {
            Separate();
            return Open('{');
        }

        public JsonLine Close(char bracket)
        {
            Put(bracket);
            _isFirst = false;
            return this;
        }

        JsonLine Open(char bracket)
        {
            Put(bracket);
            _isFirst = true;
            return this;
        }

        void Name(string name)
        {
            Separate();
            Quote(name);
            Put(':');
        }

        void Separate()
        {
            if (!_isFirst) Put(',');
            _isFirst = false;
        }

        void Put(long value)
        {
            Reserve(MaxNumberLength);
            value.TryFormat(_text.AsSpan(_length), out var written, default, CultureInfo.InvariantCulture);
            _length += written;
        }

        void Put(double value)
        {
            if (double.IsNaN(value) || double.IsInfinity(value))
            {
                Put("null");
                return;
            }
            Reserve(MaxNumberLength);
            var room = _text.AsSpan(_length);
            value.TryFormat(room, out var written, "R", CultureInfo.InvariantCulture);
            // The format R loses the last digit of some numbers on some runtimes.
            if (!double.TryParse(room.Slice(0, written), NumberStyles.Float, CultureInfo.InvariantCulture, out var back) || back != value)
                value.TryFormat(room, out written, "G17", CultureInfo.InvariantCulture);
            _length += written;
        }

        void Quote(string value) => Quote(null, value);

        void Quote(string prefix, string value)
        {
            Put('"');
            foreach (var c in prefix ?? "") PutQuoted(c);
            foreach (var c in value) PutQuoted(c);
            Put('"');
        }

        void PutQuoted(char c)
        {
            if (c == '"' || c == '\\') Put('\\');
            if (c >= ' ') Put(c);
            else PutEscaped(c);
        }

        void PutEscaped(char control)
        {
            Put("\\u00");
            Put((char)('0' + control / 16));
            Put("0123456789abcdef"[control % 16]);
        }

        void Put(string text)
        {
            foreach (var c in text) Put(c);
        }

        void Put(char c)
        {
            Reserve(1);
            _text[_length++] = c;
        }

        void Reserve(int count)
        {
            if (_length + count > _text.Length) Array.Resize(ref _text, Math.Max(2 * _text.Length, _length + count));
        }
    }
}
