using System;

namespace Nowpose
{
    /// <summary>
    /// Something a user gave (a file, a setting) cannot be used. The message is one line that names the file, line and
    /// field or the setting, the value with its unit, and what is allowed; it is meant to be shown as it is.
    /// </summary>
    public class InputException : FormatException
    {
        /// <summary>What is longer quotes something that nobody would read; the middle goes, for the end says what is allowed.</summary>
        const int LongestMessage = 1000;

        public InputException(string message) : base(OneLine(message, LongestMessage)) { }
        public InputException(string message, Exception innerException) : base(OneLine(message, LongestMessage), innerException) { }

        /// <summary>What was given by somebody else, line ends and all, as one line of bounded length.</summary>
        internal static string OneLine(string message, int longest)
        {
            if (message == null) return null;
            if (message.Length > longest)
                message = message.Substring(0, longest * 6 / 10) + " … " + message.Substring(message.Length - longest * 3 / 10);
            var letters = message.ToCharArray();
            for (var i = 0; i < letters.Length; i++)
                if (char.IsControl(letters[i]) || letters[i] == '\u2028' || letters[i] == '\u2029') letters[i] = ' ';
            return new string(letters);
        }
    }
}
