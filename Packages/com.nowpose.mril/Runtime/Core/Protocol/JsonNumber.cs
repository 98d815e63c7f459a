using System;
using System.Buffers.Text;

namespace Nowpose.Protocol
{
    /// <summary>A number in a JSON text: its digits and its length.</summary>
    readonly ref struct JsonNumber
    {
        /// <summary>Maximum number of digits that always fit into 64 bits.</summary>
        const int MaxDigits = 19;

        /// <summary>Limit of the exponent above which further digits are ignored. It is larger than the number of digits in any message.</summary>
        const int MaxExponent = 10_000_000;

        /// <summary>Values of 10^309 and more exceed the range of a double; values below 10^-324 round to zero.</summary>
        const int MaxMagnitude = 309, MinMagnitude = -324;

        readonly ReadOnlySpan<byte> _text;
        readonly bool _isNegative;
        readonly ulong _digits;
        readonly int _count;
        readonly int _exponent;

        JsonNumber(ReadOnlySpan<byte> text, bool isNegative, bool isInteger, ulong digits, int count, int exponent)
        {
            _text = text;
            _isNegative = isNegative;
            IsInteger = isInteger;
            _digits = digits;
            _count = count;
            _exponent = exponent;
        }

        /// <summary>Whether the number has neither a fraction nor an exponent.</summary>
        public bool IsInteger { get; }

        /// <summary>Length in bytes.</summary>
        public int Length => _text.Length;

        /// <summary>Scans the number at the beginning of a string.</summary>
        public static bool TryScan(ReadOnlySpan<byte> text, out JsonNumber number)
        {
            number = default;
            var at = 0;
            ulong digits = 0;
            int count = 0, exponent = 0;
            var isNegative = Take(text, ref at, '-');
            if (!Take(text, ref at, '0') && Digits(text, ref at, ref digits, ref count) == 0) return false;
            var isFraction = Take(text, ref at, '.');
            var decimals = isFraction ? Digits(text, ref at, ref digits, ref count) : 0;
            if (isFraction && decimals == 0) return false;
            var hasExponent = Take(text, ref at, 'e') || Take(text, ref at, 'E');
            if (hasExponent && !Exponent(text, ref at, out exponent)) return false;
            number = new JsonNumber(text.Slice(0, at), isNegative, !isFraction && !hasExponent, digits, count, exponent - decimals);
            return true;
        }

        public bool TryGetInteger(out long value)
        {
            value = unchecked(_isNegative ? -(long)_digits : (long)_digits);
            return _count <= MaxDigits && _digits <= long.MaxValue + (_isNegative ? 1UL : 0UL);
        }

        /// <summary>Returns the nearest double; infinity if the number exceeds the range of a double.</summary>
        /// <remarks>
        /// Uses <see cref="ExactDouble"/> for up to 19 digits with a decimal exponent from -27 to 27, which is sufficient for joints. Other
        /// numbers use the platform's parser: the nearest double on .NET, sometimes wrong in the last bit on Unity's Mono and IL2CPP.
        /// </remarks>
        public double ToDouble()
        {
            var magnitude = Magnitude();
            return _isNegative ? -magnitude : magnitude;
        }

        double Magnitude()
        {
            var magnitude = _count + _exponent;
            if (_count == 0 || magnitude <= MinMagnitude) return 0;
            if (magnitude > MaxMagnitude) return double.PositiveInfinity;
            if (_count <= MaxDigits && Math.Abs(_exponent) <= ExactDouble.MaxExponent) return ExactDouble.Of(_digits, _exponent);
            return Utf8Parser.TryParse(_isNegative ? _text.Slice(1) : _text, out double value, out _) ? value : double.PositiveInfinity;
        }

        static bool Take(ReadOnlySpan<byte> text, ref int at, char c)
        {
            if (at >= text.Length || text[at] != c) return false;
            at++;
            return true;
        }

        // Reads digits; leading zeros do not increase the count. Returns the number of digits read, including leading zeros.
        static int Digits(ReadOnlySpan<byte> text, ref int at, ref ulong digits, ref int count)
        {
            var start = at;
            for (; at < text.Length; at++)
            {
                var digit = (uint)(text[at] - '0');
                if (digit > 9) break;
                if (digit == 0 && count == 0) continue;
                if (++count <= MaxDigits) digits = 10 * digits + digit;
            }

            return at - start;
        }

        static bool Exponent(ReadOnlySpan<byte> text, ref int at, out int exponent)
        {
            exponent = 0;
            var isNegative = !Take(text, ref at, '+') && Take(text, ref at, '-');
            var start = at;
            for (; at < text.Length && text[at] >= '0' && text[at] <= '9'; at++)
                if (exponent < MaxExponent) exponent = 10 * exponent + text[at] - '0';
            if (isNegative) exponent = -exponent;
            return at > start;
        }
    }
}
