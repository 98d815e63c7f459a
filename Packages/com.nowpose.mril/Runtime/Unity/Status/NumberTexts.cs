using System;
using System.Globalization;

namespace Nowpose.Unity.Status
{
    /// <summary>Converts numbers to preallocated strings, so a conversion does not allocate.</summary>
    sealed class NumberTexts
    {
        /// <summary>String for an unknown number.</summary>
        public const string Unknown = "–";

        readonly Band[] _bands;
        readonly string[] _negative;
        readonly string _beyond, _below;

        /// <param name="before">Text before each number.</param>
        /// <param name="after">Text after each number, for example the unit.</param>
        /// <param name="decimals">Number of decimals for numbers below 1, below 100 and below 1000.</param>
        public NumberTexts(string before, string after, (int Below1, int Below100, int Below1000) decimals)
        {
            _bands = new[]
            {
                new Band(1, decimals.Below1, before, after),
                new Band(100, decimals.Below100, before, after),
                new Band(1000, decimals.Below1000, before, after),
            };
            _beyond = before + "> 999" + after;
            _below = before + "< −999" + after;
            _negative = new string[1000];
            for (var i = 0; i < _negative.Length; i++) _negative[i] = before + "−" + i.ToString(CultureInfo.InvariantCulture) + after;
        }

        /// <summary>Returns the string for a number. Negative numbers are rounded to integers.</summary>
        public string Of(double? number)
        {
            if (!number.HasValue || double.IsNaN(number.Value)) return Unknown;
            if (number.Value < 0) return OfNegative(Math.Round(-number.Value));
            foreach (var band in _bands)
                if (band.TryFind(number.Value, out var text)) return text;
            return _beyond;
        }

        public string Of(TimeSpan? length) => Of(length?.TotalMilliseconds);

        string OfNegative(double size)
        {
            if (size == 0) return Of(0);
            return size < _negative.Length ? _negative[(int)size] : _below;
        }

        readonly struct Band
        {
            readonly double _perStep;
            readonly string[] _texts;

            public Band(int end, int decimals, string before, string after)
            {
                _perStep = Math.Pow(10, decimals);
                _texts = new string[(int)(end * _perStep)];
                var format = "F" + decimals.ToString(CultureInfo.InvariantCulture);
                for (var i = 0; i < _texts.Length; i++)
                    _texts[i] = before + (i / _perStep).ToString(format, CultureInfo.InvariantCulture) + after;
            }

            /// <summary>Finds the string for a number. Returns false if the rounded number is above the range of this band.</summary>
            public bool TryFind(double number, out string text)
            {
                var index = Math.Round(number * _perStep);
                text = index < _texts.Length ? _texts[(int)index] : null;
                return text != null;
            }
        }
    }
}
