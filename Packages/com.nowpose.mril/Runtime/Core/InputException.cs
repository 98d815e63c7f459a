using System;

namespace Nowpose
{
    /// <summary>
    /// Something a user gave (a file, a setting) cannot be used. The message is one line that names the file, line and
    /// field or the setting, the value with its unit, and what is allowed; it is meant to be shown as it is.
    /// </summary>
    public sealed class InputException : FormatException
    {
        public InputException(string message) : base(message) { }
        public InputException(string message, Exception innerException) : base(message, innerException) { }
    }
}
