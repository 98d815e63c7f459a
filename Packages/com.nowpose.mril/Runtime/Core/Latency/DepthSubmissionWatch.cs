using System;

namespace Nowpose.Latency
{
    /// <summary>Monitors whether depth is submitted. A change takes effect after it has lasted a second.</summary>
    /// <remarks>A brief change of the scene's camera is therefore not reported. Allocates nothing; not thread-safe.</remarks>
    sealed class DepthSubmissionWatch
    {
        static readonly TimeSpan Lasting = TimeSpan.FromSeconds(1);

        DepthSubmission _observed;
        HeadsetTime? _since;

        public DepthSubmission State { get; private set; }

        /// <param name="now">Time of the observation, not earlier than in the previous call.</param>
        /// <returns>Whether <see cref="State"/> has changed.</returns>
        public bool Follow(HeadsetTime now, DepthSubmission observed)
        {
            if (observed != _observed || _since == null) (_observed, _since) = (observed, now);
            if (observed == State || now - _since < Lasting) return false;
            State = observed;
            return true;
        }

        /// <summary>Sets the state to unknown when observation ends.</summary>
        public void Reset()
        {
            _since = null;
            State = DepthSubmission.Unknown;
        }
    }
}
