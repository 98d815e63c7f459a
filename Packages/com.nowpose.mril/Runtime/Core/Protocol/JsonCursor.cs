using System;
using System.Collections.Generic;
using System.IO;
using System.Numerics;
using Newtonsoft.Json;

namespace Nowpose.Protocol
{
    /// <summary>Walks over a text that <see cref="JsonSyntax"/> let pass; the first thing that does not fit is its fault.</summary>
    /// <remarks>Methods return false once there is a fault, so that a caller only hands the false on.</remarks>
    sealed class JsonCursor : IDisposable
    {
        readonly JsonTextReader _reader;

        public JsonCursor(string text)
        {
            _reader = new JsonTextReader(new StringReader(text))
            {
                // A string that looks like a date stays the string that was sent.
                DateParseHandling = DateParseHandling.None,
                FloatParseHandling = FloatParseHandling.Double,
                MaxDepth = ProtocolLimits.Nesting,
            };
            _reader.Read();
        }

        public DropReason Fault { get; private set; }

        public bool IsText => _reader.TokenType == JsonToken.String;
        public bool IsInteger => _reader.TokenType == JsonToken.Integer;
        public bool IsNull => _reader.TokenType == JsonToken.Null;

        public void Dispose() => ((IDisposable)_reader).Dispose();

        public bool Fail(DropReason reason)
        {
            if (Fault == DropReason.None)
                Fault = reason;
            return false;
        }

        public bool Skip()
        {
            _reader.Skip();
            return true;
        }

        /// <summary>Reads the object here: known[i] goes to read(i), anything else is skipped.</summary>
        /// <param name="required">Bit i: known[i] must be there.</param>
        public bool Object(string[] known, int required, Func<int, bool> read)
        {
            if (_reader.TokenType != JsonToken.StartObject)
                return Fail(DropReason.WrongType);
            var seen = 0;
            while (_reader.Read() && _reader.TokenType != JsonToken.EndObject)
            {
                if (!Field(Array.IndexOf(known, (string)_reader.Value), ref seen, read))
                    return false;
            }

            return (seen & required) == required || Fail(DropReason.MissingField);
        }

        bool Field(int index, ref int seen, Func<int, bool> read)
        {
            _reader.Read();
            if (index < 0)
                return Skip();
            var bit = 1 << index;
            if ((seen & bit) != 0)
                return Fail(DropReason.DuplicateField);
            seen |= bit;
            return read(index);
        }

        public bool Elements(Func<bool> read)
        {
            if (_reader.TokenType != JsonToken.StartArray)
                return Fail(DropReason.WrongType);
            while (_reader.Read() && _reader.TokenType != JsonToken.EndArray)
            {
                if (!read())
                    return false;
            }

            return true;
        }

        public bool Text(out string text)
        {
            text = _reader.Value as string;
            return IsText || Fail(DropReason.WrongType);
        }

        /// <summary>A text that names something: not empty, no longer than the protocol allows.</summary>
        public bool Name(out string name)
        {
            if (!Text(out name))
                return false;
            if (name.Length == 0)
                return Fail(DropReason.MissingField);
            return name.Length <= ProtocolLimits.NameLength || Fail(DropReason.NameTooLong);
        }

        /// <summary>A text, or null for null: what other languages write for a field they leave out.</summary>
        public bool OptionalText(out string text)
        {
            text = null;
            return IsNull || Text(out text);
        }

        public bool OptionalCount(out int count)
        {
            count = 0;
            if (IsNull || !Integer(out var value))
                return IsNull;
            count = (int)Math.Min(Math.Max(value, 0), int.MaxValue);
            return value == count || Fail(DropReason.OutOfRange);
        }

        public bool Flag(out bool value)
        {
            value = _reader.Value is bool read && read;
            return _reader.TokenType == JsonToken.Boolean || Fail(DropReason.WrongType);
        }

        public bool Integer(out long value)
        {
            value = _reader.Value is long read ? read : 0;
            if (_reader.TokenType != JsonToken.Integer)
                return Fail(DropReason.WrongType);
            return _reader.Value is long || Fail(DropReason.OutOfRange);
        }

        /// <summary>Numbers that must all be finite. rosbridge writes null for a number that is none.</summary>
        public bool FiniteNumbers(List<double> into) => Elements(() => Number(out var value)
            && (IsFinite(value) || Fail(DropReason.NotFinite))
            && Add(into, value));

        /// <summary>Numbers of which some may be absent, null or NaN, and become NaN.</summary>
        public bool OptionalNumbers(List<double> into) => Elements(() => Number(out var value)
            && (!double.IsInfinity(value) || Fail(DropReason.NotFinite))
            && Add(into, value));

        bool Number(out double value)
        {
            switch (_reader.Value)
            {
                case double read: value = read; return true;
                case long read: value = read; return true;
                case BigInteger read: value = (double)read; return true;
                default: value = double.NaN; return IsNull || Fail(DropReason.WrongType);
            }
        }

        bool Add(List<double> into, double value)
        {
            into.Add(value);
            return into.Count <= ProtocolLimits.Joints || Fail(DropReason.TooManyJoints);
        }

        static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);
    }
}
