using System;

namespace Nowpose.Pairing
{
    /// <summary>Limits of the pairing, shared by headset and gateway.</summary>
    static class PairingLimits
    {
        /// <summary>Path of the request, on the WebSocket's port.</summary>
        public const string Path = "/pair";

        /// <summary>Validity of a code from its first display on the gateway's page.</summary>
        public static readonly TimeSpan CodeValidity = TimeSpan.FromMinutes(5);

        /// <summary>Maximum length of a request or a response, in bytes of JSON.</summary>
        public const int BodyBytes = 1024;

        /// <summary>Timeout of one exchange.</summary>
        public static readonly TimeSpan ExchangeTimeout = TimeSpan.FromSeconds(10);

        /// <summary>Interval from a failed exchange to the next attempt with the same code.</summary>
        public static readonly TimeSpan RetryInterval = TimeSpan.FromSeconds(3);

        /// <summary>
        /// Minimum interval from an answer to the next question, because the buttons of both questions appear in the same place, under the wearer's
        /// finger.
        /// </summary>
        public static readonly TimeSpan QuestionPause = TimeSpan.FromSeconds(1);

        /// <summary>Maximum time between two readings of a text that count as one, because a reader of codes repeats the text of a code in view.</summary>
        public static readonly TimeSpan SameReading = TimeSpan.FromSeconds(3);

        /// <summary>Minimum time for which another known cell alone is in view before the wearer is asked; longer than a glance.</summary>
        public static readonly TimeSpan LookAtOther = TimeSpan.FromSeconds(1);

        /// <summary>Minimum time out of view before a declined cell is offered again.</summary>
        public static readonly TimeSpan OtherDeclined = TimeSpan.FromMinutes(1);

        /// <summary>Time for which the problem of an unreadable code is shown.</summary>
        public static readonly TimeSpan FaultShown = TimeSpan.FromSeconds(10);

        /// <summary>Rate limit of wrong codes from one address, per minute.</summary>
        public const int WrongCodesPerMinute = 10;
    }
}
