namespace Nowpose.Messages
{
    /// <summary>Reasons why the value of a signal is not current.</summary>
    static class SignalMessages
    {
        public const string NoConnection = "no connection";

        public const string NoValue = "no value received";

        /// <summary>The display time is not known well enough. This affects all signals alike.</summary>
        public const string ClockUnsynchronised = "clock unsynchronised";

        public const string OlderThanConnection = "no value since the connection was restored";
    }
}
