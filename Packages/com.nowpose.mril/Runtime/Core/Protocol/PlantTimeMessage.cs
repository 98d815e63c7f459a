using System;

namespace Nowpose.Protocol
{
    /// <summary>What a plant's adapter answers when it is asked for the time of its control system.</summary>
    sealed class PlantTimeMessage
    {
        /// <param name="received">t2: what the clock showed when the question arrived.</param>
        /// <param name="sent">t3: what it showed when the answer left; the same where one reading gives one time.</param>
        /// <param name="resolution">The step in which the clock advances; zero when unknown.</param>
        /// <param name="errorBound">How wrong the clock may be against its own reference.</param>
        /// <param name="isSynchronised">Whether it follows its own reference.</param>
        public PlantTimeMessage(ControlTime received, ControlTime sent, TimeSpan resolution, TimeSpan errorBound, bool isSynchronised)
        {
            Received = received;
            Sent = sent;
            Resolution = resolution;
            ErrorBound = errorBound;
            IsSynchronised = isSynchronised;
        }

        public ControlTime Received { get; }
        public ControlTime Sent { get; }
        public TimeSpan Resolution { get; }
        public TimeSpan ErrorBound { get; }
        public bool IsSynchronised { get; }
    }
}
