using System;

namespace Nowpose.Protocol
{
    /// <summary>Response of a plant's adapter to a request for the time of its control system.</summary>
    sealed class PlantTimeMessage
    {
        /// <param name="received">t2: time of the control system's clock when the request arrived.</param>
        /// <param name="sent">t3: time of the same clock when the response was sent; equal to t2 if the clock is read only once.</param>
        /// <param name="resolution">Step by which the clock advances; zero if unknown.</param>
        /// <param name="errorBound">Error bound of the clock relative to its own reference.</param>
        /// <param name="isSynchronised">Whether the clock follows its own reference.</param>
        public PlantTimeMessage(ControlTime received, ControlTime sent, TimeSpan resolution, TimeSpan errorBound, bool isSynchronised) =>
            (Received, Sent, Resolution, ErrorBound, IsSynchronised) = (received, sent, resolution, errorBound, isSynchronised);

        public ControlTime Received { get; }
        public ControlTime Sent { get; }
        public TimeSpan Resolution { get; }
        public TimeSpan ErrorBound { get; }
        public bool IsSynchronised { get; }
    }
}
