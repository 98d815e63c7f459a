using System;

namespace Nowpose.Pairing
{
    /// <summary>Every number of the exchange, in one place for the headset and the gateway.</summary>
    static class PairingLimits
    {
        /// <summary>On the WebSocket's port.</summary>
        public const string Path = "/pair";

        /// <summary>From a code's first sight on the gateway's page until it is worth nothing.</summary>
        public static readonly TimeSpan CodeValidity = TimeSpan.FromMinutes(5);

        /// <summary>Longest request and longest answer, bytes of JSON.</summary>
        public const int BodyBytes = 1024;

        /// <summary>How long one exchange may take.</summary>
        public static readonly TimeSpan ExchangeTimeout = TimeSpan.FromSeconds(10);

        /// <summary>From an exchange that failed on the way to the next with the same code.</summary>
        public static readonly TimeSpan RetryInterval = TimeSpan.FromSeconds(3);

        /// <summary>After an answer nothing is asked for so long: the next question would stand under the same finger.</summary>
        public static readonly TimeSpan QuestionPause = TimeSpan.FromSeconds(1);

        /// <summary>How long another known cell is in view alone before it is asked about: more than a glimpse in passing.</summary>
        public static readonly TimeSpan LookAtOther = TimeSpan.FromSeconds(1);

        /// <summary>Another known cell that was declined is asked about again once it was out of view for so long.</summary>
        public static readonly TimeSpan OtherDeclined = TimeSpan.FromMinutes(1);

        /// <summary>How long a code that cannot be read is told of.</summary>
        public static readonly TimeSpan FaultShown = TimeSpan.FromSeconds(10);

        /// <summary>So many wrong codes a minute are answered to one address.</summary>
        public const int WrongCodesPerMinute = 10;
    }
}
