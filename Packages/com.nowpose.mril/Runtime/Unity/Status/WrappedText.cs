using System.Text;

namespace Nowpose.Unity
{
    /// <summary>Breaks a line between words, for the engine's texts do not; a word that is longer than a line goes on in the next.</summary>
    static class WrappedText
    {
        /// <param name="width">Letters in a line, 1 or more.</param>
        public static string Of(string line, int width)
        {
            var wrapped = new StringBuilder(line.Length + 8);
            var used = 0;
            foreach (var word in line.Split(' '))
            {
                if (used > 0 && used + 1 + word.Length <= width)
                {
                    wrapped.Append(' ');
                    used++;
                }
                else if (used > 0)
                {
                    wrapped.Append('\n');
                    used = 0;
                }
                used = Append(word, wrapped, used, width);
            }
            return wrapped.ToString();
        }

        static int Append(string word, StringBuilder into, int used, int width)
        {
            foreach (var letter in word)
            {
                if (used == width)
                {
                    into.Append('\n');
                    used = 0;
                }
                into.Append(letter);
                used++;
            }
            return used;
        }
    }
}
