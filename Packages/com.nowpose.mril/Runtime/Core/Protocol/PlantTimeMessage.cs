using System;

namespace Nowpose.Protocol
{
    /// <summary>The answer of a plant's adapter to a request for the time of its control system.</summary>
    sealed class PlantTimeMessage
    {
        /// <param name="received">t2: the clock's reading when the request arrived.</param>
        /// <param name="sent">t3: its reading when the answer was sent; equal to t2 if the clock is read only once.</param>
        /// <param name="resolution">The step in which the clock advances; zero if unknown.</param>
        /// <param name="errorBound">Error bound of the clock relative to its own reference.</param>
        /// <param name="isSynchronised">Whether the clock follows its own reference.</param>
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
