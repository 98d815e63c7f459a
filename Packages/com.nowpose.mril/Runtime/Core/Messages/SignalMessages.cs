using System;

namespace Nowpose.Messages
{
    /// <summary>Reasons why the value of a signal is not current.</summary>
    static class SignalMessages
    {
        public const string NoConnection = "no connection";

        public const string NoValue = "no value received";

        /// <summary>The display time is not known well enough. This affects all signals alike.</summary>
        public const string ClockUnsynchronised = "clock unsynchronised";

        /// <summary>The control clock has stepped, which the headset does not know yet, or the clock of the source is wrong.</summary>
        public const string StampMismatch = "the time stamp of its newest value does not match the control clock";

        /// <param name="first">One of the signals.</param>
        public static string NotCurrent(string first, int count) =>
            count == 1 ? $"signal {first} is not current" : FormattableString.Invariant($"{count} signals are not current, for example {first}");

        public const string OlderThanConnection = "no value since the connection was restored";
    }
}
