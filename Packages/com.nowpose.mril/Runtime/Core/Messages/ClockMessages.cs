namespace Nowpose.Messages
{
    /// <summary>Error messages about clocks and times.</summary>
    static class ClockMessages
    {
        public const string NotSynchronised = "the headset clock is not synchronised: no control time is known yet; check State first";
        public const string SecondsOutOfRange = "seconds must be finite and within ±9.2e11 s";

        public static string UnknownEstimator(string name, string allowed) => $"clock estimator '{name}' is unknown; allowed: {allowed}";
    }
}
