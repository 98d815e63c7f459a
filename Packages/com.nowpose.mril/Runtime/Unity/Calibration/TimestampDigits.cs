using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity.Calibration
{
    /// <summary>Shows a control time in seconds, with three decimals, as one text object per character. A new time does not allocate.</summary>
    sealed class TimestampDigits
    {
        /// <summary>Period in ms after which the displayed time starts again at 0: a little more than a day.</summary>
        public const int PeriodMs = 100_000_000;

        /// <summary>Layout of the text. Each 0 stands for a digit.</summary>
        const string Pattern = "00 000.000 s";

        /// <summary>Distance between characters, as a multiple of the font height. It is wider than any digit.</summary>
        const float Pitch = 0.6f;

        static readonly string[] Digits = { "0", "1", "2", "3", "4", "5", "6", "7", "8", "9" };

        readonly PanelCell[] _letters = new PanelCell[Pattern.Length];

        /// <param name="place">Centre of the text.</param>
        /// <param name="height">Height of the font, in metres.</param>
        public TimestampDigits(Transform parent, TextMesh model, Vector3 place, float height)
        {
            for (var i = 0; i < _letters.Length; i++)
                _letters[i] = Copy(
                    "Letter " + i, parent, model, place + (i - (Pattern.Length - 1) / 2f) * Pitch * height * Vector3.right, height);
        }

        /// <summary>Copies a text object and gives the copy another position and size.</summary>
        public static PanelCell Copy(string name, Transform parent, TextMesh model, Vector3 place, float height)
        {
            var copy = Object.Instantiate(model, parent);
            copy.name = name;
            copy.anchor = TextAnchor.MiddleCenter;
            copy.alignment = TextAlignment.Center;
            copy.richText = false;
            copy.text = "";
            copy.transform.PlaceLocally(place, Quaternion.identity);
            copy.transform.localScale = Vector3.one * (height / LetterSize.Of(model));
            copy.gameObject.SetActive(true);
            return new PanelCell(copy);
        }

        /// <summary>Shows a time without leading zeros.</summary>
        /// <param name="ms">Time in ms, 0 to <see cref="PeriodMs"/> − 1.</param>
        public void Show(int ms)
        {
            // Fills the digits from the right. Always shows the digit before the decimal point.
            for (var i = Pattern.Length - 1; i >= 0; i--)
            {
                if (Pattern[i] != '0')
                {
                    _letters[i].Show(Pattern[i] == '.' ? "." : Pattern[i] == 's' ? "s" : "");
                    continue;
                }
                _letters[i].Show(ms > 0 || i >= Pattern.IndexOf('.') - 1 ? Digits[ms % 10] : "");
                ms /= 10;
            }
        }

        public void Clear()
        {
            for (var i = 0; i < _letters.Length; i++) _letters[i].Show("");
        }
    }
}
