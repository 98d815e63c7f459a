namespace Nowpose.Unity.Status
{
    /// <summary>Widths of characters in Unity's built-in font, as a fraction of the font size.</summary>
    /// <remarks>
    /// The values are the advance widths of Liberation Sans, which equal those of Arial. A character that is not listed has the width of
    /// the widest character. Kerning is ignored.
    /// </remarks>
    static class LetterWidths
    {
        const float Widest = 1.02f;

        static readonly (float Width, string Letters)[] Classes =
        {
            (0.223f, "'ijl‘’"), (0.278f, " !,./:;I[\\]ft|"), (0.334f, "()-`r{}“”"), (0.4f, "\"*°"), (0.5f, "Jcksvxyz^"),
            (0.557f, "#$0123456789?L_abdeghnopqu±≤≥–äöüé"), (0.585f, "+<=>~×−µ"), (0.611f, "FTZß"), (0.668f, "&ABEKPSVXYÄ"),
            (0.723f, "CDHNRUwÜ"), (0.778f, "GOQÖ"), (0.834f, "Mm"), (0.89f, "%"), (0.944f, "W"), (1, "…—→"),
        };

        static readonly float[] Ascii = TableOf(128);

        public static float Of(char letter) => letter < Ascii.Length ? Ascii[letter] : Find(letter);

        /// <summary>Returns the width of a line as a multiple of the font size.</summary>
        public static float Of(string line)
        {
            var width = 0f;
            foreach (var letter in line) width += Of(letter);
            return width;
        }

        static float[] TableOf(int count)
        {
            var widths = new float[count];
            for (var i = 0; i < count; i++) widths[i] = Find((char)i);
            return widths;
        }

        static float Find(char letter)
        {
            foreach (var (width, letters) in Classes)
                if (letters.Contains(letter)) return width;
            return Widest;
        }
    }
}
