using System.Text;

namespace Nowpose.Unity.Status
{
    /// <summary>Wraps a string into lines, because a TextMesh does not wrap its text. Splits a word only if it is wider than a line.</summary>
    static class WrappedText
    {
        const char Ellipsis = '…';

        /// <summary>Inserts line breaks into a string.</summary>
        /// <param name="width">Maximum width of a line as a multiple of the font size, at least 2.</param>
        /// <param name="lines">Maximum number of lines. A longer string is truncated and ends with "…".</param>
        public static string Of(string line, float width, int lines = int.MaxValue)
        {
            var wrapped = new StringBuilder(line.Length + 8);
            float used = 0, space = LetterWidths.Of(' ');
            foreach (var word in line.Split(' '))
            {
                if (used > 0 && used + space + LetterWidths.Of(word) <= width)
                {
                    wrapped.Append(' ');
                    used += space;
                }
                else if (used > 0)
                {
                    wrapped.Append('\n');
                    used = 0;
                }
                used = Append(word, wrapped, used, width);
            }
            Shorten(wrapped, width, lines);
            return wrapped.ToString();
        }

        static float Append(string word, StringBuilder into, float used, float width)
        {
            foreach (var letter in word)
            {
                var letterWidth = LetterWidths.Of(letter);
                if (used + letterWidth > width)
                {
                    into.Append('\n');
                    used = 0;
                }
                into.Append(letter);
                used += letterWidth;
            }
            return used;
        }

        static void Shorten(StringBuilder text, float width, int lines)
        {
            var used = 0f;
            for (var i = 0; i < text.Length; i++)
            {
                if (text[i] != '\n')
                {
                    used += LetterWidths.Of(text[i]);
                    continue;
                }
                if (--lines > 0)
                {
                    used = 0;
                    continue;
                }
                for (; used + LetterWidths.Of(Ellipsis) > width; i--) used -= LetterWidths.Of(text[i - 1]);
                text.Length = i;
                text.Append(Ellipsis);
            }
        }
    }
}
