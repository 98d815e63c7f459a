using System;
using System.Globalization;

namespace Nowpose
{
    /// <summary>
    /// Thrown when user input in a file or a setting is unusable. The message is one line. It names the file, line and field, or the setting, with
    /// the value, its unit and what is allowed. It can be shown to the user unchanged.
    /// </summary>
    public class InputException : FormatException
    {
        /// <summary>Maximum length in characters. The middle of a longer message is cut out, because the end states what is allowed.</summary>
        const int MaxMessageLength = 1000;

        public InputException(string message) : base(OneLine(message, MaxMessageLength)) { }
        public InputException(string message, Exception innerException) : base(OneLine(message, MaxMessageLength), innerException) { }

        /// <summary>Returns a message from another source as one line of limited length. Line endings and invisible characters become spaces.</summary>
        internal static string OneLine(string message, int longest)
        {
            if (message == null) return null;
            if (message.Length > longest)
                message = message.Substring(0, Boundary(message, longest * 6 / 10)) + " … " + message.Substring(Boundary(message, message.Length - longest * 3 / 10));
            var letters = message.ToCharArray();
            for (var i = 0; i < letters.Length; i++)
                if (IsInvisible(letters[i])) letters[i] = ' ';
            return new string(letters);
        }

        // Also line and paragraph separators, and characters that change the direction of the text after them.
        static bool IsInvisible(char letter) => char.GetUnicodeCategory(letter) is UnicodeCategory.Control or UnicodeCategory.Format
            or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator;

        // A cut between the two halves of a surrogate pair would leave characters that no UTF-8 text can contain.
        static int Boundary(string text, int index) =>
            index > 0 && index < text.Length && char.IsHighSurrogate(text[index - 1]) ? index - 1 : index;
    }
}
