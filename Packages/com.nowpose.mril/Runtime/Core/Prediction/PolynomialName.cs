using System;
using System.Globalization;

namespace Nowpose.Prediction
{
    /// <summary>Polynomials by name beyond those that are offered: degree and history, as linear-h3 or cubic-h6.</summary>
    static class PolynomialName
    {
        const string HistoryMark = "-h";

        static readonly string[] Degrees = { "linear", "quadratic", "cubic" };

        /// <summary>Whether a name is a degree and a history that go together; histories go up to what a predictor takes.</summary>
        public static bool TryRead(string name, out int degree, out int history)
        {
            degree = history = 0;
            var mark = name?.IndexOf(HistoryMark, StringComparison.Ordinal) ?? -1;
            if (mark < 0) return false;
            degree = Array.IndexOf(Degrees, name.Substring(0, mark)) + 1;
            return degree > 0
                && int.TryParse(name.AsSpan(mark + HistoryMark.Length), NumberStyles.None, CultureInfo.InvariantCulture, out history)
                && history >= degree && history <= PolynomialPredictor.LongestHistory;
        }
    }
}
